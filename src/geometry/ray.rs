//! Where a ray meets a mesh.

use glam::DVec3;

/// Where a ray meets a mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Hit {
    /// Index of the face.
    pub triangle: usize,
    /// Distance along the ray in lengths of its direction.
    pub distance: f64,
}

/// The face that a ray from `origin` along `direction` meets first; every face is tried, from either side.
pub(crate) fn nearest_hit(positions: &[DVec3], triangles: &[[u32; 3]], origin: DVec3, direction: DVec3) -> Option<Hit> {
    let mut nearest: Option<Hit> = None;
    for (triangle, corners) in triangles.iter().enumerate() {
        let [a, b, c] = corners.map(|i| positions[i as usize]);
        // Möller and Trumbore 1997: barycentric coordinates by Cramer's rule.
        let (ab, ac) = (b - a, c - a);
        let across = direction.cross(ac);
        let determinant = ab.dot(across);
        if determinant == 0.0 {
            continue;
        }
        let from = origin - a;
        let u = from.dot(across) / determinant;
        let turned = from.cross(ab);
        let v = direction.dot(turned) / determinant;
        let distance = ac.dot(turned) / determinant;
        let inside = u >= 0.0 && v >= 0.0 && u + v <= 1.0 && distance > 0.0;
        if inside && nearest.is_none_or(|hit| distance < hit.distance) {
            nearest = Some(Hit { triangle, distance });
        }
    }
    nearest
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Cuboid, box_surface};

    #[test]
    fn a_ray_meets_the_nearer_of_two_faces() {
        let shape = Cuboid { center: DVec3::ZERO, size: DVec3::ONE };
        let mesh = box_surface(&shape, 0.25);
        let origin = DVec3::new(0.1, 0.2, 5.0);
        let hit = nearest_hit(&mesh.positions, &mesh.triangles, origin, DVec3::NEG_Z).unwrap();
        assert!((hit.distance - 4.5).abs() < 1e-12);
        let corners = mesh.triangles[hit.triangle].map(|i| mesh.positions[i as usize]);
        assert!(corners.iter().all(|corner| corner.z == 0.5));
        assert!(nearest_hit(&mesh.positions, &mesh.triangles, origin, DVec3::Z).is_none());
        assert!(nearest_hit(&mesh.positions, &mesh.triangles, DVec3::new(0.6, 0.0, 5.0), DVec3::NEG_Z).is_none());
    }
}
