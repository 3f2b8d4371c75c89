//! Panels that fall on the bodies or are driven.

use super::{Drive, Extra};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

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

impl Panel {
    /// Thickness of a panel that is shown, as a share of its shorter side: the underside alone presses.
    pub(crate) const THICKNESS: f64 = 0.06;

    /// A panel of these extents along X and Z [m] whose underside is at a height [m, world Y] when it begins to fall.
    /// It is of 1 kg, with a friction coefficient of 0.4, and centred above the world's origin.
    pub fn falling(id: impl Into<String>, height: f64, size: impl Into<[f64; 2]>) -> Self {
        Self {
            id: id.into(),
            name: String::new(),
            height,
            center: [0.0; 2],
            size: size.into(),
            mass: one(),
            friction: default_friction(),
            motion: PanelMotion::Falls,
            extra: Extra::new(),
        }
    }

    /// A panel whose underside follows heights [m, world Y] at times [s], else as [`Panel::falling`].
    pub fn driven(
        id: impl Into<String>,
        size: impl Into<[f64; 2]>,
        heights: impl IntoIterator<Item = (f64, f64)>,
    ) -> Self {
        let keys: Vec<_> = heights.into_iter().map(|(time, height)| HeightKey::new(time, height)).collect();
        let height = keys.first().map_or(0.0, |key| key.height);
        Self { motion: PanelMotion::Driven(keys), ..Self::falling(id, height, size) }
    }
}

/// How a panel moves.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum PanelMotion {
    /// Falls under gravity from rest and is held up by what it lands on.
    Falls,
    /// Follows these heights, eased smoothly from one to the next; before the first and after the last it rests.
    Driven(Vec<HeightKey>),
    /// Stands above or below its height by a distance times a drive.
    Follows(PanelDrive),
}

/// What a panel follows.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct PanelDrive {
    /// What the distance is multiplied by; none that is shared, which only bodies have, and no wavelength.
    pub drive: Drive,
    /// How far above its height it stands where the drive is 1 [m].
    pub travel: f64,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

impl PanelDrive {
    /// By so many metres upwards times a drive.
    pub fn new(drive: impl Into<Drive>, travel: f64) -> Self {
        Self { drive: drive.into(), travel, extra: Extra::new() }
    }
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

impl HeightKey {
    /// A height of the underside [m] at a time [s].
    pub fn new(time: f64, height: f64) -> Self {
        Self { time, height, extra: Extra::new() }
    }
}

fn one() -> f64 {
    1.0
}

fn default_friction() -> f64 {
    0.4
}
