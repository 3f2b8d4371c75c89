//! The vertices of a body as glTF has them: those of its file first, in their order, and behind them a copy of each at every
//! seam, where one vertex has several texture coordinates. Polygons are cut into triangles.

use crate::geometry::file_mesh::FileMesh;
use crate::io::model::triangulate;
use glam::DVec3;
use std::collections::HashMap;
use std::ops::Range;

/// A body's vertices and faces.
pub(super) struct ClipMesh {
    /// Vertex of the file of every vertex here.
    pub(super) source: Vec<u32>,
    /// Texture coordinates a vertex, right and down, of every set.
    pub(super) uv_sets: Vec<Vec<[f32; 2]>>,
    pub(super) triangles: Vec<[u32; 3]>,
    /// Faces of every part of the file, as ranges of the triangles.
    pub(super) parts: Vec<Range<usize>>,
}

impl ClipMesh {
    pub(super) fn new(mesh: &FileMesh) -> Self {
        let mut source: Vec<u32> = (0..mesh.points.len() as u32).collect();
        let mut uv_sets = vec![vec![None; source.len()]; mesh.uv_sets.len()];
        // Vertices by what they have: the first that is met of a vertex of the file is the vertex itself.
        let mut known: HashMap<(u32, Vec<Option<u32>>), u32> = HashMap::new();
        let mut is_taken = vec![false; source.len()];
        let corner = |corner: usize, source: &mut Vec<u32>, uv_sets: &mut Vec<Vec<Option<[f64; 2]>>>| {
            let vertex = mesh.corners[corner];
            let textures: Vec<Option<u32>> = mesh.uv_sets.iter().map(|set| set.of(corner)).collect();
            let is_first = !std::mem::replace(&mut is_taken[vertex as usize], true);
            let index = *known.entry((vertex, textures.clone())).or_insert_with(|| {
                if is_first {
                    return vertex;
                }
                source.push(vertex);
                for set in uv_sets.iter_mut() {
                    set.push(None);
                }
                source.len() as u32 - 1
            });
            for ((values, set), texture) in uv_sets.iter_mut().zip(&mesh.uv_sets).zip(textures) {
                values[index as usize] = texture.map(|texture| set.values[texture as usize]);
            }
            index
        };
        let mut corner = corner;
        let faces: Vec<Vec<u32>> =
            mesh.faces().map(|face| face.map(|at| corner(at, &mut source, &mut uv_sets)).collect()).collect();
        let points: Vec<DVec3> = source.iter().map(|&vertex| mesh.points[vertex as usize]).collect();
        let (mut triangles, mut parts) = (Vec::new(), Vec::new());
        for part in &mesh.parts {
            let first = triangles.len();
            faces[part.faces.clone()].iter().for_each(|face| triangulate(face, &points, &mut triangles));
            parts.push(first..triangles.len());
        }
        let down = |uv: Option<[f64; 2]>| uv.map_or([0.0; 2], |[u, v]| [u as f32, (1.0 - v) as f32]);
        let uv_sets = uv_sets.into_iter().map(|set| set.into_iter().map(down).collect()).collect();
        Self { source, uv_sets, triangles, parts }
    }

    /// The vertices here, out of those of the file.
    pub(super) fn places<'a>(&'a self, of_file: &'a [DVec3]) -> impl Iterator<Item = DVec3> + 'a {
        self.source.iter().map(|&vertex| of_file[vertex as usize])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::file_mesh::UvSet;

    #[test]
    fn a_seam_makes_copies_behind_the_vertices_of_the_file() {
        let points = vec![DVec3::ZERO, DVec3::X, DVec3::X + DVec3::Y, DVec3::Y, DVec3::Z];
        let mut mesh = FileMesh { points, ..FileMesh::default() };
        mesh.add_face(&[0, 1, 2, 3]);
        mesh.add_face(&[0, 1, 4]);
        // The second face has coordinates of its own at vertex 1.
        let values = vec![[0.0, 0.0], [1.0, 0.25], [0.5, 0.5]];
        mesh.uv_sets.push(UvSet { values, corners: vec![0, 1, 0, 0, 0, 2, 0] });
        let clip = ClipMesh::new(&mesh);
        assert_eq!(clip.source, [0, 1, 2, 3, 4, 1]);
        assert_eq!((clip.uv_sets[0][1], clip.uv_sets[0][5]), ([1.0, 0.75], [0.5, 0.5]));
        assert_eq!((clip.triangles.len(), clip.triangles[2]), (3, [0, 5, 4]));
        assert_eq!((clip.parts.len(), clip.parts[0].clone()), (1, 0..3));
    }
}
