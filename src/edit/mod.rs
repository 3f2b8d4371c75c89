//! The only writer of an open document: named changes, each one step of undo and redo.
//!
//! A change is a [`Command`]; what it leaves behind is a whole scene, shared where it is the same. A scene that does
//! not validate never becomes the document. What a command is to put there comes from pure functions: of fibres,
//! those of [`fibre_ops`], of sheets those of [`sheet_ops`], and of bodies those of [`body_ops`].

mod apply;
pub mod body_ops;
mod command;
pub mod fibre_ops;
mod history;
pub mod sheet_ops;

pub use command::{Command, Item};
pub use history::{EditError, Editor};
