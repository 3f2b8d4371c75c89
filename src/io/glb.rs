//! Models out, as GLB: one part, one colour.

use super::finite::{check_points, check_single};
use super::{IoError, write_atomically};
use crate::geometry::model::Model;
use glam::Vec3;
use serde_json::{Value, json};
use std::io;
use std::path::Path;

/// Writes a model as GLB, wholly or not at all. Numbers are single precision, as the format has them; indices take two
/// bytes where that is enough. The colour is that of the first vertex.
///
/// # Errors
/// As [`write_atomically`], [`IoError::NotFinite`] for a vertex, normal or colour that is no numbers, and
/// [`IoError::TooLargeForGlb`].
pub fn write_glb(path: &Path, model: &Model, name: &str) -> Result<(), IoError> {
    write_atomically(path, |out| {
        check_points(&model.positions, || "vertex".to_owned())?;
        let single: Vec<Vec3> = model.positions.iter().map(|p| p.as_vec3()).collect();
        check_single(&single, || "vertex".to_owned())?;
        check_single(&model.normals, || "normal".to_owned())?;
        let colours: Vec<Vec3> = model.colours.first().map(|&[r, g, b, _]| Vec3::new(r, g, b)).into_iter().collect();
        check_single(&colours, || "colour".to_owned())?;
        out.write_all(&to_glb(model, name).map_err(io::Error::other)?)
    })
}

// The format's numbers for types and uses of data.
pub(super) const FLOAT: u32 = 5126;
const SHORT: u32 = 5123;
const INT: u32 = 5125;
pub(super) const VERTICES: u32 = 34962;
const FACES: u32 = 34963;

/// What a primitive calls the part of a file that it is of, among what programs may add to it.
pub(super) const PART: &str = "part";

/// The binary part of a file, and what the document says of its pieces.
#[derive(Default)]
pub(super) struct Parts {
    pub(super) bin: Vec<u8>,
    pub(super) views: Vec<Value>,
    pub(super) accessors: Vec<Value>,
}

impl Parts {
    /// Adds data of vertices; returns its number. `accessor` says what it is made of.
    pub(super) fn add_vertices(&mut self, bytes: impl Iterator<Item = u8>, accessor: &Value) -> usize {
        self.add(bytes, VERTICES, accessor)
    }

    /// Adds data that is neither of vertices nor of faces.
    pub(super) fn add_plain(&mut self, bytes: impl Iterator<Item = u8>, accessor: &Value) -> usize {
        let index = self.add(bytes, VERTICES, accessor);
        if let Some(view) = self.views.last_mut().and_then(Value::as_object_mut) {
            view.remove("target");
        }
        index
    }

    /// Adds a piece; returns its number.
    fn add(&mut self, bytes: impl Iterator<Item = u8>, target: u32, accessor: &Value) -> usize {
        let start = self.bin.len();
        self.bin.extend(bytes);
        let length = self.bin.len() - start;
        // Pieces begin at multiples of four bytes.
        self.bin.resize(self.bin.len().next_multiple_of(4), 0);
        let index = self.accessors.len();
        self.views.push(json!({"buffer": 0, "byteOffset": start, "byteLength": length, "target": target}));
        let mut accessor = accessor.clone();
        accessor["bufferView"] = json!(index);
        self.accessors.push(accessor);
        index
    }
}

/// Adds faces over so many vertices; returns their number. Indices take two bytes where that is enough.
pub(super) fn indices_into(parts: &mut Parts, triangles: &[[u32; 3]], vertices: usize) -> usize {
    let indices = triangles.iter().flatten();
    let count = 3 * triangles.len();
    if u16::try_from(vertices).is_ok() {
        let bytes = indices.flat_map(|&i| (i as u16).to_le_bytes());
        parts.add(bytes, FACES, &json!({"componentType": SHORT, "count": count, "type": "SCALAR"}))
    } else {
        let bytes = indices.flat_map(|&i| i.to_le_bytes());
        parts.add(bytes, FACES, &json!({"componentType": INT, "count": count, "type": "SCALAR"}))
    }
}

