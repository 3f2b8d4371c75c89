//! The skeleton of a glTF document: its nodes, the joints of its skins, the meshes that hang on them, and its
//! animations.

use super::super::failure::Failure;
use super::super::text::shortened;
use super::accessor::{Accessors, Rows, Whole};
use super::animation::clips;
use super::container::Container;
use super::document::Document;
use super::extensions;
use super::pose::{DEEPEST, local, quaternion};
use super::primitive::{Piece, TRIANGLES, triangles_of};
use crate::geometry::skeleton::{Joint, Node, Parts, Place, Skeleton, SkinMesh};
use crate::scene::one_line;
use glam::{DMat4, DQuat, DVec3};
use serde_json::Value;
use std::path::Path;

/// What helps where a file has no motion in it.
const WITH_RIG: &str = "export it with its armature, skin and animations";

/// Reads a skeleton, in the file's own unit and axes.
pub(in super::super) fn read_skeleton(bytes: &[u8], folder: &Path) -> Result<Skeleton, Failure> {
    let Container { json, bin } = Container::open(bytes)?;
    let document = Document::read(&json)?;
    extensions::left_out(&document.extensions_required)?;
    let accessors = Accessors::new(&document, json.len(), folder, bin);
    let (order, nodes) = nodes(&document)?;
    let (joints, first_joints) = joints(&accessors, &order)?;
    if joints.is_empty() {
        return Err(Failure::with("it has no skin: nothing in it hangs on joints", WITH_RIG));
    }
    let mut skeleton = Skeleton { nodes, joints, clips: clips(&accessors, &order)?, skin: SkinMesh::default() };
    if skeleton.clips.is_empty() {
        return Err(Failure::with("it has no animation that moves anything", WITH_RIG));
    }
    let shown: Vec<DMat4> = skeleton.joint_maps(0, Skeleton::AT_REST).into_iter().map(|[map, _]| map).collect();
    if let Some(joint) = shown.iter().position(|map| !map.is_finite()) {
        let name = one_line(&skeleton.joints[joint].name);
        return Err(Failure::new(format_args!("the joint \"{name}\" is at no place: one of its numbers is none")));
    }
    for (index, node) in document.nodes.iter().enumerate() {
        let (Some(mesh), Some(skin)) = (node.mesh, node.skin) else { continue };
        let Some(&first) = first_joints.get(skin) else {
            return Err(Failure::new(format_args!("nodes[{index}] refers to skins[{skin}], which is not there")));
        };
        let count = document.skins[skin].joints.len();
        add_mesh(&accessors, (mesh, &node.weights), (first, &shown[first..first + count]), &mut skeleton.skin)?;
    }
    if skeleton.skin.triangles.is_empty() {
        return Err(Failure::with("no mesh hangs on its joints", WITH_RIG));
    }
    Ok(skeleton)
}

/// The nodes, parents before children, and where each of the document's stands among them.
fn nodes(document: &Document) -> Result<(Vec<usize>, Vec<Node>), Failure> {
    let count = document.nodes.len();
    let mut parents = vec![None; count];
    for (parent, node) in document.nodes.iter().enumerate() {
        for &child in &node.children {
            let Some(place) = parents.get_mut(child) else {
                return Err(Failure::new(format_args!("nodes[{child}] is referred to and not there")));
            };
            *place = Some(parent);
        }
    }
    let depth = |node: usize| std::iter::successors(parents[node], |&node| parents[node]).take(DEEPEST + 1).count();
    let depths: Vec<usize> = (0..count).map(depth).collect();
    if let Some(node) = depths.iter().position(|&depth| depth > DEEPEST) {
        return Err(Failure::new(format_args!("its nodes contain each other, at nodes[{node}]")));
    }
    let mut sorted: Vec<usize> = (0..count).collect();
    sorted.sort_by_key(|&node| depths[node]);
    let mut order = vec![0; count];
    for (place, &node) in sorted.iter().enumerate() {
        order[node] = place;
    }
    let made = sorted.iter().map(|&index| {
        let node = &document.nodes[index];
        let place = if node.matrix.is_some() {
            Place::Map(local(node))
        } else {
            Place::Parts(Parts {
                shift: node.translation.map_or(DVec3::ZERO, DVec3::from_array),
                turn: node.rotation.map_or(DQuat::IDENTITY, |turn| quaternion(turn).normalize()),
                scale: node.scale.map_or(DVec3::ONE, DVec3::from_array),
            })
        };
        Node { parent: parents[index].map(|parent| order[parent]), place }
    });
    let made = made.collect();
    Ok((order, made))
}

