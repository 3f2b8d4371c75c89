//! How points of a skin hang on the particles, wherever they lie: on them, at a tip, far outside.
//!
//! A point at X is carried by the particles X_k within a support radius that grows with the distance to the nearest of
//! them, so that weights neither vanish nor jump: `H = max(h, 2.5 |X - X_nearest|)`. With p_k the kernel's shares, c
//! their centre and S their second moment about it, moving least squares of first order are `w_k = p_k (1 + (X_k - c) .
//! S^-1 (X - c))`: they sum to one, put the point where it is, and move it exactly under any linear deformation. But
//! they grow without bound where the particles are flat beside its distance. What bounds them is the identity `sum p_k
//! ((X_k - c) . S^-1 m)² = m . S^-1 m`: the weights are those of c + m with m the point nearest to X - c for which that
//! is at most [`FARTHEST`]² (`m = S (S + t)^-1 (X - c)`, with t = 0 almost everywhere). Hence
//!
//! - `sum |w_k| <= 1 + FARTHEST`, for every point and any particles;
//! - where the particles around span space and the point is no further off than eight times their spread, linear
//!   deformations are exact;
//! - otherwise an *arm* `X - c - m` is left, which turns with the particles around ([`super::skin_arms`]). It grows
//!   from nothing: weights and arms are continuous in X, since so are H, p, c, S, and the projection onto an ellipsoid,
//!   a flat one and a point included.
//!
//! Plain moving least squares of a fixed radius instead fail at tips: kernel weights of all particles in reach may be
//! negligible, and their quotients are anything or no numbers at all.

use super::linear_algebra::symmetric::eigen;
use crate::geometry::hollows::Hollows;
use crate::geometry::kernel::Kernel;
use crate::geometry::point_tree::PointTree;
use glam::{DMat3, DVec3, IVec3};
use std::collections::HashSet;

/// Support radius over the distance to the nearest particle, at least.
const REACH: f64 = 2.5;

/// Distance from the particles' centre, in standard deviations of theirs along the way there, up to which weights alone
/// carry a point. Corners of a box lie at 3.6, tips of thick bodies far outside at 5.
pub(crate) const FARTHEST: f64 = 8.0;

/// Second moments below this share of their sum are rounding: the particles lie on a plane or a line.
const FLAT: f64 = 1e-14;

/// Support radius, in those of the body, up to which every particle counts; from there to twice it those that stand for
/// no cell fade out, and so from octave to octave.
const FINE: f64 = 2.0;

/// Width of the first cells, in support radii of the body; they double from octave to octave. When only the
/// representatives of a width carry, the support radius is at least 3.3 times as large: with a nearest particle at
/// 0.4 of that, its cell's representative is in reach.
const CELL: f64 = 1.2;

/// So many particles or fewer stand for the whole body, however far off a point is.
const FEW: usize = 64;

/// A point of a skin.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Carried {
    /// Particles and their weights, which sum to one.
    pub(super) weights: Vec<(u32, f64)>,
    /// What they leave of the way to the point.
    pub(super) arm: Option<Arm>,
}

/// The rest of the way to a point, which turns with particles.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Arm {
    /// At rest, model frame [m].
    pub(super) offset: DVec3,
    /// Particles with their weighed offsets Z_k from their centre: the turn is that of `sum x_k (x) Z_k`.
    pub(super) turn: Vec<(u32, DVec3)>,
}

/// Finds how points hang on the particles of one body at rest.
pub(super) struct SkinEmbedder<'a> {
    points: &'a [DVec3],
    support_radius: f64,
    /// Up to which octave every particle stands for others.
    levels: Vec<u8>,
    /// Particles of each level and above.
    trees: Vec<(Vec<u32>, PointTree)>,
    hollows: &'a Hollows,
}

