//! sinew: an interactive stroke-based fibre editor for soft solids.

pub mod bake;
pub mod geometry;
pub mod io;
pub mod scene;
pub mod sim;
pub mod sketch;
pub mod solver;
