//! Checks of the colliders.

use super::check::{At, Checked, Ids, not_negative, positive, require};
use super::drives;
use super::parts::{model_file, motion, placement};
use crate::scene::{Collider, ColliderShape, Distance, ModelFile, Motion};

pub(super) fn colliders(at: &At<'_>, colliders: &[Collider]) -> Checked {
    let mut ids = Ids::of("collider");
    for (index, collider) in colliders.iter().enumerate() {
        let at = at.item(index);
        ids.add(&at.field("id"), &collider.id)?;
        shape(&at.field("shape"), &collider.shape)?;
        placement(&at.field("placement"), &collider.placement)?;
        moves(&at.field("motion"), collider)?;
        not_negative(&at.field("friction"), collider.friction, "")?;
    }
    Ok(())
}

fn shape(at: &At<'_>, shape: &ColliderShape) -> Checked {
    match shape {
        ColliderShape::Sphere(of) => positive(&at.field("sphere").field("radius"), of.radius, "m"),
        ColliderShape::Box(of) => {
            let at = at.field("box");
            let at = at.field("size");
            of.size.iter().enumerate().try_for_each(|(axis, &size)| positive(&at.item(axis), size, "m"))
        }
        ColliderShape::Capsule(of) => {
            let at = at.field("capsule");
            positive(&at.field("radius"), of.radius, "m")?;
            not_negative(&at.field("length"), of.length, "m")
        }
        ColliderShape::Plane => Ok(()),
        ColliderShape::Mesh(of) => model_file(&at.field("mesh"), ModelFile::from(of)),
    }
}

fn moves(at: &At<'_>, collider: &Collider) -> Checked {
    if let Some(drive) = collider.drive() {
        drives::of_scene(&at.field("driven").field("drive"), drive)?;
    }
    motion(at, &collider.motion, &[])?;
    if let Motion::Ramp(ramp) = &collider.motion {
        let at = at.field("ramp");
        let metres = matches!(ramp.distance, Distance::Metres(_));
        require(
            &at.field("distance"),
            &ramp.distance,
            metres,
            "is a share of a body, and this is none",
            || "give {\"metres\": 0.01}",
        )?;
    }
    Ok(())
}
