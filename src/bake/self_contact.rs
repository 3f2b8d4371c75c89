//! Bodies that touch themselves.

use super::layer_model::LayerModel;
use crate::scene::{Body, TwoLayer};
use crate::solver::forces::{ContactLaw, SelfContact, SelfTouching, StepLimit, surface_particles};
use glam::DVec3;
use std::f64::consts::FRAC_1_SQRT_2;

/// Contact of a fibre solid with itself by the particles of its surface, as stiff as its contact with anything else.
pub(super) fn of_solid(body: &Body, law: &ContactLaw, points: &[DVec3]) -> Option<SelfContact> {
    if !body.self_contact {
        return None;
    }
    let touching = surface_particles(points, body.material.spacing()).into_iter();
    let touching =
        touching.map(|particle| SelfTouching { particle, radius: law.radius, rest: points[particle as usize] });
    Some(contact(law, touching.collect()))
}

/// Contact of a two-layer body with itself: its particles are balls as large as the mean edge of their layer is long,
/// so that none slips through between two of them.
pub(super) fn of_two_layer(body: &TwoLayer, law: &ContactLaw, model: &LayerModel) -> Option<SelfContact> {
    if !body.self_contact {
        return None;
    }
    let radii = [0.5 * model.spacing(), 0.5 * model.inner_spacing()];
    let touching = model.points.iter().enumerate().map(|(index, &rest)| {
        let radius = radii[usize::from(index >= model.outer)];
        SelfTouching { particle: index as u32, radius, rest }
    });
    Some(contact(law, touching.collect()))
}

/// The same critical share of damping as of one particle against a wall: of two both give way.
fn contact(law: &ContactLaw, touching: Vec<SelfTouching>) -> SelfContact {
    SelfContact::new([law.stiffness, FRAC_1_SQRT_2 * law.damping], touching)
}

/// What two contacts ask of the time step, of which a particle feels one at a time.
pub(super) fn either(a: StepLimit, b: StepLimit) -> StepLimit {
    StepLimit {
        frequency_squared: a.frequency_squared.max(b.frequency_squared),
        damping_rate: a.damping_rate.max(b.damping_rate),
    }
}
