//! Pressure of enclosed gas: the two-layer paper's, with the signed volume in place of a bounding box.

use super::force::Force;
use crate::solver::drive::Drive;
use crate::solver::driven::Driven;
use crate::solver::energy::Energies;
use crate::solver::hand::Hand;
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
    /// A pressure [Pa] that stays whatever the volume.
    frozen: Option<f64>,
    /// What nRT is multiplied by.
    driven: Driven,
}

impl Pressure {
    /// Gas of `energy_scale` nRT [J] between these surfaces.
    pub(crate) fn new(energy_scale: f64, surfaces: Vec<(Surface, f64)>) -> Self {
        Self { energy_scale, surfaces, frozen: None, driven: Driven::default() }
    }

    /// The same gas, nRT times a drive.
    pub(crate) fn driven(self, drive: Option<Drive>) -> Self {
        Self { driven: Driven::by(drive), ..self }
    }

    /// Keeps the pressure from here on as it is at a time [s] at `positions` [m]: particles feel only those beside them
    /// then.
    pub(crate) fn freeze(&mut self, time: f64, positions: &[DVec3]) {
        self.frozen = Some(self.pressure(time, positions));
    }

    /// The pressure [Pa] at a time [s]. Inside out there is none that means anything, and a body that ends a step so is
    /// stopped.
    fn pressure(&self, time: f64, positions: &[DVec3]) -> f64 {
        let volume = self.volume(positions);
        let scale = self.driven.at(time) * self.energy_scale;
        self.frozen.unwrap_or(if volume > 0.0 { scale / volume } else { 0.0 })
    }

    /// Energy [J] of the gas that is not driven.
    fn energy(&self, state: &ParticleState) -> f64 {
        -(self.energy_scale * self.volume(&state.positions).ln())
    }

    /// Volume of the gas [m³], or area [m²].
    pub(crate) fn volume(&self, positions: &[DVec3]) -> f64 {
        self.surfaces.iter().map(|(surface, sign)| sign * surface.volume(positions)).sum()
    }
}

impl Force for Pressure {
    fn add_forces(&mut self, time: f64, state: &ParticleState, forces: &mut [DVec3]) {
        let mut driven = std::mem::take(&mut self.driven);
        driven.begin(time, || self.energy(state));
        self.driven = driven;
        let pressure = self.pressure(time, &state.positions);
        for (surface, sign) in &self.surfaces {
            surface.add_gradient(&state.positions, sign * pressure, forces);
        }
    }

    fn add_energy(&self, time: f64, state: &ParticleState, energies: &mut Energies) {
        energies.pressure += self.driven.at(time) * self.energy(state);
        energies.activation -= self.drive_work();
    }

    fn is_internal(&self) -> bool {
        true
    }

    fn couplings(&self) -> Vec<Vec<u32>> {
        let of = |(surface, _): &(Surface, f64)| -> Vec<Vec<u32>> {
            match surface {
                Surface::Polygon { edges, .. } => edges.iter().map(|edge| edge.to_vec()).collect(),
                Surface::Faces(faces) => faces.iter().map(|face| face.to_vec()).collect(),
            }
        };
        self.surfaces.iter().flat_map(of).collect()
    }

    fn fault(&self, state: &ParticleState) -> Option<&'static str> {
        let inside_out = self.volume(&state.positions) <= 0.0;
        inside_out.then_some("its volume fell to zero: it is turned inside out")
    }

    fn end_step(&mut self, time: f64, state: &ParticleState) -> bool {
        let mut driven = std::mem::take(&mut self.driven);
        driven.book(time, || self.energy(state));
        self.driven = driven;
        false
    }

    fn adopt(&mut self, before: &[Box<dyn Force>]) {
        let mut gases = before.iter().filter_map(|force| force.downcast_ref::<Self>());
        // Gas in both layers counts as two.
        let before = gases.find(|gas| gas.surfaces == self.surfaces);
        self.driven.adopt(before.map(|gas| &gas.driven));
    }

    fn give(&mut self, to: &str, led: Option<Hand>) {
        self.driven.give(to, led);
    }

    fn drive_work(&self) -> f64 {
        self.driven.work()
    }

    fn changes_until(&self) -> f64 {
        self.driven.until()
    }

    fn driven_until(&self) -> f64 {
        self.changes_until()
    }

    fn clone_at_extreme(&self, greatest: bool) -> Box<dyn Force> {
        Box::new(Self { driven: self.driven.at_extreme(greatest), ..self.clone() })
    }

    fn name(&self) -> &'static str {
        "pressure"
    }

    fn clone_box(&self) -> Box<dyn Force> {
        Box::new(self.clone())
    }
}
