//! The particles that the fibres of a body ride on, side by side.
//!
//! Neighbouring vertices share most of their particles. So these are copied into a *strip* once for every evaluation,
//! fibre after fibre, in the order in which the vertices come to them: the particles around any vertex then stand next
//! to each other, and so do the vertices around any particle.

use crate::solver::wide::{Lanes8, Vec3x, Wide};
use fearless_simd::{Simd, f64x8, prelude::*};
use glam::DVec3;
use std::collections::HashMap;

/// Particles in a block.
pub(super) const WIDTH: usize = 8;

/// Vectors of the particles of a block, by components.
pub(super) type BlockVectors = [Lanes8; 3];

/// Which particles stand where.
#[derive(Clone, Debug, Default)]
pub(super) struct Strip {
    /// Particles of every block. Where those of a fibre end, its first one fills the last block, without any weight.
    particles: Vec<[u32; WIDTH]>,
}

/// Where one fibre's particles stand on the strip.
pub(super) struct StripIndex(HashMap<u32, usize>);

impl StripIndex {
    /// Block of a particle, and its place in there.
    pub(super) fn of(&self, particle: u32) -> (usize, usize) {
        let place = self.0[&particle];
        (place / WIDTH, place % WIDTH)
    }
}

impl Strip {
    /// Number of blocks.
    pub(super) fn len(&self) -> usize {
        self.particles.len()
    }

    /// Adds the particles of one fibre, each with every vertex that it is around.
    pub(super) fn add(&mut self, particles: impl Iterator<Item = (usize, u32)>) -> StripIndex {
        let mut met: HashMap<u32, [usize; 2]> = HashMap::new();
        for (vertex, particle) in particles {
            let [first, last] = met.entry(particle).or_insert([vertex; 2]);
            (*first, *last) = (vertex.min(*first), vertex.max(*last));
        }
        let mut order: Vec<u32> = met.keys().copied().collect();
        order.sort_unstable_by_key(|particle| (met[particle], *particle));
        let start = WIDTH * self.particles.len();
        for block in order.chunks(WIDTH) {
            let mut particles = [order[0]; WIDTH];
            particles[..block.len()].copy_from_slice(block);
            self.particles.push(particles);
        }
        StripIndex(order.iter().enumerate().map(|(k, &particle)| (particle, start + k)).collect())
    }

    /// Copies the positions [m] of the particles, taken against that of the first one: so they stay exact far from the
    /// origin.
    #[inline(always)]
    pub(super) fn fill<S: Simd>(&self, simd: S, positions: &[DVec3], blocks: &mut [BlockVectors]) {
        let Some(first) = self.particles.first() else { return };
        let origin = positions[first[0] as usize];
        for (particles, block) in self.particles.iter().zip(blocks) {
            let mut at = [DVec3::ZERO; WIDTH];
            for k in 0..WIDTH {
                at[k] = positions[particles[k] as usize];
            }
            let [a, b, c, d, e, f, g, h] = at;
            for axis in 0..3 {
                let lanes = [a[axis], b[axis], c[axis], d[axis], e[axis], f[axis], g[axis], h[axis]];
                block[axis] = (f64x8::load(simd, &Lanes8(lanes)) - f64x8::splat(simd, origin[axis])).store();
            }
        }
    }

    /// Adds the forces [N] on a block to those on its particles.
    #[inline(always)]
    pub(super) fn pass_on<S: Simd>(&self, block: usize, sums: Vec3x<f64x8<S>>, forces: &mut [DVec3]) {
        let [Lanes8(x), Lanes8(y), Lanes8(z)] = sums.store();
        let particles = &self.particles[block];
        for k in 0..WIDTH {
            forces[particles[k] as usize] += DVec3::new(x[k], y[k], z[k]);
        }
    }
}
