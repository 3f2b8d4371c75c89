//! What is asked before a clip is saved.

use super::answer::TransferAnswer;
use super::choices::{picture_size, place};
use super::question::{ClipKind, ClipQuestion};
use super::work::{TURN_PICTURES, TURN_RATE, clip_frames};
use crate::io::MovingFormat;
use crate::io::is_there;
use crate::text::number::compact;
use crate::ui::context::Context;
use crate::ui::theme::GRID;
use egui::{Key, RichText, Ui};

/// Asks about a clip.
pub(super) fn ask_clip(ui: &mut Ui, question: &mut ClipQuestion, cx: &Context) -> Option<TransferAnswer> {
    ui.set_width(480.0);
    let (title, says) = match question.kind {
        ClipKind::Motion => ("Save clip", motion(cx)),
        ClipKind::Turntable => {
            let lasts = compact(TURN_PICTURES as f64 / TURN_RATE);
            let says = format!("Once around what the result view shows, in {TURN_PICTURES} pictures and {lasts} s.");
            ("Save turntable", Ok(says))
        }
    };
    ui.heading(title);
    let mut obstacle = None;
    match says {
        Ok(says) => {
            ui.label(RichText::new(says).weak());
        }
        Err(why) => {
            ui.label(RichText::new(why).color(cx.tone.error()));
            obstacle = Some(why);
        }
    }
    ui.add_space(GRID);
    let endings = MovingFormat::ALL.map(|(name, _)| name);
    let pick =
        move || rfd::FileDialog::new().add_filter("moving picture", &endings).set_file_name("clip.apng").save_file();
    let hint = format!("Path of a moving picture: .{}", endings.join(" or ."));
    place(ui, "File", &hint, &mut question.file, pick);
    picture_size(ui, &mut question.size, &question.sizes);
    match question.file.path() {
        None => obstacle = Some("Name a file"),
        Some(path) if is_there(&path) => {
            ui.label(RichText::new("The file is there and will be replaced").color(cx.tone.warning()));
        }
        Some(_) => {}
    }
    ui.add_space(GRID);
    let entered = obstacle.is_none() && ui.input(|input| input.key_pressed(Key::Enter));
    let mut answer = entered.then_some(TransferAnswer::Begin);
    ui.horizontal(|ui| {
        let button = ui.add_enabled(obstacle.is_none(), egui::Button::new("Save"));
        let button = button.on_hover_text("Draws the pictures; the window goes on meanwhile");
        if button.on_disabled_hover_text(obstacle.unwrap_or_default()).clicked() {
            answer = Some(TransferAnswer::Begin);
        }
        if ui.button("Cancel").clicked() {
            answer = Some(TransferAnswer::Closed);
        }
    });
    answer
}

/// What a clip of the motion shows, or why there is none.
fn motion(cx: &Context) -> Result<String, &'static str> {
    let [first, last] = cx.simulation.published().status.recording.numbers.ok_or("The timeline keeps no frames")?;
    let seconds = cx.scene().time.frame_seconds();
    let choice = clip_frames(first, last, seconds);
    let step = choice.step as f64 * seconds;
    let [lasts, rate] = [choice.count() as f64 * step, 1.0 / step].map(compact);
    let count = choice.count();
    Ok(format!(
        "The frames that the timeline keeps, as the result view shows them: {count} pictures, {lasts} s at {rate} a second."
    ))
}
