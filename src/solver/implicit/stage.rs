//! What is solved for.

use glam::DVec3;

/// One implicit stage: find x and `v = (x - xb) / h` with `M (v - vb) / h = f(x, v, time)`.
#[derive(Clone, Copy)]
pub(in crate::solver) struct Stage<'a> {
    /// Time of the forces [s].
    pub(in crate::solver) time: f64,
    /// The stage's own step h [s].
    pub(in crate::solver) h: f64,
    /// Base positions xb [m].
    pub(in crate::solver) positions: &'a [DVec3],
    /// Base velocities vb [m/s].
    pub(in crate::solver) velocities: &'a [DVec3],
    /// Whether its solution is the state at the end of a step, so that the next one may start from its forces.
    pub(in crate::solver) is_end: bool,
}

/// A stage that no solution was found for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::solver) struct Unconverged;
