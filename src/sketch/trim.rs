//! Keeps what lies in the solid: trims ends, splits at gaps, drops crumbs.

use super::message::{SketchError, SketchNote};
use crate::geometry::curve::Point;
use glam::DVec3;

/// Fewest structure particles of a run that is kept: bending needs an angle.
pub(super) const SHORTEST_RUN: usize = 3;

/// A structure particle and what the solid makes of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placed {
    /// Its position [m].
    pub point: DVec3,
    /// Whether enough material lies within its support.
    pub embedded: bool,
    /// Distance to the nearest material, in support radii h.
    pub distance: f64,
}

/// What is left of a fibre.
#[derive(Clone, Debug, PartialEq)]
pub struct Trimmed {
    /// Runs of embedded structure particles [m], each at least `SHORTEST_RUN` long: one fibre each.
    pub runs: Vec<Vec<DVec3>>,
    /// Way along the fibre from its first structure particle to the first of each run [m].
    pub starts: Vec<f64>,
    /// What was left out.
    pub notes: Vec<SketchNote>,
}

/// Keeps the embedded structure particles of a fibre.
///
/// Unembedded ends are trimmed. Unembedded particles on the way are left out; where the neighbours that remain are more
/// than the support radius `h` [m] apart along the fibre, it is split. Runs under `SHORTEST_RUN` particles are dropped.
/// Embedded neighbours never part, however long the spacing.
///
/// # Errors
/// No run is left.
pub fn trim(particles: &[Placed], h: f64) -> Result<Trimmed, SketchError> {
    let total = particles.len();
    let embedded = particles.iter().filter(|particle| particle.embedded).count();
    if embedded == 0 {
        let nearest = particles.iter().map(|particle| particle.distance).fold(f64::INFINITY, f64::min);
        return Err(SketchError::Discarded { nearest });
    }
    let runs = split(particles, h);
    let (kept, dropped): (Vec<_>, Vec<_>) = runs.into_iter().partition(|(_, run)| run.len() >= SHORTEST_RUN);
    if kept.is_empty() {
        return Err(SketchError::Stranded { embedded, total });
    }
    let mut notes = Vec::new();
    if embedded < total {
        notes.push(SketchNote::Trimmed { trimmed: total - embedded, total });
    }
    if kept.len() > 1 {
        notes.push(SketchNote::Split { pieces: kept.len() });
    }
    if !dropped.is_empty() {
        let points = dropped.iter().map(|(_, run)| run.len()).sum();
        notes.push(SketchNote::Dropped { pieces: dropped.len(), points });
    }
    let (starts, runs) = kept.into_iter().unzip();
    Ok(Trimmed { runs, starts, notes })
}

/// Embedded particles in runs, parted where unembedded ones make a gap longer than `h` along the fibre, with where on
/// it they start.
fn split(particles: &[Placed], h: f64) -> Vec<(f64, Vec<DVec3>)> {
    let mut runs: Vec<(f64, Vec<DVec3>)> = Vec::new();
    // Length walked since the last embedded particle, and whether anything unembedded lay on the way.
    let (mut gap, mut interrupted) = (0.0, true);
    let mut way = 0.0;
    let mut before: Option<DVec3> = None;
    for particle in particles {
        let step = before.map_or(0.0, |before| Point::distance(before, particle.point));
        gap += step;
        way += step;
        before = Some(particle.point);
        if !particle.embedded {
            interrupted = true;
            continue;
        }
        match runs.last_mut() {
            Some((_, run)) if !interrupted || gap <= h => run.push(particle.point),
            _ => runs.push((way, vec![particle.point])),
        }
        (gap, interrupted) = (0.0, false);
    }
    runs
}
