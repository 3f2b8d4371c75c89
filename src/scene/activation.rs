//! Fibres that act: what a drive does to them.

use super::extra::is_zero;
use super::{Drive, Extra};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// What a drive does to a fibre.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Activation {
    /// What all below is multiplied by.
    pub drive: Drive,
    /// Share by which the fibre wants to be shorter than it was drawn; with the drive from -0.5 to 0.8. It pulls as far
    /// as it is stiffer than what it lies in.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub contract: f64,
    /// Curvature that the fibre wants to have beside that of its rest shape.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub curl: Option<Curl>,
    /// Pull of a muscle, which is there besides what resists; the drive, from 0 to 1, excites it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub muscle: Option<MusclePull>,
    /// Twist that the fibre wants to have; it takes a twisting stiffness `gj`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub twist: Option<TwistRate>,
    /// Volume fraction that the fibre has where the drive is 1; it has its own where the drive is 0, and goes from one
    /// to the other in proportion to it. As the fibre gets stiffer, the matrix around it gives way, and back.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub volume_fraction: Option<f64>,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

impl Activation {
    /// Shorter by a share, times a drive.
    pub fn contracting(contract: f64, drive: impl Into<Drive>) -> Self {
        let drive = drive.into();
        Self { drive, contract, curl: None, muscle: None, twist: None, volume_fraction: None, extra: Extra::new() }
    }

    /// Curling about an axis of the model frame, of any length but zero, by so many degrees a metre times a drive.
    pub fn curling(degrees_per_metre: f64, axis: impl Into<[f64; 3]>, drive: impl Into<Drive>) -> Self {
        Self { curl: Some(Curl::new(degrees_per_metre, axis)), ..Self::contracting(0.0, drive) }
    }

    /// Pulling as a muscle of this greatest force [N] that a drive excites.
    pub fn pulling(force: f64, drive: impl Into<Drive>) -> Self {
        Self { muscle: Some(MusclePull::new(force)), ..Self::contracting(0.0, drive) }
    }

    /// Twisting by so many degrees a metre times a drive, right-handed along the fibre.
    pub fn twisting(degrees_per_metre: f64, drive: impl Into<Drive>) -> Self {
        Self { twist: Some(TwistRate::new(degrees_per_metre)), ..Self::contracting(0.0, drive) }
    }

    /// Of this volume fraction, from 0 to 1, where a drive is 1.
    pub fn thickening(volume_fraction: f64, drive: impl Into<Drive>) -> Self {
        Self { volume_fraction: Some(volume_fraction), ..Self::contracting(0.0, drive) }
    }

    /// Between which numbers a drive must stay for a fibre of this volume fraction to have one from 0 to 1.
    pub(super) fn thickening_limits(&self, own: f64) -> [f64; 2] {
        let any = [f64::NEG_INFINITY, f64::INFINITY];
        let Some(more) = self.volume_fraction.map(|at_one| at_one - own).filter(|more| *more != 0.0) else {
            return any;
        };
        let [a, b] = [-own, 1.0 - own].map(|way| way / more);
        [a.min(b), a.max(b)]
    }
}

impl MusclePull {
    /// A muscle of this greatest force [N] and the usual width.
    pub fn new(force: f64) -> Self {
        Self { force, width: usual_width(), extra: Extra::new() }
    }
}

impl Curl {
    /// So many degrees a metre about an axis of the model frame, of any length but zero.
    pub fn new(degrees_per_metre: f64, axis: impl Into<[f64; 3]>) -> Self {
        Self { degrees_per_metre, axis: axis.into(), extra: Extra::new() }
    }
}

impl TwistRate {
    /// So many degrees a metre, right-handed along the fibre.
    pub fn new(degrees_per_metre: f64) -> Self {
        Self { degrees_per_metre, extra: Extra::new() }
    }
}

/// A curvature that a drive multiplies.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Curl {
    /// Turn of the fibre's direction over a metre of it [degrees/m]; a bend of less than 90 degrees from vertex to
    /// vertex.
    pub degrees_per_metre: f64,
    /// Axis about which it turns, right-handed along the fibre; of any length but zero, model frame.
    pub axis: [f64; 3],
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

/// The pull of a muscle: `force max(0, 1 - q²)`, `q = (s - 1) / width`, s its length over the drawn one.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct MusclePull {
    /// Greatest pull of the fibre as a whole, before its volume fraction is taken of it [N].
    pub force: f64,
    /// Share by which it may be shorter or longer than it was drawn before it no longer pulls, up to 1.
    #[serde(default = "usual_width")]
    pub width: f64,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

/// A twist that a drive multiplies.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct TwistRate {
    /// Twist over a metre of the fibre, right-handed along it [degrees/m]; less than 180 degrees from vertex to vertex.
    pub degrees_per_metre: f64,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

fn usual_width() -> f64 {
    0.5
}
