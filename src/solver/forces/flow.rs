//! Drag of air or water that moves as one, by the surface's normal.

use super::force::{Force, StepLimit};
use crate::solver::drive::Drive;
use crate::solver::embedding::EmbeddingWeights;
use crate::solver::energy::Energies;
use crate::solver::state::ParticleState;
use glam::DVec3;
use std::sync::Arc;

/// Speed [m/s] against the flow that the time step is chosen for, beside those at the start.
const USUAL_SPEED: f64 = 1.0;

/// On every face `(1/4) rho C A |u . n| (u . n) n`, u the flow's velocity against the face's: a plate across the flow,
/// which has two such sides, is pushed by `(1/2) rho C A u²`. What flows along a face does not touch it.
#[derive(Clone, Debug)]
pub(crate) struct Flow {
    /// Velocity [m/s].
    velocity: DVec3,
    /// What it is multiplied by, if anything.
    drive: Option<Drive>,
    /// `rho C` [kg/m³].
    density: f64,
    surface: Arc<FlowSurface>,
    /// The last evaluation of the step that goes on.
    last: Option<Pushed>,
    /// Work done so far [J], and up to where; that is not known before the first evaluation.
    work: f64,
    booked: Option<Pushed>,
}

/// What is pushed at a time, vertex by vertex.
#[derive(Clone, Debug)]
struct Pushed {
    /// [s]
    time: f64,
    places: Vec<DVec3>,
    /// [N]
    pushes: Vec<DVec3>,
}

impl Pushed {
    /// The work done from then until `now` [J], by the mean of the pushes at both ends: as a step of leap-frog takes
    /// them, so that energy less work is kept to second order in the step.
    fn work_until(&self, now: &Self) -> f64 {
        let moved = self.places.iter().zip(&now.places).map(|(before, now)| *now - *before);
        let pushes = self.pushes.iter().zip(&now.pushes).map(|(before, now)| 0.5 * (*before + *now));
        moved.zip(pushes).map(|(way, push)| way.dot(push)).sum()
    }

    fn bytes(&self) -> usize {
        size_of_val(&*self.places) + size_of_val(&*self.pushes)
    }
}

/// The surface that a flow pushes on.
#[derive(Debug)]
pub(crate) struct FlowSurface {
    /// How its vertices ride on the particles.
    pub(crate) vertices: Vec<EmbeddingWeights>,
    /// Vertices of its faces.
    pub(crate) triangles: Arc<[[u32; 3]]>,
}

impl Flow {
    /// A flow of this velocity [m/s], times a drive if there is one, of density times drag coefficient `density`
    /// [kg/m³].
    pub(crate) fn new(velocity: DVec3, drive: Option<Drive>, density: f64, surface: FlowSurface) -> Self {
        Self { velocity, drive, density, surface: Arc::new(surface), last: None, work: 0.0, booked: None }
    }

    fn at(&self, time: f64) -> DVec3 {
        self.drive.as_ref().map_or(self.velocity, |drive| drive.at(time).0 * self.velocity)
    }

    /// Positions and velocities of the vertices.
    fn vertices(&self, state: &ParticleState) -> Vec<[DVec3; 2]> {
        let of = |vertex: &EmbeddingWeights| [vertex.gather(&state.positions), vertex.gather(&state.velocities)];
        self.surface.vertices.iter().map(of).collect()
    }

    /// What it pushes at a time [s].
    fn pushed(&self, time: f64, state: &ParticleState) -> Pushed {
        let flow = self.at(time);
        let vertices = self.vertices(state);
        let mut pushes = vec![DVec3::ZERO; vertices.len()];
        for triangle in self.surface.triangles.iter() {
            let [a, b, c] = triangle.map(|vertex| vertices[vertex as usize]);
            let area = 0.5 * (b[0] - a[0]).cross(c[0] - a[0]);
            let normal = area.normalize_or_zero();
            let across = (flow - (a[1] + b[1] + c[1]) / 3.0).dot(normal);
            let push = (0.25 / 3.0 * self.density * across.abs() * across) * (area.dot(normal) * normal);
            for vertex in triangle {
                pushes[*vertex as usize] += push;
            }
        }
        Pushed { time, places: vertices.iter().map(|vertex| vertex[0]).collect(), pushes }
    }
}

impl Force for Flow {
    fn add_forces(&mut self, time: f64, state: &ParticleState, forces: &mut [DVec3]) {
        let now = self.pushed(time, state);
        for (vertex, push) in self.surface.vertices.iter().zip(&now.pushes) {
            vertex.scatter(*push, forces);
        }
        self.booked.get_or_insert_with(|| now.clone());
        self.last = Some(now);
    }

    fn add_energy(&self, _time: f64, _state: &ParticleState, _energies: &mut Energies) {}

    fn step_limit(&self, state: &ParticleState) -> StepLimit {
        // The push grows by (1/2) rho C A |u| for each metre a second.
        let greatest = self.drive.as_ref().map_or(1.0, Drive::largest);
        let fastest = state.velocities.iter().map(|v| v.length()).fold(0.0, f64::max);
        let speed = USUAL_SPEED.max(greatest * self.velocity.length() + fastest);
        let vertices = self.vertices(state);
        let mut shares = vec![0.0; vertices.len()];
        for triangle in self.surface.triangles.iter() {
            let [a, b, c] = triangle.map(|vertex| vertices[vertex as usize][0]);
            let share = 0.5 / 3.0 * self.density * speed * 0.5 * (b - a).cross(c - a).length();
            for &vertex in triangle {
                shares[vertex as usize] += share;
            }
        }
        let mut rates = vec![0.0; state.len()];
        for (vertex, share) in self.surface.vertices.iter().zip(shares) {
            for &(particle, weight) in &vertex.weights {
                rates[particle as usize] += weight.abs() * share;
            }
        }
        let rate = rates.iter().zip(&state.masses).map(|(rate, mass)| rate / mass).fold(0.0, f64::max);
        StepLimit { damping_rate: rate, ..StepLimit::default() }
    }

    fn end_step(&mut self, time: f64, state: &ParticleState) -> bool {
        // Where the integrator evaluated there it is those pushes that it steps with.
        let now = self.last.take().filter(|last| last.time == time).unwrap_or_else(|| self.pushed(time, state));
        self.work += self.booked.as_ref().map_or(0.0, |before| before.work_until(&now));
        self.booked = Some(now);
        false
    }

    fn adopt(&mut self, before: &[Box<dyn Force>]) {
        (self.booked, self.last) = (None, None);
        let before = before.iter().find_map(|force| force.downcast_ref::<Self>());
        self.work = before.map_or(0.0, |before| before.work);
    }

    fn outside_work(&self) -> Option<f64> {
        Some(self.work)
    }

    fn changes_until(&self) -> f64 {
        self.drive.as_ref().map_or(0.0, Drive::until)
    }

    fn driven_until(&self) -> f64 {
        self.changes_until()
    }

    fn does_work(&self) -> bool {
        self.velocity != DVec3::ZERO
    }

    fn name(&self) -> &'static str {
        "wind"
    }

    fn bytes(&self) -> usize {
        size_of_val(self) + self.last.iter().chain(&self.booked).map(Pushed::bytes).sum::<usize>()
    }

    fn clone_box(&self) -> Box<dyn Force> {
        Box::new(self.clone())
    }
}
