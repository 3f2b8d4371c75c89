//! Moving, turning and scaling what is selected with the pointer, by typed numbers, along one axis, finely or in steps.

use crate::edit::fibre_ops::{FibreEditError, Transform};
use crate::scene::{Fibre, OwnedBody, Sheet};
use crate::text::quantity::typed;
use egui::Pos2;
use glam::{DMat3, DVec2, DVec3};

/// What is done to it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// Along with the pointer.
    Move,
    /// About the pivot.
    Turn,
    /// Away from the pivot and towards it.
    Scale,
}

/// What a gesture comes to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Change {
    /// By a way [m].
    Move(DVec3),
    /// About an axis through the pivot, right-handed [rad].
    Turn(DVec3, f64),
    /// By a factor about the pivot.
    Scale(f64),
}

impl Change {
    /// As it is done to fibres about a pivot [m].
    ///
    /// # Errors
    /// An axis without a direction, a factor that leaves nothing.
    pub(super) fn about(self, pivot: DVec3) -> Result<Transform, FibreEditError> {
        match self {
            Self::Move(by) => Ok(Transform::translation(by)),
            Self::Turn(axis, radians) => Transform::rotation(pivot, axis, radians),
            Self::Scale(factor) => Transform::scaling(pivot, factor),
        }
    }
}

/// A gesture under way. Places are in the model frame where fibres or a sheet are moved, in the world where a body is.
#[derive(Clone, Debug)]
pub(super) struct Moving {
    pub kind: Kind,
    /// Axis to which it is locked.
    pub axis: Option<usize>,
    /// Number that is typed.
    pub typed: String,
    /// Whether it ends with the release of a button rather than with a click.
    pub by_drag: bool,
    /// Where the pointer began [points].
    pub start: Pos2,
    /// Where what is moved has its middle [m].
    pub pivot: DVec3,
    /// What is moved.
    pub subject: Subject,
    /// Changes of this gesture are one step of undo.
    pub gesture: u64,
    /// Steps in which it snaps [m].
    pub step: f64,
}

/// What is moved.
#[derive(Clone, Debug)]
pub(super) enum Subject {
    /// Fibres, or vertices of one.
    Fibres {
        /// The fibres as they were.
        originals: Vec<Fibre>,
        /// Vertices of the one fibre; all of every fibre if none.
        vertices: Option<Vec<usize>>,
        /// What the fibres are copies of, where they are: copies that are given up go again, and none is left on what
        /// it is a copy of.
        copied: Option<Vec<String>>,
    },
    /// A sheet, as it was.
    Sheet(Box<Sheet>),
    /// A body.
    Body {
        /// The body as it was.
        original: OwnedBody,
        /// Whether a copy of it is moved, which is not there yet.
        copies: bool,
        /// Whether the simulation ran, and is to run on.
        plays: bool,
    },
}

/// What a pointer and the keys beside it ask for.
#[derive(Clone, Copy, Debug)]
pub(super) struct Asked {
    /// Where the pointer would put the pivot [m].
    pub to: DVec3,
    /// Turn of the pointer about the pivot as seen, counter-clockwise [rad].
    pub angle: f64,
    /// How many times as far from the pivot it is as it was.
    pub stretch: f64,
    /// Towards the eye.
    pub toward_eye: DVec3,
    /// Shift: a tenth of it.
    pub fine: bool,
    /// Ctrl: in steps.
    pub snap: bool,
}

/// Share that is left of a fine move.
const FINE: f64 = 0.1;
/// Steps of turns [degrees].
const TURN_STEP: f64 = 5.0;
/// Steps of scalings, and the least and greatest one.
const SCALE_STEP: f64 = 0.1;
const SCALES: (f64, f64) = (0.01, 100.0);
const AXES: [&str; 3] = ["X", "Y", "Z"];

impl Moving {
    /// Whether a body is moved.
    pub(super) fn is_body(&self) -> bool {
        matches!(self.subject, Subject::Body { .. })
    }

