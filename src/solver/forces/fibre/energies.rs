//! What the fibres of a body store.

use super::force::FibreForce;
use super::material_turn::turn_of_material;
use crate::solver::energy::Energies;
use crate::solver::forces::element::contract::{Element, Local};
use glam::DVec3;

impl FibreForce {
    /// Adds the energy [J] of all edges and bends that are whole, at a time [s], with particles at `positions` [m].
    pub(super) fn add_stored(&self, time: f64, positions: &[DVec3], energies: &mut Energies) {
        let (mut first_edge, mut first_bend) = (0, 0);
        for fibre in self.fibres.iter() {
            let x: Vec<DVec3> = fibre.vertices.iter().map(|vertex| vertex.gather(positions)).collect();
            let rest_length = fibre.lengths_at(time);
            let muscle = fibre.activation.as_ref().and_then(|activation| activation.excitations(time));
            let binormal = fibre.binormals_at(time);
            let [edges, bends] = fibre.thicknesses_at(time);
            for k in (0..fibre.edges.len()).filter(|k| !self.broken.edges[first_edge + k]) {
                let at = Local { points: &x[k..k + 2], turns: &[] };
                let edge = fibre.edge(k, [rest_length(k), self.yielded.stretch(first_edge + k)], edges(k));
                energies.stretching += edge.energy(&at);
                if let Some((muscle, excited)) = &muscle {
                    energies.stretching += fibre.pull(k, *muscle, excited(k), edges(k)).energy(&at);
                }
            }
            for k in (0..fibre.bends.len()).filter(|k| !self.broken.bends[first_bend + k]) {
                let mut turn = self.turns[first_bend + k];
                if let Some(curved) = &fibre.bends[k].curved {
                    turn_of_material(&curved.turn, positions, &mut turn);
                }
                let rest = binormal(k) + self.yielded.binormal(first_bend + k);
                energies.bending +=
                    fibre.bend(k, rest, bends(k)).energy(&Local { points: &x[k..k + 3], turns: &[turn] });
            }
            first_edge += fibre.edges.len();
            first_bend += fibre.bends.len();
        }
        energies.twisting += self.twisting_energy(time, positions);
    }
}
