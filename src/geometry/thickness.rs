//! How thick a solid is, place by place: what its particles have to be spaced by so that every part has two layers.
//!
//! Looked at are points spread evenly through the volume, so that shares of them are shares of the matter. At each the
//! thickness is the way through it along the normal of the nearest surface, or along that which is the nearest one's at
//! the middle of this way, where that is less: near the rim of a plate the nearest surface is the rim, from which the
//! way runs through the whole of it, but at the middle of that way it is the plate's.

use super::bvh::Bvh;
use super::inside::spread;
use super::missed::MissedPlace;
use super::nearest::nearest_face_by;
use super::slabs::Slabs;
use super::solid::Solid;
use super::thickness_shares::Thickness;
use glam::DVec3;
use rayon::prelude::*;

/// Points that are looked at, about.
const POINTS: f64 = 3000.0;

/// Rows on which they lie, in all and in each box around pieces at least; boxes that are looked at, at most.
const ROWS: usize = 1600;
const LEAST_ROWS: usize = 4;
const MOST_BOXES: usize = 2000;

/// Share of half the way through at which a face at its middle counts as nearer than those at its ends.
const NEARER: f64 = 0.95;

/// Share of the extent beyond a face at which it is looked whether that lies in another piece.
const BEYOND: f64 = 1e-8;

impl Solid {
    /// How thick it is, looked at once.
    pub(crate) fn thickness(&self) -> &Thickness {
        self.known_thickness.get_or_init(|| looked_at(self))
    }

    /// How thick it is below a place of its surface, straight inwards [m]; none where the way out runs through a hole.
    pub(crate) fn thickness_below(&self, places: &[MissedPlace]) -> Vec<f64> {
        if places.is_empty() {
            return Vec::new();
        }
        let surface = Surface::of(self);
        let inside = BEYOND * self.size().length();
        let below = |place: &MissedPlace| {
            let point = place.at - inside * place.outwards;
            let from = Inner { point, turns: self.turns_around(point), near: f64::INFINITY };
            surface.leaves(&from, -place.outwards).map(|way| way + inside)
        };
        places.par_iter().filter_map(below).collect()
    }
}

fn looked_at(solid: &Solid) -> Thickness {
    let surface = Surface::of(solid);
    let points = points_inside(solid);
    Thickness::new(points.par_iter().filter_map(|&point| surface.thickness(point)).collect())
}

/// Points spread evenly through the volume.
fn points_inside(solid: &Solid) -> Vec<DVec3> {
    let boxes: Vec<[DVec3; 2]> = solid.boxes().collect();
    let chosen: Vec<[DVec3; 2]> = boxes.iter().step_by(boxes.len().div_ceil(MOST_BOXES).max(1)).copied().collect();
    let rows_each = (ROWS / chosen.len().max(1)).max(LEAST_ROWS);
    // Stretches inside, and the area for which the row stands.
    let rows: Vec<(DVec3, f64, Vec<[f64; 2]>)> = (0..rows_each * chosen.len())
        .into_par_iter()
        .map(|k| {
            let [min, max] = chosen[k / rows_each];
            let share = spread(k % rows_each);
            let at = DVec3::new(0.0, min.y + (max.y - min.y) * share[0], min.z + (max.z - min.z) * share[1]);
            let area = (max.y - min.y) * (max.z - min.z) / rows_each as f64;
            // What lies in another box is looked at there.
            let within = |[from, to]: [f64; 2]| [from.max(min.x), to.min(max.x)];
            let inside = solid.scanline_within([at.y, at.z], [min.x, max.x]);
            (at, area, inside.into_iter().map(within).filter(|[from, to]| from < to).collect())
        })
        .collect();
    let volume: f64 = rows.iter().flat_map(|(_, area, inside)| inside.iter().map(move |[a, b]| area * (b - a))).sum();
    let step = volume / POINTS;
    let mut points = Vec::with_capacity(POINTS as usize + 1);
    let (mut passed, mut next) = (0.0, 0.5 * step);
    for (at, area, inside) in &rows {
        for [from, to] in inside {
            let end = passed + area * (to - from);
            while next < end {
                points.push(at.with_x(from + (next - passed) / area));
                next += step;
            }
            passed = end;
        }
    }
    points
}

