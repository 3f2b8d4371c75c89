//! Bodies as things: added where they stand free, brought in from models, copied, placed and taken away.

mod actions;
mod free_place;
mod import;
mod incoming;
mod layers;
mod made;
mod shape_fields;

pub(crate) use actions::{add, begin_anew, delete, hide};
pub(crate) use free_place::beside;
pub(crate) use import::{add_model, incoming, paste_body, scaled_model};
pub(crate) use incoming::{Brought, Incoming};
pub(crate) use layers::Layers;
pub(crate) use made::NewBody;
pub(crate) use shape_fields::place_and_shape;
