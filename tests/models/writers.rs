//! Small writers of models, for tests.

use serde_json::{Value, json};
use sinew::geometry::Model;
use std::fmt::Write;

/// OBJ, all digits.
pub fn obj(model: &Model) -> Vec<u8> {
    let mut text = String::new();
    for p in &model.positions {
        writeln!(text, "v {} {} {}", p.x, p.y, p.z).expect("written");
    }
    for [a, b, c] in &model.triangles {
        writeln!(text, "f {} {} {}", a + 1, b + 1, c + 1).expect("written");
    }
    text.into_bytes()
}

/// PLY in double precision; `format` as its header names it.
pub fn ply(model: &Model, format: &str) -> Vec<u8> {
    let (vertices, faces) = (model.positions.len(), model.triangles.len());
    let mut bytes = format!(
        "ply\nformat {format} 1.0\nelement vertex {vertices}\nproperty double x\nproperty double y\nproperty double z\n\
         element face {faces}\nproperty list uchar uint vertex_indices\nend_header\n"
    )
    .into_bytes();
    for p in &model.positions {
        match format {
            "ascii" => bytes.extend(format!("{} {} {}\n", p.x, p.y, p.z).bytes()),
            "binary_little_endian" => bytes.extend(p.to_array().iter().flat_map(|c| c.to_le_bytes())),
            _ => bytes.extend(p.to_array().iter().flat_map(|c| c.to_be_bytes())),
        }
    }
    for [a, b, c] in &model.triangles {
        match format {
            "ascii" => bytes.extend(format!("3 {a} {b} {c}\n").bytes()),
            "binary_little_endian" => {
                bytes.extend([3].into_iter().chain([a, b, c].iter().flat_map(|i| i.to_le_bytes())));
            }
            _ => bytes.extend([3].into_iter().chain([a, b, c].iter().flat_map(|i| i.to_be_bytes()))),
        }
    }
    bytes
}

/// STL in text, single precision.
pub fn stl_text(model: &Model) -> Vec<u8> {
    let mut text = "solid mesh\n".to_owned();
    for t in &model.triangles {
        text += "facet normal 0 0 0\nouter loop\n";
        for p in t.map(|i| model.positions[i as usize]) {
            writeln!(text, "vertex {} {} {}", p.x, p.y, p.z).expect("written");
        }
        text += "endloop\nendfacet\n";
    }
    (text + "endsolid mesh\n").into_bytes()
}

/// Binary STL.
pub fn stl(model: &Model) -> Vec<u8> {
    let mut bytes = vec![b' '; 80];
    bytes.extend((model.triangles.len() as u32).to_le_bytes());
    for t in &model.triangles {
        bytes.extend([0; 12]);
        let corners = t.map(|i| model.positions[i as usize].as_vec3().to_array());
        bytes.extend(corners.iter().flatten().flat_map(|c| c.to_le_bytes()));
        bytes.extend([0; 2]);
    }
    bytes
}

/// glTF in text, its data within as a URI; single precision.
pub fn gltf(model: &Model) -> Vec<u8> {
    let (mut document, bin) = gltf_parts(model);
    document["buffers"][0]["uri"] = json!(format!("data:application/octet-stream;base64,{}", base64(&bin)));
    document.to_string().into_bytes()
}

/// GLB, single precision.
pub fn glb(model: &Model) -> Vec<u8> {
    let (document, bin) = gltf_parts(model);
    let mut text = document.to_string().into_bytes();
    text.resize(text.len().next_multiple_of(4), b' ');
    let mut bytes = b"glTF".to_vec();
    let number = |count: usize| (count as u32).to_le_bytes();
    bytes.extend([number(2), number(12 + 8 + text.len() + 8 + bin.len())].concat());
    bytes.extend([&number(text.len())[..], b"JSON", &text, &number(bin.len()), b"BIN\0", &bin].concat());
    bytes
}

/// Document and data: positions, then indices.
fn gltf_parts(model: &Model) -> (Value, Vec<u8>) {
    let corners: Vec<[f32; 3]> = model.positions.iter().map(|p| p.as_vec3().to_array()).collect();
    let mut bin: Vec<u8> = corners.iter().flatten().flat_map(|c| c.to_le_bytes()).collect();
    let positions = bin.len();
    bin.extend(model.triangles.iter().flatten().flat_map(|i| i.to_le_bytes()));
    let bound = |start: f32, of: fn(f32, f32) -> f32| -> Vec<f32> {
        (0..3).map(|k| corners.iter().map(|c| c[k]).fold(start, of)).collect()
    };
    let document = json!({
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": corners.len(),
             "min": bound(f32::INFINITY, f32::min), "max": bound(f32::NEG_INFINITY, f32::max)},
            {"bufferView": 1, "componentType": 5125, "type": "SCALAR", "count": 3 * model.triangles.len()},
        ],
        "bufferViews": [
            {"buffer": 0, "byteOffset": 0, "byteLength": positions},
            {"buffer": 0, "byteOffset": positions, "byteLength": bin.len() - positions},
        ],
        "buffers": [{"byteLength": bin.len()}],
    });
    (document, bin)
}

fn base64(bytes: &[u8]) -> String {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::new();
    for three in bytes.chunks(3) {
        let bits = (0..3).fold(0_u32, |bits, k| bits << 8 | u32::from(three.get(k).copied().unwrap_or(0)));
        for k in 0..4 {
            let digit = char::from(DIGITS[(bits >> (18 - 6 * k)) as usize & 63]);
            text.push(if k <= three.len() { digit } else { '=' });
        }
    }
    text
}
