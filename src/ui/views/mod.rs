//! The three views: how they lie beside each other, what links them, and what each shows and takes.

mod affine;
mod camera;
mod context_menu;
mod corner;
mod displayed;
mod drawing_tool;
mod ease;
mod frame;
mod grab;
mod kind;
mod layout;
mod legend;
mod links;
mod options;
mod out_of_sight;
mod outline;
mod overlay;
mod pane;
mod picture;
mod pins;
mod region;
mod sketch_tool;
mod sketching;
mod strokes;
mod view;

pub(crate) use displayed::DisplayedState;
pub(crate) use drawing_tool::DrawingTool;
pub(crate) use frame::ViewFrame;
pub(crate) use grab::{body_at, seen_on};
pub(crate) use kind::PaneKind;
pub(crate) use layout::Views;
pub(crate) use options::ViewOptions;
pub(crate) use pane::Pane;
pub(crate) use picture::Painter;
