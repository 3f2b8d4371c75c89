//! The handles of selected keys: how steeply a smooth course goes through them.

use super::actions::named;
use super::value_scale::{REACH, ValueScale, round};
use crate::scene::{Drivable, Drive, DriveKeys, Interpolation};
use crate::ui::context::{Context, Step};
use crate::ui::timescale::TimeScale;
use egui::{Color32, Painter, Pos2, Stroke, Vec2};

/// From a key to either end of its handle, and half the size of an end [points].
const LENGTH: f32 = 26.0;
const END: f32 = 2.5;
/// A handle nearer to level than this is level [points].
const LEVEL: f32 = 3.0;
/// In so many steps a slope is made less, where it leads too far.
const STEPS: u32 = 50;
/// A handle is never steeper than this [points to the side].
const ASIDE: f32 = 2.0;

/// The handle of a key.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Handle {
    /// Number of its key.
    pub(super) key: usize,
    /// Where the key is.
    at: Pos2,
    /// From there to its later end.
    way: Vec2,
}

/// The handles of these keys of a drive; none unless its course is smooth.
pub(super) fn handles(keys: &DriveKeys, which: &[usize], scale: &TimeScale, values: &ValueScale) -> Vec<Handle> {
    let smooth = which.iter().filter(|_| keys.between == Interpolation::Smooth && keys.keys.len() > 1);
    let handle = |&index: &usize| {
        let key = keys.keys.get(index)?;
        let place = |time: f64, value: f64| Pos2::new(scale.place(time), values.place(value));
        let at = place(key.time, key.value);
        // A second away it has risen by its slope.
        let way = place(key.time + 1.0, key.value + key.slope) - at;
        Some(Handle { key: index, at, way: LENGTH * way.normalized() })
    };
    smooth.filter_map(handle).collect()
}

impl Handle {
    /// The end that is hit, if one is: 1 for the later one, -1 for the other.
    pub(super) fn hit(&self, pointer: Pos2) -> Option<f32> {
        [1.0, -1.0].into_iter().find(|side| pointer.distance(self.at + *side * self.way) <= REACH)
    }

    pub(super) fn paint(&self, painter: &Painter, colour: Color32) {
        let [from, to] = [self.at - self.way, self.at + self.way];
        painter.line_segment([from, to], Stroke::new(1.0, colour));
        for end in [from, to] {
            painter.circle_filled(end, END, colour);
        }
    }
}

/// A handle that is dragged by one of its ends.
pub(super) struct HandleDrag {
    of: Drivable,
    keys: DriveKeys,
    handle: Handle,
    side: f32,
    gesture: u64,
    scale: TimeScale,
    values: ValueScale,
}

impl HandleDrag {
    /// Takes hold of an end of a handle of a drive's key.
    pub(super) fn begin(
        cx: &mut Context,
        of: &Drivable,
        (handle, side): (Handle, f32),
        (scale, values): (&TimeScale, &ValueScale),
    ) -> Option<Self> {
        let Some(Drive::Keyframes(keys)) = of.drive(cx.scene()) else { return None };
        let keys = keys.clone();
        let gesture = cx.begin_gesture();
        Some(Self { of: of.clone(), keys, handle, side, gesture, scale: *scale, values: *values })
    }

    /// The scale of time as it was when the drag began.
    pub(super) fn scale(&self) -> TimeScale {
        self.scale
    }

    /// Values over the lane as they were then.
    pub(super) fn values(&self, of: &Drivable) -> Option<ValueScale> {
        (self.of == *of).then_some(self.values)
    }

    /// Turns the handle to where the pointer is: level where it nearly is, and by round numbers, unless `freely`.
    pub(super) fn follow(&self, cx: &mut Context, pointer: Pos2, freely: bool) {
        let way = self.side * (pointer - self.handle.at);
        let end = self.handle.at + Vec2::new(way.x.max(ASIDE), way.y);
        let rise = self.values.value(end.y) - self.values.value(self.handle.at.y);
        let mut slope = rise / (self.scale.time(end.x) - self.scale.time(self.handle.at.x));
        if !freely {
            slope = if way.y.abs() < LEVEL { 0.0 } else { two_figures(slope) };
        }
        let [least, most] = self.of.limits(cx.scene());
        let turned = |slope: f64| {
            let mut keys = self.keys.clone();
            keys.keys[self.handle.key].slope = slope;
            keys
        };
        // No steeper than what is driven bears.
        let bears = |keys: &DriveKeys| {
            let [low, high] = keys.range();
            low >= least && high <= most
        };
        let Some(keys) = (0..=STEPS).map(|k| turned(slope * f64::from(STEPS - k) / f64::from(STEPS))).find(bears)
        else {
            return;
        };
        cx.edit(&named("Turn handle", vec![(self.of.clone(), Some(keys.into()))]), Step::Of(self.gesture));
    }

    /// Turns it back.
    pub(super) fn abandon(self, cx: &mut Context) {
        cx.abandon(self.gesture);
    }
}

fn two_figures(value: f64) -> f64 {
    if value == 0.0 { 0.0 } else { round(value, 10f64.powf(value.abs().log10().floor() - 1.0)) }
}
