//! The room: floor, walls and ceiling.

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
    /// What friction does below Coulomb's limit, between bodies and on panels too.
    pub sticking: Sticking,
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
            sticking: Sticking::default(),
            contact_damping: 0.0,
            extra: Extra::new(),
        }
    }
}

/// What friction does below Coulomb's limit.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Sticking {
    /// A damped spring along the surface, tied where a particle touches first and dragged along at the limit: what lies
    /// on a slope below the angle of friction stays.
    #[default]
    Spring,
    /// A damper alone: what is pushed creeps. The formulation of the figures that come with the program.
    Damper,
}
