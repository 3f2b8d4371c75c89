//! Measures of the scene as probes of the world.

use super::draft::Draft;
use super::error::{BakeError, known};
use super::supports;
use crate::scene::{MeasureKind, OverEdges, OverTime, Scene};
use crate::solver::measure::{Group, Quantity};
use crate::solver::world::Probe;
use glam::{BVec3, DVec3};

/// Least distance at rest between the two ends of a height, in reaches of the body.
const LEAST_HEIGHT: f64 = 0.1;

pub(super) fn probes(scene: &Scene, drafts: &[Draft]) -> Result<Vec<Probe>, BakeError> {
    scene
        .measures
        .iter()
        .enumerate()
        .map(|(k, measure)| {
            let path = format!("/measures/{k}");
            let body =
                drafts.iter().position(|draft| draft.parts.id == measure.body).ok_or_else(|| BakeError::Unknown {
                    path: format!("{path}/body"),
                    what: "body",
                    id: measure.body.clone(),
                    known: known(drafts.iter().map(|draft| draft.parts.id.as_str())),
                })?;
            let draft = &drafts[body];
            let kind = format!("{path}/kind");
            let group = |id: &str| supports::find(&draft.regions, id, &kind).cloned();
            let unit = |v: [f64; 3]| DVec3::from_array(v).normalize_or(DVec3::Y);
            let quantity = match &measure.kind {
                MeasureKind::MeanDisplacement(of) => Quantity::MeanDisplacement(group(&of.region)?),
                MeasureKind::Advance(of) => Quantity::Advance(group(&of.region)?, unit(of.along)),
                MeasureKind::TipDisplacement(of) => Quantity::TipDisplacement(group(&of.region)?),
                MeasureKind::HeightLoss(of) => {
                    let quantity = Quantity::HeightLoss(group(&of.region)?, group(&of.against)?, of.axis.index());
                    let apart = quantity.rest_distance(&draft.parts.rest);
                    if apart < LEAST_HEIGHT * draft.parts.reach {
                        return Err(BakeError::NoHeight { path: format!("{kind}/height_loss/axis"), apart });
                    }
                    quantity
                }
                MeasureKind::Twist(of) => Quantity::Twist(group(&of.region)?, group(&of.against)?, unit(of.axis)),
                MeasureKind::Shear(of) => Quantity::Shear(group(&of.region)?, group(&of.against)?),
                MeasureKind::ReactionForce(of) => {
                    let group = group(&of.region)?;
                    let held = held(draft, &group, &kind, &of.region)?;
                    Quantity::ReactionForce(group, held, unit(of.along))
                }
                MeasureKind::ReactionTorque(of) => {
                    let group = group(&of.region)?;
                    let held = held(draft, &group, &kind, &of.region)?;
                    Quantity::ReactionTorque(group, held, unit(of.along))
                }
                MeasureKind::ColliderForce(of) => {
                    let index = scene.colliders.iter().position(|collider| collider.id == of.collider);
                    Quantity::ColliderForce(index.ok_or_else(|| BakeError::Unknown {
                        path: format!("{kind}/collider_force/collider"),
                        what: "collider",
                        id: of.collider.clone(),
                        known: known(scene.colliders.iter().map(|collider| collider.id.as_str())),
                    })?)
                }
                MeasureKind::Size(of) => Quantity::Size(of.axis.index()),
                MeasureKind::LayerOffset => Quantity::LayerOffset,
                MeasureKind::Volume => {
                    let planar = draft.parts.layers.as_ref().is_some_and(|layers| layers.dimension == 2);
                    Quantity::Volume(if planar { "m²" } else { "m³" })
                }
                MeasureKind::InertiaRatio => Quantity::InertiaRatio,
                MeasureKind::ActivationWork => Quantity::ActivationWork,
                MeasureKind::Dissipated => Quantity::Dissipated,
                MeasureKind::PlasticStrain => Quantity::PlasticStrain,
                MeasureKind::Torn => Quantity::Torn,
                MeasureKind::Stress(of) => Quantity::Stress(group(&of.region)?, of.along.map(unit)),
                MeasureKind::Strain(of) => Quantity::Strain(group(&of.region)?, of.along.map(unit)),
                MeasureKind::Speed(of) => Quantity::Speed(group(&of.region)?),
                MeasureKind::PanelForce(of) => Quantity::PanelForce(panel(scene, &of.panel, &kind)?),
                MeasureKind::ContactForce(of) => {
                    let all = || (0..draft.parts.state.len() as u32).collect();
                    let group = of.region.as_deref().map_or_else(|| Ok(all()), group)?;
                    Quantity::ContactForce(group, unit(of.along))
                }
                MeasureKind::FibreTension(of) => {
                    let lines = draft.parts.fibres.iter().enumerate().filter(|(_, line)| line.id == of.fibre);
                    let lines: Vec<usize> = lines.map(|(index, _)| index).collect();
                    match of.of {
                        OverEdges::Greatest => Quantity::GreatestTension(lines),
                        OverEdges::Mean => Quantity::MeanTension(lines),
                    }
                }
            };
            let peak = measure.over_time == OverTime::Peak;
            Ok(Probe { name: measure.name.clone(), body, quantity, peak })
        })
        .collect()
}

/// The place of a panel among all of them.
fn panel(scene: &Scene, id: &str, kind: &str) -> Result<usize, BakeError> {
    scene.panels.iter().position(|panel| panel.id == id).ok_or_else(|| BakeError::Unknown {
        path: format!("{kind}/panel_force/panel"),
        what: "panel",
        id: id.to_owned(),
        known: known(scene.panels.iter().map(|panel| panel.id.as_str())),
    })
}

/// 1 along the axes in which each particle of the group is held, 0 along the others.
fn held(draft: &Draft, group: &Group, path: &str, region: &str) -> Result<Vec<DVec3>, BakeError> {
    let mut locked = vec![BVec3::FALSE; draft.parts.state.len()];
    for constraint in &draft.parts.constraints {
        for &i in &constraint.particles {
            locked[i as usize] |= constraint.locked;
        }
    }
    if group.iter().all(|&i| !locked[i as usize].any()) {
        return Err(BakeError::NotHeld { path: path.to_owned(), region: region.to_owned() });
    }
    Ok(group.iter().map(|&i| DVec3::select(locked[i as usize], DVec3::ONE, DVec3::ZERO)).collect())
}
