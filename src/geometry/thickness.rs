//! How thick a solid is, place by place: what its particles have to be spaced by so that every part has two layers.
//!
//! Looked at are points spread evenly through the volume, so that shares of them are shares of the matter. At each the
//! thickness is the way through it along the normal of the nearest surface, or along that which is the nearest one's at
//! the middle of this way, where that is less: near the rim of a plate the nearest surface is the rim, from which the
//! way runs through the whole of it, but at the middle of that way it is the plate's.

use super::bvh::Bvh;
use super::inside::spread;
use super::nearest::{nearest_face, nearest_face_within};
use super::solid::Solid;
use glam::DVec3;
use rayon::prelude::*;

/// Thicknesses of a solid.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Thickness {
    /// Thickness [m], the nearest place of the surface, and the share of the matter that is no thicker; in rising
    /// order.
    places: Vec<(f64, DVec3, f64)>,
}

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

impl Thickness {
    /// Looks at a solid.
    pub(crate) fn of(solid: &Solid) -> Self {
        let surface = Surface::of(solid);
        let points = points_inside(solid);
        let mut found: Vec<(f64, DVec3)> = points.par_iter().filter_map(|&point| surface.thickness(point)).collect();
        found.sort_by(|a, b| a.0.total_cmp(&b.0));
        let count = found.len() as f64;
        let place = |(k, (thickness, place)): (usize, (f64, DVec3))| (thickness, place, (k + 1) as f64 / count);
        Self { places: found.into_iter().enumerate().map(place).collect() }
    }

    /// Thickness that all but this share of the matter has at least [m]; none where nothing was found.
    pub(crate) fn of_all_but(&self, share: f64) -> Option<f64> {
        let place = self.places.partition_point(|(.., below)| *below <= share);
        self.places.get(place).or(self.places.last()).map(|(thickness, ..)| *thickness)
    }

    /// Share of the matter that is thinner than this [m], and where the surface is nearest to the thinnest of it [m].
    pub(crate) fn thinner_than(&self, thickness: f64) -> Option<(f64, DVec3)> {
        let count = self.places.partition_point(|(found, ..)| *found < thickness);
        let (.., share) = self.places.get(count.checked_sub(1)?)?;
        Some((*share, self.places[0].1))
    }
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
    points: &'a [DVec3],
    faces: &'a [[u32; 3]],
    bvh: Bvh,
    /// Those that are not within another piece.
    skin: Vec<[u32; 3]>,
    skin_bvh: Bvh,
}

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
        let skin: Vec<[u32; 3]> =
            if shares { faces.par_iter().filter(is_skin).copied().collect() } else { faces.to_vec() };
        let [bvh, skin_bvh] = [faces, skin.as_slice()].map(|faces| Bvh::new(points, faces));
        Self { points, faces, bvh, skin, skin_bvh }
    }

    /// How thick the matter around a point is [m], and the nearest place of the surface [m]; none where the ways out
    /// run through a hole.
    fn thickness(&self, point: DVec3) -> Option<(f64, DVec3)> {
        let (along, place) = self.normal(point)?;
        let [ahead, back] = self.through(point, along)?;
        // At the middle of a ball or along the axis of a bar all faces are equally near: none counts but one that is
        // nearer.
        let nearer = NEARER * 0.5 * (ahead + back);
        let middle = point + 0.5 * (ahead - back) * along;
        let across = nearest_face_within(self.points, &self.skin, &self.skin_bvh, middle, nearer);
        let across = across.and_then(|(.., place)| (middle - place).try_normalize());
        let across = across.and_then(|across| self.through(point, across));
        let way = across.map_or(f64::INFINITY, |[ahead, back]| ahead + back);
        Some((way.min(ahead + back), place))
    }

    /// The direction from the nearest place of the surface to a point inside, and that place [m].
    fn normal(&self, point: DVec3) -> Option<(DVec3, DVec3)> {
        let (_, _, place) = nearest_face(self.points, &self.skin, &self.skin_bvh, point)?;
        Some(((point - place).try_normalize()?, place))
    }

    /// The ways out from a point in a direction and against it [m].
    fn through(&self, point: DVec3, along: DVec3) -> Option<[f64; 2]> {
        Some([self.leaves(point, along)?, self.leaves(point, -along)?])
    }

    /// How far a ray from a point inside runs until the surface no longer turns around it; none if it gets out by a
    /// hole.
    fn leaves(&self, from: DVec3, along: DVec3) -> Option<f64> {
        let mut met: Vec<(f64, i32)> = Vec::new();
        self.bvh.visit(
            |node| meets(from, along, [node.min, node.max]),
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
                if u >= 0.0 && v >= 0.0 && u + v <= 1.0 && distance > 0.0 {
                    // Seen from its outside the face turns counter-clockwise, and the ray enters.
                    met.push((distance, if determinant > 0.0 { 1 } else { -1 }));
                }
            },
        );
        met.sort_by(|a, b| a.0.total_cmp(&b.0).then(b.1.cmp(&a.1)));
        // As often as it leaves in the end.
        let mut depth = -met.iter().map(|(_, step)| step).sum::<i32>();
        // Between the two faces of an edge a ray may meet both or none.
        depth = depth.max(1);
        for (distance, step) in met {
            depth += step;
            if depth <= 0 {
                return Some(distance);
            }
        }
        None
    }
}

/// Whether a ray comes through a box.
fn meets(from: DVec3, along: DVec3, [min, max]: [DVec3; 2]) -> bool {
    let (mut enters, mut exits) = (0.0_f64, f64::INFINITY);
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
        Thickness::of(&solid(meshes)).thinner_than(thickness).map_or(0.0, |(share, _)| share)
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
        let found = Thickness::of(&solid(&[block, box_surface(&plate, 0.25)]));
        let thin = found.of_all_but(0.01).unwrap();
        assert!((thin - 0.1).abs() < 1e-6, "{thin}");
        assert!(found.of_all_but(0.7).unwrap() > 0.9);
        let (share, place) = found.thinner_than(0.2).unwrap();
        assert!((share - 0.16).abs() < 0.02 && place.x > 0.4, "{share} {place}");
        assert!(found.thinner_than(0.05).is_none());
    }
}
