//! A pattern as text: its fibres in the unit cube.

use crate::edit::Command;
use crate::edit::fibre_ops::{BENDING, Called, laid, made_to_act};
use crate::sketch::pattern::{Act, OwnPattern};
use crate::ui::context::{Context, Severity, Step};
use serde::{Deserialize, Serialize};

/// What the text says that it holds.
pub(super) const PATTERN: &str = "pattern";

/// What is put on the clipboard.
#[derive(Serialize, Deserialize)]
struct Clipping {
    sinew: String,
    pattern: OwnPattern,
    /// Bending stiffness of its fibres over their axial rigidity, in particle spacings squared.
    bending: f64,
}

/// The pattern that is shown, as its numbers have it, as text; none where none is shown.
pub(crate) fn copied_pattern(
    title: &str,
    does: &str,
    acts: Vec<Option<Act>>,
    bending: f64,
    cx: &mut Context,
) -> Option<String> {
    let [min, max] = cx.pattern.bounds?;
    match OwnPattern::new(title, does, &cx.pattern.lines, min, max).and_then(|own| own.with_acts(acts)) {
        Ok(pattern) => {
            let text = serde_json::to_string(&Clipping { sinew: PATTERN.to_owned(), pattern, bending }).ok()?;
            cx.say(Severity::Note, format!("Copied the pattern {title}"));
            Some(text)
        }
        Err(error) => {
            cx.say(Severity::Error, error.to_string());
            None
        }
    }
}

/// Fits the pattern of a text to the body and puts its fibres there; false where the text holds none.
pub(super) fn paste(text: &str, cx: &mut Context) -> bool {
    let Ok(Clipping { pattern, bending, .. }) = serde_json::from_str::<Clipping>(text) else { return false };
    let (Some(body), Some([min, max])) = (cx.active_body(), cx.active.corners()) else {
        cx.say(Severity::Error, "The fibres of a pattern go into fibre solids: choose one in the list of bodies");
        return true;
    };
    let bending = if bending.is_finite() && bending > 0.0 { bending } else { BENDING };
    let called = Called { id: "pattern", title: pattern.title(), bending, spacing: cx.sampling().spacing };
    let lines = pattern.lay(min, max);
    let mut fibres = laid(called, &lines, &body.material, &body.fibres);
    let drives = made_to_act(&mut fibres, (&lines, pattern.acts()), called.id, &body.drives);
    let added: Vec<String> = fibres.iter().map(|fibre| fibre.id.clone()).collect();
    let commands = Command::additions(&body.id, drives, fibres);
    let command = Command::Many { name: format!("Paste pattern {}", pattern.title()), commands };
    cx.say(Severity::Note, format!("Pasted the pattern {}", pattern.title()));
    cx.edit(&command, Step::Own);
    cx.selection.set(added);
    true
}
