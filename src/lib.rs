//! sinew: an interactive stroke-based fibre editor for soft solids.

pub mod io;
pub mod scene;
pub mod sketch;
