//! What the motion of one body goes on from.

use super::given::Given;
use super::{Body, Divergence};
use crate::solver::contact_surface::ContactSurface;
use crate::solver::dynamics::Fallbacks;
use crate::solver::forces::{Force, Grab, MatrixForce};
use crate::solver::hand::Hand;
use crate::solver::integrators::Integrator;
use crate::solver::layers::Layers;
use crate::solver::skin::{PartedSkin, Skin};
use crate::solver::state::ParticleState;
use glam::DVec3;
use std::sync::Arc;

/// Everything of a body that moving changes. Rest data are not among it: they stay in the body, and copies of forces
/// share theirs.
#[derive(Clone)]
pub(in crate::solver) struct BodyCheckpoint {
    positions: Vec<DVec3>,
    velocities: Vec<DVec3>,
    /// Forces of the last evaluation [N]: the next step may start from them.
    net: Vec<DVec3>,
    /// Forces from other bodies [N]; empty where there are none.
    external_forces: Vec<DVec3>,
    /// Energy of contacts with other bodies [J].
    contact_energy: f64,
    /// Force with which it pushes up each panel [N].
    panel_pushes: Vec<f64>,
    /// With their warm starts and what has broken in them.
    forces: Vec<Box<dyn Force>>,
    integrator: Box<dyn Integrator>,
    grabs: Vec<Grab>,
    /// From where its constraints move what they took hold of on the way.
    found: Vec<Option<Arc<[DVec3]>>>,
    /// What leads its shared drives.
    hands: Vec<Option<Hand>>,
    current: bool,
    steps: u64,
    evaluations: u64,
    fallbacks: Fallbacks,
    given: Given,
    divergence: Option<Divergence>,
}

impl BodyCheckpoint {
    /// Memory that it takes [bytes].
    pub(in crate::solver) fn bytes(&self) -> usize {
        let lists = size_of_val(&*self.positions)
            + size_of_val(&*self.velocities)
            + size_of_val(&*self.net)
            + size_of_val(&*self.external_forces)
            + size_of_val(&*self.panel_pushes)
            + size_of_val(&*self.found)
            + size_of_val(&*self.hands);
        let grabs: usize = self.grabs.iter().map(Force::bytes).sum();
        let forces: usize = self.forces.iter().map(|force| force.bytes() + size_of_val(force)).sum();
        size_of_val(self) + lists + grabs + forces + self.integrator.bytes()
    }
}

impl Body {
    /// What the body goes on from.
    pub(in crate::solver) fn checkpoint(&self) -> BodyCheckpoint {
        let pushed = self.external_forces.iter().any(|force| *force != DVec3::ZERO);
        BodyCheckpoint {
            positions: self.parts.state.positions.clone(),
            velocities: self.parts.state.velocities.clone(),
            net: self.net.clone(),
            external_forces: if pushed { self.external_forces.clone() } else { Vec::new() },
            contact_energy: self.contact_energy,
            panel_pushes: self.panel_pushes.clone(),
            forces: self.parts.forces.clone(),
            integrator: self.parts.integrator.clone(),
            grabs: self.grabs.clone(),
            found: self.parts.constraints.iter().map(|constraint| constraint.found.clone()).collect(),
            hands: self.hands(),
            current: self.current,
            steps: self.steps,
            evaluations: self.evaluations,
            fallbacks: self.fallbacks,
            given: self.given,
            divergence: self.divergence.clone(),
        }
    }

    /// Back to what `kept` was taken of: this body, or another of the same parts.
    pub(in crate::solver) fn go_back(&mut self, kept: &BodyCheckpoint) {
        let ParticleState { positions, velocities, .. } = &mut self.parts.state;
        positions.clone_from(&kept.positions);
        velocities.clone_from(&kept.velocities);
        self.net.clone_from(&kept.net);
        if kept.external_forces.is_empty() {
            self.external_forces.fill(DVec3::ZERO);
        } else {
            self.external_forces.clone_from(&kept.external_forces);
        }
        self.contact_energy = kept.contact_energy;
        self.panel_pushes.clone_from(&kept.panel_pushes);
        self.parts.forces.clone_from(&kept.forces);
        self.parts.integrator.clone_from(&kept.integrator);
        self.grabs.clone_from(&kept.grabs);
        for (constraint, found) in self.parts.constraints.iter_mut().zip(&kept.found) {
            constraint.found.clone_from(found);
        }
        self.take_hands(&kept.hands);
        self.current = kept.current;
        self.steps = kept.steps;
        self.evaluations = kept.evaluations;
        self.fallbacks = kept.fallbacks;
        self.given = kept.given;
        self.divergence.clone_from(&kept.divergence);
        // A stopped body stands in its last good state; another takes its own at the start of the next frame.
        self.last_good.clone_from(&self.parts.state);
        self.see_tears();
    }

    /// Memory that the body takes [bytes], about: its state and rest data.
    pub(in crate::solver) fn bytes(&self) -> usize {
        let state = &self.parts.state;
        let particles = size_of_val(&*state.positions) + size_of_val(&*state.velocities) + size_of_val(&*state.masses);
        let frames = size_of_val(&*self.parts.rest) + size_of_val(&*self.parts.model);
        let forces: usize = self.parts.forces.iter().map(|force| force.bytes()).sum();
        let matrix = self.parts.forces.iter().find_map(|force| force.downcast_ref::<MatrixForce>());
        let sheets = self.parts.sheets.iter().flat_map(|sheet| &sheet.vertices);
        let vertices = self.parts.fibres.iter().flat_map(|fibre| &fibre.vertices).chain(sheets);
        let fibres: usize = vertices.map(|vertex| size_of_val(&*vertex.weights)).sum();
        let skin = self.parts.skin.as_deref().map_or(0, Skin::bytes)
            + self.parts.parted_skin.as_deref().map_or(0, PartedSkin::bytes);
        let surface = self.parts.contact_surface.as_deref().map_or(0, ContactSurface::bytes);
        let springs = self.parts.layers.as_deref().map_or(0, Layers::bytes);
        // Twice the state: the last good one is kept, too.
        2 * particles
            + frames
            + forces
            + matrix.map_or(0, MatrixForce::shared_bytes)
            + fibres
            + skin
            + surface
            + springs
    }
}
