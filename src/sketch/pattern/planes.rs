//! Layouts in the middle plane of a flat box, across its thinnest axis, in the unit cube.

use super::layout::{Inner, Polyline, curve, line};
use std::f64::consts::{PI, TAU};

/// Spokes around the middle. Values: fibres, radius of the hub as a share, vertices.
pub(super) fn radial(values: &[f64], inner: &Inner) -> Vec<Polyline> {
    let &[rays, hub, vertices] = values else { return Vec::new() };
    (0..rays as usize)
        .map(|k| {
            let angle = TAU * k as f64 / rays;
            curve(vertices, |t| around(inner, angle, hub + (1.0 - hub) * t))
        })
        .collect()
}

/// Spirals out of the middle. Values: arms, turns, radius at the start as a share, vertices.
pub(super) fn spiral(values: &[f64], inner: &Inner) -> Vec<Polyline> {
    let &[arms, turns, hub, vertices] = values else { return Vec::new() };
    (0..arms as usize)
        .map(|k| {
            let start = TAU * k as f64 / arms;
            curve(vertices, |t| around(inner, start + TAU * turns * t, hub + (1.0 - hub) * t))
        })
        .collect()
}

fn around(inner: &Inner, angle: f64, radius: f64) -> glam::DVec3 {
    inner.place(0.5 + 0.5 * radius * angle.cos(), 0.5 + 0.5 * radius * angle.sin(), 0.5)
}

/// Shares of the length at which the first side vein leaves the midrib and within which all of them do.
const FIRST: f64 = 0.08;
const WITHIN: f64 = 0.72;

/// Side veins have this share of the midrib's vertices.
const SIDE: f64 = 0.5;

/// A midrib along the longest axis and pairs of veins that leave it. Values: pairs, share of the half width, angle to
/// the midrib [degrees], vertices of the midrib.
pub(super) fn vein(values: &[f64], inner: &Inner) -> Vec<Polyline> {
    let &[pairs, reach, angle, vertices] = values else { return Vec::new() };
    let midrib = line(vertices, inner.place(0.0, 0.5, 0.5), inner.place(1.0, 0.5, 0.5));
    let [length, width] = [inner.size[inner.order[0]], inner.size[inner.order[1]]];
    let forward = 1.0 / angle.to_radians().tan();
    let of_side = (SIDE * vertices).round().max(3.0);
    let mut fibres = vec![midrib];
    for pair in 0..pairs as usize {
        let root = FIRST + WITHIN * pair as f64 / pairs;
        // Longest in the middle of the blade; one that would run past the tip is shortened, its angle kept.
        let aside = 0.5 * reach * (PI * (root + 0.12)).sin();
        let along = aside * width * forward / length;
        let part = ((1.0 - root) / along).min(1.0);
        for side in [-1.0, 1.0] {
            let end = inner.place(root + part * along, 0.5 + side * part * aside, 0.5);
            fibres.push(line(of_side, inner.place(root, 0.5, 0.5), end));
        }
    }
    fibres
}
