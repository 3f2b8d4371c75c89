//! Weighted sums over the particles around many points, and forces on those points passed back by the same weights.
//!
//! The particles around a point lie in rows of the lattice, and a row's particles stand one after another in memory. Four
//! particles in a row, a *window*, are twelve numbers x, y, z, x, y, ... in three lanes of four; with its four weights
//! spread over the three numbers of each particle a window is three multiplications, no index but its first particle,
//! and no padding. A particle of a window that is not among those of the point has the weight zero.

use crate::solver::forces::matrix::lanes::Lanes;
use fearless_simd::{Simd, f64x4, prelude::*};
use glam::DVec3;

/// Particles in a window.
const WIDTH: usize = 4;
/// Lanes in a window.
const PARTS: usize = 3;

/// Weights of N kinds of many points over the particles.
#[derive(Clone, Debug)]
pub(super) struct Windows<const N: usize> {
    /// Windows before those of each point, and all at last.
    starts: Vec<u32>,
    /// First particle of each window.
    firsts: Vec<u32>,
    weights: Vec<[Lanes; N]>,
}

impl<const N: usize> Windows<N> {
    /// Windows of points, each with its particles and their weights.
    pub(super) fn new(points: impl Iterator<Item = Vec<(u32, [f64; N])>>) -> Self {
        let mut this = Self { starts: vec![0], firsts: Vec::new(), weights: Vec::new() };
        for mut particles in points {
            particles.sort_by_key(|&(particle, _)| particle);
            let begun = this.firsts.len();
            for (particle, weights) in particles {
                let open = this.firsts[begun..].last().is_some_and(|&first| particle < first + WIDTH as u32);
                if !open {
                    this.firsts.push(particle);
                    this.weights.push([Lanes::default(); N]);
                }
                if let (Some(&first), Some(window)) = (this.firsts.last(), this.weights.last_mut()) {
                    for (lanes, weight) in window.iter_mut().zip(weights) {
                        lanes.0[(particle - first) as usize] += weight;
                    }
                }
            }
            this.starts.push(this.firsts.len() as u32);
        }
        this
    }

    #[inline(always)]
    fn of(&self, point: usize) -> impl Iterator<Item = (usize, &[Lanes; N])> {
        let range = self.starts[point] as usize..self.starts[point + 1] as usize;
        let firsts = self.firsts[range.clone()].iter().map(|&first| PARTS * first as usize);
        firsts.zip(&self.weights[range])
    }

    /// Position of a particle near a point [m].
    pub(super) fn origin(&self, point: usize, field: &[f64]) -> DVec3 {
        self.of(point).next().map_or(DVec3::ZERO, |(first, _)| DVec3::from_slice(&field[first..]))
    }

    /// `sum w x` over the particles around a point, for every kind of weight, or `sum w (x - origin)`; `field` holds x, y, z
    /// of all.
    #[inline(always)]
    pub(super) fn gather<S: Simd>(&self, simd: S, point: usize, field: &[f64], origin: Option<DVec3>) -> [DVec3; N] {
        let origin = origin.map(|origin| patterns(simd, origin));
        let mut sums = [[f64x4::splat(simd, 0.0); PARTS]; N];
        for (first, weights) in self.of(point) {
            let window = match field[first..].first_chunk() {
                Some(window) => lanes(simd, window),
                None => lanes(simd, &padded(&field[first..])),
            };
            for kind in 0..N {
                let weights = spread_out(simd, &weights[kind]);
                for part in 0..PARTS {
                    let x = if let Some(origin) = origin { window[part] - origin[part] } else { window[part] };
                    sums[kind][part] = x.mul_add(weights[part], sums[kind][part]);
                }
            }
        }
        let mut gathered = [DVec3::ZERO; N];
        for kind in 0..N {
            let [a, b, c]: [[f64; WIDTH]; PARTS] = [sums[kind][0].into(), sums[kind][1].into(), sums[kind][2].into()];
            gathered[kind] =
                DVec3::new((a[0] + a[3]) + (b[2] + c[1]), (a[1] + b[0]) + (b[3] + c[2]), (a[2] + b[1]) + (c[0] + c[3]));
        }
        gathered
    }

    /// Adds `sum over kinds of w value` to each particle around a point.
    #[inline(always)]
    pub(super) fn scatter<S: Simd>(&self, simd: S, point: usize, values: [DVec3; N], field: &mut [f64]) {
        let mut spread = [[f64x4::splat(simd, 0.0); PARTS]; N];
        for kind in 0..N {
            spread[kind] = patterns(simd, values[kind]);
        }
        for (first, weights) in self.of(point) {
            let rest = &mut field[first..];
            if let Some(window) = rest.first_chunk_mut() {
                add(simd, &spread, weights, window);
            } else {
                let mut window = padded(rest);
                add(simd, &spread, weights, &mut window);
                rest.copy_from_slice(&window[..rest.len()]);
            }
        }
    }
}

