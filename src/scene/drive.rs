//! Drives: numbers that change in time.

use super::Extra;
use super::extra::is_zero;
use crate::geometry::hermite::{Hermite, range_of};
pub(super) use crate::sketch::pattern::CONTRACTION;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A number that changes in time, such as the share of its contraction that a fibre shows. What it moves is multiplied
/// by it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Drive {
    /// The same at all times.
    Constant(f64),
    /// From key to key.
    Keyframes(DriveKeys),
    /// Up and down, and along a fibre where it has a wavelength.
    Wave(Wave),
    /// The one of this identifier among the body's drives.
    Shared(String),
}

impl From<f64> for Drive {
    fn from(value: f64) -> Self {
        Self::Constant(value)
    }
}

impl From<DriveKeys> for Drive {
    fn from(keys: DriveKeys) -> Self {
        Self::Keyframes(keys)
    }
}

impl From<Wave> for Drive {
    fn from(wave: Wave) -> Self {
        Self::Wave(wave)
    }
}

impl Drive {
    /// The drive that is meant: itself, or the one of `shared` that it names. None where none has that name, or the one
    /// that has it only names another.
    pub fn resolved<'a>(&'a self, shared: &'a [SharedDrive]) -> Option<&'a Self> {
        let Self::Shared(id) = self else { return Some(self) };
        let named = &shared.iter().find(|one| one.id == *id)?.drive;
        if matches!(named, Self::Shared(_)) { None } else { Some(named) }
    }

    /// The wave that it is, or is otherwise.
    pub(crate) fn wave(&self) -> Option<&Wave> {
        match self {
            Self::Wave(wave) => Some(wave),
            Self::Keyframes(keys) => keys.otherwise.as_ref()?.drive.wave(),
            Self::Constant(_) | Self::Shared(_) => None,
        }
    }

    /// [`Self::wave`], to be changed.
    pub(crate) fn wave_mut(&mut self) -> Option<&mut Wave> {
        match self {
            Self::Wave(wave) => Some(wave),
            Self::Keyframes(keys) => keys.otherwise.as_mut()?.drive.wave_mut(),
            Self::Constant(_) | Self::Shared(_) => None,
        }
    }

    /// The least and the greatest value that it takes; none of one that names another.
    pub fn range(&self) -> Option<[f64; 2]> {
        match self {
            Self::Constant(value) => Some([*value; 2]),
            Self::Keyframes(keys) => Some(keys.range()),
            // It rises from zero.
            Self::Wave(Wave { mean, amplitude, .. }) => {
                let reach = amplitude.abs();
                Some([(mean - reach).min(0.0), (mean + reach).max(0.0)])
            }
            Self::Shared(_) => None,
        }
    }
}

/// A drive that several things of a body follow.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SharedDrive {
    /// Stable identifier, unique among the body's drives.
    pub id: String,
    /// Name a person reads.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub name: String,
    /// What it is; one that names another is refused.
    pub drive: Drive,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

impl SharedDrive {
    /// A drive under an identifier.
    pub fn new(id: impl Into<String>, drive: impl Into<Drive>) -> Self {
        Self { id: id.into(), name: String::new(), drive: drive.into(), extra: Extra::new() }
    }
}

/// Values at times. Before the first it is the first, or what it is otherwise.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct DriveKeys {
    /// In the order of time.
    pub keys: Vec<DriveKey>,
    /// From one key to the next.
    #[serde(default)]
    pub between: Interpolation,
    /// From the last key on.
    #[serde(default)]
    pub after: AfterLast,
    /// What it is otherwise: before the first key, where that is not its value.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub otherwise: Option<Otherwise>,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

impl DriveKeys {
    /// Values at times [s], smoothly from one to the next, the last one held.
    pub fn new(keys: impl IntoIterator<Item = (f64, f64)>) -> Self {
        let keys = keys.into_iter().map(|(time, value)| DriveKey::new(time, value)).collect();
        let (between, after) = (Interpolation::default(), AfterLast::default());
        Self { keys, between, after, otherwise: None, extra: Extra::new() }
    }

