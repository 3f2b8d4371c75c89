//! Fibre solids: a shape of a material with fibres in it.

use super::extra::is_false;
use super::{
    BoxShape, Dab, Element, Extra, Fibre, Follow, Impulse, Initial, IntegratorChoice, Material, MeshShape, Pin,
    Placement, Region, RegionMaterial, Shape, SharedDrive, Sheet, Void, add_dab,
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// One soft body.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Body {
    /// Stable identifier, unique among the bodies.
    pub id: String,
    /// Name a person reads.
    #[serde(default)]
    pub name: String,
    /// Whether it is left out of what is seen; it moves all the same.
    #[serde(default, skip_serializing_if = "is_false")]
    pub hidden: bool,
    /// Colour in which it is drawn, red, green and blue from 0 to 255; the theme's unless given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub color: Option<[u8; 3]>,
    /// What kind of body it is.
    #[serde(default)]
    pub kind: BodyKind,
    /// Rest shape, in the model frame.
    pub shape: Shape,
    /// Where the model frame stands in the world.
    #[serde(default)]
    pub placement: Placement,
    /// What it is made of.
    pub material: Material,
    /// Whether its parts push each other away where they come to meet; they pass through each other unless it is set.
    #[serde(default, skip_serializing_if = "is_false")]
    pub self_contact: bool,
    /// How it is stepped through time.
    #[serde(default)]
    pub integrator: IntegratorChoice,
    /// Motion and deformation at the start.
    #[serde(default)]
    pub initial: Initial,
    /// Impulses given to regions at the start.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub impulses: Vec<Impulse>,
    /// Numbers that change in time, for several of its parts to follow.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub drives: Vec<SharedDrive>,
    /// Embedded fibres.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub fibres: Vec<Fibre>,
    /// Embedded sheets.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub sheets: Vec<Sheet>,
    /// Embedded elements.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub elements: Vec<Element>,
    /// Volume fraction of fibre painted by hand over what the fibres give, one dab after the other.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub paint: Vec<Dab>,
    /// What is taken out of it.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub voids: Vec<Void>,
    /// Named sets of particles.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub regions: Vec<Region>,
    /// Regions with a matrix of their own.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub region_materials: Vec<RegionMaterial>,
    /// Regions whose motion is prescribed.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub pins: Vec<Pin>,
    /// Motions made elsewhere that its particles follow.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub follows: Vec<Follow>,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

impl Body {
    /// A body of this shape and of [`Material::default`], with its model frame in the world's.
    pub fn new(id: impl Into<String>, shape: impl Into<Shape>) -> Self {
        Self {
            id: id.into(),
            name: String::new(),
            hidden: false,
            color: None,
            kind: BodyKind::default(),
            shape: shape.into(),
            placement: Placement::default(),
            material: Material::default(),
            self_contact: false,
            integrator: IntegratorChoice::default(),
            initial: Initial::default(),
            impulses: Vec::new(),
            drives: Vec::new(),
            fibres: Vec::new(),
            sheets: Vec::new(),
            elements: Vec::new(),
            paint: Vec::new(),
            voids: Vec::new(),
            regions: Vec::new(),
            region_materials: Vec::new(),
            pins: Vec::new(),
            follows: Vec::new(),
            extra: Extra::new(),
        }
    }

    /// A box of these full extents [m], centred on the model's origin.
    pub fn cuboid(id: impl Into<String>, size: impl Into<[f64; 3]>) -> Self {
        Self::new(id, BoxShape::new(size))
    }

    /// What a closed mesh encloses: `mesh` is a file relative to the scene file, the name of a mesh in memory
    /// ([`Assets::insert_mesh`](super::Assets::insert_mesh)), or either with more said of it ([`MeshShape`]).
    pub fn from_mesh(id: impl Into<String>, mesh: impl Into<MeshShape>) -> Self {
        Self::new(id, mesh.into())
    }

    /// Made of another material.
    #[must_use]
    pub fn with_material(self, material: Material) -> Self {
        Self { material, ..self }
    }

    /// With one drive more for its parts to share.
    #[must_use]
    pub fn with_drive(mut self, drive: SharedDrive) -> Self {
        self.drives.push(drive);
        self
    }

    /// With one fibre more.
    #[must_use]
    pub fn with_fibre(mut self, fibre: Fibre) -> Self {
        self.fibres.push(fibre);
        self
    }

    /// With one sheet more.
    #[must_use]
    pub fn with_sheet(mut self, sheet: Sheet) -> Self {
        self.sheets.push(sheet);
        self
    }

    /// With one element more.
    #[must_use]
    pub fn with_element(mut self, element: Element) -> Self {
        self.elements.push(element);
        self
    }

    /// With one region more that has a matrix of its own.
    #[must_use]
    pub fn with_region_material(mut self, material: RegionMaterial) -> Self {
        self.region_materials.push(material);
        self
    }

    /// With one void more.
    #[must_use]
    pub fn with_void(mut self, void: Void) -> Self {
        self.voids.push(void);
        self
    }

    /// Painted by one dab more.
    #[must_use]
    pub fn with_dab(mut self, dab: Dab) -> Self {
        add_dab(&mut self.paint, dab);
        self
    }
}

/// Kinds of bodies.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum BodyKind {
    /// A homogeneous elastic matrix with embedded fibres (the fibre paper).
    #[default]
    FibreSolid,
}
