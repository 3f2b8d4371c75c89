//! Changes of the document.

use crate::scene::{Fibre, IntegratorKind, Material, Panel, Pin, Region, Room, Scene, Time, TwoLayer};

/// One change. Bodies and fibres are named by their identifiers, so that a change means the same wherever it is replayed.
#[derive(Clone, Debug, PartialEq)]
pub enum Command {
    /// Adds a fibre to a body.
    AddFibre {
        /// Identifier of the body.
        body: String,
        /// The fibre; its identifier must be new.
        fibre: Fibre,
    },
    /// Puts a fibre in the place of the one with the same identifier.
    SetFibre {
        /// Identifier of the body.
        body: String,
        /// The fibre as it is to be.
        fibre: Fibre,
    },
    /// Takes a fibre away.
    RemoveFibre {
        /// Identifier of the body.
        body: String,
        /// Identifier of the fibre.
        fibre: String,
    },
    /// Gives a body another material.
    SetMaterial {
        /// Identifier of the body.
        body: String,
        /// The material.
        material: Material,
    },
    /// Steps a body of either kind by another integrator.
    SetIntegrator {
        /// Identifier of the body.
        body: String,
        /// The integrator.
        integrator: IntegratorKind,
    },
    /// Changes where a body of either kind is held, and the regions that its pins name.
    SetPins {
        /// Identifier of the body.
        body: String,
        /// Its regions.
        regions: Vec<Region>,
        /// Its pins.
        pins: Vec<Pin>,
    },
    /// Puts a two-layer body in the place of the one with the same identifier.
    SetTwoLayer(Box<TwoLayer>),
    /// Changes frame rate, length and time step.
    SetTime(Time),
    /// Changes gravity [m/s²].
    SetGravity([f64; 3]),
    /// Changes floor, walls and ceiling.
    SetRoom(Room),
    /// Changes the panels.
    SetPanels(Vec<Panel>),
}

impl Command {
    /// What undo and redo call it.
    pub fn name(&self) -> String {
        match self {
            Self::AddFibre { fibre, .. } => format!("Add {}", title(fibre)),
            Self::SetFibre { fibre, .. } => format!("Change {}", title(fibre)),
            Self::RemoveFibre { .. } => "Delete fibre".to_owned(),
            Self::SetMaterial { .. } => "Change material".to_owned(),
            Self::SetIntegrator { .. } => "Change integrator".to_owned(),
            Self::SetPins { .. } => "Change pins".to_owned(),
            Self::SetTwoLayer(body) => format!("Change {}", if body.name.is_empty() { &body.id } else { &body.name }),
            Self::SetTime(_) => "Change time step".to_owned(),
            Self::SetGravity(_) => "Change gravity".to_owned(),
            Self::SetRoom(_) => "Change room".to_owned(),
            Self::SetPanels(_) => "Change panels".to_owned(),
        }
    }

    /// Changes `scene`; what is missing is said, and nothing is changed then.
    pub(super) fn apply(&self, scene: &mut Scene) -> Result<(), String> {
        match self {
            Self::AddFibre { body, fibre } => {
                let fibres = &mut body_of(scene, body)?.fibres;
                if fibres.iter().any(|old| old.id == fibre.id) {
                    return Err(format!("there is a fibre \"{}\" already", fibre.id));
                }
                fibres.push(fibre.clone());
            }
            Self::SetFibre { body, fibre } => {
                let fibres = &mut body_of(scene, body)?.fibres;
                let old = fibres.iter_mut().find(|old| old.id == fibre.id);
                *old.ok_or_else(|| format!("there is no fibre \"{}\"", fibre.id))? = fibre.clone();
            }
            Self::RemoveFibre { body, fibre } => {
                let fibres = &mut body_of(scene, body)?.fibres;
                let index = fibres.iter().position(|old| old.id == *fibre);
                fibres.remove(index.ok_or_else(|| format!("there is no fibre \"{fibre}\""))?);
            }
            Self::SetMaterial { body, material } => body_of(scene, body)?.material = material.clone(),
            Self::SetIntegrator { body, integrator } => match scene.two_layer.iter_mut().find(|old| old.id == *body) {
                Some(body) => body.integrator = *integrator,
                None => body_of(scene, body)?.integrator = *integrator,
            },
            Self::SetPins { body, regions, pins } => {
                let two_layer = scene.two_layer.iter_mut().find(|old| old.id == *body);
                let (old_regions, old_pins) = if let Some(body) = two_layer {
                    (&mut body.regions, &mut body.pins)
                } else {
                    let body = body_of(scene, body)?;
                    (&mut body.regions, &mut body.pins)
                };
                old_regions.clone_from(regions);
                old_pins.clone_from(pins);
            }
            Self::SetTwoLayer(body) => {
                let old = scene.two_layer.iter_mut().find(|old| old.id == body.id);
                *old.ok_or_else(|| format!("there is no two-layer body \"{}\"", body.id))? = (**body).clone();
            }
            Self::SetTime(time) => scene.time = time.clone(),
            Self::SetGravity(gravity) => scene.gravity = *gravity,
            Self::SetRoom(room) => scene.room = room.clone(),
            Self::SetPanels(panels) => scene.panels.clone_from(panels),
        }
        Ok(())
    }
}

fn title(fibre: &Fibre) -> &str {
    if fibre.name.is_empty() { &fibre.id } else { &fibre.name }
}

fn body_of<'a>(scene: &'a mut Scene, id: &str) -> Result<&'a mut crate::scene::Body, String> {
    scene.bodies.iter_mut().find(|body| body.id == id).ok_or_else(|| format!("there is no body \"{id}\""))
}
