//! How finely the active fibre solid is filled: by the support radius, or by a count of particles from which that
//! follows.

use super::context::Context;
use crate::edit::Command;
use crate::edit::body_ops::{filled_by, of_any_filling};
use crate::geometry::solid::Solid;
use crate::scene::{Body, Material, OwnedBody, Shape};
use std::sync::Arc;

/// Fewest particles that a support radius asks for.
const FEWEST: u32 = 8;

/// The body's material with the support radius that it has in truth: a model that is filled by a count of particles has
/// the one that follows from that.
pub(super) fn material_in_truth(cx: &Context, body: &Body) -> Material {
    let ratio = body.material.spacing_ratio;
    let found = counted(cx, body).map(|(solid, count)| (solid.volume / f64::from(count)).cbrt() / ratio);
    Material { support_radius: found.unwrap_or(body.material.support_radius), ..body.material.clone() }
}

/// What makes the body's material another one; none where nothing was changed. `shown` is that by
/// [`material_in_truth`]. A body that is filled otherwise stays as heavy and as stiff as it is.
pub(super) fn change(cx: &Context, body: &Body, shown: &Material, material: Material) -> Option<Command> {
    if material == *shown {
        return None;
    }
    let counted = counted(cx, body);
    let of_the_scene = match counted {
        Some(_) => body.material.support_radius,
        None => material.support_radius,
    };
    let is_finer = material.support_radius != shown.support_radius;
    let is_filled_anew = is_finer || material.spacing_ratio != shown.spacing_ratio;
    if !is_filled_anew {
        let material = Material { support_radius: of_the_scene, ..material };
        return Some(Command::SetMaterial { body: body.id.clone(), material });
    }
    let mut changed = of_any_filling(body, particle_volume(cx, body));
    let mass = if material.mass == shown.mass { changed.material.mass.clone() } else { material.mass.clone() };
    if let Some((solid, _)) = counted.filter(|_| is_finer) {
        changed = filled_by(changed, solid.particles_at(material.spacing()).max(FEWEST));
    }
    changed.material = Material { mass, support_radius: of_the_scene, ..material };
    Some(Command::SetBody { verb: "Sampling of".to_owned(), body: OwnedBody::from(changed) })
}

/// The solid of a model that is filled by a count of particles, and the count.
fn counted<'a>(cx: &'a Context, body: &Body) -> Option<(&'a Arc<Solid>, u32)> {
    let Shape::Mesh(shape) = &body.shape else { return None };
    cx.document.assets().solid(shape).zip(shape.particles)
}

/// Volume of a particle of the active body as it is filled [m³]; by its spacing before it is.
fn particle_volume(cx: &Context, body: &Body) -> f64 {
    let found = cx.simulation.published().status.bodies.get(cx.active.index).and_then(|of| of.particle_volume);
    found.unwrap_or_else(|| body.material.spacing().powi(3))
}
