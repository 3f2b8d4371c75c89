//! What is said about pins, and motions that are followed, that cannot be meant: two that want different places for one
//! particle, one that moves faster than the material can follow, one that leads out of the room.

use super::note::Note;
use super::room;
use crate::scene::{Body, Follow, Hold, Mass, Pin, Scene, TwoLayer};
use crate::solver::body::BodyParts;
use crate::solver::constraint::{Constraint, PrescribedMotion};
use crate::text::number::four_figures;
use glam::DVec3;

/// How fast a body can follow what moves it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Following {
    /// Speed [m/s] at which a push travels through it.
    speed: f64,
    /// Distance [m] between its particles.
    spacing: f64,
}

impl Following {
    /// Of a fibre solid: its pressure waves.
    pub(super) fn of_solid(body: &Body) -> Self {
        let material = &body.material;
        let (e, nu, spacing) = (material.young_modulus, material.poisson_ratio, material.spacing());
        let density = match material.mass {
            Mass::Density(density) => density,
            Mass::PerParticle(mass) => mass / spacing.powi(3),
        };
        let modulus = e * (1.0 - nu) / ((1.0 + nu) * (1.0 - 2.0 * nu));
        Self { speed: (modulus / density).sqrt(), spacing }
    }

    /// Of a two-layer body of this radius [m]: what crosses one spring within its swing.
    pub(super) fn of_two_layer(body: &TwoLayer, radius: f64) -> Self {
        let spacing = 0.5 * radius;
        Self { speed: spacing * (body.ks.max(body.rks) / body.mass).sqrt(), spacing }
    }
}

/// What holds some particles of a body: where that stands in the scene, and what people call it.
pub(super) struct Holder<'a> {
    pub(super) pointer: String,
    /// "pin", or what else it is.
    pub(super) what: &'static str,
    pub(super) id: &'a str,
}

impl Holder<'_> {
    fn name(&self) -> String {
        format!("the {} \"{}\"", self.what, self.id)
    }

    /// Two of them in one breath.
    fn both(&self, other: &Self) -> String {
        if self.what == other.what {
            format!("the {}s \"{}\" and \"{}\"", self.what, self.id, other.id)
        } else {
            format!("{} and {}", self.name(), other.name())
        }
    }
}

/// What a body at `path` is held by, in the order of its constraints: the motions that it follows without springs, then
/// its pins.
pub(super) fn holders<'a>(pins: &'a [Pin], follows: &'a [Follow], path: &str) -> Vec<Holder<'a>> {
    let pins = pins.iter().enumerate();
    let pins = pins.map(|(k, pin)| Holder { pointer: format!("{path}/pins/{k}"), what: "pin", id: &pin.id });
    let hard = follows.iter().enumerate().filter(|(_, of)| of.hold == Hold::Hard);
    let led =
        hard.map(|(k, of)| Holder { pointer: format!("{path}/follows/{k}"), what: "followed motion", id: &of.id });
    led.chain(pins).collect()
}

