//! Frame rate, length and time step.

use super::Extra;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Frame rate, length and time step.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct Time {
    /// Frames for each simulated second under the automatic time step.
    pub frames_per_second: f64,
    /// How long the scene runs unless asked otherwise [s].
    pub duration: f64,
    /// How the time step is chosen.
    pub step: TimeStep,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

impl Time {
    /// Length of a frame [s].
    pub fn frame_seconds(&self) -> f64 {
        match &self.step {
            TimeStep::Automatic(_) => 1.0 / self.frames_per_second,
            TimeStep::Manual(manual) => manual.dt * f64::from(manual.substeps_per_frame),
        }
    }
}

impl Default for Time {
    fn default() -> Self {
        Self { frames_per_second: 60.0, duration: 1.0, step: TimeStep::default(), extra: Extra::new() }
    }
}

/// How the time step is chosen.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum TimeStep {
    /// Sub-steps of a frame follow from the stable step that is measured at load.
    Automatic(Automatic),
    /// A step given by hand; one beyond the stable step is allowed and warned of.
    Manual(Manual),
}

impl TimeStep {
    /// A step of `dt` [s], so many to a frame.
    pub fn manual(dt: f64, substeps_per_frame: u32) -> Self {
        Self::Manual(Manual { dt, substeps_per_frame, extra: Extra::new() })
    }

    /// This share of the stable step, above 0 and up to 1.
    pub fn automatic(safety: f64) -> Self {
        Self::Automatic(Automatic { safety, extra: Extra::new() })
    }
}

impl Default for TimeStep {
    fn default() -> Self {
        Self::Automatic(Automatic::default())
    }
}

/// The automatic time step.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct Automatic {
    /// Share of the stable step that is used, above 0 and up to 1.
    pub safety: f64,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

impl Default for Automatic {
    fn default() -> Self {
        Self { safety: 0.6, extra: Extra::new() }
    }
}

/// A time step given by hand, as in the fibre paper ("simulate 50 to 100 times between rendering frames").
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Manual {
    /// Time step [s].
    pub dt: f64,
    /// Sub-steps from one frame to the next; a frame then lasts `dt` times this.
    pub substeps_per_frame: u32,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}
