//! From the document and a state of its world to what is to be seen: a [`DrawList`] of plain data that knows no
//! graphics interface, so that it can be tested without one and drawn by any.
//!
//! Positions in a list are f32 about the list's own origin: a model a kilometre away is drawn as finely as one at
//! home. Colours keep their meaning throughout (see [`Theme`]): material cool, structure warm, each fibre a hue.

mod body_drawer;
mod bounds;
mod build;
mod colour;
pub(crate) mod colour_map;
mod cut_face;
mod element;
mod fibre;
mod list;
mod options;
mod particles;
mod sheet;
mod slice;
mod surroundings;
mod theme;
mod tube;

pub use bounds::Bounds;
pub use build::{Subject, draw};
pub use colour::Colour;
pub use list::{
    DrawList, Faces, Ground, Label, Line, Mesh, PickId, PickKind, Picks, Points, Size, SkinnedFaces, SurfaceStyle,
    Vertex,
};
pub use options::{Display, SkinStyle};
pub use slice::Slice;
pub use theme::Theme;
