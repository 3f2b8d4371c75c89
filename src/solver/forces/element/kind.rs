//! The kinds of elements.

use super::bound::Bound;
use super::contract::{Change, Element, Local, Slopes};
use super::measured::MeasuredElement;
use crate::solver::forces::fibre::elements::{CurvedBend, Pull, StraightBend, Stretching, Twisting};
use crate::solver::forces::sheet::elements::{Hinge, Triangle};

/// The elements that are built in, and any other.
#[derive(Clone)]
pub(crate) enum Kind {
    /// Stretch of a fibre.
    Stretching(Stretching),
    /// Pull of a muscle.
    Pull(Pull),
    /// Bending of a fibre that is straight at rest.
    StraightBend(StraightBend),
    /// Bending of one that is not.
    CurvedBend(CurvedBend),
    /// Twist of a fibre.
    Twist(Twisting),
    /// Stretch and shear of a sheet.
    Triangle(Triangle),
    /// Bending of a sheet.
    Hinge(Hinge),
    /// A measure times a law.
    Measured(MeasuredElement),
    /// What the stable step is measured with.
    Bound(Bound),
    /// A user's own.
    Custom(Box<dyn Element>),
}

impl Kind {
    /// What bounds how it resists any move: by its majorant, or as it is at the start.
    pub(super) fn stiffest(&self, start: &Local<'_>) -> Self {
        let majorant = self.element().majorant();
        if majorant.is_finite() {
            Self::Bound(Bound::new(self.element().points(), majorant))
        } else {
            Self::Custom(self.element().stiffest(start))
        }
    }

    /// Goes on from where the same element stood before an edit.
    pub(super) fn adopt(&mut self, before: &Self) {
        if let (Self::Measured(of), Self::Measured(before)) = (self, before) {
            of.adopt(before);
        }
    }

    /// The element that it is.
    pub(super) fn element(&self) -> &dyn Element {
        match self {
            Self::Stretching(of) => of,
            Self::Pull(of) => of,
            Self::StraightBend(of) => of,
            Self::CurvedBend(of) => of,
            Self::Twist(of) => of,
            Self::Triangle(of) => of,
            Self::Hinge(of) => of,
            Self::Measured(of) => of,
            Self::Bound(of) => of,
            Self::Custom(of) => &**of,
        }
    }

    fn element_mut(&mut self) -> &mut dyn Element {
        match self {
            Self::Stretching(of) => of,
            Self::Pull(of) => of,
            Self::StraightBend(of) => of,
            Self::CurvedBend(of) => of,
            Self::Twist(of) => of,
            Self::Triangle(of) => of,
            Self::Hinge(of) => of,
            Self::Measured(of) => of,
            Self::Bound(of) => of,
            Self::Custom(of) => &mut **of,
        }
    }
}

impl Element for Kind {
    fn points(&self) -> &[u32] {
        self.element().points()
    }

    fn turns(&self) -> &[u32] {
        self.element().turns()
    }

    fn energy(&self, at: &Local<'_>) -> f64 {
        self.element().energy(at)
    }

    fn slopes(&self, at: &Local<'_>, out: &mut Slopes<'_>) {
        self.element().slopes(at, out);
    }

    fn majorant(&self) -> f64 {
        self.element().majorant()
    }

    fn activate(&mut self, value: f64) {
        self.element_mut().activate(value);
    }

    fn end_step(&mut self, at: &Local<'_>) -> Change {
        self.element_mut().end_step(at)
    }

    fn remembered(&self, number: &mut dyn FnMut(f64)) {
        self.element().remembered(number);
    }

    fn lines(&self) -> Vec<[u32; 2]> {
        self.element().lines()
    }

    fn clone_box(&self) -> Box<dyn Element> {
        self.element().clone_box()
    }
}
