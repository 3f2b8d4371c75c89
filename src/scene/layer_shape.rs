//! Rest shapes of two-layer bodies.

use super::{Axis, Extra};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Rest shape of a two-layer body about the model's origin.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum TwoLayerShape {
    /// 1D: two particles and a structural spring along X.
    Segment(Segment),
    /// 2D: two regular polygons in the plane of X and Y, in which the body stays.
    Ring(Ring),
    /// 3D: two spheres, an octahedron subdivided.
    Ball(Ball),
    /// 3D: a closed mesh from a file, and the same moved inwards.
    Mesh(ClosedMesh),
}

impl TwoLayerShape {
    /// 1, 2 or 3.
    pub fn dimension(&self) -> u32 {
        match self {
            Self::Segment(_) => 1,
            Self::Ring(_) => 2,
            Self::Ball(_) | Self::Mesh(_) => 3,
        }
    }

    /// Whether there is an inner layer.
    pub fn has_inner_layer(&self) -> bool {
        match self {
            Self::Segment(_) => false,
            Self::Ring(ring) => !ring.single_layer,
            Self::Ball(ball) => !ball.single_layer,
            Self::Mesh(mesh) => !mesh.single_layer,
        }
    }
}

impl From<Segment> for TwoLayerShape {
    fn from(segment: Segment) -> Self {
        Self::Segment(segment)
    }
}

impl From<Ring> for TwoLayerShape {
    fn from(ring: Ring) -> Self {
        Self::Ring(ring)
    }
}

impl From<Ball> for TwoLayerShape {
    fn from(ball: Ball) -> Self {
        Self::Ball(ball)
    }
}

impl From<ClosedMesh> for TwoLayerShape {
    fn from(mesh: ClosedMesh) -> Self {
        Self::Mesh(mesh)
    }
}

/// The 1D body.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct Segment {
    /// Length at rest [m].
    pub length: f64,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

impl Default for Segment {
    fn default() -> Self {
        Self { length: 2.0, extra: Extra::new() }
    }
}

/// The 2D body.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct Ring {
    /// Sides of each polygon.
    pub sides: u32,
    /// Radius of the outer layer's vertices [m].
    pub outer_radius: f64,
    /// Radius of the inner layer's vertices [m].
    pub inner_radius: f64,
    /// Whether the outer layer stands alone.
    pub single_layer: bool,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

impl Default for Ring {
    fn default() -> Self {
        Self { sides: 10, outer_radius: 2.0, inner_radius: 1.0, single_layer: false, extra: Extra::new() }
    }
}

/// The 3D body.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct Ball {
    /// How often the octahedron's faces are cut in four, 0 to 5.
    pub subdivisions: u32,
    /// Radius of the outer layer's vertices [m].
    pub outer_radius: f64,
    /// Radius of the inner layer's vertices [m].
    pub inner_radius: f64,
    /// Whether the outer layer stands alone.
    pub single_layer: bool,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

impl Default for Ball {
    fn default() -> Self {
        Self { subdivisions: 1, outer_radius: 2.0, inner_radius: 1.0, single_layer: false, extra: Extra::new() }
    }
}

/// A 3D body of any shape: the outer layer is the surface of a closed mesh from an OBJ, STL, PLY, glTF or GLB file, one
/// particle wherever its vertices meet; the inner layer is the same surface, moved inwards along its normals.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ClosedMesh {
    /// The file, relative to the scene file.
    pub path: String,
    /// Metres to a unit of the file: 0.001 for a file in millimetres.
    #[serde(default = "default_scale")]
    pub scale: f64,
    /// Axis of the file that points up; it becomes Y.
    #[serde(default = "default_up")]
    pub up: Axis,
    /// How far inside the outer layer the inner one lies.
    #[serde(default)]
    pub inner_offset: InnerOffset,
    /// Whether the outer layer stands alone.
    #[serde(default)]
    pub single_layer: bool,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

impl ClosedMesh {
    /// The mesh of a file relative to the scene file, or of a mesh in memory by its name
    /// ([`Assets::insert_mesh`](super::Assets::insert_mesh)): in metres, Y up, two layers.
    pub fn new(path: impl Into<String>) -> Self {
        Self {
            path: path.into(),
            scale: default_scale(),
            up: default_up(),
            inner_offset: InnerOffset::default(),
            single_layer: false,
            extra: Extra::new(),
        }
    }
}

impl<S: Into<String>> From<S> for ClosedMesh {
    fn from(path: S) -> Self {
        Self::new(path)
    }
}

/// Distance from the outer layer to the inner one, along the normals.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum InnerOffset {
    /// In metres.
    Metres(f64),
    /// As a fraction of half the mesh's least extent: 0.5 puts the inner layer of a sphere at half its radius.
    Fraction(f64),
}

impl Default for InnerOffset {
    fn default() -> Self {
        Self::Fraction(0.25)
    }
}

fn default_scale() -> f64 {
    1.0
}

fn default_up() -> Axis {
    Axis::Y
}
