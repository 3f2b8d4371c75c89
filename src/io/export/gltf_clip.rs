//! The vertices of a body as glTF has them: those of its file first, in their order, and behind them a copy of each at
//! every seam, where one vertex has several texture coordinates or normals. Polygons are cut into triangles.

use super::looks::merged_parts;
use crate::geometry::file_mesh::{FileMesh, FilePart, UvSet};
use crate::io::model::Cutter;
use glam::DVec3;
use std::collections::HashMap;
use std::ops::Range;

/// A body's vertices and faces.
pub(super) struct ClipMesh {
    /// Vertex of the file of every vertex here.
    pub(super) source: Vec<u32>,
    /// Texture coordinates a vertex, right and down, of every set; the origin where there are none.
    pub(super) uv_sets: Vec<Vec<[f32; 2]>>,
    /// Which of the mesh's normals every vertex has, one behind the last for those of no face; none without any.
    pub(super) normals: Option<Vec<u32>>,
    pub(super) triangles: Vec<[u32; 3]>,
    /// Parts of the file, of different names or looks, with their faces as ranges of the triangles.
    pub(super) parts: Vec<(FilePart, Range<usize>)>,
}

impl ClipMesh {
    pub(super) fn new(mesh: &FileMesh) -> Self {
        let mut vertices = Vertices::new(mesh);
        let faces: Vec<Vec<u32>> =
            mesh.faces().map(|face| face.map(|corner| vertices.of_corner(mesh, corner)).collect()).collect();
        let Vertices { source, uv_sets, normals, .. } = vertices;
        let normals = mesh.normals.is_some().then_some(normals);
        let points: Vec<DVec3> = source.iter().map(|&vertex| mesh.points[vertex as usize]).collect();
        let (mut triangles, mut parts, mut cutter) = (Vec::new(), Vec::new(), Cutter::default());
        for (part, runs) in merged_parts(mesh) {
            let first = triangles.len();
            for face in runs.into_iter().flat_map(|run| &faces[run]) {
                cutter.cut(face, &points, &mut triangles);
            }
            parts.push((part.clone(), first..triangles.len()));
        }
        Self { source, uv_sets, normals, triangles, parts }
    }

    /// Normals of the vertices here, out of those of the mesh; upwards for those of no face, and nothing without any.
    pub(super) fn directions<'a>(&'a self, of_mesh: &'a [DVec3]) -> impl Iterator<Item = DVec3> + 'a {
        let direction = |&normal: &u32| of_mesh.get(normal as usize).copied().unwrap_or(DVec3::Y);
        self.normals.iter().flatten().map(direction)
    }

    /// The vertices here, out of those of the file.
    pub(super) fn places<'a>(&'a self, of_file: &'a [DVec3]) -> impl Iterator<Item = DVec3> + 'a {
        self.source.iter().map(|&vertex| of_file[vertex as usize])
    }
}

/// Vertices as they are found, corner by corner.
struct Vertices {
    source: Vec<u32>,
    uv_sets: Vec<Vec<[f32; 2]>>,
    /// Which normal each has; one behind the last until it has any.
    normals: Vec<u32>,
    /// Whether a vertex of the file has its coordinates.
    is_taken: Vec<bool>,
    /// Copies of a vertex of the file, by their normals and by the bits of their coordinates in every set: what is told
    /// apart by its number in the file alone is the same.
    copies: HashMap<(u32, u32, Vec<[u32; 2]>), u32>,
}

impl Vertices {
    fn new(mesh: &FileMesh) -> Self {
        let count = mesh.points.len();
        Self {
            source: (0..count as u32).collect(),
            uv_sets: vec![vec![[0.0; 2]; count]; mesh.uv_sets.len()],
            normals: vec![mesh.normals.as_ref().map_or(0, |normals| normals.values.len() as u32); count],
            is_taken: vec![false; count],
            copies: HashMap::new(),
        }
    }

