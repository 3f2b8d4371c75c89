//! An inner tube, for two-layer bodies.

use crate::geometry::model::{MeshData, Model};
use glam::DVec3;
use std::f64::consts::TAU;

/// Radius of the tube's centre line and of its section [m].
const LARGE: f64 = 2.0;
const SMALL: f64 = 0.8;

/// Vertices around the axis, and around the section.
const AROUND: u32 = 20;
const SECTION: u32 = 10;

/// A torus about the Y axis.
pub(super) fn tube() -> Model {
    let mut piece = MeshData::default();
    for i in 0..AROUND {
        for j in 0..SECTION {
            let (u, v) = (TAU * f64::from(i) / f64::from(AROUND), TAU * f64::from(j) / f64::from(SECTION));
            let out = DVec3::new(u.cos(), 0.0, -u.sin());
            let normal = v.cos() * out + v.sin() * DVec3::Y;
            piece.positions.push(LARGE * out + SMALL * normal);
            piece.normals.push(normal.as_vec3());
            let index = |i: u32, j: u32| (i % AROUND) * SECTION + j % SECTION;
            let [a, b, c, d] = [index(i, j), index(i + 1, j), index(i + 1, j + 1), index(i, j + 1)];
            // The diagonals change sides, so that the tube has no hand.
            piece.triangles.extend(if (i + j) % 2 == 0 { [[a, b, c], [a, c, d]] } else { [[a, b, d], [b, c, d]] });
        }
    }
    let mut model = Model::default();
    model.add(piece);
    model
}
