//! Two-layer bodies: elastic objects of an outer and an inner layer of particles joined by springs, with gas inside
//! (Song and Grogono: *A framework for dynamic deformation of uniform elastic two-layer 2D and 3D objects*, C3S2E
//! 2008).

use super::extra::is_false;
use super::{
    ActiveSprings, Ball, ClosedMesh, Drive, Extra, Follow, Impulse, Initial, IntegratorChoice, Pin, Placement, Region,
    Ring, Segment, SharedDrive, TwoLayerShape,
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// One two-layer body. Every parameter has the paper's default (sec. 4.2.1).
///
/// The regions "outer", "inner" and "everything" are there without being given; a single particle of a layer is reached
/// by a region of its own.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct TwoLayer {
    /// Stable identifier, unique among the bodies of both kinds.
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
    /// Rest shape, in the model frame; its dimension is the body's.
    pub shape: TwoLayerShape,
    /// Where the model frame stands in the world.
    #[serde(default)]
    pub placement: Placement,
    /// KS: stiffness of structural springs, along the edges of a layer [N/m].
    #[serde(default = "default_ks")]
    pub ks: f64,
    /// KD: damping of structural springs [N s/m].
    #[serde(default = "default_kd")]
    pub kd: f64,
    /// RKS: stiffness of radius and shear springs, between the layers [N/m].
    #[serde(default = "default_rks")]
    pub rks: f64,
    /// RKD: damping of radius and shear springs [N s/m].
    #[serde(default = "default_rkd")]
    pub rkd: f64,
    /// MKS: stiffness of the spring by which the body is grabbed [N/m].
    #[serde(default = "default_mks")]
    pub mks: f64,
    /// MKD: damping of the spring by which the body is grabbed [N s/m].
    #[serde(default = "default_mkd")]
    pub mkd: f64,
    /// PRESSURE: nRT of the enclosed gas [J], in 2D for each metre of depth; P = nRT / V.
    #[serde(default = "default_pressure")]
    pub pressure: f64,
    /// What the gas's nRT is multiplied by, from 0 on; by 1 unless given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pressure_drive: Option<Drive>,
    /// Which space the gas fills.
    #[serde(default)]
    pub pressure_in: PressureIn,
    /// MASS: mass of a particle [kg].
    #[serde(default = "default_mass")]
    pub mass: f64,
    /// Mass of a particle of the inner layer [kg]; as `mass` unless given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub inner_mass: Option<f64>,
    /// Masses of the particles of some regions, such as the lower half of a balloon half filled with water.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub masses: Vec<RegionMass>,
    /// Drag of the surrounding air, acceleration per velocity [1/s]; springs leave swing and rotation undamped.
    #[serde(default)]
    pub air_drag: f64,
    /// How it pushes on what it touches.
    #[serde(default)]
    pub contact: TwoLayerContact,
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
    /// Springs whose rest lengths a drive changes.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub active_springs: Vec<ActiveSprings>,
    /// Named sets of particles.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub regions: Vec<Region>,
    /// Regions whose motion is prescribed.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub pins: Vec<Pin>,
    /// Motions made elsewhere that its particles follow.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub follows: Vec<Follow>,
    /// Grabs of its nearest outer particle; the paper and the file say drags.
    #[serde(default, rename = "drags", skip_serializing_if = "Vec::is_empty")]
    pub grabs: Vec<Grab>,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

impl TwoLayer {
    /// Regions that every two-layer body has: all particles, and those of either layer.
    pub const REGIONS: [&'static str; 3] = ["everything", "outer", "inner"];

    /// A body of this shape with the paper's parameters (sec. 4.2.1). To change one, write it before the rest:
    /// `TwoLayer { pressure: 40.0, ..TwoLayer::ball("ball") }`.
    pub fn new(id: impl Into<String>, shape: impl Into<TwoLayerShape>) -> Self {
        Self {
            id: id.into(),
            name: String::new(),
            hidden: false,
            color: None,
            shape: shape.into(),
            placement: Placement::default(),
            ks: default_ks(),
            kd: default_kd(),
            rks: default_rks(),
            rkd: default_rkd(),
            mks: default_mks(),
            mkd: default_mkd(),
            pressure: default_pressure(),
            pressure_drive: None,
            pressure_in: PressureIn::default(),
            mass: default_mass(),
            inner_mass: None,
            masses: Vec::new(),
            air_drag: 0.0,
            contact: TwoLayerContact::default(),
            self_contact: false,
            integrator: IntegratorChoice::default(),
            initial: Initial::default(),
            impulses: Vec::new(),
            drives: Vec::new(),
            active_springs: Vec::new(),
            regions: Vec::new(),
            pins: Vec::new(),
            follows: Vec::new(),
            grabs: Vec::new(),
            extra: Extra::new(),
        }
    }

    /// The 1D body: two particles 2 m apart and a spring along X.
    pub fn segment(id: impl Into<String>) -> Self {
        Self::new(id, Segment::default())
    }

    /// The 2D body: two polygons of ten sides, of radius 2 m and 1 m.
    pub fn ring(id: impl Into<String>) -> Self {
        Self::new(id, Ring::default())
    }

    /// The 3D body: two spheres of 18 particles, of radius 2 m and 1 m.
    pub fn ball(id: impl Into<String>) -> Self {
        Self::new(id, Ball::default())
    }

    /// A 3D body of any shape: the surface of a closed mesh from a file or in memory, and the same moved inwards by a
    /// quarter of half its least extent.
    pub fn from_mesh(id: impl Into<String>, mesh: impl Into<ClosedMesh>) -> Self {
        Self::new(id, mesh.into())
    }

    /// Grabbed by its nearest outer particle as well.
    #[must_use]
    pub fn with_grab(mut self, grab: Grab) -> Self {
        self.grabs.push(grab);
        self
    }
}

/// Which space the gas of a two-layer body fills.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum PressureIn {
    /// All that the outer layer encloses.
    #[default]
    Outer,
    /// All that the inner layer encloses.
    Inner,
    /// Gas of the same nRT in the outer and in the inner layer, each pushing on its own.
    Both,
    /// The space between the layers.
    Annulus,
}

/// Mass of the particles of a region.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct RegionMass {
    /// The region.
    pub region: String,
    /// Mass of each of its particles [kg].
    pub mass: f64,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

impl RegionMass {
    /// Mass of each particle of a region [kg].
    pub fn new(region: impl Into<String>, mass: f64) -> Self {
        Self { region: region.into(), mass, extra: Extra::new() }
    }
}

/// How a two-layer body pushes on what it touches. Its particles are points. Friction is the room's.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct TwoLayerContact {
    /// How contact acts.
    pub law: ContactKind,
    /// kc: stiffness of each particle's contact [N/m].
    pub kc: f64,
    /// cc: damping of each particle's contact in the normal direction [N s/m].
    pub cc: f64,
    /// ct: damping along the surface below Coulomb's limit [N s/m].
    pub ct: f64,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

impl Default for TwoLayerContact {
    fn default() -> Self {
        Self { law: ContactKind::Penalty, kc: 5000.0, cc: 50.0, ct: 50.0, extra: Extra::new() }
    }
}

/// How contact with the room acts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ContactKind {
    /// N = max(0, kc d - cc vn) and |Ft| = min(friction N, |kt st + ct vt|), st the way along the surface since it
    /// took hold and kt = kc where the room's friction holds by springs: only pushes, never pulls.
    #[default]
    Penalty,
    /// The paper's: as penalty, and after each step what is behind a plane is put on it without touching its velocity.
    /// It sticks (sec. 4.3.1); for comparison only.
    PaperReset,
}

/// A grab of the nearest outer particle by a spring of stiffness `mks` and damping `mkd`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Grab {
    /// Where the particle is pulled to [m], world.
    pub target: [f64; 3],
    /// When it is let go [s]; never unless given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub until: Option<f64>,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

impl Grab {
    /// Pulls to a point [m, world] and never lets go.
    pub fn to(target: impl Into<[f64; 3]>) -> Self {
        Self { target: target.into(), until: None, extra: Extra::new() }
    }
}

fn default_ks() -> f64 {
    800.0
}

fn default_kd() -> f64 {
    15.0
}

fn default_rks() -> f64 {
    700.0
}

fn default_rkd() -> f64 {
    50.0
}

fn default_mks() -> f64 {
    150.0
}

fn default_mkd() -> f64 {
    25.0
}

fn default_pressure() -> f64 {
    20.0
}

fn default_mass() -> f64 {
    1.0
}
