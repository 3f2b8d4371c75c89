//! Rest neighbourhoods of the material particles: who feels whom, by which weight, over which rest offset.
//!
//! The lists are those of the rest shape and never change (total Lagrangian), and they are never truncated: a list cut
//! at some length is no longer symmetric and loses momentum. On a lattice an offset recurs all over the body, so that
//! each neighbour is an index and the number of its offset in a small palette (80 entries at D = 0.4 h).

mod cutting;

use crate::geometry::hollows::Hollows;
use crate::geometry::kernel::Kernel;
use crate::geometry::lattice::{ASK_EVERY, LatticeSample};
use crate::geometry::neighbours::PointGrid;
use glam::{DMat3, DVec3, IVec3};
use rayon::prelude::*;
use std::collections::HashMap;
use std::ops::Range;
use std::sync::Arc;
use thiserror::Error;

/// A rest offset and its weight.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct RestBond {
    /// `w_ij X_ji` [1/m], `X_ji = X_j - X_i`.
    pub weighted_offset: DVec3,
    /// `w_ij = -V W'(r) / r` [1/m²].
    pub weight: f64,
}

/// The lattice that the particles lie on: there neighbour sums are stencils, the same for every particle.
#[derive(Clone, Debug)]
pub struct Lattice {
    /// Lattice index of every particle.
    pub cells: Arc<[IVec3]>,
    /// Spacing D [m].
    pub spacing: f64,
    /// Unit axes in the model frame, as columns.
    pub axes: DMat3,
    /// By how much it is stretched along them: particles whose indices differ by `o` are `D axes (stretch o)` apart.
    /// The kernel is stretched along, so that weights hang on `|o|²` alone.
    pub stretch: DVec3,
    kernel: Kernel,
    volume: f64,
}

impl Lattice {
    /// `w_ij` [1/m²] of particles whose indices differ by an `o` with `|o|² = norm_squared`; zero out of support.
    pub fn weight(&self, norm_squared: u32) -> f64 {
        self.volume * self.kernel.minus_slope_over_r(self.spacing * f64::from(norm_squared).sqrt())
    }
}

/// Rest neighbourhoods and what follows from them.
#[derive(Clone, Debug)]
pub struct Neighbourhood {
    lattice: Lattice,
    /// Whether some particles do not feel others that are near enough.
    is_cut: bool,
    starts: Vec<u32>,
    neighbours: Vec<u32>,
    bonds: Vec<u32>,
    palette: Vec<RestBond>,
    offsets: Vec<DVec3>,
    /// `A_i^-1`, the inverse of `A_i = sum w_ij X_ji (x) X_ji` (dimensionless).
    pub inverse_moment: Vec<DMat3>,
    /// `B_i = sum w_ij X_ji` [1/m]; zero inside, not at surfaces.
    pub weighted_sum: Vec<DVec3>,
    /// `sum w_ij` [1/m²].
    pub weight_sum: Vec<f64>,
}

/// A shape too thin for its particles.
#[derive(Clone, Debug, PartialEq, Error)]
#[error(
    "{count} of {total} particles lie in a part only one layer thick (the first at {at:.4?} m), which cannot resist \
     bending: give it a smaller support radius than {support_radius} m, for two layers 1.25 times the part's thickness \
     at the usual spacing of 0.4 h"
)]
pub struct TooThin {
    /// Particles whose neighbours lie on a plane or a line.
    pub count: usize,
    /// All particles.
    pub total: usize,
    /// Rest position of the first of them [m].
    pub at: [f64; 3],
    /// Support radius in use [m].
    pub support_radius: f64,
}

/// Condition (least over greatest eigenvalue estimate) of A below which a neighbourhood counts as flat.
const FLAT: f64 = 1e-6;

impl Neighbourhood {
    /// Memory that it takes [bytes].
    pub(super) fn bytes(&self) -> usize {
        size_of_val(&*self.starts)
            + size_of_val(&*self.neighbours)
            + size_of_val(&*self.bonds)
            + size_of_val(&*self.lattice.cells)
            + size_of_val(&*self.inverse_moment)
            + size_of_val(&*self.weighted_sum)
            + size_of_val(&*self.weight_sum)
    }

    /// Builds the neighbourhoods of particles on a lattice (rest, model frame); `volume` is that of a particle [m³].
    ///
    /// # Errors
    /// [`TooThin`] if some particle's neighbours lie on a plane or a line: A has no inverse there.
    pub fn on_lattice(sample: &LatticeSample, kernel: Kernel, volume: f64) -> Result<Self, TooThin> {
        let built = Self::around(sample, kernel, volume, &Hollows::default(), &mut || false)?;
        Ok(built.unwrap_or_else(|| unreachable!("nothing stops it")))
    }

