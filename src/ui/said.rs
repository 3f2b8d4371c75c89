//! Messages go when they cease to be true: as the person goes on from where they were said, or once they were read.

use super::context::{Context, Selection, Severity};
use crate::scene::Scene;
use egui::Ui;
use std::sync::Arc;

/// How long a note and anything more serious stay at least, and for each letter more [s].
const NOTE: [f64; 2] = [6.0, 0.07];
const HEEDED: [f64; 2] = [20.0, 0.1];

/// The message that is shown, and since when.
#[derive(Default)]
pub(super) struct Said {
    shown: Option<(Severity, String)>,
    /// Since when [s].
    since: f64,
    /// How things stood then.
    standing: Option<Standing>,
}

/// What a person does not leave as it is when going on to something else.
struct Standing {
    scene: Arc<Scene>,
    selection: Selection,
    strokes: u8,
}

impl Standing {
    fn of(cx: &Context) -> Self {
        let strokes = cx.status.strokes;
        Self { scene: Arc::clone(cx.scene()), selection: cx.selection.clone(), strokes }
    }
}

impl Said {
    /// Drops the message where it is no longer true. What is said of the scene is true as long as that stays as it is.
    pub(super) fn review(&mut self, ui: &Ui, cx: &mut Context) {
        let now = ui.input(|input| input.time);
        if cx.status.message != self.shown {
            self.shown.clone_from(&cx.status.message);
            self.since = now;
            self.standing = Some(Standing::of(cx));
        }
        let (Some((severity, text)), Some(then)) = (&self.shown, &self.standing) else { return };
        let has_scene = Arc::ptr_eq(&then.scene, cx.scene());
        let stays = if cx.status.of_scene {
            has_scene
        } else {
            let [least, letter] = if *severity == Severity::Note { NOTE } else { HEEDED };
            let left = least + letter * text.chars().count() as f64 - (now - self.since);
            if left > 0.0 {
                ui.ctx().request_repaint_after_secs(left as f32 + 0.05);
            }
            has_scene && then.selection == cx.selection && then.strokes == cx.status.strokes && left > 0.0
        };
        if !stays {
            cx.status.message = None;
            self.shown = None;
        }
    }
}
