//! Shared drives in hand: a slider each, by which muscles move now, and what was played as keys.

use super::context::{Context, Severity, Step};
use crate::edit::Command;
use crate::scene::Drivable;
use crate::sim::{DriveStatus, SimCommand};
use egui::{Button, RichText, Slider, SliderClamping, Ui};

/// Shows a slider for every shared drive, and what can be done with what was played.
pub(super) fn conductor(ui: &mut Ui, cx: &mut Context) {
    let drives = cx.simulation.published().status.drives.clone();
    if drives.is_empty() {
        ui.weak("No drive is shared yet: \"Share it\" in a lane under Drives makes one");
        return;
    }
    ui.weak("Drag: what follows moves now").on_hover_text(
        "From the least to the greatest value of the drive itself, and to 0: so one that stays the same has a range, too",
    );
    for of in &drives {
        knob(ui, cx, of);
    }
    let is_led = drives.iter().any(|of| of.is_led);
    ui.horizontal(|ui| {
        let tooltip = "Makes keys of what was played since the start, linear from frame to frame, and lets go: played \
                       again from the start it is the same motion";
        let was_performed = ui.add_enabled(cx.simulation.was_performed(), Button::new("Record")).on_hover_text(tooltip);
        if was_performed.on_disabled_hover_text("Nothing was played since the start").clicked() {
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
        ui.weak("0 at all times")
            .on_hover_text("Another value, keys or a wave in its lane give it a range to be played in");
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

/// Makes keys of what was played, on top of what the drives are by themselves: one step of undo.
fn record(cx: &mut Context, drives: &[DriveStatus]) {
    let journal = cx.simulation.journal();
    let scene = cx.scene().clone();
    let performed = |of: &DriveStatus| {
        let drivable = drivable(cx, of)?;
        let drive = journal.performed(of.body, &of.id, drivable.drive(&scene)?)?;
        Some(Command::SetDrive { of: drivable, drive: Some(drive) })
    };
    let commands: Vec<Command> = drives.iter().filter_map(performed).collect();
    let name = "Record performance".to_owned();
    cx.say(Severity::Note, "What was played is keys now: reset plays it from the start (Drives, below the views)");
    cx.edit(&Command::Many { name, commands }, Step::Own);
    release(cx, drives);
}
