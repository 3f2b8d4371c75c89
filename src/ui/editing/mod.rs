//! Editing fibres and bodies that are there: choosing them and their vertices, moving, turning and scaling them,
//! painting, and what menus do to them.

mod actions;
mod allowed;
mod body;
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

pub(crate) use actions::{
    delete, detach, duplicate, duplicate_sheet, hide, insert_vertices, mirror, mirror_copies, resample, reverse,
    select_all, show_all, smooth, snap, split,
};
pub(crate) use allowed::Allowed;
pub(crate) use body::move_copy;
pub(crate) use brush::{can_paint, toggle_brush};
pub(crate) use brush_panel::brush_panel;
pub(crate) use keys::take_keys;
pub(crate) use motion::{begin_moving, moves_copies};
pub(crate) use moving::Kind;
pub(crate) use pointer::{choose_at, paint, take_pointer};
pub(crate) use set::set_fibres;
pub(crate) use state::Editing;
