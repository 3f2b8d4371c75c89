//! Putting edited fibres and sheets into the document.

use crate::edit::Command;
use crate::edit::fibre_ops::{Edited, FibreEditError};
use crate::scene::Sheet;
use crate::ui::context::{Context, Severity, Step};

/// Puts edited fibres in the place of those with their identifiers, and says what they lost.
pub(crate) fn set_fibres(cx: &mut Context, verb: &str, edited: Result<Vec<Edited>, FibreEditError>, step: Step) {
    let Some(body) = cx.active_body().map(|body| body.id.clone()) else { return };
    match edited {
        Ok(edited) => {
            let note = edited.iter().find_map(|edited| edited.note.clone());
            let fibres = edited.into_iter().map(|edited| edited.fibre).collect();
            cx.edit(&Command::set_fibres(verb, &body, fibres), step);
            if let Some(note) = note {
                cx.say(Severity::Note, note);
            }
        }
        Err(error) => cx.say(Severity::Error, error.to_string()),
    }
}

/// Puts an edited sheet in the place of the one with its identifier.
pub(super) fn set_sheet(cx: &mut Context, verb: &str, edited: Result<Sheet, FibreEditError>, step: Step) {
    let Some(body) = cx.active_body().map(|body| body.id.clone()) else { return };
    match edited {
        Ok(sheet) => cx.edit(&Command::SetSheet { verb: verb.to_owned(), body, sheet }, step),
        Err(error) => cx.say(Severity::Error, error.to_string()),
    }
}
