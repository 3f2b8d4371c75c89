//! Moving and turning what is selected with the pointer, by typed numbers, along one axis, finely or in steps.

use crate::edit::fibre_ops::{FibreEditError, Transform};
use crate::scene::Fibre;
use crate::text::quantity::typed;
use egui::Pos2;
use glam::{DMat3, DVec2, DVec3};

/// Moved or turned.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// Along with the pointer.
    Move,
    /// About the pivot.
    Turn,
}

/// A gesture under way. All places are in the model frame.
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
    /// The fibres as they were.
    pub originals: Vec<Fibre>,
    /// Vertices of the one fibre; all of every fibre if none.
    pub vertices: Option<Vec<usize>>,
    /// Changes of this gesture are one step of undo.
    pub gesture: u64,
    /// Steps in which it snaps [m].
    pub step: f64,
    /// What the fibres are copies of, where they are: copies that are given up go again, and none is left on what it is
    /// a copy of.
    pub copied: Option<Vec<String>>,
}

/// What a pointer and the keys beside it ask for.
#[derive(Clone, Copy, Debug)]
pub(super) struct Asked {
    /// Where the pointer would put the pivot [m].
    pub to: DVec3,
    /// Turn of the pointer about the pivot as seen, counter-clockwise [rad].
    pub angle: f64,
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

const AXES: [&str; 3] = ["X", "Y", "Z"];

impl Moving {
    /// What is typed, as metres or degrees; none while nothing is, or what is makes no number.
    fn number(&self) -> Option<f64> {
        match self.kind {
            Kind::Move => typed(&self.typed, "mm").map(|mm| 1e-3 * mm),
            Kind::Turn => typed(&self.typed, "°"),
        }
    }

    /// The transform that is asked for.
    ///
    /// # Errors
    /// An axis without a direction.
    pub(super) fn transform(&self, asked: &Asked) -> Result<Transform, FibreEditError> {
        let share = if asked.fine { FINE } else { 1.0 };
        let stepped = |value: f64, step: f64| if asked.snap { (value / step).round() * step } else { value };
        match self.kind {
            Kind::Move => {
                let by = share * (asked.to - self.pivot);
                let by = DVec3::from_array(by.to_array().map(|along| stepped(along, self.step)));
                let locked = |axis: usize, value: f64| value * DMat3::IDENTITY.col(axis);
                Ok(Transform::translation(match (self.axis, self.number()) {
                    (Some(axis), Some(number)) => locked(axis, number),
                    (None, Some(number)) => number * by.normalize_or(DVec3::X),
                    (Some(axis), None) => locked(axis, by[axis]),
                    (None, None) => by,
                }))
            }
            Kind::Turn => {
                let axis = self.axis.map_or(asked.toward_eye, |axis| DMat3::IDENTITY.col(axis));
                // Seen from behind, an axis turns the other way.
                let side = if axis.dot(asked.toward_eye) < 0.0 { -1.0 } else { 1.0 };
                let degrees = stepped(share * side * asked.angle.to_degrees(), TURN_STEP);
                Transform::rotation(self.pivot, axis, self.number().unwrap_or(degrees).to_radians())
            }
        }
    }

    /// What is going on, for the status bar.
    pub(super) fn hint(&self) -> String {
        let what = match self.kind {
            Kind::Move => "Move",
            Kind::Turn => "Turn",
        };
        let axis = self.axis.map_or(String::new(), |axis| format!(" along {}", AXES[axis]));
        let axis = if self.kind == Kind::Turn { axis.replace("along", "about") } else { axis };
        let unit = if self.kind == Kind::Move { "mm" } else { "degrees" };
        let typed = match self.number() {
            Some(_) if self.kind == Kind::Move && self.typed.contains('m') => format!(": {}", self.typed),
            _ if self.typed.is_empty() => String::new(),
            _ => format!(": {} {unit}", self.typed),
        };
        format!(
            "{what}{axis}{typed}   X Y Z lock an axis, a number is taken in {unit}, Shift finely, Ctrl in steps, Escape back"
        )
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
            originals: Vec::new(),
            vertices: None,
            gesture: 0,
            step: 0.002,
            copied: None,
        }
    }

    fn asked(to: DVec3, angle: f64) -> Asked {
        Asked { to, angle, toward_eye: DVec3::Z, fine: false, snap: false }
    }

    #[test]
    fn a_move_follows_the_pointer_locked_fine_in_steps_or_as_typed() {
        let mut moving = moving(Kind::Move);
        let to = moving.pivot + DVec3::new(0.0051, -0.0029, 0.0);
        let by = |moving: &Moving, asked: &Asked| moving.transform(asked).unwrap().apply(moving.pivot) - moving.pivot;
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
            moving.transform(asked).unwrap().apply(moving.pivot + DVec3::X) - moving.pivot
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
    fn steps_are_round_numbers() {
        for (diagonal, step) in [(0.09, 0.002), (0.3, 0.005), (1.0, 0.02), (40.0, 1.0)] {
            assert!((step_for(diagonal) - step).abs() < 1e-12, "{}", step_for(diagonal));
        }
    }
}
