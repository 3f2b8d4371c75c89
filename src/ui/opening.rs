//! What a newcomer sees first: the scene that the window starts with, in slow motion and beside itself without fibres,
//! over and over until something is touched.

use super::context::{Context, Ghost};
use super::top_bar::TopBar;
use crate::sim::SimCommand;
use egui::Event;
use std::sync::Arc;

/// Simulated over real time.
const SPEED: f64 = 0.06;
/// As many frames for each of the scene's, so that slow motion is smooth.
const FINER: f64 = 16.0;
/// When it begins again [s, simulated]: it has landed, twisted, swung back and leapt off by then.
const LASTS: f64 = 0.2;
/// What is seen, and what to do.
const CAPTION: &str = "Its fibres twist the bar as it lands; the pale one has none. Draw fibres of your own on the left, or \
                       drag the bar.";

/// Plays the scene until something is touched.
#[derive(Default)]
pub(super) struct Opening {
    plays: bool,
}

impl Opening {
    /// Begins to play what is open.
    pub(super) fn begin(&mut self, cx: &mut Context, top_bar: &mut TopBar) {
        let mut finer = (**cx.scene()).clone();
        finer.time.frames_per_second *= FINER;
        cx.simulation.show_instead(Some(Arc::new(finer)), &cx.document);
        cx.simulation.choose_ghost(Some(Ghost::WithoutFibres), &cx.document);
        top_bar.choose_speed(SPEED, cx);
        cx.ask(SimCommand::Reset);
        cx.caption = Some(CAPTION);
        cx.ghost_beside = true;
        self.plays = true;
    }

    /// Begins again after a while, and ends with the first thing that is touched.
    pub(super) fn watch(&mut self, ctx: &egui::Context, cx: &mut Context, top_bar: &mut TopBar) {
        if !self.plays {
            return;
        }
        let is_touched = ctx.input(|input| {
            let touches = |event: &Event| {
                matches!(
                    event,
                    Event::PointerButton { pressed: true, .. }
                        | Event::Key { pressed: true, .. }
                        | Event::AccessKitActionRequest(_)
                )
            };
            input.events.iter().any(touches) || !input.raw.dropped_files.is_empty()
        });
        if is_touched {
            self.plays = false;
            cx.caption = None;
            cx.ghost_beside = false;
            cx.simulation.choose_ghost(None, &cx.document);
            cx.simulation.show_instead(None, &cx.document);
            top_bar.choose_speed(1.0, cx);
        } else if cx.simulation.published().status.time >= LASTS {
            cx.ask(SimCommand::Reset);
        }
    }
}
