//! What the window takes up before it shows anything: the newest state of the simulation, keys and drops.

use super::App;
use crate::io::is_model;
use crate::sim::Published;
use crate::ui::action::Action;
use crate::ui::bodies::Layers;
use crate::ui::clipboard;
use crate::ui::context::Severity;
use crate::ui::drives;
use crate::ui::editing;
use crate::ui::next::Next;
use egui::{Event, Key, KeyboardShortcut, Modifiers};

impl App {
    /// Takes the newest state of the simulation and what the person asks for by keys and drops.
    pub(super) fn listen(&mut self, ctx: &egui::Context) {
        if let Some(before) = self.cx.simulation.take() {
            self.take_state(&before);
        }
        self.opening.watch(ctx, &mut self.cx, &mut self.top_bar);
        self.effect.watch(ctx, &mut self.cx, &mut self.top_bar);
        if ctx.input(|input| input.pointer.any_released()) {
            self.cx.begin_gesture();
        }
        let dropped = ctx.input(|input| input.raw.dropped_files.iter().map(|file| file.path().to_owned()).next());
        if let Some(path) = dropped {
            // Into a scene of one's own a model comes beside what is there.
            if is_model(&path) && (self.cx.document.is_changed() || self.cx.scene().all_bodies().next().is_none()) {
                self.add_body_of(ctx, path, Layers::Filled);
                self.carry_out(ctx);
            } else {
                self.leave(ctx, Next::Open(path));
            }
        }
        // Keys belong to what stands in front of everything.
        if self.dialog.is_some() || editing::take_keys(self.views.editing_mut(), ctx, &mut self.cx) {
            return;
        }
        if ctx.input(|input| input.key_pressed(Key::Escape)) {
            self.views.sketching().cancel();
            self.prepare_pattern();
            if self.cx.pattern.takes_region {
                self.patterns.leave_region();
            }
        }
        self.set_key(ctx);
        self.dispatch_keys(ctx);
        self.use_clipboard(ctx);
    }

    /// Sets a key of what is under the pointer, or takes it away, where `I` is pressed over a field that can be driven.
    fn set_key(&mut self, ctx: &egui::Context) {
        let pointed = self.cx.pointed.take();
        if let Some(of) = pointed.filter(|_| !ctx.egui_wants_keyboard_input())
            && ctx.input_mut(|input| input.consume_key(Modifiers::NONE, Key::I))
        {
            drives::toggle_key(&of, &mut self.cx);
        }
    }

    /// Copies and pastes, unless that is meant for a text.
    fn use_clipboard(&mut self, ctx: &egui::Context) {
        if ctx.egui_wants_keyboard_input() {
            return;
        }
        for event in ctx.input(|input| input.events.clone()) {
            match event {
                Event::Copy => self.dispatch(ctx, Action::Copy),
                Event::Cut => self.dispatch(ctx, Action::Cut),
                Event::Paste(text) => clipboard::paste(&text, &mut self.cx),
                _ => {}
            }
        }
    }

    /// Takes up a state that follows another one.
    fn take_state(&mut self, before: &Published) {
        let now = self.cx.simulation.published().clone();
        // What was noticed before the motion began is said before what happened in it. What nobody has to act on does
        // not take the place of what somebody has, such as why a model was opened in so many particles.
        let is_heeded = matches!(self.cx.status.message, Some((Severity::Warning | Severity::Error, _)));
        if now.status.notes != before.status.notes
            && (now.status.warns || !is_heeded)
            && let Some(text) = now.status.notes.last()
        {
            let more = match now.status.notes.len() - 1 {
                0 => String::new(),
                more => format!(" (and {more} more: `sinew check` lists them)"),
            };
            let said = self.cx.scene().with_names(text) + &more;
            self.cx.say_of_scene(if now.status.warns { Severity::Warning } else { Severity::Note }, said);
        }
        if let Some(unbalanced) =
            now.status.unbalanced.as_ref().filter(|_| now.status.unbalanced != before.status.unbalanced)
        {
            let said = self.cx.scene().with_names(unbalanced);
            self.cx.say_of_scene(Severity::Warning, said);
        }
        self.breaks.watch(before, &mut self.cx);
        self.remedy.watch(&mut self.cx);
        if now.compared.len() != before.compared.len() {
            self.views.reframe(false);
        }
        self.comparison.record(&now.compared);
        if !std::sync::Arc::ptr_eq(&now.at_rest, &before.at_rest) {
            let last = self.cx.scene().all_bodies().count().saturating_sub(1);
            self.cx.active.index = self.cx.active.index.min(last);
            self.cx.take_model();
            if now.at_rest.bodies.len() > before.at_rest.bodies.len() {
                // What has come into the scene is to be seen.
                self.views.reframe(false);
            }
        }
    }

    /// Does what was asked for by keys.
    fn dispatch_keys(&mut self, ctx: &egui::Context) {
        // While something is typed, plain keys belong to the text, with Shift, too.
        let typing = ctx.egui_wants_keyboard_input();
        let mut keys: Vec<(Action, KeyboardShortcut)> = Action::ALL
            .into_iter()
            .flat_map(|action| action.shortcuts().iter().map(move |shortcut| (action, *shortcut)))
            .filter(|(_, shortcut)| !typing || !is_of_text(*shortcut))
            .collect();
        // Those with most modifiers first: Ctrl+Shift+Z must not be taken for Ctrl+Z, nor Alt+H for H.
        let held = |shortcut: &KeyboardShortcut| {
            let Modifiers { alt, shift, ctrl, command, .. } = shortcut.modifiers;
            [alt, shift, ctrl || command].into_iter().filter(|held| *held).count()
        };
        keys.sort_by_key(|(_, shortcut)| std::cmp::Reverse(held(shortcut)));
        let asked: Vec<Action> = ctx.input_mut(|input| {
            keys.into_iter()
                .filter(|(_, shortcut)| input.consume_shortcut(shortcut))
                .map(|(action, _)| action)
                .collect()
        });
        for action in asked {
            self.dispatch(ctx, action);
        }
    }
}

/// Whether a key belongs to a text while one is typed.
fn is_of_text(shortcut: KeyboardShortcut) -> bool {
    let KeyboardShortcut { modifiers, logical_key } = shortcut;
    let commands = !modifiers.shift && matches!(logical_key, Key::A | Key::C | Key::V | Key::X);
    !modifiers.alt && (!modifiers.command || commands)
}
