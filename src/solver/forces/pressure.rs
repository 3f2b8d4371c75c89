//! Pressure of enclosed gas: the two-layer paper's, with the signed volume in place of a bounding box.

use super::force::Force;
use crate::solver::energy::Energies;
use crate::solver::scratch::Scratch;
use crate::solver::state::ParticleState;
use glam::DVec3;
use std::sync::Arc;

/// A closed surface, whose volume is signed: positive while it is not turned inside out.
#[derive(Clone, Debug, PartialEq)]
pub enum Surface {
    /// A polygon in the plane with this unit normal; its edges run counter-clockwise seen from the normal's end.
    Polygon {
        /// Particles at both ends of every edge.
        edges: Arc<[[u32; 2]]>,
        /// Unit normal of the plane.
        normal: DVec3,
    },
    /// Faces that turn counter-clockwise seen from outside.
    Faces(Arc<[[u32; 3]]>),
}

impl Surface {
    /// Signed area [m²] of a polygon by the shoelace formula, or signed volume [m³] `sum a . (b x c) / 6` of faces.
    pub fn volume(&self, positions: &[DVec3]) -> f64 {
        // From one of its own points, so that a body far from the origin loses no digits.
        match self {
            Self::Polygon { edges, normal } => {
                let origin = edges.first().map_or(DVec3::ZERO, |edge| positions[edge[0] as usize]);
                let at = |i: u32| positions[i as usize] - origin;
                0.5 * normal.dot(edges.iter().map(|&[a, b]| at(a).cross(at(b))).sum())
            }
            Self::Faces(faces) => {
                let origin = faces.first().map_or(DVec3::ZERO, |face| positions[face[0] as usize]);
                let at = |i: u32| positions[i as usize] - origin;
                faces.iter().map(|&[a, b, c]| at(a).dot(at(b).cross(at(c)))).sum::<f64>() / 6.0
            }
        }
    }

    /// Adds `scale` times the gradient of the volume: half the outward edge vector to both ends of an edge, a third of
    /// the outward area vector to every corner of a face.
    pub fn add_gradient(&self, positions: &[DVec3], scale: f64, out: &mut [DVec3]) {
        match self {
            Self::Polygon { edges, normal } => {
                for &[a, b] in edges.iter() {
                    let (a, b) = (a as usize, b as usize);
                    let push = (0.5 * scale) * (positions[b] - positions[a]).cross(*normal);
                    out[a] += push;
                    out[b] += push;
                }
            }
            Self::Faces(faces) => {
                for &[a, b, c] in faces.iter() {
                    let (a, b, c) = (a as usize, b as usize, c as usize);
                    let area = (positions[b] - positions[a]).cross(positions[c] - positions[a]);
                    let push = (scale / 6.0) * area;
                    out[a] += push;
                    out[b] += push;
                    out[c] += push;
                }
            }
        }
    }

    /// Adds `scale` times the change of the volume's gradient under a displacement `dx`.
    fn add_gradient_change(&self, positions: &[DVec3], dx: &[DVec3], scale: f64, out: &mut [DVec3]) {
        match self {
            Self::Polygon { .. } => self.add_gradient(dx, scale, out),
            Self::Faces(faces) => {
                for &[a, b, c] in faces.iter() {
                    let (a, b, c) = (a as usize, b as usize, c as usize);
                    let (ab, ac) = (positions[b] - positions[a], positions[c] - positions[a]);
                    let area = (dx[b] - dx[a]).cross(ac) + ab.cross(dx[c] - dx[a]);
                    let push = (scale / 6.0) * area;
                    out[a] += push;
                    out[b] += push;
                    out[c] += push;
                }
            }
        }
    }
}

/// Gas at `P = nRT / V` between surfaces: `f = P grad V`, the exact negative gradient of `-nRT ln V`.
///
/// V is the sum of the surfaces' volumes by their signs, so that an inner surface with the sign -1 is left out of what
/// an outer one encloses.
#[derive(Clone, Debug)]
pub(crate) struct Pressure {
    /// `nRT` [J]; in two dimensions per metre of depth.
    pub energy_scale: f64,
    /// Surfaces with +1 or -1.
    pub surfaces: Vec<(Surface, f64)>,
    scratch: Scratch<Vec<DVec3>>,
}

impl Pressure {
    /// Gas of `energy_scale` nRT [J] between these surfaces.
    pub(crate) fn new(energy_scale: f64, surfaces: Vec<(Surface, f64)>) -> Self {
        Self { energy_scale, surfaces, scratch: Scratch::default() }
    }

    /// Volume of the gas [m³], or area [m²].
    pub(crate) fn volume(&self, positions: &[DVec3]) -> f64 {
        self.surfaces.iter().map(|(surface, sign)| sign * surface.volume(positions)).sum()
    }
}

impl Force for Pressure {
    fn add_forces(&mut self, _time: f64, state: &ParticleState, forces: &mut [DVec3]) {
        let volume = self.volume(&state.positions);
        // Inside out there is no pressure that means anything, and a body that ends a step so is stopped.
        let pressure = if volume > 0.0 { self.energy_scale / volume } else { 0.0 };
        for (surface, sign) in &self.surfaces {
            surface.add_gradient(&state.positions, sign * pressure, forces);
        }
    }

    fn add_energy(&self, _time: f64, state: &ParticleState, energies: &mut Energies) {
        energies.pressure -= self.energy_scale * self.volume(&state.positions).ln();
    }

    fn add_derivative(&mut self, _time: f64, state: &ParticleState, [dx, _]: [&[DVec3]; 2], out: &mut [DVec3]) {
        let volume = self.volume(&state.positions);
        let pressure = self.energy_scale / volume;
        self.scratch.clear();
        self.scratch.resize(state.len(), DVec3::ZERO);
        for (surface, sign) in &self.surfaces {
            surface.add_gradient(&state.positions, *sign, &mut self.scratch);
            surface.add_gradient_change(&state.positions, dx, sign * pressure, out);
        }
        let growth: f64 = self.scratch.iter().zip(dx).map(|(gradient, dx)| gradient.dot(*dx)).sum();
        let loss = -pressure / volume * growth;
        for (out, gradient) in out.iter_mut().zip(&*self.scratch) {
            *out += loss * *gradient;
        }
    }

    fn fault(&self, state: &ParticleState) -> Option<&'static str> {
        let inside_out = self.volume(&state.positions) <= 0.0;
        inside_out.then_some("its volume fell to zero: it is turned inside out")
    }

    fn changes_until(&self) -> f64 {
        0.0
    }

    fn clone_box(&self) -> Box<dyn Force> {
        Box::new(self.clone())
    }
}
