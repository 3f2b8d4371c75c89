//! What of a glTF document makes its shape and colours. All else, from animations to images, may be as it likes.

use super::super::failure::Failure;
use crate::io::IoError;
use crate::io::json::{parse, pointer_of};
use crate::scene::brief;
use serde::Deserialize;
use serde_json::{Map, Value};
use std::collections::BTreeMap;

/// The members of the document that are read, as the format names them; an index is a place in one of the lists.
#[derive(Debug, Default, Deserialize)]
#[serde(default, rename_all = "camelCase")]
pub(super) struct Document {
    pub(super) scene: Option<usize>,
    pub(super) scenes: Vec<Scene>,
    pub(super) nodes: Vec<Node>,
    pub(super) meshes: Vec<Mesh>,
    pub(super) accessors: Vec<Accessor>,
    pub(super) buffer_views: Vec<BufferView>,
    pub(super) buffers: Vec<Buffer>,
    pub(super) materials: Vec<Material>,
    pub(super) skins: Vec<Skin>,
    /// Looked into only where a motion is asked for.
    pub(super) animations: Value,
    pub(super) extensions_required: Vec<String>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(super) struct Scene {
    pub(super) nodes: Vec<usize>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(super) struct Node {
    /// Whatever stands there.
    pub(super) name: Value,
    pub(super) children: Vec<usize>,
    pub(super) mesh: Option<usize>,
    pub(super) skin: Option<usize>,
    pub(super) matrix: Option<[f64; 16]>,
    pub(super) translation: Option<[f64; 3]>,
    pub(super) rotation: Option<[f64; 4]>,
    pub(super) scale: Option<[f64; 3]>,
    pub(super) weights: Option<Vec<f64>>,
    pub(super) extensions: NodeExtensions,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(super) struct NodeExtensions {
    #[serde(rename = "EXT_mesh_gpu_instancing")]
    pub(super) instancing: Option<Instancing>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(super) struct Instancing {
    pub(super) attributes: BTreeMap<String, usize>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(super) struct Mesh {
    pub(super) name: Option<String>,
    pub(super) primitives: Vec<Primitive>,
    pub(super) weights: Vec<f64>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(super) struct Primitive {
    pub(super) attributes: BTreeMap<String, usize>,
    pub(super) indices: Option<usize>,
    pub(super) material: Option<usize>,
    pub(super) mode: Option<u32>,
    pub(super) targets: Vec<BTreeMap<String, usize>>,
    pub(super) extensions: Map<String, Value>,
    pub(super) extras: Value,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default, rename_all = "camelCase")]
pub(super) struct Accessor {
    pub(super) buffer_view: Option<usize>,
    pub(super) byte_offset: usize,
    pub(super) component_type: u32,
    pub(super) count: usize,
    #[serde(rename = "type")]
    pub(super) kind: String,
    pub(super) normalized: bool,
    pub(super) sparse: Option<Sparse>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(super) struct Sparse {
    pub(super) count: usize,
    pub(super) indices: SparsePart,
    pub(super) values: SparsePart,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default, rename_all = "camelCase")]
pub(super) struct SparsePart {
    pub(super) buffer_view: usize,
    pub(super) byte_offset: usize,
    pub(super) component_type: u32,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default, rename_all = "camelCase")]
pub(super) struct BufferView {
    pub(super) buffer: usize,
    pub(super) byte_offset: usize,
    pub(super) byte_length: usize,
    pub(super) byte_stride: Option<usize>,
    pub(super) extensions: Map<String, Value>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default, rename_all = "camelCase")]
pub(super) struct Buffer {
    pub(super) uri: Option<String>,
    pub(super) byte_length: usize,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default, rename_all = "camelCase")]
pub(super) struct Material {
    pub(super) name: String,
    pub(super) pbr_metallic_roughness: BaseColour,
}

#[derive(Debug, Deserialize)]
#[serde(default, rename_all = "camelCase")]
pub(super) struct BaseColour {
    pub(super) base_color_factor: [f32; 4],
}

impl Default for BaseColour {
    fn default() -> Self {
        Self { base_color_factor: [1.0; 4] }
    }
}

#[derive(Debug, Default, Deserialize)]
#[serde(default, rename_all = "camelCase")]
pub(super) struct Skin {
    pub(super) inverse_bind_matrices: Option<usize>,
    pub(super) joints: Vec<usize>,
}

impl Document {
    pub(super) fn read(text: &[u8]) -> Result<Self, Failure> {
        let text = str::from_utf8(text).map_err(|error| {
            Failure::new(format_args!("its text is not UTF-8 from byte {} on", error.valid_up_to()))
        })?;
        let mut value = parse(text).map_err(|error| match error {
            IoError::Syntax { line, column, .. } => {
                Failure::new(format_args!("line {line}, column {column}: its JSON breaks off or goes wrong there"))
            }
            other => Failure::Other(other),
        })?;
        check_version(&value)?;
        tidy(&mut value);
        serde_path_to_error::deserialize(&value).map_err(|error| {
            let pointer = pointer_of(error.path());
            let found = value.pointer(&pointer).map_or_else(|| "what is there".to_owned(), brief);
            Failure::new(format_args!("{pointer}: {found} is not what glTF has there"))
        })
    }
}

fn check_version(document: &Value) -> Result<(), Failure> {
    let Some(version) = document.pointer("/asset/version").and_then(Value::as_str) else {
        return Err(Failure::new("/asset/version is missing, which every glTF has"));
    };
    // Later versions of the second are readable by those who know the first.
    if version.starts_with("2.") {
        return Ok(());
    }
    Err(old_version(version))
}

/// A version that is not read.
pub(super) fn old_version(version: &str) -> Failure {
    Failure::with(format_args!("it is glTF {version}, and 2.0 is read"), "export or convert it as glTF 2.0")
}

/// Takes out members without a value, and writes whole numbers as such: both stand for what the format has there.
fn tidy(value: &mut Value) {
    match value {
        Value::Object(members) => {
            members.retain(|_, member| !member.is_null());
            members.values_mut().for_each(tidy);
        }
        Value::Array(items) => items.iter_mut().for_each(tidy),
        Value::Number(number) => {
            let whole = number.as_f64().filter(|x| number.is_f64() && x.fract() == 0.0 && (0.0..9e15).contains(x));
            if let Some(whole) = whole {
                *number = (whole as u64).into();
            }
        }
        _ => {}
    }
}
