//! sinew: an interactive stroke-based fibre editor for soft solids.
// Units stand in brackets throughout the docs: [m], [N/m].
#![allow(rustdoc::broken_intra_doc_links, reason = "units in brackets are no links")]

pub mod bake;
pub mod cli;
pub mod geometry;
pub mod io;
pub mod scene;
pub mod sim;
pub mod sketch;
pub mod solver;
