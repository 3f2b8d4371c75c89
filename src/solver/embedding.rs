//! Embedding: points that ride on the material particles (eq. 16) by weights that reproduce linear fields.
//!
//! Eq. 17 (a weighted mean) reproduces constants only: it pulls points inwards, moves a helix in the short bar by 2 mm
//! and shortens it by 4 %. Moving-least-squares weights of first order keep every point where it was drawn and move it
//! exactly under any linear deformation. They grow outside the hull of the particles, and so does the stiffness that
//! a fibre vertex passes on: `sum phi²` says by how much.

use crate::geometry::hollows::Hollows;
use crate::geometry::kernel::Kernel;
use crate::geometry::lattice::ASK_EVERY;
use crate::geometry::neighbours::PointGrid;
use glam::{DMat3, DVec3};

/// Weights of one embedded point.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct EmbeddingWeights {
    /// Material particles and their weights phi; the weights sum to one.
    pub weights: Vec<(u32, f64)>,
}

impl EmbeddingWeights {
    /// A particle itself.
    pub fn of_particle(particle: u32) -> Self {
        Self { weights: vec![(particle, 1.0)] }
    }

    /// Position (or velocity) of the point.
    pub fn gather(&self, field: &[DVec3]) -> DVec3 {
        let mut sum = DVec3::ZERO;
        for &(k, phi) in &self.weights {
            sum += phi * field[k as usize];
        }
        sum
    }

    /// Passes a force on the point to the particles, by the same weights.
    pub fn scatter(&self, force: DVec3, forces: &mut [DVec3]) {
        for &(k, phi) in &self.weights {
            forces[k as usize] += phi * force;
        }
    }

    /// `sum phi²`: the share of a force on the point that comes back as the point's own acceleration, per particle
    /// mass.
    pub fn square_sum(&self) -> f64 {
        self.weights.iter().map(|(_, phi)| phi * phi).sum()
    }
}

/// How a small turn of the material around a point is read off its particles (for the rest shape of curved fibres).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TurnWeights {
    /// Particles with `om_k Z_k` [1/m]: the local gradient is `sum x_k (x) (om_k Z_k)`.
    pub weights: Vec<(u32, DVec3)>,
}

/// Computes weights over the material particles of one body at rest.
pub(crate) struct Embedder<'a> {
    points: &'a [DVec3],
    grid: PointGrid<'a>,
    kernel: Kernel,
    median_sum: f64,
    /// What no point reaches across.
    hollows: Hollows,
    /// Share of the heaviest weight below which a particle is left out of a fibre vertex.
    negligible: f64,
}

/// A point counts as embedded from this share of the median kernel sum on.
const LEAST_SUM: f64 = 0.05;
/// And from this number of particles in reach on.
const LEAST_PARTICLES: usize = 4;
/// That share unless all particles are to be kept.
const NEGLIGIBLE: f64 = 0.06;

/// Sum of kernel weights, relative to the kernel's centre, from which on weights are worked out.
const LEAST_WEIGHT: f64 = 1e-30;

impl<'a> Embedder<'a> {
    /// Weights over particles at `points` (rest, model frame).
    #[cfg(test)]
    pub(crate) fn new(points: &'a [DVec3], kernel: Kernel) -> Self {
        let never = &mut || false;
        Self::around(points, kernel, Hollows::default(), never).unwrap_or_else(|| unreachable!("nothing stops it"))
    }

    /// Weights over particles at `points` (rest, model frame), where nothing hangs on those across a hollow; none where
    /// `stop`, asked again and again, says that they are no longer wanted.
    pub(crate) fn around(
        points: &'a [DVec3],
        kernel: Kernel,
        hollows: Hollows,
        stop: &mut dyn FnMut() -> bool,
    ) -> Option<Self> {
        let grid = PointGrid::new(points, kernel.support_radius);
        let mut this = Self { points, grid, kernel, median_sum: 0.0, hollows, negligible: NEGLIGIBLE };
        let mut sums: Vec<f64> = Vec::with_capacity(points.len());
        for some in points.chunks(ASK_EVERY) {
            if stop() {
                return None;
            }
            sums.extend(some.iter().map(|&point| this.kernel_sum(point).0));
        }
        sums.sort_by(f64::total_cmp);
        this.median_sum = sums.get(sums.len() / 2).copied().unwrap_or(0.0);
        Some(this)
    }

    /// The same, with fibre vertices that hang on all particles in reach.
    pub(crate) fn with_all_in_reach(self) -> Self {
        Self { negligible: 0.0, ..self }
    }

    /// Particles in reach of a point.
    fn within(&self, at: DVec3) -> Vec<u32> {
        let mut near = self.grid.within(at);
        if !self.hollows.is_empty() {
            near.retain(|&k| !self.hollows.separate(at, self.points[k as usize]));
        }
        near
    }

