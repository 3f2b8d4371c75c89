//! The surface through the outermost points of a lattice: the faces of all of its cubes whose eight corners are there,
//! but for those that two cubes share.

use super::lattice::CORNERS;
use glam::{DVec3, IVec3};
use std::collections::{HashMap, HashSet};

/// A surface through points of a lattice.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct LatticeHull {
    /// Points that do not have full cubes all around, in ascending order; the corners of the faces are among them.
    pub(crate) outer: Vec<u32>,
    /// Faces, counter-clockwise seen from outside.
    pub(crate) faces: Vec<[u32; 3]>,
}

impl LatticeHull {
    /// Of points at `cells` of a lattice. Cubes between points of which some are not `joined` do not count.
    pub(crate) fn new(points: &[DVec3], cells: &[IVec3], joined: impl Fn(DVec3, DVec3) -> bool) -> Self {
        let at: HashMap<IVec3, u32> = cells.iter().zip(0..).map(|(&cell, i)| (cell, i)).collect();
        let corners = |cube: IVec3| -> Option<[u32; 8]> {
            let mut found = [0; 8];
            for (corner, step) in found.iter_mut().zip(CORNERS) {
                *corner = *at.get(&(cube + step))?;
            }
            let place = |k: usize| points[found[k] as usize];
            let edges = (0..8).flat_map(|k| [1, 2, 4].map(|bit| (k, k | bit))).filter(|(k, l)| k != l);
            edges.into_iter().all(|(k, l)| joined(place(k), place(l))).then_some(found)
        };
        let cubes: HashSet<IVec3> = cells.iter().copied().filter(|&cube| corners(cube).is_some()).collect();
        let is_inner = |cell: IVec3| CORNERS.iter().all(|&step| cubes.contains(&(cell - step)));
        let outer = cells.iter().zip(0..).filter(|(cell, _)| !is_inner(**cell)).map(|(_, i)| i).collect();
        let mut faces = Vec::new();
        for &cube in cells {
            if !cubes.contains(&cube) {
                continue;
            }
            for axis in 0..3 {
                for side in [0, 1] {
                    let mut beside = cube;
                    beside[axis] += 2 * side - 1;
                    if !cubes.contains(&beside) {
                        faces.extend(side_of(cube, axis, side, &at, points));
                    }
                }
            }
        }
        Self { outer, faces }
    }
}

/// The two triangles of a side of a full cube. Which way it is divided alternates from side to side, so that no
/// direction along the surface is preferred.
fn side_of(cube: IVec3, axis: usize, side: i32, at: &HashMap<IVec3, u32>, points: &[DVec3]) -> [[u32; 3]; 2] {
    let [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
    let corner = |i: i32, j: i32| {
        let mut cell = cube;
        cell[axis] += side;
        cell[u] += i;
        cell[v] += j;
        at[&cell]
    };
    let mut opposite = cube;
    opposite[axis] += 1 - side;
    let mut quad = [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)];
    if (cube.x + cube.y + cube.z) % 2 != 0 {
        quad.rotate_left(1);
    }
    let [a, b, c, d] = quad;
    let place = |i: u32| points[i as usize];
    let outward = place(corner(0, 0)) - place(at[&opposite]);
    if (place(b) - place(a)).cross(place(c) - place(a)).dot(outward) > 0.0 {
        [[a, b, c], [a, c, d]]
    } else {
        [[a, c, b], [a, d, c]]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn block(size: IVec3, axes: [f64; 3]) -> (Vec<DVec3>, Vec<IVec3>) {
        let mut cells = Vec::new();
        for x in 0..size.x {
            for y in 0..size.y {
                cells.extend((0..size.z).map(|z| IVec3::new(x, y, z)));
            }
        }
        (cells.iter().map(|cell| cell.as_dvec3() * DVec3::from_array(axes)).collect(), cells)
    }

    fn volume(points: &[DVec3], faces: &[[u32; 3]]) -> f64 {
        let six = |face: &[u32; 3]| {
            let [a, b, c] = face.map(|i| points[i as usize]);
            a.dot(b.cross(c))
        };
        faces.iter().map(six).sum::<f64>() / 6.0
    }

    #[test]
    fn it_encloses_the_cubes_from_outside_on_lattices_of_either_hand() {
        for (axes, expected) in [([1.0, 1.0, 1.0], 24.0), ([2.0, 1.0, -1.0], 48.0)] {
            let (points, cells) = block(IVec3::new(5, 4, 3), axes);
            let hull = LatticeHull::new(&points, &cells, |_, _| true);
            assert!((volume(&points, &hull.faces) - expected).abs() < 1e-12);
            assert_eq!(hull.faces.len(), 2 * 2 * (4 * 3 + 3 * 2 + 2 * 4));
            // All but the inner points.
            assert_eq!(hull.outer.len(), 60 - 3 * 2);
            let corners: HashSet<u32> = hull.faces.iter().flatten().copied().collect();
            assert_eq!(corners.len(), hull.outer.len());
        }
    }

    #[test]
    fn it_is_open_to_where_points_are_not_joined_and_has_no_face_at_single_points() {
        let (points, cells) = block(IVec3::new(6, 3, 3), [1.0; 3]);
        let cut = |a: DVec3, b: DVec3| (a.x < 2.5) == (b.x < 2.5);
        let hull = LatticeHull::new(&points, &cells, cut);
        assert!((volume(&points, &hull.faces) - 16.0).abs() < 1e-12);
        let hull = LatticeHull::new(&[DVec3::ZERO], &[IVec3::ZERO], |_, _| true);
        assert_eq!(hull, LatticeHull { outer: vec![0], faces: Vec::new() });
    }
}
