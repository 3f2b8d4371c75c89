//! A column on a skeleton of two joints, and caches of its vertices, written for tests.

use glam::{DQuat, DVec3};
use serde_json::{Value, json};
use sinew::geometry::{Cuboid, TriangleMesh, box_surface};
use std::fs;
use std::path::{Path, PathBuf};
use tempfile::TempDir;

/// Where the upper joint is [m].
pub const ELBOW: DVec3 = DVec3::new(0.0, 0.06, 0.0);

/// Seconds that the upper joint takes to turn, steadily, and by which angle about z [rad].
pub const SECONDS: f64 = 0.4;
pub const ANGLE: f64 = 0.8;

/// A folder with `rig.gltf`, which names `rig.bin`.
pub struct Rig {
    pub folder: TempDir,
    pub json: Value,
    pub bin: Vec<u8>,
}

/// The column: 4 by 12 by 4 cm on the origin.
pub fn column() -> TriangleMesh {
    box_surface(&Cuboid { center: 0.06 * DVec3::Y, size: DVec3::new(0.04, 0.12, 0.04) }, 0.01)
}

fn floats(values: impl IntoIterator<Item = f64>) -> Vec<u8> {
    values.into_iter().flat_map(|value| (value as f32).to_le_bytes()).collect()
}

impl Rig {
    /// The lower joint, "base", at the origin, stands still; "tip" holds what is above 7 cm alone, and shares with it
    /// from 5 cm on.
    pub fn column() -> Self {
        let mesh = column();
        let count = mesh.positions.len();
        let json = json!({
            "asset": {"version": "2.0"},
            "scene": 0,
            "scenes": [{"nodes": [0, 2]}],
            "nodes": [
                {"name": "base", "children": [1]},
                {"name": "tip", "translation": ELBOW.to_array()},
                {"mesh": 0, "skin": 0}
            ],
            "meshes": [{"primitives": [{
                "attributes": {"POSITION": 0, "JOINTS_0": 1, "WEIGHTS_0": 2}, "indices": 3
            }]}],
            "skins": [{"joints": [0, 1], "inverseBindMatrices": 4}],
            "animations": [{
                "name": "nod",
                "channels": [{"sampler": 0, "target": {"node": 1, "path": "rotation"}}],
                "samplers": [{"input": 5, "output": 6, "interpolation": "LINEAR"}]
            }],
            "accessors": [],
            "bufferViews": []
        });
        let mut rig = Self { folder: tempfile::tempdir().expect("a folder"), json, bin: Vec::new() };
        let upper = |y: f64| ((y - 0.05) / 0.02).clamp(0.0, 1.0);
        rig.accessor(5126, "VEC3", count, floats(mesh.positions.iter().flat_map(DVec3::to_array)));
        rig.accessor(5121, "VEC4", count, mesh.positions.iter().flat_map(|_| [0, 1, 0, 0]).collect());
        let shares = mesh.positions.iter().flat_map(|at| [1.0 - upper(at.y), upper(at.y), 0.0, 0.0]);
        rig.accessor(5126, "VEC4", count, floats(shares));
        let indices = mesh.triangles.iter().flatten().flat_map(|vertex| vertex.to_le_bytes()).collect();
        rig.accessor(5125, "SCALAR", 3 * mesh.triangles.len(), indices);
        let bind = |at: DVec3| glam::DMat4::from_translation(-at).to_cols_array();
        rig.accessor(5126, "MAT4", 2, floats([bind(DVec3::ZERO), bind(ELBOW)].concat()));
        rig.accessor(5126, "SCALAR", 2, floats([0.0, SECONDS]));
        let turns = [DQuat::IDENTITY, DQuat::from_rotation_z(ANGLE)];
        rig.accessor(5126, "VEC4", 2, floats(turns.iter().flat_map(DQuat::to_array)));
        rig.write();
        rig
    }

    /// Adds an accessor with a view of its own.
    pub fn accessor(&mut self, component: u32, kind: &str, count: usize, bytes: Vec<u8>) -> usize {
        self.bin.resize(self.bin.len().next_multiple_of(4), 0);
        let view = json!({"buffer": 0, "byteOffset": self.bin.len(), "byteLength": bytes.len()});
        self.bin.extend(bytes);
        let views = self.json["bufferViews"].as_array_mut().expect("a list");
        views.push(view);
        let view = views.len() - 1;
        let accessor = json!({"bufferView": view, "componentType": component, "count": count, "type": kind});
        let accessors = self.json["accessors"].as_array_mut().expect("a list");
        accessors.push(accessor);
        accessors.len() - 1
    }

    /// Adds an accessor of numbers.
    pub fn numbers(&mut self, kind: &str, count: usize, values: impl IntoIterator<Item = f64>) -> usize {
        self.accessor(5126, kind, count, floats(values))
    }

    pub fn write(&mut self) {
        self.json["buffers"] = json!([{"byteLength": self.bin.len(), "uri": "rig.bin"}]);
        fs::write(self.folder.path().join("rig.bin"), &self.bin).expect("a file");
        fs::write(self.folder.path().join("rig.gltf"), self.json.to_string()).expect("a file");
    }

    pub fn path(&self) -> &Path {
        self.folder.path()
    }
}

/// Writes a PC2 or an MDD file, by how its name ends, of the column's vertices at times [s]; those of a PC2 are frames.
pub fn write_cache(folder: &Path, name: &str, times: &[f64], at: impl Fn(DVec3, f64) -> DVec3) -> PathBuf {
    let points = column().positions;
    let samples = times.iter().flat_map(|&time| points.iter().map(move |&point| (point, time)));
    let values: Vec<f32> = samples.flat_map(|(point, time)| at(point, time).as_vec3().to_array()).collect();
    let mut bytes = Vec::new();
    if Path::new(name).extension().is_some_and(|ending| ending == "pc2") {
        bytes.extend(b"POINTCACHE2\0");
        bytes.extend(1_u32.to_le_bytes());
        bytes.extend((points.len() as u32).to_le_bytes());
        bytes.extend(7_f32.to_le_bytes());
        bytes.extend(1_f32.to_le_bytes());
        bytes.extend((times.len() as u32).to_le_bytes());
        bytes.extend(values.iter().flat_map(|value| value.to_le_bytes()));
    } else {
        bytes.extend([times.len() as u32, points.len() as u32].into_iter().flat_map(u32::to_be_bytes));
        bytes.extend(times.iter().flat_map(|time| (*time as f32).to_be_bytes()));
        bytes.extend(values.iter().flat_map(|value| value.to_be_bytes()));
    }
    let path = folder.join(name);
    fs::write(&path, bytes).expect("a file");
    path
}
