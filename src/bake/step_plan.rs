//! How a frame is divided into steps.

use super::draft::Draft;
use super::error::{BakeError, softer};
use super::integrator::implicit_steps;
use crate::scene::{Scene, TimeStep};
use crate::solver::body_contact::stiffness_between;
use crate::solver::collider::Collider;
use crate::solver::integrators::{Integrator, LeapFrog};
use crate::solver::world::StepPlan;

/// More steps than this to one frame are refused: nothing would be seen to happen.
const MOST_STEPS: f64 = 1e6;

/// Leap-frog's step over an integrator's from which on leap-frog could take far longer ones.
const FAR_LONGER: f64 = 10.0;

/// Divides a frame so that no body steps beyond its share of the stable step. Bodies that share a panel step together;
/// bodies that may meet share outer steps short enough for the contact between them.
pub(super) fn step_plan(scene: &Scene, drafts: &[Draft], colliders: &[Collider]) -> Result<StepPlan, BakeError> {
    let (frame_seconds, wanted, for_contact): (f64, Vec<u32>, u32) = match &scene.time.step {
        TimeStep::Automatic(automatic) => {
            let frame = scene.time.frame_seconds();
            let count = |stable: f64| (frame / (automatic.safety * stable)).ceil().max(1.0) as u32;
            for draft in drafts {
                let stable_dt = draft.parts.stable_dt;
                let steps = frame / (automatic.safety * stable_dt);
                if steps.is_nan() || steps > MOST_STEPS {
                    return Err(BakeError::TooManySteps {
                        path: "/time/frames_per_second".to_owned(),
                        body: draft.parts.name.clone(),
                        frame_seconds: frame,
                        steps,
                        stable_dt,
                        remedy: softer(
                            draft.parts.limited_by.as_deref(),
                            (draft.parts.explicit_dt > FAR_LONGER * stable_dt)
                                .then(|| format!("{}/integrator", draft.parts.pointer))
                                .as_deref(),
                        ),
                    });
                }
            }
            let wanted = drafts.iter().map(|draft| match draft.parts.stable_dt {
                f64::INFINITY => implicit_steps(frame) as u32,
                stable_dt => count(stable_dt),
            });
            let fastest = colliders.iter().map(|of| of.greatest_speed(scene.time.duration)).fold(0.0, f64::max);
            let wanted = wanted.zip(drafts).map(|(wanted, draft)| match meeting_step(draft, fastest) {
                Some(step) if !colliders.is_empty() && frame / step <= MOST_STEPS => {
                    wanted.max((frame / step).ceil() as u32)
                }
                _ => wanted,
            });
            let wanted = wanted.collect();
            let under_panels = if scene.panels.is_empty() { f64::INFINITY } else { stable_panel_step(drafts) };
            (frame, wanted, count(stable_contact_step(drafts).min(under_panels)))
        }
        TimeStep::Manual(manual) => {
            let count = manual.substeps_per_frame;
            (scene.time.frame_seconds(), vec![count; drafts.len()], count)
        }
    };
    let outer_steps = match (scene.panels.is_empty(), drafts.len()) {
        (false, _) => wanted.iter().copied().max().unwrap_or(1).max(for_contact),
        (true, 0 | 1) => 1,
        (true, _) => for_contact,
    };
    let substeps = wanted.iter().map(|count| count.div_ceil(outer_steps)).collect();
    Ok(StepPlan { frame_seconds, outer_steps, substeps })
}

/// Share of a particle's reach by which it comes nearer to a collider in a step.
const NEARER: f64 = 0.1;

/// Greatest step [s] in which a body at its present speed is not flung past a collider of this greatest speed [m/s];
/// none where neither moves.
fn meeting_step(draft: &Draft, fastest: f64) -> Option<f64> {
    let own = draft.parts.state.velocities.iter().map(|v| v.length()).fold(0.0, f64::max);
    (own + fastest > 0.0).then(|| NEARER * draft.parts.reach / (own + fastest))
}

/// Greatest outer step [s] that resolves the contact of panels with bodies whose own steps are not bounded; those of
/// all others resolve it by themselves.
fn stable_panel_step(drafts: &[Draft]) -> f64 {
    let unbounded = drafts.iter().filter(|draft| draft.parts.stable_dt.is_infinite());
    let steps = unbounded.map(|draft| {
        let law = &draft.parts.contact;
        let lightest = lightest(draft);
        let damping = law.damping.max(law.sticking) / lightest;
        LeapFrog::default().stable_step((law.stiffness / lightest).sqrt(), damping)
    });
    steps.fold(f64::INFINITY, f64::min)
}

/// Mass of a body's lightest particle [kg].
fn lightest(draft: &Draft) -> f64 {
    draft.parts.state.masses.iter().copied().fold(f64::INFINITY, f64::min)
}

/// Greatest outer step [s] that resolves the contact between any two bodies; infinite without any.
fn stable_contact_step(drafts: &[Draft]) -> f64 {
    // A particle of a surface may carry several others.
    const CARRIED: f64 = 4.0;
    let mut fastest: f64 = 0.0;
    for (index, a) in drafts.iter().enumerate() {
        for b in &drafts[index + 1..] {
            let stiffness = CARRIED * stiffness_between(&a.parts.contact, &b.parts.contact);
            fastest = fastest.max(stiffness * (1.0 / lightest(a) + 1.0 / lightest(b)));
        }
    }
    if fastest > 0.0 { 2.0 / fastest.sqrt() } else { f64::INFINITY }
}
