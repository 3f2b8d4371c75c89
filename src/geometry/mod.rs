//! Shapes and distances: curves, kernel, neighbour search, surface meshes, and from a model to the particles inside it
//! (weld, check, orient, fill). Knows nothing of scenes or physics.

pub mod bvh;
pub mod closest;
pub mod crossing;
pub mod curve;
pub mod edges;
pub mod fill;
pub mod isosurface;
pub mod kernel;
pub mod lattice;
pub mod linear_map;
pub mod mesh;
pub mod model;
pub mod model_report;
pub mod nearest;
pub mod neighbours;
pub mod octahedron;
pub mod offset;
pub mod orient;
pub mod rig;
pub mod scanline;
pub mod solid;
pub mod subdivide;
pub mod thinness;
pub mod weld;
pub mod winding;
