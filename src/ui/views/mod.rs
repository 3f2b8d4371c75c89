//! The three views: how they lie beside each other, what links them, and what each shows and takes.

mod affine;
mod camera;
mod corner;
mod displayed;
mod ease;
mod frame;
mod grab;
mod kind;
mod layout;
mod legend;
mod links;
mod options;
mod overlay;
mod pane;
mod picture;
mod region;
mod sketch_tool;
mod sketching;
mod strokes;
mod view;

pub use displayed::DisplayedState;
pub use frame::ViewFrame;
pub use grab::seen_on;
pub use kind::PaneKind;
pub use layout::Views;
pub use options::ViewOptions;
pub use pane::Pane;
pub use picture::Painter;
