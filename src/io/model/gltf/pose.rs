//! Where the nodes of a glTF document put its meshes before anything moves: the pose that the file itself has.

use super::super::failure::Failure;
use super::accessor::{Accessors, Whole};
use super::document::{Document, Node};
use glam::{DMat4, DQuat, DVec3};

/// Nodes within nodes, at most: deeper ones are a loop.
pub(super) const DEEPEST: usize = 256;

/// The map from a node's frame to its parent's.
pub(super) fn local(node: &Node) -> DMat4 {
    if let Some(matrix) = &node.matrix {
        return DMat4::from_cols_array(matrix);
    }
    let turn = node.rotation.map_or(DQuat::IDENTITY, quaternion);
    let scale = node.scale.map_or(DVec3::ONE, DVec3::from_array);
    let shift = node.translation.map_or(DVec3::ZERO, DVec3::from_array);
    DMat4::from_scale_rotation_translation(scale, turn, shift)
}

/// A rotation, whatever the length of its numbers.
pub(super) fn quaternion(xyzw: [f64; 4]) -> DQuat {
    let [x, y, z, w] = xyzw;
    let length = xyzw.iter().map(|c| c * c).sum::<f64>().sqrt();
    // Only those that are off are mended, so that all others keep their bits.
    let off = length > 0.0 && (length - 1.0).abs() > 1e-3;
    if off { DQuat::from_xyzw(x / length, y / length, z / length, w / length) } else { DQuat::from_xyzw(x, y, z, w) }
}

/// The maps from the frames of all nodes to the world.
pub(super) fn worlds(document: &Document) -> Vec<DMat4> {
    let mut parents = vec![None; document.nodes.len()];
    for (parent, node) in document.nodes.iter().enumerate() {
        for &child in &node.children {
            if let Some(place) = parents.get_mut(child) {
                *place = Some(parent);
            }
        }
    }
    let world = |node: usize| {
        let above = std::iter::successors(Some(node), |&node| parents[node]).take(DEEPEST);
        above.fold(DMat4::IDENTITY, |world, node| local(&document.nodes[node]) * world)
    };
    (0..document.nodes.len()).map(world).collect()
}

/// The maps of a skin's joints: from the mesh's frame to the world, by way of each joint as it was bound. The node that
/// shows the mesh has no say in it.
pub(super) fn joints(skin: usize, accessors: &Accessors<'_>, worlds: &[DMat4]) -> Result<Vec<DMat4>, Failure> {
    let Some(found) = accessors.document.skins.get(skin) else {
        return Err(Failure::new(format_args!("skins[{skin}] is referred to and not there")));
    };
    let bound = match found.inverse_bind_matrices {
        Some(index) => accessors.read(index, &["MAT4"], Whole::AsSaid, &format!("bind matrices of skins[{skin}]"))?,
        None => super::accessor::Rows::default(),
    };
    let mut bound = bound.rows();
    let joints = found.joints.iter().map(|&joint| {
        let world = worlds.get(joint).copied();
        let inverse = match bound.next() {
            Some(row) => DMat4::from_cols_slice(row),
            None => DMat4::IDENTITY,
        };
        let missing = || Failure::new(format_args!("skins[{skin}] refers to nodes[{joint}], which is not there"));
        world.map(|world| world * inverse).ok_or_else(missing)
    });
    joints.collect()
}

/// The places in which a node shows its mesh: one, or those that EXT_mesh_gpu_instancing lists.
pub(super) fn instances(node: &Node, place: DMat4, accessors: &Accessors<'_>) -> Result<Vec<DMat4>, Failure> {
    let Some(instancing) = &node.extensions.instancing else { return Ok(vec![place]) };
    let read = |name: &str, kind: &str| match instancing.attributes.get(name) {
        Some(&index) => accessors.read(index, &[kind], Whole::AsSaid, &format!("{name} of instances")).map(Some),
        None => Ok(None),
    };
    let (shifts, turns, scales) = (read("TRANSLATION", "VEC3")?, read("ROTATION", "VEC4")?, read("SCALE", "VEC3")?);
    let count = [&shifts, &turns, &scales].into_iter().flatten().map(|rows| rows.rows().len()).min();
    let Some(count) = count else { return Ok(vec![place]) };
    let vector = |rows: &Option<super::accessor::Rows>, k: usize, missing| {
        rows.as_ref().and_then(|rows| rows.rows().nth(k)).map_or(missing, DVec3::from_slice)
    };
    let turn = |k: usize| turns.as_ref().and_then(|rows| rows.rows().nth(k)?.try_into().ok());
    let instance = |k| {
        let turn = turn(k).map_or(DQuat::IDENTITY, quaternion);
        let (scale, shift) = (vector(&scales, k, DVec3::ONE), vector(&shifts, k, DVec3::ZERO));
        place * DMat4::from_scale_rotation_translation(scale, turn, shift)
    };
    Ok((0..count).map(instance).collect())
}
