//! How a body starts.

use super::Extra;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Motion and deformation at the start.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct Initial {
    /// Velocity [m/s], world axes.
    pub velocity: [f64; 3],
    /// Angular velocity about the centre of mass [degrees/s], world axes.
    pub angular_velocity: [f64; 3],
    /// Deformation gradient about the model's centre of mass, row by row; the identity is the rest shape.
    pub deformation: [[f64; 3]; 3],
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

impl Default for Initial {
    fn default() -> Self {
        Self {
            velocity: [0.0; 3],
            angular_velocity: [0.0; 3],
            deformation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
            extra: Extra::new(),
        }
    }
}

/// An impulse shared by the particles of a region at the start, by mass.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Impulse {
    /// Region that is struck.
    pub region: String,
    /// Impulse on the whole region [N s], world axes.
    pub impulse: [f64; 3],
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

impl Impulse {
    /// An impulse [N s, world axes] on a whole region.
    pub fn new(region: impl Into<String>, impulse: impl Into<[f64; 3]>) -> Self {
        Self { region: region.into(), impulse: impulse.into(), extra: Extra::new() }
    }
}
