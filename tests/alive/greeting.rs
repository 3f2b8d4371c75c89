//! The motion of the character as its file says it, read by a reader of its own: joints, and what hangs on them,
//! linearly blended.

use glam::{DMat4, DQuat, DVec3, DVec4};
use serde_json::Value;
use std::fs;
use std::path::Path;

/// A chain of joints with cubic keys, and the skin on them.
pub struct Greeting {
    pub json: Value,
    bin: Vec<u8>,
    parents: Vec<Option<usize>>,
    /// Nodes of the joints.
    nodes: Vec<usize>,
    inverse_binds: Vec<DMat4>,
    points: Vec<DVec3>,
    triangles: Vec<[usize; 3]>,
    /// Joints that hold a vertex, and their shares.
    pub held: Vec<[(usize, f64); 4]>,
}

/// How a place hangs on joints.
pub struct Hung {
    joints: Vec<(usize, f64)>,
    /// Where it is in the frame in which the skin was bound.
    point: DVec3,
}

impl Greeting {
    /// Reads a GLB.
    pub fn read(path: &Path) -> Self {
        let bytes = fs::read(path).expect("a file that is there");
        let length = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().expect("four bytes")) as usize;
        let text = length(12);
        let json: Value = serde_json::from_slice(&bytes[20..20 + text]).expect("a document");
        let bin = bytes[28 + text..].to_vec();
        let (parents, inverse_binds) = (Vec::new(), Vec::new());
        let (nodes, points, triangles, held) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        let mut this = Self { json, bin, parents, nodes, inverse_binds, points, triangles, held };
        let nodes = this.json["nodes"].as_array().expect("nodes").clone();
        this.parents = vec![None; nodes.len()];
        for (parent, node) in nodes.iter().enumerate() {
            for child in node["children"].as_array().into_iter().flatten() {
                this.parents[child.as_u64().expect("a number") as usize] = Some(parent);
            }
        }
        let skin = this.json["skins"][0].clone();
        let joints = skin["joints"].as_array().expect("joints");
        this.nodes = joints.iter().map(|node| node.as_u64().expect("a number") as usize).collect();
        let binds = this.floats(&skin["inverseBindMatrices"]);
        this.inverse_binds = binds.chunks(16).map(DMat4::from_cols_slice).collect();
        let primitive = this.json["meshes"][0]["primitives"][0].clone();
        let attributes = &primitive["attributes"];
        let points = this.floats(&attributes["POSITION"]);
        this.points = points.chunks(3).map(|p| DVec3::new(p[0], p[1], p[2])).collect();
        let accessor = &this.json["accessors"][primitive["indices"].as_u64().expect("an accessor") as usize];
        // Two bytes each, or four.
        let width = if accessor["componentType"] == 5123 { 2 } else { 4 };
        let index = |bytes: &[u8]| bytes.iter().rev().fold(0, |sum, byte| 256 * sum + usize::from(*byte));
        let indices: Vec<usize> = this.view(&primitive["indices"]).chunks(width).map(index).collect();
        this.triangles = indices.chunks(3).map(|corners| [corners[0], corners[1], corners[2]]).collect();
        let weights = this.floats(&attributes["WEIGHTS_0"]);
        let joints = this.view(&attributes["JOINTS_0"]).chunks(4).zip(weights.chunks(4));
        let held = joints.map(|(joints, weights)| [0, 1, 2, 3].map(|k| (usize::from(joints[k]), weights[k])));
        this.held = held.collect();
        this
    }

    fn view(&self, accessor: &Value) -> &[u8] {
        let accessor = &self.json["accessors"][accessor.as_u64().expect("an accessor") as usize];
        let view = &self.json["bufferViews"][accessor["bufferView"].as_u64().expect("a view") as usize];
        let number = |name: &str| view[name].as_u64().expect("a number") as usize;
        &self.bin[number("byteOffset")..number("byteOffset") + number("byteLength")]
    }

    /// The numbers of an accessor.
    pub fn floats(&self, accessor: &Value) -> Vec<f64> {
        let number = |four: &[u8]| f64::from(f32::from_le_bytes(four.try_into().expect("four bytes")));
        self.view(accessor).chunks(4).map(number).collect()
    }

    /// A part of a node's place at a time, as its cubic keys have it (tangents are zero), or as it stands.
    fn part(&self, node: usize, path: &str, time: f64) -> Option<DVec4> {
        let animation = &self.json["animations"][0];
        let channels = animation["channels"].as_array().expect("channels");
        let of = |channel: &&Value| channel["target"]["node"] == node && channel["target"]["path"] == path;
        let channel = channels.iter().find(of)?;
        let sampler = &animation["samplers"][channel["sampler"].as_u64().expect("a number") as usize];
        assert_eq!(sampler["interpolation"], "CUBICSPLINE");
        let times = self.floats(&sampler["input"]);
        let width = if path == "rotation" { 4 } else { 3 };
        let rows = self.floats(&sampler["output"]);
        let value = |key: usize| {
            let row = &rows[(3 * key + 1) * width..(3 * key + 2) * width];
            DVec4::new(row[0], row[1], row[2], row.get(3).copied().unwrap_or(0.0))
        };
        let time = time.clamp(times[0], times[times.len() - 1]);
        let key = times.iter().rposition(|&key| key <= time).expect("a key").min(times.len() - 2);
        let s = (time - times[key]) / (times[key + 1] - times[key]);
        let smooth = s * s * (3.0 - 2.0 * s);
        Some((1.0 - smooth) * value(key) + smooth * value(key + 1))
    }

    fn local(&self, node: usize, time: Option<f64>) -> DMat4 {
        let stands = |name: &str| {
            let part = self.json["nodes"][node][name].as_array().expect("a part");
            part.iter().map(|c| c.as_f64().expect("a number")).collect::<Vec<f64>>()
        };
        let keyed = |path: &str| time.and_then(|time| self.part(node, path, time));
        let shift = keyed("translation").map_or_else(|| DVec3::from_slice(&stands("translation")), DVec4::truncate);
        let turn = keyed("rotation").unwrap_or_else(|| DVec4::from_slice(&stands("rotation")));
        DMat4::from_rotation_translation(DQuat::from_vec4(turn.normalize()), shift)
    }

    fn world(&self, node: usize, time: Option<f64>) -> DMat4 {
        let own = self.local(node, time);
        self.parents[node].map_or(own, |parent| self.world(parent, time) * own)
    }

    /// Whether a place is as near as this [m] to a bone, which leads from a joint to one that hangs on it.
    pub fn is_near_a_bone(&self, at: DVec3, distance: f64) -> bool {
        let joint = |node: usize| self.world(node, None).w_axis.truncate();
        let ends = self.nodes.iter().filter_map(|&node| Some([joint(self.parents[node]?), joint(node)]));
        ends.into_iter().any(|[from, to]| {
            let s = ((at - from).dot(to - from) / (to - from).length_squared()).clamp(0.0, 1.0);
            at.distance(from.lerp(to, s)) <= distance
        })
    }

    /// How a place at rest hangs on joints: as the skin does where that is nearest.
    pub fn hung(&self, at: DVec3) -> Hung {
        let mut nearest = (f64::INFINITY, [0; 3], [0.0; 3]);
        for &corners in &self.triangles {
            let shares = closest(corners.map(|corner| self.points[corner]), at);
            let foot: DVec3 = corners.iter().zip(shares).map(|(&corner, share)| share * self.points[corner]).sum();
            if at.distance(foot) < nearest.0 {
                nearest = (at.distance(foot), corners, shares);
            }
        }
        let mut shares = vec![0.0; self.nodes.len()];
        for (corner, share) in nearest.1.into_iter().zip(nearest.2) {
            let whole: f64 = self.held[corner].iter().map(|(_, weight)| weight).sum();
            for (joint, weight) in self.held[corner] {
                shares[joint] += share * weight / whole;
            }
        }
        let joints: Vec<_> = shares.into_iter().enumerate().filter(|(_, share)| *share != 0.0).collect();
        let point = self.blend(&joints, None).inverse().transform_point3(at);
        Hung { joints, point }
    }

    fn blend(&self, joints: &[(usize, f64)], time: Option<f64>) -> DMat4 {
        let map = |joint: usize| self.world(self.nodes[joint], time) * self.inverse_binds[joint];
        joints.iter().fold(DMat4::ZERO, |sum, &(joint, share)| sum + map(joint) * share)
    }

    /// Where what hangs so is at a time of the motion.
    pub fn place(&self, hung: &Hung, time: f64) -> DVec3 {
        self.blend(&hung.joints, Some(time)).transform_point3(hung.point)
    }
}

/// The shares of the corners of a triangle in the point of it that is nearest to a place.
fn closest([a, b, c]: [DVec3; 3], at: DVec3) -> [f64; 3] {
    let normal = (b - a).cross(c - a);
    let share = |one: DVec3, other: DVec3| (one - at).cross(other - at).dot(normal) / normal.length_squared();
    let within = [share(b, c), share(c, a), share(a, b)];
    if within.iter().all(|share| *share >= 0.0) {
        return within;
    }
    let mut nearest = (f64::INFINITY, [0.0; 3]);
    for (k, [from, to]) in [[a, b], [b, c], [c, a]].into_iter().enumerate() {
        let s = ((at - from).dot(to - from) / (to - from).length_squared()).clamp(0.0, 1.0);
        let far = at.distance(from.lerp(to, s));
        if far < nearest.0 {
            let mut shares = [0.0; 3];
            (shares[k], shares[(k + 1) % 3]) = (1.0 - s, s);
            nearest = (far, shares);
        }
    }
    nearest.1
}
