//! Things to be touched, each about its own origin: how far a point is from one, and where a way goes into it.

use super::obstacle_mesh::{Entry, Foot, ObstacleMesh};
use glam::DVec3;
use std::sync::Arc;

/// A thing to be touched, in its own frame.
#[derive(Clone, Debug)]
pub(crate) enum Obstacle {
    /// A ball of this radius [m].
    Ball(f64),
    /// A box of these half extents [m].
    Cuboid(DVec3),
    /// A cylinder along Y of this half length between two half balls [m].
    Capsule {
        /// Radius [m].
        radius: f64,
        /// Half the length of the cylinder [m].
        half: f64,
    },
    /// All below Y = 0.
    HalfSpace,
    /// A mesh.
    Mesh(Arc<ObstacleMesh>),
}

impl PartialEq for Obstacle {
    /// Meshes are equal where they have the same points and faces.
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Ball(a), Self::Ball(b)) => a == b,
            (Self::Cuboid(a), Self::Cuboid(b)) => a == b,
            (Self::Capsule { radius: a, half: c }, Self::Capsule { radius: b, half: d }) => (a, c) == (b, d),
            (Self::HalfSpace, Self::HalfSpace) => true,
            (Self::Mesh(a), Self::Mesh(b)) => {
                let same = || a.points() == b.points() && a.faces() == b.faces() && a.is_solid() == b.is_solid();
                Arc::ptr_eq(a, b) || same()
            }
            _ => false,
        }
    }
}

/// Steps in which the place where a way goes in is looked for. Few are needed but by a way that grazes: one that goes
/// less than a thousandth of its size into a round thing is not followed further.
const MOST_STEPS: u32 = 512;

impl Obstacle {
    /// Least and greatest corner [m].
    pub(crate) fn bounds(&self) -> [DVec3; 2] {
        match self {
            Self::Ball(radius) => [DVec3::splat(-radius), DVec3::splat(*radius)],
            Self::Cuboid(half) => [-*half, *half],
            Self::Capsule { radius, half } => {
                let greatest = DVec3::new(*radius, radius + half, *radius);
                [-greatest, greatest]
            }
            Self::HalfSpace => [DVec3::NEG_INFINITY, DVec3::INFINITY.with_y(0.0)],
            Self::Mesh(mesh) => mesh.bounds(),
        }
    }

    /// Whether it is a thin shell that is touched from both sides.
    pub(crate) fn is_shell(&self) -> bool {
        matches!(self, Self::Mesh(mesh) if !mesh.is_solid())
    }

    /// Where it is nearest to a point that is less than `reach` [m] outside of it, or inside; in a mesh not deeper than
    /// `deep` [m].
    pub(crate) fn foot(&self, x: DVec3, reach: f64, deep: f64) -> Option<Foot> {
        if let Self::Mesh(mesh) = self {
            let foot = mesh.foot(x, reach.max(deep))?;
            return (foot.gap < reach && foot.gap >= -deep).then_some(foot);
        }
        let foot = self.nearest(x);
        (foot.gap < reach).then_some(foot)
    }

    /// Where it is nearest to a point, if it is no mesh.
    fn nearest(&self, x: DVec3) -> Foot {
        match self {
            Self::Ball(radius) => around(x, *radius),
            Self::Capsule { radius, half } => around(x.with_y(x.y - x.y.clamp(-half, *half)), *radius),
            Self::Cuboid(half) => {
                let beyond = x.abs() - *half;
                let out = beyond.max(DVec3::ZERO);
                let distance = out.length();
                if distance > 0.0 {
                    return Foot { gap: distance, normal: out * x.signum() / distance };
                }
                let axis = beyond.max_position();
                let mut normal = DVec3::ZERO;
                normal[axis] = x[axis].signum();
                Foot { gap: beyond[axis], normal }
            }
            Self::HalfSpace | Self::Mesh(_) => Foot { gap: x.y, normal: DVec3::Y },
        }
    }

    /// Where the way between two points, the first of them outside, first goes in.
    pub(crate) fn entry(&self, from: DVec3, to: DVec3) -> Option<Entry> {
        if let Self::Mesh(mesh) = self {
            return mesh.entry(from, to);
        }
        let way = to - from;
        let length = way.length();
        let mut gone = 0.0;
        for _ in 0..MOST_STEPS {
            let Foot { gap, normal } = self.nearest(from + way * (gone / length));
            if gap <= 0.0 && gone == 0.0 {
                return None;
            }
            // No surface is nearer than the gap, so that this far the way is free.
            if gap <= 1e-9 * length {
                return (way.dot(normal) < 0.0).then_some(Entry { share: (gone / length).min(1.0), normal });
            }
            gone += gap;
            if gone > length {
                return None;
            }
        }
        None
    }
}

