//! A filled shape without its hollows: which particles stay, and whether its walls hold.
//!
//! A particle stays where its centre lies in no hollow. It feels only those that no hollow lies between, so that walls
//! are judged by these: one whose neighbours lie on a plane or a line, or are too few, cannot be held in place. At the
//! rim of an opening a hollow runs out into the open and any wall ends in an edge; there such particles are left out.
//! Anywhere else they are a wall of a single layer.

use super::hollows::{Hollow, Hollows};
use super::lattice::LatticeSample;
use super::neighbours::PointGrid;
use super::thinness::{SINGLE, STRAY, least_eigenvalue};
use glam::{DMat3, DVec3, IVec3};
use rayon::prelude::*;
use std::collections::HashMap;

/// What is left.
#[derive(Clone, Debug)]
pub(crate) struct Carved {
    /// The particles that stay.
    pub(crate) sample: LatticeSample,
    /// Their indices before.
    pub(crate) kept: Vec<u32>,
    /// Particles whose centre lay in a hollow.
    pub(crate) inside: usize,
    /// Particles that were left out at rims too fine to hold them.
    pub(crate) fine: usize,
    /// Particles of pieces that the hollows cut off, which were left out.
    pub(crate) loose: usize,
}

/// A wall of hardly more than one layer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ThinWall {
    /// Its particles.
    pub(crate) count: usize,
    /// The first of them [m].
    pub(crate) at: DVec3,
}

/// Takes hollows out of a filled shape; `radius` [m] is how far particles feel each other, `is_solid` tells what lies
/// inside the shape.
///
/// # Errors
/// [`ThinWall`] where less than two layers are left between a hollow and the outside, or another hollow.
pub(crate) fn carve(
    whole: &LatticeSample,
    hollows: &Hollows,
    radius: f64,
    is_solid: &(dyn Fn(DVec3) -> bool + Sync),
) -> Result<Carved, ThinWall> {
    let outside: Vec<u32> =
        (0..whole.points.len() as u32).filter(|&i| !hollows.contain(whole.points[i as usize])).collect();
    let inside = whole.points.len() - outside.len();
    let mut kept = outside;
    let mut fine = 0;
    loop {
        let sample = chosen(whole, &kept);
        let thin = thin_places(&sample, hollows, radius);
        let at_rim = |&(i, _): &(usize, bool)| is_at_rim(sample.points[i], hollows, whole.spacing, radius, is_solid);
        let (rims, walls): (Vec<_>, Vec<_>) = thin.into_iter().partition(at_rim);
        // What was as thin before is no doing of a hollow.
        let before = Held { grid: PointGrid::new(&whole.points, radius), whole, hollows: &Hollows::default() };
        let walls: Vec<usize> = walls.into_iter().map(|(i, _)| i).filter(|&i| !before.is_single(kept[i])).collect();
        if let Some(&first) = walls.first() {
            return Err(ThinWall { count: walls.len(), at: sample.points[first] });
        }
        let stray: Vec<usize> = rims.into_iter().filter(|(_, is_stray)| *is_stray).map(|(i, _)| i).collect();
        if stray.is_empty() {
            let (kept, loose) = largest_piece(whole, &kept, hollows);
            return Ok(Carved { sample: chosen(whole, &kept), kept, inside, fine, loose });
        }
        fine += stray.len();
        let mut k = 0;
        kept.retain(|_| {
            k += 1;
            stray.binary_search(&(k - 1)).is_err()
        });
    }
}

fn chosen(whole: &LatticeSample, kept: &[u32]) -> LatticeSample {
    LatticeSample {
        points: kept.iter().map(|&i| whole.points[i as usize]).collect(),
        cells: kept.iter().map(|&i| whole.cells[i as usize]).collect(),
        ..whole.clone()
    }
}

/// How particles are held by those that they feel.
struct Held<'a> {
    grid: PointGrid<'a>,
    whole: &'a LatticeSample,
    hollows: &'a Hollows,
}

