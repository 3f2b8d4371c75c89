//! What is tried of every element before it acts: that its slopes are its energy's, that they move and turn nothing as
//! a whole, and that it is no stiffer than it says.

use super::contract::{Element, Local, MOST_POINTS, Slopes};
use glam::{DQuat, DVec3};
use thiserror::Error;

/// Why an element cannot be used.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum ElementFault {
    /// More points than one may have, or none.
    #[error("it names {0} points; give 1 to {MOST_POINTS}")]
    Points(usize),
    /// A point that the structure does not have, or one that is named twice.
    #[error("it names point {0}, which is not there or which it names before")]
    Point(u32),
    /// An energy or a slope that is no number.
    #[error("its energy or a slope of it is no finite number where its points are moved by {0:.1e} m")]
    NoNumber(f64),
    /// Slopes that are not those of the energy.
    #[error("its slopes are {0:.1e} off the differences of its energy, relative")]
    Slopes(f64),
    /// Forces on its points that push the whole.
    #[error("its forces sum to {0:.1e} of their sizes, so that it pushes the body by itself")]
    Sum(f64),
    /// Forces on its points, and turns of the material, that turn the whole.
    #[error("its torques sum to {0:.1e} of their sizes, so that it turns the body by itself")]
    Torque(f64),
    /// Stiffer than its majorant.
    #[error("it resists a move by {found:.3e} N/m, more than its majorant of {said:.3e} N/m")]
    Majorant {
        /// The curvature of its energy that was found [N/m].
        found: f64,
        /// What it says [N/m].
        said: f64,
    },
}

/// States that are tried, and moves from each.
const STATES: usize = 3;
const MOVES: usize = 4;

/// How far points are moved, over the size of what they span, and by what share of that the differences are taken.
const FAR: f64 = 0.08;
const STEP: f64 = 1e-3;

/// Greatest error of slopes, and of their sums.
const SLOPE_ERROR: f64 = 1e-5;
const SUM_ERROR: f64 = 1e-9;

/// Share by which a curvature may be above its bound: what differences leave of it.
const ABOVE: f64 = 1e-3;

/// Tries an element over a structure's `points` at rest [m] in three random states around that, each turned as a whole.
///
/// # Errors
/// What is wrong, with its figure.
pub fn check(element: &dyn Element, points: &[DVec3]) -> Result<(), ElementFault> {
    let names = element.points();
    if names.is_empty() || names.len() > MOST_POINTS {
        return Err(ElementFault::Points(names.len()));
    }
    for list in [names, element.turns()] {
        for (k, &name) in list.iter().enumerate() {
            if name as usize >= points.len() || list[..k].contains(&name) {
                return Err(ElementFault::Point(name));
            }
        }
    }
    let rest: Vec<DVec3> = names.iter().map(|&k| points[k as usize]).collect();
    let size = rest.iter().map(|x| x.distance(rest[0])).fold(0.0, f64::max);
    let size = if size > 0.0 { size } else { 1.0 };
    let mut random = Random(0x5eed);
    (0..STATES).try_for_each(|_| {
        let state = State::random(&rest, element.turns().len(), size, &mut random);
        state.try_of(element, size, &mut random)
    })
}

/// A state of an element's points and turns.
struct State {
    points: Vec<DVec3>,
    turns: Vec<DQuat>,
}

/// A move of both.
struct Move {
    points: Vec<DVec3>,
    turns: Vec<DVec3>,
}

impl State {
    fn random(rest: &[DVec3], turns: usize, size: f64, random: &mut Random) -> Self {
        let whole = random.turn(3.0);
        let points = rest.iter().map(|x| whole * (*x + FAR * size * random.vector())).collect();
        Self { points, turns: (0..turns).map(|_| whole * random.turn(0.3)).collect() }
    }

    fn energy(&self, element: &dyn Element) -> f64 {
        element.energy(&Local { points: &self.points, turns: &self.turns })
    }

