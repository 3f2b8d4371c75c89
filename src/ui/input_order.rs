//! What the hands did between two pictures, taken up in the order in which they did it.
//!
//! How it works. Where pictures are slow, a press, all that the pointer drew and its release come as the input of one
//! frame. The toolkit asks of a frame only where the pointer came to rest in it and which buttons changed; a stroke
//! that begins and ends in one is none to it. So the events of a frame are dealt out over several passes, each with at
//! most one change that others depend on: a button, or a key. All passes but the last are not drawn, and cost what
//! laying the window out takes.
//!
//! Why not otherwise. Tools that read the events themselves would each have to find out anew what lies under the
//! pointer, and buttons, menus and fields would still lose clicks. To wait a picture for each event would have slow
//! machines lag the more behind.

use egui::{Context, Event, Plugin, RawInput, Ui};
use std::collections::VecDeque;
use std::num::NonZeroUsize;

/// Passes that a frame has at most; what is left comes in the next.
const MOST_PASSES: NonZeroUsize = NonZeroUsize::new(96).expect("it is more than none");

/// A finger that rests so long asks for a menu [s]. A mouse button may be held as long as one likes before it clicks.
const LONG_TOUCH: f64 = 0.8;

/// Two clicks are a double click up to this long apart [s], as far as frames tell them apart.
const DOUBLE_CLICK: f64 = 0.3;

/// Deals the events of a frame out over passes.
#[derive(Debug, Default)]
pub(super) struct InputOrder {
    waiting: VecDeque<Event>,
    /// When the last frame was [s].
    last: f64,
}

/// What an event has to do with those around it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    /// The pointer goes somewhere.
    Way,
    Press,
    Release,
    /// A key goes down.
    Key,
    /// Modifiers change, for what comes after.
    Modifiers,
    /// It goes with whatever was before it.
    Other,
}

fn kind(event: &Event) -> Kind {
    match event {
        Event::PointerMoved(_) | Event::MouseWheel { .. } | Event::Zoom(_) | Event::Rotate(_) => Kind::Way,
        Event::PointerButton { pressed: true, .. } => Kind::Press,
        Event::PointerButton { pressed: false, .. } => Kind::Release,
        // A command of the keyboard comes as one of these in place of its key.
        Event::Key { pressed: true, .. } | Event::Copy | Event::Cut | Event::Paste(_) => Kind::Key,
        Event::ModifiersChanged(_) => Kind::Modifiers,
        _ => Kind::Other,
    }
}

/// Whether an event may be taken up together with those before it.
fn goes_with(event: Kind, before: &[Kind]) -> bool {
    let has = |kind| before.contains(&kind);
    if has(Kind::Press) || has(Kind::Release) {
        return false;
    }
    match event {
        Kind::Way | Kind::Press => !has(Kind::Key),
        Kind::Release | Kind::Key | Kind::Modifiers => !has(Kind::Key) && !has(Kind::Way),
        Kind::Other => true,
    }
}

/// Takes the first of the events that may be taken up together.
fn take_group(waiting: &mut VecDeque<Event>) -> Vec<Event> {
    let mut kinds = Vec::new();
    for event in waiting.iter() {
        let kind = kind(event);
        if !goes_with(kind, &kinds) {
            break;
        }
        kinds.push(kind);
    }
    waiting.drain(..kinds.len()).collect()
}

impl Plugin for InputOrder {
    fn debug_name(&self) -> &'static str {
        "input order"
    }

    fn setup(&mut self, ctx: &Context) {
        ctx.options_mut(|options| {
            options.max_passes = MOST_PASSES;
            options.input_options.max_click_duration = f64::INFINITY;
        });
    }

    fn input_hook(&mut self, ctx: &Context, input: &mut RawInput) {
        let now = input.time.unwrap_or(self.last + f64::from(input.predicted_dt));
        let frame = (now - self.last).clamp(0.0, 1.0);
        self.last = now;
        self.waiting.extend(input.events.drain(..));
        input.events = take_group(&mut self.waiting);
        let touches = input.events.iter().any(|event| matches!(event, Event::Touch { .. }));
        let moves = input.events.iter().any(|event| matches!(event, Event::MouseMoved(_) | Event::PointerMoved(_)));
        ctx.options_mut(|options| {
            let options = &mut options.input_options;
            if touches {
                options.max_click_duration = LONG_TOUCH;
            } else if moves {
                options.max_click_duration = f64::INFINITY;
            }
            if frame > 0.0 {
                options.max_double_click_delay = DOUBLE_CLICK + frame;
            }
        });
    }

    fn on_begin_pass(&mut self, ui: &mut Ui) {
        if !self.waiting.is_empty() {
            ui.ctx().request_discard("more of the input waits");
            // Should there be no pass for it any more in this frame.
            ui.ctx().request_repaint();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui::{Key, Modifiers, PointerButton, Pos2};

    fn to(x: f32) -> Event {
        Event::PointerMoved(Pos2::new(x, 0.0))
    }

    fn button(x: f32, pressed: bool) -> Event {
        let (pos, modifiers) = (Pos2::new(x, 0.0), Modifiers::NONE);
        Event::PointerButton { pos, button: PointerButton::Primary, pressed, modifiers }
    }

    fn key(key: Key) -> Event {
        Event::Key { key, physical_key: None, pressed: true, repeat: false, modifiers: Modifiers::NONE }
    }

    #[test]
    fn each_group_has_one_change_that_others_depend_on_and_nothing_is_lost() {
        let shift = Event::ModifiersChanged(Modifiers::SHIFT);
        let events = vec![
            (0, to(0.0)),
            (0, button(0.0, true)),
            (1, to(10.0)),
            (1, to(20.0)),
            (2, button(20.0, false)),
            (3, key(Key::G)),
            (3, Event::Text("g".to_owned())),
            (4, to(30.0)),
            (5, shift),
            (5, to(40.0)),
            (5, button(40.0, true)),
            (6, button(40.0, false)),
            (7, key(Key::X)),
            (8, key(Key::Num5)),
        ];
        let mut waiting: VecDeque<Event> = events.iter().map(|(_, event)| event.clone()).collect();
        let mut dealt = Vec::new();
        for group in 0.. {
            let taken = take_group(&mut waiting);
            if taken.is_empty() {
                break;
            }
            dealt.extend(taken.into_iter().map(|event| (group, event)));
        }
        assert_eq!(dealt, events);
    }
}
