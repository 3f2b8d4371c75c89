//! Voids: what is taken out of a body.

use super::{Axis, Extra, FibreSource, ModelFile};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Most voids in a body; each takes time at every particle and its neighbours.
pub const MAX_VOIDS: usize = 1000;

/// One void of a body: the particles in it are taken out, and those on its sides no longer feel each other through it.
/// One thinner than a spacing takes no particle out and is a cut. Between it and the outside, or another void, two
/// layers of particles must be left.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Void {
    /// Stable identifier, unique among the body's voids.
    pub id: String,
    /// Name a person reads.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub name: String,
    /// What is taken out, in the model frame.
    pub shape: VoidShape,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

/// Shapes of voids, in the model frame.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum VoidShape {
    /// A ball.
    Sphere {
        /// Centre [m].
        center: [f64; 3],
        /// Radius [m].
        radius: f64,
        /// Unknown fields, kept.
        #[serde(flatten)]
        extra: Extra,
    },
    /// An axis-aligned box.
    Box {
        /// Least corner [m].
        min: [f64; 3],
        /// Greatest corner [m].
        max: [f64; 3],
        /// Unknown fields, kept.
        #[serde(flatten)]
        extra: Extra,
    },
    /// All that lies near a line drawn as fibres are, round at both ends; one that is to come out of the body is drawn
    /// beyond it.
    Tube {
        /// Where the line runs.
        source: FibreSource,
        /// How near [m].
        radius: f64,
        /// Unknown fields, kept.
        #[serde(flatten)]
        extra: Extra,
    },
    /// What a closed mesh from a file encloses.
    Mesh(VoidMesh),
}

/// A mesh that encloses a void.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct VoidMesh {
    /// The file, relative to the scene file.
    pub path: String,
    /// Metres to a unit of the file: 0.001 for a file in millimetres.
    #[serde(default = "default_scale")]
    pub scale: f64,
    /// Axis of the file that points up; it becomes Y.
    #[serde(default = "default_up")]
    pub up: Axis,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

impl<'a> From<&'a VoidMesh> for ModelFile<'a> {
    fn from(mesh: &'a VoidMesh) -> Self {
        Self { path: &mesh.path, scale: mesh.scale, up: mesh.up }
    }
}

impl Void {
    fn new(id: impl Into<String>, shape: VoidShape) -> Self {
        Self { id: id.into(), name: String::new(), shape, extra: Extra::new() }
    }

    /// A ball of the model frame: its centre and radius [m].
    pub fn sphere(id: impl Into<String>, center: impl Into<[f64; 3]>, radius: f64) -> Self {
        Self::new(id, VoidShape::Sphere { center: center.into(), radius, extra: Extra::new() })
    }

    /// What lies between two corners of a box of the model frame [m].
    pub fn in_box(id: impl Into<String>, min: impl Into<[f64; 3]>, max: impl Into<[f64; 3]>) -> Self {
        Self::new(id, VoidShape::Box { min: min.into(), max: max.into(), extra: Extra::new() })
    }

    /// What lies within a radius [m] of a line drawn as a fibre is.
    pub fn tube(id: impl Into<String>, source: FibreSource, radius: f64) -> Self {
        Self::new(id, VoidShape::Tube { source, radius, extra: Extra::new() })
    }

    /// What a closed mesh encloses: a file relative to the scene file, or the name of a mesh in memory; in metres, Y
    /// up.
    pub fn mesh(id: impl Into<String>, path: impl Into<String>) -> Self {
        let mesh = VoidMesh { path: path.into(), scale: default_scale(), up: default_up(), extra: Extra::new() };
        Self::new(id, VoidShape::Mesh(mesh))
    }
}

fn default_scale() -> f64 {
    1.0
}

fn default_up() -> Axis {
    Axis::Y
}
