//! Layouts of straight fibres, in the unit cube.

use super::layout::{Inner, Polyline, line, side_by_side};
use glam::DVec3;
use std::f64::consts::TAU;

/// Upright fibres in rows. Values: fibres along x, fibres along z, vertices.
pub(super) fn vertical(values: &[f64], inner: &Inner) -> Vec<Polyline> {
    let &[along_x, along_z, vertices] = values else { return Vec::new() };
    slanted(&[along_x, along_z, 0.0, vertices], inner)
}

/// Fibres in rows whose upper ends stand aside along x. Values: fibres along x, fibres along z, lean as a share of the
/// width, vertices.
pub(super) fn slanted(values: &[f64], _inner: &Inner) -> Vec<Polyline> {
    let &[along_x, along_z, lean, vertices] = values else { return Vec::new() };
    // A lean to the left begins as far to the right as it needs to.
    let (from, room) = ((-lean).max(0.0), 1.0 - lean.abs());
    let row = side_by_side(along_x);
    side_by_side(along_z)
        .flat_map(|z| row.clone().map(move |share| (from + room * share, z)))
        .map(|(x, z)| line(vertices, DVec3::new(x, 0.0, z), DVec3::new(x + lean, 1.0, z)))
        .collect()
}

/// Two diagonals in each of some planes one behind the other. Values: planes, share of the width, vertices.
pub(super) fn cross(values: &[f64], _inner: &Inner) -> Vec<Polyline> {
    let &[planes, reach, vertices] = values else { return Vec::new() };
    let (left, right) = (0.5 - 0.5 * reach, 0.5 + 0.5 * reach);
    side_by_side(planes)
        .flat_map(|z| [(left, right), (right, left)].map(|(from, to)| (from, to, z)))
        .map(|(from, to, z)| line(vertices, DVec3::new(from, 0.0, z), DVec3::new(to, 1.0, z)))
        .collect()
}

/// The twelve edges of the box. Values: vertices of each.
pub(super) fn frame(values: &[f64], _inner: &Inner) -> Vec<Polyline> {
    let &[vertices] = values else { return Vec::new() };
    let corners = [(0.0, 0.0), (0.0, 1.0), (1.0, 0.0), (1.0, 1.0)];
    (0..3)
        .flat_map(|axis| corners.map(|(a, b)| (axis, a, b)))
        .map(|(axis, a, b)| {
            let mut from = DVec3::ZERO;
            from[(axis + 1) % 3] = a;
            from[(axis + 2) % 3] = b;
            let mut to = from;
            to[axis] = 1.0;
            line(vertices, from, to)
        })
        .collect()
}

/// Short straight fibres anywhere, in any direction. Values: fibres, length as a share of the least extent, seed,
/// vertices.
pub(super) fn short_fibres(values: &[f64], inner: &Inner) -> Vec<Polyline> {
    let &[fibres, length, seed, vertices] = values else { return Vec::new() };
    let mut random = SplitMix64(seed as u64);
    (0..fibres as usize)
        .map(|_| {
            // Uniform on the sphere: the height of a point on it is uniform (Archimedes).
            let (height, turn) = (2.0 * random.share() - 1.0, TAU * random.share());
            let around = (1.0 - height * height).sqrt();
            let direction = DVec3::new(around * turn.cos(), height, around * turn.sin());
            let half = 0.5 * length * inner.size.min_element() * direction / inner.size;
            // Both ends inside, whatever the direction.
            let reach = half.abs();
            let middle = DVec3::new(random.share(), random.share(), random.share());
            let middle = reach + middle * (1.0 - 2.0 * reach);
            line(vertices, middle - half, middle + half)
        })
        .collect()
}

/// A small generator of numbers: the same from the same seed everywhere.
struct SplitMix64(u64);

impl SplitMix64 {
    /// A number of [0, 1).
    fn share(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut mixed = self.0;
        mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^= mixed >> 31;
        (mixed >> 11) as f64 / (1_u64 << 53) as f64
    }
}
