//! Keys that belong to a gesture of editing while it goes on.

use super::motion::end_moving;
use super::state::Editing;
use crate::ui::context::Context;
use egui::{Event, Key};

/// Keys while something is moved, or a box is drawn, or the brush is in use; whether they were taken.
pub(crate) fn take_keys(editing: &mut Editing, ctx: &egui::Context, cx: &mut Context) -> bool {
    let escaped = ctx.input(|input| input.key_pressed(Key::Escape));
    if editing.brush.is_some() && escaped {
        editing.brush = None;
        return true;
    }
    if editing.boxed.is_some() && escaped {
        editing.boxed = None;
        return true;
    }
    let Some((moving, _)) = &mut editing.moving else { return false };
    let (mut keep, mut back) = (false, false);
    let events = ctx.input(|input| input.events.clone());
    for event in events {
        match event {
            Event::Text(text) => {
                moving.typed.extend(text.chars().filter(|c| c.is_ascii_digit() || "+-*/^().ecmkµ ".contains(*c)));
            }
            Event::Key { key, pressed: true, .. } => match key {
                Key::X | Key::Y | Key::Z => {
                    let axis = [Key::X, Key::Y, Key::Z].iter().position(|known| *known == key);
                    moving.axis = if moving.axis == axis { None } else { axis };
                }
                Key::Backspace => {
                    moving.typed.pop();
                }
                Key::Enter => keep = true,
                Key::Escape => back = true,
                _ => {}
            },
            _ => {}
        }
    }
    if back {
        end_moving(editing, false, cx);
    } else if keep {
        end_moving(editing, true, cx);
    }
    true
}
