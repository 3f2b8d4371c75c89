//! glTF documents made for tests.

use crate::cases::{CORNERS, triangles};
use serde_json::{Value, json};

/// A document and its bytes.
pub struct Document {
    pub json: Value,
    pub bin: Vec<u8>,
}

impl Document {
    /// A cube of 8 m³ at one node.
    pub fn cube() -> Self {
        let mut document = Self {
            json: json!({
                "asset": {"version": "2.0"},
                "scene": 0,
                "scenes": [{"nodes": [0]}],
                "nodes": [{"mesh": 0}],
                "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
                "accessors": [],
                "bufferViews": []
            }),
            bin: Vec::new(),
        };
        document.accessor(5126, "VEC3", 8, floats(CORNERS.as_flattened()));
        let indices = triangles().into_iter().flatten().flat_map(|i| (i as u16).to_le_bytes()).collect();
        document.accessor(5123, "SCALAR", 36, indices);
        document
    }

    /// Adds an accessor with a view of its own; gives its number.
    pub fn accessor(&mut self, component: u32, kind: &str, count: usize, bytes: Vec<u8>) -> usize {
        let views = self.json["bufferViews"].as_array_mut().expect("a list");
        let view = views.len();
        self.bin.resize(self.bin.len().next_multiple_of(4), 0);
        views.push(json!({"buffer": 0, "byteOffset": self.bin.len(), "byteLength": bytes.len()}));
        self.bin.extend(bytes);
        let accessors = self.json["accessors"].as_array_mut().expect("a list");
        accessors.push(json!({"bufferView": view, "componentType": component, "count": count, "type": kind}));
        accessors.len() - 1
    }

    /// Sets a member, by its pointer; it need not have been there.
    pub fn set(mut self, pointer: &str, value: Value) -> Self {
        if let Some(place) = self.json.pointer_mut(pointer) {
            *place = value;
        } else {
            let (parent, name) = pointer.rsplit_once('/').expect("a pointer");
            self.json.pointer_mut(parent).unwrap_or_else(|| panic!("{pointer}"))[name] = value;
        }
        self
    }

    pub fn text(&self) -> Vec<u8> {
        let mut json = self.json.clone();
        if json.get("buffers").is_none() {
            json["buffers"] = json!([{"byteLength": self.bin.len(), "uri": data_uri(&self.bin)}]);
        }
        json.to_string().into_bytes()
    }

    pub fn glb(&self) -> Vec<u8> {
        let mut json = self.json.clone();
        json["buffers"] = json!([{"byteLength": self.bin.len()}]);
        let mut text = json.to_string().into_bytes();
        text.resize(text.len().next_multiple_of(4), b' ');
        let mut bin = self.bin.clone();
        bin.resize(bin.len().next_multiple_of(4), 0);
        let word = |value: usize| (value as u32).to_le_bytes();
        [
            b"glTF".as_slice(),
            &word(2),
            &word(28 + text.len() + bin.len()),
            &word(text.len()),
            b"JSON",
            &text,
            &word(bin.len()),
            b"BIN\0",
            &bin,
        ]
        .concat()
    }
}

pub fn floats(values: &[f64]) -> Vec<u8> {
    values.iter().flat_map(|value| (*value as f32).to_le_bytes()).collect()
}

pub fn data_uri(bytes: &[u8]) -> String {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = "data:application/octet-stream;base64,".to_owned();
    for chunk in bytes.chunks(3) {
        let bits = chunk.iter().fold(0_u32, |bits, byte| bits << 8 | u32::from(*byte)) << (8 * (3 - chunk.len()));
        let digits = (0..=chunk.len()).map(|k| char::from(DIGITS[(bits >> (18 - 6 * k) & 63) as usize]));
        text.extend(digits);
        text.extend(std::iter::repeat_n('=', 3 - chunk.len()));
    }
    text
}