    /// [`Self::on_lattice`], where particles with a hollow between them are no neighbours; none where `stop`, asked
    /// again and again, says that they are no longer wanted.
    ///
    /// # Errors
    /// As [`Self::on_lattice`].
    pub(crate) fn around(
        sample: &LatticeSample,
        kernel: Kernel,
        volume: f64,
        hollows: &Hollows,
        stop: &mut dyn FnMut() -> bool,
    ) -> Result<Option<Self>, TooThin> {
        let LatticeSample { points, cells, spacing, axes, stretch } = sample;
        let even = sample.unstretched();
        let grid = PointGrid::new(&even, kernel.support_radius);
        let together = |(&even, &point): (&DVec3, &DVec3)| {
            let mut near = grid.within(even);
            let all = near.len();
            if !hollows.is_empty() {
                near.retain(|&j| !hollows.separate(point, points[j as usize]));
            }
            (all - near.len(), near)
        };
        let mut lists: Vec<(usize, Vec<u32>)> = Vec::with_capacity(points.len());
        for (even, some) in even.chunks(ASK_EVERY).zip(points.chunks(ASK_EVERY)) {
            if stop() {
                return Ok(None);
            }
            lists.par_extend(even.par_iter().zip(some).map(together));
        }
        let mut this = Self {
            is_cut: lists.iter().any(|(cut, _)| *cut > 0),
            lattice: Lattice {
                cells: cells.as_slice().into(),
                spacing: *spacing,
                axes: *axes,
                stretch: *stretch,
                kernel,
                volume,
            },
            starts: vec![0],
            neighbours: Vec::new(),
            bonds: Vec::new(),
            palette: Vec::new(),
            offsets: Vec::new(),
            inverse_moment: Vec::new(),
            weighted_sum: Vec::new(),
            weight_sum: Vec::new(),
        };
        let mut known: HashMap<IVec3, u32> = HashMap::new();
        for (i, (_, list)) in lists.iter().enumerate() {
            if i % ASK_EVERY == 0 && stop() {
                return Ok(None);
            }
            for &j in list {
                if j as usize == i {
                    continue;
                }
                let step = cells[j as usize] - cells[i];
                let bond = *known.entry(step).or_insert_with(|| this.add_bond(step));
                this.neighbours.push(j);
                this.bonds.push(bond);
            }
            this.starts.push(this.neighbours.len() as u32);
        }
        Ok(this.moments(points, kernel, stop)?.then_some(this))
    }

    fn add_bond(&mut self, step: IVec3) -> u32 {
        let Lattice { axes, spacing, stretch, .. } = self.lattice;
        let offset = axes * (spacing * (stretch * step.as_dvec3()));
        // From |o|², so that offsets of one length have one weight to the last bit.
        let weight = self.lattice.weight(step.length_squared() as u32);
        self.palette.push(RestBond { weighted_offset: weight * offset, weight });
        self.offsets.push(offset);
        self.palette.len() as u32 - 1
    }

    /// Whether they were found; not where `stop` ended it.
    fn moments(&mut self, points: &[DVec3], kernel: Kernel, stop: &mut dyn FnMut() -> bool) -> Result<bool, TooThin> {
        let mut flat = Vec::new();
        for (i, &point) in points.iter().enumerate() {
            if i % ASK_EVERY == 0 && stop() {
                return Ok(false);
            }
            let (mut moment, mut sum, mut weight) = (DMat3::ZERO, DVec3::ZERO, 0.0);
            for k in self.range(i) {
                let bond = self.palette[self.bonds[k] as usize];
                let offset = self.offsets[self.bonds[k] as usize];
                moment += outer(bond.weighted_offset, offset);
                sum += bond.weighted_offset;
                weight += bond.weight;
            }
            // Exact symmetry: the gradient of the energy relies on it.
            let moment = 0.5 * (moment + moment.transpose());
            let trace = moment.x_axis.x + moment.y_axis.y + moment.z_axis.z;
            let determinant = moment.determinant();
            if trace.is_nan() || determinant <= FLAT * trace.powi(3) {
                flat.push(point);
                continue;
            }
            let inverse = moment.inverse();
            self.inverse_moment.push(0.5 * (inverse + inverse.transpose()));
            self.weighted_sum.push(sum);
            self.weight_sum.push(weight);
        }
        match flat.first() {
            None => Ok(true),
            Some(first) => Err(TooThin {
                count: flat.len(),
                total: points.len(),
                at: first.to_array(),
                support_radius: kernel.support_radius,
            }),
        }
    }

    /// The lattice that the particles lie on.
    pub fn lattice(&self) -> &Lattice {
        &self.lattice
    }

    /// Whether hollows keep some particles from feeling others that are near enough: neighbour sums are no stencils
    /// then.
    pub(super) fn is_cut(&self) -> bool {
        self.is_cut
    }

    /// Number of particles.
    pub fn len(&self) -> usize {
        self.starts.len() - 1
    }

    /// Whether there is no particle.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Positions of particle `i`'s bonds in the lists.
    pub fn range(&self, i: usize) -> Range<usize> {
        self.starts[i] as usize..self.starts[i + 1] as usize
    }

    /// Particle `i`'s neighbours with their palette entries, in ascending order of neighbours.
    #[inline]
    pub fn bonds(&self, i: usize) -> impl Iterator<Item = (usize, &RestBond)> {
        let range = self.range(i);
        self.neighbours[range.clone()]
            .iter()
            .zip(&self.bonds[range])
            .map(|(&j, &bond)| (j as usize, &self.palette[bond as usize]))
    }

    /// Particle `i`'s neighbours with their rest offsets X_ji [m].
    pub fn offsets(&self, i: usize) -> impl Iterator<Item = (usize, DVec3)> {
        let range = self.range(i);
        self.neighbours[range.clone()]
            .iter()
            .zip(&self.bonds[range])
            .map(|(&j, &bond)| (j as usize, self.offsets[bond as usize]))
    }

    /// Mean number of neighbours of a particle.
    pub fn mean_neighbours(&self) -> f64 {
        self.neighbours.len() as f64 / self.len().max(1) as f64
    }
}

/// `a (x) b`, the matrix with entries `a_r b_c`.
pub(crate) fn outer(a: DVec3, b: DVec3) -> DMat3 {
    DMat3::from_cols(a * b.x, a * b.y, a * b.z)
}
