//! Constraints: particles whose motion is prescribed along some axes.

use super::drive::Drive;
use super::hand::Hand;
use super::led::Led;
use super::state::ParticleState;
use glam::{BVec3, DQuat, DVec3};
use std::sync::Arc;

/// Particles held or moved along some world axes.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Constraint {
    /// Identifier of the scene's pin; none of what holds a body by itself, or follows a motion.
    pub id: Option<Arc<str>>,
    /// The particles.
    pub particles: Vec<u32>,
    /// Where each of them starts [m].
    pub start: Vec<DVec3>,
    /// From where each of them is moved instead [m], where it was taken hold of on its way.
    pub found: Option<Arc<[DVec3]>>,
    /// Axes along which they are held.
    pub locked: BVec3,
    /// How they move.
    pub motion: PrescribedMotion,
}

/// Motion relative to the start.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum PrescribedMotion {
    /// None.
    Fixed,
    /// By `displacement` [m] over the course.
    Ramp {
        /// Full displacement [m].
        displacement: DVec3,
        /// When.
        course: Course,
    },
    /// By `angle` about a unit axis through `origin`.
    Turn {
        /// Unit axis.
        axis: DVec3,
        /// A point on the axis [m].
        origin: DVec3,
        /// Full angle [rad].
        angle: f64,
        /// When.
        course: Course,
    },
    /// Along offsets [m] at ascending times [s], linear in between.
    Keyframes(Vec<(f64, DVec3)>),
    /// By an offset and a turn, both times a drive.
    Driven {
        /// What they are multiplied by.
        drive: Drive,
        /// Full offset [m].
        offset: DVec3,
        /// Full turn: unit axis, a point on it [m], and the angle [rad].
        turn: Option<(DVec3, DVec3, f64)>,
    },
    /// As a motion made elsewhere leads each of the particles: what is alike for all of them is none.
    Led(Arc<Led>),
}

/// From 0 to 1 over a time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Course {
    /// When it starts [s].
    pub start: f64,
    /// How long it takes [s].
    pub duration: f64,
    /// Whether it eases from rest to rest (3 s² - 2 s³) or runs at a steady rate.
    pub smooth: bool,
}

impl Course {
    /// Progress (0 to 1) and its rate [1/s] at `time` [s].
    pub(crate) fn at(&self, time: f64) -> (f64, f64) {
        let since = time - self.start;
        if since >= self.duration {
            return (1.0, 0.0);
        }
        if since <= 0.0 {
            return (0.0, 0.0);
        }
        let s = since / self.duration;
        if self.smooth {
            (s * s * (3.0 - 2.0 * s), 6.0 * s * (1.0 - s) / self.duration)
        } else {
            (s, 1.0 / self.duration)
        }
    }
}

impl PrescribedMotion {
    /// Position [m] and velocity [m/s] at `time` of what starts at `start`.
    pub(crate) fn at(&self, time: f64, start: DVec3) -> (DVec3, DVec3) {
        match self {
            Self::Fixed | Self::Led(_) => (start, DVec3::ZERO),
            Self::Ramp { displacement, course } => {
                let (progress, rate) = course.at(time);
                (start + progress * *displacement, rate * *displacement)
            }
            Self::Turn { axis, origin, angle, course } => {
                let (progress, rate) = course.at(time);
                let arm = DQuat::from_axis_angle(*axis, progress * angle) * (start - *origin);
                (*origin + arm, (rate * angle * *axis).cross(arm))
            }
            Self::Driven { drive, offset, turn } => {
                let (value, rate) = drive.at(time);
                let (turned, velocity) = turn.map_or((start, DVec3::ZERO), |(axis, origin, angle)| {
                    let arm = DQuat::from_axis_angle(axis, value * angle) * (start - origin);
                    (origin + arm, (rate * angle * axis).cross(arm))
                });
                (turned + value * *offset, velocity + rate * *offset)
            }
            Self::Keyframes(keys) => {
                let (offset, velocity) = interpolate(keys, time);
                (start + offset, velocity)
            }
        }
    }

