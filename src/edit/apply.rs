//! What each command does to a scene.

use super::{Command, Item};
use crate::scene::{AnyBodyMut, Body, Fibre, MeasureKind, OwnedBody, Scene, Sheet, TwoLayer};

impl Command {
    /// Changes `scene`. What is missing is said; the scene may be changed in part then and is not to be used.
    pub(super) fn apply(&self, scene: &mut Scene) -> Result<(), String> {
        match self {
            Self::Many { commands, .. } => commands.iter().try_for_each(|command| command.apply(scene))?,
            Self::AddBody(body) => {
                let id = body.view().id();
                if scene.find_body(id).is_some() {
                    return Err(format!("there is a body \"{id}\" already"));
                }
                match body {
                    OwnedBody::Solid(body) => scene.bodies.push((**body).clone()),
                    OwnedBody::TwoLayer(body) => scene.two_layer.push((**body).clone()),
                }
            }
            Self::SetBody { body: OwnedBody::Solid(body), .. } => *body_of(scene, &body.id)? = (**body).clone(),
            Self::RemoveBody { body } => {
                any_body_of(scene, body)?;
                scene.bodies.retain(|old| old.id != *body);
                scene.two_layer.retain(|old| old.id != *body);
                scene.measures.retain(|measure| measure.body != *body);
            }
            Self::SetPlacement { body, placement } => {
                any_body_of(scene, body)?.placement_mut().clone_from(placement);
            }
            Self::AddFibre { body, fibre } => {
                let fibres = &mut body_of(scene, body)?.fibres;
                if fibres.iter().any(|old| old.id == fibre.id) {
                    return Err(format!("there is a fibre \"{}\" already", fibre.id));
                }
                fibres.push(fibre.clone());
            }
            Self::SetFibre { body, fibre } => *fibre_of(scene, body, &fibre.id)? = fibre.clone(),
            Self::RemoveFibre { body, fibre } => {
                let fibres = &mut body_of(scene, body)?.fibres;
                let index = fibres.iter().position(|old| old.id == *fibre);
                fibres.remove(index.ok_or_else(|| format!("there is no fibre \"{fibre}\""))?);
                // What is gone cannot be measured any more.
                scene.measures.retain(|measure| match &measure.kind {
                    MeasureKind::FibreTension(of) => measure.body != *body || of.fibre != *fibre,
                    _ => true,
                });
            }
            Self::AddSheet { body, sheet } => {
                let sheets = &mut body_of(scene, body)?.sheets;
                if sheets.iter().any(|old| old.id == sheet.id) {
                    return Err(format!("there is a sheet \"{}\" already", sheet.id));
                }
                sheets.push(sheet.clone());
            }
            Self::SetSheet { body, sheet, .. } => *sheet_of(scene, body, &sheet.id)? = sheet.clone(),
            Self::RemoveSheet { body, sheet } => {
                sheet_of(scene, body, sheet)?;
                body_of(scene, body)?.sheets.retain(|old| old.id != *sheet);
            }
            Self::SetName { item, name } => item_fields(scene, item)?.name.clone_from(name),
            Self::SetHidden { items, hidden } => {
                for item in items {
                    *item_fields(scene, item)?.hidden = *hidden;
                }
            }
            Self::SetColor { items, color } => {
                for item in items {
                    *item_fields(scene, item)?.color = *color;
                }
            }
            Self::SetPaint { body, paint } => body_of(scene, body)?.paint.clone_from(paint),
            Self::SetElements { body, elements } => body_of(scene, body)?.elements.clone_from(elements),
            Self::SetVoids { body, voids } => body_of(scene, body)?.voids.clone_from(voids),
            Self::SetRegionMaterials { body, materials } => {
                body_of(scene, body)?.region_materials.clone_from(materials);
            }
            Self::SetMaterial { body, material } => body_of(scene, body)?.material = material.clone(),
            Self::SetIntegrator { body, integrator } => *any_body_of(scene, body)?.integrator_mut() = *integrator,
            Self::SetPins { body, regions, pins } => {
                let mut body = any_body_of(scene, body)?;
                body.regions_mut().clone_from(regions);
                body.pins_mut().clone_from(pins);
            }
            Self::SetFollows { body, follows } => any_body_of(scene, body)?.follows_mut().clone_from(follows),
            Self::SetBody { body: OwnedBody::TwoLayer(body), .. } | Self::SetTwoLayer(body) => {
                *two_layer_of(scene, &body.id)? = (**body).clone();
            }
            Self::SetTime(time) => scene.time = time.clone(),
            Self::SetGravity(gravity) => scene.gravity = *gravity,
            Self::SetWind(wind) => scene.wind.clone_from(wind),
            Self::SetDrive { of, drive } => of.set(scene, drive.clone())?,
            Self::SetRoom(room) => scene.room = room.clone(),
            Self::SetPanels(panels) => {
                scene.panels.clone_from(panels);
                scene.measures.retain(|measure| match &measure.kind {
                    MeasureKind::PanelForce(on) => panels.iter().any(|panel| panel.id == on.panel),
                    _ => true,
                });
            }
            Self::SetColliders(colliders) => {
                scene.colliders.clone_from(colliders);
                scene.measures.retain(|measure| match &measure.kind {
                    MeasureKind::ColliderForce(on) => colliders.iter().any(|collider| collider.id == on.collider),
                    _ => true,
                });
            }
        }
        Ok(())
    }
}

