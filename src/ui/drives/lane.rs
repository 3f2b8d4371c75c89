//! One lane: the course of a drive over the time that the timeline shows, with its keys.

use super::handle::handles;
use super::key_button::diamond;
use super::keys::value_of;
use super::value_scale::ValueScale;
use super::wave_handle::WaveHandle;
use crate::bake::solver_drive;
use crate::scene::{Drivable, Drive, DriveKeys, Scene};
use crate::text::number::compact;
use crate::ui::context::Context;
use crate::ui::theme;
use crate::ui::timescale::TimeScale;
use egui::{Align2, Color32, FontId, Pos2, Rect, Shape, Stroke, Ui};

/// Heights of a lane with a drive of its own, and of one that follows another [points].
pub(super) const TALL: f32 = 56.0;
pub(super) const LOW: f32 = 24.0;
/// Half the diagonal of a key [points].
const KEY: f32 = 5.0;

/// Where the keys of a drive lie.
pub(super) fn key_places(keys: &DriveKeys, scale: &TimeScale, values: &ValueScale) -> Vec<Pos2> {
    keys.keys.iter().map(|key| Pos2::new(scale.place(key.time), values.place(key.value))).collect()
}

/// Paints the course of a drive, its keys and the time that is shown [s]; faintly where it follows another one.
pub(super) fn paint_lane(
    ui: &Ui,
    cx: &Context,
    (of, drive): (&Drivable, &Drive),
    place: Rect,
    (scale, values): (&TimeScale, &ValueScale),
    shown: f64,
) {
    let painter = ui.painter_at(place);
    let visuals = ui.visuals();
    let accent = theme::color(cx.tone.pictures().accent);
    let ink = visuals.weak_text_color();
    painter.rect_filled(place, 3.0, visuals.extreme_bg_color);
    let follows = matches!(of.drive(cx.scene()), Some(Drive::Shared(_)));
    for level in [0.0, 1.0] {
        let y = values.place(level);
        painter.hline(place.x_range(), y, Stroke::new(1.0, ink.gamma_multiply(0.25)));
        if !follows {
            let at = Pos2::new(place.right() - 3.0, y);
            painter.text(at, Align2::RIGHT_CENTER, compact(level), FontId::proportional(9.0), ink.gamma_multiply(0.8));
        }
    }
    for (time, _) in scale.ticks() {
        painter.vline(scale.place(time), place.y_range(), Stroke::new(1.0, ink.gamma_multiply(0.15)));
    }
    let line = if follows { ink } else { visuals.text_color() };
    painter.add(Shape::line(course(drive, place, scale, values), Stroke::new(1.5, line)));
    painter.vline(scale.place(shown), place.y_range(), Stroke::new(1.5, accent));
    if follows {
        return;
    }
    match drive {
        Drive::Keyframes(keys) => {
            // Those at the ends are whole.
            let painter = ui.painter_at(place.expand2([KEY + 1.0, 0.0].into()));
            for handle in handles(keys, &cx.keys.of(of), scale, values) {
                handle.paint(&painter, accent);
            }
            for (index, at) in key_places(keys, scale, values).into_iter().enumerate() {
                let chosen = cx.keys.contains(of, index);
                let fill = if chosen { accent } else { visuals.text_color() };
                let half = if chosen { KEY + 1.0 } else { KEY };
                painter.add(diamond(at, half, fill, Stroke::new(1.0, visuals.extreme_bg_color)));
            }
        }
        Drive::Wave(wave) => {
            let at = Pos2::new(scale.place(wave.start), values.place(0.0));
            painter.circle_stroke(at, 3.0, Stroke::new(1.0, line));
            WaveHandle::of(wave, scale, values).paint(&painter, accent, visuals.extreme_bg_color);
        }
        Drive::Constant(_) | Drive::Shared(_) => {}
    }
}

/// The course of a drive as a line, a point for each point of the window.
fn course(drive: &Drive, place: Rect, scale: &TimeScale, values: &ValueScale) -> Vec<Pos2> {
    let solved = solver_drive(drive, &[]);
    let points = place.width().ceil().max(1.0) as usize;
    let at = |k: usize| {
        let x = (place.left() + k as f32).min(place.right());
        Pos2::new(x, values.place(solved.at(scale.time(x)).0))
    };
    (0..=points).map(at).collect()
}

/// What a drive comes to at a time [s], in words: "0.4 = 20 %".
pub(super) fn words_at(of: &Drivable, drive: &Drive, scene: &Scene, time: f64) -> String {
    let value = value_of(drive, &[], time);
    match of.at_one(scene) {
        Some((amount, unit)) => format!("{} = {} {unit}", compact(value), compact(value * amount)),
        None => compact(value),
    }
}

/// Faint where something is not to be looked at first.
pub(super) fn faint(colour: Color32) -> Color32 {
    colour.gamma_multiply(0.3)
}