    /// How far it has turned what it moves at `time` [s], and how fast that turns [rad/s].
    pub(crate) fn turning(&self, time: f64) -> (DQuat, DVec3) {
        let turned = |axis: DVec3, angle: f64, rate: f64| (DQuat::from_axis_angle(axis, angle), rate * axis);
        match self {
            Self::Turn { axis, angle, course, .. } => {
                let (progress, rate) = course.at(time);
                turned(*axis, progress * angle, rate * angle)
            }
            Self::Driven { drive, turn: Some((axis, _, angle)), .. } => {
                let (value, rate) = drive.at(time);
                turned(*axis, value * angle, rate * angle)
            }
            Self::Driven { turn: None, .. } | Self::Fixed | Self::Led(_) | Self::Ramp { .. } | Self::Keyframes(_) => {
                (DQuat::IDENTITY, DVec3::ZERO)
            }
        }
    }

    /// Where something starts that is at `position` [m] at `time` [s].
    fn start_of(&self, time: f64, position: DVec3) -> DVec3 {
        match self {
            Self::Turn { axis, origin, angle, course } => {
                let turn = DQuat::from_axis_angle(*axis, course.at(time).0 * angle);
                *origin + turn.inverse() * (position - *origin)
            }
            Self::Driven { drive, offset, turn } => {
                let value = drive.at(time).0;
                let unmoved = position - value * *offset;
                turn.map_or(unmoved, |(axis, origin, angle)| {
                    origin + DQuat::from_axis_angle(axis, -value * angle) * (unmoved - origin)
                })
            }
            Self::Fixed | Self::Led(_) | Self::Ramp { .. } | Self::Keyframes(_) => {
                position - self.at(time, DVec3::ZERO).0
            }
        }
    }

    /// Has a hand lead a shared drive, or none.
    pub(crate) fn give(&mut self, to: &str, led: Option<Hand>) {
        if let Self::Driven { drive, .. } = self {
            drive.give(to, led);
        }
    }

    /// When the motion has ended [s].
    pub(crate) fn end(&self) -> f64 {
        match self {
            Self::Fixed => 0.0,
            Self::Ramp { course, .. } | Self::Turn { course, .. } => course.start + course.duration,
            Self::Keyframes(keys) => keys.last().map_or(0.0, |key| key.0),
            Self::Driven { drive, .. } => drive.until(),
            Self::Led(led) => led.end(),
        }
    }
}

/// Linear interpolation of keyed vectors: value and rate; constant before the first and after the last.
fn interpolate(keys: &[(f64, DVec3)], time: f64) -> (DVec3, DVec3) {
    let next = keys.partition_point(|key| key.0 <= time);
    match (next.checked_sub(1).map(|k| keys[k]), keys.get(next)) {
        (Some((t0, a)), Some(&(t1, b))) => {
            let rate = (b - a) / (t1 - t0);
            (a + rate * (time - t0), rate)
        }
        (Some((_, last)), None) => (last, DVec3::ZERO),
        (None, first) => (first.map_or(DVec3::ZERO, |key| key.1), DVec3::ZERO),
    }
}

impl Constraint {
    /// From where each of the particles is moved [m].
    fn from(&self) -> &[DVec3] {
        self.found.as_deref().unwrap_or(&self.start)
    }

    /// Holds particles from `time` [s] on where they are in `state`, but for what `before` held already: a constraint
    /// that is new to a motion leaves it where it finds it.
    pub(crate) fn take_hold(&mut self, before: &[Self], time: f64, state: &ParticleState) {
        let same = |old: &&Self| old.particles == self.particles;
        let like = before.iter().filter(same).find(|old| old.locked == self.locked);
        let old = like.or_else(|| before.iter().find(same));
        let held = old.map_or(BVec3::FALSE, |old| old.locked);
        if (self.locked & !held) == BVec3::FALSE {
            self.found = old.and_then(|old| old.found.clone());
            return;
        }
        let led = self.led_by(time);
        let found = self.particles.iter().enumerate().map(|(k, &i)| {
            let at = state.positions[i as usize];
            let here = led.as_ref().map_or_else(|| self.motion.start_of(time, at), |led| at - led[k].0);
            let there = old.map_or(here, |old| old.from()[k]);
            DVec3::select(held, there, here)
        });
        self.found = Some(found.collect());
    }

