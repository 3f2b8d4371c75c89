//! Rigid things that bodies touch and that nothing pushes away: where they are at any time.

use super::constraint::PrescribedMotion;
use crate::geometry::obstacle::Obstacle;
use glam::{DQuat, DVec3};
use std::sync::Arc;

/// A collider.
#[derive(Clone, Debug, PartialEq)]
pub struct Collider {
    /// Stable identifier of the scene.
    pub id: String,
    /// Name a person reads.
    pub name: String,
    /// What it is, in its own frame.
    pub(crate) obstacle: Arc<Obstacle>,
    /// Corners of its surface in its own frame [m], three to a face, each with its normal.
    pub(crate) surface: Arc<[[DVec3; 2]]>,
    /// How its own frame is turned at the start.
    pub(crate) rotation: DQuat,
    /// Where its own origin is at the start [m].
    pub(crate) translation: DVec3,
    /// How it moves from there.
    pub(crate) motion: PrescribedMotion,
    /// Coulomb friction coefficient.
    pub friction: f64,
}

/// Where a collider is and how it moves at one time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// How its own frame is turned.
    pub rotation: DQuat,
    /// Where its own origin is [m].
    pub translation: DVec3,
    /// Velocity of its origin [m/s].
    pub velocity: DVec3,
    /// Angular velocity [rad/s].
    pub spin: DVec3,
}

impl Pose {
    /// A place in the world [m] in its own frame.
    pub(crate) fn to_local(self, x: DVec3) -> DVec3 {
        self.rotation.inverse() * (x - self.translation)
    }

    /// A place in its own frame [m] in the world.
    pub(crate) fn to_world(self, x: DVec3) -> DVec3 {
        self.translation + self.rotation * x
    }

    /// Velocity of what it carries at a place in the world [m/s].
    pub(crate) fn velocity_at(&self, x: DVec3) -> DVec3 {
        self.velocity + self.spin.cross(x - self.translation)
    }
}

/// Times at which the greatest speed of a collider is looked for.
const SAMPLES: u32 = 256;

impl Collider {
    /// Where it is at a time [s].
    pub fn pose(&self, time: f64) -> Pose {
        let (translation, velocity) = self.motion.at(time, self.translation);
        let (turn, spin) = self.motion.turning(time);
        Pose { rotation: turn * self.rotation, translation, velocity, spin }
    }

    /// Least and greatest corner [m] of a box in the world around it at a pose, larger by `reach` [m].
    pub(crate) fn bounds(&self, pose: &Pose, reach: f64) -> [DVec3; 2] {
        let [min, max] = self.obstacle.bounds();
        if !(min.is_finite() && max.is_finite()) {
            return [DVec3::NEG_INFINITY, DVec3::INFINITY];
        }
        let center = pose.to_world(0.5 * (min + max));
        let half = 0.5 * (max - min);
        let spread = DVec3::AXES.iter().zip(half.to_array()).map(|(&axis, half)| (pose.rotation * axis).abs() * half);
        let half = spread.sum::<DVec3>() + reach;
        [center - half, center + half]
    }

    /// About the greatest speed of any place of it [m/s] until a time [s].
    pub(crate) fn greatest_speed(&self, until: f64) -> f64 {
        let [min, max] = self.obstacle.bounds();
        let far = min.abs().max(max.abs());
        let arm = if far.is_finite() { far.length() } else { 0.0 };
        let speed = |time: f64| {
            let pose = self.pose(time);
            pose.velocity.length() + pose.spin.length() * arm
        };
        let span = until.min(self.motion.end());
        (0..=SAMPLES).map(|k| speed(span * f64::from(k) / f64::from(SAMPLES))).fold(0.0, f64::max)
    }
}
