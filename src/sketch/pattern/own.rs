//! A person's own layouts, kept as patterns: drawn in one box, fitted to others.

use super::layout::Polyline;
use glam::DVec3;
use serde::{Deserialize, Serialize};
use thiserror::Error;

/// A layout that a person saved: in JSON an object with `title`, `does` and `fibres`, each a list of [x, y, z] in the unit
/// cube.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "Unchecked")]
pub struct OwnPattern {
    title: String,
    #[serde(skip_serializing_if = "String::is_empty")]
    does: String,
    fibres: Vec<Vec<[f64; 3]>>,
}

/// The same as it was read, before it is looked at.
#[derive(Deserialize)]
struct Unchecked {
    title: String,
    #[serde(default)]
    does: String,
    fibres: Vec<Vec<[f64; 3]>>,
}

/// Why a layout is no pattern.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum PatternError {
    /// Nothing to lay out.
    #[error("the pattern has no fibres; draw at least one")]
    Empty,
    /// A fibre that is no line.
    #[error("fibre {fibre} of the pattern has {vertices} vertices; it needs 2 or more")]
    Short {
        /// Index of the fibre.
        fibre: usize,
        /// What it has.
        vertices: usize,
    },
    /// A vertex that is nowhere.
    #[error("a vertex of fibre {fibre} of the pattern is no number")]
    NotFinite {
        /// Index of the fibre.
        fibre: usize,
    },
    /// Nothing to measure the fibres by.
    #[error("the box of the pattern has no volume; it needs an extent along each axis")]
    Flat,
}

impl TryFrom<Unchecked> for OwnPattern {
    type Error = PatternError;

    fn try_from(read: Unchecked) -> Result<Self, PatternError> {
        Self { title: read.title, does: read.does, fibres: read.fibres }.checked()
    }
}

impl OwnPattern {
    /// The layout of `fibres` [m] in the box from `min` to `max` [m], model frame. What sticks out of the box is brought to
    /// its faces.
    ///
    /// # Errors
    /// No fibres, one of fewer than two vertices or with one that is no number, a box without volume.
    pub fn new(title: &str, does: &str, fibres: &[Polyline], min: DVec3, max: DVec3) -> Result<Self, PatternError> {
        let extents = max - min;
        if !(extents.is_finite() && extents.min_element() > 0.0) {
            return Err(PatternError::Flat);
        }
        let share = |at: &DVec3| ((*at - min) / extents).to_array();
        let fibres = fibres.iter().map(|fibre| fibre.iter().map(share).collect()).collect();
        Self { title: title.to_owned(), does: does.to_owned(), fibres }.checked()
    }

    /// Name a person reads.
    pub fn title(&self) -> &str {
        &self.title
    }

    /// What the fibres do to a solid, in a line; empty where nothing was written.
    pub fn does(&self) -> &str {
        &self.does
    }

    /// The fibres' vertices [m], fitted to the box from `min` to `max` [m], model frame.
    pub fn lay(&self, min: DVec3, max: DVec3) -> Vec<Polyline> {
        let at = |share: &[f64; 3]| min + DVec3::from_array(*share) * (max - min);
        self.fibres.iter().map(|fibre| fibre.iter().map(at).collect()).collect()
    }

    /// The same with every vertex in the unit cube.
    fn checked(mut self) -> Result<Self, PatternError> {
        if self.fibres.is_empty() {
            return Err(PatternError::Empty);
        }
        for (fibre, vertices) in self.fibres.iter_mut().enumerate() {
            if vertices.len() < 2 {
                return Err(PatternError::Short { fibre, vertices: vertices.len() });
            }
            for share in vertices.iter_mut().flatten() {
                if !share.is_finite() {
                    return Err(PatternError::NotFinite { fibre });
                }
                *share = share.clamp(0.0, 1.0);
            }
        }
        Ok(self)
    }
}
