//! Edits of a fibre that leave it a pair of strokes.

use super::edited::{Edited, Sampling, with_vertices};
use super::error::FibreEditError;
use crate::scene::{Fibre, FibreSource};
use crate::sketch::View;

/// Runs a fibre the other way, and with it a wave along it; it curls to the same side as before. A pair of strokes
/// stays one.
///
/// # Errors
/// None for a fibre of a valid document.
pub fn reverse(fibre: &Fibre) -> Result<Edited, FibreEditError> {
    let mut fibre = fibre.clone();
    if let Some(curl) = fibre.activation.as_mut().and_then(|activation| activation.curl.as_mut()) {
        curl.axis = curl.axis.map(|along| 0.0 - along);
    }
    match &fibre.source {
        FibreSource::Vertices(vertices) => {
            let reversed: Vec<_> = vertices.iter().rev().copied().map(glam::DVec3::from_array).collect();
            with_vertices(&fibre, &reversed)
        }
        FibreSource::Strokes(pair) => {
            let mut pair = pair.clone();
            pair.first.points.reverse();
            pair.second.points.reverse();
            Ok(Edited::whole(Fibre { source: FibreSource::Strokes(pair), ..fibre }))
        }
    }
}

/// Puts a new stroke in the place of the one that was drawn in the same view; the other stroke stays. A flip of the
/// second stroke is taken back: it mended a pair that is no more.
///
/// # Errors
/// A fibre without strokes, a view in which it was not drawn, or strokes that give no curve together.
pub fn redraw(fibre: &Fibre, view: View, points: Vec<[f64; 2]>, sampling: Sampling) -> Result<Edited, FibreEditError> {
    let FibreSource::Strokes(pair) = &fibre.source else { return Err(FibreEditError::NoStrokes) };
    let mut pair = pair.clone();
    let old = if pair.first.view == view {
        &mut pair.first
    } else if pair.second.view == view {
        &mut pair.second
    } else {
        return Err(FibreEditError::OtherView { drawn: view, views: [pair.first.view, pair.second.view] });
    };
    old.points = points;
    let mut notes = Vec::new();
    if std::mem::take(&mut pair.flip_second) {
        notes.push("The second stroke is no longer flipped".to_owned());
    }
    let lifted = pair.lifted(sampling.model_diagonal)?;
    notes.extend(lifted.notes.iter().map(ToString::to_string));
    let note = (!notes.is_empty()).then(|| notes.join(". "));
    Ok(Edited { fibre: Fibre { source: FibreSource::Strokes(pair), ..fibre.clone() }, note })
}
