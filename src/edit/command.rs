//! Changes of the document.

use crate::scene::{
    Collider, Dab, Drivable, Drive, Element, Fibre, Follow, IntegratorChoice, Material, OwnedBody, Panel, Pin,
    Placement, Region, RegionMaterial, Room, SharedDrive, Sheet, Time, TwoLayer, Void, Wind,
};

/// One change. Bodies and fibres are named by their identifiers, so that a change means the same wherever it is
/// replayed.
#[derive(Clone, Debug, PartialEq)]
pub enum Command {
    /// Makes several changes as one, in this order: all of them or none.
    Many {
        /// What undo and redo call them.
        name: String,
        /// The changes.
        commands: Vec<Command>,
    },
    /// Adds a body of either kind; its identifier must be new among bodies of both.
    AddBody(OwnedBody),
    /// Puts a body in the place of the one of its kind with the same identifier, called by what was done, such as
    /// "Scale".
    SetBody {
        /// What undo and redo call it, before the body's name.
        verb: String,
        /// The body as it is to be.
        body: OwnedBody,
    },
    /// Takes a body of either kind away, with the measures that read it.
    RemoveBody {
        /// Its identifier.
        body: String,
    },
    /// Puts a body of either kind somewhere else at the start.
    SetPlacement {
        /// Identifier of the body.
        body: String,
        /// Where it stands.
        placement: Placement,
    },
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
    /// Adds a sheet to a body.
    AddSheet {
        /// Identifier of the body.
        body: String,
        /// The sheet; its identifier must be new.
        sheet: Sheet,
    },
    /// Puts a sheet in the place of the one with the same identifier, called by what was done, such as "Move".
    SetSheet {
        /// What undo and redo call it, before the sheet's name.
        verb: String,
        /// Identifier of the body.
        body: String,
        /// The sheet as it is to be.
        sheet: Sheet,
    },
    /// Takes a sheet away.
    RemoveSheet {
        /// Identifier of the body.
        body: String,
        /// Identifier of the sheet.
        sheet: String,
    },
    /// Gives a body, a fibre or a sheet another name.
    SetName {
        /// What is renamed.
        item: Item,
        /// The name.
        name: String,
    },
    /// Hides bodies, fibres and sheets from view or shows them again. They move all the same.
    SetHidden {
        /// What is hidden or shown.
        items: Vec<Item>,
        /// Whether it is hidden.
        hidden: bool,
    },
    /// Draws bodies, fibres and sheets in a colour, red, green and blue, or in that of the theme again.
    SetColor {
        /// What is coloured.
        items: Vec<Item>,
        /// The colour.
        color: Option<[u8; 3]>,
    },
    /// Changes what is painted of a body's volume fraction: all of it, so that one gesture is one step.
    SetPaint {
        /// Identifier of the body.
        body: String,
        /// The dabs in the order in which they act; none clears it.
        paint: Vec<Dab>,
    },
    /// Changes what is taken out of a body.
    SetVoids {
        /// Identifier of the body.
        body: String,
        /// Its voids.
        voids: Vec<Void>,
    },
    /// Changes the elements of a body.
    SetElements {
        /// Identifier of the body.
        body: String,
        /// Its elements.
        elements: Vec<Element>,
    },
    /// Changes which regions of a body have a matrix of their own.
    SetRegionMaterials {
        /// Identifier of the body.
        body: String,
        /// Their materials.
        materials: Vec<RegionMaterial>,
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
        integrator: IntegratorChoice,
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
    /// Changes which motions a body of either kind follows.
    SetFollows {
        /// Identifier of the body.
        body: String,
        /// The motions.
        follows: Vec<Follow>,
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
    /// Changes the colliders.
    SetColliders(Vec<Collider>),
    /// Changes the air or water that the bodies move in, or takes it away.
    SetWind(Option<Wind>),
    /// Has something follow a drive, or takes its drive away ([`Drivable::set`]).
    SetDrive {
        /// What follows it.
        of: Drivable,
        /// The drive.
        drive: Option<Drive>,
    },
}

/// Something that a person sees in the list of the document's parts.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Item {
    /// A body of either kind, by its identifier.
    Body(String),
    /// A fibre.
    Fibre {
        /// Identifier of its body.
        body: String,
        /// Its own.
        fibre: String,
    },
    /// A sheet.
    Sheet {
        /// Identifier of its body.
        body: String,
        /// Its own.
        sheet: String,
    },
}

impl Command {
    /// Puts fibres of a body in the places of those with the same identifiers: one step, called by what was done to
    /// them, such as "Move".
    pub fn set_fibres(verb: &str, body: &str, fibres: Vec<Fibre>) -> Self {
        let name = name_of(verb, &fibres);
        let set = |fibre| Self::SetFibre { body: body.to_owned(), fibre };
        Self::Many { name, commands: fibres.into_iter().map(set).collect() }
    }

