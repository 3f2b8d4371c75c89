//! Fibres become a pattern of a person's own, which can be renamed and deleted.

use super::question::PatternQuestion;
use super::state::{Chosen, Fit, Patterns};
use crate::edit::fibre_ops;
use crate::geometry::curve::arc_length;
use crate::io::JsonFolder;
use crate::sketch::pattern::{Act, OwnPattern, Polyline};
use crate::ui::context::{Context, Request, Severity};
use crate::ui::dialogs::Dialog;

/// The fibres that would be kept, the selected ones, or all, with what each does by itself.
fn kept_fibres(cx: &Context) -> Result<Vec<(Polyline, Option<Act>)>, String> {
    let Some(body) = cx.active_body() else { return Ok(Vec::new()) };
    let selected = cx.selected_fibres();
    let fibres = if selected.is_empty() { body.fibres.iter().collect() } else { selected };
    let sampling = cx.sampling();
    let kept = |fibre| {
        let line = fibre_ops::vertices(fibre, sampling).map_err(|error| error.to_string())?;
        let act = fibre_ops::act_of(fibre, arc_length(&line), &body.drives);
        Ok((line, act))
    };
    fibres.into_iter().map(kept).collect()
}

impl Patterns {
    /// Asks what the pattern of the selected fibres is called.
    pub(crate) fn ask_to_keep(&self, cx: &mut Context) {
        if self.own.folder().is_none() {
            cx.say(
                Severity::Error,
                "There is no folder to keep patterns in: this system names none for programs' data",
            );
            return;
        }
        match kept_fibres(cx) {
            Ok(kept) => {
                let question = PatternQuestion::Keep { title: String::new(), does: String::new(), fibres: kept.len() };
                cx.request(Request::Open(Dialog::Pattern(question)));
            }
            Err(problem) => cx.say(Severity::Error, problem),
        }
    }

    /// Does what was asked about.
    pub(crate) fn answered(&mut self, question: &PatternQuestion, cx: &mut Context) {
        let Some(folder) = self.own.folder().cloned() else { return };
        let (done, said) = match question {
            PatternQuestion::Keep { title, does, .. } => (
                self.keep(&folder, title.trim(), does.trim(), cx),
                format!("{} is kept under Patterns, Yours", title.trim()),
            ),
            PatternQuestion::Rename { path, title } => (
                JsonFolder::set_text(path, "title", title.trim()).map_err(|error| error.to_string()),
                format!("The pattern is called {} now", title.trim()),
            ),
            PatternQuestion::Delete { path, title } => {
                (JsonFolder::remove(path).map_err(|error| error.to_string()), format!("{title} was deleted"))
            }
        };
        self.own.look_again();
        match done {
            Ok(()) => cx.say(Severity::Note, said),
            Err(problem) => cx.say(Severity::Error, problem),
        }
        if let Some(Chosen::Own(path)) = &self.chosen
            && self.own.get(path).is_none()
        {
            self.chosen = None;
        }
    }

    fn keep(&mut self, folder: &JsonFolder, title: &str, does: &str, cx: &mut Context) -> Result<(), String> {
        let (lines, acts): (Vec<_>, Vec<_>) = kept_fibres(cx)?.into_iter().unzip();
        let [min, max] = cx.active.corners().ok_or("The body is not there yet: save the pattern again in a moment")?;
        let own = OwnPattern::new(title, does, &lines, min, max).and_then(|own| own.with_acts(acts));
        let own = own.map_err(|error| error.to_string())?;
        folder.add(title, &own).map_err(|error| error.to_string())?;
        cx.request(Request::ShowPatterns);
        self.chosen = None;
        self.fit = Fit::Whole;
        Ok(())
    }
}
