//! Rest shapes of fibre solids, and where a body stands.

use super::{Axis, Extra};
use glam::{DQuat, DVec3};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Rest shape of a body.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Shape {
    /// A box.
    Box(BoxShape),
    /// A closed mesh from a file.
    Mesh(MeshShape),
}

/// A closed mesh from an OBJ, STL, PLY, glTF or GLB file, filled with particles on a cubic lattice. The lattice is placed
/// so, and its spacing changed by so little, that the particles' volume comes closest to that of the mesh.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct MeshShape {
    /// The file, relative to the scene file.
    pub path: String,
    /// Metres to a unit of the file: 0.001 for a file in millimetres.
    #[serde(default = "default_scale")]
    pub scale: f64,
    /// Axis of the file that points up; it becomes Y.
    #[serde(default = "default_up")]
    pub up: Axis,
    /// Number of particles that is wanted; the spacing and the support radius follow from it then, and the material's
    /// support radius is not used. From 8 to 2000000.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub particles: Option<u32>,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

/// A box along the axes of the model frame, filled with particles on a cubic lattice.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct BoxShape {
    /// Centre [m].
    #[serde(default)]
    pub center: [f64; 3],
    /// Full extents [m].
    pub size: [f64; 3],
    /// Turn of the lattice against the box, to see how much of a result is the lattice's doing. To turn a body in the
    /// world use its placement: that turns box and lattice together.
    #[serde(default)]
    pub lattice_rotation: Rotation,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

/// A rotation about an axis.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Rotation {
    /// Axis, of any length but zero.
    pub axis: [f64; 3],
    /// Angle [degrees], right-handed about the axis.
    pub degrees: f64,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

impl Rotation {
    /// As a quaternion.
    pub fn quaternion(&self) -> DQuat {
        let axis = DVec3::from_array(self.axis).normalize_or(DVec3::Y);
        DQuat::from_axis_angle(axis, self.degrees.to_radians())
    }
}

impl Default for Rotation {
    fn default() -> Self {
        Self { axis: [0.0, 1.0, 0.0], degrees: 0.0, extra: Extra::new() }
    }
}

/// Where the model frame stands in the world: turned about the model's origin, then moved.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct Placement {
    /// World position of the model's origin [m].
    pub translation: [f64; 3],
    /// Turn about the model's origin.
    pub rotation: Rotation,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

fn default_scale() -> f64 {
    1.0
}

fn default_up() -> Axis {
    Axis::Y
}
