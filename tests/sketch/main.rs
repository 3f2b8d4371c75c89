//! Strokes to fibres, through the public API.

mod accuracy;
mod drawing;
mod hostile;
mod patterns;
mod preview;
mod rules;
mod trimming;
