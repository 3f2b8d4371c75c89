//! Damped springs between particles, as in the two-layer paper.

use super::force::{Force, StepLimit};
use crate::solver::energy::Energies;
use crate::solver::state::ParticleState;
use glam::DVec3;
use std::ops::Range;
use std::sync::Arc;

/// Role of a spring in a two-layer body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SpringKind {
    /// Along an edge of a layer.
    Structural,
    /// From a vertex of the inner layer to the same one of the outer layer.
    Radius,
    /// From the first vertex of an edge in the inner layer to the second in the outer layer.
    ShearLeft,
    /// From the second vertex of an edge in the inner layer to the first in the outer layer.
    ShearRight,
}

/// Springs of one kind, which share their constants.
#[derive(Clone, Debug, PartialEq)]
pub struct SpringGroup {
    /// What they are.
    pub kind: SpringKind,
    /// Stiffness [N/m].
    pub stiffness: f64,
    /// Damping along the spring [N s/m].
    pub damping: f64,
    /// Which of the springs.
    pub springs: Range<usize>,
}

/// `f = [ks (L - L0) + kd (dv . n)] n` on the first end of every spring, the opposite on the second (sec. 3.2).
///
/// Springs lie in structure-of-arrays order, group by group, and are evaluated one after the other: at some nanoseconds
/// a spring threads would cost more than they save, and the sums have one order.
#[derive(Clone, Debug)]
pub struct Springs {
    ends: Arc<[[u32; 2]]>,
    rest_lengths: Arc<[f64]>,
    groups: Vec<SpringGroup>,
}

impl Springs {
    /// Springs between `ends`, at rest at `rest_lengths` [m]; the groups divide them without a gap.
    pub fn new(ends: Arc<[[u32; 2]]>, rest_lengths: Arc<[f64]>, groups: Vec<SpringGroup>) -> Self {
        debug_assert_eq!(ends.len(), rest_lengths.len());
        Self { ends, rest_lengths, groups }
    }

    /// Particles at both ends of every spring.
    pub fn ends(&self) -> &Arc<[[u32; 2]]> {
        &self.ends
    }

    /// The groups.
    pub fn groups(&self) -> &[SpringGroup] {
        &self.groups
    }

    fn of<'a>(&'a self, group: &SpringGroup) -> impl Iterator<Item = ([usize; 2], f64)> + 'a {
        let range = group.springs.clone();
        let ends = &self.ends[range.clone()];
        ends.iter().zip(&self.rest_lengths[range]).map(|(&[a, b], &rest)| ([a as usize, b as usize], rest))
    }
}

impl Force for Springs {
    fn add_forces(&mut self, _time: f64, state: &ParticleState, forces: &mut [DVec3]) {
        let ParticleState { positions, velocities, .. } = state;
        for group in &self.groups {
            for ([a, b], rest) in self.of(group) {
                let d = positions[b] - positions[a];
                let dv = velocities[b] - velocities[a];
                // A spring of no length has no direction and gives no force.
                let inverse_square = 1.0 / d.length_squared().max(f64::MIN_POSITIVE);
                let pull = group.stiffness * (1.0 - rest * inverse_square.sqrt())
                    + group.damping * (dv.dot(d) * inverse_square);
                let force = pull * d;
                forces[a] += force;
                forces[b] -= force;
            }
        }
    }

    fn add_energy(&self, _time: f64, state: &ParticleState, energies: &mut Energies) {
        for group in &self.groups {
            let squares: f64 = self
                .of(group)
                .map(|([a, b], rest)| (state.positions[b].distance(state.positions[a]) - rest).powi(2))
                .sum();
            energies.springs += 0.5 * group.stiffness * squares;
        }
    }

    fn is_internal(&self) -> bool {
        true
    }

    fn couplings(&self) -> Vec<Vec<u32>> {
        self.ends.iter().map(|ends| ends.to_vec()).collect()
    }

    fn step_limit(&self, state: &ParticleState) -> StepLimit {
        // Gershgorin: no row of the damping matrix sums to more than twice the particle's own entry.
        let mut rates = vec![0.0; state.len()];
        for group in &self.groups {
            for ([a, b], _) in self.of(group) {
                rates[a] += 2.0 * group.damping / state.masses[a];
                rates[b] += 2.0 * group.damping / state.masses[b];
            }
        }
        StepLimit { damping_rate: rates.into_iter().fold(0.0, f64::max), ..StepLimit::default() }
    }

    fn changes_until(&self) -> f64 {
        0.0
    }

    fn clone_box(&self) -> Box<dyn Force> {
        Box::new(self.clone())
    }
}
