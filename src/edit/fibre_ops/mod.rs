//! What can be done to a fibre: pure functions from a fibre to the fibre as it is to be, for a
//! [`Command`](super::Command) to put into the document.
//!
//! How it works. A fibre is a pair of strokes, or vertices. Moves, turns by right angles and mirrorings along the
//! axes take strokes to strokes, and so does running the other way: the fibre stays as it was drawn and can be
//! redrawn. No pair of strokes gives what anything else leaves behind, so that the fibre becomes the vertices with
//! which it was simulated, and [`Edited::note`] says so.
//!
//! Why not otherwise. Strokes projected from an edited curve would look as if somebody had drawn them, but lift to
//! another curve than the one that was edited.

mod cut;
mod error;
mod layout;
mod reshape;
mod snap;
mod strokes;
mod transform;
mod vertices;

pub use cut::{copies, split};
pub use error::FibreEditError;
pub use layout::{BENDING, Called, NEW_VOLUME_FRACTION, STIFFER, displaced, laid, rigidity_of};
pub use reshape::{ResampleTo, resample, smooth};
pub use snap::{snap, surface};
pub use strokes::{redraw, reverse};
pub use transform::{Transform, transform, transform_vertices};
pub use vertices::{delete_vertices, detach, insert_vertex, vertices};

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
    fn whole(fibre: Fibre) -> Self {
        Self { fibre, note: None }
    }
}

/// The fibre with other vertices; strokes that it had are said to be lost.
fn with_vertices(fibre: &Fibre, vertices: &[DVec3]) -> Result<Edited, FibreEditError> {
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
fn chosen(indices: &[usize], count: usize) -> Result<Vec<bool>, FibreEditError> {
    let mut chosen = vec![false; count];
    for &index in indices {
        *chosen.get_mut(index).ok_or(FibreEditError::NoVertex { index, count })? = true;
    }
    Ok(chosen)
}