impl Held<'_> {
    /// Least variance [spacings²] of the particles around one, itself included, and how many others there are.
    fn by(&self, i: u32) -> (f64, usize) {
        let LatticeSample { points, cells, .. } = self.whole;
        let at = points[i as usize];
        let mut near = self.grid.within(at);
        near.retain(|&j| j == i || !self.hollows.separate(at, points[j as usize]));
        let count = near.len() as f64;
        let steps = || near.iter().map(|&j| (cells[j as usize] - cells[i as usize]).as_dvec3());
        let mean = steps().sum::<DVec3>() / count;
        let spread = |y: DVec3| DMat3::from_cols(y * y.x, y * y.y, y * y.z);
        let squares = steps().fold(DMat3::ZERO, |sum, step| sum + spread(step - mean));
        (least_eigenvalue(squares * count.recip()), near.len() - 1)
    }

    fn is_single(&self, i: u32) -> bool {
        self.by(i).0 < SINGLE
    }
}

/// Particles near a hollow in walls of hardly more than one layer, and whether nothing would hold them.
fn thin_places(sample: &LatticeSample, hollows: &Hollows, radius: f64) -> Vec<(usize, bool)> {
    let bounds: Vec<[DVec3; 2]> = hollows.shapes().map(Hollow::bounds).collect();
    let is_near =
        |at: DVec3| bounds.iter().any(|&[min, max]| (min - radius).cmple(at).all() && at.cmple(max + radius).all());
    let held = Held { grid: PointGrid::new(&sample.points, radius), whole: sample, hollows };
    let found: Vec<Option<(usize, bool)>> = (0..sample.points.len())
        .into_par_iter()
        .map(|i| {
            if !is_near(sample.points[i]) {
                return None;
            }
            let (variance, count) = held.by(i as u32);
            let is_stray = variance < STRAY.0 || count < STRAY.1;
            (variance < SINGLE || is_stray).then_some((i, is_stray))
        })
        .collect();
    found.into_iter().flatten().collect()
}

/// Whether a hollow comes out of the shape, or into another hollow, near a point [m].
fn is_at_rim(
    at: DVec3,
    hollows: &Hollows,
    spacing: f64,
    radius: f64,
    is_solid: &(dyn Fn(DVec3) -> bool + Sync),
) -> bool {
    let steps = (2.0 * radius / spacing).ceil() as i32;
    let around = (-steps..=steps)
        .flat_map(|z| (-steps..=steps).flat_map(move |y| (-steps..=steps).map(move |x| IVec3::new(x, y, z))));
    around.map(|step| at + 0.5 * spacing * step.as_dvec3()).any(|near| {
        let hollows = hollows.shapes().filter(|shape| shape.contains(near)).count();
        hollows > 1 || hollows == 1 && !is_solid(near)
    })
}

/// Of the pieces that hang together the one of most particles, and how many others are left.
fn largest_piece(whole: &LatticeSample, kept: &[u32], hollows: &Hollows) -> (Vec<u32>, usize) {
    // Pieces that were apart before may be: only those that hollows cut off are left out.
    let (piece_before, _) = whole.pieces();
    let index: HashMap<IVec3, usize> = kept.iter().enumerate().map(|(k, &i)| (whole.cells[i as usize], k)).collect();
    let mut piece = vec![usize::MAX; kept.len()];
    let mut sizes: Vec<usize> = Vec::new();
    let mut open = Vec::new();
    for seed in 0..kept.len() {
        if piece[seed] != usize::MAX {
            continue;
        }
        let number = sizes.len();
        piece[seed] = number;
        sizes.push(0);
        open.push(seed);
        while let Some(k) = open.pop() {
            sizes[number] += 1;
            let (at, cell) = (whole.points[kept[k] as usize], whole.cells[kept[k] as usize]);
            for step in 0..27 {
                let step = IVec3::new(step % 3 - 1, step / 3 % 3 - 1, step / 9 - 1);
                let Some(&other) = index.get(&(cell + step)) else { continue };
                if piece[other] == usize::MAX && !hollows.separate(at, whole.points[kept[other] as usize]) {
                    piece[other] = number;
                    open.push(other);
                }
            }
        }
    }
    let mut largest: HashMap<usize, usize> = HashMap::new();
    for (k, &i) in kept.iter().enumerate() {
        let best = largest.entry(piece_before[i as usize]).or_insert(piece[k]);
        if sizes[piece[k]] > sizes[*best] {
            *best = piece[k];
        }
    }
    let stays = |k: usize, i: u32| largest.get(&piece_before[i as usize]) == Some(&piece[k]);
    let left: Vec<u32> = kept.iter().enumerate().filter(|(k, i)| stays(*k, **i)).map(|(_, &i)| i).collect();
    let loose = kept.len() - left.len();
    (left, loose)
}
