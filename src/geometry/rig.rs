//! How a picture's surface hangs on moving points: all that a graphics processor needs to move it by itself.

use super::linear_map::LinearMap;
use glam::{DVec3, Vec3};
use rayon::prelude::*;

/// Normals of a file that agree to this share of a unit belong together.
const SAME_NORMAL: f32 = 1e-3;

/// A surface over the particles of a body.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Rig {
    /// The skin's points from the particles and the directions behind them.
    pub points: LinearMap,
    /// How many of what the points are sums of have no place: unit vectors that turn with the body.
    pub directions: usize,
    /// The picture's vertices from the skin's points; finer than these where the skin is coarse.
    pub vertices: LinearMap,
    /// Vertex indices of the picture's faces.
    pub triangles: Vec<[u32; 3]>,
    /// For every vertex the other two corners of the faces around it, in their order: the pairs of vertex `v` are
    /// `corners[starts[v]..starts[v + 1]]` of [`Rig::corner_starts`]. Its normal is the mean of these faces by their
    /// angle there, so that the way a surface was cut into triangles does not show (Thürmer and Wüthrich 1998).
    pub corners: Vec<[u32; 2]>,
    /// As above.
    pub corner_starts: Vec<u32>,
}

impl Rig {
    /// A rig of a surface whose vertices share normals as `shading` says.
    pub fn new(points: LinearMap, vertices: LinearMap, triangles: Vec<[u32; 3]>, shading: &Shading) -> Self {
        let (mut corners, mut corner_starts) = (Vec::new(), vec![0]);
        for vertex in 0..vertices.len() {
            for &face in shading.faces_around(vertex) {
                let face = triangles[face as usize];
                // The corner that shares the vertex's normal; it lies at the same place.
                if let Some(own) = (0..3).find(|&k| shading.share(face[k] as usize, vertex)) {
                    corners.push([face[(own + 1) % 3], face[(own + 2) % 3]]);
                }
            }
            corner_starts.push(corners.len() as u32);
        }
        Self { points, directions: 0, vertices, triangles, corners, corner_starts }
    }

    /// Normals of the picture's vertices.
    pub fn normals(&self, vertices: &[Vec3]) -> Vec<Vec3> {
        let normal = |v: usize| {
            let at = vertices[v].as_dvec3();
            let pairs = &self.corners[self.corner_starts[v] as usize..self.corner_starts[v + 1] as usize];
            let face = |&[b, c]: &[u32; 2]| {
                let [b, c] = [b, c].map(|k| vertices[k as usize].as_dvec3() - at);
                let area = b.cross(c);
                area.normalize_or_zero() * area.length().atan2(b.dot(c))
            };
            pairs.iter().map(face).sum::<DVec3>().normalize_or(DVec3::Y).as_vec3()
        };
        (0..vertices.len()).into_par_iter().with_min_len(1024).map(normal).collect()
    }
}

/// Vertices that share a normal: those at one point on the same side of every edge.
#[derive(Clone, Debug, Default)]
pub struct Shading {
    group_of: Vec<u32>,
    /// Faces around group `g`: `starts[g]..starts[g + 1]`.
    starts: Vec<u32>,
    faces: Vec<u32>,
}

impl Shading {
    /// Of vertices at points, with the normals of a file that tell where the surface has edges; none at all for a
    /// surface smooth everywhere.
    pub fn new(point_of: &[u32], normals: &[Vec3], triangles: &[[u32; 3]]) -> Self {
        let normal_of = |vertex: u32| {
            let normal = normals.get(vertex as usize).copied().unwrap_or_default();
            (normal / SAME_NORMAL).round().as_ivec3().to_array()
        };
        let mut keys: Vec<(u32, [i32; 3], u32)> = point_of
            .iter()
            .enumerate()
            .map(|(vertex, &point)| (point, normal_of(vertex as u32), vertex as u32))
            .collect();
        keys.par_sort_unstable();
        let mut group_of = vec![0; keys.len()];
        let mut count = 0;
        for (k, (point, normal, vertex)) in keys.iter().enumerate() {
            if k > 0 && (keys[k - 1].0, keys[k - 1].1) != (*point, *normal) {
                count += 1;
            }
            group_of[*vertex as usize] = count;
        }
        let groups = if keys.is_empty() { 0 } else { count as usize + 1 };
        let mut around: Vec<(u32, u32)> = triangles
            .iter()
            .enumerate()
            .flat_map(|(face, t)| t.map(|vertex| (group_of[vertex as usize], face as u32)))
            .collect();
        around.par_sort_unstable();
        around.dedup();
        let mut starts = vec![0; groups + 1];
        for (group, _) in &around {
            starts[*group as usize + 1] += 1;
        }
        for group in 0..groups {
            starts[group + 1] += starts[group];
        }
        Self { group_of, starts, faces: around.into_iter().map(|(_, face)| face).collect() }
    }

