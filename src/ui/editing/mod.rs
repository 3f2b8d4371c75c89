//! Editing fibres that are there: choosing them and their vertices, moving and turning them, painting, and what menus do to
//! them.

mod actions;
mod brush;
mod brush_panel;
mod courses;
mod gizmo;
mod handle;
mod keys;
mod motion;
mod moving;
mod pointer;
mod set;
mod state;

pub use actions::{
    delete, detach, duplicate, hide, insert_vertices, mirror, resample, reverse, select_all, show_all, smooth, snap,
    split,
};
pub use brush::toggle_brush;
pub use brush_panel::brush_panel;
pub use keys::take_keys;
pub use motion::begin_moving;
pub use moving::Kind;
pub use pointer::{paint, take_pointer};
pub use set::set_fibres;
pub use state::Editing;
