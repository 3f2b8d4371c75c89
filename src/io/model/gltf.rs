//! glTF 2.0, as text with its buffers and as GLB: meshes of the default scene, in the places that its nodes give them.

use super::failure::Failure;
use super::limits::{MAX_MODEL_BYTES, MOST};
use crate::geometry::model::{MeshData, Model};
use crate::io::read::read_bytes;
use glam::{DMat3, DMat4, DVec3, Vec3};
use gltf::mesh::Mode;
use gltf::{Gltf, Node, Primitive, buffer};
use std::path::Path;

/// Nodes within nodes, at most: deeper ones are a loop.
const DEEPEST: usize = 256;

pub(super) fn read(bytes: &[u8], folder: &Path) -> Result<Model, Failure> {
    let file = Gltf::from_slice(bytes).map_err(Failure::new)?;
    let buffers = buffers(&file, folder)?;
    if file.accessors().any(|accessor| accessor.count() > MOST) {
        return Err(Failure::new("it announces more data than it can hold"));
    }
    let mut reader = Reader { buffers: &buffers, model: Model::default(), visited: 0 };
    match file.default_scene().or_else(|| file.scenes().next()) {
        Some(scene) => scene.nodes().try_for_each(|node| reader.add_node(&node, DMat4::IDENTITY, 0))?,
        // A library of meshes, each where it was made.
        None => file.meshes().for_each(|mesh| reader.add_mesh(&mesh, DMat4::IDENTITY)),
    }
    Ok(reader.model)
}

fn buffers(file: &Gltf, folder: &Path) -> Result<Vec<Vec<u8>>, Failure> {
    file.buffers()
        .map(|buffer| match buffer.source() {
            buffer::Source::Bin => file.blob.clone().ok_or_else(|| Failure::new("its binary part is missing")),
            buffer::Source::Uri(uri) => from_uri(uri, folder),
        })
        .collect()
}

/// Data in the document itself or in a file beside it.
fn from_uri(uri: &str, folder: &Path) -> Result<Vec<u8>, Failure> {
    if let Some(data) = uri.strip_prefix("data:") {
        let (_, text) = data.split_once(";base64,").ok_or_else(|| Failure::new("its data is not base64"))?;
        return decode_base64(text).ok_or_else(|| Failure::new("its base64 data is damaged"));
    }
    let path = folder.join(decode_percent(uri));
    read_bytes(&path, MAX_MODEL_BYTES).map_err(|error| Failure::Other(error.within(&path)))
}

struct Reader<'a> {
    buffers: &'a [Vec<u8>],
    model: Model,
    visited: usize,
}

impl Reader<'_> {
    fn add_node(&mut self, node: &Node<'_>, parent: DMat4, depth: usize) -> Result<(), Failure> {
        self.visited += 1;
        if depth > DEEPEST || self.visited > MOST {
            return Err(Failure::new("its nodes contain each other"));
        }
        let local = DMat4::from_cols_array_2d(&node.transform().matrix().map(|column| column.map(f64::from)));
        let place = parent * local;
        if let Some(mesh) = node.mesh() {
            self.add_mesh(&mesh, place);
        }
        if self.model.positions.len() > MOST {
            return Err(Failure::new("its nodes repeat too many vertices"));
        }
        node.children().try_for_each(|child| self.add_node(&child, place, depth + 1))
    }

    fn add_mesh(&mut self, mesh: &gltf::Mesh<'_>, place: DMat4) {
        for primitive in mesh.primitives() {
            let piece = self.piece(&primitive, mesh.name().unwrap_or_default(), place);
            if !piece.triangles.is_empty() {
                self.model.add(piece);
            }
        }
    }

    fn piece(&self, primitive: &Primitive<'_>, name: &str, place: DMat4) -> MeshData {
        let reader = primitive.reader(|buffer| self.buffers.get(buffer.index()).map(Vec::as_slice));
        let to_place = |p: [f32; 3]| place.transform_point3(DVec3::from_array(p.map(f64::from)));
        let positions: Vec<DVec3> = reader.read_positions().into_iter().flatten().map(to_place).collect();
        let turn = DMat3::from_mat4(place).inverse().transpose();
        let to_normal = |n: [f32; 3]| (turn * DVec3::from_array(n.map(f64::from))).as_vec3().normalize_or_zero();
        let normals: Vec<Vec3> = reader.read_normals().into_iter().flatten().map(to_normal).collect();
        let base = primitive.material().pbr_metallic_roughness().base_color_factor();
        let colours = match reader.read_colors(0) {
            Some(colours) => colours.into_rgba_f32().map(|c| [0, 1, 2, 3].map(|k| c[k] * base[k])).collect(),
            None => vec![base; positions.len()],
        };
        let indices: Vec<u32> = match reader.read_indices() {
            Some(indices) => indices.into_u32().collect(),
            None => (0..positions.len() as u32).collect(),
        };
        let mut triangles = triangles_of(&indices, primitive.mode());
        // A mirroring node turns faces inside out.
        if DMat3::from_mat4(place).determinant() < 0.0 {
            for t in &mut triangles {
                t.swap(1, 2);
            }
        }
        MeshData { name: name.to_owned(), positions, normals, colours, triangles }
    }
}

