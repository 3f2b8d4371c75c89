//! Regions: named sets of particles.

use super::{Axis, Extra, Side};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

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

impl Region {
    /// The particles that `select` chooses.
    pub fn new(id: impl Into<String>, select: Selector) -> Self {
        Self { id: id.into(), select, extra: Extra::new() }
    }

    /// The first `count` layers of a fibre solid's lattice from one side.
    pub fn layers(id: impl Into<String>, axis: Axis, side: Side, count: u32) -> Self {
        Self::new(id, Selector::Layers { axis, side, count, extra: Extra::new() })
    }

    /// What lies between two corners of a box of the model frame [m].
    pub fn in_box(id: impl Into<String>, min: impl Into<[f64; 3]>, max: impl Into<[f64; 3]>) -> Self {
        Self::new(id, Selector::Box { min: min.into(), max: max.into(), extra: Extra::new() })
    }

    /// What lies in a ball of the model frame: its centre and radius [m].
    pub fn in_sphere(id: impl Into<String>, center: impl Into<[f64; 3]>, radius: f64) -> Self {
        Self::new(id, Selector::Sphere { center: center.into(), radius, extra: Extra::new() })
    }
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
