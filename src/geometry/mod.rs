//! Shapes and distances: kernel, lattice sampling, neighbour search, surface meshes. Knows nothing of scenes or physics.

pub mod kernel;
pub mod lattice;
pub mod mesh;
pub mod neighbours;
