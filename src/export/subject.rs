//! What does not change over a motion: which bodies there are, what they are made of, how long a frame is.

use super::space::Space;
use crate::geometry::file_mesh::FileMesh;

/// What moves.
#[derive(Clone, Debug, Default)]
pub(crate) struct Subject {
    /// Name of the scene.
    pub(crate) name: String,
    /// Simulated time of a frame [s].
    pub(crate) frame_seconds: f64,
    /// Unit and axes in which everything stands.
    pub(crate) space: Space,
    /// Bodies in the order of the scene, and its panels behind them: surfaces alone.
    pub(crate) bodies: Vec<BodySubject>,
}

/// A body, or a panel.
#[derive(Clone, Debug, Default)]
pub(crate) struct BodySubject {
    /// Name a person reads.
    pub(crate) name: String,
    /// Its surface where it was put, undeformed: the mesh of its file, or else its skin; of a body without one its
    /// particles alone.
    pub(crate) mesh: FileMesh,
    /// Fibres in the order of the scene.
    pub(crate) fibres: Vec<FibreSubject>,
    /// Particles at both ends of every spring; empty but for a two-layer body.
    pub(crate) springs: Vec<[u32; 2]>,
}

/// A fibre.
#[derive(Clone, Debug, Default)]
pub(crate) struct FibreSubject {
    /// Identifier of the scene's fibre.
    pub(crate) id: String,
    /// Number of vertices.
    pub(crate) vertices: usize,
    /// Width of a round rod that holds as much fibre as there is at its centre line.
    pub(crate) width: f64,
}