/// The numbers of a window.
#[inline(always)]
fn lanes<S: Simd>(simd: S, window: &[f64; WIDTH * PARTS]) -> [f64x4<S>; PARTS] {
    [
        f64x4::from_slice(simd, &window[..WIDTH]),
        f64x4::from_slice(simd, &window[WIDTH..2 * WIDTH]),
        f64x4::from_slice(simd, &window[2 * WIDTH..]),
    ]
}

/// Adds what one window gets.
#[inline(always)]
fn add<S: Simd, const N: usize>(
    simd: S,
    spread: &[[f64x4<S>; PARTS]; N],
    weights: &[Lanes; N],
    window: &mut [f64; WIDTH * PARTS],
) {
    let mut sums = lanes(simd, window);
    for kind in 0..N {
        let weights = spread_out(simd, &weights[kind]);
        for part in 0..PARTS {
            sums[part] = spread[kind][part].mul_add(weights[part], sums[part]);
        }
    }
    for part in 0..PARTS {
        sums[part].store_slice(&mut window[WIDTH * part..WIDTH * (part + 1)]);
    }
}

/// Four weights, each for the three numbers of its particle.
#[inline(always)]
fn spread_out<S: Simd>(simd: S, Lanes([a, b, c, d]): &Lanes) -> [f64x4<S>; PARTS] {
    [
        f64x4::simd_from(simd, [*a, *a, *a, *b]),
        f64x4::simd_from(simd, [*b, *b, *c, *c]),
        f64x4::simd_from(simd, [*c, *d, *d, *d]),
    ]
}

/// A vector for each particle of a window.
#[inline(always)]
fn patterns<S: Simd>(simd: S, v: DVec3) -> [f64x4<S>; PARTS] {
    [
        f64x4::simd_from(simd, [v.x, v.y, v.z, v.x]),
        f64x4::simd_from(simd, [v.y, v.z, v.x, v.y]),
        f64x4::simd_from(simd, [v.z, v.x, v.y, v.z]),
    ]
}

/// The window of the last particles, which may be fewer than four.
#[cold]
fn padded(rest: &[f64]) -> [f64; WIDTH * PARTS] {
    let mut window = [0.0; WIDTH * PARTS];
    window[..rest.len()].copy_from_slice(rest);
    window
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solver::embedding::Stencil;
    use fearless_simd::{Level, dispatch};

    /// Points over eleven particles: in a row, with gaps, at the end, out of order.
    fn stencils() -> Vec<Stencil> {
        let picks: [&[u32]; 5] = [&[0, 1, 2, 3, 4, 5], &[10], &[7, 2, 9], &[8, 9, 10], &[]];
        let weights = |picks: &&[u32]| picks.iter().map(|&k| (k, 0.3 + 0.1 * f64::from(k))).collect();
        picks.iter().map(|picks| Stencil { weights: weights(picks) }).collect()
    }

    #[test]
    fn sums_and_forces_are_those_of_the_stencils_one_by_one() {
        let stencils = stencils();
        let windows =
            Windows::new(stencils.iter().map(|s| s.weights.iter().map(|&(k, w)| (k, [w, -2.0 * w])).collect()));
        let field: Vec<DVec3> = (0..11).map(|k| DVec3::new(f64::from(k), 0.5 * f64::from(k * k), -3.0)).collect();
        for (point, stencil) in stencils.iter().enumerate() {
            let origin = DVec3::new(0.5, -1.0, 2.0);
            let flat: &[f64] = bytemuck::cast_slice(&field);
            let [sum, other] =
                dispatch!(Level::new(), simd => Windows::gather(&windows, simd, point, flat, Some(origin)));
            let total: f64 = stencil.weights.iter().map(|(_, w)| w).sum();
            let expected = stencil.gather(&field) - total * origin;
            assert!(sum.distance(expected) < 1e-12, "{point}: {sum}, not {expected}");
            assert!(other.distance(-2.0 * expected) < 1e-12);

            let (mut forces, mut one_by_one) = (field.clone(), field.clone());
            let (force, second) = (DVec3::new(1.0, 2.0, -4.0), DVec3::new(0.0, 0.5, 1.0));
            let flat: &mut [f64] = bytemuck::cast_slice_mut(&mut forces);
            dispatch!(Level::new(), simd => Windows::scatter(&windows, simd, point, [force, second], flat));
            stencil.scatter(force - 2.0 * second, &mut one_by_one);
            for (force, expected) in forces.iter().zip(&one_by_one) {
                assert!(force.distance(*expected) < 1e-12, "{point}: {force}, not {expected}");
            }
        }
    }
}
