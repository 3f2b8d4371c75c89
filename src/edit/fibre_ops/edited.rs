//! A fibre after an edit, and what is asked of its vertices.

use super::error::FibreEditError;
use crate::scene::{Fibre, FibreSource};
use glam::DVec3;

/// Fewest vertices of a fibre: bending needs an angle.
pub const LEAST_VERTICES: usize = 3;

/// Most vertices of a fibre; more than structure particles would ever be drawn with.
pub const MOST_VERTICES: usize = 4096;

/// How strokes become vertices in the body that the fibre lies in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sampling {
    /// Diagonal H of the model's bounding box [m].
    pub model_diagonal: f64,
    /// Spacing D of the body's particles [m]; of a mesh that is filled with a number of particles the spacing that
    /// came out.
    pub spacing: f64,
}

/// A fibre after an edit.
#[derive(Clone, Debug, PartialEq)]
pub struct Edited {
    /// The fibre as it is to be.
    pub fibre: Fibre,
    /// What was lost or done without being asked, for people.
    pub note: Option<String>,
}

impl Edited {
    /// A fibre that lost nothing.
    pub(super) fn whole(fibre: Fibre) -> Self {
        Self { fibre, note: None }
    }
}

/// The fibre with other vertices; strokes that it had are said to be lost.
pub(super) fn with_vertices(fibre: &Fibre, vertices: &[DVec3]) -> Result<Edited, FibreEditError> {
    if vertices.len() < LEAST_VERTICES {
        return Err(FibreEditError::TooFew(vertices.len()));
    }
    if vertices.len() > MOST_VERTICES {
        return Err(FibreEditError::TooMany { wanted: vertices.len() as f64, limit: MOST_VERTICES });
    }
    if let Some(index) = vertices.iter().position(|vertex| !vertex.is_finite()) {
        return Err(FibreEditError::NotFinite { index });
    }
    if let Some(index) = vertices.windows(2).position(|pair| pair[0] == pair[1]) {
        return Err(FibreEditError::Repeats { index: index + 1 });
    }
    let note = matches!(fibre.source, FibreSource::Strokes(_)).then(|| {
        format!("{} is no longer drawn by its two strokes: it has {} vertices now", fibre.title(), vertices.len())
    });
    let source = FibreSource::Vertices(vertices.iter().map(DVec3::to_array).collect());
    Ok(Edited { fibre: Fibre { source, ..fibre.clone() }, note })
}

/// Which of `count` vertices are chosen.
pub(super) fn chosen(indices: &[usize], count: usize) -> Result<Vec<bool>, FibreEditError> {
    let mut chosen = vec![false; count];
    for &index in indices {
        *chosen.get_mut(index).ok_or(FibreEditError::NoVertex { index, count })? = true;
    }
    Ok(chosen)
}
