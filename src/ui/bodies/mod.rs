//! Bodies as things: added where they stand free, brought in from models, copied, placed and taken away.

mod actions;
mod free_place;
mod import;
mod layers;
mod made;
mod shape_fields;

pub(crate) use actions::{add, add_body, begin_anew, delete, hide};
pub(crate) use free_place::beside;
pub(crate) use import::{add_model, bring_models, scaled_model};
pub(crate) use layers::Layers;
pub(crate) use made::NewBody;
pub(crate) use shape_fields::place_and_shape;
