//! Bodies: shape, material, regions, start.

use super::{Axis, Dab, Extra, Fibre, Pin, Side, is_false};
use glam::{DQuat, DVec3};
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
    /// How it is stepped through time.
    #[serde(default)]
    pub integrator: IntegratorKind,
    /// Motion and deformation at the start.
    #[serde(default)]
    pub initial: Initial,
    /// Impulses given to regions at the start.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub impulses: Vec<Impulse>,
    /// Embedded fibres.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub fibres: Vec<Fibre>,
    /// Volume fraction of fibre painted by hand over what the fibres give, one dab after the other.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub paint: Vec<Dab>,
    /// Named sets of particles.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub regions: Vec<Region>,
    /// Regions whose motion is prescribed.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub pins: Vec<Pin>,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

/// Kinds of bodies.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum BodyKind {
    /// A homogeneous elastic matrix with embedded fibres (the fibre paper).
    #[default]
    FibreSolid,
}

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

/// A homogeneous, isotropic elastic material and its discretisation. The fibres do the rest.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Material {
    /// Young's modulus E [Pa].
    pub young_modulus: f64,
    /// Poisson's ratio nu, from 0 to 0.49.
    #[serde(default = "default_poisson")]
    pub poisson_ratio: f64,
    /// Density or mass.
    pub mass: Mass,
    /// Support radius h of the smoothing kernel [m].
    pub support_radius: f64,
    /// Particle spacing over support radius, D / h.
    #[serde(default = "default_spacing_ratio")]
    pub spacing_ratio: f64,
    /// What takes energy out of the motion.
    #[serde(default)]
    pub damping: Damping,
    /// How a fibre's volume fraction falls off with the distance from its structure particles, out to h.
    #[serde(default)]
    pub volume_fraction_falloff: Falloff,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

impl Material {
    /// Particle spacing D [m].
    pub fn spacing(&self) -> f64 {
        self.spacing_ratio * self.support_radius
    }
}

/// Mass of a body.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Mass {
    /// Density [kg/m³] times the volume of the shape, shared evenly by its particles.
    Density(f64),
    /// Mass of each material particle [kg]; the fibre paper uses 4e-4.
    PerParticle(f64),
}

/// Damping. Neither kind changes the rest state.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct Damping {
    /// Radial damping between neighbouring particles [1/s]; keeps linear and angular momentum.
    pub pair: f64,
    /// Drag of the surrounding air, acceleration per velocity [1/s].
    pub air: f64,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

/// How a fibre's volume fraction falls off with distance d from its nearest structure particle.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Falloff {
    /// By the kernel, W(d) / W(0) (eq. 13).
    #[default]
    Kernel,
    /// Linearly, 1 - d / h.
    Linear,
    /// Not at all within h.
    Constant,
}

/// How a body is stepped through time.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum IntegratorKind {
    /// Kick-drift-kick leap-frog: order 2, one force evaluation a step, keeps momenta and energy.
    #[default]
    LeapFrog,
    /// Explicit Euler: order 1, gains energy without damping.
    ExplicitEuler,
    /// Explicit midpoint: order 2, two evaluations a step.
    Midpoint,
    /// Classical Runge-Kutta: order 4, four evaluations a step.
    Rk4,
    /// Symplectic Euler: order 1, one evaluation a step.
    SymplecticEuler,
    /// Velocity Verlet with a predicted velocity: order 2 with damping too, two evaluations a step.
    Verlet,
    /// Backward Euler: order 1, stable at any step, takes energy.
    BackwardEuler,
}

/// Motion and deformation at the start.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct Initial {
    /// Velocity [m/s], world axes.
    pub velocity: [f64; 3],
    /// Angular velocity about the centre of mass [degrees/s], world axes.
    pub angular_velocity: [f64; 3],
    /// Deformation gradient about the model's centre of mass, row by row; the identity is the rest shape.
    pub deformation: [[f64; 3]; 3],
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

impl Default for Initial {
    fn default() -> Self {
        Self {
            velocity: [0.0; 3],
            angular_velocity: [0.0; 3],
            deformation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
            extra: Extra::new(),
        }
    }
}

/// An impulse shared by the particles of a region at the start, by mass.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Impulse {
    /// Region that is struck.
    pub region: String,
    /// Impulse on the whole region [N s], world axes.
    pub impulse: [f64; 3],
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

/// A named set of material particles, chosen at rest in the model frame.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Region {
    /// Stable identifier, unique within the body.
    pub id: String,
    /// Which particles belong to it.
    pub select: Selector,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

/// Which particles belong to a region.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Selector {
    /// Every particle of the body.
    Everything,
    /// The first layers of the lattice from one side.
    Layers {
        /// Axis along which layers are counted.
        axis: Axis,
        /// Side from which they are counted.
        side: Side,
        /// How many layers.
        count: u32,
        /// Unknown fields, kept.
        #[serde(flatten)]
        extra: Extra,
    },
    /// Particles in an axis-aligned box of the model frame.
    Box {
        /// Least corner [m].
        min: [f64; 3],
        /// Greatest corner [m].
        max: [f64; 3],
        /// Unknown fields, kept.
        #[serde(flatten)]
        extra: Extra,
    },
    /// Particles in a ball of the model frame.
    Sphere {
        /// Centre [m].
        center: [f64; 3],
        /// Radius [m].
        radius: f64,
        /// Unknown fields, kept.
        #[serde(flatten)]
        extra: Extra,
    },
}

fn default_scale() -> f64 {
    1.0
}

fn default_up() -> Axis {
    Axis::Y
}

fn default_poisson() -> f64 {
    0.33
}

fn default_spacing_ratio() -> f64 {
    0.4
}
