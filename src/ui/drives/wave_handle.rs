//! The handle of a wave, on a crest of it: how far it swings, and how fast.

use super::actions::named;
use super::keys::on_frame;
use super::value_scale::{REACH, ValueScale, round};
use crate::scene::{Drivable, Drive, Wave};
use crate::ui::context::{Context, Step};
use crate::ui::timescale::TimeScale;
use egui::{Color32, Painter, Pos2, Stroke};

/// Half the size of the handle [points].
const HALF: f32 = 4.5;
/// A way of the pointer along an axis that is none yet, so that a wave of another height keeps its period, and the
/// other way round [points].
const STILL: f32 = 4.0;

/// The handle of a wave.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct WaveHandle {
    /// On the first crest after it has risen.
    at: Pos2,
    /// So many periods after its start.
    periods: f64,
}

impl WaveHandle {
    /// The handle of a wave over a lane.
    pub(super) fn of(wave: &Wave, scale: &TimeScale, values: &ValueScale) -> Self {
        let periods = 1.0 + (wave.phase_degrees / 360.0 - 0.5).rem_euclid(1.0);
        let (time, value) = (wave.start + periods * wave.period, wave.mean + wave.amplitude);
        Self { at: Pos2::new(scale.place(time), values.place(value)), periods }
    }

    pub(super) fn is_hit(&self, pointer: Pos2) -> bool {
        pointer.distance(self.at) <= REACH
    }

    pub(super) fn paint(&self, painter: &Painter, fill: Color32, line: Color32) {
        painter.circle(self.at, HALF, fill, Stroke::new(1.0, line));
    }
}

/// A handle of a wave that is dragged.
pub(super) struct WaveDrag {
    of: Drivable,
    wave: Wave,
    handle: WaveHandle,
    origin: Pos2,
    gesture: u64,
    scale: TimeScale,
    values: ValueScale,
    limits: [f64; 2],
}

impl WaveDrag {
    /// Takes hold of the handle of a drive that is a wave.
    pub(super) fn begin(
        cx: &mut Context,
        of: &Drivable,
        (handle, origin): (WaveHandle, Pos2),
        (scale, values): (&TimeScale, &ValueScale),
    ) -> Option<Self> {
        let Some(Drive::Wave(wave)) = of.drive(cx.scene()) else { return None };
        let wave = wave.clone();
        let limits = values.within(of.limits(cx.scene()));
        let gesture = cx.begin_gesture();
        Some(Self { of: of.clone(), wave, handle, origin, gesture, scale: *scale, values: *values, limits })
    }

    /// The scale of time as it was when the drag began.
    pub(super) fn scale(&self) -> TimeScale {
        self.scale
    }

    /// Values over the lane as they were then.
    pub(super) fn values(&self, of: &Drivable) -> Option<ValueScale> {
        (self.of == *of).then_some(self.values)
    }

    /// Brings the crest to where the pointer is: by periods of whole frames and round amplitudes, unless `freely`.
    pub(super) fn follow(&self, cx: &mut Context, pointer: Pos2, freely: bool) {
        let (before, way) = (&self.wave, pointer - self.origin);
        let mut wave = before.clone();
        let frame = cx.scene().time.frame_seconds();
        if freely || way.x.abs() >= STILL {
            let period = (self.scale.time(self.handle.at.x + way.x) - before.start) / self.handle.periods;
            // Two frames at the least: with fewer there is no swing to be seen.
            wave.period = if freely { period } else { on_frame(period, frame) }.max(2.0 * frame);
        }
        if freely || way.y.abs() >= STILL {
            let higher = self.values.value(self.handle.at.y + way.y) - self.values.value(self.handle.at.y);
            let amplitude = before.amplitude + higher;
            let amplitude = if freely { amplitude } else { round(amplitude, self.values.step()) };
            let [least, most] = self.limits;
            let room = (most - before.mean).min(before.mean - least).max(before.amplitude.abs());
            // It does not turn upside down.
            wave.amplitude =
                if before.amplitude < 0.0 { amplitude.clamp(-room, 0.0) } else { amplitude.clamp(0.0, room) };
        }
        cx.edit(&named("Change wave", vec![(self.of.clone(), Some(wave.into()))]), Step::Of(self.gesture));
    }

    /// Puts it back.
    pub(super) fn abandon(self, cx: &mut Context) {
        cx.abandon(self.gesture);
    }
}