/// The surface of a solid.
struct Surface<'a> {
    solid: &'a Solid,
    points: &'a [DVec3],
    faces: &'a [[u32; 3]],
    bvh: Bvh,
    /// Those that are not within another piece, where some are.
    skin: Option<(Vec<[u32; 3]>, Bvh)>,
    /// Of the leaves of the skin.
    slabs: Slabs,
}

/// How far a ray is looked along at first, in distances from the surface, and by how much further then.
const AHEAD: f64 = 4.0;

impl<'a> Surface<'a> {
    fn of(solid: &'a Solid) -> Self {
        let (points, faces) = (solid.surface.points.as_slice(), solid.surface.faces.as_slice());
        let beyond = BEYOND * solid.size().length();
        let is_skin = |face: &&[u32; 3]| {
            let [a, b, c] = face.map(|i| points[i as usize]);
            let outwards = (b - a).cross(c - a).normalize_or_zero();
            !solid.contains((a + b + c) / 3.0 + beyond * outwards)
        };
        let shares = solid.report.closed && (solid.report.pieces > 1 || solid.report.crossings > 0);
        let skin = shares.then(|| {
            let skin: Vec<[u32; 3]> = faces.par_iter().filter(is_skin).copied().collect();
            let bvh = Bvh::new(points, &skin);
            (skin, bvh)
        });
        let bvh = Bvh::new(points, faces);
        let slabs =
            skin.as_ref().map_or_else(|| Slabs::new(points, faces, &bvh), |(skin, bvh)| Slabs::new(points, skin, bvh));
        Self { solid, points, faces, bvh, skin, slabs }
    }

    /// The nearest place of what is not within another piece, if it is nearer than a distance [m].
    fn nearest(&self, x: DVec3, within: f64) -> Option<DVec3> {
        let (skin, bvh) = self.skin.as_ref().map_or((self.faces, &self.bvh), |(faces, bvh)| (faces, bvh));
        nearest_face_by(self.points, skin, (bvh, Some(&self.slabs)), x, within).map(|(.., place)| place)
    }

    /// How thick the matter around a point is [m], and the nearest place of the surface [m]; none where the ways out
    /// run through a hole.
    fn thickness(&self, point: DVec3) -> Option<(f64, DVec3)> {
        let place = self.nearest(point, f64::INFINITY)?;
        let along = (point - place).try_normalize()?;
        let from = Inner { point, turns: self.solid.turns_around(point), near: AHEAD * point.distance(place) };
        let [ahead, back] = self.through(&from, along)?;
        // At the middle of a ball or along the axis of a bar all faces are equally near: none counts but one that is
        // nearer.
        let nearer = NEARER * 0.5 * (ahead + back);
        let middle = point + 0.5 * (ahead - back) * along;
        let across = self.nearest(middle, nearer).and_then(|place| (middle - place).try_normalize());
        let across = across.and_then(|across| self.through(&from, across));
        let way = across.map_or(f64::INFINITY, |[ahead, back]| ahead + back);
        Some((way.min(ahead + back), place))
    }

    /// The ways out from a point in a direction and against it [m].
    fn through(&self, from: &Inner, along: DVec3) -> Option<[f64; 2]> {
        Some([self.leaves(from, along)?, self.leaves(from, -along)?])
    }

    /// How far a ray from a point inside runs until the surface no longer turns around it; none if it gets out by a
    /// hole. Where it is known how often it does at the point hardly any ray is followed to its end.
    fn leaves(&self, from: &Inner, along: DVec3) -> Option<f64> {
        let mut reach = if from.turns.is_some() { from.near } else { f64::INFINITY };
        loop {
            let mut met = self.met(from.point, along, reach);
            met.sort_by(|a, b| a.0.total_cmp(&b.0).then(b.1.cmp(&a.1)));
            // As often as it leaves in the end. Between the two faces of an edge a ray may meet both or none.
            let in_the_end = || -met.iter().map(|(_, step)| step).sum::<i32>();
            let mut depth = from.turns.unwrap_or_else(in_the_end).max(1);
            for (distance, step) in &met {
                depth += step;
                if depth <= 0 {
                    return Some(*distance);
                }
            }
            if reach == f64::INFINITY {
                return None;
            }
            reach = if reach > self.solid.size().length() { f64::INFINITY } else { AHEAD * reach };
        }
    }

