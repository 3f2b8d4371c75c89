//! Triangle meshes.

use super::lattice::Cuboid;
use glam::DVec3;
use std::collections::HashMap;

/// A triangle mesh; faces turn counter-clockwise seen from outside.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TriangleMesh {
    /// Vertex positions [m].
    pub positions: Vec<DVec3>,
    /// Vertex indices of each face.
    pub triangles: Vec<[u32; 3]>,
}

/// Closed surface of a box, divided into squares of about `edge` [m], so that it can bend with what it encloses.
pub fn box_surface(shape: &Cuboid, edge: f64) -> TriangleMesh {
    let cells = (shape.size / edge).round().max(DVec3::ONE).as_uvec3().to_array();
    let mut mesh = TriangleMesh::default();
    let mut seen: HashMap<[u32; 3], u32> = HashMap::new();
    let mut vertex = |mesh: &mut TriangleMesh, at: [u32; 3]| {
        *seen.entry(at).or_insert_with(|| {
            let share = DVec3::from_array(std::array::from_fn(|k| f64::from(at[k]) / f64::from(cells[k]) - 0.5));
            mesh.positions.push(shape.center + share * shape.size);
            mesh.positions.len() as u32 - 1
        })
    };
    for axis in 0..3 {
        let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
        for side in [0, cells[axis]] {
            for a in 0..cells[u] {
                for b in 0..cells[v] {
                    let corner = |da: u32, db: u32| {
                        let mut at = [0; 3];
                        at[axis] = side;
                        at[u] = a + da;
                        at[v] = b + db;
                        at
                    };
                    let mut quad = [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)];
                    if side == 0 {
                        quad.reverse();
                    }
                    let [p, q, r, s] = quad.map(|at| vertex(&mut mesh, at));
                    mesh.triangles.extend([[p, q, r], [p, r, s]]);
                }
            }
        }
    }
    mesh
}

impl TriangleMesh {
    /// Signed volume enclosed [m³], positive when the faces turn outwards.
    pub fn volume(&self) -> f64 {
        self.triangles
            .iter()
            .map(|t| {
                let [a, b, c] = t.map(|i| self.positions[i as usize]);
                a.dot(b.cross(c)) / 6.0
            })
            .sum()
    }
}

/// Where a ray meets a mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// Index of the face.
    pub triangle: usize,
    /// Distance along the ray in lengths of its direction.
    pub distance: f64,
}

/// The face that a ray from `origin` along `direction` meets first; every face is tried, from either side.
pub fn nearest_hit(positions: &[DVec3], triangles: &[[u32; 3]], origin: DVec3, direction: DVec3) -> Option<Hit> {
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

    #[test]
    fn a_box_surface_is_closed_and_turned_outwards() {
        let shape = Cuboid { center: DVec3::new(1.0, 2.0, 3.0), size: DVec3::new(0.3, 0.4, 0.5) };
        let mesh = box_surface(&shape, 0.1);
        assert!((mesh.volume() - 0.06).abs() < 1e-12);
        let mut edges: HashMap<[u32; 2], i32> = HashMap::new();
        for &[a, b, c] in &mesh.triangles {
            for [p, q] in [[a, b], [b, c], [c, a]] {
                *edges.entry([p.min(q), p.max(q)]).or_default() += if p < q { 1 } else { -1 };
            }
        }
        assert!(edges.values().all(|&balance| balance == 0));
    }

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
