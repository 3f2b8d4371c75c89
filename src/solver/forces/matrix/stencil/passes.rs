//! The two passes of an evaluation over the chunks of a body.

use super::brick_data::{BrickStress, BrickVectors};
use super::brick_law::{BrickLaw, BrickState};
use super::layout::Chunk;
use super::line_buffer::LineBuffer;
use super::precomputed::Precomputed;
use super::row_stencil::RowStencil;
use crate::solver::forces::bricks::NO_PARTICLE;
use crate::solver::wide::{Lanes4, Vec3x};
use fearless_simd::Simd;
use glam::DVec3;

/// What an evaluation reads, which all threads share; for stencils of |o|² up to M, over N rows.
pub(super) struct StencilPasses<'a, const M: usize, const N: usize> {
    pub(super) fixed: &'a Precomputed,
    pub(super) law: BrickLaw,
    /// A particle and how far the mean of all lies from it [m]: differences to a particle first, since they are exact
    /// far from the origin, too. Deviations from the mean add up to zero, and so does what rounding makes of constant
    /// ones.
    pub(super) origin: [DVec3; 2],
}

/// What the first pass writes, brick by brick of a chunk.
pub(super) struct FirstPassOutput<'a> {
    /// The particles' own part of their forces [N].
    pub(super) own: &'a mut [BrickVectors],
    pub(super) stresses: &'a mut [BrickStress],
    /// Read before: those of the last evaluation.
    pub(super) rotations: &'a mut [[Lanes4; 4]],
}

impl<const M: usize, const N: usize> StencilPasses<'_, M, N> {
    /// Deviations from the rigid turn of the bricks from `first` on.
    pub(super) fn deviate(&self, first: usize, positions: &[DVec3], deviations: &mut [BrickVectors]) {
        let layout = &self.fixed.layout;
        let step = self.fixed.spacing * self.law.body_turn;
        let [origin, mean] = self.origin;
        for (k, deviations) in deviations.iter_mut().enumerate() {
            let corner = step * layout.corners[first + k];
            for (lane, &i) in layout.bricks.particles[first + k].iter().enumerate() {
                if i != NO_PARTICLE {
                    let u = ((positions[i as usize] - origin) - mean) - (corner + lane as f64 * step.x_axis);
                    deviations[0].0[lane] = u.x;
                    deviations[1].0[lane] = u.y;
                    deviations[2].0[lane] = u.z;
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
        deviations: &[BrickVectors],
        out: FirstPassOutput<'_>,
        lines: &mut LineBuffer,
    ) {
        let Precomputed { layout, weights, rest, matrix_volumes, .. } = self.fixed;
        let rows = RowStencil::<S, M, N> { simd, weights };
        for (k, site) in layout.sites[chunk.sites.clone()].iter().enumerate() {
            match site {
                Some(site) => rows.combine_deviations(layout.neighbours(*site), deviations, k, lines),
                None => lines.clear(simd, k),
            }
        }
        let bricks = out.own.iter_mut().zip(out.stresses).zip(out.rotations);
        for (brick, ((own, stress), rotations)) in chunk.bricks.clone().zip(bricks) {
            let sums = rows.shift_deviations(layout.site_of[brick] as usize, lines);
            let state =
                BrickState { rest: rest.of(brick), matrix: &matrix_volumes[brick], deviations: &deviations[brick + 1] };
            (*own, *stress) = self.law.finish(simd, &state, sums, rotations);
        }
    }

    /// Pass 2: forces on the particles of a chunk of bricks, of which `own` holds their own part.
    #[inline(always)]
    pub(super) fn gather<S: Simd>(
        &self,
        simd: S,
        chunk: &Chunk,
        stresses: &[BrickStress],
        own: &mut [BrickVectors],
        lines: &mut LineBuffer,
    ) {
        let Precomputed { layout, weights, .. } = self.fixed;
        let rows = RowStencil::<S, M, N> { simd, weights };
        for (k, site) in layout.sites[chunk.sites.clone()].iter().enumerate() {
            match site {
                Some(site) => rows.combine_stresses(layout.neighbours(*site), stresses, k, lines),
                None => lines.clear(simd, k),
            }
        }
        for (brick, own) in chunk.bricks.clone().zip(own) {
            let sums = rows.shift_stresses(layout.site_of[brick] as usize, lines);
            *own = (Vec3x::load(simd, own) + sums).store();
        }
    }
}