    /// How far each of the particles has been led from its start at `time` [s], and how fast, where a motion made
    /// elsewhere does so.
    fn led_by(&self, time: f64) -> Option<Vec<(DVec3, DVec3)>> {
        let PrescribedMotion::Led(led) = &self.motion else { return None };
        let starts = self.start.iter();
        Some(led.places(time).into_iter().zip(starts).map(|([at, velocity], start)| (at - *start, velocity)).collect())
    }

    /// Where each of the particles belongs at `time` [s], and how fast it is there.
    pub(crate) fn places(&self, time: f64) -> Vec<(DVec3, DVec3)> {
        match self.led_by(time) {
            Some(led) => {
                led.into_iter().zip(self.from()).map(|((way, velocity), from)| (*from + way, velocity)).collect()
            }
            None => self.from().iter().map(|&from| self.motion.at(time, from)).collect(),
        }
    }

    /// Puts the held particles where they belong at `time` [s], with their velocities.
    pub(crate) fn apply(&self, time: f64, state: &mut ParticleState) {
        let led = self.led_by(time);
        for (k, (&i, &from)) in self.particles.iter().zip(self.from()).enumerate() {
            let (position, velocity) = match &led {
                Some(led) => (from + led[k].0, led[k].1),
                None => self.motion.at(time, from),
            };
            let i = i as usize;
            state.positions[i] = DVec3::select(self.locked, position, state.positions[i]);
            state.velocities[i] = DVec3::select(self.locked, velocity, state.velocities[i]);
        }
    }

    /// Sets the held components of a vector field to zero.
    pub(crate) fn mask(&self, field: &mut [DVec3]) {
        for &i in &self.particles {
            let i = i as usize;
            field[i] = DVec3::select(self.locked, DVec3::ZERO, field[i]);
        }
    }
}

/// Axes along which each of `n` particles is held.
pub(super) fn held(constraints: &[Constraint], n: usize) -> Vec<BVec3> {
    let mut held = vec![BVec3::FALSE; n];
    for constraint in constraints {
        for &i in &constraint.particles {
            held[i as usize] |= constraint.locked;
        }
    }
    held
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solver::drive::Wave;

    #[test]
    fn prescribed_velocities_are_the_rates_of_prescribed_positions() {
        let course = Course { start: 0.1, duration: 0.4, smooth: true };
        let motions = [
            PrescribedMotion::Ramp { displacement: DVec3::new(1.0, 2.0, 3.0), course },
            PrescribedMotion::Turn { axis: DVec3::Y, origin: DVec3::X, angle: 2.0, course },
            PrescribedMotion::Keyframes(vec![(0.0, DVec3::ZERO), (0.3, DVec3::X), (0.6, DVec3::Y)]),
            PrescribedMotion::Driven {
                drive: Drive::Wave(Wave {
                    mean: 0.5,
                    amplitude: 0.7,
                    period: 0.3,
                    phase: 1.0,
                    wavelength: None,
                    start: 0.1,
                }),
                offset: DVec3::new(0.3, 0.0, 0.1),
                turn: Some((DVec3::Z, DVec3::X, 1.0)),
            },
        ];
        let start = DVec3::new(0.3, 0.2, 0.5);
        for motion in &motions {
            for time in [0.05, 0.15, 0.25, 0.45, 0.7] {
                let d = 1e-6;
                let rate = (motion.at(time + d, start).0 - motion.at(time - d, start).0) / (2.0 * d);
                assert!(rate.distance(motion.at(time, start).1) < 1e-7, "{motion:?} at {time}");
                let back = motion.start_of(time, motion.at(time, start).0);
                assert!(back.distance(start) < 1e-12, "{motion:?} at {time}");
            }
        }
        assert_eq!(motions[0].at(9.0, start).0, start + DVec3::new(1.0, 2.0, 3.0));
        for motion in &motions {
            let there = motion.at(0.27, start).0;
            assert!(motion.start_of(0.27, there).distance(start) < 1e-12, "{motion:?}");
        }
    }
}
