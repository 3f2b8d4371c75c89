//! Checks of the measures.

use super::check::{At, Checked, Ids, direction, require};
use crate::scene::{Body, Measure, MeasureKind, Scene};

pub(super) fn measures(at: &At<'_>, scene: &Scene) -> Checked {
    let mut bodies = Ids::of("body");
    for (index, body) in scene.bodies.iter().enumerate() {
        bodies.add(&At::ROOT.field("bodies").item(index).field("id"), &body.id)?;
    }
    let mut names = Ids::of("measure");
    for (index, measure) in scene.measures.iter().enumerate() {
        let at = at.item(index);
        names.add(&at.field("name"), &measure.name)?;
        bodies.resolve(&at.field("body"), &measure.body)?;
        if let Some(body) = scene.body(&measure.body) {
            kind(&at.field("kind"), measure, body)?;
        }
    }
    Ok(())
}

fn kind(at: &At<'_>, measure: &Measure, body: &Body) -> Checked {
    let (name, region, against, axis) = match &measure.kind {
        MeasureKind::MeanDisplacement(of) => ("mean_displacement", &of.region, None, None),
        MeasureKind::TipDisplacement(of) => ("tip_displacement", &of.region, None, None),
        MeasureKind::HeightLoss(of) => ("height_loss", &of.region, Some(&of.against), None),
        MeasureKind::Twist(of) => ("twist", &of.region, Some(&of.against), Some(("axis", &of.axis))),
        MeasureKind::Shear(of) => ("shear", &of.region, Some(&of.against), None),
        MeasureKind::ReactionForce(of) => ("reaction_force", &of.region, None, Some(("along", &of.along))),
        MeasureKind::ReactionTorque(of) => ("reaction_torque", &of.region, None, Some(("along", &of.along))),
    };
    let at = at.field(name);
    let mut regions = Ids::of("region");
    for other in &body.regions {
        regions.add(&at, &other.id)?;
    }
    regions.resolve(&at.field("region"), region)?;
    if let Some(against) = against {
        let at = at.field("against");
        regions.resolve(&at, against)?;
        require(&at, against, against != region, "is the measured region itself", || "name another region")?;
    }
    if let Some((name, axis)) = axis {
        direction(&at.field(name), axis)?;
    }
    Ok(())
}
