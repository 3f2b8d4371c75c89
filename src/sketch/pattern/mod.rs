//! Patterns: layouts of fibres to start from, fitted to a box; each makes one deformation plain.
//!
//! How it works. A layout is drawn in the unit cube and stretched into the box, less a margin, so that no number a
//! person types can lead out of it. What has to know the box (angles, lengths, which way is flat) is told its extents.
//! Where the solid leaves much of its box empty, the layout goes further in, until its fibres lie in the material.
//!
//! Why not bent to the surface. Fibres that leave a model's surface all the same are trimmed when they are put into it,
//! as those that were drawn by hand; a pattern is a start and is edited as any fibre.

mod acting;
mod curves;
mod fit;
mod layout;
mod lines;
mod own;
mod parametric;
mod planes;
mod shipped;

pub use acting::{Act, CONTRACTION};
pub use fit::Laid;
pub use layout::Polyline;
pub use own::{OwnPattern, PatternError};
pub use parametric::{Parameter, Pattern};
pub use shipped::PATTERNS;
