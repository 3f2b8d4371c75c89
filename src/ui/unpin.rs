//! Taking a pin away, of whichever kind.

use super::context::{ChosenPin, Context, Step};
use crate::edit::Command;
use crate::sim::SimCommand;

/// Takes a pin away; a region's pin is one of the document's, which can be undone.
pub(super) fn remove_pin(pin: &ChosenPin, cx: &mut Context) {
    match pin {
        ChosenPin::Region { body, pin } => {
            let found = cx.scene().all_bodies().find(|known| known.id() == body);
            let Some((regions, pins)) = found.map(|body| (body.regions().to_vec(), body.pins().to_vec())) else {
                return;
            };
            let pins = pins.into_iter().filter(|known| known.id != *pin).collect();
            cx.edit(&Command::SetPins { body: body.clone(), regions, pins }, Step::Own);
        }
        &ChosenPin::Point { body, grab } => cx.ask(SimCommand::Unpin { body, grab }),
    }
    cx.selection.forget_pin();
}
