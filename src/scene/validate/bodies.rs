//! Checks of the bodies of both kinds, one after the other.

use super::SceneError;
use super::check::{At, Ids};
use super::solid::solid;
use super::two_layer::two_layer;
use crate::scene::{AnyBody, Scene};

/// Checks every body; gives their identifiers.
pub(super) fn bodies<'a>(root: &At<'_>, scene: &'a Scene) -> Result<Ids<'a>, SceneError> {
    let mut ids = Ids::of("body");
    let mut particles = 0.0;
    for (index, body) in scene.all_bodies().enumerate() {
        let (list, index) = scene.body_place(index);
        let at = root.field(list);
        let at = at.item(index);
        ids.add(&at.field("id"), body.id())?;
        match body {
            AnyBody::Solid(body) => particles = solid(&at, body, particles)?,
            AnyBody::TwoLayer(body) => particles = two_layer(&at, body, particles)?,
        }
    }
    Ok(ids)
}
