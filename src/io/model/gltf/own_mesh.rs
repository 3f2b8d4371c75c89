//! The mesh of a glTF file as the file has it: its pieces one after another, every vertex of each.

use super::primitive::Drawn;
use crate::geometry::file_mesh::{FileMesh, FilePart, UvSet};
use glam::Vec3;

/// What tints nothing.
const WHITE: [f32; 4] = [1.0; 4];

/// Adds a piece to the mesh of its file.
pub(super) fn add_piece(file: &mut FileMesh, drawn: &Drawn) {
    let mesh = &drawn.mesh;
    let (first_vertex, first_corner) = (file.points.len() as u32, file.corners.len());
    let (material, colour) = drawn.material.clone().map_or((String::new(), None), |(name, base)| (name, Some(base)));
    let name = if drawn.part.is_empty() { mesh.name.clone() } else { drawn.part.clone() };
    file.begin_part(FilePart { name, material, colour, ..FilePart::default() });
    file.points.extend(&mesh.positions);
    for triangle in &mesh.triangles {
        file.add_face(&triangle.map(|vertex| first_vertex + vertex));
    }
    // Pieces without a colour are white among those that have one.
    if !file.colours.is_empty() || !drawn.own_colours.is_empty() {
        file.colours.resize(first_vertex as usize, WHITE);
        file.colours.extend(&drawn.own_colours);
        file.colours.resize(file.points.len(), WHITE);
    }
    let normals = file.normals.get_or_insert_default();
    let first = normals.values.len() as u32;
    normals.values.extend(mesh.normals.iter().map(|normal| normal.as_dvec3()));
    let is_given = |vertex: u32| mesh.normals.get(vertex as usize).is_some_and(|normal| *normal != Vec3::ZERO);
    let of_corner = |&vertex: &u32| if is_given(vertex) { first + vertex } else { UvSet::NONE };
    normals.corners.extend(mesh.triangles.iter().flatten().map(of_corner));
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
