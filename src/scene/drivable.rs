//! What a drive can move in a scene: one list of it, and one way to look at a drive and to put another there.

use super::{
    Activation, AnyBody, AnyBodyMut, Drive, DrivenMotion, Element, ElementActivation, Motion, PanelDrive, PanelMotion,
    Scene, SharedDrive, SheetActivation,
};

/// Something that a drive moves or could move, by identifiers.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Drivable {
    /// The scene's gravity.
    Gravity,
    /// The scene's wind.
    Wind,
    /// The height of a panel.
    Panel(String),
    /// The motion of a collider.
    Collider(String),
    /// A drive that several parts of a body follow.
    Shared {
        /// Identifier of the body.
        body: String,
        /// Of the drive.
        drive: String,
    },
    /// What a fibre does by itself.
    Fibre {
        /// Identifier of the body.
        body: String,
        /// Of the fibre.
        fibre: String,
    },
    /// What a sheet does by itself.
    Sheet {
        /// Identifier of the body.
        body: String,
        /// Of the sheet.
        sheet: String,
    },
    /// What an element does by itself.
    Element {
        /// Identifier of the body.
        body: String,
        /// Of the element.
        element: String,
    },
    /// The motion of a pinned region.
    Pin {
        /// Identifier of the body.
        body: String,
        /// Of the pin.
        pin: String,
    },
    /// The gas of a two-layer body.
    Pressure(String),
    /// Active springs of a two-layer body.
    Springs {
        /// Identifier of the body.
        body: String,
        /// Of the springs.
        springs: String,
    },
}

/// How far a panel, a pin or a collider goes where the drive that it is given is 1, before a person says how far [m].
const USUAL_TRAVEL: f64 = 0.01;

impl Scene {
    /// Everything in the scene that a drive moves or could move: gravity, wind and panels first, then body by body.
    pub fn drivables(&self) -> Vec<Drivable> {
        let mut all = vec![Drivable::Gravity];
        all.extend(self.wind.iter().map(|_| Drivable::Wind));
        all.extend(self.panels.iter().map(|panel| Drivable::Panel(panel.id.clone())));
        all.extend(self.colliders.iter().map(|collider| Drivable::Collider(collider.id.clone())));
        for of in self.all_bodies() {
            let body = || of.id().to_owned();
            all.extend(of.drives().iter().map(|one| Drivable::Shared { body: body(), drive: one.id.clone() }));
            all.extend(of.fibres().iter().map(|fibre| Drivable::Fibre { body: body(), fibre: fibre.id.clone() }));
            all.extend(of.sheets().iter().map(|sheet| Drivable::Sheet { body: body(), sheet: sheet.id.clone() }));
            let elements = of.solid().map_or(&[][..], |body| &body.elements);
            all.extend(elements.iter().map(|one| Drivable::Element { body: body(), element: one.id.clone() }));
            all.extend(of.pins().iter().map(|pin| Drivable::Pin { body: body(), pin: pin.id.clone() }));
            all.extend(of.two_layer().map(|_| Drivable::Pressure(body())));
            let active = of.two_layer().map_or(&[][..], |of| &of.active_springs);
            all.extend(active.iter().map(|one| Drivable::Springs { body: body(), springs: one.id.clone() }));
        }
        all
    }
}

impl Drivable {
    /// Identifier of the body that it belongs to; none of what is the scene's.
    pub fn body(&self) -> Option<&str> {
        match self {
            Self::Gravity | Self::Wind | Self::Panel(_) | Self::Collider(_) => None,
            Self::Shared { body, .. }
            | Self::Fibre { body, .. }
            | Self::Sheet { body, .. }
            | Self::Element { body, .. }
            | Self::Pin { body, .. }
            | Self::Springs { body, .. }
            | Self::Pressure(body) => Some(body),
        }
    }