fn around(x: DVec3, radius: f64) -> Foot {
    let distance = x.length();
    Foot { gap: distance - radius, normal: if distance > 0.0 { x / distance } else { DVec3::Y } }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::lattice::Cuboid;
    use crate::geometry::mesh::box_surface;
    use crate::geometry::model::{MeshData, Model};

    fn mesh(positions: Vec<DVec3>, triangles: Vec<[u32; 3]>) -> Obstacle {
        let mut model = Model::default();
        model.add(MeshData { positions, triangles, ..MeshData::default() });
        Obstacle::Mesh(Arc::new(ObstacleMesh::new(&model).expect("a surface")))
    }

    fn places() -> impl Iterator<Item = DVec3> {
        (0..300).map(f64::from).map(|k| 2.0 * DVec3::new((1.3 * k).sin(), (2.1 * k).cos(), (0.7 * k).sin()))
    }

    #[test]
    fn gaps_are_distances_and_normals_their_gradients() {
        let box_mesh = box_surface(&Cuboid { center: DVec3::ZERO, size: DVec3::new(1.0, 2.0, 1.4) }, 0.3);
        let obstacles = [
            Obstacle::Ball(0.8),
            Obstacle::Cuboid(DVec3::new(0.5, 1.0, 0.7)),
            Obstacle::Capsule { radius: 0.4, half: 0.6 },
            Obstacle::HalfSpace,
            mesh(box_mesh.positions, box_mesh.triangles),
        ];
        for obstacle in &obstacles {
            let gap = |x: DVec3| obstacle.foot(x, 9.0, 9.0).expect("near").gap;
            let mut ill = 0;
            for x in places() {
                let foot = obstacle.foot(x, 9.0, 9.0).expect("near");
                let d = 1e-5;
                let slope = DVec3::from_array(DVec3::AXES.map(|e| (gap(x + d * e) - gap(x - d * e)) / (2.0 * d)));
                // Where two pieces are equally near there is no gradient.
                ill += i32::from(slope.distance(foot.normal) > 1e-4);
                assert!((foot.normal.length() - 1.0).abs() < 1e-12);
            }
            assert!(ill < 6, "{obstacle:?}: {ill}");
        }
        // The mesh of a box is that box.
        for x in places() {
            let [a, b] = [&obstacles[1], &obstacles[4]].map(|of| of.foot(x, 9.0, 9.0).expect("near").gap);
            assert!((a - b).abs() < 1e-9, "{x}: {a} {b}");
        }
    }

    #[test]
    fn ways_go_in_where_the_gap_is_nothing() {
        let box_mesh = box_surface(&Cuboid { center: DVec3::ZERO, size: DVec3::new(1.0, 2.0, 1.4) }, 0.3);
        let solids = [
            Obstacle::Ball(0.8),
            Obstacle::Cuboid(DVec3::new(0.5, 1.0, 0.7)),
            Obstacle::Capsule { radius: 0.4, half: 0.6 },
            mesh(box_mesh.positions, box_mesh.triangles),
        ];
        for obstacle in &solids {
            let mut met = 0;
            for x in places() {
                let from = 6.0 * x.normalize_or(DVec3::X);
                let to = -from + 0.4 * DVec3::new(x.y, x.z, x.x);
                let gap = |share: f64| obstacle.foot(from.lerp(to, share), 99.0, 99.0).expect("near").gap;
                let least = (0..=2000).map(|k| gap(f64::from(k) / 2000.0)).fold(f64::INFINITY, f64::min);
                if let Some(entry) = obstacle.entry(from, to) {
                    met += 1;
                    assert!(gap(entry.share).abs() < 1e-6, "{obstacle:?}: {}", gap(entry.share));
                    assert!(entry.normal.dot(to - from) < 0.0);
                } else {
                    assert!(least > -1e-3, "{obstacle:?}: {least}");
                }
            }
            assert!(met > 100, "{met}");
        }
    }

    #[test]
    fn a_shell_has_two_sides_and_is_met_from_both() {
        let shell = mesh(vec![DVec3::ZERO, DVec3::Z, DVec3::X], vec![[0, 1, 2]]);
        assert!(shell.is_shell());
        for side in [1.0, -1.0] {
            let above = DVec3::new(0.2, 0.1 * side, 0.3);
            let foot = shell.foot(above, 1.0, 1.0).expect("near");
            assert!((foot.gap - 0.1).abs() < 1e-12 && foot.normal == side * DVec3::Y);
            let entry = shell.entry(above, above.with_y(-3.0 * side)).expect("a way through");
            assert!((entry.share - 0.1 / 3.1).abs() < 1e-9 && entry.normal == side * DVec3::Y);
        }
        assert_eq!(shell.entry(DVec3::new(0.9, 1.0, 0.9), DVec3::new(0.9, -1.0, 0.9)), None);
    }
}
