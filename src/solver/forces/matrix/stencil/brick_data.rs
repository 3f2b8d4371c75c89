//! What is kept of a brick.

use crate::solver::forces::bricks::{Bricks, NO_PARTICLE, Palette};
use crate::solver::forces::matrix::reference::ReferenceConfiguration;
use crate::solver::wide::Lanes;
use glam::DMat3;
use rayon::prelude::*;

/// A vector of each particle, by components.
pub(super) type BrickVectors<L> = [L; 3];

/// A component of what a particle's neighbours feel of it: that of the columns of `Q` [N], then of `z = al u - Y` [N
/// m].
pub(super) type BrickStress<L> = [L; 4];

/// Rest data, along the stencil's axes; zero where no particle is.
pub(super) struct BrickRest<L> {
    /// `A^-1`: 00, 01, 02, 11, 12, 22.
    pub(super) inverse_moment: [L; 6],
    /// `B` [1/m].
    pub(super) weighted_sum: [L; 3],
    /// `n = sum w` [1/m²].
    pub(super) weight_sum: L,
}

impl<L> From<[L; 10]> for BrickRest<L> {
    fn from([inverse_moment @ .., b0, b1, b2, weight_sum]: [L; 10]) -> Self {
        Self { inverse_moment, weighted_sum: [b0, b1, b2], weight_sum }
    }
}

/// How much matrix there is in and around a brick's particles.
#[derive(Clone, Copy, Default)]
pub(super) struct MatrixVolume<L> {
    /// `s V` [m³].
    pub(super) own: L,
    /// `sum w_ij s_j V` [m].
    pub(super) around: L,
}

/// Rest data of all bricks of rows along the first of these axes.
pub(super) fn rest_data<L: Lanes>(
    reference: &ReferenceConfiguration,
    bricks: &Bricks,
    axes: &DMat3,
) -> Palette<BrickRest<L>> {
    let rest = &reference.neighbourhood;
    Palette::new(bricks.all_particles().map(|particles| {
        let mut numbers = [L::default(); 10];
        for (lane, i) in present(particles) {
            let [x, y, z] = (axes.transpose() * rest.inverse_moment[i] * *axes).to_cols_array_2d();
            let sum = axes.transpose() * rest.weighted_sum[i];
            let all = [x[0], y[0], z[0], y[1], z[1], z[2], sum.x, sum.y, sum.z, rest.weight_sum[i]];
            for (number, value) in numbers.iter_mut().zip(all) {
                number.set(lane, value);
            }
        }
        numbers
    }))
}

/// Volumes of matrix of all bricks.
pub(super) fn matrix_volumes<L: Lanes>(reference: &ReferenceConfiguration, bricks: &Bricks) -> Vec<MatrixVolume<L>> {
    let ReferenceConfiguration { neighbourhood, matrix_weight, volume, .. } = reference;
    let of_brick = |brick: usize| {
        let mut matrix = MatrixVolume::<L>::default();
        for (lane, i) in present(bricks.particles(brick)) {
            let around: f64 = neighbourhood.bonds(i).map(|(j, bond)| bond.weight * matrix_weight[j]).sum();
            matrix.own.set(lane, volume * matrix_weight[i]);
            matrix.around.set(lane, volume * around);
        }
        matrix
    };
    (0..bricks.len()).into_par_iter().map(of_brick).collect()
}

/// The particles of a brick with their lanes.
fn present(particles: &[u32]) -> impl Iterator<Item = (usize, usize)> {
    particles.iter().enumerate().filter(|(_, i)| **i != NO_PARTICLE).map(|(lane, &i)| (lane, i as usize))
}
