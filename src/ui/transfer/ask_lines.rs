//! What is asked before fibres go out or come in as lines of other programs.

use super::answer::TransferAnswer;
use super::choices::{counted, place, unit_and_axis};
use super::question::LinesQuestion;
use crate::io::is_there;
use crate::ui::context::Context;
use crate::ui::theme::GRID;
use egui::{Grid, Key, RichText, Ui};
use std::sync::mpsc::TryRecvError;

/// Asks about lines.
pub(super) fn ask_lines(ui: &mut Ui, question: &mut LinesQuestion, cx: &Context) -> Option<TransferAnswer> {
    if let Some(receiver) = &question.work {
        match receiver.try_recv() {
            Ok(Ok(done)) => return Some(TransferAnswer::Done(done)),
            Ok(Err(problem)) => (question.work, question.problem) = (None, Some(problem)),
            Err(TryRecvError::Disconnected) => {
                (question.work, question.problem) = (None, Some("It ended before it was done; try again".to_owned()));
            }
            Err(TryRecvError::Empty) => {}
        }
    }
    ui.set_width(480.0);
    let (title, verb, tooltip) = if let Some((_, body)) = &question.into {
        let tooltip = "Reads the lines as fibres of the body; undo takes them out";
        (format!("Import fibres into {body}"), "Import", tooltip)
    } else {
        let fibres = counted(question.fibres.len(), "fibre", "fibres");
        (format!("Export {fibres}"), "Export", "Writes the vertices of the fibres as lines")
    };
    ui.heading(title);
    ui.add_space(GRID);
    let reads = question.into.is_some();
    let pick = move || {
        let dialog = rfd::FileDialog::new().add_filter("lines", &["obj", "csv", "json"]);
        if reads { dialog.pick_file() } else { dialog.set_file_name("fibres.obj").save_file() }
    };
    place(ui, "File", "Path of an .obj file with lines, or a .csv or .json of vertices", &mut question.file, pick);
    Grid::new("lines").num_columns(2).spacing([4.0 * GRID, 2.0 * GRID]).show(ui, |ui| {
        ui.label("Lines in");
        ui.horizontal_wrapped(|ui| unit_and_axis(ui, &mut question.at.space));
        ui.end_row();
        ui.label("Frame");
        ui.horizontal_wrapped(|ui| {
            ui.radio_value(&mut question.at.in_model, false, "World")
                .on_hover_text("The lines stand where the body was put in the scene");
            ui.radio_value(&mut question.at.in_model, true, "Model")
                .on_hover_text("The lines stand in the body's own frame, that of its model's file");
        });
        ui.end_row();
    });
    let path = question.file.path();
    if !reads && path.as_deref().is_some_and(is_there) {
        ui.label(RichText::new("The file is there and will be replaced").color(cx.tone.warning()));
    }
    if let Some(problem) = &question.problem {
        ui.label(RichText::new(cx.scene().with_names(problem)).color(cx.tone.error()));
    }
    ui.add_space(GRID);
    let ready = path.is_some() && question.work.is_none();
    let entered = ready && ui.input(|input| input.key_pressed(Key::Enter));
    let mut answer = entered.then_some(TransferAnswer::Begin);
    ui.horizontal(|ui| {
        let button = ui.add_enabled(ready, egui::Button::new(verb)).on_hover_text(tooltip);
        if button.on_disabled_hover_text("Name a file").clicked() {
            answer = Some(TransferAnswer::Begin);
        }
        if ui.button("Cancel").clicked() {
            answer = Some(TransferAnswer::Closed);
        }
        if question.work.is_some() {
            ui.spinner();
        }
    });
    answer
}
