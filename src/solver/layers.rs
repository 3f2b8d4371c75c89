//! What is special about a two-layer body: which particles make a layer, what joins and what encloses them.

use super::forces::pressure::Surface;
use super::forces::{Plane, Springs};
use super::state::ParticleState;
use glam::DVec3;

/// Build of a two-layer body. The outer layer's particles come first, then the inner layer's.
#[derive(Clone, Debug)]
pub struct Layers {
    /// 1, 2 or 3.
    pub dimension: u32,
    /// Number of particles in the outer layer.
    pub outer: usize,
    /// Springs, by kind, for drawing and counting.
    pub springs: Springs,
    /// Surface of the outer layer, where it encloses anything.
    pub outer_surface: Option<Surface>,
    /// Surface of the inner layer, where there is one.
    pub inner_surface: Option<Surface>,
    /// MKS [N/m] and MKD [N s/m] of the spring by which the body is grabbed.
    pub grab: [f64; 2],
    /// Planes onto which particles are put back after each step (the paper's contact, for comparison only).
    pub reset: Vec<Plane>,
}

impl Layers {
    /// Memory of the springs and surfaces [bytes].
    pub(super) fn bytes(&self) -> usize {
        let surfaces = [&self.outer_surface, &self.inner_surface].into_iter().flatten();
        let surfaces = surfaces.map(|surface| match surface {
            Surface::Polygon { edges, .. } => size_of_val(&**edges),
            Surface::Faces(faces) => size_of_val(&**faces),
        });
        // Ends and rest length of every spring.
        self.springs.ends().len() * size_of::<([u32; 2], f64)>() + surfaces.sum::<usize>()
    }

    /// Puts particles that are behind a plane of [`Layers::reset`] on it, velocities untouched; whether there were any.
    /// `allowance` is the depth [m] that is granted behind a plane, by its index.
    pub(super) fn put_back(&self, state: &mut ParticleState, allowance: impl Fn(usize) -> f64) -> bool {
        let mut moved = false;
        for (index, plane) in self.reset.iter().enumerate() {
            let granted = allowance(index);
            for x in &mut state.positions {
                let gap = (*x - plane.point).dot(plane.normal) + granted;
                if gap < 0.0 {
                    *x -= gap * plane.normal;
                    moved = true;
                }
            }
        }
        moved
    }

    /// Distance between the layers' centres of mass [m].
    pub fn offset(&self, state: &ParticleState) -> f64 {
        let center = |range: std::ops::Range<usize>| {
            let mass: f64 = state.masses[range.clone()].iter().sum();
            range.map(|i| state.masses[i] * state.positions[i]).sum::<DVec3>() / mass
        };
        if self.outer == state.len() {
            return 0.0;
        }
        center(0..self.outer).distance(center(self.outer..state.len()))
    }

    /// Moment of inertia about the centre of mass over `M Ro²`, Ro the mean distance of the outer particles: about the
    /// plane's normal in 2D, the mean over all axes (2/3 of the polar moment) in 3D.
    pub fn inertia_ratio(&self, state: &ParticleState) -> f64 {
        let center = state.center();
        let radius = state.positions[..self.outer].iter().map(|x| x.distance(center)).sum::<f64>() / self.outer as f64;
        let polar: f64 = state.positions.iter().zip(&state.masses).map(|(x, m)| m * x.distance_squared(center)).sum();
        let share = if self.dimension == 3 { 2.0 / 3.0 } else { 1.0 };
        share * polar / (state.mass() * radius * radius)
    }
}