    /// What is typed, as metres, degrees or a factor; none while nothing is, or what is makes no number.
    fn number(&self) -> Option<f64> {
        match self.kind {
            Kind::Move => typed(&self.typed, "mm").map(|mm| 1e-3 * mm),
            Kind::Turn => typed(&self.typed, "°"),
            Kind::Scale => typed(&self.typed, "").filter(|factor| (SCALES.0..=SCALES.1).contains(factor)),
        }
    }

    /// What is asked for.
    pub(super) fn change(&self, asked: &Asked) -> Change {
        let share = if asked.fine { FINE } else { 1.0 };
        let stepped = |value: f64, step: f64| if asked.snap { (value / step).round() * step } else { value };
        match self.kind {
            Kind::Move => {
                let by = share * (asked.to - self.pivot);
                let by = DVec3::from_array(by.to_array().map(|along| stepped(along, self.step)));
                let locked = |axis: usize, value: f64| value * DMat3::IDENTITY.col(axis);
                Change::Move(match (self.axis, self.number()) {
                    (Some(axis), Some(number)) => locked(axis, number),
                    (None, Some(number)) => number * by.normalize_or(DVec3::X),
                    (Some(axis), None) => locked(axis, by[axis]),
                    (None, None) => by,
                })
            }
            Kind::Turn => {
                let axis = self.axis.map_or(asked.toward_eye, |axis| DMat3::IDENTITY.col(axis));
                // Seen from behind, an axis turns the other way.
                let side = if axis.dot(asked.toward_eye) < 0.0 { -1.0 } else { 1.0 };
                let degrees = stepped(share * side * asked.angle.to_degrees(), TURN_STEP);
                Change::Turn(axis, self.number().unwrap_or(degrees).to_radians())
            }
            Kind::Scale => {
                let factor = stepped(1.0 + share * (asked.stretch - 1.0), SCALE_STEP);
                Change::Scale(self.number().unwrap_or_else(|| factor.clamp(SCALES.0, SCALES.1)))
            }
        }
    }

    /// What is going on, for the status bar.
    pub(super) fn hint(&self) -> String {
        let (what, unit) = match self.kind {
            Kind::Move => ("Move", "mm"),
            Kind::Turn => ("Turn", "degrees"),
            Kind::Scale => ("Scale", "times"),
        };
        let axis = self.axis.map_or(String::new(), |axis| format!(" along {}", AXES[axis]));
        let axis = match self.kind {
            Kind::Move => axis,
            Kind::Turn => axis.replace("along", "about"),
            Kind::Scale => String::new(),
        };
        let typed = match self.number() {
            Some(_) if self.kind == Kind::Move && self.typed.contains('m') => format!(": {}", self.typed),
            _ if self.typed.is_empty() => String::new(),
            _ => format!(": {} {unit}", self.typed),
        };
        let locks = if self.kind == Kind::Scale { "" } else { "X Y Z lock an axis, " };
        let number = if self.kind == Kind::Scale { "as a factor".to_owned() } else { format!("in {unit}") };
        format!("{what}{axis}{typed}   {locks}a number is taken {number}, Shift finely, Ctrl in steps, Escape back")
    }
}

/// Steps in which things of this size [m] are moved: about a fortieth, as 1, 2 or 5 times a power of ten.
pub(super) fn step_for(diagonal: f64) -> f64 {
    let wanted = (diagonal / 40.0).max(f64::MIN_POSITIVE);
    let power = 10_f64.powf(wanted.log10().floor());
    [5.0, 2.0].into_iter().map(|times| times * power).find(|step| *step <= wanted).unwrap_or(power)
}

