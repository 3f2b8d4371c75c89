//! How the questions look.

use super::offer::RecoveryOffer;
use super::question::{Loss, Question, Reply};
use super::recorder::RecordingOffer;
use crate::ui::recent_menu::file_name;
use crate::ui::theme::{GRID, Tone};
use egui::{Button, Label, RichText, ScrollArea, Ui};
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};

/// What questions are about.
pub(crate) struct About<'a> {
    pub name: &'a str,
    pub path: Option<&'a Path>,
    pub offers: &'a [RecoveryOffer],
    pub recordings: &'a [RecordingOffer],
    pub tone: Tone,
}

/// A button: what it says, what it tells of itself and what it answers.
type Choice<'a> = (&'static str, &'a str, Reply);

/// Shows a question; gives its answer.
pub(crate) fn ask(ui: &mut Ui, question: &Question, about: &About<'_>) -> Option<Reply> {
    ui.set_width(if matches!(question, Question::Recover) { 520.0 } else { 400.0 });
    match question {
        Question::Unsaved(_) => unsaved(ui, about),
        Question::Replace { path, loss, .. } => replace(ui, path, *loss),
        Question::Reload { path, is_asked, is_changed } => reload(ui, path, *is_asked, *is_changed),
        Question::Outside { path, files } => outside(ui, path, files),
        Question::Recover => recover(ui, about),
    }
}

fn unsaved(ui: &mut Ui, about: &About<'_>) -> Option<Reply> {
    explain(ui, &format!("Save the changes to {}?", about.name), "Without saving they are lost.");
    let save = about.path.map_or_else(
        || "Asks for a file, writes the scene to it and goes on".to_owned(),
        |path| format!("Writes the scene to {} and goes on", path.display()),
    );
    let choices = [
        ("Save", save.as_str(), Reply::Save),
        ("Discard", "Goes on without the changes since the last save", Reply::Discard),
        ("Cancel", "Back to the scene (Escape)", Reply::Back),
    ];
    // Asked for by the person, who may answer by Enter.
    choose(ui, &choices, true)
}

fn replace(ui: &mut Ui, path: &Path, loss: Loss) -> Option<Reply> {
    let why = match loss {
        Loss::Changed => {
            "Another program changed it since it was read or saved here. Saving replaces what it holds now."
        }
        Loss::Other => "There is such a file already. Saving replaces what it holds.",
        Loss::Table => "There is such a file already. Exporting replaces what it holds.",
    };
    explain(ui, &format!("Replace {}?", file_name(path)), why);
    place(ui, path);
    let choices = [
        ("Replace", "Writes over what the file holds", Reply::Replace),
        ("Save as…", "Writes to another file", Reply::SaveElsewhere),
        ("Cancel", "Back to the scene; nothing is written (Escape)", Reply::Back),
    ];
    choose(ui, &choices, false)
}

fn reload(ui: &mut Ui, path: &Path, is_asked: bool, is_changed: bool) -> Option<Reply> {
    let file = file_name(path);
    if is_asked {
        explain(ui, &format!("Reload {file}?"), "The changes since the last save are lost then.");
    } else {
        let why = if is_changed {
            "The scene here has changes of its own: reloading loses them. Keep mine leaves the scene as it is, and saving asks \
             before it replaces the file."
        } else {
            "The scene here has no changes of its own. Keep mine leaves it as it is, and saving asks before it replaces the \
             file."
        };
        explain(ui, &format!("{file} was changed by another program"), why);
    }
    place(ui, path);
    let keep = if is_asked { "Cancel" } else { "Keep mine" };
    let choices = [
        ("Reload", "Opens what the file holds now", Reply::Reload),
        (keep, "Leaves the scene as it is here (Escape)", Reply::Back),
    ];
    choose(ui, &choices, false)
}

/// So many files are named one by one.
const NAMED: usize = 5;

fn outside(ui: &mut Ui, path: &Path, files: &[PathBuf]) -> Option<Reply> {
    let why = "The models below lie elsewhere. Let a scene read them if you know where it comes from.";
    explain(ui, &format!("Let {} read files outside of its folder?", file_name(path)), why);
    files.iter().take(NAMED).for_each(|file| place(ui, file));
    if files.len() > NAMED {
        ui.label(RichText::new(format!("and {} more", files.len() - NAMED)).weak());
    }
    let choices = [
        ("Allow", "Opens the scene with these models; this window does not ask about it again", Reply::Allow),
        ("Don't open", "Leaves what is open as it is; nothing is read (Escape)", Reply::Back),
    ];
    choose(ui, &choices, false)
}

