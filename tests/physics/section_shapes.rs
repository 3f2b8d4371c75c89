//! Sections of rods: what they look like, what theory says of them, and how a rod lies to the lattice.

use crate::common::D;
use glam::{DMat3, DVec3};
use sinew::geometry::TriangleMesh;

/// What a section looks like; its size is that of its thinnest part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// A box, by the lattice that it asks for.
    Square,
    Round,
    /// Two arms as wide as they are thick, at a right angle.
    L,
    /// Three times as wide as its wall is thick.
    Tube,
    /// Four times as wide as it is thick.
    Leaf,
}

/// How a rod lies to the lattice: not turned, about its own axis, or that axis itself.
#[derive(Clone, Copy, Debug)]
pub enum Turned {
    Not,
    About(f64),
    Askew(f64),
}

impl Turned {
    pub fn rotation(self) -> DMat3 {
        match self {
            Self::Not => DMat3::IDENTITY,
            Self::About(degrees) => DMat3::from_rotation_x(degrees.to_radians()),
            Self::Askew(degrees) => DMat3::from_rotation_z(degrees.to_radians()),
        }
    }
}

/// Corners of a section in layers, counter-clockwise in y and z, with as many inside that a hole turns around.
fn outline(kind: Kind, t: f64) -> (Vec<[f64; 2]>, Vec<[f64; 2]>) {
    let ring = |radius: f64| -> Vec<[f64; 2]> {
        let angle = |k: i32| std::f64::consts::TAU * (f64::from(k) + 0.5) / 72.0;
        // As large as the circle, not within it.
        let out = radius * (std::f64::consts::TAU / 72.0 / (std::f64::consts::TAU / 72.0).sin()).sqrt();
        (0..72).map(|k| [out * angle(k).cos(), out * angle(k).sin()]).collect()
    };
    let boxed =
        |w: f64, h: f64| vec![[-0.5 * w, -0.5 * h], [0.5 * w, -0.5 * h], [0.5 * w, 0.5 * h], [-0.5 * w, 0.5 * h]];
    match kind {
        Kind::Square => (boxed(t, t), Vec::new()),
        Kind::Round => (ring(0.5 * t), Vec::new()),
        Kind::L => (vec![[-t, -t], [t, -t], [t, 0.0], [0.0, 0.0], [0.0, t], [-t, t]], Vec::new()),
        Kind::Tube => (ring(1.5 * t), ring(0.5 * t)),
        Kind::Leaf => (boxed(4.0 * t, t), Vec::new()),
    }
}

/// What theory says of a section of unit size: area, both second moments about its principal axes, the first of which
/// is turned by an angle from y, centre, and J.
pub struct Theory {
    pub area: f64,
    pub bending: [f64; 2],
    pub principal: f64,
    pub center: [f64; 2],
    pub torsion: f64,
    pub width: f64,
}

pub fn theory(kind: Kind) -> Theory {
    use std::f64::consts::PI;
    let plain =
        |area, bending, torsion, width| Theory { area, bending, principal: 0.0, center: [0.0; 2], torsion, width };
    match kind {
        Kind::Square => plain(1.0, [1.0 / 12.0; 2], 0.140_577, 1.0),
        Kind::Round => plain(PI / 4.0, [PI / 64.0; 2], PI / 32.0, 1.0),
        Kind::Tube => plain(
            2.0 * PI,
            [PI / 4.0 * (1.5_f64.powi(4) - 0.5_f64.powi(4)); 2],
            PI / 2.0 * (1.5_f64.powi(4) - 0.5_f64.powi(4)),
            3.0,
        ),
        Kind::Leaf => plain(4.0, [4.0 / 12.0, 64.0 / 12.0], 1.123_252, 4.0),
        // A square of two less one of one; about the diagonal and across it. J by finite differences of Prandtl's
        // function.
        Kind::L => {
            let center = -1.0 / 6.0;
            let about = 4.0 / 3.0 - 1.0 / 3.0 - 3.0 * center * center;
            let mixed = -0.25 - 3.0 * center * center;
            let bending = [about - mixed, about + mixed];
            Theory { area: 3.0, bending, principal: 45.0, center: [center; 2], torsion: 0.856_3, width: 2.0 }
        }
    }
}

/// A rod along x with its section's corners as given, and its ends.
pub fn prism(kind: Kind, t: f64, length: f64, turn: DMat3) -> TriangleMesh {
    let (outer, hole) = outline(kind, t);
    let at = |x: f64, [y, z]: [f64; 2]| turn * (D * DVec3::new(x, y, z));
    let mut mesh = TriangleMesh { positions: Vec::new(), triangles: Vec::new() };
    let ends = [-0.5 * length, 0.5 * length];
    let mut rings = Vec::new();
    for (outline, out) in [(&outer, true), (&hole, false)].into_iter().filter(|(outline, _)| !outline.is_empty()) {
        let n = outline.len() as u32;
        let first = mesh.positions.len() as u32;
        rings.push((first, n));
        for x in ends {
            mesh.positions.extend(outline.iter().map(|&corner| at(x, corner)));
        }
        for k in 0..n {
            let [a, b, c, d] = [k, (k + 1) % n, n + (k + 1) % n, n + k].map(|i| first + i);
            let faces = if out { [[a, c, b], [a, d, c]] } else { [[a, b, c], [a, c, d]] };
            mesh.triangles.extend(faces);
        }
    }
    let mut cap = |faces: &[[u32; 3]], [near, far]: [u32; 2]| {
        for &[a, b, c] in faces {
            mesh.triangles.push([near + a, near + b, near + c]);
            mesh.triangles.push([far + a, far + c, far + b]);
        }
    };
    match rings[..] {
        [(_, n)] if kind == Kind::L => cap(&[[0, 2, 1], [0, 3, 2], [0, 4, 3], [0, 5, 4]], [0, n]),
        [(_, n)] => cap(&(1..n - 1).map(|k| [0, k + 1, k]).collect::<Vec<_>>(), [0, n]),
        _ => {
            let n = rings[0].1;
            for k in 0..n {
                let next = (k + 1) % n;
                cap(&[[k, 2 * n + next, next], [k, 2 * n + k, 2 * n + next]], [0, n]);
            }
        }
    }
    mesh
}
