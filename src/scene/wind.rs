//! The air, or the water, that bodies move in.

use super::{Drive, Extra};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Air or water that moves as one and pushes on the surfaces of solid bodies across them: at rest it is what a tail
/// swims in, in motion what bends a leaf.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct Wind {
    /// Velocity [m/s], world axes.
    pub velocity: [f64; 3],
    /// What the velocity is multiplied by; by 1 unless given. None that is shared, which only bodies have.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub drive: Option<Drive>,
    /// Density [kg/m³]; that of air unless given.
    pub density: f64,
    /// Drag coefficient of a plate across the flow, half of it for each side.
    pub drag: f64,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

impl Default for Wind {
    fn default() -> Self {
        Self { velocity: [0.0; 3], drive: None, density: 1.2, drag: 1.1, extra: Extra::new() }
    }
}

impl Wind {
    /// Air of this velocity [m/s, world axes].
    pub fn new(velocity: impl Into<[f64; 3]>) -> Self {
        Self { velocity: velocity.into(), ..Self::default() }
    }

    /// Water at rest.
    pub fn water() -> Self {
        Self { density: 1000.0, ..Self::default() }
    }

    /// Its velocity times a drive.
    #[must_use]
    pub fn with_drive(self, drive: impl Into<Drive>) -> Self {
        Self { drive: Some(drive.into()), ..self }
    }
}
