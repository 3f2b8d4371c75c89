//! Checks of the measures.

use super::check::{At, Checked, Ids, direction, require};
use super::two_layer::known_regions;
use crate::scene::{AnyBody, Body, Measure, MeasureKind, Region, Scene, SceneError, TwoLayer};

/// `bodies` are the identifiers of the scene's bodies.
pub(super) fn measures(at: &At<'_>, scene: &Scene, bodies: &Ids<'_>) -> Checked {
    let mut names = Ids::of("measure");
    let mut colliders = Ids::of("collider");
    scene.colliders.iter().try_for_each(|of| colliders.add(at, &of.id))?;
    for (index, measure) in scene.measures.iter().enumerate() {
        let at = at.item(index);
        names.add(&at.field("name"), &measure.name)?;
        bodies.resolve(&at.field("body"), &measure.body)?;
        let at = at.field("kind");
        if let MeasureKind::ColliderForce(of) = &measure.kind {
            let at = at.field("collider_force");
            colliders.resolve(&at.field("collider"), &of.collider)?;
        }
        match scene.find_body(&measure.body) {
            Some(AnyBody::Solid(body)) => {
                one_layer(&at, measure)?;
                fibre(&at, measure, body)?;
                kind(&at, measure, &own_regions(&at, &body.regions)?)?;
            }
            Some(AnyBody::TwoLayer(body)) => {
                layers(&at, measure, body)?;
                kind(&at, measure, &known_regions(&at, body)?)?;
            }
            None => {}
        }
        if let MeasureKind::PanelForce(on) = &measure.kind {
            let mut panels = Ids::of("panel");
            scene.panels.iter().try_for_each(|panel| panels.add(&at, &panel.id))?;
            panels.resolve(&at.field("panel_force").field("panel"), &on.panel)?;
        }
    }
    Ok(())
}

fn own_regions<'a>(at: &At<'_>, regions: &'a [Region]) -> Result<Ids<'a>, SceneError> {
    let mut ids = Ids::of("region");
    regions.iter().try_for_each(|region| ids.add(at, &region.id))?;
    Ok(ids)
}

/// A fibre solid has no layers to measure.
fn one_layer(at: &At<'_>, measure: &Measure) -> Checked {
    let of_layers = matches!(measure.kind, MeasureKind::LayerOffset | MeasureKind::InertiaRatio);
    require(at, &measure.kind, !of_layers, "is of two-layer bodies only", || "measure one of `two_layer`")
}

/// A fibre that is measured has to be there.
fn fibre(at: &At<'_>, measure: &Measure, body: &Body) -> Checked {
    let MeasureKind::FibreTension(of) = &measure.kind else { return Ok(()) };
    let mut fibres = Ids::of("fibre");
    body.fibres.iter().try_for_each(|fibre| fibres.add(at, &fibre.id))?;
    fibres.resolve(&at.field("fibre_tension").field("fibre"), &of.fibre)
}

/// What a two-layer body has to measure depends on its shape.
fn layers(at: &At<'_>, measure: &Measure, body: &TwoLayer) -> Checked {
    match measure.kind {
        MeasureKind::LayerOffset => {
            let two = body.shape.has_inner_layer();
            require(at, &measure.kind, two, "has no second layer to measure", || "give the body both layers")
        }
        MeasureKind::Volume => {
            let closed = body.shape.dimension() > 1;
            require(at, &measure.kind, closed, "has nothing enclosed to measure", || "measure a ring, a ball or a mesh")
        }
        MeasureKind::Dissipated
        | MeasureKind::PlasticStrain
        | MeasureKind::Torn
        | MeasureKind::Stress(_)
        | MeasureKind::Strain(_)
        | MeasureKind::FibreTension(_) => {
            require(at, &measure.kind, false, "is of fibre solids only", || "measure one of `bodies`")
        }
        _ => Ok(()),
    }
}

fn kind(at: &At<'_>, measure: &Measure, regions: &Ids<'_>) -> Checked {
    let (name, region, against, axis) = match &measure.kind {
        MeasureKind::MeanDisplacement(of) => ("mean_displacement", &of.region, None, None),
        MeasureKind::Advance(of) => ("advance", &of.region, None, Some(("along", &of.along))),
        MeasureKind::TipDisplacement(of) => ("tip_displacement", &of.region, None, None),
        MeasureKind::HeightLoss(of) => ("height_loss", &of.region, Some(&of.against), None),
        MeasureKind::Twist(of) => ("twist", &of.region, Some(&of.against), Some(("axis", &of.axis))),
        MeasureKind::Shear(of) => ("shear", &of.region, Some(&of.against), None),
        MeasureKind::ReactionForce(of) => ("reaction_force", &of.region, None, Some(("along", &of.along))),
        MeasureKind::ReactionTorque(of) => ("reaction_torque", &of.region, None, Some(("along", &of.along))),
        MeasureKind::Stress(of) => ("stress", &of.region, None, of.along.as_ref().map(|along| ("along", along))),
        MeasureKind::Strain(of) => ("strain", &of.region, None, of.along.as_ref().map(|along| ("along", along))),
        MeasureKind::Speed(of) => ("speed", &of.region, None, None),
        MeasureKind::ContactForce(of) => {
            let at = at.field("contact_force");
            of.region.iter().try_for_each(|region| regions.resolve(&at.field("region"), region))?;
            return direction(&at.field("along"), &of.along);
        }
        MeasureKind::Size(_)
        | MeasureKind::PanelForce(_)
        | MeasureKind::FibreTension(_)
        | MeasureKind::LayerOffset
        | MeasureKind::Volume
        | MeasureKind::InertiaRatio
        | MeasureKind::ActivationWork
        | MeasureKind::Dissipated
        | MeasureKind::PlasticStrain
        | MeasureKind::Torn
        | MeasureKind::ColliderForce(_) => return Ok(()),
    };
    let at = at.field(name);
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
