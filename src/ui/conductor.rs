//! Shared drives in hand: a slider each, by which muscles move now, and what was played as keys.

use super::context::{Context, Severity, Step};
use crate::bake::solver_drive;
use crate::edit::Command;
use crate::scene::{AfterLast, Drivable, Drive, DriveKeys, Interpolation};
use crate::sim::{DriveStatus, SimCommand};
use egui::{Button, RichText, Slider, SliderClamping, Ui};

/// Shows a slider for every shared drive, and what can be done with what was played.
pub(super) fn conductor(ui: &mut Ui, cx: &mut Context) {
    let drives = cx.simulation.published().status.drives.clone();
    if drives.is_empty() {
        ui.weak("No drive is shared yet: \"Share it\" in a lane under Drives makes one");
        return;
    }
    ui.weak("Drag: what follows moves now").on_hover_text("Up to the least and the greatest value of the drive itself");
    for of in &drives {
        knob(ui, cx, of);
    }
    let is_led = drives.iter().any(|of| of.is_led);
    ui.horizontal(|ui| {
        let tooltip = "Makes keys of what was played since the start, linear from frame to frame, and lets go";
        let has_played = ui.add_enabled(is_led, Button::new("Record")).on_hover_text(tooltip);
        if has_played.on_disabled_hover_text("Nothing is in hand").clicked() {
            record(cx, &drives);
        }
        let tooltip = "The drives go on by themselves; nothing of the scene changes";
        if ui.add_enabled(is_led, Button::new("Release")).on_hover_text(tooltip).clicked() {
            release(cx, &drives);
        }
    });
}

/// The slider of a drive: it shows what the drive is just now.
fn knob(ui: &mut Ui, cx: &Context, of: &DriveStatus) {
    let title = drivable(cx, of).map_or_else(|| of.id.clone(), |drivable| drivable.title(cx.scene()));
    let [least, most] = of.limits;
    let label = RichText::new(&title).small();
    let text = ui.label(if of.is_led { label.strong() } else { label });
    if least >= most {
        ui.weak("the same at all times").on_hover_text("Keys or a wave in its lane give it a range to be played in");
        return;
    }
    let mut value = of.value;
    ui.spacing_mut().slider_width = 150.0;
    let slider = Slider::new(&mut value, least..=most).clamping(SliderClamping::Edits).max_decimals(3);
    if ui.add(slider).labelled_by(text.id).changed() {
        cx.ask(SimCommand::Lead { body: of.body, drive: of.id.clone(), aim: Some(value) });
    }
}

fn drivable(cx: &Context, of: &DriveStatus) -> Option<Drivable> {
    let body = cx.scene().any_body(of.body)?.id().to_owned();
    Some(Drivable::Shared { body, drive: of.id.clone() })
}

fn release(cx: &Context, drives: &[DriveStatus]) {
    for of in drives.iter().filter(|of| of.is_led) {
        cx.ask(SimCommand::Lead { body: of.body, drive: of.id.clone(), aim: None });
    }
}

/// Makes keys of what was played: one step of undo.
fn record(cx: &mut Context, drives: &[DriveStatus]) {
    let journal = cx.simulation.journal();
    let scene = cx.scene().clone();
    let mut commands = Vec::new();
    for of in drives {
        let Some(drivable) = drivable(cx, of) else { continue };
        let Some(drive) = drivable.drive(&scene) else { continue };
        let own = solver_drive(drive, &[]);
        let mut keys = journal.played(of.body, &of.id, |time| own.at(time).0, of.limits);
        let Some(&(first, _)) = keys.first() else { continue };
        // What it was by itself before a hand took it.
        let seconds = scene.time.frame_seconds();
        let before = (0..).map(|k| f64::from(k) * seconds).take_while(|time| *time < first - 0.5 * seconds);
        if !matches!(drive, Drive::Constant(_)) {
            let led: Vec<(f64, f64)> = before.map(|time| (time, own.at(time).0)).collect();
            keys.splice(0..0, led);
        }
        let keys = DriveKeys { between: Interpolation::Linear, after: AfterLast::Hold, ..DriveKeys::new(keys) };
        commands.push(Command::SetDrive { of: drivable, drive: Some(keys.into()) });
    }
    if commands.is_empty() {
        cx.say(Severity::Note, "Nothing was played since the start");
        return;
    }
    let name = "Record performance".to_owned();
    cx.say(Severity::Note, "What was played is keys now: reset plays it from the start (Drives, below the views)");
    cx.edit(&Command::Many { name, commands }, Step::Own);
    release(cx, drives);
}
