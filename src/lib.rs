//! sinew: an interactive stroke-based fibre editor for soft solids.

pub mod geometry;
pub mod scene;
pub mod sketch;
