//! What can be done to a fibre: pure functions from a fibre to the fibre as it is to be, for a
//! [`Command`](super::Command) to put into the document.
//!
//! How it works. A fibre is a pair of strokes, or vertices. Moves, turns by right angles and mirrorings along the
//! axes take strokes to strokes, and so does running the other way: the fibre stays as it was drawn and can be
//! redrawn. No pair of strokes gives what anything else leaves behind, so that the fibre becomes the vertices with
//! which it was simulated, and [`Edited::note`] says so.
//!
//! Why not otherwise. Strokes projected from an edited curve would look as if somebody had drawn them, but lift to
//! another curve than the one that was edited.

mod acting;
mod axis_map;
mod cut;
mod edited;
mod error;
mod layout;
mod reshape;
mod snap;
mod strokes;
mod transform;
mod vertices;

pub use acting::{act_of, made_to_act};
pub use cut::{copies, split};
pub use edited::{Edited, LEAST_VERTICES, MOST_VERTICES, Sampling};
pub use error::FibreEditError;
pub use layout::{BENDING, Called, NEW_VOLUME_FRACTION, STIFFER, laid};
pub use layout::{displaced, rigidity_of};
pub use reshape::{ResampleTo, resample, smooth};
pub use snap::{snap, surface};
pub use strokes::{redraw, reverse};
pub use transform::{Transform, transform, transform_vertices};
pub use vertices::{delete_vertices, detach, insert_vertex, vertices};
