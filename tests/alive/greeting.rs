//! The motion of the character as its file says it, read by a reader of its own: joints alone, and what hangs on one of
//! them.

use glam::{DMat4, DQuat, DVec3, DVec4};
use serde_json::Value;
use std::fs;
use std::path::Path;

/// A chain of joints with cubic keys.
pub struct Greeting {
    json: Value,
    bin: Vec<u8>,
    parents: Vec<Option<usize>>,
    points: Vec<DVec3>,
    joints: Vec<[u8; 4]>,
    weights: Vec<[f32; 4]>,
}

impl Greeting {
    /// Reads a GLB.
    pub fn read(path: &Path) -> Self {
        let bytes = fs::read(path).expect("a file that is there");
        let length = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().expect("four bytes")) as usize;
        let text = length(12);
        let json: Value = serde_json::from_slice(&bytes[20..20 + text]).expect("a document");
        let bin = bytes[28 + text..].to_vec();
        let mut this =
            Self { json, bin, parents: Vec::new(), points: Vec::new(), joints: Vec::new(), weights: Vec::new() };
        let nodes = this.json["nodes"].as_array().expect("nodes").clone();
        this.parents = vec![None; nodes.len()];
        for (parent, node) in nodes.iter().enumerate() {
            for child in node["children"].as_array().into_iter().flatten() {
                this.parents[child.as_u64().expect("a number") as usize] = Some(parent);
            }
        }
        let attributes = this.json["meshes"][0]["primitives"][0]["attributes"].clone();
        let points = this.floats(&attributes["POSITION"]);
        this.points = points.chunks(3).map(|p| DVec3::new(p[0], p[1], p[2])).collect();
        let weights = this.floats(&attributes["WEIGHTS_0"]);
        this.weights = weights.chunks(4).map(|w| [0, 1, 2, 3].map(|k| w[k] as f32)).collect();
        this.joints = this.view(&attributes["JOINTS_0"]).chunks(4).map(|j| [j[0], j[1], j[2], j[3]]).collect();
        this
    }

    fn view(&self, accessor: &Value) -> &[u8] {
        let accessor = &self.json["accessors"][accessor.as_u64().expect("an accessor") as usize];
        let view = &self.json["bufferViews"][accessor["bufferView"].as_u64().expect("a view") as usize];
        let number = |name: &str| view[name].as_u64().expect("a number") as usize;
        &self.bin[number("byteOffset")..number("byteOffset") + number("byteLength")]
    }

    fn floats(&self, accessor: &Value) -> Vec<f64> {
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

    /// Where a point near a bone is at a time, where all of the skin that is nearest to it hangs on one joint; before
    /// the motion begins none.
    pub fn held_by_one(&self, at: DVec3, time: f64) -> Option<DVec3> {
        const BONES: [(usize, [f64; 3], [f64; 3]); 3] = [
            (1, [0.0, 0.15, -0.005], [0.0, 0.19, 0.0]),
            (3, [0.075, 0.164, 0.0], [0.12, 0.154, 0.0]),
            (5, [-0.075, 0.164, 0.0], [-0.12, 0.154, 0.0]),
        ];
        if time < 0.0 {
            return None;
        }
        let near = |(_, from, to): &&(usize, [f64; 3], [f64; 3])| {
            let (from, to) = (DVec3::from_array(*from), DVec3::from_array(*to));
            let s = (at - from).dot(to - from) / (to - from).length_squared();
            (0.0..=1.0).contains(&s) && at.distance(from.lerp(to, s)) < 0.014
        };
        let (joint, ..) = BONES.iter().find(near)?;
        let mut nearest: Vec<usize> = (0..self.points.len()).collect();
        nearest.sort_by(|&a, &b| self.points[a].distance(at).total_cmp(&self.points[b].distance(at)));
        let alone = |&vertex: &usize| {
            let held = self.joints[vertex].iter().zip(self.weights[vertex]);
            held.filter(|(of, _)| **of as usize == *joint).map(|(_, weight)| weight).sum::<f32>() > 0.999
        };
        if !nearest[..12].iter().all(alone) {
            return None;
        }
        let moved = self.world(*joint, Some(time)) * self.world(*joint, None).inverse();
        Some(moved.transform_point3(at))
    }
}