impl<'a> SkinEmbedder<'a> {
    /// Over particles at `points` (rest, model frame), with hollows across which nothing hangs on them; none without
    /// any.
    pub(super) fn new(points: &'a [DVec3], kernel: Kernel, hollows: &'a Hollows) -> Option<Self> {
        if points.is_empty() {
            return None;
        }
        let support_radius = kernel.support_radius;
        let levels = levels(points, CELL * support_radius);
        let top = levels.iter().copied().max().unwrap_or(0);
        let tree = |level| {
            let among: Vec<u32> = (0..points.len() as u32).filter(|&k| levels[k as usize] >= level).collect();
            let tree = PointTree::new(among.iter().map(|&k| points[k as usize]).collect());
            (among, tree)
        };
        let trees = (0..=top).map(tree).collect();
        Some(Self { points, support_radius, levels, trees, hollows })
    }

    /// How a point hangs on the particles.
    pub(super) fn carried(&self, at: DVec3) -> Carried {
        let radius = self.support_radius.max(REACH * self.trees[0].1.distance(at));
        self.carried_by(at, self.shares(at, radius))
    }

    /// The turn of the whole body: particles with their offsets from their centre.
    pub(super) fn whole(&self) -> Vec<(u32, DVec3)> {
        let few = self.trees.last().into_iter().flat_map(|(among, _)| among);
        let shares: Vec<(u32, f64)> = few.map(|&k| (k, 1.0)).collect();
        Cloud::new(self.points, shares).turn()
    }

    /// Particles in reach of a point with their kernel weights; never all zero.
    fn shares(&self, at: DVec3, radius: f64) -> Vec<(u32, f64)> {
        let kernel = Kernel::new(radius);
        let fine = FINE * self.support_radius;
        // Those of lower levels have faded out.
        let gone = (radius / (2.0 * fine)).log2().floor() + 1.0;
        let (among, tree) = &self.trees[(gone.max(0.0) as usize).min(self.trees.len() - 1)];
        let share = |index: u32| {
            let k = among[index as usize];
            let level = self.levels[k as usize];
            let w = kernel.relative(self.points[k as usize].distance(at));
            let last = usize::from(level) + 1 == self.trees.len();
            (k, if last { w } else { w * fading(radius / (fine * f64::from(level).exp2())) })
        };
        let mut shares: Vec<(u32, f64)> =
            tree.within(at, radius).into_iter().map(share).filter(|&(_, w)| w > 0.0).collect();
        if !self.hollows.is_empty() {
            let seen = |&(k, _): &(u32, f64)| !self.hollows.separate(at, self.points[k as usize]);
            // A point that sees none hangs on whatever is near.
            if shares.iter().any(seen) {
                shares.retain(seen);
            }
        }
        shares
    }

    fn carried_by(&self, at: DVec3, shares: Vec<(u32, f64)>) -> Carried {
        let cloud = Cloud::new(self.points, shares);
        let way = (at - cloud.center) / cloud.size;
        let (values, axes) = eigen(cloud.moment);
        let values = values.to_array().map(|value| if value > FLAT { value } else { 0.0 });
        let along = (axes.transpose() * way).to_array();
        let (give, is_short) = give(values, along);
        let slope: [f64; 3] =
            std::array::from_fn(|k| if values[k] > 0.0 { along[k] / (values[k] + give) } else { 0.0 });
        let slope = axes * DVec3::from_array(slope);
        let weights: Vec<(u32, f64)> =
            cloud.shares.iter().zip(&cloud.offsets).map(|(&(k, p), y)| (k, p * (1.0 + y.dot(slope)))).collect();
        let is_flat = (0..3).any(|k| values[k] == 0.0);
        let arm = (is_short || is_flat).then(|| {
            let carried: DVec3 = weights.iter().map(|&(k, w)| w * (self.points[k as usize] - cloud.center)).sum();
            Arm { offset: at - cloud.center - carried, turn: cloud.turn() }
        });
        Carried { weights, arm }
    }
}

