//! Shares of fibre and sheet at the particles of a body, and of the matrix that is left.

use super::falloff::curve;
use super::fibres::PlacedFibre;
use super::sheets::PlacedSheet;
use crate::geometry::kernel::Kernel;
use crate::scene::{Body, painted};
use crate::solver::volume_fraction::{add_sheet, volume_fractions};
use glam::DVec3;
use std::sync::Arc;

/// Volume fraction `l_i` at every particle: that of the fibres and sheets by distance, the largest of all, and what is painted
/// over it.
pub(super) fn fractions(
    body: &Body,
    particles: &[DVec3],
    kernel: Kernel,
    (fibres, sheets): (&[PlacedFibre], &[PlacedSheet]),
) -> Vec<f64> {
    let curve = curve(&body.material, kernel);
    let runs: Vec<(f64, &[DVec3])> = fibres.iter().map(|run| run.share(body)).collect();
    let mut smoothed = volume_fractions(particles, &runs, &curve);
    for sheet in sheets {
        add_sheet(particles, sheet.share(body), (kernel.support_radius, &curve), &mut smoothed);
    }
    smoothed.into_iter().zip(particles).map(|(fraction, &at)| painted(fraction, at, &body.paint)).collect()
}

/// Share of matrix, `1 - l_i`.
pub(super) fn matrix_fractions(fractions: &[f64]) -> Arc<[f64]> {
    fractions.iter().map(|fraction| 1.0 - fraction).collect()
}
