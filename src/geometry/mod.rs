//! Shapes and distances: curves, kernel, lattice sampling, neighbour search, surface meshes. Knows nothing of scenes or
//! physics.

pub mod closest;
pub mod curve;
pub mod kernel;
pub mod lattice;
pub mod mesh;
pub mod neighbours;
pub mod octahedron;
