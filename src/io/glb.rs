//! Models out, as GLB: one part, smooth normals, one colour.

use super::{IoError, write_atomically};
use crate::geometry::model::Model;
use serde_json::json;
use std::path::Path;

/// Writes a model as GLB, wholly or not at all. Numbers are single precision, as the format has them; indices take two
/// bytes where that is enough. The colour is that of the first vertex.
///
/// # Errors
/// As [`write_atomically`].
pub fn write_glb(path: &Path, model: &Model, name: &str) -> Result<(), IoError> {
    let bytes = to_glb(model, name);
    write_atomically(path, |out| out.write_all(&bytes))
}

const FLOAT: u32 = 5126;
const SHORT: u32 = 5123;
const INT: u32 = 5125;

fn to_glb(model: &Model, name: &str) -> Vec<u8> {
    let mut bin: Vec<u8> = Vec::new();
    let mut views = Vec::new();
    let mut close = |bin: &mut Vec<u8>, target: u32| {
        let start = views.iter().map(|view: &serde_json::Value| view["end"].as_u64().unwrap_or(0)).max().unwrap_or(0);
        let length = bin.len() as u64 - start;
        // Views begin at multiples of four bytes.
        bin.resize(bin.len().next_multiple_of(4), 0);
        views.push(json!({"start": start, "length": length, "end": bin.len(), "target": target}));
    };
    let positions: Vec<[f32; 3]> = model.positions.iter().map(|p| p.as_vec3().to_array()).collect();
    let (mut min, mut max) = ([f32::INFINITY; 3], [f32::NEG_INFINITY; 3]);
    for p in &positions {
        for k in 0..3 {
            min[k] = min[k].min(p[k]);
            max[k] = max[k].max(p[k]);
        }
    }
    bin.extend(positions.iter().flatten().flat_map(|c| c.to_le_bytes()));
    close(&mut bin, 34962);
    bin.extend(model.normals.iter().flat_map(|n| n.to_array()).flat_map(f32::to_le_bytes));
    close(&mut bin, 34962);
    let indices = model.triangles.iter().flatten();
    let short = positions.len() <= usize::from(u16::MAX);
    if short {
        bin.extend(indices.flat_map(|&i| (i as u16).to_le_bytes()));
    } else {
        bin.extend(indices.flat_map(|&i| i.to_le_bytes()));
    }
    close(&mut bin, 34963);

    let mut attributes = json!({"POSITION": 0});
    if !model.normals.is_empty() {
        attributes["NORMAL"] = json!(1);
    }
    let colour = model.colours.first().copied().unwrap_or([1.0; 4]);
    let views: Vec<_> = views
        .iter()
        .map(|view| {
            json!({"buffer": 0, "byteOffset": view["start"], "byteLength": view["length"], "target": view["target"]})
        })
        .collect();
    let kind = if short { SHORT } else { INT };
    let document = json!({
        "asset": {"version": "2.0", "generator": "sinew"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0, "name": name}],
        "meshes": [{"name": name, "primitives": [{"attributes": attributes, "indices": 2, "material": 0}]}],
        "materials": [{"pbrMetallicRoughness": {
            "baseColorFactor": colour, "metallicFactor": 0.0, "roughnessFactor": 0.55
        }}],
        "accessors": [
            {"bufferView": 0, "componentType": FLOAT, "count": positions.len(), "type": "VEC3", "min": min, "max": max},
            {"bufferView": 1, "componentType": FLOAT, "count": model.normals.len(), "type": "VEC3"},
            {"bufferView": 2, "componentType": kind, "count": 3 * model.triangles.len(), "type": "SCALAR"}
        ],
        "bufferViews": views,
        "buffers": [{"byteLength": bin.len()}]
    });
    let mut text = document.to_string().into_bytes();
    text.resize(text.len().next_multiple_of(4), b' ');

    let total = 12 + 8 + text.len() + 8 + bin.len();
    let mut out = Vec::with_capacity(total);
    out.extend(b"glTF");
    out.extend(2_u32.to_le_bytes());
    out.extend((total as u32).to_le_bytes());
    for (kind, chunk) in [(b"JSON", &text), (b"BIN\0", &bin)] {
        out.extend((chunk.len() as u32).to_le_bytes());
        out.extend(kind);
        out.extend(chunk.iter());
    }
    out
}
