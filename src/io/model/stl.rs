//! STL, binary and text. It has neither parts nor units, and its normals say no more than its corners.

use super::failure::Failure;
use crate::geometry::model::{MeshData, Model};
use glam::DVec3;
use std::io::Cursor;

/// Bytes before the first facet, and of each.
const HEADER: usize = 84;
const FACET: usize = 50;

pub(super) fn read(mut bytes: Vec<u8>) -> Result<Model, Failure> {
    // Text begins with "solid", but so do some binary files: their length gives them away.
    let count = bytes.get(80..HEADER).and_then(|count| count.try_into().ok()).map_or(0, u32::from_le_bytes);
    let is_binary = HEADER + FACET * count as usize == bytes.len();
    if is_binary {
        bytes[..80].fill(0);
    } else if let Some(line) = first_line_of_text(&bytes) {
        // The reader wants a name.
        bytes.splice(..line, *b"solid model");
    }
    let mesh = stl_io::read_stl(&mut Cursor::new(bytes)).map_err(Failure::new)?;
    let mut model = Model::default();
    model.add(MeshData {
        positions: mesh.vertices.iter().map(|v| DVec3::from_array(v.0.map(f64::from))).collect(),
        triangles: mesh.faces.iter().map(|face| face.vertices.map(|i| i as u32)).collect(),
        ..MeshData::default()
    });
    Ok(model)
}

/// Length of the first line of a text file.
fn first_line_of_text(bytes: &[u8]) -> Option<usize> {
    let is_text = bytes.starts_with(b"solid") && bytes.get(5).is_none_or(u8::is_ascii_whitespace);
    is_text.then(|| bytes.iter().position(|&b| b == b'\n' || b == b'\r').unwrap_or(bytes.len()))
}
