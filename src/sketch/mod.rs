//! Strokes to curves: a pair of strokes in two orthogonal views becomes one curve in space.
//!
//! How it works. Two of the three orthographic views share one axis. Each stroke is cleaned and resampled by arc
//! length; an order-preserving dynamic programming pairs the two sequences by their shared coordinate; each pair gives
//! one point: the shared coordinate is the mean of both, the other two come from one stroke each.
//!
//! Why not otherwise. Pairing by arc length alone drifts, because a curve is foreshortened differently in each view.
//! Sorting by the shared coordinate breaks any stroke that turns back.
//!
//! The steps: [`guides()`] after the first stroke, [`partial_lift()`] while the second is drawn, [`lift()`] for the
//! pair, [`structure_particles`] to sample the curve, [`trim()`] to keep what lies in the solid. All of them are pure.
//! Beside strokes there are [`pattern`]s to start from. A pair can also be taken another way: [`sweep()`] carries the
//! first along the second, which gives a surface.

mod clean;
mod correspond;
mod fibre;
pub(crate) mod guides;
pub(crate) mod lift;
mod message;
pub(crate) mod partial_lift;
pub mod pattern;
mod range;
mod stroke;
mod sweep;
mod trim;
mod view;

pub use fibre::structure_particles;
#[cfg(feature = "gui")]
pub(crate) use guides::{Guides, guides};
pub use lift::{LiftOptions, Lifted, lift};
pub use message::{SketchError, SketchNote, Which};
#[cfg(feature = "gui")]
pub(crate) use partial_lift::{PartialLift, partial_lift};
pub use stroke::Stroke;
pub use sweep::{Sweep, sweep};
pub use trim::{Placed, Trimmed, trim};
pub use view::View;
