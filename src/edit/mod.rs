//! The only writer of an open document: named changes, each one step of undo and redo.
//!
//! A change is a [`Command`]; what it leaves behind is a whole scene, shared where it is the same. A scene that does not
//! validate never becomes the document.

mod command;
mod history;

pub use command::Command;
pub use history::{EditError, Editor};