fn triangles_of(indices: &[u32], mode: Mode) -> Vec<[u32; 3]> {
    match mode {
        Mode::Triangles => indices.chunks_exact(3).map(|t| [t[0], t[1], t[2]]).collect(),
        Mode::TriangleStrip => {
            // Every second one is wound the other way.
            let strip = indices.windows(3).enumerate();
            strip.map(|(k, t)| if k % 2 == 0 { [t[0], t[1], t[2]] } else { [t[1], t[0], t[2]] }).collect()
        }
        Mode::TriangleFan => {
            indices.get(1..).unwrap_or_default().windows(2).map(|t| [indices[0], t[0], t[1]]).collect()
        }
        _ => Vec::new(),
    }
}

fn decode_base64(text: &str) -> Option<Vec<u8>> {
    let mut bytes = Vec::with_capacity(text.len() / 4 * 3);
    let (mut bits, mut count) = (0_u32, 0);
    for c in text.bytes().filter(|&c| c != b'=') {
        let value = match c {
            b'A'..=b'Z' => c - b'A',
            b'a'..=b'z' => c - b'a' + 26,
            b'0'..=b'9' => c - b'0' + 52,
            b'+' | b'-' => 62,
            b'/' | b'_' => 63,
            _ => return None,
        };
        bits = bits << 6 | u32::from(value);
        count += 6;
        if count >= 8 {
            count -= 8;
            bytes.push((bits >> count) as u8);
        }
    }
    Some(bytes)
}

/// Names of files in a glTF are written as in web addresses.
fn decode_percent(text: &str) -> String {
    let mut bytes = Vec::with_capacity(text.len());
    let mut rest = text.as_bytes();
    while let [first, behind @ ..] = rest {
        let code = behind.get(..2).and_then(|two| std::str::from_utf8(two).ok());
        let byte = code.filter(|_| *first == b'%').and_then(|code| u8::from_str_radix(code, 16).ok());
        bytes.push(byte.unwrap_or(*first));
        rest = if byte.is_some() { &behind[2..] } else { behind };
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn data_in_text_is_decoded() {
        assert_eq!(decode_base64("c2luZXc=").as_deref(), Some(b"sinew".as_slice()));
        assert_eq!(decode_base64("c2lu*"), None);
        assert_eq!(decode_percent("my%20part%.bin"), "my part%.bin");
    }

    #[test]
    fn strips_and_fans_keep_their_sense() {
        assert_eq!(triangles_of(&[0, 1, 2, 3], Mode::TriangleStrip), [[0, 1, 2], [2, 1, 3]]);
        assert_eq!(triangles_of(&[0, 1, 2, 3], Mode::TriangleFan), [[0, 1, 2], [0, 2, 3]]);
        assert!(triangles_of(&[], Mode::TriangleFan).is_empty());
    }
}