/// What a file begins with before so many bytes of data: its head, the document, the head of the data.
///
/// # Errors
/// [`IoError::TooLargeForGlb`]: lengths are four bytes long.
pub(super) fn container_head(document: &Value, data: usize) -> Result<Vec<u8>, IoError> {
    let mut text = document.to_string().into_bytes();
    text.resize(text.len().next_multiple_of(4), b' ');
    let whole = 28 + text.len() + data;
    let length = u32::try_from(whole).map_err(|_| IoError::TooLargeForGlb { bytes: whole as u64 })?;
    let mut out = Vec::with_capacity(28 + text.len());
    out.extend(b"glTF");
    out.extend(2_u32.to_le_bytes());
    out.extend(length.to_le_bytes());
    // Both are parts of the whole.
    out.extend((text.len() as u32).to_le_bytes());
    out.extend(b"JSON");
    out.extend(text);
    out.extend((data as u32).to_le_bytes());
    out.extend(b"BIN\0");
    Ok(out)
}

fn to_glb(model: &Model, name: &str) -> Result<Vec<u8>, IoError> {
    let mut parts = Parts::default();
    let positions: Vec<[f32; 3]> = model.positions.iter().map(|p| p.as_vec3().to_array()).collect();
    let (mut min, mut max) = ([f32::INFINITY; 3], [f32::NEG_INFINITY; 3]);
    for p in &positions {
        for k in 0..3 {
            min[k] = min[k].min(p[k]);
            max[k] = max[k].max(p[k]);
        }
    }
    let indices = indices_into(&mut parts, &model.triangles, positions.len());
    let vectors = json!({"componentType": FLOAT, "count": positions.len(), "type": "VEC3"});
    let mut bounded = vectors.clone();
    (bounded["min"], bounded["max"]) = (json!(min), json!(max));
    let bytes = positions.iter().flatten().flat_map(|c| c.to_le_bytes());
    let mut attributes = json!({"POSITION": parts.add(bytes, VERTICES, &bounded)});
    if !model.normals.is_empty() {
        let bytes = model.normals.iter().flat_map(Vec3::to_array).flat_map(f32::to_le_bytes);
        attributes["NORMAL"] = json!(parts.add(bytes, VERTICES, &vectors));
    }
    let colour = model.colours.first().copied().unwrap_or([1.0; 4]);
    let Parts { bin, views, accessors } = parts;
    let document = json!({
        "asset": {"version": "2.0", "generator": "sinew"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0, "name": name}],
        "meshes": [{"name": name, "primitives": [{"attributes": attributes, "indices": indices, "material": 0}]}],
        "materials": [material(&colour)],
        "accessors": accessors,
        "bufferViews": views,
        "buffers": [{"byteLength": bin.len()}]
    });
    container(&document, bin)
}

/// The material of our own models, of a colour.
pub(super) fn material(colour: &[f32; 4]) -> Value {
    json!({"pbrMetallicRoughness": {"baseColorFactor": colour, "metallicFactor": 0.0, "roughnessFactor": 0.55}})
}

/// A document and its data, whole.
///
/// # Errors
/// More than four bytes can count.
pub(super) fn container(document: &Value, data: Vec<u8>) -> Result<Vec<u8>, IoError> {
    let mut out = container_head(document, data.len())?;
    out.extend(data);
    Ok(out)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_four_bytes_cannot_count_is_refused() {
        let head = |data| container_head(&json!({}), data);
        let most = u32::MAX as usize - 32;
        assert_eq!(head(most).map(|head| head[8..12].to_vec()).ok(), Some(vec![255; 4]));
        let error = head(most + 1).expect_err("it is one byte too long").to_string();
        assert!(error.contains("4294967296 bytes"), "{error}");
    }
}
