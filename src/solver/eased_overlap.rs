//! How what overlaps at the start is eased apart.
//!
//! A contact stores energy by the square of the depth, and hands all of it out as motion: a body that was put half into
//! another one, or into the floor, would be thrown. What overlaps when a motion begins is therefore granted an
//! *allowance*, as deep as the overlap, that fades to nothing smoothly. Contact pushes only past the allowance, so it
//! starts without a force and ends as it always is; in between it acts like something that moves in slowly.
//!
//! The energy of the overlap is counted at the start and taken back as the allowance fades. It is more than the work
//! that easing does (where it were not, nothing is eased: so soft a contact throws nothing), so the sum of the energies
//! never rises above that at the start.
//!
//! All follows from the time alone, so there is nothing to remember from step to step.

use super::constraint::Course;

/// Greatest acceleration of an allowance [m/s²], a quarter of a fall's: what is eased out is not lifted off by it. A
/// speed of `sqrt(0.375 a s)` is the greatest over a distance s.
pub(crate) const GENTLE: f64 = 2.5;

/// An allowance that fades.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EasedOverlap {
    /// Allowance at the start [m].
    pub distance: f64,
    /// Energy that the overlap holds at the start [J].
    pub energy: f64,
    course: Course,
}

impl EasedOverlap {
    /// Eases over a distance [m] from a time [s] on an overlap that holds an energy [J].
    pub(crate) fn new(distance: f64, energy: f64, start: f64) -> Self {
        // The course 3 s² - 2 s³ accelerates by at most 6 over the square of its duration.
        let duration = (6.0 * distance / GENTLE).sqrt();
        Self { distance, energy, course: Course { start, duration, smooth: true } }
    }

    /// How long it takes [s].
    pub fn duration(&self) -> f64 {
        self.course.duration
    }

    /// When it is over [s].
    pub fn end(&self) -> f64 {
        self.course.start + self.course.duration
    }

    /// Allowance [m] at a time [s], and its rate [m/s].
    pub(crate) fn at(&self, time: f64) -> (f64, f64) {
        let (progress, rate) = self.course.at(time);
        (self.distance * (1.0 - progress), -self.distance * rate)
    }

    /// Energy [J] of the overlap that is left at a time [s].
    pub(crate) fn energy_at(&self, time: f64) -> f64 {
        self.energy * (1.0 - self.course.at(time).0)
    }

    /// Greatest speed of the allowance [m/s].
    pub fn speed(&self) -> f64 {
        1.5 * self.distance / self.course.duration
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_allowance_fades_within_its_acceleration_and_speed() {
        let easing = EasedOverlap::new(0.3, 2.0, 1.0);
        assert_eq!(easing.at(1.0), (0.3, -0.0));
        assert_eq!(easing.at(easing.end()).0, 0.0);
        let (mut last, dt) = (0.0, 1e-4);
        for k in 0..=(easing.duration() / dt) as u32 {
            let (_, rate) = easing.at(1.0 + f64::from(k) * dt);
            assert!(rate <= 0.0 && -rate <= easing.speed() * (1.0 + 1e-12));
            assert!((rate - last).abs() <= GENTLE * dt * (1.0 + 1e-6));
            last = rate;
        }
        assert!((easing.speed().powi(2) - 0.375 * GENTLE * 0.3).abs() < 1e-12);
    }
}
