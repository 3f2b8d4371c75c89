//! Checks of voids.

use super::check::{At, Checked, Ids, number, ordered, positive, require, vector};
use super::lines::source;
use super::parts::model_file;
use crate::scene::{MAX_VOIDS, Void, VoidShape};

pub(super) fn voids(at: &At<'_>, voids: &[Void]) -> Checked {
    require(at, &[(); 0], voids.len() <= MAX_VOIDS, &format!("has {} voids", voids.len()), || {
        format!("give at most {MAX_VOIDS}, or make one mesh of them")
    })?;
    let mut ids = Ids::of("void");
    for (index, void) in voids.iter().enumerate() {
        let at = at.item(index);
        ids.add(&at.field("id"), &void.id)?;
        shape(&at.field("shape"), &void.shape)?;
    }
    Ok(())
}

fn shape(at: &At<'_>, shape: &VoidShape) -> Checked {
    match shape {
        VoidShape::Sphere { center, radius, .. } => {
            let at = at.field("sphere");
            vector(&at.field("center"), center, "m")?;
            positive(&at.field("radius"), *radius, "m")
        }
        VoidShape::Box { min, max, .. } => {
            let at = at.field("box");
            vector(&at.field("min"), min, "m")?;
            vector(&at.field("max"), max, "m")?;
            for (axis, (&least, &greatest)) in min.iter().zip(max).enumerate() {
                let at = at.field("max");
                ordered(&at.item(axis), least, greatest, &format!("the least corner's {} m", number(least)))?;
            }
            Ok(())
        }
        VoidShape::Tube { source: line, radius, .. } => {
            let at = at.field("tube");
            source(&at.field("source"), line)?;
            positive(&at.field("radius"), *radius, "m")
        }
        VoidShape::Mesh(mesh) => model_file(&at.field("mesh"), mesh.into()),
    }
}
