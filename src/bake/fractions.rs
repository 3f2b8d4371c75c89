//! Shares of fibre and sheet at the particles of a body, and of the matrix that is left.

use super::drives::drive;
use super::falloff::curve;
use super::fibres::PlacedFibre;
use super::sheets::PlacedSheet;
use crate::geometry::kernel::Kernel;
use crate::scene::{Body, painted};
use crate::solver::drive_along::DriveAlong;
use crate::solver::driven_fractions::{DrivenFractions, DrivenRun};
use crate::solver::volume_fraction::{add_sheet, volume_fractions};
use glam::DVec3;
use std::sync::Arc;

/// Volume fraction `l_i` at every particle where all drives are 0: that of the fibres and sheets by distance, the
/// largest of all, and what is painted over it.
pub(super) fn fractions(
    body: &Body,
    particles: &[DVec3],
    kernel: Kernel,
    (fibres, sheets): (&[PlacedFibre], &[PlacedSheet]),
) -> Vec<f64> {
    let smoothed = smoothed(body, particles, kernel, (fibres.iter(), sheets));
    smoothed.into_iter().zip(particles).map(|(fraction, &at)| painted(fraction, at, &body.paint)).collect()
}

/// The same of these fibres and sheets alone, with nothing painted over it.
fn smoothed<'a>(
    body: &Body,
    particles: &[DVec3],
    kernel: Kernel,
    (fibres, sheets): (impl Iterator<Item = &'a PlacedFibre>, &[PlacedSheet]),
) -> Vec<f64> {
    let curve = curve(&body.material, kernel);
    let runs: Vec<(f64, &[DVec3])> = fibres.map(|run| run.share(body)).collect();
    let mut smoothed = volume_fractions(particles, &runs, &curve);
    for sheet in sheets {
        add_sheet(particles, sheet.share(body), (kernel.support_radius, &curve), &mut smoothed);
    }
    smoothed
}

/// What the fractions are made of around fibres whose own is driven; none where no fibre's is.
pub(super) fn driven(
    body: &Body,
    particles: &[DVec3],
    kernel: Kernel,
    (fibres, sheets): (&[PlacedFibre], &[PlacedSheet]),
) -> Option<DrivenFractions> {
    let is_driven = |run: &&PlacedFibre| run.thickening(body).is_some();
    let curve = curve(&body.material, kernel);
    // Of every run: its particles, how much of the fraction is left there, and how far along the fibre they are
    // nearest.
    let reached: Vec<Vec<(u32, f64, f64)>> = fibres
        .iter()
        .filter(is_driven)
        .map(|run| {
            let near = (0..).zip(particles).map(|(i, &at)| {
                let (distance, along) = run.nearest(at);
                (i, curve(distance), along)
            });
            near.filter(|(_, left, _)| *left > 0.0).collect()
        })
        .collect();
    let mut around: Vec<u32> = reached.iter().flatten().map(|(i, ..)| *i).collect();
    around.sort_unstable();
    around.dedup();
    if around.is_empty() {
        return None;
    }
    let at: Vec<DVec3> = around.iter().map(|&i| particles[i as usize]).collect();
    let place = |i: u32| around.partition_point(|&other| other < i) as u32;
    let run = |(run, reached): (&PlacedFibre, Vec<(u32, f64, f64)>)| {
        let drive = drive(&body.fibres[run.fibre].activation.as_ref()?.drive, &body.drives);
        Some(DrivenRun {
            fractions: run.thickening(body)?,
            drive: DriveAlong::new(&drive, reached.iter().map(|(.., along)| *along)),
            reached: reached.into_iter().map(|(i, left, _)| (place(i), left)).collect(),
        })
    };
    Some(DrivenFractions {
        others: smoothed(body, &at, kernel, (fibres.iter().filter(|run| !is_driven(run)), sheets)),
        painted: at
            .iter()
            .map(|&at| {
                let [none, all] = [0.0, 1.0].map(|fraction| painted(fraction, at, &body.paint));
                [all - none, none]
            })
            .collect(),
        runs: fibres.iter().filter(is_driven).zip(reached).filter_map(run).collect(),
        particles: around,
    })
}

/// Share of matrix, `1 - l_i`.
pub(super) fn matrix_fractions(fractions: &[f64]) -> Arc<[f64]> {
    fractions.iter().map(|fraction| 1.0 - fraction).collect()
}
