//! What an evaluation of the force is.

use super::reference::ReferenceConfiguration;
use crate::solver::state::ParticleState;
use glam::{DQuat, DVec3};

/// One way to compute the sums over neighbours, with warm starts and buffers that it keeps between evaluations.
pub(super) trait Evaluation: Send + Sync {
    /// Adds the forces [N].
    fn add_forces(&mut self, reference: &ReferenceConfiguration, state: &ParticleState, forces: &mut [DVec3]);

    /// Rotation of particle i at the last evaluation.
    fn rotation(&self, i: usize) -> DQuat;

    /// Memory of the warm starts [bytes].
    fn bytes(&self) -> usize;

    /// Which of them it is.
    fn kind(&self) -> EvaluationKind;

    fn clone_box(&self) -> Box<dyn Evaluation>;
}

impl Clone for Box<dyn Evaluation> {
    fn clone(&self) -> Self {
        self.clone_box()
    }
}

/// The evaluations that there are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EvaluationKind {
    /// By stencils in f64.
    Exact,
    /// By stencils in f32, on deviations from the body's rigid motion.
    Fast,
    /// Particle by particle in f64.
    PairList,
}
