//! The two passes of an evaluation over the chunks of a body.

use super::brick_data::{BrickStress, BrickVectors};
use super::brick_law::{BrickLaw, BrickState};
use super::layout::Chunk;
use super::line_buffer::LineBuffer;
use super::precomputed::Precomputed;
use super::row_stencil::{Around, RowStencil};
use super::row_table::DISTANCES;
use crate::solver::forces::bricks::NO_PARTICLE;
use crate::solver::wide::{Lanes, Vec3x, Wide};
use fearless_simd::Simd;
use glam::{DMat3, DVec3};

/// What an evaluation reads, which all threads share; for stencils of |o|² up to M, over N rows.
pub(super) struct StencilPasses<'a, L, const M: usize, const N: usize> {
    pub(super) fixed: &'a Precomputed<L>,
    pub(super) law: BrickLaw,
    /// A particle and how far the mean of all lies from it [m]: differences to a particle first, since they are exact
    /// far from the origin, too. Deviations from the mean add up to zero, and so does what rounding makes of constant
    /// ones.
    pub(super) origin: [DVec3; 2],
}

/// What the first pass writes, brick by brick of a chunk.
pub(super) struct FirstPassOutput<'a, L> {
    /// The particles' own part of their forces [N].
    pub(super) own: &'a mut [BrickVectors<L>],
    /// Of x, y and z.
    pub(super) stresses: [&'a mut [BrickStress<L>]; 3],
    /// Read before: those of the last evaluation.
    pub(super) rotations: &'a mut [[L; 4]],
}

impl<L: Lanes, const M: usize, const N: usize> StencilPasses<'_, L, M, N> {
    /// Deviations from the rigid turn of the bricks from `first` on.
    pub(super) fn deviate(&self, first: usize, positions: &[DVec3], deviations: &mut [BrickVectors<L>]) {
        let layout = &self.fixed.layout;
        let spacings = self.fixed.spacings;
        let DMat3 { x_axis, y_axis, z_axis } = self.law.body_turn;
        let step = DMat3::from_cols(spacings.x * x_axis, spacings.y * y_axis, spacings.z * z_axis);
        let to_body = self.law.body_turn.transpose();
        let [origin, mean] = self.origin;
        for (k, deviations) in deviations.iter_mut().enumerate() {
            let corner = step * layout.corners[first + k];
            for (lane, &i) in layout.bricks.particles(first + k).iter().enumerate() {
                if i != NO_PARTICLE {
                    let x = (positions[i as usize] - origin) - mean;
                    let u = if L::SHORT {
                        to_body * x - spacings * (layout.corners[first + k] + lane as f64 * DVec3::X)
                    } else {
                        x - (corner + lane as f64 * step.x_axis)
                    };
                    deviations[0].set(lane, u.x);
                    deviations[1].set(lane, u.y);
                    deviations[2].set(lane, u.z);
                }
            }
        }
    }

    /// Pass 1: deformation gradients, rotations and stresses of a chunk of bricks.
    #[inline(always)]
    pub(super) fn stresses<S: Simd>(
        &self,
        simd: S,
        chunk: &Chunk,
        deviations: &[BrickVectors<L>],
        out: FirstPassOutput<'_, L>,
        lines: &mut LineBuffer<L>,
    ) {
        let Precomputed { layout, weights, rest, matrix_volumes, .. } = self.fixed;
        let rows = RowStencil::<S, L, M, N> { simd, weights };
        let neighbours = layout.neighbours::<N>();
        let nothing = [[L::Register::constant(simd, 0.0); DISTANCES]; 3];
        for (component, lines) in lines.0.iter_mut().enumerate() {
            for (k, site) in layout.sites[chunk.sites.clone()].iter().enumerate() {
                let sums = match site {
                    Some(site) => {
                        let around = Around { numbers: &neighbours[*site as usize], bricks: deviations };
                        rows.combine_deviations(around, component)
                    }
                    None => nothing,
                };
                rows.put_deviations(&sums, k, lines);
            }
        }
        let [x, y, z] = out.stresses;
        let stresses = x.iter_mut().zip(y).zip(z);
        let bricks = out.own.iter_mut().zip(stresses).zip(out.rotations);
        for (brick, ((own, ((x, y), z)), rotations)) in chunk.bricks.clone().zip(bricks) {
            let sums = rows.shift_deviations(layout.site_of[brick] as usize, lines);
            let state =
                BrickState { rest: rest.of(brick), matrix: &matrix_volumes[brick], deviations: &deviations[brick + 1] };
            (*own, [*x, *y, *z]) = self.law.finish(simd, &state, sums, rotations);
        }
    }

    /// Pass 2: forces on the particles of a chunk of bricks, of which `own` holds their own part.
    #[inline(always)]
    pub(super) fn gather<S: Simd>(
        &self,
        simd: S,
        chunk: &Chunk,
        stresses: [&[BrickStress<L>]; 3],
        own: &mut [BrickVectors<L>],
        lines: &mut LineBuffer<L>,
    ) {
        let Precomputed { layout, weights, .. } = self.fixed;
        let rows = RowStencil::<S, L, M, N> { simd, weights };
        let neighbours = layout.neighbours::<N>();
        let nothing = [[L::Register::constant(simd, 0.0); DISTANCES]; 2];
        for (stresses, lines) in stresses.iter().zip(&mut lines.0) {
            for (k, site) in layout.sites[chunk.sites.clone()].iter().enumerate() {
                let sums = match site {
                    Some(site) => {
                        let around = Around { numbers: &neighbours[*site as usize], bricks: stresses };
                        rows.combine_stresses(around)
                    }
                    None => nothing,
                };
                rows.put_stresses(&sums, k, lines);
            }
        }
        for (brick, own) in chunk.bricks.clone().zip(own) {
            let sums = rows.shift_stresses(layout.site_of[brick] as usize, lines);
            *own = (Vec3x::load(simd, own) + sums).store();
        }
    }
}
