//! What is asked before a motion is written: formats, program, frames, folder, with what will come of them.

use super::answer::TransferAnswer;
use super::choices::{picture_size, place, told, unit_and_axis};
use super::motion_preview::show_preview;
use super::question::{Known, MotionQuestion, Source};
use crate::export::sizes;
use crate::sim::TakenMotion;
use crate::text::number::compact;
use crate::transfer::{Format, FrameChoice, Program};
use crate::ui::context::Context;
use crate::ui::theme::GRID;
use egui::{DragValue, Grid, RichText, Ui};

/// Width of the dialog [points].
const WIDTH: f32 = 560.0;

impl MotionQuestion {
    /// The last frame of the scene's own duration.
    fn last_of_scene(cx: &Context, seconds: f64) -> u64 {
        (cx.scene().time.duration / seconds - 1e-9).ceil().max(0.0) as u64
    }

    /// The frames that are to be written, as far as they are known.
    pub(super) fn frames(&self, cx: &Context) -> Option<FrameChoice> {
        let Known::Bodies(_, seconds) = &self.known else { return None };
        let [first, last] = match self.source {
            Source::Kept => {
                let [first, last] = cx.simulation.published().status.recording.numbers?;
                let [from, to] = self.range.unwrap_or([first, last]);
                [from.clamp(first, last), to.clamp(first, last)]
            }
            Source::Anew => self.range.unwrap_or([0, Self::last_of_scene(cx, *seconds)]),
        };
        Some(FrameChoice { first, last: last.max(first), step: self.step.max(1) })
    }

    /// Takes what was asked for, once it is there.
    fn hear(&mut self) {
        let Known::Asked(receiver) = &self.known else { return };
        let told = |motion: TakenMotion| {
            let (scene, assets) = motion.scene();
            let world = motion.start().world();
            Known::Bodies(sizes(scene, assets, world), world.plan().frame_seconds)
        };
        match receiver.try_recv() {
            Ok(taken) => self.known = taken.map_or(Known::Nothing, told),
            Err(std::sync::mpsc::TryRecvError::Disconnected) => self.known = Known::Nothing,
            Err(std::sync::mpsc::TryRecvError::Empty) => {}
        }
    }
}

/// Asks about a motion.
pub(super) fn ask_motion(ui: &mut Ui, question: &mut MotionQuestion, cx: &Context) -> Option<TransferAnswer> {
    question.hear();
    ui.set_width(WIDTH.min(ui.ctx().content_rect().width() - 16.0 * GRID));
    ui.heading("Export motion");
    ui.add_space(GRID);
    Grid::new("motion").num_columns(2).spacing([4.0 * GRID, 2.0 * GRID]).show(ui, |ui| {
        ui.label("For");
        ui.horizontal_wrapped(|ui| programs(ui, question));
        ui.end_row();
        ui.label("Formats");
        ui.horizontal_wrapped(|ui| formats(ui, &mut question.formats));
        ui.end_row();
        ui.label("Frames");
        ui.vertical(|ui| frames(ui, question, cx));
        ui.end_row();
    });
    let pick = || rfd::FileDialog::new().pick_folder();
    place(ui, "Folder", "Path of a folder; it is made unless it is there", &mut question.folder, pick);
    let draws = question.formats.iter().any(|format| matches!(format, Format::Picture(_)));
    if draws {
        picture_size(ui, &mut question.size, &question.sizes);
    }
    ui.separator();
    let obstacle = show_preview(ui, question, cx);
    ui.separator();
    let mut answer = None;
    ui.horizontal(|ui| {
        let button = ui.add_enabled(obstacle.is_none(), egui::Button::new("Export"));
        let button = button.on_hover_text("Writes the files; the window goes on meanwhile");
        if button.on_disabled_hover_text(obstacle.unwrap_or_default()).clicked() {
            answer = Some(TransferAnswer::Begin);
        }
        if ui.button("Cancel").clicked() {
            answer = Some(TransferAnswer::Closed);
        }
    });
    answer
}

fn programs(ui: &mut Ui, question: &mut MotionQuestion) {
    for (name, program) in Program::ALL {
        let chosen = question.program == Some(program);
        if ui.selectable_label(chosen, name).on_hover_text(told(program.space())).clicked() {
            (question.program, question.space) = (Some(program), program.space());
        }
    }
    let own = question.program.is_none();
    if ui.selectable_label(own, "Other").on_hover_text("A unit and axes of your own").clicked() {
        question.program = None;
    }
    if question.program.is_some() {
        ui.label(RichText::new(told(question.space)).weak());
    } else {
        unit_and_axis(ui, &mut question.space);
    }
}

fn formats(ui: &mut Ui, chosen: &mut Vec<Format>) {
    for (name, format) in Format::all() {
        let mut on = chosen.contains(&format);
        if ui.checkbox(&mut on, name.to_uppercase()).on_hover_text(format.title()).changed() {
            chosen.retain(|known| *known != format);
            if on {
                chosen.push(format);
            }
        }
    }
}

fn frames(ui: &mut Ui, question: &mut MotionQuestion, cx: &Context) {
    let kept = cx.simulation.published().status.recording.numbers;
    let before = question.source;
    ui.horizontal(|ui| {
        let text = kept.map_or_else(|| "Kept".to_owned(), |[first, last]| format!("Kept, {first} to {last}"));
        ui.add_enabled_ui(kept.is_some(), |ui| {
            ui.radio_value(&mut question.source, Source::Kept, text)
                .on_hover_text("The frames that the timeline keeps, with all that was pulled and changed in them")
                .on_disabled_hover_text("The timeline keeps no frames");
        });
        ui.radio_value(&mut question.source, Source::Anew, "Computed anew")
            .on_hover_text("A run from the start of the scene, with nothing pulled; as `sinew simulate` runs it");
    });
    if before != question.source {
        question.range = None;
    }
    let Some(choice) = question.frames(cx) else {
        ui.label(RichText::new("The scene is being put together…").weak());
        return;
    };
    let limits = match (question.source, kept) {
        (Source::Kept, Some([first, last])) => first..=last,
        _ => 0..=10_000_000,
    };
    ui.horizontal(|ui| {
        let [mut first, mut last] = [choice.first, choice.last];
        let text = ui.label("From");
        let changed = ui.add(DragValue::new(&mut first).range(limits.clone())).labelled_by(text.id).changed();
        let text = ui.label("to");
        let moved = ui.add(DragValue::new(&mut last).range(limits)).labelled_by(text.id).changed();
        if changed || moved {
            // The one that was taken hold of moves the other one along.
            question.range = Some(if changed { [first, last.max(first)] } else { [first.min(last), last] });
        }
        let text = ui.label("every");
        ui.add(DragValue::new(&mut question.step).range(1..=1000))
            .labelled_by(text.id)
            .on_hover_text("Every so many frames; those between are left out, and what is written lasts as long");
        ui.label(if question.step == 1 { "frame" } else { "frames" });
    });
    if let Known::Bodies(_, seconds) = &question.known {
        let lasts = choice.count() as f64 * choice.step as f64 * seconds;
        let rate = 1.0 / (choice.step as f64 * seconds);
        let [lasts, rate] = [lasts, rate].map(compact);
        ui.label(RichText::new(format!("{} frames, {lasts} s at {rate} a second", choice.count())).weak());
    }
}
