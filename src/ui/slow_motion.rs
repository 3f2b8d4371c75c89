//! The scene from its start in slow motion, beside itself as it is otherwise.

use super::context::{Context, Ghost};
use super::top_bar::TopBar;
use crate::sim::SimCommand;
use std::sync::Arc;

/// How it is shown.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct SlowMotion {
    /// What runs beside it.
    pub ghost: Ghost,
    /// Simulated over real time.
    pub speed: f64,
    /// Frames for each of the scene's, so that it is smooth.
    pub finer: f64,
    /// What is seen, and what to do.
    pub caption: &'static str,
}

impl SlowMotion {
    /// Begins to play what is open; gives the speed of before.
    pub(super) fn begin(self, cx: &mut Context, top_bar: &mut TopBar) -> f64 {
        let mut finer = (**cx.scene()).clone();
        finer.time.frames_per_second *= self.finer;
        cx.simulation.show_instead(Some(Arc::new(finer)), &cx.document);
        cx.simulation.choose_ghost(Some(self.ghost), &cx.document);
        let before = top_bar.speed();
        top_bar.choose_speed(self.speed, cx);
        cx.ask(SimCommand::Reset);
        cx.ask(SimCommand::Play);
        cx.caption = Some(self.caption);
        cx.ghost_beside = true;
        before
    }

    /// Ends it: what is open is shown as it is, at this speed. Another ghost or document that was chosen meanwhile
    /// stays.
    pub(super) fn end(self, speed: f64, cx: &mut Context, top_bar: &mut TopBar) {
        cx.caption = None;
        cx.ghost_beside = false;
        if cx.simulation.ghost() == Some(self.ghost) {
            cx.simulation.choose_ghost(None, &cx.document);
        }
        if cx.simulation.shows_instead() {
            cx.simulation.show_instead(None, &cx.document);
        }
        top_bar.choose_speed(speed, cx);
    }
}
