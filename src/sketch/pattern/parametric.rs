//! A layout of fibres with parameters, and its fitting to a box.

use super::acting::Act;
use super::layout::{Inner, Polyline};
use glam::DVec3;

/// Number that a pattern is given.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameter {
    /// Stable identifier, unique within the pattern.
    pub id: &'static str,
    /// Name a person reads.
    pub title: &'static str,
    /// What it changes, for a person.
    pub tip: &'static str,
    /// Unit a person reads; empty for counts and shares.
    pub unit: &'static str,
    /// What it is unless it is changed.
    pub default: f64,
    /// Least and greatest value.
    pub range: [f64; 2],
    /// Whether it is rounded to a whole number.
    pub whole: bool,
}

impl Parameter {
    /// The value nearest to `value` that is allowed; the default for what is no number.
    pub fn held(&self, value: f64) -> f64 {
        if !value.is_finite() {
            return self.default;
        }
        let [least, greatest] = self.range;
        let held = value.clamp(least, greatest);
        if self.whole { held.round() } else { held }
    }
}

/// A layout of fibres with parameters.
#[derive(Clone, Copy, Debug)]
pub struct Pattern {
    /// Stable identifier, unique among the patterns.
    pub id: &'static str,
    /// Name a person reads.
    pub title: &'static str,
    /// What the fibres do to a solid, in a line.
    pub does: &'static str,
    /// What it is given; the last one is the margin as a share of the box's least extent.
    pub parameters: &'static [Parameter],
    /// Bending stiffness of its fibres over their axial rigidity, in particle spacings squared: fibres in the middle
    /// plane of something flat carry it by bending alone.
    pub bending: f64,
    /// Polylines in the unit cube, from the values before the margin.
    pub(super) layout: fn(&[f64], &Inner) -> Vec<Polyline>,
    /// What a fibre does by itself, from the values before the margin and its place in the layout; nothing unless
    /// given.
    pub(super) acting: Option<fn(&[f64], usize) -> Act>,
}

impl Pattern {
    /// Value of every parameter unless it is changed.
    pub fn defaults(&self) -> Vec<f64> {
        self.parameters.iter().map(|parameter| parameter.default).collect()
    }

    /// The fibres' vertices [m] in the box from `min` to `max` [m], model frame, by the values of the parameters in
    /// their order. Values are held within their ranges, those that are left out are defaults. A box without volume has
    /// none.
    pub fn lay(&self, values: &[f64], min: DVec3, max: DVec3) -> Vec<Polyline> {
        let held = self.held(values);
        let Some((&margin, values)) = held.split_last() else { return Vec::new() };
        let extents = max - min;
        if !(extents.is_finite() && extents.min_element() > 0.0) {
            return Vec::new();
        }
        let margin = margin * extents.min_element();
        let (low, high) = (min + margin, max - margin);
        let inner = Inner::new(high - low);
        let mut fibres = (self.layout)(values, &inner);
        for vertex in fibres.iter_mut().flatten() {
            // Twice held: first against layouts that overshoot, then against the last bit of the sum.
            *vertex = (low + vertex.clamp(DVec3::ZERO, DVec3::ONE) * inner.size).clamp(low, high);
        }
        fibres
    }

    /// Whether its fibres do something by themselves.
    pub fn is_acting(&self) -> bool {
        self.acting.is_some()
    }

    /// What each of so many fibres does by itself, by the values of the parameters as [`Pattern::lay`] takes them;
    /// empty where they only resist.
    pub fn acts(&self, values: &[f64], fibres: usize) -> Vec<Option<Act>> {
        let held = self.held(values);
        let Some((act, (_, values))) = self.acting.zip(held.split_last()) else { return Vec::new() };
        (0..fibres).map(|fibre| Some(act(values, fibre))).collect()
    }

    /// A value of every parameter, within its range.
    pub(super) fn held(&self, values: &[f64]) -> Vec<f64> {
        let given = |k: usize, parameter: &Parameter| values.get(k).copied().unwrap_or(parameter.default);
        self.parameters.iter().enumerate().map(|(k, parameter)| parameter.held(given(k, parameter))).collect()
    }
}
