//! Shapes and distances: curves, kernel, neighbour search, surface meshes, and from a model to the particles inside it
//! (weld, check, orient, fill). Knows nothing of scenes or physics.

pub(crate) mod bvh;
pub(crate) mod closest;
pub(crate) mod cluster;
pub(crate) mod crossing;
pub(crate) mod curve;
pub(crate) mod edges;
pub(crate) mod file_mesh;
pub(crate) mod fill;
pub(crate) mod fineness;
pub(crate) mod holes;
pub(crate) mod inside;
pub(crate) mod isosurface;
pub(crate) mod kernel;
pub(crate) mod lathe;
pub(crate) mod lattice;
pub(crate) mod linear_map;
pub(crate) mod mesh;
pub(crate) mod model;
pub(crate) mod model_report;
pub(crate) mod nearest;
pub(crate) mod neighbours;
pub(crate) mod octahedron;
pub(crate) mod offset;
pub(crate) mod orient;
pub(crate) mod placement;
pub(crate) mod point_tree;
#[cfg(feature = "gui")]
pub(crate) mod ray;
pub(crate) mod rig;
pub(crate) mod row_index;
pub(crate) mod scanline;
pub(crate) mod sheets;
pub(crate) mod solid;
pub(crate) mod subdivide;
pub(crate) mod thickness;
pub(crate) mod thinness;
pub(crate) mod two_layers;
pub(crate) mod weld;
pub(crate) mod winding;

pub use file_mesh::{FileMesh, FilePart, UvSet};
pub use fill::{FillError, FillResolution, fill};
pub use kernel::Kernel;
pub use lattice::Cuboid;
pub use mesh::{TriangleMesh, box_surface};
pub use model::{MeshData, Model, Part, UpAxis};
pub use model_report::{Finding, LeftOut, ModelReport, Refusal};
pub use placement::Filling;
pub use solid::Solid;
pub use thinness::Thinness;
pub use weld::Welded;
