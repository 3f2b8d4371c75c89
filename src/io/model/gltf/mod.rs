//! glTF 2.0, as text with its buffers and as GLB: meshes of the default scene, in the places and the pose that its
//! nodes, skins and morph targets give them.
//!
//! Read here, from JSON on: the crates that read glTF 2.0 refuse files for parts that have nothing to do with their
//! shape, read nothing where data is missing, and fall over numbers of other types than a vertex usually has.

mod accessor;
mod animation;
mod buffers;
mod container;
mod document;
mod extensions;
mod own_mesh;
mod pose;
mod primitive;
mod skeleton;

pub(super) use self::skeleton::read_skeleton;

use self::accessor::Accessors;
use self::buffers::decode_percent;
use self::container::Container;
use self::document::Document;
use self::pose::{DEEPEST, instances, joints, local, worlds};
use self::primitive::{Piece, Pose};
use super::failure::Failure;
use crate::geometry::file_mesh::FileMesh;
use crate::geometry::model::Model;
use crate::io::json::parse;
use glam::DMat4;
use std::path::Path;
use std::sync::Arc;

pub(super) fn read(bytes: &[u8], folder: &Path) -> Result<Model, Failure> {
    let Container { json, bin } = Container::open(bytes)?;
    let document = Document::read(&json)?;
    let notes = extensions::left_out(&document.extensions_required)?;
    let accessors = Accessors::new(&document, json.len(), folder, bin);
    let model = Model { notes, ..Model::default() };
    let mut reader =
        Reader { accessors: &accessors, worlds: worlds(&document), model, file: FileMesh::default(), visited: 0 };
    match document.scene.map_or_else(|| document.scenes.first(), |scene| document.scenes.get(scene)) {
        Some(scene) => scene.nodes.iter().try_for_each(|&node| reader.add_node(node, DMat4::IDENTITY, 0))?,
        None if document.scene.is_some() => return Err(Failure::new("/scene refers to a scene that is not there")),
        // A library of meshes, each where it was made.
        None => (0..document.meshes.len())
            .try_for_each(|mesh| reader.add_mesh(mesh, &[], &Pose::Placed(DMat4::IDENTITY)))?,
    }
    reader.file.complete_normals();
    Ok(Model { file: Some(Arc::new(reader.file)), ..reader.model })
}

/// Files that a document names, by their paths from its folder.
pub(super) fn named_files(bytes: &[u8]) -> Result<Vec<String>, Failure> {
    let Container { json, .. } = Container::open(bytes)?;
    let document = parse(&String::from_utf8_lossy(&json)).map_err(Failure::Other)?;
    let lists = ["buffers", "images"].into_iter().filter_map(|list| document[list].as_array());
    let names = lists.flatten().filter_map(|item| item["uri"].as_str());
    let is_file = |uri: &&str| !uri.starts_with("data:") && !uri.contains("://");
    Ok(names.filter(is_file).map(|uri| decode_percent(uri).replace('\\', "/")).collect())
}

/// Times that nodes are shown which were shown before, at most: a document has each once.
const MOST_AGAIN: usize = 100_000;

struct Reader<'a, 'b> {
    accessors: &'a Accessors<'b>,
    worlds: Vec<DMat4>,
    model: Model,
    file: FileMesh,
    visited: usize,
}

impl Reader<'_, '_> {
    fn add_node(&mut self, index: usize, parent: DMat4, depth: usize) -> Result<(), Failure> {
        let document = self.accessors.document;
        let Some(node) = document.nodes.get(index) else {
            return Err(Failure::new(format_args!("nodes[{index}] is referred to and not there")));
        };
        self.visited += 1;
        if depth > DEEPEST || self.visited > document.nodes.len() + MOST_AGAIN {
            return Err(Failure::new(format_args!("its nodes contain each other, at nodes[{index}]")));
        }
        let place = parent * local(node);
        if let Some(mesh) = node.mesh {
            let weights = node.weights.as_deref().unwrap_or_default();
            if let Some(skin) = node.skin {
                let joints = joints(skin, self.accessors, &self.worlds)?;
                self.add_mesh(mesh, weights, &Pose::Skinned(&joints))?;
            } else {
                for place in instances(node, place, self.accessors)? {
                    self.add_mesh(mesh, weights, &Pose::Placed(place))?;
                }
            }
        }
        node.children.iter().try_for_each(|&child| self.add_node(child, place, depth + 1))
    }

    fn add_mesh(&mut self, index: usize, weights: &[f64], pose: &Pose<'_>) -> Result<(), Failure> {
        let accessors = self.accessors;
        let Some(mesh) = accessors.document.meshes.get(index) else {
            return Err(Failure::new(format_args!("meshes[{index}] is referred to and not there")));
        };
        let weights = if weights.is_empty() { &mesh.weights } else { weights };
        for (number, primitive) in mesh.primitives.iter().enumerate() {
            let name = format!("meshes[{index}].primitives[{number}]");
            accessors.keep(1)?;
            let piece = Piece { accessors, mesh, primitive, name, weights };
            if let Some(drawn) = piece.read(pose)? {
                // Faces take half as much memory as vertices do.
                accessors.keep(drawn.mesh.positions.len() + drawn.mesh.triangles.len() / 2)?;
                own_mesh::add_piece(&mut self.file, &drawn);
                self.model.add(drawn.mesh);
            }
        }
        Ok(())
    }
}
