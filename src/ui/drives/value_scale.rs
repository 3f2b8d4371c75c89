//! Values over the height of a lane, and how near to what stands there the pointer hits it.

use crate::scene::Drive;
use egui::Rangef;

/// From how far a key or the end of a handle is hit [points].
pub(super) const REACH: f32 = 8.0;
/// Room above and below the values of a drive, as a share of them.
const ROOM: f64 = 0.16;

/// Values over the height of a lane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct ValueScale {
    least: f64,
    most: f64,
    places: Rangef,
}

impl ValueScale {
    /// Room for all that a drive does, and for 0 and 1.
    pub(super) fn of(drive: &Drive, places: Rangef) -> Self {
        let [least, most] = drive.range().unwrap_or([0.0, 1.0]);
        let [least, most] = [least.min(0.0), most.max(1.0)];
        let room = ROOM * (most - least);
        Self { least: least - room, most: most + room, places }
    }

    /// Where a value is [points].
    pub(super) fn place(&self, value: f64) -> f32 {
        self.places.max - ((value - self.least) / (self.most - self.least)) as f32 * self.places.span()
    }

    /// The value at a place.
    pub(super) fn value(&self, place: f32) -> f64 {
        self.least + f64::from((self.places.max - place) / self.places.span()) * (self.most - self.least)
    }

    /// Steps in which values are chosen by the pointer: round, and a hundredth of what is shown or less.
    pub(super) fn step(&self) -> f64 {
        10f64.powf(((self.most - self.least) / 100.0).log10().floor())
    }

    /// What is shown of these limits.
    pub(super) fn within(&self, [least, most]: [f64; 2]) -> [f64; 2] {
        [least.max(self.least), most.min(self.most)]
    }
}

/// A round value near to one, in steps of a power of ten, without digits that are none.
pub(super) fn round(value: f64, step: f64) -> f64 {
    let digits = (-step.log10()).round().max(0.0) as usize;
    format!("{:.digits$}", (value / step).round() * step).parse().unwrap_or(value)
}
