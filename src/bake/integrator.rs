//! From the name of an integrator to the integrator.

use super::drives;
use super::note::Note;
use crate::scene::{Body, Initial, IntegratorChoice, IntegratorKind, Motion, Scene, TimeStep};
use crate::solver::forces::{FibreForce, Force};
use crate::solver::integrators::{
    BackwardEuler, Bdf2, ExplicitEuler, Feynman, FibresImplicit, ImplicitMidpoint, Integrator, LeapFrog, Midpoint,
    Newmark, Rk4, Sdirk2, SymplecticEuler, TrBdf2, Verlet, work_of_a_step,
};
use crate::solver::state::ParticleState;

/// The stable step of fibres taken implicitly over leap-frog's from which on they are, where such a step takes as long.
const WORTH_IT: f64 = 4.0;
/// The same for each of leap-frog's steps that such a step takes as long as.
const WORTH_THE_WORK: f64 = 1.5;

/// Leap-frog's steps to one of the whole body implicit from which on that is taken: it takes about as long as 150.
const WORTH_SOLVING: f64 = 400.0;
/// Particles up to which the whole body's matrix is factored within a second or two.
const MOST_SOLVED: usize = 6000;

/// How a body is stepped.
pub(super) struct Choice {
    pub(super) integrator: IntegratorKind,
    /// Why, where that was chosen here and is not leap-frog.
    pub(super) reason: Option<String>,
}

impl Choice {
    /// What is said of it, of a body by its pointer.
    pub(super) fn note(&self, path: &str) -> Option<Note> {
        let text = self.reason.clone()?;
        Some(Note { path: format!("{path}/integrator"), text, warning: false })
    }
}

/// How a fibre solid of a scene is stepped that takes these steps [s], in the order of [`IntegratorKind::ALL`].
pub(super) fn stepping(
    scene: &Scene,
    body: &Body,
    stable_steps: &[f64],
    forces: &[Box<dyn Force>],
    state: &ParticleState,
) -> Choice {
    if let IntegratorChoice::Given(integrator) = body.integrator {
        return Choice { integrator, reason: None };
    }
    let step =
        |kind| IntegratorKind::ALL.iter().zip(stable_steps).find(|(one, _)| **one == kind).map_or(0.0, |of| *of.1);
    let (implicit, explicit) = (step(IntegratorKind::FibresImplicit), step(IntegratorKind::LeapFrog));
    let fibres = forces.iter().find_map(|force| force.downcast_ref::<FibreForce>());
    let work = || fibres.map_or(1.0, |fibres| work_of_a_step(fibres, state));
    if implicit > WORTH_IT * explicit && implicit > WORTH_THE_WORK * work() * explicit {
        let reason = format!("fibres implicit: stable step {implicit:.1e} instead of {explicit:.1e} s");
        return Choice { integrator: IntegratorKind::FibresImplicit, reason: Some(reason) };
    }
    let whole = match &scene.time.step {
        TimeStep::Automatic(_) => implicit_step(scene.time.frame_seconds()),
        TimeStep::Manual(manual) => manual.dt,
    };
    if moves_gently(scene, body) && state.len() <= MOST_SOLVED && whole > WORTH_SOLVING * explicit {
        let reason = format!("the whole body implicit: step {whole:.1e} instead of {explicit:.1e} s");
        return Choice { integrator: IntegratorKind::TrBdf2, reason: Some(reason) };
    }
    Choice { integrator: IntegratorKind::LeapFrog, reason: None }
}

/// Whether by all that the scene says a body is held, starts without speed, takes no blow, does not tear or yield, is
/// driven by nothing, blown at by nothing and meets neither panels, colliders, other bodies nor itself: long steps
/// resolve what it does.
fn moves_gently(scene: &Scene, body: &Body) -> bool {
    let Initial { velocity, angular_velocity, .. } = &body.initial;
    let is_held = body.pins.iter().any(|pin| pin.axes.len() == 3 && pin.motion == Motion::Fixed);
    let is_alone =
        !body.self_contact && scene.all_bodies().count() == 1 && scene.panels.is_empty() && scene.colliders.is_empty();
    let is_struck = !body.impulses.is_empty() || [*velocity, *angular_velocity] != [[0.0; 3]; 2];
    let may_tear = body.fibres.iter().any(|fibre| fibre.break_past.is_some() || fibre.yields.is_some())
        || body.sheets.iter().any(|sheet| sheet.seam.is_some())
        || body.material.plasticity.is_some();
    let is_moved = body.pins.iter().any(|pin| matches!(pin.motion, Motion::Driven(_)));
    let is_driven = scene.gravity_drive.is_some()
        || body.fibres.iter().any(|fibre| fibre.activation.is_some())
        || body.sheets.iter().any(|sheet| sheet.activation.is_some())
        || body.elements.iter().any(|element| element.activation.is_some());
    is_held
        && is_alone
        && !is_struck
        && !may_tear
        && !is_moved
        && !is_driven
        && body.follows.is_empty()
        && !drives::blows(scene)
}

/// Longest step of an integrator that is stable at any [s]; longer ones would show little of the motion.
const LONGEST_STEP: f64 = 1.0 / 59.0;

/// The step [s] into which a frame is divided for an integrator that is stable at any.
fn implicit_step(frame_seconds: f64) -> f64 {
    frame_seconds / implicit_steps(frame_seconds)
}

/// The number of steps to a frame [s] of an integrator that is stable at any.
pub(super) fn implicit_steps(frame_seconds: f64) -> f64 {
    (frame_seconds / LONGEST_STEP).ceil().max(1.0)
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
        IntegratorKind::Feynman => Box::new(Feynman::default()),
        IntegratorKind::BackwardEuler => Box::new(BackwardEuler::default()),
        IntegratorKind::TrBdf2 => Box::new(TrBdf2::default()),
        IntegratorKind::Sdirk2 => Box::new(Sdirk2::default()),
        IntegratorKind::ImplicitMidpoint => Box::new(ImplicitMidpoint::default()),
        IntegratorKind::Bdf2 => Box::new(Bdf2::default()),
        IntegratorKind::Newmark => Box::new(Newmark::default()),
    }
}