    /// Adds fibres to a body in one step, called by what was done, such as "Duplicate". Their identifiers must be new.
    pub fn add_fibres(verb: &str, body: &str, fibres: Vec<Fibre>) -> Self {
        let name = name_of(verb, &fibres);
        let add = |fibre| Self::AddFibre { body: body.to_owned(), fibre };
        Self::Many { name, commands: fibres.into_iter().map(add).collect() }
    }

    /// The changes that add drives which parts of a body share, and fibres that may follow them.
    pub fn additions(body: &str, drives: Vec<SharedDrive>, fibres: Vec<Fibre>) -> Vec<Self> {
        let of = |drive: String| Drivable::Shared { body: body.to_owned(), drive };
        let drives = drives.into_iter().map(|one| Self::SetDrive { of: of(one.id), drive: Some(one.drive) });
        let fibres = fibres.into_iter().map(|fibre| Self::AddFibre { body: body.to_owned(), fibre });
        drives.chain(fibres).collect()
    }

    /// Takes fibres of a body away in one step.
    pub fn remove_fibres<'a>(body: &str, fibres: impl IntoIterator<Item = &'a str>) -> Self {
        let remove = |fibre: &str| Self::RemoveFibre { body: body.to_owned(), fibre: fibre.to_owned() };
        let commands: Vec<Self> = fibres.into_iter().map(remove).collect();
        Self::Many { name: format!("Delete {}", counted(commands.len(), "fibre", "fibres")), commands }
    }

    /// What undo and redo call it.
    pub fn name(&self) -> String {
        match self {
            Self::Many { name, .. } => name.clone(),
            Self::AddBody(body) => format!("Add {}", body.view().title()),
            Self::SetBody { verb, body } => format!("{verb} {}", body.view().title()),
            Self::RemoveBody { .. } => "Delete body".to_owned(),
            Self::SetPlacement { .. } => "Place body".to_owned(),
            Self::AddFibre { fibre, .. } => format!("Add {}", fibre.title()),
            Self::SetFibre { fibre, .. } => format!("Change {}", fibre.title()),
            Self::RemoveFibre { .. } => "Delete fibre".to_owned(),
            Self::AddSheet { sheet, .. } => format!("Add {}", sheet.title()),
            Self::SetSheet { verb, sheet, .. } => format!("{verb} {}", sheet.title()),
            Self::RemoveSheet { .. } => "Delete sheet".to_owned(),
            Self::SetName { item, .. } => format!("Rename {}", several(std::slice::from_ref(item))),
            Self::SetHidden { items, hidden: true } => format!("Hide {}", several(items)),
            Self::SetHidden { items, hidden: false } => format!("Show {}", several(items)),
            Self::SetColor { items, .. } => format!("Colour {}", several(items)),
            Self::SetPaint { paint, .. } if paint.is_empty() => "Clear painted fraction".to_owned(),
            Self::SetPaint { .. } => "Paint volume fraction".to_owned(),
            Self::SetVoids { .. } => "Change voids".to_owned(),
            Self::SetElements { .. } => "Change elements".to_owned(),
            Self::SetRegionMaterials { .. } => "Change materials of regions".to_owned(),
            Self::SetMaterial { .. } => "Change material".to_owned(),
            Self::SetIntegrator { .. } => "Change integrator".to_owned(),
            Self::SetPins { .. } => "Change pins".to_owned(),
            Self::SetFollows { .. } => "Change what is followed".to_owned(),
            Self::SetTwoLayer(body) => format!("Change {}", body.title()),
            Self::SetTime(_) => "Change time step".to_owned(),
            Self::SetGravity(_) => "Change gravity".to_owned(),
            Self::SetRoom(_) => "Change room".to_owned(),
            Self::SetPanels(_) => "Change panels".to_owned(),
            Self::SetColliders(_) => "Change colliders".to_owned(),
            Self::SetWind(_) => "Change wind".to_owned(),
            Self::SetDrive { drive: Some(_), .. } => "Change drive".to_owned(),
            Self::SetDrive { drive: None, .. } => "Remove drive".to_owned(),
        }
    }
}

fn name_of(verb: &str, fibres: &[Fibre]) -> String {
    match fibres {
        [fibre] => format!("{verb} {}", fibre.title()),
        _ => format!("{verb} {} fibres", fibres.len()),
    }
}

fn several(items: &[Item]) -> String {
    let count = |is: fn(&Item) -> bool| items.iter().filter(|item| is(item)).count();
    let kinds = [
        (count(|item| matches!(item, Item::Body(_))), "body", "bodies"),
        (count(|item| matches!(item, Item::Fibre { .. })), "fibre", "fibres"),
        (count(|item| matches!(item, Item::Sheet { .. })), "sheet", "sheets"),
    ];
    let said: Vec<String> =
        kinds.into_iter().filter(|kind| kind.0 > 0).map(|(count, one, many)| counted(count, one, many)).collect();
    said.join(" and ")
}

fn counted(count: usize, one: &str, many: &str) -> String {
    if count == 1 { one.to_owned() } else { format!("{count} {many}") }
}
