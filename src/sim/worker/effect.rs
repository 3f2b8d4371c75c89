//! Which commands make which others pointless.

use crate::sim::command::SimCommand;

/// What a command does to an older one that still waits. Of documents and ghosts that follow each other only the newest
/// is put together, whatever the others would have been.
pub(super) enum Effect {
    /// It takes its place: with or without the older one all comes to the same.
    Supersedes,
    /// It leaves it where it is, and may supersede even older ones.
    Passes,
    /// Nothing before the older one is superseded.
    Stops,
}

/// What the newer of two commands does to the older one.
pub(super) fn effect(newer: &SimCommand, older: &SimCommand) -> Effect {
    use SimCommand::{Activation, Edit, Field, Ghost, Lead, MoveGrab, Open, Pause, Play, Show, Speed, Tension};
    match (newer, older) {
        // A ghost that is ended and wanted again starts anew from where the world is.
        (Ghost(Some(_)), Ghost(None)) => Effect::Stops,
        // Another document leaves nothing of the last one, whatever was done to it.
        (Open(..), Open(..) | Edit(_) | Ghost(_))
        | (Edit(_), Edit(_))
        | (Ghost(_), Ghost(_))
        | (Speed(_), Speed(_))
        | (Field(_), Field(_))
        | (Tension(_), Tension(_))
        | (Activation(_), Activation(_))
        | (Show(_), Show(_))
        | (MoveGrab(_), MoveGrab(_)) => Effect::Supersedes,
        (Lead { body, drive, .. }, Lead { body: old_body, drive: old, .. }) => {
            if (body, drive) == (old_body, old) {
                Effect::Supersedes
            } else {
                Effect::Passes
            }
        }
        // Settings and all the rest do not heed each other. Whether time runs is all the same to an edit and a ghost:
        // no frame is computed between two commands.
        (Speed(_) | Field(_) | Tension(_) | Activation(_), _)
        | (_, Speed(_) | Field(_) | Tension(_) | Activation(_))
        | (Edit(_) | Ghost(_), Edit(_) | Ghost(_) | Play | Pause) => Effect::Passes,
        _ => Effect::Stops,
    }
}
