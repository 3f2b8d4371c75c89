//! What is kept of a brick.

use crate::solver::forces::bricks::{Bricks, NO_PARTICLE, Palette};
use crate::solver::forces::matrix::reference::ReferenceConfiguration;
use crate::solver::wide::{LANES, Lanes4};
use glam::DMat3;
use rayon::prelude::*;

/// A vector of each particle, by components.
pub(super) type BrickVectors = [Lanes4; 3];

/// What a particle's neighbours feel of it: the columns of `Q` [N], then `z = al u - Y` [N m].
pub(super) type BrickStress = [Lanes4; 12];

/// Rest data, along the stencil's axes; zero where no particle is.
pub(super) struct BrickRest {
    /// `A^-1`: 00, 01, 02, 11, 12, 22.
    pub(super) inverse_moment: [Lanes4; 6],
    /// `B` [1/m].
    pub(super) weighted_sum: [Lanes4; 3],
    /// `n = sum w` [1/m²].
    pub(super) weight_sum: Lanes4,
}

impl From<[Lanes4; 10]> for BrickRest {
    fn from([inverse_moment @ .., b0, b1, b2, weight_sum]: [Lanes4; 10]) -> Self {
        Self { inverse_moment, weighted_sum: [b0, b1, b2], weight_sum }
    }
}

/// How much matrix there is in and around a brick's particles.
#[derive(Clone, Copy, Default)]
pub(super) struct MatrixVolume {
    /// `s V` [m³].
    pub(super) own: Lanes4,
    /// `sum w_ij s_j V` [m].
    pub(super) around: Lanes4,
}

/// Rest data of all bricks of rows along the first of these axes.
pub(super) fn rest_data(reference: &ReferenceConfiguration, bricks: &Bricks, axes: &DMat3) -> Palette<BrickRest> {
    let rest = &reference.neighbourhood;
    Palette::new(bricks.particles.iter().map(|particles| {
        let mut numbers = [Lanes4::default(); 10];
        for (lane, i) in present(particles) {
            let [x, y, z] = (axes.transpose() * rest.inverse_moment[i] * *axes).to_cols_array_2d();
            let sum = axes.transpose() * rest.weighted_sum[i];
            let all = [x[0], y[0], z[0], y[1], z[1], z[2], sum.x, sum.y, sum.z, rest.weight_sum[i]];
            for (number, value) in numbers.iter_mut().zip(all) {
                number.0[lane] = value;
            }
        }
        numbers
    }))
}

/// Volumes of matrix of all bricks.
pub(super) fn matrix_volumes(reference: &ReferenceConfiguration, bricks: &Bricks) -> Vec<MatrixVolume> {
    let ReferenceConfiguration { neighbourhood, matrix_fraction, volume, .. } = reference;
    let of_brick = |particles: &[u32; LANES]| {
        let mut matrix = MatrixVolume::default();
        for (lane, i) in present(particles) {
            let around: f64 = neighbourhood.bonds(i).map(|(j, bond)| bond.weight * matrix_fraction[j]).sum();
            matrix.own.0[lane] = volume * matrix_fraction[i];
            matrix.around.0[lane] = volume * around;
        }
        matrix
    };
    bricks.particles.par_iter().map(of_brick).collect()
}

/// The particles of a brick with their lanes.
fn present(particles: &[u32; LANES]) -> impl Iterator<Item = (usize, usize)> {
    particles.iter().enumerate().filter(|(_, i)| **i != NO_PARTICLE).map(|(lane, &i)| (lane, i as usize))
}
