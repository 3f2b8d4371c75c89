//! From the name of an integrator to the integrator.

use super::note::Note;
use crate::scene::{IntegratorChoice, IntegratorKind, Scene, TimeStep};
use crate::solver::forces::{FibreForce, Force};
use crate::solver::integrators::{
    BackwardEuler, Bdf2, ExplicitEuler, FibresImplicit, ImplicitMidpoint, Integrator, LeapFrog, Midpoint, Newmark, Rk4,
    Sdirk2, SymplecticEuler, TrBdf2, Verlet, work_of_a_step,
};
use crate::solver::state::ParticleState;

/// The stable step of fibres taken implicitly over leap-frog's from which on they are, where such a step takes as long.
const WORTH_IT: f64 = 4.0;
/// The same for each of leap-frog's steps that such a step takes as long as.
const WORTH_THE_WORK: f64 = 1.5;

/// How a body is stepped.
pub(super) struct Stepping {
    pub(super) integrator: IntegratorKind,
    /// Why, where that was chosen here and is not leap-frog.
    pub(super) reason: Option<String>,
}

impl Stepping {
    /// What is said of it, of a body by its pointer.
    pub(super) fn note(&self, path: &str) -> Option<Note> {
        let text = self.reason.clone()?;
        Some(Note { path: format!("{path}/integrator"), text, warning: false })
    }
}

/// How a fibre solid is stepped that takes these steps [s], in the order of [`IntegratorKind::ALL`].
pub(super) fn stepping(
    choice: IntegratorChoice,
    stable_steps: &[f64],
    forces: &[Box<dyn Force>],
    state: &ParticleState,
) -> Stepping {
    if let IntegratorChoice::Given(integrator) = choice {
        return Stepping { integrator, reason: None };
    }
    let step =
        |kind| IntegratorKind::ALL.iter().zip(stable_steps).find(|(one, _)| **one == kind).map_or(0.0, |of| *of.1);
    let (implicit, explicit) = (step(IntegratorKind::FibresImplicit), step(IntegratorKind::LeapFrog));
    let fibres = forces.iter().find_map(|force| force.downcast_ref::<FibreForce>());
    let work = || fibres.map_or(1.0, |fibres| work_of_a_step(fibres, state));
    if implicit > WORTH_IT * explicit && implicit > WORTH_THE_WORK * work() * explicit {
        let reason = format!("fibres implicit: stable step {implicit:.1e} instead of {explicit:.1e} s");
        return Stepping { integrator: IntegratorKind::FibresImplicit, reason: Some(reason) };
    }
    Stepping { integrator: IntegratorKind::LeapFrog, reason: None }
}

/// Pointer to what chooses the time step.
pub(super) fn step_parameter(scene: &Scene) -> &'static str {
    match scene.time.step {
        TimeStep::Automatic(_) => "/time/step/automatic/safety",
        TimeStep::Manual(_) => "/time/step/manual/dt",
    }
}

/// What `stable_step` says of every integrator, in the order of [`IntegratorKind::ALL`].
pub(super) fn stable_steps(stable_step: impl Fn(&dyn Integrator) -> f64) -> Vec<f64> {
    IntegratorKind::ALL.map(|kind| stable_step(integrator(kind).as_ref())).to_vec()
}

/// The integrator of a kind, as it steps first.
pub(super) fn integrator(kind: IntegratorKind) -> Box<dyn Integrator> {
    match kind {
        IntegratorKind::LeapFrog => Box::new(LeapFrog::default()),
        IntegratorKind::FibresImplicit => Box::new(FibresImplicit::default()),
        IntegratorKind::ExplicitEuler => Box::new(ExplicitEuler::default()),
        IntegratorKind::Midpoint => Box::new(Midpoint::default()),
        IntegratorKind::Rk4 => Box::new(Rk4::default()),
        IntegratorKind::SymplecticEuler => Box::new(SymplecticEuler::default()),
        IntegratorKind::Verlet => Box::new(Verlet::default()),
        IntegratorKind::BackwardEuler => Box::new(BackwardEuler::default()),
        IntegratorKind::TrBdf2 => Box::new(TrBdf2::default()),
        IntegratorKind::Sdirk2 => Box::new(Sdirk2::default()),
        IntegratorKind::ImplicitMidpoint => Box::new(ImplicitMidpoint::default()),
        IntegratorKind::Bdf2 => Box::new(Bdf2::default()),
        IntegratorKind::Newmark => Box::new(Newmark::default()),
    }
}
