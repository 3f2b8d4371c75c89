//! What a newcomer sees first: the scene that the window starts with, in slow motion and beside itself without fibres,
//! over and over until something is touched.

use super::context::{Context, Ghost};
use super::slow_motion::SlowMotion;
use super::top_bar::TopBar;
use crate::sim::SimCommand;
use egui::Event;

const SHOWN: SlowMotion = SlowMotion {
    ghost: Ghost::WithoutFibres,
    speed: 0.06,
    finer: 16.0,
    caption: "Its fibres twist the bar as it lands; the pale one has none. Draw fibres of your own on the left, or drag the \
              bar.",
};
/// When it begins again [s, simulated]: it has landed, twisted, swung back and leapt off by then.
const LASTS: f64 = 0.2;

/// Plays the scene until something is touched.
#[derive(Default)]
pub(super) struct Opening {
    /// Simulated over real time before, while it plays.
    plays: Option<f64>,
}

impl Opening {
    /// Begins to play what is open.
    pub(super) fn begin(&mut self, cx: &mut Context, top_bar: &mut TopBar) {
        self.plays = Some(SHOWN.begin(cx, top_bar));
    }

    /// Begins again after a while, and ends with the first thing that is touched.
    pub(super) fn watch(&mut self, ctx: &egui::Context, cx: &mut Context, top_bar: &mut TopBar) {
        let Some(speed) = self.plays else { return };
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
            self.plays = None;
            SHOWN.end(speed, cx, top_bar);
        } else if cx.simulation.published().status.time >= LASTS {
            cx.ask(SimCommand::Reset);
        }
    }
}