/// The t by which the ellipsoid's nearest point is found, in units of the moment, and whether it takes one: the way has
/// components `along` the axes of a moment of eigenvalues `values`, whose sum is one.
fn give(values: [f64; 3], along: [f64; 3]) -> (f64, bool) {
    let square = |t: f64| -> f64 {
        let part = |k: usize| if values[k] > 0.0 { values[k] * (along[k] / (values[k] + t)).powi(2) } else { 0.0 };
        (0..3).map(part).sum()
    };
    if square(0.0) <= FARTHEST * FARTHEST {
        return (0.0, false);
    }
    let (mut low, mut high) = (0.0, DVec3::from_array(along).length() / FARTHEST);
    for _ in 0..64 {
        let middle = 0.5 * (low + high);
        if square(middle) > FARTHEST * FARTHEST {
            low = middle;
        } else {
            high = middle;
        }
    }
    (high, true)
}

/// Particles by their shares.
struct Cloud {
    /// Particles and shares, which sum to one.
    shares: Vec<(u32, f64)>,
    /// Their mean [m].
    center: DVec3,
    /// Root of their mean square distance from it [m]; one where that is nothing.
    size: f64,
    /// Offsets from it, in sizes.
    offsets: Vec<DVec3>,
    /// Second moment of those; its trace is one, or nothing.
    moment: DMat3,
}

impl Cloud {
    fn new(points: &[DVec3], mut shares: Vec<(u32, f64)>) -> Self {
        let sum: f64 = shares.iter().map(|(_, w)| w).sum();
        for (_, w) in &mut shares {
            *w /= sum;
        }
        // About one of them: far from the origin nothing else cancels.
        let first = shares.first().map_or(DVec3::ZERO, |&(k, _)| points[k as usize]);
        let center = first + shares.iter().map(|&(k, p)| p * (points[k as usize] - first)).sum::<DVec3>();
        let mut offsets: Vec<DVec3> = shares.iter().map(|&(k, _)| points[k as usize] - center).collect();
        let square: f64 = shares.iter().zip(&offsets).map(|((_, p), y)| p * y.length_squared()).sum();
        let size = if square > 0.0 { square.sqrt() } else { 1.0 };
        for y in &mut offsets {
            *y /= size;
        }
        let mut moment = DMat3::ZERO;
        for ((_, p), &y) in shares.iter().zip(&offsets) {
            moment += DMat3::from_cols(y * y.x, y * y.y, y * y.z) * *p;
        }
        Self { shares, center, size, offsets, moment }
    }

    fn turn(&self) -> Vec<(u32, DVec3)> {
        self.shares.iter().zip(&self.offsets).map(|(&(k, p), y)| (k, p * *y)).collect()
    }
}

/// One up to a radius of one octave's beginning, zero from its end on, with no kink between.
fn fading(radius: f64) -> f64 {
    let s = (radius - 1.0).clamp(0.0, 1.0);
    (1.0 - s).powi(2) * (1.0 + 2.0 * s)
}

/// Up to which octave every particle stands for those of its cell: cells are `cell` [m] wide in the first, twice as
/// wide in the next, until there are few. Which one of a cell is as good as random, so that thin parts keep their
/// thickness.
fn levels(points: &[DVec3], cell: f64) -> Vec<u8> {
    let corner = points.iter().copied().fold(DVec3::INFINITY, DVec3::min);
    let mut levels = vec![0; points.len()];
    let mut left: Vec<u32> = (0..points.len() as u32).collect();
    left.sort_unstable_by_key(|&k| (scrambled(k), k));
    for level in 1..=u8::MAX {
        if left.len() <= FEW {
            break;
        }
        let width = cell * f64::from(level - 1).exp2();
        let mut cells: HashSet<IVec3> = HashSet::new();
        left.retain(|&k| cells.insert(((points[k as usize] - corner) / width).floor().as_ivec3()));
        for &k in &left {
            levels[k as usize] = level;
        }
    }
    levels
}

/// An index in another order.
fn scrambled(index: u32) -> u32 {
    let mut x = index.wrapping_add(1).wrapping_mul(0x9E37_79B9);
    x ^= x >> 16;
    x = x.wrapping_mul(0x85EB_CA6B);
    x ^ (x >> 13)
}
