//! What a fibre or a sheet does by itself, as numbers that can be changed.

use super::context::Context;
use super::drives::{key_button, keyed_field, point_at};
use super::field::{NumberField, vector};
use super::motion_fields::drive_words;
use crate::scene::{
    Activation, Curl, Drivable, Drive, Fibre, MusclePull, Sheet, SheetActivation, Stiffness, TwistRate,
};
use egui::{CollapsingHeader, RichText, Ui};

const CONTRACT: NumberField = NumberField::new(
    "Contracts by",
    "",
    -0.5..=0.8,
    Some(0.0),
    "Share by which it wants to be shorter where its drive is 1: rest length l0 (1 - c)",
);
const CURL: NumberField = NumberField::new(
    "Curls by",
    "°/m",
    -1e5..=1e5,
    Some(0.0),
    "Curvature that it wants to have beside that of its rest shape, where its drive is 1",
);
const TWIST: NumberField = NumberField::new(
    "Twists by",
    "°/m",
    -1e5..=1e5,
    Some(0.0),
    "Twist that it wants to have where its drive is 1, right-handed along it; it takes a GJ above 0",
);
const FORCE: NumberField = NumberField::new(
    "Muscle pulls",
    "N",
    0.0..=1e6,
    Some(0.0),
    "Greatest force of a muscle beside what resists: force (1 - q²), q its stretch over the width; its drive goes from 0 to 1",
);
const WIDTH: NumberField = NumberField::new(
    "over a width of",
    "",
    1e-3..=1.0,
    Some(0.5),
    "Share by which it may be shorter or longer than drawn before the muscle no longer pulls",
);

const FRACTION: NumberField = NumberField::new(
    "Volume fraction at 1",
    "",
    0.0..=1.0,
    None,
    "Volume fraction that it has where its drive is 1; where that is 0 it has its own. The matrix around gives way to it, and back",
);

/// Shows what a fibre does by itself; folded away where it does nothing.
pub(super) fn activation_fields(ui: &mut Ui, cx: &mut Context, fibre: &mut Fibre, body: &str) {
    // One that yields does not act.
    if fibre.yields.is_some() {
        return;
    }
    let of = Drivable::Fibre { body: body.to_owned(), fibre: fibre.id.clone() };
    let header = CollapsingHeader::new("Activation").default_open(fibre.activation.is_some());
    header.show(ui, |ui| {
        let before = fibre.activation.clone();
        // As it acts once one of its numbers is another than none.
        let mut acts = before.clone().unwrap_or_else(|| Activation::contracting(0.0, 1.0));
        keyed_field(ui, cx, &CONTRACT, &mut acts.contract, &of);
        curl(ui, cx, &mut acts, &of);
        if fibre.stiffness.twisting() > 0.0 {
            let mut rate = acts.twist.as_ref().map_or(0.0, |twist| twist.degrees_per_metre);
            if keyed_field(ui, cx, &TWIST, &mut rate, &of) {
                acts.twist = (rate != 0.0).then(|| match acts.twist.take() {
                    Some(twist) => TwistRate { degrees_per_metre: rate, ..twist },
                    None => TwistRate::new(rate),
                });
            }
        }
        muscle(ui, cx, &mut acts, &of);
        let own = fibre.volume_fraction;
        let mut at_one = acts.volume_fraction.unwrap_or(own);
        if keyed_field(ui, cx, &FRACTION, &mut at_one, &of) {
            acts.volume_fraction = (at_one != own).then_some(at_one);
        }
        if let Some(before) = &before {
            driven_by(ui, cx, &before.drive, &of);
            if ui.button("Acts no more").on_hover_text("It only resists again; its drive goes with it").clicked() {
                fibre.activation = None;
                return;
            }
        } else if acts == Activation::contracting(0.0, 1.0) {
            return;
        }
        fibre.activation = Some(acts);
    });
}

