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
}
