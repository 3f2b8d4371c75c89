//! What a stencil computes once.

use super::brick_data::{BrickRest, MatrixVolume, matrix_volumes, rest_data};
use super::layout::Layout;
use super::row_stencil::StencilWeights;
use super::row_table::{MAX_NORM_SQUARED, rows_within};
use crate::solver::forces::bricks::Palette;
use crate::solver::forces::matrix::reference::ReferenceConfiguration;
use crate::solver::wide::Lanes;
use glam::DVec3;
use std::array::from_fn;

/// Rows of a stencil of |o|² up to 6.
pub(super) const ROWS_UP_TO_6: usize = rows_within(6);
/// Rows of a stencil of |o|² up to 11.
pub(super) const ROWS_UP_TO_11: usize = rows_within(11);

/// Stencils that there is code for, by the greatest |o|² they hold.
#[derive(Clone, Copy)]
pub(super) enum StencilSize {
    /// D / h from 0.354 on, 0.4 among them.
    UpTo6,
    /// D / h from 0.289 on.
    UpTo11,
}

impl StencilSize {
    /// Greatest |o|².
    fn norm_squared(self) -> usize {
        match self {
            Self::UpTo6 => 6,
            Self::UpTo11 => MAX_NORM_SQUARED,
        }
    }
}

/// What does not change.
pub(super) struct Precomputed<L> {
    pub(super) layout: Layout,
    pub(super) weights: StencilWeights<L>,
    pub(super) size: StencilSize,
    pub(super) rest: Palette<BrickRest<L>>,
    pub(super) matrix_volumes: Vec<MatrixVolume<L>>,
    /// Spacings along the stencil's axes [m].
    pub(super) spacings: DVec3,
}

impl<L: Lanes> Precomputed<L> {
    /// Layout, weights and rest data of a body; none where the support holds too many particles, or some do not feel
    /// others across a hollow.
    pub(super) fn new(reference: &ReferenceConfiguration) -> Option<Self> {
        if reference.neighbourhood.is_cut() {
            return None;
        }
        let lattice = reference.neighbourhood.lattice();
        let weights: [f64; MAX_NORM_SQUARED + 1] = from_fn(|square| lattice.weight(square as u32));
        if lattice.weight(MAX_NORM_SQUARED as u32 + 1) > 0.0 {
            return None;
        }
        let size = match weights.iter().rposition(|&weight| weight > 0.0) {
            None | Some(0..=6) => StencilSize::UpTo6,
            Some(_) => StencilSize::UpTo11,
        };
        let layout = Layout::new(lattice, size.norm_squared(), L::COUNT);
        Some(Self {
            weights: StencilWeights::new(weights, lattice.spacing * layout.stretch),
            spacings: lattice.spacing * layout.stretch,
            size,
            rest: rest_data(reference, &layout.bricks, &layout.axes),
            matrix_volumes: matrix_volumes(reference, &layout.bricks),
            layout,
        })
    }
}