/// Turn from one pixel to another about a third, counter-clockwise as seen [rad].
pub(super) fn seen_angle(from: DVec2, to: DVec2, about: DVec2) -> f64 {
    // Pixels count downwards.
    let up = |v: DVec2| DVec2::new(v.x, -v.y);
    let (from, to) = (up(from - about), up(to - about));
    if from.length() < 1e-9 || to.length() < 1e-9 { 0.0 } else { from.angle_to(to) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn moving(kind: Kind) -> Moving {
        Moving {
            kind,
            axis: None,
            typed: String::new(),
            by_drag: false,
            start: Pos2::ZERO,
            pivot: DVec3::new(0.01, 0.02, 0.03),
            subject: Subject::Fibres { originals: Vec::new(), vertices: None, copied: None },
            gesture: 0,
            step: 0.002,
        }
    }

    fn asked(to: DVec3, angle: f64) -> Asked {
        Asked { to, angle, stretch: 1.0, toward_eye: DVec3::Z, fine: false, snap: false }
    }

    #[test]
    fn a_move_follows_the_pointer_locked_fine_in_steps_or_as_typed() {
        let mut moving = moving(Kind::Move);
        let to = moving.pivot + DVec3::new(0.0051, -0.0029, 0.0);
        let by = |moving: &Moving, asked: &Asked| {
            moving.change(asked).about(moving.pivot).unwrap().apply(moving.pivot) - moving.pivot
        };
        let close = |a: DVec3, b: DVec3| assert!(a.distance(b) < 1e-15, "{a}, not {b}");
        let mut asked = asked(to, 0.0);
        close(by(&moving, &asked), DVec3::new(0.0051, -0.0029, 0.0));
        asked.snap = true;
        close(by(&moving, &asked), DVec3::new(0.006, -0.002, 0.0));
        asked.snap = false;
        asked.fine = true;
        close(by(&moving, &asked), DVec3::new(0.00051, -0.00029, 0.0));
        moving.axis = Some(1);
        close(by(&moving, &asked), DVec3::new(0.0, -0.00029, 0.0));
        for (typed, metres) in [("7", 0.007), ("-2.5", -0.0025), ("1.5cm", 0.015), ("0.1 m", 0.1), ("2*3cm", 0.06)] {
            moving.typed = typed.to_owned();
            close(by(&moving, &asked), DVec3::new(0.0, metres, 0.0));
        }
        moving.typed = "-".to_owned();
        close(by(&moving, &asked), DVec3::new(0.0, -0.00029, 0.0));
    }

    #[test]
    fn a_turn_follows_the_pointer_as_it_is_seen() {
        let mut moving = moving(Kind::Turn);
        let quarter = asked(DVec3::ZERO, std::f64::consts::FRAC_PI_2);
        let at = |moving: &Moving, asked: &Asked| {
            moving.change(asked).about(moving.pivot).unwrap().apply(moving.pivot + DVec3::X) - moving.pivot
        };
        assert!(at(&moving, &quarter).distance(DVec3::Y) < 1e-12);
        moving.axis = Some(2);
        let behind = Asked { toward_eye: -DVec3::Z, ..quarter };
        assert!(at(&moving, &behind).distance(-DVec3::Y) < 1e-12, "seen from behind it turns the other way");
        moving.typed = "90".to_owned();
        assert!(at(&moving, &behind).distance(DVec3::Y) < 1e-12);
        assert!((seen_angle(DVec2::X, -DVec2::Y, DVec2::ZERO) - std::f64::consts::FRAC_PI_2).abs() < 1e-12);
    }

    #[test]
    fn a_scaling_follows_the_pointer_away_from_the_pivot_or_is_typed() {
        let mut moving = moving(Kind::Scale);
        let mut asked = Asked { stretch: 1.34, ..asked(DVec3::ZERO, 0.0) };
        let factor = |moving: &Moving, asked: &Asked| match moving.change(asked) {
            Change::Scale(factor) => factor,
            other => panic!("{other:?}"),
        };
        assert!((factor(&moving, &asked) - 1.34).abs() < 1e-12);
        asked.snap = true;
        assert!((factor(&moving, &asked) - 1.3).abs() < 1e-12);
        moving.typed = "2.5".to_owned();
        assert_eq!(factor(&moving, &asked), 2.5);
        moving.typed = "0".to_owned();
        assert!((factor(&moving, &asked) - 1.3).abs() < 1e-12, "nothing would be left");
        asked = Asked { stretch: 0.0, snap: false, ..asked };
        assert_eq!(factor(&moving, &asked), SCALES.0);
    }

    #[test]
    fn steps_are_round_numbers() {
        for (diagonal, step) in [(0.09, 0.002), (0.3, 0.005), (1.0, 0.02), (40.0, 1.0)] {
            assert!((step_for(diagonal) - step).abs() < 1e-12, "{}", step_for(diagonal));
        }
    }
}