/// The joints of all skins, one skin after the other, and the first of each.
fn joints(accessors: &Accessors<'_>, order: &[usize]) -> Result<(Vec<Joint>, Vec<usize>), Failure> {
    let document = accessors.document;
    let (mut all, mut firsts): (Vec<Joint>, _) = (Vec::new(), Vec::new());
    for (index, skin) in document.skins.iter().enumerate() {
        firsts.push(all.len());
        let bound = match skin.inverse_bind_matrices {
            Some(at) => accessors.read(at, &["MAT4"], Whole::AsSaid, &format!("bind matrices of skins[{index}]"))?,
            None => Rows::default(),
        };
        let mut bound = bound.rows();
        for &joint in &skin.joints {
            let Some(&node) = order.get(joint) else {
                let problem = format_args!("skins[{index}] refers to nodes[{joint}], which is not there");
                return Err(Failure::new(problem));
            };
            let name = match &document.nodes[joint].name {
                Value::String(name) if !name.trim().is_empty() => shortened(name),
                _ => format!("nodes[{joint}]"),
            };
            let inverse_bind = bound.next().map_or(DMat4::IDENTITY, DMat4::from_cols_slice);
            all.push(Joint { name, node, inverse_bind });
        }
    }
    Ok((all, firsts))
}

/// Adds a mesh that hangs on joints, whose maps and first number are given, where the file shows it.
fn add_mesh(
    accessors: &Accessors<'_>,
    (index, weights): (usize, &Option<Vec<f64>>),
    (first, joints): (usize, &[DMat4]),
    skin: &mut SkinMesh,
) -> Result<(), Failure> {
    let Some(mesh) = accessors.document.meshes.get(index) else {
        return Err(Failure::new(format_args!("meshes[{index}] is referred to and not there")));
    };
    let weights = weights.as_deref().unwrap_or(&mesh.weights);
    for (number, primitive) in mesh.primitives.iter().enumerate() {
        let mode = primitive.mode.unwrap_or(TRIANGLES);
        if !(TRIANGLES..=TRIANGLES + 2).contains(&mode) {
            continue;
        }
        let name = format!("meshes[{index}].primitives[{number}]");
        accessors.keep(1)?;
        let piece = Piece { accessors, mesh, primitive, name, weights };
        piece.refuse_compressed()?;
        let positions = piece.vectors("POSITION")?;
        let triangles = triangles_of(&piece.indices(positions.len())?, mode);
        piece.check(&triangles, &positions)?;
        accessors.keep(positions.len() + triangles.len() / 2)?;
        let mut held: Vec<Vec<(u32, f64)>> = vec![Vec::new(); positions.len()];
        piece.each_hold(joints.len(), &mut |vertex, joint, weight| {
            if let Some(held) = held.get_mut(vertex) {
                held.push((joint, weight));
            }
        })?;
        let base = skin.points.len() as u32;
        for (position, held) in positions.iter().zip(&mut held) {
            let sum: f64 = held.iter().map(|(_, weight)| weight).sum();
            if !sum.is_finite() {
                return Err(Failure::new(format_args!("{}: a weight of its skin is no number", piece.name)));
            }
            // A vertex that nothing holds goes with the first joint.
            if sum == 0.0 {
                *held = vec![(0, 1.0)];
            } else {
                for (_, weight) in held.iter_mut() {
                    *weight /= sum;
                }
            }
            let map = held.iter().fold(DMat4::ZERO, |map, &(joint, weight)| map + joints[joint as usize] * weight);
            skin.points.push(map.transform_point3(*position));
            for (joint, _) in held.iter_mut() {
                *joint += first as u32;
            }
        }
        skin.held.append(&mut held);
        skin.triangles.extend(triangles.iter().map(|triangle| triangle.map(|vertex| base + vertex)));
    }
    Ok(())
}
