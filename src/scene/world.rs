//! What surrounds the bodies: room, panels, time.

use super::Extra;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Axis-aligned floor, walls and ceiling; each is there only when its coordinate is given.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct Room {
    /// Height of the floor [m], world Y.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub floor: Option<f64>,
    /// Height of the ceiling [m], world Y.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ceiling: Option<f64>,
    /// Wall towards negative X [m].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub x_min: Option<f64>,
    /// Wall towards positive X [m].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub x_max: Option<f64>,
    /// Wall towards negative Z [m].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub z_min: Option<f64>,
    /// Wall towards positive Z [m].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub z_max: Option<f64>,
    /// Coulomb friction coefficient of floor, walls and ceiling.
    pub friction: f64,
    /// Share of critical damping in the normal direction of a contact: 0 bounces fully, 1 hardly at all.
    pub contact_damping: f64,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

impl Default for Room {
    fn default() -> Self {
        Self {
            floor: None,
            ceiling: None,
            x_min: None,
            x_max: None,
            z_min: None,
            z_max: None,
            friction: 0.4,
            contact_damping: 0.0,
            extra: Extra::new(),
        }
    }
}

/// A rigid horizontal panel that moves up and down only and presses on what lies below it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Panel {
    /// Stable identifier, unique among the panels.
    pub id: String,
    /// Name a person reads.
    #[serde(default)]
    pub name: String,
    /// Height of its underside at the start [m], world Y.
    pub height: f64,
    /// Centre in the world's X and Z [m].
    #[serde(default)]
    pub center: [f64; 2],
    /// Extent along X and Z [m].
    pub size: [f64; 2],
    /// Mass [kg]; it matters only when the panel falls.
    #[serde(default = "one")]
    pub mass: f64,
    /// Coulomb friction coefficient of its underside.
    #[serde(default = "default_friction")]
    pub friction: f64,
    /// How it moves.
    pub motion: PanelMotion,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

/// How a panel moves.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum PanelMotion {
    /// Falls under gravity from rest and is held up by what it lands on.
    Falls,
    /// Follows these heights, eased smoothly from one to the next; before the first and after the last it rests.
    Driven(Vec<HeightKey>),
}

/// Height of a driven panel at one time.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct HeightKey {
    /// Time [s].
    pub time: f64,
    /// Height of the underside [m].
    pub height: f64,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

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

fn one() -> f64 {
    1.0
}

fn default_friction() -> f64 {
    0.4
}
