//! A closed surface moved inwards along its normals, for as long as it stays the same surface on a smaller scale.

use super::bvh::Bvh;
use super::crossing::crossing_pairs;
use super::edges::Groups;
use glam::DVec3;

/// Outward unit normal of every point: the mean of the faces around it, weighted by their angles there, so that how a
/// surface is cut into triangles does not matter (Thürmer and Wüthrich 1998; Bærentzen and Aanæs 2005). Zero where the
/// faces leave no direction.
pub(crate) fn point_normals(points: &[DVec3], faces: &[[u32; 3]]) -> Vec<DVec3> {
    let mut normals = vec![DVec3::ZERO; points.len()];
    for &face in faces {
        let normal = area_vector(points, face).normalize_or_zero();
        for k in 0..3 {
            let [at, next, last] = [0, 1, 2].map(|turn| face[(k + turn) % 3] as usize);
            let (u, v) = (points[next] - points[at], points[last] - points[at]);
            normals[at] += u.cross(v).length().atan2(u.dot(v)) * normal;
        }
    }
    normals.iter().map(|normal| normal.normalize_or_zero()).collect()
}

/// A surface that cannot be moved inwards as far as was asked for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct InsideOut {
    /// Faces that would look the other way.
    pub turned: usize,
    /// Pairs of faces that would pass through each other.
    pub crossings: usize,
    /// Volume that would be left inside [m³].
    pub volume: f64,
    /// About the greatest distance that does [m]; none where hardly any does.
    pub greatest: Option<f64>,
}

/// The points moved inwards by `distance` [m] along their normals.
///
/// # Errors
/// [`InsideOut`] where a face would be turned over, faces pass through each other that did not before, or a piece of
/// the surface be turned inside out as a whole.
pub(crate) fn moved_inwards(points: &[DVec3], faces: &[[u32; 3]], distance: f64) -> Result<Vec<DVec3>, InsideOut> {
    let normals = point_normals(points, faces);
    let at = |distance: f64| -> Vec<DVec3> { points.iter().zip(&normals).map(|(&x, n)| x - distance * n).collect() };
    let crossings = |points: &[DVec3]| crossing_pairs(points, faces, &Bvh::new(points, faces)).len();
    let (crossed, pieces) = (crossings(points), pieces(points.len(), faces));
    let before = volumes(points, faces, &pieces);
    let sound = |moved: &[DVec3]| {
        let after = volumes(moved, faces, &pieces);
        turned_over(points, moved, faces) == 0
            && before.iter().zip(&after).all(|(&before, after)| before == 0.0 || before * after > 0.0)
            && crossings(moved) <= crossed
    };
    let moved = at(distance);
    if sound(&moved) {
        return Ok(moved);
    }
    let mut greatest = (1..HALVINGS).map(|power| distance * 0.5_f64.powi(power)).find(|&less| sound(&at(less)));
    if let Some(good) = &mut greatest {
        let mut bad = 2.0 * *good;
        while bad - *good > NEAR * *good {
            let middle = 0.5 * (*good + bad);
            *(if sound(&at(middle)) { &mut *good } else { &mut bad }) = middle;
        }
    }
    Err(InsideOut {
        turned: turned_over(points, &moved, faces),
        crossings: crossings(&moved),
        volume: volumes(&moved, faces, &pieces).iter().sum(),
        greatest,
    })
}

/// Halvings of a distance before none is taken to do, and how near the greatest one is looked for.
const HALVINGS: i32 = 20;
const NEAR: f64 = 2e-3;

/// Faces whose area vector no longer points to the side that it did; those without area have none to keep.
fn turned_over(points: &[DVec3], moved: &[DVec3], faces: &[[u32; 3]]) -> usize {
    let is_turned = |face: &&[u32; 3]| {
        let before = area_vector(points, **face);
        before != DVec3::ZERO && area_vector(moved, **face).dot(before) <= 0.0
    };
    faces.iter().filter(is_turned).count()
}

/// Twice the area of a face, along its normal [m²].
fn area_vector(points: &[DVec3], face: [u32; 3]) -> DVec3 {
    let [a, b, c] = face.map(|i| points[i as usize]);
    (b - a).cross(c - a)
}

