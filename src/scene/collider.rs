//! Colliders: rigid things that bodies touch, still or moved.

use super::{Axis, Drive, Extra, Motion, Placement, Rotation};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A rigid thing that bodies touch and that nothing pushes away: it stands still, or moves as it is told.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Collider {
    /// Stable identifier, unique among the colliders.
    pub id: String,
    /// Name a person reads.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub name: String,
    /// What it is, about its own origin.
    pub shape: ColliderShape,
    /// Where it stands at the start.
    #[serde(default)]
    pub placement: Placement,
    /// How it moves; a turn without an origin goes about its own. Distances are in metres, and a drive is none that is
    /// shared, which only bodies have.
    #[serde(default)]
    pub motion: Motion,
    /// Coulomb friction coefficient.
    #[serde(default = "default_friction")]
    pub friction: f64,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

impl Collider {
    /// A collider about the world's origin that stands still, with a friction coefficient of 0.4.
    pub fn new(id: impl Into<String>, shape: impl Into<ColliderShape>) -> Self {
        Self {
            id: id.into(),
            name: String::new(),
            shape: shape.into(),
            placement: Placement::default(),
            motion: Motion::default(),
            friction: default_friction(),
            extra: Extra::new(),
        }
    }

    /// A ball of this radius [m].
    pub fn sphere(id: impl Into<String>, radius: f64) -> Self {
        Self::new(id, ColliderShape::Sphere(ColliderSphere { radius, extra: Extra::new() }))
    }

    /// A box of these full extents [m].
    pub fn cuboid(id: impl Into<String>, size: impl Into<[f64; 3]>) -> Self {
        Self::new(id, ColliderShape::Box(ColliderBox { size: size.into(), extra: Extra::new() }))
    }

    /// A capsule along its own Y: a cylinder of this length between two half balls of this radius [m].
    pub fn capsule(id: impl Into<String>, radius: f64, length: f64) -> Self {
        Self::new(id, ColliderShape::Capsule(ColliderCapsule { radius, length, extra: Extra::new() }))
    }

    /// All that is below its own X and Z.
    pub fn plane(id: impl Into<String>) -> Self {
        Self::new(id, ColliderShape::Plane)
    }

    /// With its origin at this point [m, world].
    #[must_use]
    pub fn with_translation(self, translation: impl Into<[f64; 3]>) -> Self {
        Self { placement: Placement { translation: translation.into(), ..self.placement }, ..self }
    }

    /// Turned about its own origin.
    #[must_use]
    pub fn with_rotation(self, rotation: Rotation) -> Self {
        Self { placement: Placement { rotation, ..self.placement }, ..self }
    }

    /// Moved so.
    #[must_use]
    pub fn with_motion(self, motion: impl Into<Motion>) -> Self {
        Self { motion: motion.into(), ..self }
    }

    /// With another friction coefficient.
    #[must_use]
    pub fn with_friction(self, friction: f64) -> Self {
        Self { friction, ..self }
    }

    /// The drive that moves it, if one does.
    pub fn drive(&self) -> Option<&Drive> {
        match &self.motion {
            Motion::Driven(driven) => Some(&driven.drive),
            _ => None,
        }
    }
}

/// What a collider is, about its own origin.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ColliderShape {
    /// A ball.
    Sphere(ColliderSphere),
    /// A box along its own axes.
    Box(ColliderBox),
    /// A capsule along its own Y.
    Capsule(ColliderCapsule),
    /// All that is below its own X and Z.
    Plane,
    /// A mesh from a file.
    Mesh(ColliderMesh),
}

impl From<ColliderMesh> for ColliderShape {
    fn from(mesh: ColliderMesh) -> Self {
        Self::Mesh(mesh)
    }
}

impl ColliderShape {
    /// What people call it.
    pub fn word(&self) -> &'static str {
        match self {
            Self::Sphere(_) => "sphere",
            Self::Box(_) => "box",
            Self::Capsule(_) => "capsule",
            Self::Plane => "plane",
            Self::Mesh(_) => "mesh",
        }
    }
}

/// A ball.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ColliderSphere {
    /// Radius [m].
    pub radius: f64,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

/// A box along its own axes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ColliderBox {
    /// Full extents [m].
    pub size: [f64; 3],
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

/// A cylinder along its own Y between two half balls.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ColliderCapsule {
    /// Radius of all of it [m].
    pub radius: f64,
    /// Length of the cylinder [m].
    pub length: f64,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

/// A mesh from an OBJ, STL, PLY, glTF or GLB file. What it encloses is solid; a mesh with holes is a thin shell that is
/// touched from both sides.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ColliderMesh {
    /// The file, relative to the scene file.
    pub path: String,
    /// Metres to a unit of the file: 0.001 for a file in millimetres.
    #[serde(default = "one")]
    pub scale: f64,
    /// Axis of the file that points up; it becomes Y.
    #[serde(default = "y_up")]
    pub up: Axis,
    /// Whether it is a thin shell though it is closed: bodies may be in it, and do not leave it.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub hollow: bool,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

impl ColliderMesh {
    /// The mesh of a file relative to the scene file, or of a mesh in memory by its name
    /// ([`Assets::insert_obstacle`](super::Assets::insert_obstacle)): in metres, Y up.
    pub fn new(path: impl Into<String>) -> Self {
        Self { path: path.into(), scale: one(), up: y_up(), hollow: false, extra: Extra::new() }
    }
}

fn one() -> f64 {
    1.0
}

fn y_up() -> Axis {
    Axis::Y
}

fn default_friction() -> f64 {
    0.4
}
