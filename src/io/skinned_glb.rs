//! Models that hang on a skeleton, out, as GLB.

use super::finite::{check_points, check_single};
use super::glb::{FLOAT, Parts, container, indices_into, material};
use super::{IoError, write_atomically};
use crate::geometry::model::Model;
use crate::geometry::skeleton::{Clip, Moves, Place, Skeleton};
use crate::geometry::track::Between;
use glam::{DVec4, Vec3};
use serde_json::{Value, json};
use std::io;
use std::path::Path;

const BYTE: u32 = 5121;

/// Joints that hold a vertex, at most: the format takes them by fours.
const MOST_JOINTS: usize = 4;

/// Writes a model as GLB with the skeleton that it hangs on, whose skin has a point for each of the model's vertices,
/// wholly or not at all. Numbers are single precision.
///
/// # Errors
/// As [`write_atomically`], and for a vertex or normal that is no numbers.
pub(crate) fn write_skinned_glb(path: &Path, model: &Model, skeleton: &Skeleton, name: &str) -> Result<(), IoError> {
    write_atomically(path, |out| {
        check_points(&model.positions, || "vertex".to_owned())?;
        check_single(&model.normals, || "normal".to_owned())?;
        out.write_all(&to_glb(model, skeleton, name).map_err(io::Error::other)?)
    })
}

fn floats(values: impl IntoIterator<Item = f64>) -> impl Iterator<Item = u8> {
    values.into_iter().flat_map(|value| (value as f32).to_le_bytes())
}

fn to_glb(model: &Model, skeleton: &Skeleton, name: &str) -> Result<Vec<u8>, IoError> {
    let mut parts = Parts::default();
    let count = model.positions.len();
    let accessor = |kind: &str, count: usize| json!({"componentType": FLOAT, "count": count, "type": kind});
    let indices = indices_into(&mut parts, &model.triangles, count);
    let single: Vec<Vec3> = model.positions.iter().map(|point| point.as_vec3()).collect();
    let mut positions = accessor("VEC3", count);
    let least = single.iter().copied().fold(Vec3::INFINITY, Vec3::min);
    let greatest = single.iter().copied().fold(Vec3::NEG_INFINITY, Vec3::max);
    (positions["min"], positions["max"]) = (json!(least.to_array()), json!(greatest.to_array()));
    let bytes = single.iter().flat_map(Vec3::to_array).flat_map(f32::to_le_bytes);
    let mut attributes = json!({"POSITION": parts.add_vertices(bytes, &positions)});
    if !model.normals.is_empty() {
        let bytes = model.normals.iter().flat_map(Vec3::to_array).flat_map(f32::to_le_bytes);
        attributes["NORMAL"] = json!(parts.add_vertices(bytes, &accessor("VEC3", count)));
    }
    let held = |of: &Vec<(u32, f64)>| {
        let mut row = [(0, 0.0); MOST_JOINTS];
        row.iter_mut().zip(of).for_each(|(place, joint)| *place = *joint);
        row
    };
    let rows: Vec<[(u32, f64); MOST_JOINTS]> = skeleton.skin.held.iter().map(held).collect();
    let joints = rows.iter().flatten().map(|(joint, _)| *joint as u8);
    let bytes = json!({"componentType": BYTE, "count": count, "type": "VEC4"});
    attributes["JOINTS_0"] = json!(parts.add_vertices(joints, &bytes));
    let weights = floats(rows.iter().flatten().map(|(_, weight)| *weight));
    attributes["WEIGHTS_0"] = json!(parts.add_vertices(weights, &accessor("VEC4", count)));
    let bound = skeleton.joints.iter().flat_map(|joint| joint.inverse_bind.to_cols_array());
    let bound = parts.add_plain(floats(bound), &accessor("MAT4", skeleton.joints.len()));
    let animations: Vec<Value> = skeleton.clips.iter().map(|clip| animation(clip, &mut parts)).collect();
    let mesh_node = skeleton.nodes.len();
    let mut nodes: Vec<Value> = (0..mesh_node).map(|index| node(skeleton, index)).collect();
    nodes.push(json!({"mesh": 0, "skin": 0, "name": name}));
    let roots = (0..mesh_node).filter(|&node| skeleton.nodes[node].parent.is_none());
    let shown: Vec<usize> = roots.chain([mesh_node]).collect();
    let colour = model.colours.first().copied().unwrap_or([1.0; 4]);
    let joints: Vec<usize> = skeleton.joints.iter().map(|joint| joint.node).collect();
    let Parts { bin, views, accessors } = parts;
    let document = json!({
        "asset": {"version": "2.0", "generator": "sinew"},
        "scene": 0,
        "scenes": [{"nodes": shown}],
        "nodes": nodes,
        "meshes": [{"name": name, "primitives": [{"attributes": attributes, "indices": indices, "material": 0}]}],
        "materials": [material(&colour)],
        "skins": [{"joints": joints, "inverseBindMatrices": bound}],
        "animations": animations,
        "accessors": accessors,
        "bufferViews": views,
        "buffers": [{"byteLength": bin.len()}]
    });
    container(&document, bin)
}

fn node(skeleton: &Skeleton, index: usize) -> Value {
    let mut made = match skeleton.nodes[index].place {
        Place::Map(map) => json!({"matrix": map.to_cols_array()}),
        Place::Parts(parts) => json!({
            "translation": parts.shift.to_array(), "rotation": parts.turn.to_array(), "scale": parts.scale.to_array()
        }),
    };
    let nodes = skeleton.nodes.iter().enumerate();
    let children: Vec<usize> = nodes.filter(|(_, node)| node.parent == Some(index)).map(|(child, _)| child).collect();
    if !children.is_empty() {
        made["children"] = json!(children);
    }
    if let Some(joint) = skeleton.joints.iter().find(|joint| joint.node == index) {
        made["name"] = json!(joint.name);
    }
    made
}

fn animation(clip: &Clip, parts: &mut Parts) -> Value {
    let (mut channels, mut samplers) = (Vec::new(), Vec::new());
    for channel in &clip.channels {
        let track = &channel.track;
        let count = track.times.len();
        let mut times = json!({"componentType": FLOAT, "count": count, "type": "SCALAR"});
        (times["min"], times["max"]) = (json!([track.times[0] as f32]), json!([track.times[count - 1] as f32]));
        let input = parts.add_plain(floats(track.times.iter().copied()), &times);
        let (path, kind, width) = match channel.moves {
            Moves::Shift => ("translation", "VEC3", 3),
            Moves::Scale => ("scale", "VEC3", 3),
            Moves::Turn => ("rotation", "VEC4", 4),
        };
        let (rows, interpolation): (Vec<DVec4>, _) = match &track.between {
            Between::Stepped => (track.values.clone(), "STEP"),
            Between::Linear => (track.values.clone(), "LINEAR"),
            Between::Cubic(tangents) => {
                let keys = track.values.iter().zip(tangents);
                (keys.flat_map(|(value, [into, out])| [*into, *value, *out]).collect(), "CUBICSPLINE")
            }
        };
        let values = rows.iter().flat_map(|row| row.to_array().into_iter().take(width));
        let accessor = json!({"componentType": FLOAT, "count": rows.len(), "type": kind});
        let output = parts.add_plain(floats(values), &accessor);
        channels.push(json!({"sampler": samplers.len(), "target": {"node": channel.node, "path": path}}));
        samplers.push(json!({"input": input, "output": output, "interpolation": interpolation}));
    }
    json!({"name": clip.name, "channels": channels, "samplers": samplers})
}