    fn moved(&self, by: &Move, step: f64) -> Self {
        let points = self.points.iter().zip(&by.points).map(|(x, way)| *x + step * *way).collect();
        let turned = |(turn, spin): (&DQuat, &DVec3)| *turn * DQuat::from_scaled_axis(step * *spin);
        Self { points, turns: self.turns.iter().zip(&by.turns).map(turned).collect() }
    }

    fn try_of(&self, element: &dyn Element, size: f64, random: &mut Random) -> Result<(), ElementFault> {
        let (mut points, mut turns) = (vec![DVec3::ZERO; self.points.len()], vec![DVec3::ZERO; self.turns.len()]);
        let mut slopes = Slopes { points: &mut points, turns: &mut turns };
        element.slopes(&Local { points: &self.points, turns: &self.turns }, &mut slopes);
        let finite = points.iter().chain(&turns).all(|slope| slope.is_finite()) && self.energy(element).is_finite();
        if !finite {
            return Err(ElementFault::NoNumber(FAR * size));
        }
        let work =
            points.iter().map(|g| g.length()).sum::<f64>() * size + turns.iter().map(|m| m.length()).sum::<f64>();
        // Where it does nothing there is nothing to be off.
        let energy = self.energy(element).abs();
        let scale = work + energy;
        if scale == 0.0 {
            return Ok(());
        }
        let sum = points.iter().sum::<DVec3>().length() * size / scale;
        if sum > SUM_ERROR {
            return Err(ElementFault::Sum(sum));
        }
        let middle = self.points.iter().sum::<DVec3>() / self.points.len() as f64;
        let by_points: DVec3 = self.points.iter().zip(&points).map(|(x, g)| (*x - middle).cross(*g)).sum();
        let by_turns: DVec3 = self.turns.iter().zip(&turns).map(|(r, m)| *r * *m).sum();
        let torque = (by_points + by_turns).length() / scale;
        if torque > SUM_ERROR {
            return Err(ElementFault::Torque(torque));
        }
        (0..MOVES).try_for_each(|_| {
            let by = Move {
                points: points.iter().map(|_| size * random.vector()).collect(),
                turns: turns.iter().map(|_| random.vector()).collect(),
            };
            let at = |step: f64| self.moved(&by, step).energy(element);
            let [a, b, c, d] = [-2.0, -1.0, 1.0, 2.0].map(|k| at(k * STEP));
            let found = (8.0 * (c - b) - (d - a)) / (12.0 * STEP);
            let said: f64 = points.iter().zip(&by.points).map(|(g, way)| g.dot(*way)).sum::<f64>()
                + turns.iter().zip(&by.turns).map(|(m, spin)| m.dot(*spin)).sum::<f64>();
            let off = (found - said).abs() / scale;
            if off.is_nan() || off > SLOPE_ERROR {
                return Err(ElementFault::Slopes(off));
            }
            let still = Move { points: by.points.clone(), turns: vec![DVec3::ZERO; turns.len()] };
            let at = |step: f64| self.moved(&still, step).energy(element);
            let moved: f64 = by.points.iter().map(|way| way.length_squared()).sum();
            // Differences leave so much of the energy's last digits.
            let noise = 1e-12 * scale / (STEP * STEP);
            let found = (at(STEP) + at(-STEP) - 2.0 * at(0.0)) / (STEP * STEP);
            let said = element.majorant();
            let most = said * moved * (1.0 + ABOVE) + noise;
            if said.is_nan() || found > most {
                return Err(ElementFault::Majorant { found: found / moved, said });
            }
            Ok(())
        })
    }
}

/// A linear congruential sequence (Knuth's MMIX constants): the same on every machine.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    fn vector(&mut self) -> DVec3 {
        DVec3::new(self.next(), self.next(), self.next())
    }

    fn turn(&mut self, most: f64) -> DQuat {
        DQuat::from_scaled_axis(most * self.vector())
    }
}
