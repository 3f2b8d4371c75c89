//! What the matrix is made of at every particle, where regions have one of their own.

use super::error::BakeError;
use super::supports::{Regions, find};
use crate::geometry::neighbours::PointGrid;
use crate::scene::{Body, RegionMaterial};
use glam::DVec3;
use rayon::prelude::*;
use std::sync::Arc;

/// What differs from particle to particle; nothing where it is the same everywhere.
#[derive(Default)]
pub(super) struct Varied {
    /// By how much the matrix is stiffer than the body's material.
    pub(super) stiffening: Option<Arc<[f64]>>,
    /// Masses [kg].
    pub(super) masses: Option<Vec<f64>>,
    /// Rates of radial damping [1/s].
    pub(super) damping: Option<Vec<f64>>,
}

/// Of a body of particles at `points` [m], each of `mass` [kg] and, at rest, of `volume` [m³].
pub(super) fn varied(
    body: &Body,
    regions: &Regions,
    points: &[DVec3],
    [mass, volume]: [f64; 2],
    path: &str,
) -> Result<Varied, BakeError> {
    let mut varied = Varied::default();
    let spacing = body.material.spacing();
    for (k, of) in body.region_materials.iter().enumerate() {
        let region = find(regions, &of.region, &format!("{path}/region_materials/{k}/region"))?;
        let shares = shares(of, region, points, spacing);
        if let Some(young_modulus) = of.young_modulus {
            let factor = young_modulus / body.material.young_modulus;
            let before = varied.stiffening.take().map_or_else(|| vec![1.0; points.len()], |of| of.to_vec());
            let blended =
                before.iter().zip(&shares).map(|(before, share)| before.powf(1.0 - share) * factor.powf(*share));
            varied.stiffening = Some(blended.collect());
        }
        if let Some(density) = of.density {
            blend(varied.masses.get_or_insert_with(|| vec![mass; points.len()]), &shares, density * volume);
        }
        if let Some(damping) = of.damping {
            let rate = body.material.damping.pair;
            blend(varied.damping.get_or_insert_with(|| vec![rate; points.len()]), &shares, damping);
        }
    }
    Ok(varied)
}

fn blend(values: &mut [f64], shares: &[f64], value: f64) {
    for (old, share) in values.iter_mut().zip(shares) {
        *old = (1.0 - share) * *old + share * value;
    }
}

/// How far each particle is made of a region's material: 1 in it, smoothly less over its transition.
fn shares(of: &RegionMaterial, region: &[u32], points: &[DVec3], spacing: f64) -> Vec<f64> {
    let mut is_inside = vec![false; points.len()];
    for &i in region {
        is_inside[i as usize] = true;
    }
    let inside: Vec<DVec3> = region.iter().map(|&i| points[i as usize]).collect();
    if of.transition == 0.0 {
        return is_inside.into_iter().map(|inside| f64::from(u8::from(inside))).collect();
    }
    // The region ends half way to the particles beside it.
    let reach = of.transition + 0.5 * spacing;
    let grid = PointGrid::new(&inside, reach);
    let share = |i: usize| {
        if is_inside[i] {
            return 1.0;
        }
        let near = grid.within(points[i]).into_iter();
        let nearest = near.map(|k| points[i].distance(inside[k as usize])).fold(reach, f64::min);
        let t = ((reach - nearest) / of.transition).clamp(0.0, 1.0);
        t * t * (3.0 - 2.0 * t)
    };
    (0..points.len()).into_par_iter().with_min_len(256).map(share).collect()
}
