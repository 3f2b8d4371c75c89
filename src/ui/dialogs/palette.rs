//! The palette and the help: every action by its name, and every key.

use super::answer::Answer;
use crate::ui::action::{Action, ActionStates, GESTURES, Menu};
use crate::ui::controls::key_of;
use crate::ui::navigation::Navigation;
use crate::ui::theme::GRID;
use egui::{Key, RichText, ScrollArea, TextEdit, Ui};

/// Finds an action by its name.
pub(super) fn palette(ui: &mut Ui, text: &mut String, chosen: &mut usize, actions: &ActionStates) -> Answer {
    ui.set_width(360.0);
    let typed = ui.add(TextEdit::singleline(text).hint_text("Type a command").desired_width(f32::INFINITY));
    typed.request_focus();
    if typed.changed() {
        *chosen = 0;
    }
    let wanted = text.to_lowercase();
    let matches: Vec<Action> =
        Action::ALL.into_iter().filter(|action| action.name().to_lowercase().contains(&wanted)).collect();
    let (up, down, enter) = ui.input(|input| {
        (input.key_pressed(Key::ArrowUp), input.key_pressed(Key::ArrowDown), input.key_pressed(Key::Enter))
    });
    if down {
        *chosen += 1;
    }
    if up {
        *chosen = chosen.saturating_sub(1);
    }
    *chosen = (*chosen).min(matches.len().saturating_sub(1));
    let mut answer = Answer::None;
    ScrollArea::vertical().max_height(320.0).show(ui, |ui| {
        if matches.is_empty() {
            ui.label("No command of that name");
        }
        for (k, &action) in matches.iter().enumerate() {
            let key = key_of(ui, action);
            let button = egui::Button::selectable(k == *chosen, action.name())
                .shortcut_text(key)
                .min_size(egui::vec2(340.0, 0.0));
            let why = actions[action].disabled;
            let response = ui.add_enabled(why.is_none(), button).on_hover_text(action.tooltip());
            let clicked = response.on_disabled_hover_text(why.unwrap_or_default()).clicked();
            if clicked || (enter && k == *chosen && why.is_none()) {
                answer = Answer::Do(action);
            }
        }
    });
    answer
}

/// Lists every key and gesture.
pub(super) fn help(ui: &mut Ui, navigation: Navigation) -> Answer {
    ui.set_width(520.0);
    ui.heading("Keys and gestures");
    ScrollArea::vertical().max_height(0.7 * ui.ctx().content_rect().height()).show(ui, |ui| {
        egui::Grid::new("gestures").num_columns(2).spacing([6.0 * GRID, GRID]).show(ui, |ui| {
            for (gesture, effect) in GESTURES.into_iter().chain(navigation.gestures()) {
                ui.label(gesture);
                ui.label(RichText::new(effect).weak());
                ui.end_row();
            }
            for menu in Menu::ALL {
                ui.label(RichText::new(menu.title()).strong());
                ui.end_row();
                for action in Action::ALL.into_iter().filter(|action| action.menu() == menu) {
                    let keys: Vec<String> = action.shortcuts().iter().map(|s| ui.ctx().format_shortcut(s)).collect();
                    ui.label(format!("{}  {}", action.name(), keys.join(", ")));
                    ui.label(RichText::new(action.tooltip()).weak());
                    ui.end_row();
                }
            }
        });
    });
    if ui.button("Close").clicked() { Answer::Closed } else { Answer::None }
}
