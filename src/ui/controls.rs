//! Buttons and menu entries for actions: greyed with the reason where they cannot be asked for.

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

/// A menu entry for an action, marked where it is a switch that is on.
pub(super) fn menu_entry(ui: &mut Ui, cx: &mut Context, action: Action) {
    let state = &cx.actions[action];
    let disabled = state.disabled;
    // Undo and redo say what they would do.
    let text = match &state.detail {
        Some(detail) => format!("{}: {}", action.name(), lower_first(detail)),
        None => action.name().to_owned(),
    };
    let mut button = match state.on {
        Some(on) => Button::selectable(on, text),
        None => Button::new(text),
    };
    let key = key_of(ui, action);
    if !key.is_empty() {
        button = button.shortcut_text(key);
    }
    let response = ui.add_enabled(disabled.is_none(), button).on_hover_text(action.tooltip());
    if response.on_disabled_hover_text(disabled.unwrap_or_default()).clicked() {
        cx.request(Request::Do(action));
        ui.close();
    }
}

fn lower_first(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_lowercase().chain(letters).collect())
}
