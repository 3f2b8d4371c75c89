//! The system's clipboard: fibres, sheets, bodies, keys of drives and patterns as JSON text, so that they go from scene
//! to scene, window to window and into letters.

mod bodies;
mod fibres;
mod patterns;
mod sheets;

pub(crate) use patterns::copied_pattern;

use super::context::{Context, Severity};
use super::drives;
use serde::Deserialize;

/// What a text says that it holds.
#[derive(Deserialize)]
struct Clipping {
    sinew: String,
}

/// What is selected as text.
pub(super) fn copied(cx: &mut Context) -> Option<String> {
    if !cx.keys.is_empty() {
        drives::copied_keys(cx)
    } else if cx.selection.is_body() {
        bodies::copied(cx)
    } else if cx.selection.sheet().is_some() {
        sheets::copied(cx)
    } else {
        fibres::copied(cx)
    }
}

/// Puts what a text holds into the scene, selected.
pub(super) fn paste(text: &str, cx: &mut Context) {
    let holds = serde_json::from_str::<Clipping>(text).map(|clipping| clipping.sinew);
    let is_pasted = match holds.as_deref() {
        Ok(fibres::FIBRES) => fibres::paste(text, cx),
        Ok(sheets::SHEET) => sheets::paste(text, cx),
        Ok(drives::KEYS) => drives::paste_keys(text, cx),
        Ok(bodies::BODY) => bodies::paste(text, cx),
        Ok(patterns::PATTERN) => patterns::paste(text, cx),
        _ => false,
    };
    if !is_pasted {
        let text = "The clipboard holds no fibres, sheet, body, keys or pattern: copy some with Ctrl+C first";
        cx.say(Severity::Warning, text);
    }
}
