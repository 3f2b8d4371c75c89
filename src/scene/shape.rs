//! Rest shapes of fibre solids, and where a body stands.

use super::{Axis, BallShape, CapsuleShape, CylinderShape, Extra, TorusShape};
use crate::geometry::mesh::TriangleMesh;
use glam::{DQuat, DVec3};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Rest shape of a body.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Shape {
    /// A box.
    Box(BoxShape),
    /// A ball.
    Ball(BallShape),
    /// A cylinder.
    Cylinder(CylinderShape),
    /// A cylinder with round ends.
    Capsule(CapsuleShape),
    /// A ring.
    Torus(TorusShape),
    /// A closed mesh from a file.
    Mesh(MeshShape),
}

macro_rules! shapes {
    ($($kind:ident $shape:ty;)*) => {
        $(impl From<$shape> for Shape {
            fn from(shape: $shape) -> Self {
                Self::$kind(shape)
            }
        })*
    };
}

shapes! {
    Box BoxShape;
    Ball BallShape;
    Cylinder CylinderShape;
    Capsule CapsuleShape;
    Torus TorusShape;
    Mesh MeshShape;
}

impl Shape {
    /// The surface of a round shape in faces of about `edge` [m]; none of a box, nor of a mesh, which has its own.
    pub(crate) fn round_surface(&self, edge: f64) -> Option<TriangleMesh> {
        match self {
            Self::Box(_) | Self::Mesh(_) => None,
            Self::Ball(shape) => Some(shape.surface(edge)),
            Self::Cylinder(shape) => Some(shape.surface(edge)),
            Self::Capsule(shape) => Some(shape.surface(edge)),
            Self::Torus(shape) => Some(shape.surface(edge)),
        }
    }

    /// Full extents along the axes of the model frame [m]; none of a mesh, which the document does not hold.
    pub fn size(&self) -> Option<[f64; 3]> {
        match self {
            Self::Box(shape) => Some(shape.size),
            Self::Ball(shape) => Some(shape.size()),
            Self::Cylinder(shape) => Some(shape.size()),
            Self::Capsule(shape) => Some(shape.size()),
            Self::Torus(shape) => Some(shape.size()),
            Self::Mesh(_) => None,
        }
    }

    /// Thickness where it is thinnest [m]: of a ring its tube's, of others the least extent; none of a mesh.
    pub fn thickness(&self) -> Option<f64> {
        match self {
            Self::Torus(torus) => Some(2.0 * torus.tube_radius),
            other => Some(other.size()?.into_iter().fold(f64::INFINITY, f64::min)),
        }
    }

    /// Volume [m³]; none of a mesh.
    pub fn volume(&self) -> Option<f64> {
        match self {
            Self::Box(shape) => Some(shape.size.iter().product()),
            Self::Ball(shape) => Some(shape.volume()),
            Self::Cylinder(shape) => Some(shape.volume()),
            Self::Capsule(shape) => Some(shape.volume()),
            Self::Torus(shape) => Some(shape.volume()),
            Self::Mesh(_) => None,
        }
    }
}

/// A closed mesh from an OBJ, STL, PLY, glTF or GLB file, filled with particles on a cubic lattice. The lattice is
/// placed so, and its spacing changed by so little, that the particles' volume comes closest to that of the mesh.
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

impl MeshShape {
    /// The mesh of a file relative to the scene file, or of a mesh in memory by its name
    /// ([`Assets::insert_mesh`](super::Assets::insert_mesh)): in metres, Y up, as finely filled as the material says.
    pub fn new(path: impl Into<String>) -> Self {
        Self { path: path.into(), scale: default_scale(), up: default_up(), particles: None, extra: Extra::new() }
    }

    /// Filled with about this many particles, from 8 to 2000000, whatever the material's support radius is.
    #[must_use]
    pub fn with_particles(self, particles: u32) -> Self {
        Self { particles: Some(particles), ..self }
    }

    /// With so many metres to a unit of the mesh.
    #[must_use]
    pub fn with_scale(self, scale: f64) -> Self {
        Self { scale, ..self }
    }

    /// With another axis of the mesh that points up.
    #[must_use]
    pub fn with_up(self, up: Axis) -> Self {
        Self { up, ..self }
    }
}

impl<S: Into<String>> From<S> for MeshShape {
    fn from(path: S) -> Self {
        Self::new(path)
    }
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

impl BoxShape {
    /// A box of these full extents [m] about the model's origin.
    pub fn new(size: impl Into<[f64; 3]>) -> Self {
        Self { center: [0.0; 3], size: size.into(), lattice_rotation: Rotation::default(), extra: Extra::new() }
    }

    /// With another centre [m].
    #[must_use]
    pub fn with_center(self, center: impl Into<[f64; 3]>) -> Self {
        Self { center: center.into(), ..self }
    }
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
    /// A turn by an angle [degrees], right-handed about an axis of any length but zero.
    pub fn about(axis: impl Into<[f64; 3]>, degrees: f64) -> Self {
        Self { axis: axis.into(), degrees, extra: Extra::new() }
    }

    /// As a quaternion.
    pub fn quaternion(&self) -> DQuat {
        let axis = DVec3::from_array(self.axis).normalize_or(DVec3::Y);
        DQuat::from_axis_angle(axis, self.degrees.to_radians())
    }
}

impl Default for Rotation {
    fn default() -> Self {
        Self::about([0.0, 1.0, 0.0], 0.0)
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