    /// Faces whose mean is the normal of a vertex.
    fn faces_around(&self, vertex: usize) -> &[u32] {
        self.faces_of(self.group_of[vertex] as usize)
    }

    fn faces_of(&self, group: usize) -> &[u32] {
        &self.faces[self.starts[group] as usize..self.starts[group + 1] as usize]
    }

    fn share(&self, a: usize, b: usize) -> bool {
        self.group_of[a] == self.group_of[b]
    }

    /// Unit normals of vertices at `vertices` [m]: means of the faces around them, by area.
    pub fn normals(&self, triangles: &[[u32; 3]], vertices: &[DVec3]) -> Vec<Vec3> {
        let areas: Vec<Vec3> = triangles
            .par_iter()
            .with_min_len(1024)
            .map(|t| {
                let [a, b, c] = t.map(|i| vertices[i as usize]);
                (b - a).cross(c - a).normalize_or_zero().as_vec3() * ((b - a).cross(c - a).length() as f32)
            })
            .collect();
        let normals: Vec<Vec3> = (0..self.starts.len().saturating_sub(1))
            .into_par_iter()
            .with_min_len(1024)
            .map(|group| {
                // Areas of small faces vanish in single precision when squared.
                let sum: Vec3 = self.faces_of(group).iter().map(|&face| areas[face as usize]).sum();
                sum.as_dvec3().normalize_or(DVec3::Y).as_vec3()
            })
            .collect();
        self.group_of.iter().map(|&group| normals[group as usize]).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::lattice::Cuboid;
    use crate::geometry::mesh::box_surface;

    fn rig(count: u32, triangles: &[[u32; 3]]) -> Rig {
        let each: Vec<u32> = (0..count).collect();
        let shading = Shading::new(&each, &[], triangles);
        Rig::new(LinearMap::gather(&each), LinearMap::gather(&each), triangles.to_vec(), &shading)
    }

    #[test]
    fn the_corners_of_a_cube_point_along_its_diagonals_however_it_is_cut() {
        let mesh = box_surface(&Cuboid { center: DVec3::ZERO, size: DVec3::ONE }, 0.5);
        let positions: Vec<Vec3> = mesh.positions.iter().map(|point| point.as_vec3()).collect();
        let normals = rig(positions.len() as u32, &mesh.triangles).normals(&positions);
        for (position, normal) in positions.iter().zip(&normals) {
            assert!((position.normalize_or_zero() - *normal).length() < 1e-5, "{position} {normal}");
        }
    }

    #[test]
    fn faces_without_area_have_no_say() {
        assert_eq!(rig(3, &[[0, 1, 2]]).normals(&[Vec3::ZERO; 3]), [Vec3::Y; 3]);
    }

    #[test]
    fn an_edge_of_the_model_stays_an_edge() {
        // Two faces of a wedge over one edge: their vertices lie at the same points and have normals of their own.
        let positions = [Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::ZERO, Vec3::X, Vec3::Z];
        let triangles = [[0, 1, 2], [4, 3, 5]];
        let sharp = [Vec3::Z, Vec3::Z, Vec3::Z, Vec3::Y, Vec3::Y, Vec3::Y];
        let points = [0, 1, 2, 0, 1, 3];
        let rig = |normals: &[Vec3]| {
            let shading = Shading::new(&points, normals, &triangles);
            let each = LinearMap::gather(&[0, 1, 2, 3, 4, 5]);
            Rig::new(each.clone(), each, triangles.to_vec(), &shading).normals(&positions)
        };
        assert_eq!(rig(&sharp), sharp);
        let soft = rig(&[]);
        assert!(soft[0] == soft[3] && soft[0].y > 0.5 && soft[0].z > 0.5, "{soft:?}");
    }
}
