//! Pins: regions whose motion is prescribed.

use super::{Axis, Extra};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A region that is held or moved along some world axes and free along the others.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Pin {
    /// Stable identifier, unique within the body.
    pub id: String,
    /// Region that is held.
    pub region: String,
    /// World axes along which it is held; all three unless given.
    #[serde(default = "all_axes")]
    pub axes: Vec<Axis>,
    /// How it moves.
    #[serde(default)]
    pub motion: Motion,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

/// Prescribed motion, relative to where the region starts.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Motion {
    /// Stays where it starts.
    #[default]
    Fixed,
    /// Moves a distance along a direction, then stays.
    Ramp(Ramp),
    /// Turns about an axis, then stays.
    Turn(Turn),
    /// Follows offsets, linearly from one to the next; before the first and after the last it rests.
    Keyframes(Vec<Keyframe>),
}

/// A straight move.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Ramp {
    /// Direction, of any length but zero, world axes.
    pub direction: [f64; 3],
    /// How far.
    pub distance: Distance,
    /// When it starts [s].
    #[serde(default)]
    pub start: f64,
    /// How long it takes [s].
    pub duration: f64,
    /// How it speeds up and slows down.
    #[serde(default)]
    pub easing: Easing,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

/// A distance.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Distance {
    /// In metres.
    Metres(f64),
    /// As a fraction of the body's extent along the direction, from its first to its last layer of particles.
    Fraction(f64),
}

/// A turn about an axis through a point.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Turn {
    /// Axis, of any length but zero, world axes.
    pub axis: [f64; 3],
    /// A point on the axis [m], world; the centre of the region unless given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub origin: Option<[f64; 3]>,
    /// Angle [degrees], right-handed about the axis.
    pub degrees: f64,
    /// When it starts [s].
    #[serde(default)]
    pub start: f64,
    /// How long it takes [s].
    pub duration: f64,
    /// How it speeds up and slows down.
    #[serde(default)]
    pub easing: Easing,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

/// How a motion speeds up and slows down.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Easing {
    /// At a steady speed.
    Linear,
    /// From rest to rest (3 s² - 2 s³).
    #[default]
    Smooth,
}

/// Offset from the start at one time.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Keyframe {
    /// Time [s].
    pub time: f64,
    /// Offset [m], world axes.
    pub offset: [f64; 3],
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

fn all_axes() -> Vec<Axis> {
    vec![Axis::X, Axis::Y, Axis::Z]
}
