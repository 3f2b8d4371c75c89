//! An element without code: what it measures, and a law.

use super::contract::{Change, Element, Local, Slopes};
use super::law::{Excited, Law};
use super::measure::Measure;
use std::f64::consts::TAU;

/// A measure times a law.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct MeasuredElement {
    points: Vec<u32>,
    measure: Measure,
    law: Law,
    /// The measure at rest.
    rest: f64,
    /// By what x grows where the drive is 1.
    contract: f64,
    /// Least and greatest value of the drive.
    driven: [f64; 2],
    /// The drive now.
    value: f64,
    /// Last value of an angle that may go round: the next is the one nearest to it.
    last: f64,
}

impl MeasuredElement {
    /// Of the structure's first points, which measure `rest` at rest; it wants to be smaller by the share (or angle)
    /// `contract` where its drive, whose values lie between `driven`, is 1.
    pub(crate) fn new((measure, rest): (Measure, f64), law: Law, contract: f64, driven: [f64; 2]) -> Self {
        let points = (0..measure.points() as u32).collect();
        Self { points, measure, law, rest, contract, driven, value: 1.0, last: rest }
    }

    /// Goes on from where the same one stood before an edit: as often round.
    pub(super) fn adopt(&mut self, before: &Self) {
        if self.measure == before.measure && self.rest == before.rest {
            self.last = before.last;
        }
    }

    /// m0 of sizes, which is above zero though a volume may be measured the other way round; 1 of angles.
    fn unit(&self) -> f64 {
        if self.measure.is_angle() { 1.0 } else { self.rest.abs() }
    }

    fn law(&self) -> Excited<'_> {
        let rest = if self.measure.is_angle() { 0.0 } else { 1.0 };
        Excited { law: &self.law, rest, by: self.value }
    }

    fn measured(&self, at: &Local<'_>) -> f64 {
        let value = self.measure.value(at);
        if self.goes_round() { value + TAU * ((self.last - value) / TAU).round() } else { value }
    }

    /// Whether its angle goes on past half a turn.
    fn goes_round(&self) -> bool {
        matches!(self.measure, Measure::Dihedral | Measure::Twist(_))
    }

    /// x of a value of the measure.
    fn place(&self, measured: f64) -> f64 {
        let contracted = self.contract * self.value;
        if self.measure.is_angle() { measured - self.rest + contracted } else { measured / self.rest + contracted }
    }

    /// Least and greatest share by which the drive has it want to be smaller.
    fn contracted(&self) -> [f64; 2] {
        let [a, b] = self.driven.map(|value| self.contract * value);
        [a.min(b), a.max(b)]
    }
}

impl Element for MeasuredElement {
    fn points(&self) -> &[u32] {
        &self.points
    }

    fn turns(&self) -> &[u32] {
        if matches!(self.measure, Measure::Twist(_)) { &self.points } else { &[] }
    }

    fn energy(&self, at: &Local<'_>) -> f64 {
        self.unit() * self.law().energy(self.place(self.measured(at)))
    }

    fn slopes(&self, at: &Local<'_>, out: &mut Slopes<'_>) {
        // Of a size, `|m0| psi' / m0`.
        let sign = if self.measure.is_angle() { 1.0 } else { self.rest.signum() };
        let by_measure = sign * self.law().slope(self.place(self.measured(at)));
        if by_measure == 0.0 {
            return;
        }
        let Slopes { points, turns } = out;
        self.measure.slopes(at, &mut |k, slope| points[k] += by_measure * slope, &mut |k, slope| {
            turns[k] += by_measure * slope;
        });
    }

    /// Of a length `2 max(psi'', psi' / s) / m0`: along the line and across it, of both its points; the others grow
    /// with what they measure, or as it vanishes.
    fn majorant(&self) -> f64 {
        if self.measure != Measure::Length {
            return f64::INFINITY;
        }
        2.0 * self.law.steepest().max(self.law.greatest_over_size(self.contracted())) / self.rest
    }

    fn activate(&mut self, value: f64) {
        self.value = value;
    }

    fn end_step(&mut self, at: &Local<'_>) -> Change {
        if self.goes_round() {
            self.last = self.measured(at);
        }
        Change::None
    }

    fn remembered(&self, number: &mut dyn FnMut(f64)) {
        if self.goes_round() {
            number(self.last);
        }
    }

    fn lines(&self) -> Vec<[u32; 2]> {
        match self.measure {
            Measure::Length | Measure::Twist(_) => vec![[0, 1]],
            Measure::Turn => vec![[0, 1], [1, 2]],
            Measure::Area => vec![[0, 1], [1, 2], [2, 0]],
            Measure::Volume => vec![[0, 1], [0, 2], [0, 3], [1, 2], [2, 3], [3, 1]],
            Measure::Dihedral => vec![[0, 1], [0, 2], [1, 2], [0, 3], [1, 3]],
        }
    }

    /// A law as steep everywhere as this one is where it is steepest, through where it is at the start.
    fn stiffest(&self, start: &Local<'_>) -> Box<dyn Element> {
        let x = self.place(self.measured(start));
        let (pull, steepest) = (self.law().slope(x), self.law.steepest());
        let line = vec![[x - 1e3, pull - 1e3 * steepest], [x + 1e3, pull + 1e3 * steepest]];
        Box::new(Self { law: Law::Table(line), ..self.clone() })
    }

    fn clone_box(&self) -> Box<dyn Element> {
        Box::new(self.clone())
    }
}
