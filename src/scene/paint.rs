//! Volume fraction painted by hand: dabs of a brush over what the fibres give.
//!
//! How it works. A dab pulls the fraction towards a value, by its strength within half its radius and smoothly less
//! from there to the rim; dabs act one after the other, as paint does. They lie in space and not on particles, so
//! that a body can be filled more finely and keeps what was painted.
//!
//! A fibre's own energy keeps its own volume fraction: paint is about the matrix around it.

use super::Extra;
use glam::DVec3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Most dabs on a body; each takes time at every particle.
pub const MAX_DABS: usize = 10_000;

/// Share of a dab's radius within which it has its whole strength.
const CORE: f64 = 0.5;

/// One dab of a brush that paints the volume fraction of fibre.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Dab {
    /// Centre in the model frame [m].
    pub center: [f64; 3],
    /// Radius beyond which it does nothing [m].
    pub radius: f64,
    /// Volume fraction that is painted, 0 to 1: 1 leaves no matrix there, 0 all of it whatever fibres run through.
    pub value: f64,
    /// How much of the way to that value it goes within half its radius, 0 to 1.
    #[serde(default = "whole_strength")]
    pub strength: f64,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

impl Dab {
    /// Paints a volume fraction of fibre, 0 to 1, around a point of the model frame out to a radius [m], with all its
    /// strength.
    pub fn new(center: impl Into<[f64; 3]>, radius: f64, value: f64) -> Self {
        Self { center: center.into(), radius, value, strength: whole_strength(), extra: Extra::new() }
    }

    /// How much of the way to its value it goes at a point of the model frame [m].
    pub fn weight(&self, at: DVec3) -> f64 {
        let distance = at.distance(DVec3::from_array(self.center));
        let t = ((1.0 - distance / self.radius) / (1.0 - CORE)).clamp(0.0, 1.0);
        self.strength * t * t * (3.0 - 2.0 * t)
    }

    /// Whether nothing is left of an earlier dab under this one.
    fn covers(&self, earlier: &Self) -> bool {
        // A little within the core: its rim is subject to round-off.
        let core = 0.999 * CORE * self.radius;
        let apart = DVec3::from_array(self.center).distance(DVec3::from_array(earlier.center));
        self.strength == 1.0 && apart + earlier.radius <= core
    }
}

/// Volume fraction at a point of the model frame [m] where fibres alone would give `fraction`.
pub fn painted(fraction: f64, at: DVec3, paint: &[Dab]) -> f64 {
    // Not `fraction + weight * (value - fraction)`: a weight of one is to give the value to the bit.
    paint.iter().fold(fraction, |fraction, dab| match dab.weight(at) {
        0.0 => fraction,
        weight => (1.0 - weight) * fraction + weight * dab.value,
    })
}

/// Paints one dab more. What nothing is left of is dropped, so that brushing over one place again and again stays
/// short.
pub fn add_dab(paint: &mut Vec<Dab>, dab: Dab) {
    paint.retain(|earlier| !dab.covers(earlier));
    paint.push(dab);
}

fn whole_strength() -> f64 {
    1.0
}

#[cfg(test)]
mod tests {
    use super::*;

    fn dab(x: f64, radius: f64, value: f64, strength: f64) -> Dab {
        Dab { strength, ..Dab::new([x, 0.0, 0.0], radius, value) }
    }

    #[test]
    fn a_dab_is_whole_in_its_core_and_fades_to_its_rim() {
        let dab = dab(0.0, 2.0, 0.7, 0.5);
        let weights = [0.0, 0.99, 1.5, 2.0, 9.0].map(|y| dab.weight(DVec3::Y * y));
        assert_eq!(weights, [0.5, 0.5, 0.25, 0.0, 0.0]);
        let at = |y: f64| painted(0.1, DVec3::Y * y, std::slice::from_ref(&dab));
        assert!((at(0.0) - 0.4).abs() < 1e-15 && (at(1.5) - 0.25).abs() < 1e-15);
        assert_eq!(at(2.0).to_bits(), 0.1_f64.to_bits());
    }

    #[test]
    fn dropping_what_is_covered_changes_no_bit() {
        let dabs = [
            dab(0.0, 0.3, 0.9, 0.4),
            dab(0.1, 0.2, 0.3, 1.0),
            dab(0.9, 0.5, 0.8, 0.7),
            dab(0.0, 1.0, 0.35, 1.0),
            dab(0.05, 0.4, 0.6, 0.9),
        ];
        let mut short = Vec::new();
        dabs.iter().cloned().for_each(|dab| add_dab(&mut short, dab));
        assert_eq!(short, dabs[2..], "the first two lie within the core of the fourth");
        for k in 0..200 {
            let at = DVec3::new(0.01 * f64::from(k) - 0.5, 0.1, 0.0);
            assert_eq!(painted(0.2, at, &short).to_bits(), painted(0.2, at, &dabs).to_bits());
        }
    }
}