    fn kernel_sum(&self, at: DVec3) -> (f64, usize) {
        let near = self.within(at);
        (near.iter().map(|&k| self.kernel.value(self.points[k as usize].distance(at))).sum(), near.len())
    }

    /// Whether enough material lies around the point: four particles and 5 % of the median kernel sum.
    pub(crate) fn is_embedded(&self, at: DVec3) -> bool {
        let (sum, count) = self.kernel_sum(at);
        count >= LEAST_PARTICLES && sum > LEAST_SUM * self.median_sum
    }

    /// Distance to the nearest particle [m].
    pub(crate) fn distance(&self, at: DVec3) -> f64 {
        self.points.iter().map(|point| point.distance_squared(at)).fold(f64::INFINITY, f64::min).sqrt()
    }

    /// Linear-reproducing weights at a point, over the particles that count there: those of more than a negligible
    /// share of the heaviest kernel weight, 6 % unless all are kept. They are half of all in reach, which is what a
    /// fibre vertex costs at every step; linear fields are reproduced all the same. The weights change abruptly from
    /// one point to the next, as a skin must not ([`super::skin_weights`]). None where those particles lie on a plane
    /// or a line, or are too few.
    pub(crate) fn vertex_weights(&self, at: DVec3) -> Option<EmbeddingWeights> {
        self.weighted(at, &self.that_count(at))
    }

    /// Particles in reach of a point with their kernel weights, relative to the kernel's centre.
    fn in_reach(&self, at: DVec3) -> Vec<(u32, f64)> {
        let near = self.within(at).into_iter();
        near.map(|k| (k, self.kernel.relative(self.points[k as usize].distance(at)))).collect()
    }

    /// Those of them whose weight is not negligible.
    fn that_count(&self, at: DVec3) -> Vec<(u32, f64)> {
        let mut near = self.in_reach(at);
        let heaviest = near.iter().map(|&(_, w)| w).fold(0.0, f64::max);
        near.retain(|&(_, w)| w > self.negligible * heaviest);
        near
    }

    fn weighted(&self, at: DVec3, near: &[(u32, f64)]) -> Option<EmbeddingWeights> {
        let h = self.kernel.support_radius;
        // With p = (1, y), y = (X_k - X) / h: phi_k = W_k (1 - y_k . a) / (W - b . a), a = C^-1 b, where W, b, C are
        // the kernel's moments of order 0, 1, 2.
        let (mut w_sum, mut b, mut c) = (0.0, DVec3::ZERO, DMat3::ZERO);
        let terms: Vec<(u32, f64, DVec3)> =
            near.iter().map(|&(k, w)| (k, w, (self.points[k as usize] - at) / h)).collect();
        for &(_, w, y) in &terms {
            w_sum += w;
            b += w * y;
            c += DMat3::from_cols(y * y.x, y * y.y, y * y.z) * w;
        }
        // Quotients of weights that are all negligible would be no numbers.
        if w_sum <= LEAST_WEIGHT {
            return None;
        }
        // Second moments about the centroid decide whether the particles in reach span space.
        let mean = b / w_sum;
        let spread = c - DMat3::from_cols(b * mean.x, b * mean.y, b * mean.z);
        if !spans_space(spread, w_sum) {
            return None;
        }
        let a = spread.inverse() * mean;
        let weights = terms.iter().map(|&(k, w, y)| (k, w * (1.0 / w_sum - (y - mean).dot(a)))).collect();
        Some(EmbeddingWeights { weights })
    }

    /// Where the particles around a point have their kernel-weighted centre [m].
    pub(crate) fn centroid(&self, at: DVec3) -> DVec3 {
        let (mut sum, mut weight) = (DVec3::ZERO, 0.0);
        for k in self.within(at) {
            let point = self.points[k as usize];
            let w = self.kernel.value(point.distance(at));
            sum += w * point;
            weight += w;
        }
        if weight > 0.0 { sum / weight } else { at }
    }

    /// Weights by which the material's turn around a point is read: `om_k` positive and normalised, offsets centred by
    /// their mean, `Z_k = C^-1 Y_k`, so that a pure strain turns nothing. None where C is singular.
    pub(crate) fn turn_weights(&self, at: DVec3) -> Option<TurnWeights> {
        let near = self.that_count(at);
        let total: f64 = near.iter().map(|(_, w)| w).sum();
        let mean: DVec3 = near.iter().map(|&(k, w)| self.points[k as usize] * w).sum::<DVec3>() / total;
        let mut c = DMat3::ZERO;
        for &(k, w) in &near {
            let y = self.points[k as usize] - mean;
            c += DMat3::from_cols(y * y.x, y * y.y, y * y.z) * (w / total);
        }
        if !spans_space(c * self.kernel.support_radius.powi(-2), 1.0) {
            return None;
        }
        let inverse = c.inverse();
        let weights =
            near.into_iter().map(|(k, w)| (k, inverse * (self.points[k as usize] - mean) * (w / total))).collect();
        Some(TurnWeights { weights })
    }
}

