//! How thick a solid is, place by place: what its particles have to be spaced by so that every part has two layers.
//!
//! From places spread over the surface a ray goes straight inwards until it is outside. Each place stands for the matter
//! under it, half as deep as the part is thick, so that the shares are shares of the volume; tips and rims weigh little.

use super::bvh::Bvh;
use super::solid::Solid;
use glam::DVec3;
use rayon::prelude::*;

/// Thicknesses of a solid.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Thickness {
    /// Thickness [m], the place where it was found, and the share of the matter that is no thicker; in rising order.
    places: Vec<(f64, DVec3, f64)>,
}

/// Places of the surface that are looked at.
const PLACES: usize = 3000;

/// Share of the extent that a ray begins beneath the surface, so that it does not meet its own face.
const BENEATH: f64 = 1e-9;

impl Thickness {
    /// Looks at a solid.
    pub(crate) fn of(solid: &Solid) -> Self {
        let (points, faces) = (&solid.surface.points, &solid.surface.faces);
        let corners = |face: usize| faces[face].map(|i| points[i as usize]);
        let bvh = Bvh::new(points, faces);
        let areas: Vec<f64> =
            (0..faces.len()).map(corners).map(|[a, b, c]| 0.5 * (b - a).cross(c - a).length()).collect();
        let total: f64 = areas.iter().sum();
        // The same distance of area apart, each at another place of its face.
        let mut chosen = Vec::with_capacity(PLACES);
        let mut passed = 0.0;
        for (face, area) in areas.iter().enumerate() {
            let first = (passed / total * PLACES as f64 + 0.5).floor() as usize;
            passed += area;
            let last = (passed / total * PLACES as f64 + 0.5).floor() as usize;
            chosen.extend((first..last.min(first + PLACES)).map(|k| (face, k)));
        }
        let beneath = BENEATH * solid.size().length();
        let found: Vec<(f64, DVec3)> = chosen
            .par_iter()
            .filter_map(|&(face, k)| {
                let [a, b, c] = corners(face);
                let [mut u, mut v] =
                    [0.618_033_988_749_895, 0.754_877_666_246_693].map(|step| (k as f64 * step).fract());
                if u + v > 1.0 {
                    (u, v) = (1.0 - u, 1.0 - v);
                }
                let inwards = -(b - a).cross(c - a).try_normalize()?;
                let place = a + u * (b - a) + v * (c - a);
                // Beneath a face that lies within another piece there is no skin of the matter.
                if solid.contains(place - 10.0 * beneath * inwards) {
                    return None;
                }
                leaves(points, faces, &bvh, place + beneath * inwards, inwards).map(|thickness| (thickness, place))
            })
            .collect();
        Self::sorted(found)
    }

    fn sorted(mut found: Vec<(f64, DVec3)>) -> Self {
        found.sort_by(|a, b| a.0.total_cmp(&b.0));
        let total: f64 = found.iter().map(|(thickness, _)| thickness).sum();
        let mut sum = 0.0;
        let places = found.into_iter().map(|(thickness, place)| {
            sum += thickness;
            (thickness, place, sum / total)
        });
        Self { places: places.collect() }
    }

    /// Thickness that all but this share of the matter has at least [m]; none where nothing was found.
    pub(crate) fn of_all_but(&self, share: f64) -> Option<f64> {
        let place = self.places.partition_point(|(.., below)| *below <= share);
        self.places.get(place).or(self.places.last()).map(|(thickness, ..)| *thickness)
    }

    /// Share of the matter that is thinner than this [m], and the middle of the thinnest place [m].
    pub(crate) fn thinner_than(&self, thickness: f64) -> Option<(f64, DVec3)> {
        let count = self.places.partition_point(|(found, ..)| *found < thickness);
        let (.., share) = self.places.get(count.checked_sub(1)?)?;
        Some((*share, self.places[0].1))
    }
}

/// How far a ray from just inside runs until the surface no longer turns around it; none if it gets out by a hole.
fn leaves(points: &[DVec3], faces: &[[u32; 3]], bvh: &Bvh, from: DVec3, along: DVec3) -> Option<f64> {
    let mut met: Vec<(f64, i32)> = Vec::new();
    bvh.visit(
        |node| meets(from, along, [node.min, node.max]),
        |face| {
            let [a, b, c] = faces[face as usize].map(|i| points[i as usize]);
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
    let mut depth = 1;
    for (distance, step) in met {
        depth += step;
        if depth <= 0 {
            return Some(distance);
        }
    }
    None
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

    fn solid(meshes: &[TriangleMesh]) -> Solid {
        let mut model = Model::default();
        for mesh in meshes {
            let (positions, triangles) = (mesh.positions.clone(), mesh.triangles.clone());
            model.add(MeshData { positions, triangles, ..MeshData::default() });
        }
        Solid::new(&model).expect("an inside")
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
        assert!((0.05..0.3).contains(&share) && place.x > 0.5, "{share} {place}");
        assert!(found.thinner_than(0.05).is_none());
    }
}
