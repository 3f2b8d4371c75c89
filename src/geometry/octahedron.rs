//! The unit sphere as an octahedron, subdivided.

use super::mesh::TriangleMesh;
use glam::DVec3;
use std::collections::{BTreeSet, HashMap};

/// The unit sphere about the origin: an octahedron whose faces are cut in four `subdivisions` times, every new vertex
/// moved out onto the sphere. It has `4^(n+1) + 2` vertices, `12 * 4^n` edges and `8 * 4^n` faces.
pub fn sphere(subdivisions: u32) -> TriangleMesh {
    let mut positions = vec![DVec3::X, DVec3::NEG_X, DVec3::Y, DVec3::NEG_Y, DVec3::Z, DVec3::NEG_Z];
    let mut triangles = vec![[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]];
    for _ in 0..subdivisions {
        // Both faces beside an edge share its middle.
        let mut middles: HashMap<[u32; 2], u32> = HashMap::new();
        let mut middle = |a: u32, b: u32| {
            *middles.entry([a.min(b), a.max(b)]).or_insert_with(|| {
                positions.push((positions[a as usize] + positions[b as usize]).normalize_or(DVec3::Y));
                positions.len() as u32 - 1
            })
        };
        let mut finer = Vec::with_capacity(4 * triangles.len());
        for [a, b, c] in triangles {
            let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
            finer.extend([[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]);
        }
        triangles = finer;
    }
    TriangleMesh { positions, triangles }
}

/// Every edge of a mesh once, the lower index first, in order.
pub(crate) fn edges(mesh: &TriangleMesh) -> Vec<[u32; 2]> {
    let sides = mesh.triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    sides.map(|[a, b]| [a.min(b), a.max(b)]).collect::<BTreeSet<_>>().into_iter().collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn counts_follow_the_formulae_and_faces_turn_outwards() {
        for n in 0..=5 {
            let mesh = sphere(n);
            assert_eq!(mesh.positions.len(), 4_usize.pow(n + 1) + 2);
            assert_eq!(mesh.triangles.len(), 8 * 4_usize.pow(n));
            assert_eq!(edges(&mesh).len(), 12 * 4_usize.pow(n));
            assert!(mesh.positions.iter().all(|x| (x.length() - 1.0).abs() < 1e-15));
            let volume = mesh.volume();
            assert!(volume > 0.0 && volume < 4.0 / 3.0 * PI, "{volume}");
        }
    }
}