fn recover(ui: &mut Ui, about: &About<'_>) -> Option<Reply> {
    if about.offers.is_empty() {
        let why =
            "The program ended before its window was closed. What was done to the motion until then was recorded.";
        explain(ui, "Keep the recording?", why);
    } else {
        explain(ui, "Recover unsaved changes?", "The program ended before these were saved.");
    }
    let mut reply = None;
    let now = SystemTime::now();
    ScrollArea::vertical().max_height(0.5 * ui.ctx().content_rect().height()).show(ui, |ui| {
        for (k, offer) in about.offers.iter().enumerate() {
            ui.separator();
            ui.horizontal(|ui| {
                ui.label(RichText::new(offer.name()).strong());
                ui.label(RichText::new(age(now, offer.document.written)).weak());
                ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
                    let forget = ui.button("Discard").on_hover_text("Removes it for good");
                    let recover = ui.button("Recover").on_hover_text("Opens it, as changed since the last save");
                    if forget.clicked() {
                        reply = Some(Reply::Forget(k));
                    }
                    if recover.clicked() {
                        reply = Some(Reply::Recover(k));
                    }
                });
            });
            match &offer.document.origin.file {
                Some(file) => place(ui, file),
                None => drop(ui.label(RichText::new("Never saved to a file").weak())),
            }
            if offer.is_older {
                let text = "The file was written after this: saving asks before it replaces it";
                ui.label(RichText::new(text).color(about.tone.warning()));
            }
        }
        for (k, offer) in about.recordings.iter().enumerate() {
            ui.separator();
            reply = reply.or(recording(ui, k, offer, now));
        }
    });
    ui.separator();
    let later = "Keeps them all; File, Recover unsaved… and the next start offer them again (Escape)";
    let all = ("Discard all", "Removes them all for good", Reply::ForgetAll);
    let choices = [("Decide later", later, Reply::Back), all];
    choose(ui, &choices[..if about.offers.len() + about.recordings.len() > 1 { 2 } else { 1 }], false).or(reply)
}

/// A recording that was left behind, and what can be done with it.
fn recording(ui: &mut Ui, k: usize, offer: &RecordingOffer, now: SystemTime) -> Option<Reply> {
    let mut reply = None;
    ui.horizontal(|ui| {
        ui.label(RichText::new(format!("Recording of {}", offer.name())).strong());
        ui.label(RichText::new(format!("{} frames, {}", offer.frames, age(now, offer.written()))).weak());
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            if ui.button("Discard recording").on_hover_text("Removes it for good").clicked() {
                reply = Some(Reply::ForgetRecording(k));
            }
            let tooltip = "Writes what was done to the motion until the program ended; `sinew replay` makes it again";
            if ui.button("Save recording…").on_hover_text(tooltip).clicked() {
                reply = Some(Reply::SaveRecording(k));
            }
        });
    });
    reply
}

fn explain(ui: &mut Ui, heading: &str, why: &str) {
    ui.heading(heading);
    ui.add_space(GRID);
    ui.label(why);
}

/// The path of a file, cut where it is long.
fn place(ui: &mut Ui, path: &Path) {
    let text = path.display().to_string();
    ui.add(Label::new(RichText::new(&text).weak()).truncate()).on_hover_text(text);
}

/// Buttons in a row, the first one to be taken by Enter where `is_first_ready`.
fn choose(ui: &mut Ui, choices: &[Choice<'_>], is_first_ready: bool) -> Option<Reply> {
    let mut reply = None;
    ui.add_space(2.0 * GRID);
    ui.horizontal(|ui| {
        for (k, (text, tooltip, answer)) in choices.iter().enumerate() {
            let button = ui.add(Button::new(*text).min_size(egui::vec2(20.0 * GRID, 0.0))).on_hover_text(*tooltip);
            if k == 0 && is_first_ready && ui.memory(|memory| memory.focused().is_none()) {
                button.request_focus();
            }
            if button.clicked() {
                reply = Some(*answer);
            }
        }
    });
    reply
}

/// How long ago something was, in words.
fn age(now: SystemTime, then: SystemTime) -> String {
    let minutes = now.duration_since(then).unwrap_or(Duration::ZERO).as_secs() / 60;
    let (count, unit) = match minutes {
        0 => return "just now".to_owned(),
        1..60 => (minutes, "minute"),
        60..1440 => (minutes / 60, "hour"),
        _ => (minutes / 1440, "day"),
    };
    format!("{count} {unit}{} ago", if count == 1 { "" } else { "s" })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ages_are_told_in_words() {
        let now = SystemTime::now();
        let told = |seconds| age(now, now - Duration::from_secs(seconds));
        let expected =
            ["just now", "1 minute ago", "59 minutes ago", "1 hour ago", "23 hours ago", "1 day ago", "9 days ago"];
        let day = 24 * 3600;
        assert_eq!([0, 60, 3599, 3600, day - 1, day, 9 * day + 5].map(told), expected);
        assert_eq!(age(now - Duration::from_secs(9), now), "just now", "by a clock that was put back");
    }
}
