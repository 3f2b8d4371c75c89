//! Smooth normals.

use glam::Vec3;

/// Unit normals of a mesh's vertices: those of the faces around, weighed by their angle there, so that the way a
/// surface was cut into triangles does not show (Thürmer and Wüthrich 1998). Up where no face has a normal.
pub fn smooth_normals(positions: &[Vec3], triangles: &[[u32; 3]]) -> Vec<Vec3> {
    let mut sums = vec![Vec3::ZERO; positions.len()];
    for triangle in triangles {
        let corners = triangle.map(|k| positions[k as usize]);
        let Some(normal) = (corners[1] - corners[0]).cross(corners[2] - corners[0]).try_normalize() else { continue };
        for k in 0..3 {
            let (to_next, to_last) = (corners[(k + 1) % 3] - corners[k], corners[(k + 2) % 3] - corners[k]);
            sums[triangle[k] as usize] += normal * to_next.angle_between(to_last);
        }
    }
    sums.into_iter().map(|sum| sum.try_normalize().unwrap_or(Vec3::Y)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::lattice::Cuboid;
    use crate::geometry::mesh::box_surface;
    use glam::DVec3;

    #[test]
    fn the_corners_of_a_cube_point_along_its_diagonals_however_it_is_cut() {
        let mesh = box_surface(&Cuboid { center: DVec3::ZERO, size: DVec3::ONE }, 0.5);
        let positions: Vec<Vec3> = mesh.positions.iter().map(|point| point.as_vec3()).collect();
        let normals = smooth_normals(&positions, &mesh.triangles);
        for (position, normal) in positions.iter().zip(&normals) {
            assert!((position.normalize() - *normal).length() < 1e-5, "{position} {normal}");
        }
    }

    #[test]
    fn faces_without_area_have_no_say() {
        let normals = smooth_normals(&[Vec3::ZERO; 3], &[[0, 1, 2]]);
        assert_eq!(normals, [Vec3::Y; 3]);
    }
}