    /// The drive that it has; none where it has none, or is not there.
    pub fn drive<'a>(&self, scene: &'a Scene) -> Option<&'a Drive> {
        let body = || scene.find_body(self.body()?);
        match self {
            Self::Gravity => scene.gravity_drive.as_ref(),
            Self::Wind => scene.wind.as_ref()?.drive.as_ref(),
            Self::Panel(id) => match &scene.panels.iter().find(|panel| panel.id == *id)?.motion {
                PanelMotion::Follows(of) => Some(&of.drive),
                _ => None,
            },
            Self::Collider(id) => scene.colliders.iter().find(|collider| collider.id == *id)?.drive(),
            Self::Shared { drive, .. } => Some(&body()?.drives().iter().find(|one| one.id == *drive)?.drive),
            Self::Fibre { fibre, .. } => {
                let fibre = body()?.fibres().iter().find(|one| one.id == *fibre)?;
                fibre.activation.as_ref().map(|of| &of.drive)
            }
            Self::Sheet { sheet, .. } => {
                let sheet = body()?.sheets().iter().find(|one| one.id == *sheet)?;
                sheet.activation.as_ref().map(|of| &of.drive)
            }
            Self::Element { .. } => self.element(scene)?.activation.as_ref().map(|of| &of.drive),
            Self::Pin { pin, .. } => driven(&body()?.pins().iter().find(|one| one.id == *pin)?.motion),
            Self::Pressure(_) => body()?.two_layer()?.pressure_drive.as_ref(),
            Self::Springs { springs, .. } => {
                Some(&body()?.two_layer()?.active_springs.iter().find(|one| one.id == *springs)?.drive)
            }
        }
    }

    /// The course of its own that a panel, a pin or a collider follows (heights, offsets, a ramp, a turn), as the drive
    /// that [`Drivable::set`] makes the same motion of; none where it has none, or none that a drive can make.
    pub fn course(&self, scene: &Scene) -> Option<Drive> {
        let of_motion = |motion: &Motion| motion.as_driven().map(|of| of.drive);
        match self {
            Self::Panel(id) => {
                let panel = scene.panels.iter().find(|panel| panel.id == *id)?;
                panel.heights_as_drive().map(|of| of.drive)
            }
            Self::Collider(id) => of_motion(&scene.colliders.iter().find(|collider| collider.id == *id)?.motion),
            Self::Pin { body, pin } => {
                of_motion(&scene.find_body(body)?.pins().iter().find(|one| one.id == *pin)?.motion)
            }
            _ => None,
        }
    }

    /// The drives that it may name as shared ones.
    pub fn shared<'a>(&self, scene: &'a Scene) -> &'a [SharedDrive] {
        self.body().and_then(|body| scene.find_body(body)).map_or(&[], AnyBody::drives)
    }

    /// The drive that is meant: its own, or the shared one that it names.
    pub fn resolved<'a>(&self, scene: &'a Scene) -> Option<&'a Drive> {
        self.drive(scene)?.resolved(self.shared(scene))
    }

    /// Where its drive is written: itself, or the shared one that it follows.
    #[must_use]
    pub fn source(&self, scene: &Scene) -> Self {
        match (self.drive(scene), self.body()) {
            (Some(Drive::Shared(id)), Some(body)) => Self::Shared { body: body.to_owned(), drive: id.clone() },
            _ => self.clone(),
        }
    }

    /// The element that it is of, if it is one's.
    pub(super) fn element<'a>(&self, scene: &'a Scene) -> Option<&'a Element> {
        let Self::Element { body, element } = self else { return None };
        scene.body(body)?.elements.iter().find(|one| one.id == *element)
    }

    /// What follows it, of a shared drive.
    pub fn followers(&self, scene: &Scene) -> Vec<Self> {
        let Self::Shared { body, drive } = self else { return Vec::new() };
        let follows = |other: &Self| {
            let names = matches!(other.drive(scene), Some(Drive::Shared(id)) if id == drive);
            other.body() == Some(body) && names
        };
        scene.drivables().into_iter().filter(follows).collect()
    }

    /// Puts a drive there, or takes the present one away: a fibre or springs only resist then, what was moved stays
    /// where it starts and a panel falls. What is new to a drive gets a way to go by it, a pin, a panel or a collider
    /// as far as the course of its own went, or 10 mm upwards; a shared drive that is not there is added.
    ///
    /// # Errors
    /// What is not there, said in a sentence. Whether the scene can be used with the drive is for
    /// [`validate`](Scene::validate) to say.
    pub fn set(&self, scene: &mut Scene, drive: Option<Drive>) -> Result<(), String> {
        let missing = || format!("{} is not there", self.words());
        let found = match self {
            Self::Gravity => {
                scene.gravity_drive = drive;
                Some(())
            }
            Self::Wind => scene.wind.as_mut().map(|wind| wind.drive = drive),
            Self::Panel(id) => scene.panels.iter_mut().find(|panel| panel.id == *id).map(|panel| {
                panel.motion = match (drive, &panel.motion) {
                    (None, PanelMotion::Follows(_)) => PanelMotion::Falls,
                    (None, motion) => motion.clone(),
                    (Some(drive), PanelMotion::Follows(of)) => PanelMotion::Follows(PanelDrive { drive, ..of.clone() }),
                    (Some(drive), _) => {
                        let travel = panel.heights_as_drive().map_or(USUAL_TRAVEL, |heights| heights.travel);
                        PanelMotion::Follows(PanelDrive::new(drive, travel))
                    }
                };
            }),
            Self::Collider(id) => {
                let collider = scene.colliders.iter_mut().find(|collider| collider.id == *id);
                collider.map(|collider| set_motion(&mut collider.motion, drive))
            }
            Self::Shared { body, .. }
            | Self::Fibre { body, .. }
            | Self::Sheet { body, .. }
            | Self::Element { body, .. }
            | Self::Pin { body, .. }
            | Self::Springs { body, .. }
            | Self::Pressure(body) => scene.find_body_mut(body).and_then(|body| self.set_of_body(body, drive)),
        };
        found.ok_or_else(missing)
    }

    fn set_of_body(&self, mut of: AnyBodyMut<'_>, drive: Option<Drive>) -> Option<()> {
        match (self, drive) {
            (Self::Shared { drive: id, .. }, None) => {
                let drives = of.drives_mut();
                let index = drives.iter().position(|one| one.id == *id)?;
                drives.remove(index);
            }
            (Self::Shared { drive: id, .. }, Some(drive)) => {
                let drives = of.drives_mut();
                match drives.iter_mut().find(|one| one.id == *id) {
                    Some(one) => one.drive = drive,
                    None => drives.push(SharedDrive::new(id.clone(), drive)),
                }
            }
            (Self::Fibre { fibre, .. }, drive) => {
                let AnyBodyMut::Solid(body) = of else { return None };
                let fibre = body.fibres.iter_mut().find(|one| one.id == *fibre)?;
                fibre.activation = match (drive, &fibre.activation) {
                    (None, _) => None,
                    (Some(drive), Some(of)) => Some(Activation { drive, ..of.clone() }),
                    (Some(drive), None) => Some(Activation::contracting(0.0, drive)),
                };
            }
            (Self::Sheet { sheet, .. }, drive) => {
                let AnyBodyMut::Solid(body) = of else { return None };
                let sheet = body.sheets.iter_mut().find(|one| one.id == *sheet)?;
                sheet.activation = drive.map(|drive| match &sheet.activation {
                    Some(of) => SheetActivation { drive, ..of.clone() },
                    None => SheetActivation::contracting([0.0; 2], drive),
                });
            }
            (Self::Element { element, .. }, drive) => {
                let AnyBodyMut::Solid(body) = of else { return None };
                let element = body.elements.iter_mut().find(|one| one.id == *element)?;
                element.activation = drive.map(|drive| match &element.activation {
                    Some(of) => ElementActivation { drive, ..of.clone() },
                    None => ElementActivation::contracting(0.0, drive),
                });
            }
            (Self::Pin { pin, .. }, drive) => {
                set_motion(&mut of.pins_mut().iter_mut().find(|one| one.id == *pin)?.motion, drive);
            }
            (Self::Pressure(_), drive) => {
                let AnyBodyMut::TwoLayer(body) = of else { return None };
                body.pressure_drive = drive;
            }
            (Self::Springs { springs, .. }, drive) => {
                let AnyBodyMut::TwoLayer(body) = of else { return None };
                let index = body.active_springs.iter().position(|one| one.id == *springs)?;
                match drive {
                    Some(drive) => body.active_springs[index].drive = drive,
                    // They only resist then.
                    None => drop(body.active_springs.remove(index)),
                }
            }
            _ => return None,
        }
        Some(())
    }

    /// What it is, by identifiers.
    fn words(&self) -> String {
        match self {
            Self::Gravity => "gravity".to_owned(),
            Self::Wind => "a wind".to_owned(),
            Self::Panel(id) => format!("a panel \"{id}\""),
            Self::Collider(id) => format!("a collider \"{id}\""),
            Self::Shared { body, drive } => format!("a drive \"{drive}\" of \"{body}\""),
            Self::Fibre { body, fibre } => format!("a fibre \"{fibre}\" of \"{body}\""),
            Self::Sheet { body, sheet } => format!("a sheet \"{sheet}\" of \"{body}\""),
            Self::Element { body, element } => format!("an element \"{element}\" of \"{body}\""),
            Self::Pin { body, pin } => format!("a pin \"{pin}\" of \"{body}\""),
            Self::Pressure(body) => format!("gas in \"{body}\""),
            Self::Springs { body, springs } => format!("active springs \"{springs}\" of \"{body}\""),
        }
    }
}

fn driven(motion: &Motion) -> Option<&Drive> {
    match motion {
        Motion::Driven(of) => Some(&of.drive),
        _ => None,
    }
}

fn set_motion(motion: &mut Motion, drive: Option<Drive>) {
    *motion = match (drive, &*motion) {
        (None, Motion::Driven(_)) => Motion::Fixed,
        (None, motion) => motion.clone(),
        (Some(drive), Motion::Driven(of)) => DrivenMotion { drive, ..of.clone() }.into(),
        (Some(drive), motion) => match motion.as_driven() {
            Some(of) => DrivenMotion { drive, ..of }.into(),
            None => DrivenMotion::new(drive, [0.0, USUAL_TRAVEL, 0.0]).into(),
        },
    };
}
