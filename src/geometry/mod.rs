//! Geometry that knows nothing of bodies, fibres or files.

pub mod curve;