/// Says what is doubtful about what holds a body: its last constraints.
pub(super) fn note_pins(
    scene: &Scene,
    holders: &[Holder<'_>],
    parts: &BodyParts,
    following: Following,
    notes: &mut Vec<Note>,
) {
    let held = &parts.constraints[parts.constraints.len() - holders.len()..];
    let mut warn = |of: &Holder<'_>, text: String| notes.push(Note { path: of.pointer.clone(), text, warning: true });
    for (k, (of, constraint)) in holders.iter().zip(held).enumerate() {
        for (other, before) in holders.iter().zip(held).take(k) {
            if let Some((shared, axis, apart, time)) = conflict(before, constraint, following.spacing) {
                warn(
                    of,
                    format!(
                        "{} share {shared} particles and want them {} m apart along {axis} at \
                         {} s; the later one, \"{}\", has its way: hold each particle by one pin along an axis",
                        other.both(of),
                        four_figures(apart),
                        four_figures(time),
                        of.id
                    ),
                );
            }
        }
        if let Some((speed, time)) = leap(constraint, following) {
            let remedy = match constraint.motion {
                PrescribedMotion::Led(_) => "give it a pre-roll, or play it more slowly",
                _ => "give the move more time",
            };
            warn(
                of,
                format!(
                    "{} moves at {} m/s at {} s, faster than a push travels through the body ({} m/s), which \
                     tears it; {remedy}",
                    of.name(),
                    if speed.is_finite() { four_figures(speed) } else { "any number of".to_owned() },
                    four_figures(time),
                    four_figures(following.speed)
                ),
            );
        }
        if let Some((side, depth, time)) = leaves_room(scene, constraint, following.spacing) {
            warn(
                of,
                format!(
                    "{} leads its particles {} m beyond the {side} at {} s; end the move before it",
                    of.name(),
                    four_figures(depth),
                    four_figures(time)
                ),
            );
        }
    }
}

/// Times at which the motion of a pin is looked at [s].
fn times(motion: &PrescribedMotion) -> Vec<f64> {
    const PIECES: u32 = 16;
    let between =
        |start: f64, end: f64| (0..=PIECES).map(move |k| start + (end - start) * f64::from(k) / f64::from(PIECES));
    match motion {
        PrescribedMotion::Fixed => vec![0.0],
        PrescribedMotion::Ramp { course, .. } | PrescribedMotion::Turn { course, .. } => {
            between(course.start, course.start + course.duration).collect()
        }
        PrescribedMotion::Driven { drive, .. } => drive.moments(),
        PrescribedMotion::Led(led) => led.playing.moments(),
        PrescribedMotion::Keyframes(keys) => {
            let middles = keys.windows(2).map(|pair| 0.5 * (pair[0].0 + pair[1].0));
            let mut times: Vec<f64> = keys.iter().map(|key| key.0).chain(middles).collect();
            times.sort_by(f64::total_cmp);
            times
        }
    }
}

/// How many particles two pins share, and along which axis, how far and when they want them furthest apart; none where
/// they agree.
fn conflict(one: &Constraint, other: &Constraint, spacing: f64) -> Option<(usize, &'static str, f64, f64)> {
    let both = one.locked & other.locked;
    if !both.any() {
        return None;
    }
    // Both lists are in ascending order.
    let shared: Vec<(usize, usize)> = one
        .particles
        .iter()
        .enumerate()
        .filter_map(|(k, i)| Some((k, other.particles.binary_search(i).ok()?)))
        .collect();
    let mut furthest = ("x", 0.0, 0.0);
    for time in times(&one.motion).into_iter().chain(times(&other.motion)).filter(|_| !shared.is_empty()) {
        let (mine, its) = (one.places(time), other.places(time));
        for &(k, l) in &shared {
            let apart = (mine[k].0 - its[l].0).abs();
            for (k, axis) in ["x", "y", "z"].into_iter().enumerate().filter(|(k, _)| both.test(*k)) {
                if apart[k] > furthest.1 {
                    furthest = (axis, apart[k], time);
                }
            }
        }
    }
    (furthest.1 > 1e-6 * spacing).then_some((shared.len(), furthest.0, furthest.1, furthest.2))
}

/// The speed [m/s] of a pin that outruns its body, and when [s]; none where the body can follow. A move of less than
/// half a spacing may be as sudden as it likes.
fn leap(constraint: &Constraint, following: Following) -> Option<(f64, f64)> {
    let window = following.spacing / following.speed;
    let locked = |x: DVec3| DVec3::select(constraint.locked, x, DVec3::ZERO);
    let mut fastest: Option<(f64, f64)> = None;
    // What begins away from where the particle starts is reached in no time.
    let starts = constraint.places(0.0).into_iter().zip(&constraint.start);
    if starts.into_iter().any(|((at, _), start)| locked(at - *start).length() > 0.5 * following.spacing) {
        return Some((f64::INFINITY, 0.0));
    }
    for time in times(&constraint.motion) {
        let [before, here, after] =
            [(time - 0.5 * window).max(0.0), time, time + 0.5 * window].map(|time| constraint.places(time));
        for ((before, here), after) in before.into_iter().zip(here).zip(after) {
            let speed = locked(here.1).length();
            let moved = locked(after.0 - before.0).length();
            // A jump has no rate.
            let speed = speed.max(moved / window);
            let is_leap = speed > following.speed && moved > 0.5 * following.spacing;
            if is_leap && fastest.is_none_or(|(known, _)| speed > known) {
                fastest = Some((speed, time));
            }
        }
    }
    fastest
}

/// The side of the room that a pin leads its particles beyond, how far [m] and when [s].
fn leaves_room(scene: &Scene, constraint: &Constraint, spacing: f64) -> Option<(&'static str, f64, f64)> {
    let mut furthest: Option<(&'static str, f64, f64)> = None;
    let planes = room::planes(scene);
    if planes.is_empty() {
        return None;
    }
    for time in times(&constraint.motion) {
        let places = constraint.places(time);
        for plane in &planes {
            let behind = |x: DVec3| -(x - plane.point).dot(plane.normal);
            let inside = constraint.start.iter().zip(&places).filter(|(start, _)| behind(**start) <= 0.0);
            for (&start, &(at, _)) in inside {
                let depth = behind(DVec3::select(constraint.locked, at, start));
                if depth > 0.5 * spacing && furthest.is_none_or(|(_, known, _)| depth > known) {
                    furthest = Some((room::side(plane.normal), depth, time));
                }
            }
        }
    }
    furthest
}