    /// Faces that a ray meets up to a distance [m]: where, and 1 where it enters there or -1 where it leaves.
    fn met(&self, from: DVec3, along: DVec3, reach: f64) -> Vec<(f64, i32)> {
        let mut met: Vec<(f64, i32)> = Vec::new();
        self.bvh.visit(
            |node| meets(from, along, reach, [node.min, node.max]),
            |face| {
                let [a, b, c] = self.faces[face as usize].map(|i| self.points[i as usize]);
                let (ab, ac) = (b - a, c - a);
                let across = along.cross(ac);
                let determinant = ab.dot(across);
                if determinant == 0.0 {
                    return;
                }
                let to = from - a;
                let u = to.dot(across) / determinant;
                let turned = to.cross(ab);
                let v = along.dot(turned) / determinant;
                let distance = ac.dot(turned) / determinant;
                if u >= 0.0 && v >= 0.0 && u + v <= 1.0 && distance > 0.0 && distance <= reach {
                    // Seen from its outside the face turns counter-clockwise, and the ray enters.
                    met.push((distance, if determinant > 0.0 { 1 } else { -1 }));
                }
            },
        );
        met
    }
}

/// A point inside.
struct Inner {
    point: DVec3,
    /// How often the surface turns around it, where that is known.
    turns: Option<i32>,
    /// How far a ray from it is looked along at first [m].
    near: f64,
}

