//! Keys that are dragged, and boxes that are drawn around keys.

use super::actions::{counted, named};
use super::keys::{moved_keys, on_frame};
use super::value_scale::{ValueScale, round};
use crate::scene::{Drivable, Drive, DriveKeys};
use crate::ui::context::{Context, Step};
use crate::ui::timescale::TimeScale;
use egui::{Pos2, Rect};

/// A way of the pointer along an axis that is none yet, so that a key that is moved in time keeps its value, and the
/// other way round [points].
const STILL: f32 = 4.0;

/// Keys that are dragged.
pub(super) struct KeyDrag {
    /// Where the pointer was pressed.
    origin: Pos2,
    gesture: u64,
    scale: TimeScale,
    /// Time of the key that was grabbed [s].
    time: f64,
    lanes: Vec<DraggedLane>,
}

/// What is dragged of one drive.
struct DraggedLane {
    of: Drivable,
    /// As they were when the drag began.
    keys: DriveKeys,
    which: Vec<usize>,
    values: ValueScale,
    limits: [f64; 2],
}

impl KeyDrag {
    /// Takes hold of the selected keys at the one at `time` [s]; `lanes` are those that are shown.
    pub(super) fn begin(
        cx: &mut Context,
        origin: Pos2,
        time: f64,
        scale: &TimeScale,
        lanes: &[(Drivable, ValueScale)],
    ) -> Self {
        let gesture = cx.begin_gesture();
        let scene = cx.scene();
        let dragged = lanes.iter().filter_map(|(of, values)| match of.drive(scene) {
            Some(Drive::Keyframes(keys)) => {
                let limits = values.within(of.limits(scene));
                Some(DraggedLane { of: of.clone(), keys: keys.clone(), which: cx.keys.of(of), values: *values, limits })
            }
            _ => None,
        });
        let lanes = dragged.filter(|lane| !lane.which.is_empty()).collect();
        Self { origin, gesture, scale: *scale, time, lanes }
    }

    /// The scale of time as it was when the drag began: what is dragged does not change it.
    pub(super) fn scale(&self) -> TimeScale {
        self.scale
    }

    /// Values over a lane as they were then.
    pub(super) fn values(&self, of: &Drivable) -> Option<ValueScale> {
        self.lanes.iter().find(|lane| lane.of == *of).map(|lane| lane.values)
    }

    /// Moves the keys to where the pointer is: onto frames and round values, unless `freely`.
    pub(super) fn follow(&self, cx: &mut Context, pointer: Pos2, freely: bool) {
        let frame = cx.scene().time.frame_seconds();
        let way = pointer - self.origin;
        let mut later = self.scale.time(pointer.x) - self.scale.time(self.origin.x);
        if !freely {
            let aim = on_frame(self.time + later, frame);
            later = if way.x.abs() < STILL { 0.0 } else { aim - self.time };
        }
        let mut drives = Vec::new();
        let mut chosen = Vec::new();
        for lane in &self.lanes {
            let mut higher = lane.values.value(pointer.y) - lane.values.value(self.origin.y);
            if !freely {
                higher = if way.y.abs() < STILL { 0.0 } else { round(higher, lane.values.step()) };
            }
            let (mut keys, which) = moved_keys(&lane.keys, &lane.which, [later, higher], lane.limits, frame);
            // Sums of round numbers are not always written as such.
            for &index in which.iter().filter(|_| !freely && higher != 0.0) {
                keys.keys[index].value = round(keys.keys[index].value, 1e-3 * lane.values.step());
            }
            chosen.extend(which.into_iter().map(|index| (lane.of.clone(), index)));
            drives.push((lane.of.clone(), Some(Drive::from(keys))));
        }
        let before = cx.scene().clone();
        cx.edit(&named(&counted("Move", chosen.len()), drives), Step::Of(self.gesture));
        if !std::sync::Arc::ptr_eq(&before, cx.scene()) {
            cx.keys.set(chosen);
        }
    }

    /// Puts the keys back where they were.
    pub(super) fn abandon(self, cx: &mut Context) {
        cx.abandon(self.gesture);
        cx.keys.set(self.lanes.iter().flat_map(|lane| lane.which.iter().map(|k| (lane.of.clone(), *k))).collect());
    }
}

/// A box that is drawn around keys.
#[derive(Clone, Copy, Debug)]
pub(super) struct KeyBox {
    /// Where the pointer was pressed.
    pub(super) origin: Pos2,
    /// Whether what is in it joins what is selected.
    pub(super) adding: bool,
}

impl KeyBox {
    /// The box up to where the pointer is.
    pub(super) fn reach(&self, pointer: Pos2) -> Rect {
        Rect::from_two_pos(self.origin, pointer)
    }
}
