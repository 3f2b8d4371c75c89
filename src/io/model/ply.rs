//! PLY, text and binary of either byte order.

use super::failure::Failure;
use super::polygon::triangulate;
use crate::geometry::model::{MeshData, Model};
use glam::{DVec3, Vec3};
use ply_rs_bw::parser::{Parser, Reader};
use ply_rs_bw::ply::{Property, PropertyAccess, PropertyAccessResult};

/// A vertex, a face or something that is read over.
#[derive(Clone, Debug, Default)]
struct Element {
    position: [f64; 3],
    normal: [f64; 3],
    colour: [u8; 3],
    has_normal: bool,
    has_colour: bool,
    corners: Vec<u32>,
}

impl PropertyAccess for Element {
    fn new() -> Self {
        Self::default()
    }

    fn set_property(&mut self, name: &str, property: Property) -> PropertyAccessResult {
        let number = || match property {
            Property::Double(value) => Some(value),
            _ => property.to_f32_lossy().map(f64::from),
        };
        match name {
            "x" | "y" | "z" => set(&mut self.position, name, &["x", "y", "z"], number()),
            "nx" | "ny" | "nz" => {
                self.has_normal = true;
                set(&mut self.normal, name, &["nx", "ny", "nz"], number())
            }
            "red" | "green" | "blue" => {
                self.has_colour = true;
                set(&mut self.colour, name, &["red", "green", "blue"], property.to_u8_color_lossy())
            }
            "vertex_indices" | "vertex_index" => {
                self.corners = indices(property);
                PropertyAccessResult::Set
            }
            _ => PropertyAccessResult::Ignored,
        }
    }
}

fn set<T>(all: &mut [T; 3], name: &str, names: &[&str; 3], value: Option<T>) -> PropertyAccessResult {
    let place = names.iter().position(|other| *other == name).and_then(|k| all.get_mut(k));
    match (place, value) {
        (Some(place), Some(value)) => {
            *place = value;
            PropertyAccessResult::Set
        }
        _ => PropertyAccessResult::UnsupportedType,
    }
}

/// Corners of a face; those below zero refer to nothing.
fn indices(property: Property) -> Vec<u32> {
    let signed = |i: i64| u32::try_from(i).unwrap_or(u32::MAX);
    match property {
        Property::ListChar(list) => list.into_iter().map(|i| signed(i.into())).collect(),
        Property::ListUChar(list) => list.into_iter().map(u32::from).collect(),
        Property::ListShort(list) => list.into_iter().map(|i| signed(i.into())).collect(),
        Property::ListUShort(list) => list.into_iter().map(u32::from).collect(),
        Property::ListInt(list) => list.into_iter().map(|i| signed(i.into())).collect(),
        Property::ListUInt(list) => list,
        _ => Vec::new(),
    }
}

pub(super) fn read(bytes: &[u8]) -> Result<Model, Failure> {
    let parser = Parser::<Element>::new();
    let mut reader = Reader::new(bytes);
    let header = parser.read_header(&mut reader).map_err(Failure::new)?;
    // Every element takes a byte at least. A header that claims more would be believed for as long as memory lasts.
    let claimed = header.elements.iter().map(|(_, element)| element.count).fold(0, usize::saturating_add);
    if claimed > bytes.len() {
        return Err(Failure::new("its header announces more than the file holds"));
    }
    let (mut vertices, mut faces) = (Vec::new(), Vec::new());
    for (name, element) in &header.elements {
        let read = parser.read_payload_for_element(&mut reader, element, &header).map_err(Failure::new)?;
        match name.as_str() {
            "vertex" => vertices = read,
            "face" => faces = read,
            _ => {}
        }
    }
    let positions: Vec<DVec3> = vertices.iter().map(|v| DVec3::from_array(v.position)).collect();
    let normals: Vec<Vec3> = vertices
        .iter()
        .filter(|v| v.has_normal)
        .map(|v| DVec3::from_array(v.normal).as_vec3().normalize_or_zero())
        .collect();
    let colours = vertices.iter().filter(|v| v.has_colour).map(|v| linear(v.colour)).collect();
    let mut triangles = Vec::with_capacity(faces.len());
    for face in &faces {
        triangulate(&face.corners, &positions, &mut triangles);
    }
    let mut model = Model::default();
    model.add(MeshData { name: String::new(), positions, normals, colours, triangles });
    Ok(model)
}

/// Colours of bytes are meant for the screen; light is computed with linear ones.
fn linear(colour: [u8; 3]) -> [f32; 4] {
    let [r, g, b] = colour.map(|byte| (f32::from(byte) / 255.0).powf(2.2));
    [r, g, b, 1.0]
}
