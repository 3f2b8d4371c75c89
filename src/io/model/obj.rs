//! Wavefront OBJ with its MTL: objects are parts, a material's diffuse colour is their colour.

use super::failure::Failure;
use super::limits::MAX_MODEL_BYTES;
use super::polygon::triangulate;
use crate::geometry::model::{MeshData, Model};
use crate::io::read::read_bytes;
use glam::{DVec3, Vec3};
use std::path::Path;
use tobj::{LoadError, LoadOptions};

pub(super) fn read(mut bytes: &[u8], folder: &Path) -> Result<Model, Failure> {
    let options = LoadOptions { single_index: true, ignore_lines: true, ignore_points: true, ..LoadOptions::default() };
    // A model without its colours is still a model.
    let materials = |path: &Path| match read_bytes(&folder.join(path), MAX_MODEL_BYTES) {
        Ok(bytes) => tobj::load_mtl_buf(&mut bytes.as_slice()),
        Err(_) => Err(LoadError::OpenFileFailed),
    };
    let (objects, materials) = tobj::load_obj_buf(&mut bytes, &options, materials).map_err(Failure::new)?;
    let materials = materials.unwrap_or_default();
    let mut model = Model::default();
    for object in objects {
        let mesh = object.mesh;
        let positions: Vec<DVec3> = mesh.positions.chunks_exact(3).map(DVec3::from_slice).collect();
        let normals = mesh.normals.chunks_exact(3).map(|n| DVec3::from_slice(n).as_vec3().normalize_or_zero());
        let normals: Vec<Vec3> = normals.collect();
        let diffuse = mesh.material_id.and_then(|id| materials.get(id)).and_then(|material| material.diffuse);
        let colours = if mesh.vertex_color.is_empty() {
            diffuse.map_or_else(Vec::new, |colour| vec![linear(colour); positions.len()])
        } else {
            mesh.vertex_color.chunks_exact(3).map(|c| linear([c[0], c[1], c[2]])).collect()
        };
        let mut triangles = Vec::with_capacity(mesh.indices.len() / 3);
        if mesh.face_arities.is_empty() {
            triangles.extend(mesh.indices.chunks_exact(3).map(|t| [t[0], t[1], t[2]]));
        } else {
            let mut rest = mesh.indices.as_slice();
            for &arity in &mesh.face_arities {
                let Some((face, behind)) = rest.split_at_checked(arity as usize) else { break };
                triangulate(face, &positions, &mut triangles);
                rest = behind;
            }
        }
        model.add(MeshData { name: object.name, positions, normals, colours, triangles });
    }
    Ok(model)
}

/// Colours of OBJ files are meant for the screen; light is computed with linear ones.
fn linear([r, g, b]: [f64; 3]) -> [f32; 4] {
    let [r, g, b] = [r, g, b].map(|c| if c <= 0.04045 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) } as f32);
    [r, g, b, 1.0]
}
