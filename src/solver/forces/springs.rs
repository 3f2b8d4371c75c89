//! Damped springs between particles, as in the two-layer paper.

use super::active_springs::ActiveSprings;
use super::force::{Force, StepLimit};
use crate::solver::energy::Energies;
use crate::solver::hand::Hand;
use crate::solver::state::ParticleState;
use glam::DVec3;
use std::borrow::Cow;
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
    /// Those that act.
    active: Vec<ActiveSprings>,
    /// Work of drives that are gone since an edit [J].
    done: f64,
}

impl Springs {
    /// Springs between `ends`, at rest at `rest_lengths` [m]; the groups divide them without a gap.
    pub fn new(ends: Arc<[[u32; 2]]>, rest_lengths: Arc<[f64]>, groups: Vec<SpringGroup>) -> Self {
        debug_assert_eq!(ends.len(), rest_lengths.len());
        Self { ends, rest_lengths, groups, active: Vec::new(), done: 0.0 }
    }

    /// Whether a drive shortens any of them.
    pub(crate) fn is_active(&self) -> bool {
        !self.active.is_empty()
    }

    /// With springs that act, each of them once.
    #[must_use]
    pub(crate) fn with_active(self, active: Vec<ActiveSprings>) -> Self {
        Self { active, ..self }
    }

    /// Particles at both ends of every spring.
    pub fn ends(&self) -> &Arc<[[u32; 2]]> {
        &self.ends
    }

    /// The groups.
    pub fn groups(&self) -> &[SpringGroup] {
        &self.groups
    }

    /// Ends of a group's springs with their rest lengths among all of these [m].
    fn of<'a>(&'a self, group: &SpringGroup, lengths: &'a [f64]) -> impl Iterator<Item = ([usize; 2], f64)> + 'a {
        let range = group.springs.clone();
        let ends = &self.ends[range.clone()];
        ends.iter().zip(&lengths[range]).map(|(&[a, b], &rest)| ([a as usize, b as usize], rest))
    }

    /// Rest lengths at a time [m].
    fn lengths(&self, time: f64) -> Cow<'_, [f64]> {
        if self.active.is_empty() {
            return Cow::Borrowed(&self.rest_lengths);
        }
        let mut lengths = self.rest_lengths.to_vec();
        for active in &self.active {
            active.put_in(time, &self.rest_lengths, &mut lengths);
        }
        Cow::Owned(lengths)
    }

    /// Books the work of the drives up to a time [s]: all of it, or where the booking begins.
    fn book(&mut self, time: f64, state: &ParticleState, only_begin: bool) {
        let Self { ends, rest_lengths, groups, active, .. } = self;
        let passive = |spring: u32| {
            let spring = spring as usize;
            let group = groups.iter().find(|group| group.springs.contains(&spring));
            let stiffness = group.map_or(0.0, |group| group.stiffness);
            (ends[spring].map(|end| end as usize), stiffness, rest_lengths[spring])
        };
        for one in active.iter_mut().filter(|one| !(only_begin && one.is_booked())) {
            one.book(time, &state.positions, passive);
        }
    }
}

impl Force for Springs {
    fn add_forces(&mut self, time: f64, state: &ParticleState, forces: &mut [DVec3]) {
        self.book(time, state, true);
        let lengths = self.lengths(time);
        let ParticleState { positions, velocities, .. } = state;
        for group in &self.groups {
            for ([a, b], rest) in self.of(group, &lengths) {
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

    fn add_energy(&self, time: f64, state: &ParticleState, energies: &mut Energies) {
        let lengths = self.lengths(time);
        for group in &self.groups {
            let squares: f64 = self
                .of(group, &lengths)
                .map(|([a, b], rest)| (state.positions[b].distance(state.positions[a]) - rest).powi(2))
                .sum();
            energies.springs += 0.5 * group.stiffness * squares;
        }
        energies.activation -= self.drive_work();
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
            for ([a, b], _) in self.of(group, &self.rest_lengths) {
                rates[a] += 2.0 * group.damping / state.masses[a];
                rates[b] += 2.0 * group.damping / state.masses[b];
            }
        }
        StepLimit { damping_rate: rates.into_iter().fold(0.0, f64::max), ..StepLimit::default() }
    }

    fn end_step(&mut self, time: f64, state: &ParticleState) -> bool {
        self.book(time, state, false);
        false
    }

    fn adopt(&mut self, before: &[Box<dyn Force>]) {
        let Some(before) = before.iter().find_map(|force| force.downcast_ref::<Self>()) else { return };
        self.active.iter_mut().for_each(|one| one.adopt(&before.active));
        // What the drives that are gone did, they have done.
        let stayed: f64 = self.active.iter().map(ActiveSprings::work).sum();
        self.done = before.drive_work() - stayed;
    }

    fn give(&mut self, to: &str, led: Option<Hand>) {
        self.active.iter_mut().for_each(|one| one.give(to, led));
    }

    fn drive_work(&self) -> f64 {
        self.done + self.active.iter().map(ActiveSprings::work).sum::<f64>()
    }

    fn changes_until(&self) -> f64 {
        self.active.iter().map(ActiveSprings::until).fold(0.0, f64::max)
    }

    fn driven_until(&self) -> f64 {
        self.changes_until()
    }

    fn clone_at_extreme(&self, greatest: bool) -> Box<dyn Force> {
        let active = self.active.iter().map(|one| one.at_extreme(greatest)).collect();
        Box::new(Self { active, ..self.clone() })
    }

    fn name(&self) -> &'static str {
        "springs"
    }

    fn clone_box(&self) -> Box<dyn Force> {
        Box::new(self.clone())
    }
}
