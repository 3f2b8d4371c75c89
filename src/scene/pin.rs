//! Pins: regions whose motion is prescribed.

use super::{Axis, Drive, Extra};
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

impl Pin {
    /// Holds a region where it starts, along all three axes.
    pub fn new(id: impl Into<String>, region: impl Into<String>) -> Self {
        Self { id: id.into(), region: region.into(), axes: all_axes(), motion: Motion::default(), extra: Extra::new() }
    }

    /// Held along these world axes only.
    #[must_use]
    pub fn with_axes(self, axes: impl IntoIterator<Item = Axis>) -> Self {
        Self { axes: axes.into_iter().collect(), ..self }
    }

    /// Moved so.
    #[must_use]
    pub fn with_motion(self, motion: impl Into<Motion>) -> Self {
        Self { motion: motion.into(), ..self }
    }
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
    /// Moves and turns as a drive has it.
    Driven(DrivenMotion),
}

impl From<Ramp> for Motion {
    fn from(ramp: Ramp) -> Self {
        Self::Ramp(ramp)
    }
}

impl From<Turn> for Motion {
    fn from(turn: Turn) -> Self {
        Self::Turn(turn)
    }
}

impl From<DrivenMotion> for Motion {
    fn from(driven: DrivenMotion) -> Self {
        Self::Driven(driven)
    }
}

/// A move and a turn, each as far as a drive has it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct DrivenMotion {
    /// What both are multiplied by; a wave with a wavelength is refused, as it runs along fibres.
    pub drive: Drive,
    /// How far it is moved where the drive is 1 [m], world axes.
    #[serde(default)]
    pub offset: [f64; 3],
    /// How far it is turned where the drive is 1; not at all unless given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub turn: Option<DrivenTurn>,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

impl DrivenMotion {
    /// Moved by an offset [m, world axes] times a drive.
    pub fn new(drive: impl Into<Drive>, offset: impl Into<[f64; 3]>) -> Self {
        Self { drive: drive.into(), offset: offset.into(), turn: None, extra: Extra::new() }
    }

    /// Turned as well.
    #[must_use]
    pub fn with_turn(self, turn: DrivenTurn) -> Self {
        Self { turn: Some(turn), ..self }
    }
}

/// A turn about an axis through a point, which a drive multiplies.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct DrivenTurn {
    /// Axis, of any length but zero, world axes.
    pub axis: [f64; 3],
    /// A point on the axis [m], world; the centre of the region unless given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub origin: Option<[f64; 3]>,
    /// Angle [degrees], right-handed about the axis.
    pub degrees: f64,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

impl DrivenTurn {
    /// Turned by an angle [degrees] about an axis (of any length but zero, world axes) through the region's centre.
    pub fn new(axis: impl Into<[f64; 3]>, degrees: f64) -> Self {
        Self { axis: axis.into(), origin: None, degrees, extra: Extra::new() }
    }
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

impl Ramp {
    /// Moves a distance along a direction (of any length but zero, world axes) in `duration` [s], at once and smoothly.
    pub fn new(direction: impl Into<[f64; 3]>, distance: Distance, duration: f64) -> Self {
        let direction = direction.into();
        Self { direction, distance, start: 0.0, duration, easing: Easing::default(), extra: Extra::new() }
    }
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

impl Turn {
    /// Turns by an angle [degrees] about an axis (of any length but zero, world axes) through the region's centre in
    /// `duration` [s], at once and smoothly.
    pub fn new(axis: impl Into<[f64; 3]>, degrees: f64, duration: f64) -> Self {
        let axis = axis.into();
        Self { axis, origin: None, degrees, start: 0.0, duration, easing: Easing::default(), extra: Extra::new() }
    }

    /// With a point that the axis goes through [m, world].
    #[must_use]
    pub fn with_origin(self, origin: impl Into<[f64; 3]>) -> Self {
        Self { origin: Some(origin.into()), ..self }
    }
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

impl Keyframe {
    /// An offset from the start [m, world axes] at a time [s].
    pub fn new(time: f64, offset: impl Into<[f64; 3]>) -> Self {
        Self { time, offset: offset.into(), extra: Extra::new() }
    }
}

fn all_axes() -> Vec<Axis> {
    Axis::ALL.to_vec()
}
