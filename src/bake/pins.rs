//! What is said about pins that cannot be meant: two that want different places for one particle, one that moves faster
//! than the material can follow, one that leads out of the room.

use super::note::Note;
use super::room;
use crate::scene::{Body, Mass, Pin, Scene, TwoLayer};
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

/// Says what is doubtful about the pins of a body, its last constraints.
pub(super) fn note_pins(
    scene: &Scene,
    pins: &[Pin],
    parts: &BodyParts,
    following: Following,
    path: &str,
    notes: &mut Vec<Note>,
) {
    let held = &parts.constraints[parts.constraints.len() - pins.len()..];
    let mut warn = |k: usize, text: String| {
        notes.push(Note { path: format!("{path}/pins/{k}"), text, warning: true });
    };
    for (k, (pin, constraint)) in pins.iter().zip(held).enumerate() {
        for (other, before) in pins.iter().zip(held).take(k) {
            if let Some((shared, axis, apart, time)) = conflict(before, constraint, following.spacing) {
                warn(
                    k,
                    format!(
                        "the pins \"{}\" and \"{}\" share {shared} particles and want them {} m apart along {axis} at \
                         {} s; the later one, \"{}\", has its way: hold each particle by one pin along an axis",
                        other.id,
                        pin.id,
                        four_figures(apart),
                        four_figures(time),
                        pin.id
                    ),
                );
            }
        }
        if let Some((speed, time)) = leap(constraint, following) {
            warn(
                k,
                format!(
                    "the pin \"{}\" moves at {} m/s at {} s, faster than a push travels through the body ({} m/s), which \
                     tears it; give the move more time",
                    pin.id,
                    if speed.is_finite() { four_figures(speed) } else { "any number of".to_owned() },
                    four_figures(time),
                    four_figures(following.speed)
                ),
            );
        }
        if let Some((side, depth, time)) = leaves_room(scene, constraint, following.spacing) {
            warn(
                k,
                format!(
                    "the pin \"{}\" leads its particles {} m beyond the {side} at {} s; end the move before it",
                    pin.id,
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
    let starts: Vec<(DVec3, DVec3)> = one
        .particles
        .iter()
        .zip(&one.start)
        .filter_map(|(i, &start)| Some((start, other.start[other.particles.binary_search(i).ok()?])))
        .collect();
    let mut furthest = ("x", 0.0, 0.0);
    for time in times(&one.motion).into_iter().chain(times(&other.motion)) {
        for &(mine, its) in &starts {
            let apart = (one.motion.at(time, mine).0 - other.motion.at(time, its).0).abs();
            for (k, axis) in ["x", "y", "z"].into_iter().enumerate().filter(|(k, _)| both.test(*k)) {
                if apart[k] > furthest.1 {
                    furthest = (axis, apart[k], time);
                }
            }
        }
    }
    (furthest.1 > 1e-6 * spacing).then_some((starts.len(), furthest.0, furthest.1, furthest.2))
}

/// The speed [m/s] of a pin that outruns its body, and when [s]; none where the body can follow. A move of less than half
/// a spacing may be as sudden as it likes.
fn leap(constraint: &Constraint, following: Following) -> Option<(f64, f64)> {
    let window = following.spacing / following.speed;
    let locked = |x: DVec3| DVec3::select(constraint.locked, x, DVec3::ZERO);
    let mut fastest: Option<(f64, f64)> = None;
    for &start in &constraint.start {
        let at = |time: f64| constraint.motion.at(time, start);
        // What begins away from where the particle starts is reached in no time.
        if locked(at(0.0).0 - start).length() > 0.5 * following.spacing {
            return Some((f64::INFINITY, 0.0));
        }
        for time in times(&constraint.motion) {
            let speed = locked(at(time).1).length();
            let moved = locked(at(time + 0.5 * window).0 - at((time - 0.5 * window).max(0.0)).0).length();
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
    for plane in room::planes(scene) {
        let behind = |x: DVec3| -(x - plane.point).dot(plane.normal);
        for &start in constraint.start.iter().filter(|start| behind(**start) <= 0.0) {
            for time in times(&constraint.motion) {
                let place = DVec3::select(constraint.locked, constraint.motion.at(time, start).0, start);
                let depth = behind(place);
                if depth > 0.5 * spacing && furthest.is_none_or(|(_, known, _)| depth > known) {
                    furthest = Some((room::side(plane.normal), depth, time));
                }
            }
        }
    }
    furthest
}
