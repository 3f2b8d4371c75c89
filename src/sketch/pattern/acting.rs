//! What the fibres of a layout do by themselves, and layouts that are there for it, in the unit cube.

use super::curves::{helix_left, helix_right};
use super::layout::{Inner, Polyline, curve, line, side_by_side};
use glam::DVec3;
use serde::{Deserialize, Serialize};
use std::f64::consts::TAU;

/// What a fibre does by itself: it is shorter and as it was laid, over and over.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Act {
    /// Word for what acts with it: fibres of one word follow one drive.
    pub muscle: String,
    /// Share by which it wants to be shorter at most; longer where it is below zero.
    pub contract: f64,
    /// Time of one swing [s].
    pub period: f64,
    /// How late in its swing it is [degrees].
    #[serde(default)]
    pub phase_degrees: f64,
    /// Waves that run along it at a time, from its first vertex on; where there are none, all of it swings at once.
    #[serde(default)]
    pub waves: f64,
}

impl Act {
    /// All of a fibre at once, from the values of a pattern: contraction and period come first.
    fn new(muscle: &str, values: &[f64], phase_degrees: f64) -> Self {
        let &[contract, period, ..] = values else { return Self::new(muscle, &[0.0, 1.0], phase_degrees) };
        Self { muscle: muscle.to_owned(), contract, period, phase_degrees, waves: 0.0 }
    }

    /// Running along the fibre: the third value tells how many waves.
    fn running(muscle: &str, values: &[f64], phase_degrees: f64) -> Self {
        Self { waves: values.get(2).copied().unwrap_or(0.0), ..Self::new(muscle, values, phase_degrees) }
    }
}

/// Shares by which a fibre may want to be shorter: beyond them its edges turn over or it buckles at once.
pub const CONTRACTION: [f64; 2] = [-0.5, 0.8];

/// Half a swing.
const OPPOSITE: f64 = 180.0;
/// A third of one.
const THIRD: f64 = 120.0;

/// The longer of the two level axes, and the other.
fn level(inner: &Inner) -> [usize; 2] {
    if inner.size.z > inner.size.x { [2, 0] } else { [0, 2] }
}

/// Four fibres along the longer level axis, the first two at its foot, the others above. Values: contraction, period,
/// waves, vertices.
pub(super) fn worm(values: &[f64], inner: &Inner) -> Vec<Polyline> {
    let &[.., vertices] = values else { return Vec::new() };
    let [along, aside] = level(inner);
    pairs(vertices, along, 1, aside)
}

pub(super) fn acts_of_worm(values: &[f64], fibre: usize) -> Act {
    if fibre < 2 { Act::running("below", values, 0.0) } else { Act::running("above", values, OPPOSITE) }
}

/// Four fibres along the longer level axis from its far end, the first two on one side, the others on the other. Values
/// as of a worm.
pub(super) fn tail(values: &[f64], inner: &Inner) -> Vec<Polyline> {
    let &[.., vertices] = values else { return Vec::new() };
    let [along, aside] = level(inner);
    let mut fibres = pairs(vertices, along, aside, 1);
    for fibre in &mut fibres {
        fibre.reverse();
    }
    fibres
}

pub(super) fn acts_of_tail(values: &[f64], fibre: usize) -> Act {
    if fibre < 2 { Act::running("left", values, 0.0) } else { Act::running("right", values, OPPOSITE) }
}

/// The four edges along an axis: first those at the low end of `split`, each pair from one end of `paired` to the
/// other.
fn pairs(vertices: f64, along: usize, split: usize, paired: usize) -> Vec<Polyline> {
    let mut fibres = Vec::new();
    for of_split in [0.0, 1.0] {
        for of_pair in [0.0, 1.0] {
            let mut from = DVec3::ZERO;
            from[split] = of_split;
            from[paired] = of_pair;
            let mut to = from;
            to[along] = 1.0;
            fibres.push(line(vertices, from, to));
        }
    }
    fibres
}

/// Fibres along the longest axis on one face. Values: contraction, period, fibres, vertices.
pub(super) fn finger(values: &[f64], inner: &Inner) -> Vec<Polyline> {
    let &[_, _, fibres, vertices] = values else { return Vec::new() };
    side_by_side(fibres).map(|z| line(vertices, inner.place(0.0, 1.0, z), inner.place(1.0, 1.0, z))).collect()
}