/// Whether a ray comes through a box before a distance [m].
fn meets(from: DVec3, along: DVec3, reach: f64, [min, max]: [DVec3; 2]) -> bool {
    let (mut enters, mut exits) = (0.0_f64, reach);
    for axis in 0..3 {
        let (near, far) = (min[axis] - from[axis], max[axis] - from[axis]);
        if along[axis] != 0.0 {
            let (near, far) = (near / along[axis], far / along[axis]);
            (enters, exits) = (enters.max(near.min(far)), exits.min(near.max(far)));
        } else if near > 0.0 || far < 0.0 {
            return false;
        }
    }
    enters <= exits
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::lattice::Cuboid;
    use crate::geometry::mesh::{TriangleMesh, box_surface};
    use crate::geometry::model::{MeshData, Model};
    use glam::DMat3;
    use std::slice;

    fn solid(meshes: &[TriangleMesh]) -> Solid {
        let mut model = Model::default();
        for mesh in meshes {
            let (positions, triangles) = (mesh.positions.clone(), mesh.triangles.clone());
            model.add(MeshData { positions, triangles, ..MeshData::default() });
        }
        Solid::new(&model).expect("an inside")
    }

    fn boxed(center: [f64; 3], size: [f64; 3]) -> TriangleMesh {
        let shape = Cuboid { center: DVec3::from_array(center), size: DVec3::from_array(size) };
        box_surface(&shape, 0.25 * size.iter().copied().fold(0.0, f64::max))
    }

    fn turned(mut mesh: TriangleMesh) -> TriangleMesh {
        let turn = DMat3::from_axis_angle(DVec3::new(1.0, -2.0, 0.5).normalize_or_zero(), 0.8);
        mesh.positions.iter_mut().for_each(|x| *x = turn * *x);
        mesh
    }

    /// A tube around the z axis.
    fn tube(radius: f64, wall: f64, length: f64) -> TriangleMesh {
        let sides = 64;
        let rings = [(radius, 0.0), (radius, length), (radius - wall, length), (radius - wall, 0.0)];
        let at = |k: u32| {
            let (sine, cosine) = (std::f64::consts::TAU * f64::from(k / 4) / f64::from(sides)).sin_cos();
            let (radius, z) = rings[k as usize % 4];
            DVec3::new(radius * cosine, radius * sine, z)
        };
        let quads = (0..4 * sides).map(|k| {
            let (next, above) = ((k + 4) % (4 * sides), k / 4 * 4 + (k + 1) % 4);
            [k, next, next / 4 * 4 + (next + 1) % 4, above]
        });
        let triangles = quads.flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
        TriangleMesh { positions: (0..4 * sides).map(at).collect(), triangles }
    }

    fn share(meshes: &[TriangleMesh], thickness: f64) -> f64 {
        solid(meshes).thickness().thinner_than(thickness).map_or(0.0, |(share, _)| share)
    }

    #[test]
    fn all_of_what_is_thin_counts_and_nothing_of_what_is_not() {
        for (name, mesh, thickness) in [
            ("plate", boxed([0.0; 3], [1.0, 0.05, 0.7]), 0.05),
            ("bar", boxed([0.0; 3], [0.1, 2.0, 0.2]), 0.1),
            ("thin tube", tube(0.5, 0.02, 2.0), 0.02),
            ("short tube", tube(0.5, 0.1, 0.3), 0.1),
            ("cube", boxed([0.0; 3], [1.0; 3]), 1.0),
        ] {
            for mesh in [turned(mesh.clone()), mesh] {
                let (less, more) =
                    (share(slice::from_ref(&mesh), 0.95 * thickness), share(slice::from_ref(&mesh), 1.05 * thickness));
                assert!(less < 0.02 && more > 0.97, "{name}: {less} below {thickness} m, {more} up to it");
            }
        }
    }

    #[test]
    fn mixtures_count_by_their_volumes() {
        let block = || boxed([0.0; 3], [1.0; 3]);
        // A plate beside a block; one that sticks out of it; a bar and a tube far from it.
        let beside = boxed([3.0, 0.0, 0.0], [2.0, 0.1, 1.0]);
        let out = boxed([1.4, 0.0, 0.0], [2.0, 0.1, 1.0]);
        let bar = boxed([4.0, 0.0, 0.0], [0.1, 0.1, 5.0]);
        let tube = tube(4.0, 0.05, 0.5);
        let of_tube = solid(slice::from_ref(&tube)).volume;
        for (name, meshes, thin) in [
            ("plate beside", vec![block(), beside], 0.2 / 1.2),
            ("plate out of it", vec![block(), out], 0.19 / 1.19),
            ("bar", vec![block(), bar], 0.05 / 1.05),
            ("tube around", vec![block(), tube], of_tube / (1.0 + of_tube)),
        ] {
            let found = share(&meshes, 0.2);
            assert!((found - thin).abs() < 0.02, "{name}: {found} instead of {thin}");
            let moved: Vec<TriangleMesh> = meshes.into_iter().map(turned).collect();
            let found = share(&moved, 0.2);
            assert!((found - thin).abs() < 0.02, "{name}, turned: {found} instead of {thin}");
        }
    }

    #[test]
    fn a_plate_on_a_block_is_as_thick_as_it_is() {
        let block = box_surface(&Cuboid { center: DVec3::ZERO, size: DVec3::ONE }, 0.25);
        // Sunk into the block, out of which most of it sticks.
        let plate = Cuboid { center: DVec3::new(1.4, 0.0, 0.0), size: DVec3::new(2.0, 0.1, 1.0) };
        let solid = solid(&[block, box_surface(&plate, 0.25)]);
        let found = solid.thickness();
        let thin = found.of_all_but(0.01).unwrap();
        assert!((thin - 0.1).abs() < 1e-6, "{thin}");
        assert!(found.of_all_but(0.7).unwrap() > 0.9);
        let (share, place) = found.thinner_than(0.2).unwrap();
        assert!((share - 0.16).abs() < 0.02 && place.x > 0.4, "{share} {place}");
        assert!(found.thinner_than(0.05).is_none());
    }
}
