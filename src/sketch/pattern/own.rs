//! A person's own layouts, kept as patterns: drawn in one box, fitted to others.

use super::acting::{Act, CONTRACTION};
use super::layout::Polyline;
use glam::DVec3;
use serde::{Deserialize, Serialize};
use thiserror::Error;

/// A layout that a person saved: in JSON an object with `title`, `does` and `fibres`, each a list of [x, y, z] in the
/// unit cube, and `acts`, what each of them does by itself, where any does something.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "Unchecked")]
pub struct OwnPattern {
    title: String,
    #[serde(skip_serializing_if = "String::is_empty")]
    does: String,
    fibres: Vec<Vec<[f64; 3]>>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    acts: Vec<Option<Act>>,
}

/// The same as it was read, before it is looked at.
#[derive(Deserialize)]
struct Unchecked {
    title: String,
    #[serde(default)]
    does: String,
    fibres: Vec<Vec<[f64; 3]>>,
    #[serde(default)]
    acts: Vec<Option<Act>>,
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
    /// A fibre that acts as none can.
    #[error("what fibre {fibre} of the pattern does needs a period over 0 s, and numbers")]
    Act {
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
        Self { title: read.title, does: read.does, fibres: read.fibres, acts: read.acts }.checked()
    }
}

impl OwnPattern {
    /// The layout of `fibres` [m] in the box from `min` to `max` [m], model frame. What sticks out of the box is
    /// brought to its faces.
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
        Self { title: title.to_owned(), does: does.to_owned(), fibres, acts: Vec::new() }.checked()
    }

    /// With what each fibre does by itself; `None` for one that only resists.
    ///
    /// # Errors
    /// A period that is not above zero, a number that is none.
    pub fn with_acts(self, acts: Vec<Option<Act>>) -> Result<Self, PatternError> {
        let acts = if acts.iter().all(Option::is_none) { Vec::new() } else { acts };
        Self { acts, ..self }.checked()
    }

    /// What each fibre does by itself; empty where all only resist.
    pub fn acts(&self) -> &[Option<Act>] {
        &self.acts
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

    /// The same with every vertex in the unit cube and no fibre shorter than fibres can be.
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
        for (fibre, act) in self.acts.iter_mut().enumerate() {
            let Some(act) = act else { continue };
            let numbers = [act.contract, act.period, act.phase_degrees, act.waves];
            if !(act.period > 0.0 && numbers.iter().all(|number| number.is_finite())) {
                return Err(PatternError::Act { fibre });
            }
            act.contract = act.contract.clamp(CONTRACTION[0], CONTRACTION[1]);
        }
        Ok(self)
    }
}
