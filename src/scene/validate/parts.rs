//! Checks of what bodies of both kinds have.

use super::check::{At, Checked, Ids, direction, finite, increasing, not_negative, number, positive, require, vector};
use super::drives::still;
use crate::scene::{
    Distance, Impulse, Initial, MAX_PARTICLES, ModelFile, Motion, Pin, Placement, Region, Rotation, Selector,
    SharedDrive,
};
use glam::DVec3;

pub(super) fn model_file(at: &At<'_>, file: ModelFile<'_>) -> Checked {
    require(
        &at.field("path"),
        &file.path,
        !file.path.trim().is_empty(),
        "names no file",
        || "name an OBJ, STL, PLY, glTF or GLB file, relative to the scene file",
    )?;
    positive(&at.field("scale"), file.scale, "m")
}

pub(super) fn placement(at: &At<'_>, placement: &Placement) -> Checked {
    vector(&at.field("translation"), &placement.translation, "m")?;
    rotation(&at.field("rotation"), &placement.rotation)
}

pub(super) fn rotation(at: &At<'_>, rotation: &Rotation) -> Checked {
    direction(&at.field("axis"), &rotation.axis)?;
    finite(&at.field("degrees"), rotation.degrees, "degrees")
}

pub(super) fn initial(at: &At<'_>, initial: &Initial) -> Checked {
    vector(&at.field("velocity"), &initial.velocity, "m/s")?;
    vector(&at.field("angular_velocity"), &initial.angular_velocity, "degrees/s")?;
    let at = at.field("deformation");
    for (row, components) in initial.deformation.iter().enumerate() {
        vector(&at.item(row), components, "")?;
    }
    let [a, b, c] = initial.deformation.map(DVec3::from);
    require(
        &at,
        &initial.deformation,
        a.cross(b).dot(c) > 0.0,
        "turns the body inside out or flattens it",
        || "give three rows of positive determinant, such as [[1,0,0],[0,1,0],[0,0,1]]",
    )
}

/// The regions of the body here, added to those that are known.
pub(super) fn regions<'a>(at: &At<'_>, regions: &'a [Region], known: &mut Ids<'a>) -> Checked {
    for (index, region) in regions.iter().enumerate() {
        let at = at.field("regions");
        let at = at.item(index);
        known.add(&at.field("id"), &region.id)?;
        selector(&at.field("select"), &region.select)?;
    }
    Ok(())
}

/// The impulses of the body here.
pub(super) fn impulses(at: &At<'_>, impulses: &[Impulse], regions: &Ids<'_>) -> Checked {
    for (index, impulse) in impulses.iter().enumerate() {
        let at = at.field("impulses");
        let at = at.item(index);
        regions.resolve(&at.field("region"), &impulse.region)?;
        vector(&at.field("impulse"), &impulse.impulse, "N s")?;
    }
    Ok(())
}

/// The pins of the body here.
pub(super) fn pins(at: &At<'_>, all: &[Pin], regions: &Ids<'_>, drives: &[SharedDrive]) -> Checked {
    let mut ids = Ids::of("pin");
    for (index, one) in all.iter().enumerate() {
        let at = at.field("pins");
        let at = at.item(index);
        ids.add(&at.field("id"), &one.id)?;
        regions.resolve(&at.field("region"), &one.region)?;
        pin(&at, one, drives)?;
    }
    Ok(())
}

fn selector(at: &At<'_>, selector: &Selector) -> Checked {
    match selector {
        Selector::Everything => Ok(()),
        Selector::Layers { count, .. } => {
            let at = at.field("layers");
            let possible = (1..=MAX_PARTICLES).contains(&(*count as usize));
            require(&at.field("count"), count, possible, "is no number of layers", || {
                format!("give 1 to {MAX_PARTICLES}")
            })
        }
        Selector::Box { min, max, .. } => {
            let at = at.field("box");
            vector(&at.field("min"), min, "m")?;
            vector(&at.field("max"), max, "m")?;
            for (axis, (least, greatest)) in min.iter().zip(max).enumerate() {
                let at = at.field("max");
                require(&at.item(axis), greatest, least <= greatest, "is below the least corner", || {
                    format!("give {} m or more", number(*least))
                })?;
            }
            Ok(())
        }
        Selector::Sphere { center, radius, .. } => {
            let at = at.field("sphere");
            vector(&at.field("center"), center, "m")?;
            positive(&at.field("radius"), *radius, "m")
        }
    }
}

fn pin(at: &At<'_>, pin: &Pin, drives: &[SharedDrive]) -> Checked {
    require(
        &at.field("axes"),
        &pin.axes,
        !pin.axes.is_empty(),
        "holds the region along no axis",
        || "name an axis at least, such as [\"x\", \"y\", \"z\"]",
    )?;
    motion(&at.field("motion"), &pin.motion, drives)
}

/// A prescribed motion; `drives` are those that its body shares.
pub(super) fn motion(at: &At<'_>, motion: &Motion, drives: &[SharedDrive]) -> Checked {
    match motion {
        Motion::Fixed => Ok(()),
        Motion::Ramp(ramp) => {
            let at = at.field("ramp");
            direction(&at.field("direction"), &ramp.direction)?;
            let distance = at.field("distance");
            match ramp.distance {
                Distance::Metres(metres) => finite(&distance.field("metres"), metres, "m")?,
                Distance::Fraction(fraction) => finite(&distance.field("fraction"), fraction, "of the extent")?,
            }
            not_negative(&at.field("start"), ramp.start, "s")?;
            positive(&at.field("duration"), ramp.duration, "s")
        }
        Motion::Turn(turn) => {
            let at = at.field("turn");
            direction(&at.field("axis"), &turn.axis)?;
            turn.origin.map_or(Ok(()), |origin| vector(&at.field("origin"), &origin, "m"))?;
            finite(&at.field("degrees"), turn.degrees, "degrees")?;
            not_negative(&at.field("start"), turn.start, "s")?;
            positive(&at.field("duration"), turn.duration, "s")
        }
        Motion::Driven(driven) => {
            let at = at.field("driven");
            still(&at.field("drive"), &driven.drive, drives)?;
            vector(&at.field("offset"), &driven.offset, "m")?;
            let Some(turn) = &driven.turn else { return Ok(()) };
            let at = at.field("turn");
            direction(&at.field("axis"), &turn.axis)?;
            turn.origin.map_or(Ok(()), |origin| vector(&at.field("origin"), &origin, "m"))?;
            finite(&at.field("degrees"), turn.degrees, "degrees")
        }
        Motion::Keyframes(keys) => {
            let at = at.field("keyframes");
            increasing(&at, keys.iter().map(|key| key.time))?;
            for (index, key) in keys.iter().enumerate() {
                vector(&at.item(index).field("offset"), &key.offset, "m")?;
            }
            Ok(())
        }
    }
}
