//! Regions of a body with a matrix of their own.

use super::Extra;
use super::extra::is_zero;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// What the matrix of one region is made of, where it is another than the body's: a soft belly, a hard shell. Poisson's
/// ratio and what does not spring back are the body's. Of regions that overlap the later one counts.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct RegionMaterial {
    /// The region.
    pub region: String,
    /// Young's modulus [Pa]; the body's unless given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub young_modulus: Option<f64>,
    /// Density [kg/m³]; the body's unless given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub density: Option<f64>,
    /// Radial damping between neighbouring particles [1/s]; the body's unless given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub damping: Option<f64>,
    /// Over what distance from the region its material passes into the body's [m]; Young's modulus by equal factors,
    /// all else evenly. At once unless given.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub transition: f64,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

impl RegionMaterial {
    /// A region's own material, as the body's in everything as yet.
    pub fn of(region: impl Into<String>) -> Self {
        let region = region.into();
        Self { region, young_modulus: None, density: None, damping: None, transition: 0.0, extra: Extra::new() }
    }
}
