//! What is offered where a body was stopped, and taken back where it did not help.

use super::context::{Context, Severity, Step};
use crate::edit::Command;
use crate::scene::{Scene, TimeStep};
use crate::sim::SimCommand;
use egui::Ui;
use std::sync::Arc;

/// What was tried, and what is known not to help.
#[derive(Default)]
pub(super) struct Remedy {
    tried: Option<Tried>,
    /// The scene that it did not help.
    in_vain: Option<Arc<Scene>>,
}

/// A remedy at work.
struct Tried {
    /// The change is one step of undo.
    gesture: u64,
    /// The scene with it.
    scene: Arc<Scene>,
    what: &'static str,
}

impl Remedy {
    /// Offers what may take a body that was stopped on again, unless that was in vain.
    pub(super) fn offer(&mut self, ui: &mut Ui, cx: &mut Context) {
        if self.in_vain.as_ref().is_some_and(|scene| Arc::ptr_eq(scene, cx.scene())) {
            return;
        }
        let mut time = cx.scene().time.clone();
        let (text, tooltip, what) = match &mut time.step {
            TimeStep::Manual(_) => {
                time.step = TimeStep::default();
                let tooltip = "Chooses the time step from the stable one that is measured";
                ("Step automatically and restart", tooltip, "An automatic step")
            }
            TimeStep::Automatic(step) => {
                step.safety = (0.5 * step.safety).max(0.01);
                let tooltip = "Halves the share of the stable time step that is used; taken back if it does not help";
                ("Halve the step and restart", tooltip, "Half the step")
            }
        };
        if ui.button(text).on_hover_text(tooltip).clicked() {
            let gesture = cx.begin_gesture();
            cx.edit(&Command::SetTime(time), Step::Of(gesture));
            cx.begin_gesture();
            cx.ask(SimCommand::Reset);
            cx.ask(SimCommand::Play);
            self.tried = Some(Tried { gesture, scene: Arc::clone(cx.scene()), what });
        }
    }

    /// Takes back what did not help.
    pub(super) fn watch(&mut self, cx: &mut Context) {
        let Some(tried) = &self.tried else { return };
        if !Arc::ptr_eq(&tried.scene, cx.scene()) {
            // The person has gone on to something else.
            self.tried = None;
            return;
        }
        let status = &cx.simulation.published().status;
        let has_begun = cx.simulation.is_up_to_date() && status.baking.is_none();
        let Some(stopped) = status.divergence.as_ref().filter(|_| has_begun) else { return };
        let said = format!("{} did not help and was taken back: {}", tried.what, cx.scene().with_names(stopped));
        let gesture = tried.gesture;
        cx.abandon(gesture);
        cx.ask(SimCommand::Pause);
        cx.ask(SimCommand::Reset);
        cx.say(Severity::Error, said);
        self.in_vain = Some(Arc::clone(cx.scene()));
        self.tried = None;
    }
}
