//! Buttons for actions: greyed with the reason where they cannot be asked for.

use super::action::Action;
use super::context::{Context, Request};
use egui::{Button, Ui};

/// The key of an action as people read it; empty where it has none.
pub(super) fn key_of(ui: &Ui, action: Action) -> String {
    action.shortcuts().first().map_or_else(String::new, |shortcut| ui.ctx().format_shortcut(shortcut))
}

/// A plain button for an action, with its name and key in the tooltip.
pub(super) fn button(ui: &mut Ui, cx: &mut Context, action: Action, text: &str) {
    let key = key_of(ui, action);
    let hover = if key.is_empty() { action.tooltip().to_owned() } else { format!("{} ({key})", action.tooltip()) };
    let disabled = cx.actions[action].disabled;
    let response = ui.add_enabled(disabled.is_none(), Button::new(text)).on_hover_text(hover);
    if response.on_disabled_hover_text(disabled.unwrap_or_default()).clicked() {
        cx.request(Request::Do(action));
    }
}