    /// The vertex of a corner: that of the file where it is the first, or of the same coordinates, or else a copy.
    fn of_corner(&mut self, mesh: &FileMesh, corner: usize) -> u32 {
        let vertex = mesh.corners[corner];
        let uvs: Vec<[f32; 2]> = mesh.uv_sets.iter().map(|set| uv_of(set, corner)).collect();
        let normal = mesh.normals.as_ref().and_then(|normals| normals.of(corner)).unwrap_or(0);
        let bits = |uv: [f32; 2]| uv.map(f32::to_bits);
        let is_taken = &mut self.is_taken[vertex as usize];
        let own = self.uv_sets.iter().map(|set| bits(set[vertex as usize]));
        let is_same = self.normals[vertex as usize] == normal && own.eq(uvs.iter().map(|&uv| bits(uv)));
        if *is_taken && !is_same {
            let (source, sets, normals) = (&mut self.source, &mut self.uv_sets, &mut self.normals);
            let key = (vertex, normal, uvs.iter().map(|&uv| bits(uv)).collect());
            return *self.copies.entry(key).or_insert_with(|| {
                sets.iter_mut().zip(uvs).for_each(|(set, uv)| set.push(uv));
                normals.push(normal);
                source.push(vertex);
                source.len() as u32 - 1
            });
        }
        *is_taken = true;
        self.normals[vertex as usize] = normal;
        self.uv_sets.iter_mut().zip(uvs).for_each(|(set, uv)| set[vertex as usize] = uv);
        vertex
    }
}

/// Coordinates of a corner as they are written; zero is never negative.
fn uv_of(set: &UvSet, corner: usize) -> [f32; 2] {
    let written = |index: u32| {
        let [u, v] = set.values[index as usize];
        [u as f32 + 0.0, (1.0 - v) as f32 + 0.0]
    };
    set.of(corner).map_or([0.0; 2], written)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn corner_with(values: Vec<[f64; 2]>, corners: Vec<u32>) -> FileMesh {
        let points = vec![DVec3::ZERO, DVec3::X, DVec3::X + DVec3::Y, DVec3::Y, DVec3::Z];
        let mut mesh = FileMesh { points, ..FileMesh::default() };
        mesh.add_face(&[0, 1, 2, 3]);
        mesh.add_face(&[0, 1, 4]);
        mesh.uv_sets.push(UvSet { values, corners });
        mesh
    }

    #[test]
    fn a_seam_makes_copies_behind_the_vertices_of_the_file() {
        // The second face has coordinates of its own at vertex 1.
        let values = vec![[0.0, 0.0], [1.0, 0.25], [0.5, 0.5]];
        let clip = ClipMesh::new(&corner_with(values, vec![0, 1, 0, 0, 0, 2, 0]));
        assert_eq!(clip.source, [0, 1, 2, 3, 4, 1]);
        assert_eq!((clip.uv_sets[0][1], clip.uv_sets[0][5]), ([1.0, 0.75], [0.5, 0.5]));
        assert_eq!((clip.triangles.len(), clip.triangles[2]), (3, [0, 5, 4]));
        assert_eq!((clip.parts.len(), clip.parts[0].1.clone()), (1, 0..3));
    }

    #[test]
    fn coordinates_that_are_the_same_are_no_seam_whatever_their_numbers() {
        let values = vec![[0.0, 0.0], [1.0, 0.25], [0.5, 0.5], [0.0, 1.0], [-0.0, 0.0], [1.0, 0.25], [0.5, 0.25]];
        let clip = ClipMesh::new(&corner_with(values, (0..7).collect()));
        assert_eq!(clip.source, [0, 1, 2, 3, 4]);
        assert_eq!(clip.uv_sets[0], [[0.0, 1.0], [1.0, 0.75], [0.5, 0.5], [0.0, 0.0], [0.5, 0.75]]);
    }

    #[test]
    fn parts_that_look_alike_are_one() {
        let mut mesh = FileMesh { points: vec![DVec3::ZERO, DVec3::X, DVec3::Y], ..FileMesh::default() };
        for k in 0..1000 {
            let material = ["a", "b"][k % 2].to_owned();
            mesh.begin_part(FilePart { material, ..FilePart::default() });
            mesh.add_face(&[0, 1, 2]);
        }
        let clip = ClipMesh::new(&mesh);
        let parts: Vec<_> = clip.parts.iter().map(|(part, range)| (&*part.material, range.clone())).collect();
        assert_eq!(parts, [("a", 0..500), ("b", 500..1000)]);
    }
}
