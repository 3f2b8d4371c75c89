//! What will come of a motion that is to be written, told beforehand.

use super::choices::counted;
use super::question::{Known, MotionQuestion, Source};
use crate::export::BodySize;
use crate::transfer::{FormatPreview, FrameChoice, preview, replaced};
use crate::ui::context::Context;
use crate::ui::theme::GRID;
use egui::{RichText, ScrollArea, Ui};

/// More bodies than this are counted, not named one by one.
const NAMED: usize = 12;
/// More files than this are not named one by one.
const FILES: usize = 4;

/// Shows it; gives why nothing can be written, where nothing can.
pub(super) fn show_preview(ui: &mut Ui, question: &mut MotionQuestion, cx: &Context) -> Option<String> {
    let room = (ui.ctx().content_rect().height() - 420.0).clamp(80.0, 260.0);
    let mut obstacle = None;
    ScrollArea::vertical().max_height(room).auto_shrink([false, true]).show(ui, |ui| {
        obstacle = contents(ui, question, cx);
    });
    if let Some(obstacle) = &obstacle {
        ui.label(RichText::new(obstacle).color(cx.tone.error()));
    }
    obstacle
}

fn contents(ui: &mut Ui, question: &mut MotionQuestion, cx: &Context) -> Option<String> {
    let status = &cx.simulation.published().status;
    let choice = question.frames(cx);
    let bodies = match &question.known {
        Known::Asked(_) => {
            ui.horizontal(|ui| {
                ui.spinner();
                ui.label("The scene is being put together…");
            });
            return Some("What will be written is not known yet".to_owned());
        }
        Known::Nothing => {
            let why =
                status.failure.as_ref().map_or_else(String::new, |why| format!(": {}", cx.scene().with_names(why)));
            return Some(format!("There is no motion, as the scene is not put together{why}"));
        }
        Known::Bodies(bodies, _) => bodies,
    };
    let Some(choice) = choice else { return Some("The timeline keeps no frames; have them computed anew".to_owned()) };
    let told = preview(&question.formats, bodies, choice);
    for size in bodies.iter().take(NAMED) {
        body(ui, size);
    }
    if bodies.len() > NAMED {
        ui.label(format!("and {} more bodies", bodies.len() - NAMED));
    }
    ui.add_space(GRID);
    for format in &told {
        files(ui, format, cx);
    }
    if question.source == Source::Kept && status.recording.frames > kept(status.recording.numbers) {
        let left = status.recording.frames - kept(status.recording.numbers);
        let frames = counted(left, "frame", "frames");
        let said = format!("{frames} of before the scene was last changed are left out: they are of another scene");
        ui.label(RichText::new(said).color(cx.tone.warning()));
    }
    let there = count_replaced(question, choice);
    if there > 0 {
        let files = counted(there, "file", "files");
        ui.label(RichText::new(format!("{files} in the folder will be replaced")).color(cx.tone.warning()));
    }
    if question.formats.is_empty() {
        return Some("Choose a format".to_owned());
    }
    if question.folder.path().is_none() {
        return Some("Name a folder".to_owned());
    }
    told.into_iter().find_map(|format| format.refused)
}

/// Frames from the first to the last.
fn kept(numbers: Option<[u64; 2]>) -> usize {
    numbers.map_or(0, |[first, last]| (last - first + 1) as usize)
}

fn body(ui: &mut Ui, size: &BodySize) {
    let mut parts = vec![counted(size.vertices, "vertex", "vertices")];
    let mut and = |count: usize, one: &str, many: &str| {
        if count > 0 {
            parts.push(counted(count, one, many));
        }
    };
    and(size.faces, "face", "faces");
    and(size.fibres, "fibre", "fibres");
    and(size.springs, "spring", "springs");
    and(size.particles, "particle", "particles");
    let own = if size.is_of_file { ", on its file's own vertices" } else { "" };
    ui.horizontal_wrapped(|ui| {
        ui.label(RichText::new(&size.name).strong());
        ui.label(parts.join(", ") + own);
    });
}

fn files(ui: &mut Ui, format: &FormatPreview, cx: &Context) {
    ui.horizontal_wrapped(|ui| {
        ui.label(RichText::new(format.name.to_uppercase()).strong());
        let mut text = format.files.iter().take(FILES).cloned().collect::<Vec<_>>().join(", ");
        if format.files.len() > FILES {
            text = format!("{text} and {} more", format.files.len() - FILES);
        }
        ui.label(text);
        if !format.left_out.is_empty() {
            ui.label(RichText::new(format!("without {}", format.left_out.join(", "))).weak());
        }
        if let Some(refused) = &format.refused {
            ui.label(RichText::new(refused).color(cx.tone.error()));
        }
    });
}

/// How many files would be replaced; the folder is looked into only when something has changed.
fn count_replaced(question: &mut MotionQuestion, choice: FrameChoice) -> usize {
    let Known::Bodies(bodies, _) = &question.known else { return 0 };
    let Some(folder) = question.folder.path() else { return 0 };
    let FrameChoice { first, last, step } = choice;
    let looked = (question.folder.text.clone(), question.formats.clone(), [first, last, step]);
    match &question.replaced {
        Some((before, count)) if *before == looked => *count,
        _ => {
            let count = replaced(&question.formats, &folder, bodies, choice);
            question.replaced = Some((looked, count));
            count
        }
    }
}