    /// On top of another drive, to which they go back from the last key in `back_in` [s], if ever.
    #[must_use]
    pub fn over(self, drive: impl Into<Drive>, back_in: Option<f64>) -> Self {
        Self { otherwise: Some(Otherwise { drive: Box::new(drive.into()), back_in, extra: Extra::new() }), ..self }
    }

    /// The least and the greatest value that is reached.
    pub fn range(&self) -> [f64; 2] {
        let otherwise = self.otherwise.as_ref().and_then(|otherwise| otherwise.drive.range());
        let [least, greatest] = self.range_of_keys();
        otherwise.map_or([least, greatest], |[low, high]| [least.min(low), greatest.max(high)])
    }

    fn range_of_keys(&self) -> [f64; 2] {
        let smooth = self.keys.windows(2).filter(|_| self.between == Interpolation::Smooth);
        let cubic = |pair: &[DriveKey]| {
            let ends = [&pair[0], &pair[1]];
            let span = ends[1].time - ends[0].time;
            Hermite { span, values: ends.map(|key| key.value), slopes: ends.map(|key| key.slope) }
        };
        range_of(self.keys.iter().map(|key| key.value), smooth.map(cubic))
    }
}

/// What a drive with keys is otherwise: as a shared drive was by itself until a hand took it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Otherwise {
    /// What it is before the first key; one that names another is refused.
    pub drive: Box<Drive>,
    /// In which time it goes back to that from the last key on [s]; it does not where there is none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub back_in: Option<f64>,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

/// A value at a time.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct DriveKey {
    /// Time [s].
    pub time: f64,
    /// Value.
    pub value: f64,
    /// Rate with which a smooth course goes through it [1/s]; others take no notice of it.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub slope: f64,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

impl DriveKey {
    /// A value at a time [s] at which a smooth course comes to rest.
    pub fn new(time: f64, value: f64) -> Self {
        Self { time, value, slope: 0.0, extra: Extra::new() }
    }
}

/// How a drive goes from one key to the next.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Interpolation {
    /// It keeps its value up to the next key.
    Stepped,
    /// At a steady rate.
    Linear,
    /// By a cubic from slope to slope: from rest to rest (3 s² - 2 s³) where none is given.
    #[default]
    Smooth,
}

/// What a drive does from its last key on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum AfterLast {
    /// It keeps the last value.
    #[default]
    Hold,
    /// It begins again with the first key, over and over.
    Repeat,
    /// It goes back to the first key and comes again, over and over.
    Mirror,
}

/// `mean - amplitude cos(2 pi (s / wavelength - (t - start) / period) + phase)`, s the way along the fibre; zero before
/// the start, from which it rises within the first period.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Wave {
    /// What it swings around; from 0 to 1 unless given otherwise.
    #[serde(default = "half")]
    pub mean: f64,
    /// How far it swings to either side.
    #[serde(default = "half")]
    pub amplitude: f64,
    /// Time of one swing [s].
    pub period: f64,
    /// How far ahead it is along the fibre, and so how late in time [degrees].
    #[serde(default)]
    pub phase_degrees: f64,
    /// Length of the wave along the fibre from its first point on [m]: it runs that way, a negative one the other.
    /// Without one all of the fibre swings at once, as everything does that is no fibre.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub wavelength: Option<f64>,
    /// When it starts [s].
    #[serde(default)]
    pub start: f64,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

impl Wave {
    /// From 0 to 1 and back in `period` [s], from the start on.
    pub fn new(period: f64) -> Self {
        Self {
            mean: half(),
            amplitude: half(),
            period,
            phase_degrees: 0.0,
            wavelength: None,
            start: 0.0,
            extra: Extra::new(),
        }
    }

    /// Running along the fibre with this wavelength [m]; the other way where it is negative.
    #[must_use]
    pub fn with_wavelength(self, wavelength: f64) -> Self {
        Self { wavelength: Some(wavelength), ..self }
    }

    /// Behind by this angle [degrees].
    #[must_use]
    pub fn with_phase(self, phase_degrees: f64) -> Self {
        Self { phase_degrees, ..self }
    }
}

fn half() -> f64 {
    0.5
}