/// Shows what a sheet does by itself; folded away where it does nothing.
pub(super) fn sheet_activation_fields(ui: &mut Ui, cx: &mut Context, sheet: &mut Sheet, body: &str) {
    const ALONG: NumberField = NumberField { label: "Contracts along by", ..CONTRACT };
    const ACROSS: NumberField = NumberField { label: "across by", ..CONTRACT };
    const CURL_ALONG: NumberField = NumberField { label: "Curls along by", tooltip: SHEET_CURL, ..CURL };
    const CURL_ACROSS: NumberField = NumberField { label: "curls across by", tooltip: SHEET_CURL, ..CURL };
    const SHEET_CURL: &str = "Curvature that it wants to have beside that of its rest shape, where its drive is 1; above 0 it curls \
                              to the side to which its first direction turned into its second one looks";
    let of = Drivable::Sheet { body: body.to_owned(), sheet: sheet.id.clone() };
    let header = CollapsingHeader::new("Activation").default_open(sheet.activation.is_some());
    header.show(ui, |ui| {
        let before = sheet.activation.clone();
        let still = || SheetActivation::contracting([0.0; 2], 1.0);
        let mut acts = before.clone().unwrap_or_else(still);
        for (field, value) in [&ALONG, &ACROSS].into_iter().zip(&mut acts.contract) {
            keyed_field(ui, cx, field, value, &of);
        }
        for (field, value) in [&CURL_ALONG, &CURL_ACROSS].into_iter().zip(&mut acts.curl_degrees_per_metre) {
            keyed_field(ui, cx, field, value, &of);
        }
        if let Some(before) = &before {
            driven_by(ui, cx, &before.drive, &of);
            if ui.button("Acts no more").on_hover_text("It only resists again; its drive goes with it").clicked() {
                sheet.activation = None;
                return;
            }
        } else if acts == still() {
            return;
        }
        sheet.activation = Some(acts);
    });
}

fn curl(ui: &mut Ui, cx: &mut Context, acts: &mut Activation, of: &Drivable) {
    let mut rate = acts.curl.as_ref().map_or(0.0, |curl| curl.degrees_per_metre);
    if keyed_field(ui, cx, &CURL, &mut rate, of) {
        acts.curl = (rate != 0.0).then(|| match acts.curl.take() {
            Some(curl) => Curl { degrees_per_metre: rate, ..curl },
            None => Curl::new(rate, [0.0, 0.0, 1.0]),
        });
    }
    if let Some(curl) = &mut acts.curl {
        let mut axis = curl.axis;
        vector(ui, "about", "", &mut axis, "Axis about which it curls, right-handed along it, model frame");
        if axis.iter().any(|part| part.abs() > 1e-9) {
            curl.axis = axis;
        }
    }
}

fn muscle(ui: &mut Ui, cx: &mut Context, acts: &mut Activation, of: &Drivable) {
    let mut force = acts.muscle.as_ref().map_or(0.0, |muscle| muscle.force);
    if keyed_field(ui, cx, &FORCE, &mut force, of) {
        acts.muscle = (force != 0.0).then(|| match acts.muscle.take() {
            Some(muscle) => MusclePull { force, ..muscle },
            None => MusclePull::new(force),
        });
    }
    if let Some(muscle) = &mut acts.muscle {
        WIDTH.show(ui, &mut muscle.width);
    }
}

/// What all of it is multiplied by, in a word.
fn driven_by(ui: &mut Ui, cx: &mut Context, drive: &Drive, of: &Drivable) {
    let words = format!("times {}", drive_words(drive));
    let row = ui.horizontal(|ui| {
        ui.label(RichText::new(words).weak().small()).on_hover_text("Its lane is below the timeline, under Drives");
        key_button(ui, cx, of);
    });
    point_at(ui, cx, row.response.rect, of);
}

/// Shows how a fibre resists twist.
pub(super) fn twisting_field(ui: &mut Ui, stiffness: &mut Stiffness) {
    const GJ: NumberField = NumberField::new(
        "GJ",
        "N m²",
        0.0..=1e6,
        Some(0.0),
        "Twisting stiffness: l_f GJ / 2 l0 times the square of the twist at each edge, l0 its own length; 0 does not feel twist",
    );
    if let Stiffness::Rigidity(of) = stiffness {
        GJ.show(ui, &mut of.gj);
    }
}