/// The piece of every face; pieces share no point.
fn pieces(points: usize, faces: &[[u32; 3]]) -> Vec<u32> {
    let mut groups = Groups::new(points);
    for &[a, b, c] in faces {
        groups.join(a as usize, b as usize);
        groups.join(a as usize, c as usize);
    }
    let (labels, _) = groups.labels();
    faces.iter().map(|face| labels[face[0] as usize]).collect()
}

/// Signed volume of every piece [m³].
fn volumes(points: &[DVec3], faces: &[[u32; 3]], pieces: &[u32]) -> Vec<f64> {
    let origin = points.first().copied().unwrap_or_default();
    let corner = |i: u32| points[i as usize] - origin;
    let mut volumes = vec![0.0; pieces.iter().max().map_or(0, |&last| last as usize + 1)];
    for (&[a, b, c], &piece) in faces.iter().zip(pieces) {
        volumes[piece as usize] += corner(a).dot(corner(b).cross(corner(c))) / 6.0;
    }
    volumes
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::lattice::Cuboid;
    use crate::geometry::mesh::box_surface;
    use crate::geometry::octahedron::sphere;

    #[test]
    fn a_sphere_shrinks_about_its_centre() {
        let mesh = sphere(3);
        let moved = moved_inwards(&mesh.positions, &mesh.triangles, 0.4).unwrap();
        for (x, y) in mesh.positions.iter().zip(&moved) {
            assert!(y.distance(0.6 * *x) < 0.01, "{x} {y}");
        }
    }

    #[test]
    fn normals_of_a_box_do_not_depend_on_how_it_is_cut() {
        let mesh = box_surface(&Cuboid { center: DVec3::ZERO, size: DVec3::new(2.0, 3.0, 4.0) }, 1.0);
        for (x, normal) in mesh.positions.iter().zip(point_normals(&mesh.positions, &mesh.triangles)) {
            // Along the diagonal of all sides that the point lies on.
            let sides = DVec3::new(x.x, x.y / 1.5, x.z / 2.0);
            let expected = sides.to_array().map(|side| if side.abs() > 0.999 { side.signum() } else { 0.0 });
            assert!(normal.distance(DVec3::from_array(expected).normalize_or_zero()) < 1e-12, "{x}: {normal}");
        }
    }

    #[test]
    fn a_surface_that_would_turn_inside_out_is_refused_with_what_would_do() {
        // A sphere turns inside out at its centre; none of its faces looks another way beyond it.
        let mesh = sphere(1);
        for distance in [1.1, 1.5, 40.0] {
            let refusal = moved_inwards(&mesh.positions, &mesh.triangles, distance).unwrap_err();
            assert!(refusal.turned == 0 && refusal.volume <= 0.0, "{refusal:?}");
            let greatest = refusal.greatest.unwrap();
            assert!(greatest > 0.99 && greatest <= 1.0, "{refusal:?}");
            assert!(moved_inwards(&mesh.positions, &mesh.triangles, greatest).is_ok());
        }
        // The upper side of a plate passes through its lower one, though both still look the way they did.
        let plate = box_surface(&Cuboid { center: DVec3::ZERO, size: DVec3::new(4.0, 1.0, 4.0) }, 0.5);
        let refusal = moved_inwards(&plate.positions, &plate.triangles, 0.6).unwrap_err();
        assert!(refusal.crossings > 0 || refusal.turned > 0, "{refusal:?}");
        assert!(refusal.greatest.is_some_and(|greatest| greatest > 0.4 && greatest <= 0.5), "{refusal:?}");
    }

    #[test]
    fn a_small_piece_beside_a_large_one_counts_by_itself() {
        let (large, small) = (sphere(2), sphere(1));
        let mut points = large.positions.clone();
        points.extend(small.positions.iter().map(|&x| 0.1 * x + 3.0 * DVec3::X));
        let mut faces = large.triangles.clone();
        faces.extend(small.triangles.iter().map(|face| face.map(|i| i + large.positions.len() as u32)));
        let refusal = moved_inwards(&points, &faces, 0.2).unwrap_err();
        assert!(refusal.volume > 0.0 && refusal.greatest.unwrap() < 0.101, "{refusal:?}");
    }
}