/// What bodies of either kind, fibres and sheets have in common.
struct ItemFields<'a> {
    name: &'a mut String,
    hidden: &'a mut bool,
    color: &'a mut Option<[u8; 3]>,
}

fn item_fields<'a>(scene: &'a mut Scene, item: &Item) -> Result<ItemFields<'a>, String> {
    match item {
        Item::Fibre { body, fibre } => {
            let Fibre { name, hidden, color, .. } = fibre_of(scene, body, fibre)?;
            Ok(ItemFields { name, hidden, color })
        }
        Item::Sheet { body, sheet } => {
            let Sheet { name, hidden, color, .. } = sheet_of(scene, body, sheet)?;
            Ok(ItemFields { name, hidden, color })
        }
        Item::Body(id) => match any_body_of(scene, id)? {
            AnyBodyMut::Solid(Body { name, hidden, color, .. })
            | AnyBodyMut::TwoLayer(TwoLayer { name, hidden, color, .. }) => Ok(ItemFields { name, hidden, color }),
        },
    }
}

fn any_body_of<'a>(scene: &'a mut Scene, id: &str) -> Result<AnyBodyMut<'a>, String> {
    scene.find_body_mut(id).ok_or_else(|| no_body(id))
}

fn body_of<'a>(scene: &'a mut Scene, id: &str) -> Result<&'a mut Body, String> {
    scene.bodies.iter_mut().find(|body| body.id == id).ok_or_else(|| no_body(id))
}

fn two_layer_of<'a>(scene: &'a mut Scene, id: &str) -> Result<&'a mut TwoLayer, String> {
    let body = scene.two_layer.iter_mut().find(|body| body.id == id);
    body.ok_or_else(|| format!("there is no two-layer body \"{id}\""))
}

fn sheet_of<'a>(scene: &'a mut Scene, body: &str, id: &str) -> Result<&'a mut Sheet, String> {
    let sheets = &mut body_of(scene, body)?.sheets;
    sheets.iter_mut().find(|sheet| sheet.id == id).ok_or_else(|| format!("there is no sheet \"{id}\""))
}

fn fibre_of<'a>(scene: &'a mut Scene, body: &str, id: &str) -> Result<&'a mut Fibre, String> {
    let fibres = &mut body_of(scene, body)?.fibres;
    fibres.iter_mut().find(|fibre| fibre.id == id).ok_or_else(|| format!("there is no fibre \"{id}\""))
}

fn no_body(id: &str) -> String {
    format!("there is no body \"{id}\"")
}
