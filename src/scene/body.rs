//! Fibre solids: a shape of a material with fibres in it.

use super::extra::is_false;
use super::{Dab, Extra, Fibre, Impulse, Initial, IntegratorKind, Material, Pin, Placement, Region, Shape};
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