pub(super) fn acts_of_finger(values: &[f64], _fibre: usize) -> Act {
    Act::new("curl", values, 0.0)
}

/// Level rings, one above the other. Values: contraction, period, rings, vertices of each.
pub(super) fn rings(values: &[f64], _inner: &Inner) -> Vec<Polyline> {
    let &[_, _, rings, vertices] = values else { return Vec::new() };
    (0..rings as usize)
        .map(|k| {
            let height = (k as f64 + 0.5) / rings;
            let mut ring = curve(vertices, |t| {
                let angle = TAU * t;
                DVec3::new(0.5 + 0.5 * angle.cos(), height, 0.5 + 0.5 * angle.sin())
            });
            // It ends where it began, to the last bit.
            if let [first, .., last] = ring.as_mut_slice() {
                *last = *first;
            }
            ring
        })
        .collect()
}

pub(super) fn acts_of_rings(values: &[f64], _fibre: usize) -> Act {
    Act::new("beat", values, 0.0)
}

/// Rays from the middle at the lower face of something flat. Values: contraction, period, arms, hub as a share,
/// vertices.
pub(super) fn starfish(values: &[f64], inner: &Inner) -> Vec<Polyline> {
    let &[_, _, arms, hub, vertices] = values else { return Vec::new() };
    (0..arms as usize)
        .map(|k| {
            let angle = TAU * k as f64 / arms;
            curve(vertices, |t| {
                let radius = hub + (1.0 - hub) * t;
                inner.place(0.5 + 0.5 * radius * angle.cos(), 0.5 + 0.5 * radius * angle.sin(), 0.0)
            })
        })
        .collect()
}

pub(super) fn acts_of_starfish(values: &[f64], fibre: usize) -> Act {
    let arms = values.get(2).copied().unwrap_or(1.0);
    Act::new(&format!("arm-{}", fibre + 1), values, 2.0 * OPPOSITE * fibre as f64 / arms)
}

/// Helices in each of these numbers that wind by one hand, of those that do both.
const WOUND: usize = 4;

/// Helices of both hands. Values: contraction, period, turns, vertices.
pub(super) fn trunk(values: &[f64], inner: &Inner) -> Vec<Polyline> {
    let &[_, _, turns, vertices] = values else { return Vec::new() };
    let wound = [WOUND as f64, turns, 1.0, vertices];
    let mut fibres = helix_right(&wound, inner);
    fibres.extend(helix_left(&wound, inner));
    fibres
}

pub(super) fn acts_of_trunk(values: &[f64], fibre: usize) -> Act {
    if fibre < WOUND { Act::new("right", values, 0.0) } else { Act::new("left", values, OPPOSITE) }
}

/// As of a trunk, and two upright fibres on one side.
pub(super) fn tentacle(values: &[f64], inner: &Inner) -> Vec<Polyline> {
    let &[.., vertices] = values else { return Vec::new() };
    let mut fibres = trunk(values, inner);
    fibres.extend([0.0, 1.0].map(|z| line(vertices, DVec3::new(1.0, 0.0, z), DVec3::new(1.0, 1.0, z))));
    fibres
}

pub(super) fn acts_of_tentacle(values: &[f64], fibre: usize) -> Act {
    match fibre / WOUND {
        0 => Act::new("right", values, 0.0),
        1 => Act::new("left", values, THIRD),
        _ => Act::new("along", values, 2.0 * THIRD),
    }
}

/// Spokes from the middle along the axes and the diagonals of space. Values: contraction, period, vertices.
pub(super) fn spokes(values: &[f64], _inner: &Inner) -> Vec<Polyline> {
    /// Where they begin, as a share of the way out.
    const HUB: f64 = 0.2;
    let &[_, _, vertices] = values else { return Vec::new() };
    let middle = DVec3::splat(0.5);
    let axes = [DVec3::X, DVec3::Y, DVec3::Z];
    let corners = (0..4_u8).map(|k| {
        let sign = |bit: u8| if k & bit == 0 { 1.0 } else { -1.0 };
        DVec3::new(sign(1), sign(2), 1.0).normalize_or_zero()
    });
    let ways = axes.into_iter().chain(corners).flat_map(|way| [way, -way]);
    ways.map(|way| line(vertices, middle + 0.5 * HUB * way, middle + 0.5 * way)).collect()
}

pub(super) fn acts_of_spokes(values: &[f64], _fibre: usize) -> Act {
    Act::new("breath", values, 0.0)
}
