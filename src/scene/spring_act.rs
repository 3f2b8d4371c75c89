//! Springs of a two-layer body that act.

use super::{Drive, Extra};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Springs of a two-layer body that want to be shorter by a share of their rest length times a drive.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ActiveSprings {
    /// Stable identifier, unique among those of the body.
    pub id: String,
    /// Region in which both ends of a spring lie; of springs that two of these have, the later one counts.
    #[serde(default = "everything")]
    pub region: String,
    /// Which of its springs.
    #[serde(default)]
    pub springs: SpringChoice,
    /// Share by which they want to be shorter where the drive is 1; with the drive from -0.5 to 0.8.
    pub contract: f64,
    /// What it is multiplied by; a wave with a wavelength is refused, as it runs along fibres.
    pub drive: Drive,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

impl ActiveSprings {
    /// All springs of a region, shorter by a share times a drive.
    pub fn new(id: impl Into<String>, region: impl Into<String>, contract: f64, drive: impl Into<Drive>) -> Self {
        let (id, region, drive) = (id.into(), region.into(), drive.into());
        Self { id, region, springs: SpringChoice::default(), contract, drive, extra: Extra::new() }
    }

    /// Only those of a kind.
    #[must_use]
    pub fn only(self, springs: SpringChoice) -> Self {
        Self { springs, ..self }
    }
}

/// Kinds of springs of a two-layer body.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum SpringChoice {
    /// All of them.
    #[default]
    All,
    /// Those along the edges of both layers.
    Structural,
    /// Those from a vertex of the inner layer to the same one of the outer layer.
    Radius,
    /// Those that cross between the layers.
    Shear,
}

fn everything() -> String {
    "everything".to_owned()
}
