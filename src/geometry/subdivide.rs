//! Surfaces a little rounder than they are: what is soft has no sharp edges.

use super::linear_map::LinearMap;
use std::collections::HashMap;

/// A mesh with more triangles than this looks round as it is.
const FINE: usize = 2500;

/// Subdivisions, the last ones, that round: what they take off a corner is small beside the mesh.
const ROUNDING: u32 = 2;

/// Every triangle becomes four until a mesh of `count` vertices is fine, at last by Loop's subdivision (1987), by which
/// the outline loses its corners: the new vertices as sums of the old ones, and the new faces. The first cuts of a
/// coarse mesh are flat: Loop's would make a ball a third its size of a tetrahedron. None for a mesh that is fine
/// already. Edges of holes keep their run.
pub(crate) fn rounded(count: usize, triangles: &[[u32; 3]]) -> Option<(LinearMap, Vec<[u32; 3]>)> {
    let mut whole: Option<(LinearMap, Vec<[u32; 3]>)> = None;
    loop {
        let (count, faces) = whole.as_ref().map_or((count, triangles), |(map, faces)| (map.len(), faces));
        if faces.is_empty() || faces.len() > FINE {
            return whole;
        }
        let is_coarse = faces.len() << (2 * ROUNDING) <= FINE;
        let (map, finer) = if is_coarse { cut(count, faces) } else { subdivided(count, faces) };
        let map = whole.as_ref().map_or_else(|| map.clone(), |(first, _)| map.after(first));
        whole = Some((map, finer));
    }
}

/// Every triangle cut in four at the middles of its edges.
fn cut(count: usize, triangles: &[[u32; 3]]) -> (LinearMap, Vec<[u32; 3]>) {
    let (edges, sides) = edges(triangles);
    let mut map = LinearMap::default();
    for vertex in 0..count as u32 {
        map.push([(vertex, 1.0)]);
    }
    for edge in &edges {
        map.push(edge.ends.map(|end| (end, 0.5)));
    }
    (map, quarters(count, triangles, sides))
}

/// Loop's subdivision.
fn subdivided(count: usize, triangles: &[[u32; 3]]) -> (LinearMap, Vec<[u32; 3]>) {
    let (edges, sides) = edges(triangles);
    let mut map = LinearMap::default();
    old_vertices(count, &edges, &mut map);
    for edge in &edges {
        let [a, b] = edge.ends;
        match edge.opposite {
            [Some(c), Some(d)] => map.push([(a, 0.375), (b, 0.375), (c, 0.125), (d, 0.125)]),
            _ => map.push([(a, 0.5), (b, 0.5)]),
        }
    }
    (map, quarters(count, triangles, sides))
}

/// The four faces that each triangle becomes, whose edges have their new vertices behind the `count` old ones.
fn quarters(count: usize, triangles: &[[u32; 3]], sides: Vec<[usize; 3]>) -> Vec<[u32; 3]> {
    let mut faces = Vec::with_capacity(4 * triangles.len());
    for (triangle, sides) in triangles.iter().zip(sides) {
        let [a, b, c] = *triangle;
        let [ab, bc, ca] = sides.map(|edge| (count + edge) as u32);
        faces.extend([[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]);
    }
    faces
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
fn old_vertices(count: usize, edges: &[Edge], map: &mut LinearMap) {
    let mut around = vec![Vec::new(); count];
    let mut open = vec![Vec::new(); count];
    for edge in edges {
        let [a, b] = edge.ends;
        for (one, other) in [(a, b), (b, a)] {
            around[one as usize].push(other);
            if edge.opposite[1].is_none() {
                open[one as usize].push(other);
            }
        }
    }
    for (vertex, (around, open)) in (0..).zip(around.iter().zip(&open)) {
        let n = around.len() as f32;
        match open.len() {
            0 if n > 0.0 => {
                // Warren's weights.
                let weight = if n > 3.0 { 3.0 / (8.0 * n) } else { 3.0 / 16.0 };
                let own = std::iter::once((vertex, 1.0 - n * weight));
                map.push(own.chain(around.iter().map(|&other| (other, weight))));
            }
            2 => map.push(std::iter::once((vertex, 0.75)).chain(open.iter().map(|&other| (other, 0.125)))),
            _ => map.push([(vertex, 1.0)]),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::lattice::Cuboid;
    use crate::geometry::mesh::box_surface;
    use glam::{DVec3, Vec3};

    #[test]
    fn a_box_loses_its_corners_and_little_else() {
        let mesh = box_surface(&Cuboid { center: DVec3::ZERO, size: DVec3::new(7.0, 12.0, 7.0) }, 1.0);
        let positions: Vec<Vec3> = mesh.positions.iter().map(|point| point.as_vec3()).collect();
        let (map, faces) = subdivided(positions.len(), &mesh.triangles);
        let round = map.apply(&positions);
        assert_eq!(faces.len(), 4 * mesh.triangles.len());
        assert_eq!(round.len() + faces.len(), faces.len() * 3 / 2 + 2, "Euler's formula for a closed surface");
        for (before, after) in positions.iter().zip(&round) {
            let on_edge = (before.abs() / Vec3::new(3.5, 6.0, 3.5)).to_array().iter().filter(|s| **s > 0.99).count();
            let moved = before.distance(*after);
            assert!(if on_edge == 1 { moved < 0.15 } else { moved > 0.1 && moved < 0.6 }, "{before} {moved}");
        }
        let (fine, faces) = rounded(positions.len(), &mesh.triangles).expect("it is coarse");
        assert!(faces.len() > FINE && rounded(fine.len(), &faces).is_none());
    }

    #[test]
    fn a_coarse_mesh_keeps_its_size_and_its_tips() {
        let tetrahedron = [Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::Z];
        let (map, faces) = rounded(4, &[[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]).expect("it is coarse");
        assert!(faces.len() > FINE);
        let round = map.apply(&tetrahedron);
        for tip in tetrahedron {
            let nearest = round.iter().map(|point| point.distance(tip)).fold(f32::INFINITY, f32::min);
            assert!(nearest < 0.12, "{tip} is {nearest} away");
        }
        let volume: f32 =
            faces.iter().map(|face| face.map(|i| round[i as usize])).map(|[a, b, c]| a.dot(b.cross(c))).sum();
        assert!(volume > 0.95 && volume <= 1.0, "{volume} of the volume is left");
    }

    #[test]
    fn a_flat_sheet_stays_flat_and_keeps_its_rim_straight() {
        let positions = [Vec3::ZERO, Vec3::X, Vec3::Z, Vec3::X + Vec3::Z];
        let (map, faces) = subdivided(4, &[[0, 2, 1], [1, 2, 3]]);
        let round = map.apply(&positions);
        assert_eq!((round.len(), faces.len()), (9, 8));
        assert!(round.iter().all(|point| point.y == 0.0));
    }
}
