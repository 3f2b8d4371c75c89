//! Rest shapes that are round about the Y axis of the model frame, with their middle at its origin.

use super::Extra;
use crate::geometry::lathe::{corners_around, hoop, spindle};
use crate::geometry::mesh::TriangleMesh;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// A ball about the model's origin, filled with particles on a cubic lattice.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct BallShape {
    /// Radius [m].
    pub radius: f64,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

/// A cylinder along Y about the model's origin, filled with particles on a cubic lattice.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct CylinderShape {
    /// Radius [m].
    pub radius: f64,
    /// Height [m].
    pub height: f64,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

/// A cylinder along Y with half a ball at each end, about the model's origin, filled with particles on a cubic lattice.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct CapsuleShape {
    /// Radius of cylinder and balls [m].
    pub radius: f64,
    /// Height of the cylinder, without the balls [m].
    pub height: f64,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

/// A ring around Y about the model's origin, filled with particles on a cubic lattice.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct TorusShape {
    /// Distance of the middle of the tube from the axis [m].
    pub radius: f64,
    /// Radius of the tube, less than that [m].
    pub tube_radius: f64,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

/// Points of a quarter of a circle and more, from one angle to another, both included.
fn arc(center: [f64; 2], radius: f64, [from, to]: [f64; 2], steps: usize) -> impl Iterator<Item = [f64; 2]> {
    (0..=steps).map(move |k| {
        let (sine, cosine) = (from + (to - from) * k as f64 / steps as f64).sin_cos();
        [center[0] + radius * cosine, center[1] + radius * sine]
    })
}

/// As many steps as make parts of about `edge`, one at least and 200 at most.
fn steps(length: f64, edge: f64) -> usize {
    (length / edge).round().clamp(1.0, 200.0) as usize
}

impl BallShape {
    /// A ball of this radius [m].
    pub fn new(radius: f64) -> Self {
        Self { radius, extra: Extra::new() }
    }

    /// Its surface in faces of about `edge` [m].
    pub(crate) fn surface(&self, edge: f64) -> TriangleMesh {
        let around = corners_around(self.radius, edge);
        let profile: Vec<_> = arc([0.0; 2], self.radius, [-FRAC_PI_2, FRAC_PI_2], around / 2).collect();
        spindle(&profile, around)
    }

    pub(super) fn volume(&self) -> f64 {
        4.0 / 3.0 * PI * self.radius.powi(3)
    }

    pub(super) fn size(&self) -> [f64; 3] {
        [2.0 * self.radius; 3]
    }
}

impl CylinderShape {
    /// A cylinder of this radius and height [m].
    pub fn new(radius: f64, height: f64) -> Self {
        Self { radius, height, extra: Extra::new() }
    }

    /// Its surface in faces of about `edge` [m].
    pub(crate) fn surface(&self, edge: f64) -> TriangleMesh {
        let (half, rings, rows) = (0.5 * self.height, steps(self.radius, edge).max(2), steps(self.height, edge));
        let out = |k: usize| self.radius * k as f64 / rings as f64;
        let mut profile: Vec<[f64; 2]> = (0..=rings).map(|k| [out(k), -half]).collect();
        profile.extend((1..rows).map(|k| [self.radius, self.height * k as f64 / rows as f64 - half]));
        profile.extend((0..=rings).rev().map(|k| [out(k), half]));
        spindle(&profile, corners_around(self.radius, edge))
    }

    pub(super) fn volume(&self) -> f64 {
        PI * self.radius.powi(2) * self.height
    }

    pub(super) fn size(&self) -> [f64; 3] {
        [2.0 * self.radius, self.height, 2.0 * self.radius]
    }
}

impl CapsuleShape {
    /// A capsule of this radius, with a cylinder of this height between its balls [m].
    pub fn new(radius: f64, height: f64) -> Self {
        Self { radius, height, extra: Extra::new() }
    }

    /// Its surface in faces of about `edge` [m].
    pub(crate) fn surface(&self, edge: f64) -> TriangleMesh {
        let (half, rows) = (0.5 * self.height, steps(self.height, edge));
        let around = corners_around(self.radius, edge);
        let mut profile: Vec<_> = arc([0.0, -half], self.radius, [-FRAC_PI_2, 0.0], around / 4).collect();
        profile.extend((1..rows).map(|k| [self.radius, self.height * k as f64 / rows as f64 - half]));
        profile.extend(arc([0.0, half], self.radius, [0.0, FRAC_PI_2], around / 4));
        spindle(&profile, around)
    }

    pub(super) fn volume(&self) -> f64 {
        PI * self.radius.powi(2) * (self.height + 4.0 / 3.0 * self.radius)
    }

    pub(super) fn size(&self) -> [f64; 3] {
        [2.0 * self.radius, self.height + 2.0 * self.radius, 2.0 * self.radius]
    }
}

impl TorusShape {
    /// A torus: how far the middle of its tube lies from the axis, and the tube's own radius [m].
    pub fn new(radius: f64, tube_radius: f64) -> Self {
        Self { radius, tube_radius, extra: Extra::new() }
    }

    /// Its surface in faces of about `edge` [m].
    pub(crate) fn surface(&self, edge: f64) -> TriangleMesh {
        let corners = corners_around(self.tube_radius, edge);
        let mut profile: Vec<_> = arc([self.radius, 0.0], self.tube_radius, [0.0, TAU], corners).collect();
        // The last is the first.
        profile.pop();
        hoop(&profile, corners_around(self.radius + self.tube_radius, edge))
    }

    pub(super) fn volume(&self) -> f64 {
        2.0 * PI * PI * self.radius * self.tube_radius.powi(2)
    }

    pub(super) fn size(&self) -> [f64; 3] {
        let across = 2.0 * (self.radius + self.tube_radius);
        [across, 2.0 * self.tube_radius, across]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn surfaces_are_closed_turned_outwards_and_of_the_volume_that_is_said() {
        let (ball, cylinder) = (BallShape::new(0.03), CylinderShape::new(0.02, 0.07));
        let (capsule, torus) = (CapsuleShape::new(0.02, 0.05), TorusShape::new(0.03, 0.01));
        let cases = [
            (ball.surface(2e-3), ball.volume(), ball.size()),
            (cylinder.surface(2e-3), cylinder.volume(), cylinder.size()),
            (capsule.surface(2e-3), capsule.volume(), capsule.size()),
            (torus.surface(2e-3), torus.volume(), torus.size()),
        ];
        for (mesh, volume, size) in cases {
            assert!((mesh.volume() / volume - 1.0).abs() < 0.01, "{} instead of {volume}", mesh.volume());
            let mut edges = std::collections::BTreeMap::<[u32; 2], i32>::new();
            for &[a, b, c] in &mesh.triangles {
                for [p, q] in [[a, b], [b, c], [c, a]] {
                    *edges.entry([p.min(q), p.max(q)]).or_default() += if p < q { 1 } else { -1 };
                }
            }
            assert!(edges.values().all(|&balance| balance == 0));
            for axis in 0..3 {
                let reach = mesh.positions.iter().map(|at| at[axis].abs()).fold(0.0, f64::max);
                assert!((2.0 * reach / size[axis] - 1.0).abs() < 1e-9, "axis {axis}");
            }
        }
    }
}
