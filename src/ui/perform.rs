//! What becomes of every action.

use super::action::Action;
use super::app::{App, Gravity};
use super::dialogs::{Dialog, PathPurpose};
use super::trust::{Next, Question};
use crate::sim::SimCommand;
use egui::{KeyboardShortcut, Modifiers};

impl App {
    /// Why an action cannot be asked for just now; none where it can.
    pub(super) fn obstacle(&self, action: Action) -> Option<&'static str> {
        let unless = |met: bool, why: &'static str| (!met).then_some(why);
        match action {
            Action::Undo => unless(self.editor.undo_name().is_some(), "There is nothing to undo"),
            Action::Redo => unless(self.editor.redo_name().is_some(), "There is nothing to redo"),
            Action::StepBack | Action::FirstFrame | Action::Replay if !self.published.compared.is_empty() => {
                Some("Nothing is recorded while integrators are compared")
            }
            Action::StepBack | Action::FirstFrame | Action::Replay => {
                unless(self.has_frames(), "There are no earlier frames yet")
            }
            Action::GoOn | Action::Live => unless(self.in_replay(), "The present is shown already"),
            Action::Reload => unless(self.path.is_some(), "The scene has no file yet"),
            Action::Recover => unless(!self.trust.left().is_empty(), "Nothing was left unsaved"),
            Action::KeepPattern => unless(self.can_keep_pattern(), "The body has no fibres"),
            action if action.edits_fibres() => self.editing_obstacle(action),
            _ => None,
        }
    }

    /// Whether a switch is on; none for what is no switch.
    pub(super) fn is_on(&self, action: Action) -> Option<bool> {
        match action {
            Action::XRay => Some(self.display.skin == crate::draw::SkinStyle::XRay),
            Action::Particles => Some(self.display.particles),
            Action::Springs => Some(self.display.springs),
            Action::Strokes => Some(self.display.strokes),
            Action::Grid => Some(self.display.grid),
            Action::Timeline => Some(self.timeline_shown()),
            Action::Tension => Some(self.seeing.tension),
            Action::Plots => Some(self.readings.open),
            Action::Vertices => Some(self.editing.selection.vertices().is_some()),
            Action::Redraw => Some(self.editing.redraws),
            Action::Paint => Some(self.editing.paints()),
            _ => None,
        }
    }

    /// Does what was asked for by keys.
    pub(super) fn perform_keys(&mut self, ctx: &egui::Context) {
        // While something is typed, plain keys belong to the text, with Shift, too.
        let typing = ctx.egui_wants_keyboard_input();
        let mut keys: Vec<(Action, KeyboardShortcut)> = Action::ALL
            .into_iter()
            .flat_map(|action| action.shortcuts().iter().map(move |shortcut| (action, *shortcut)))
            .filter(|(_, shortcut)| !typing || shortcut.modifiers.alt || shortcut.modifiers.command)
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
            match self.obstacle(action) {
                None => self.perform(ctx, action),
                Some(why) => self.say(Gravity::Note, format!("{}: {why}", action.name())),
            }
        }
    }

    /// Does what was asked for.
    pub fn perform(&mut self, ctx: &egui::Context, action: Action) {
        match action {
            Action::New => self.leave(ctx, Next::New),
            Action::Open => self.dialog = Some(Dialog::path(PathPurpose::Open, self.path.as_deref())),
            Action::Reload => self.reload(),
            Action::Save => self.save_then(ctx, None),
            Action::SaveAs => self.ask_where(None),
            Action::Export => self.ask_where_to_export(),
            Action::Recover => self.dialog = Some(Dialog::Question(Question::Recover)),
            Action::Quit => self.leave(ctx, Next::Quit),
            Action::Examples => self.dialog = Some(Dialog::Examples),
            Action::Patterns | Action::KeepPattern => self.pattern_action(action),
            Action::Undo => {
                if self.editor.undo() {
                    self.hand_over();
                }
            }
            Action::Redo => {
                if self.editor.redo() {
                    self.hand_over();
                }
            }
            Action::PlayPause => {
                let playing = self.published.status.playing;
                self.ask(if playing { SimCommand::Pause } else { SimCommand::Play });
            }
            Action::Step => self.ask(SimCommand::Step),
            Action::StepBack => self.look_back(SimCommand::StepBack),
            Action::FirstFrame => self.show_first(),
            Action::Replay => self.look_back(SimCommand::Replay),
            Action::GoOn => self.ask(SimCommand::ContinueHere),
            Action::Live => self.ask(SimCommand::Live),
            Action::Reset => self.ask(SimCommand::Reset),
            Action::ReleasePins => self.ask(SimCommand::ReleaseAll),
            Action::Frame => self.reframe(true),
            Action::FrameAll => self.reframe(false),
            Action::XRay => {
                use crate::draw::SkinStyle::{Shaded, XRay};
                self.display.skin = if self.display.skin == XRay { Shaded } else { XRay };
            }
            Action::Particles => {
                self.display.particles = !self.display.particles;
                self.display.structure = self.display.particles;
            }
            Action::Springs => self.display.springs = !self.display.springs,
            Action::Strokes => self.display.strokes = !self.display.strokes,
            Action::Grid => self.display.grid = !self.display.grid,
            Action::Timeline => self.fold_timeline(),
            Action::ColourMap => self.next_field(),
            Action::Tension => self.toggle_tension(),
            Action::Slice => self.next_slice(),
            Action::Ghost => self.next_ghost(),
            Action::Plots => self.readings.open = !self.readings.open,
            Action::Theme => {
                self.tone = self.tone.other();
                self.tone.apply(ctx);
            }
            Action::Palette => self.dialog = Some(Dialog::palette()),
            Action::Help => self.dialog = Some(Dialog::Help),
            // All that is left is about the selected fibres.
            _ => self.edit_fibres(ctx, action),
        }
    }
}
