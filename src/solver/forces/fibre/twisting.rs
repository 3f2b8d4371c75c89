//! What the twisted fibres of a body do together.

use super::force::FibreForce;
use glam::DVec3;

impl FibreForce {
    /// Energy of twist [J] of particles at `positions` [m].
    pub(super) fn twisting_energy(&self, time: f64, positions: &[DVec3]) -> f64 {
        let (mut energy, mut first_edge, mut first_end) = (0.0, 0, 0);
        for fibre in self.fibres.iter() {
            if let Some(twist) = &fibre.twist {
                let (wanted, [thickness, _]) = (fibre.twists_at(time), fibre.thicknesses_at(time));
                let angles = twist.angles(positions, &self.ends[first_end..]);
                for (k, (edge, angle)) in twist.edges.iter().zip(angles).enumerate() {
                    if !self.broken.edges[first_edge + k] {
                        energy += 0.5 * thickness(k) * edge.stiffness * (angle - wanted(k)).powi(2);
                    }
                }
            }
            first_edge += fibre.edges.len();
            first_end += fibre.twisted_ends();
        }
        energy
    }

    /// Adds what twisted fibres do to particles at `positions` [m].
    pub(super) fn add_twists(&mut self, time: f64, positions: &[DVec3], forces: &mut [DVec3]) {
        let (mut first_edge, mut first_end) = (0, 0);
        for fibre in self.fibres.iter() {
            if let Some(twist) = &fibre.twist {
                let (wanted, [thickness, _]) = (fibre.twists_at(time), fibre.thicknesses_at(time));
                let at_rest = |k: usize| (!self.broken.edges[first_edge + k]).then(|| [wanted(k), thickness(k)]);
                let warm = &mut self.ends[first_end..first_end + twist.len()];
                twist.add_forces(at_rest, positions, warm, forces);
            }
            first_edge += fibre.edges.len();
            first_end += fibre.twisted_ends();
        }
    }
}
