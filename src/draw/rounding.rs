//! Skins are drawn a little rounder than they are: what is soft has no sharp edges.

use glam::Vec3;
use std::collections::HashMap;

/// A mesh with more triangles than this looks round as it is.
const FINE: usize = 6000;

/// Loop's subdivision (1987), by which every triangle becomes four and the outline loses its corners, until the mesh is
/// fine; one that is fine already stays as it is. Edges of holes keep their run.
pub fn rounded(mut positions: Vec<Vec3>, triangles: &[[u32; 3]]) -> (Vec<Vec3>, Vec<[u32; 3]>) {
    let mut triangles = triangles.to_vec();
    while !triangles.is_empty() && triangles.len() <= FINE {
        (positions, triangles) = subdivided(&positions, &triangles);
    }
    (positions, triangles)
}

fn subdivided(positions: &[Vec3], triangles: &[[u32; 3]]) -> (Vec<Vec3>, Vec<[u32; 3]>) {
    let (edges, sides) = edges(triangles);
    let count = positions.len();
    let mut rounded: Vec<Vec3> = old_vertices(positions, &edges);
    for edge in &edges {
        let [a, b] = edge.ends.map(|k| positions[k as usize]);
        rounded.push(match edge.opposite {
            [Some(c), Some(d)] => 0.375 * (a + b) + 0.125 * (positions[c as usize] + positions[d as usize]),
            _ => 0.5 * (a + b),
        });
    }
    let mut faces = Vec::with_capacity(4 * triangles.len());
    for (triangle, sides) in triangles.iter().zip(sides) {
        let [a, b, c] = *triangle;
        let [ab, bc, ca] = sides.map(|edge| (count + edge) as u32);
        faces.extend([[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]);
    }
    (rounded, faces)
}

struct Edge {
    ends: [u32; 2],
    /// Vertices across the edge in the two faces that share it.
    opposite: [Option<u32>; 2],
}

/// Every edge once, and the edges of each face in its order.
fn edges(triangles: &[[u32; 3]]) -> (Vec<Edge>, Vec<[usize; 3]>) {
    let mut edges: Vec<Edge> = Vec::new();
    let mut known: HashMap<[u32; 2], usize> = HashMap::new();
    let sides = triangles
        .iter()
        .map(|triangle| {
            std::array::from_fn(|k| {
                let [a, b, across] = std::array::from_fn(|step| triangle[(k + step) % 3]);
                let ends = [a.min(b), a.max(b)];
                let index = *known.entry(ends).or_insert_with(|| {
                    edges.push(Edge { ends, opposite: [None; 2] });
                    edges.len() - 1
                });
                let opposite = &mut edges[index].opposite;
                opposite[usize::from(opposite[0].is_some())] = Some(across);
                index
            })
        })
        .collect();
    (edges, sides)
}

/// Where the vertices that were there go.
fn old_vertices(positions: &[Vec3], edges: &[Edge]) -> Vec<Vec3> {
    let mut around = vec![(Vec3::ZERO, 0.0_f32); positions.len()];
    let mut open = vec![(Vec3::ZERO, 0_u32); positions.len()];
    for edge in edges {
        let [a, b] = edge.ends.map(|k| k as usize);
        for (one, other) in [(a, b), (b, a)] {
            around[one].0 += positions[other];
            around[one].1 += 1.0;
            if edge.opposite[1].is_none() {
                open[one].0 += positions[other];
                open[one].1 += 1;
            }
        }
    }
    let placed = positions.iter().zip(around.iter().zip(&open));
    placed
        .map(|(&at, (&(sum, n), &(open_sum, open_n)))| match open_n {
            0 if n > 0.0 => {
                // Warren's weights.
                let weight = if n > 3.0 { 3.0 / (8.0 * n) } else { 3.0 / 16.0 };
                at * (1.0 - n * weight) + sum * weight
            }
            2 => 0.75 * at + 0.125 * open_sum,
            _ => at,
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::lattice::Cuboid;
    use crate::geometry::mesh::box_surface;
    use glam::DVec3;

    #[test]
    fn a_box_loses_its_corners_and_little_else() {
        let mesh = box_surface(&Cuboid { center: DVec3::ZERO, size: DVec3::new(7.0, 12.0, 7.0) }, 1.0);
        let positions: Vec<Vec3> = mesh.positions.iter().map(|point| point.as_vec3()).collect();
        let (round, faces) = subdivided(&positions, &mesh.triangles);
        assert_eq!(faces.len(), 4 * mesh.triangles.len());
        assert_eq!(round.len() + faces.len(), faces.len() * 3 / 2 + 2, "Euler's formula for a closed surface");
        for (before, after) in positions.iter().zip(&round) {
            let on_edge = (before.abs() / Vec3::new(3.5, 6.0, 3.5)).to_array().iter().filter(|s| **s > 0.99).count();
            let moved = before.distance(*after);
            assert!(if on_edge == 1 { moved < 0.15 } else { moved > 0.1 && moved < 0.6 }, "{before} {moved}");
        }
    }

    #[test]
    fn a_flat_sheet_stays_flat_and_keeps_its_rim_straight() {
        let positions = vec![Vec3::ZERO, Vec3::X, Vec3::Z, Vec3::X + Vec3::Z];
        let (round, faces) = subdivided(&positions, &[[0, 2, 1], [1, 2, 3]]);
        assert_eq!((round.len(), faces.len()), (9, 8));
        assert!(round.iter().all(|point| point.y == 0.0));
    }
}
