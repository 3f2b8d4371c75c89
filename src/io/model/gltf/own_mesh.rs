//! The mesh of a glTF file as the file has it: its pieces one after another, every vertex of each.

use super::primitive::Drawn;
use crate::geometry::file_mesh::{FileMesh, FilePart, UvSet};

/// Adds a piece to the mesh of its file.
pub(super) fn add_piece(file: &mut FileMesh, drawn: &Drawn) {
    let mesh = &drawn.mesh;
    let (first_vertex, first_corner) = (file.points.len() as u32, file.corners.len());
    let (material, colour) = drawn.material.clone().map_or((String::new(), None), |(name, base)| (name, Some(base)));
    file.begin_part(FilePart { name: mesh.name.clone(), material, colour, ..FilePart::default() });
    file.points.extend(&mesh.positions);
    for triangle in &mesh.triangles {
        file.add_face(&triangle.map(|vertex| first_vertex + vertex));
    }
    let sets = file.uv_sets.len().max(drawn.uv_sets.len());
    file.uv_sets.resize(sets, UvSet::default());
    for (number, set) in file.uv_sets.iter_mut().enumerate() {
        // Pieces before may have had fewer sets, and this one may.
        set.corners.resize(first_corner, UvSet::NONE);
        if let Some(values) = drawn.uv_sets.get(number).filter(|values| !values.is_empty()) {
            let first = set.values.len() as u32;
            set.values.extend(values);
            set.corners.extend(mesh.triangles.iter().flatten().map(|vertex| first + vertex));
        }
        set.corners.resize(file.corners.len(), UvSet::NONE);
    }
}
