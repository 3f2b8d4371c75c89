//! How something that is held is moved: a pinned region, a collider.

use super::context::Context;
use super::drives::{key_button, point_at};
use super::field::{NumberField, vector};
use crate::scene::{Distance, Drivable, Drive, DrivenMotion, DrivenTurn, Motion};
use egui::Ui;

const TURN: NumberField = NumberField::new(
    "Turned by",
    "°",
    -1e5..=1e5,
    Some(0.0),
    "How far it is turned where its drive is 1, right-handed about the axis",
);

/// Shows how something is moved, with the button that lets a drive do it.
pub(super) fn motion_fields(ui: &mut Ui, cx: &mut Context, motion: &mut Motion, of: &Drivable) {
    let fields = ui.scope(|ui| {
        ui.horizontal(|ui| {
            ui.label(words(motion))
                .on_hover_text("The diamond lets it follow keys in its lane, under Drives below the timeline");
            key_button(ui, cx, of);
        });
        if let Motion::Driven(driven) = motion {
            driven_fields(ui, driven);
        }
    });
    point_at(ui, cx, fields.response.rect, of);
}

fn driven_fields(ui: &mut Ui, driven: &mut DrivenMotion) {
    vector(ui, "Moved by", "m", &mut driven.offset, "How far it is moved where its drive is 1, world axes");
    let before = driven.turn.as_ref().map_or(0.0, |turn| turn.degrees);
    let mut degrees = before;
    if TURN.show(ui, &mut degrees) && degrees != before {
        driven.turn = (degrees != 0.0).then(|| match driven.turn.take() {
            Some(turn) => DrivenTurn { degrees, ..turn },
            None => DrivenTurn::new([0.0, 1.0, 0.0], degrees),
        });
    }
    if let Some(turn) = &mut driven.turn {
        let mut axis = turn.axis;
        vector(ui, "about", "", &mut axis, "Axis of the turn, of any length but zero, world axes");
        if axis.iter().any(|part| part.abs() > 1e-9) {
            turn.axis = axis;
        }
    }
}

/// How something is moved, in words.
fn words(motion: &Motion) -> String {
    match motion {
        Motion::Fixed => "stays where it starts".to_owned(),
        Motion::Ramp(ramp) => match ramp.distance {
            Distance::Metres(metres) => format!("moves by {metres} m in {} s", ramp.duration),
            Distance::Fraction(share) => format!("moves by {share} in {} s", ramp.duration),
        },
        Motion::Turn(turn) => format!("turns by {}° in {} s", turn.degrees, turn.duration),
        Motion::Keyframes(keys) => format!("follows {} offsets", keys.len()),
        Motion::Driven(driven) => format!("follows {}", drive_words(&driven.drive)),
    }
}

/// A drive in words, after "follows" or "times".
pub(super) fn drive_words(drive: &Drive) -> String {
    match drive {
        Drive::Constant(value) => format!("{value} at all times"),
        Drive::Keyframes(keys) if keys.keys.len() == 1 => "a drive of one key".to_owned(),
        Drive::Keyframes(keys) => format!("a drive of {} keys", keys.keys.len()),
        Drive::Wave(wave) => format!("a wave of {} s", wave.period),
        Drive::Shared(id) => format!("the drive \"{id}\""),
    }
}