/// Whether a symmetric second moment, of offsets in support radii and of this weight, is far from singular. That of a
/// single particle is round-off, and may have any sign.
fn spans_space(c: DMat3, weight: f64) -> bool {
    let trace = c.x_axis.x + c.y_axis.y + c.z_axis.z;
    trace > 1e-9 * weight && c.determinant() > 1e-6 * trace.powi(3)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::lattice::{Cuboid, fill_box};

    /// Over all particles in reach.
    fn weights(embedder: &Embedder<'_>, at: DVec3) -> Option<EmbeddingWeights> {
        embedder.weighted(at, &embedder.in_reach(at))
    }

    fn particles() -> Vec<DVec3> {
        let shape = Cuboid { center: DVec3::ZERO, size: DVec3::new(0.042, 0.072, 0.042) };
        fill_box(&shape, 0.006, DMat3::IDENTITY).points
    }

    #[test]
    fn weights_reproduce_linear_fields_inside_and_outside_the_hull() {
        let points = particles();
        let embedder = Embedder::new(&points, Kernel::new(0.015));
        let gradient = DMat3::from_cols_array(&[1.1, 0.2, -0.3, 0.05, 0.9, 0.4, -0.2, 0.1, 1.3]);
        let moved: Vec<DVec3> = points.iter().map(|&x| gradient * x + DVec3::new(0.3, -0.2, 0.1)).collect();
        for at in [DVec3::ZERO, DVec3::new(0.021, 0.036, 0.021), DVec3::new(0.003, -0.036, 0.011)] {
            let weights = weights(&embedder, at).unwrap();
            assert!(weights.gather(&points).distance(at) < 1e-15);
            let expected = gradient * at + DVec3::new(0.3, -0.2, 0.1);
            assert!(weights.gather(&moved).distance(expected) < 1e-14);
        }
    }

    #[test]
    fn square_sums_grow_outside_the_hull_as_designed() {
        let points = particles();
        let embedder = Embedder::new(&points, Kernel::new(0.015));
        let square_sum = |x: f64, y: f64, z: f64| weights(&embedder, DVec3::new(x, y, z)).unwrap().square_sum();
        // At the hull's corner, and half a spacing beyond it along one, two and three axes.
        let found = [
            square_sum(0.018, 0.033, 0.018),
            square_sum(0.021, 0.033, 0.018),
            square_sum(0.021, 0.036, 0.018),
            square_sum(0.021, 0.036, 0.021),
        ];
        for (found, expected) in found.into_iter().zip([0.63, 1.38, 2.8, 5.5]) {
            assert!((found - expected).abs() < 0.05 * expected, "{found}, not {expected}");
        }
        assert!(square_sum(0.0, 0.0, 0.0) < 0.06);
    }

    #[test]
    fn a_pure_strain_turns_nothing() {
        let points = particles();
        let embedder = Embedder::new(&points, Kernel::new(0.015));
        let strain = DMat3::from_cols_array(&[1.1, 0.03, 0.0, 0.03, 0.95, 0.02, 0.0, 0.02, 0.97]);
        let moved: Vec<DVec3> = points.iter().map(|&x| strain * x).collect();
        for at in [DVec3::ZERO, DVec3::new(0.02, 0.035, 0.0)] {
            let turn = embedder.turn_weights(at).unwrap();
            let mut gradient = DMat3::ZERO;
            for &(k, z) in &turn.weights {
                gradient += crate::solver::neighbourhood::outer(moved[k as usize], z);
            }
            let asymmetry = gradient - gradient.transpose();
            assert!(asymmetry.to_cols_array().iter().all(|e| e.abs() < 1e-12), "{gradient}");
        }
    }

    #[test]
    fn far_points_are_not_embedded() {
        let points = particles();
        let embedder = Embedder::new(&points, Kernel::new(0.015));
        assert!(embedder.is_embedded(DVec3::new(0.0, 0.036, 0.0)));
        assert!(!embedder.is_embedded(DVec3::new(0.0, 0.06, 0.0)));
        assert!(weights(&embedder, DVec3::new(0.0, 0.06, 0.0)).is_none());
        assert!((embedder.distance(DVec3::new(0.0, 0.06, 0.0)) - 0.027).abs() < 1e-12);
    }
}
