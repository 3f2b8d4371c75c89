//! A sheet as text, with the drive that it follows.

use crate::edit::Command;
use crate::edit::fibre_ops::Transform;
use crate::edit::sheet_ops;
use crate::scene::{Drive, SharedDrive, Sheet};
use crate::ui::context::{Context, Severity, Step};
use glam::DVec3;
use serde::{Deserialize, Serialize};

/// What the text says that it holds.
pub(super) const SHEET: &str = "sheet";

/// What is put on the clipboard. Places are those of the model frame [m].
#[derive(Serialize, Deserialize)]
struct Clipping {
    sinew: String,
    sheet: Sheet,
    /// The drive of the body that the sheet names, if it does.
    #[serde(default)]
    drive: Option<SharedDrive>,
}

/// The selected sheet as text.
pub(super) fn copied(cx: &mut Context) -> Option<String> {
    let (body, sheet) = cx.selected_sheet()?;
    let shared = match sheet.activation.as_ref().map(|of| &of.drive) {
        Some(Drive::Shared(id)) => body.drives.iter().find(|drive| drive.id == *id).cloned(),
        _ => None,
    };
    let clipping = Clipping { sinew: SHEET.to_owned(), sheet: sheet.clone(), drive: shared };
    let (said, text) = (format!("Copied {}", sheet.title()), serde_json::to_string_pretty(&clipping).ok()?);
    cx.say(Severity::Note, said);
    Some(text)
}

/// Puts the sheet of a text into the body, selected; false where the text holds none.
pub(super) fn paste(text: &str, cx: &mut Context) -> bool {
    let Ok(Clipping { mut sheet, drive, .. }) = serde_json::from_str::<Clipping>(text) else { return false };
    let Some(body) = cx.active_body() else {
        cx.say(Severity::Error, "Sheets go into fibre solids: choose one in the list of bodies");
        return true;
    };
    // The drive that it followed where it is from becomes its own, unless the body has the same.
    if let (Some(of), Some(drive)) = (&mut sheet.activation, drive)
        && !body.drives.contains(&drive)
    {
        of.drive = drive.drive;
    }
    let lies_on_like = body.sheets.iter().any(|known| known.source == sheet.source);
    let aside = if lies_on_like { cx.sampling().spacing * DVec3::ONE } else { DVec3::ZERO };
    let moved =
        sheet_ops::transform(&sheet_ops::copy(&sheet, &body.sheets), &Transform::translation(aside), cx.sampling());
    match moved {
        Ok(sheet) => {
            let (body, id, name) = (body.id.clone(), sheet.id.clone(), format!("Paste {}", sheet.title()));
            cx.edit(&Command::Many { name, commands: vec![Command::AddSheet { body, sheet }] }, Step::Own);
            let is_there = cx.active_body().is_some_and(|body| body.sheets.iter().any(|known| known.id == id));
            if is_there {
                cx.selection.choose_sheet(id);
            }
        }
        Err(error) => cx.say(Severity::Error, error.to_string()),
    }
    true
}
