//! Layouts of curved fibres that run upwards, in the unit cube.

use super::layout::{Inner, Polyline, curve, side_by_side};
use glam::DVec3;
use std::f64::consts::{PI, TAU};

/// Left-handed helices about the upright axis. Values: fibres, turns, share of the half width, vertices.
pub(super) fn helix_left(values: &[f64], _inner: &Inner) -> Vec<Polyline> {
    helices(values, -1.0)
}

/// Right-handed helices about the upright axis. Values: fibres, turns, share of the half width, vertices.
pub(super) fn helix_right(values: &[f64], _inner: &Inner) -> Vec<Polyline> {
    helices(values, 1.0)
}

fn helices(values: &[f64], hand: f64) -> Vec<Polyline> {
    let &[fibres, turns, radius, vertices] = values else { return Vec::new() };
    (0..fibres as usize)
        .map(|k| {
            let start = TAU * k as f64 / fibres;
            curve(vertices, |y| {
                // A right-handed turn about Y leads from x to -z. The left hand is the mirror image in z.
                let angle = start + TAU * turns * y;
                DVec3::new(0.5 + 0.5 * radius * angle.cos(), y, 0.5 - 0.5 * hand * radius * angle.sin())
            })
        })
        .collect()
}

/// Bows one behind the other, each in an upright plane. Values: fibres, bulge towards -x as a share of the width,
/// vertices.
pub(super) fn c_shape(values: &[f64], _inner: &Inner) -> Vec<Polyline> {
    let &[fibres, bulge, vertices] = values else { return Vec::new() };
    rows(fibres, vertices, |y| 0.5 - bulge * ((PI * y).sin() - 0.5))
}

/// Waves of one period one behind the other, each in an upright plane. Values: fibres, swing of the lower half towards
/// +x as a share of the half width, vertices.
pub(super) fn s_shape(values: &[f64], _inner: &Inner) -> Vec<Polyline> {
    let &[fibres, swing, vertices] = values else { return Vec::new() };
    rows(fibres, vertices, |y| 0.5 + 0.5 * swing * (TAU * y).sin())
}

fn rows(fibres: f64, vertices: f64, x: impl Fn(f64) -> f64) -> Vec<Polyline> {
    side_by_side(fibres).map(|z| curve(vertices, |y| DVec3::new(x(y), y, z))).collect()
}
