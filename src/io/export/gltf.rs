//! glTF 2.0 as GLB: bodies with a morph target a frame, and an animation that goes from one to the next.
//!
//! All targets of a mesh are in a viewer's memory at once, so that this is for short clips. Numbers are single
//! precision, in metres with Y up whatever is asked for elsewhere: the format knows no other unit or axis.

use super::gltf_clip::ClipMesh;
use super::looks::Look;
use super::republished::Republished;
use super::writer::{MotionWriter, Planned};
use crate::export::{Frame, Space, Subject};
use crate::geometry::file_mesh::FilePart;
use crate::io::IoError;
use crate::io::glb::{FLOAT, PART, Parts, container_head, indices_into};
use glam::{DVec3, Vec3};
use serde_json::{Value, json};
use std::collections::HashMap;
use std::path::{Path, PathBuf};

/// Most frames, and bytes of all their targets together.
const MOST_FRAMES: u64 = 600;
const MOST_BYTES: u64 = 512 << 20;

/// Bytes of a vector.
pub(super) const VECTOR: usize = 12;

/// The kind of primitive that is drawn as points.
const POINTS: u32 = 0;

/// A clip that is written.
pub(super) struct Gltf {
    /// In metres, Y up.
    subject: Subject,
    /// The unit and axes of the frames.
    space: Space,
    meshes: Vec<ClipMesh>,
    /// Least and greatest displacement of every body in every frame, of its vertices and of its normals.
    bounds: Vec<Vec<[[Vec3; 2]; 2]>>,
    /// [s]
    times: Vec<f64>,
    file: Option<Republished>,
    path: PathBuf,
}

impl Gltf {
    /// No frames yet, and nothing in the folder.
    ///
    /// # Errors
    /// [`IoError::TooLong`] for a motion that is not short enough.
    pub(super) fn create(folder: &Path, subject: &Subject, frames: &Planned) -> Result<Self, IoError> {
        let (mut subject, space) = (subject.clone(), subject.space);
        subject.space = Space::default();
        for body in &mut subject.bodies {
            body.mesh.move_points(|point| space.back(point));
            body.mesh.turn_normals(|normal| space.up.stand_up(normal));
        }
        let meshes: Vec<ClipMesh> = subject.bodies.iter().map(|body| ClipMesh::new(&body.mesh)).collect();
        check(&meshes, frames)?;
        let bounds = vec![Vec::new(); meshes.len()];
        Ok(Self { subject, space, meshes, bounds, times: Vec::new(), file: None, path: file(folder) })
    }

    /// All that stands before the frames: the container's head, the document, the data that stays.
    ///
    /// # Errors
    /// [`IoError::TooLargeForGlb`].
    fn head(&self) -> Result<Vec<u8>, IoError> {
        let mut parts = Parts::default();
        let frames = self.times.len();
        // Frames lie behind one another in the last view, each with its bodies behind one another.
        let frame_bytes: usize = self.meshes.iter().map(frame_bytes).sum();
        let (mut meshes, mut materials, mut first_of_body) = (Vec::new(), Materials::default(), 0);
        let mut targets: Vec<Vec<Value>> = Vec::new();
        for (index, mesh) in self.meshes.iter().enumerate() {
            let vectors = |bounds: [Vec3; 2]| {
                json!({"componentType": FLOAT, "count": mesh.source.len(), "type": "VEC3",
                    "min": bounds[0].to_array(), "max": bounds[1].to_array()})
            };
            let body = &self.subject.bodies[index];
            if mesh.source.is_empty() {
                continue;
            }
            let base: Vec<Vec3> = mesh.places(&body.mesh.points).map(DVec3::as_vec3).collect();
            let bytes = base.iter().flat_map(Vec3::to_array).flat_map(f32::to_le_bytes);
            let mut attributes = json!({"POSITION": parts.add_vertices(bytes, &vectors(bounds_of(&base)))});
            if let Some(normals) = mesh.normals.as_ref().and(body.mesh.normals.as_ref()) {
                let bytes =
                    mesh.directions(&normals.values).flat_map(|n| n.as_vec3().to_array()).flat_map(f32::to_le_bytes);
                let accessor = json!({"componentType": FLOAT, "count": mesh.source.len(), "type": "VEC3"});
                attributes["NORMAL"] = json!(parts.add_vertices(bytes, &accessor));
            }
            if !body.mesh.colours.is_empty() {
                let of_vertex = |&vertex: &u32| body.mesh.colours[vertex as usize].map(|share| share.clamp(0.0, 1.0));
                let bytes = mesh.source.iter().flat_map(of_vertex).flat_map(f32::to_le_bytes);
                let colours = json!({"componentType": FLOAT, "count": mesh.source.len(), "type": "VEC4"});
                attributes["COLOR_0"] = json!(parts.add_vertices(bytes, &colours));
            }
            for (number, set) in mesh.uv_sets.iter().enumerate() {
                let bytes = set.iter().flatten().flat_map(|c| c.to_le_bytes());
                let uvs = json!({"componentType": FLOAT, "count": set.len(), "type": "VEC2"});
                attributes[format!("TEXCOORD_{number}")] = json!(parts.add_vertices(bytes, &uvs));
            }
            targets.push(
                self.bounds[index]
                    .iter()
                    .enumerate()
                    .map(|(frame, bounds)| {
                        let start = frame * frame_bytes + first_of_body;
                        let block = |kind: usize| {
                            let mut accessor = vectors(bounds[kind]);
                            accessor["byteOffset"] = json!(start + kind * VECTOR * mesh.source.len());
                            accessor
                        };
                        let mut target = json!({"POSITION": block(0)});
                        if mesh.normals.is_some() {
                            target["NORMAL"] = block(1);
                        }
                        target
                    })
                    .collect(),
            );
            first_of_body += self::frame_bytes(mesh);
            let mut primitives = Vec::new();
            for (part, range) in mesh.parts.iter().filter(|(_, range)| !range.is_empty()) {
                let mut primitive = json!({"attributes": attributes,
                    "indices": indices_into(&mut parts, &mesh.triangles[range.clone()], mesh.source.len())});
                if !part.material.is_empty() || part.colour.is_some() {
                    primitive["material"] = json!(materials.number(part));
                }
                if !part.name.is_empty() {
                    primitive["extras"] = json!({PART: part.name});
                }
                primitives.push(primitive);
            }
            if primitives.is_empty() {
                primitives.push(json!({"attributes": attributes, "mode": POINTS}));
            }
            meshes.push(json!({"name": body.name, "primitives": primitives, "weights": vec![0.0; frames],
                "extras": {"targetNames": self.target_names()}}));
        }
        self.document(parts, meshes, &targets, &materials.list, frame_bytes)
    }

    fn target_names(&self) -> Vec<String> {
        self.times.iter().map(|&time| format!("{} s", time as f32)).collect()
    }

    /// Puts the animation and the frames behind what stays, and the container's head before it.
    fn document(
        &self,
        mut parts: Parts,
        mut meshes: Vec<Value>,
        targets: &[Vec<Value>],
        materials: &[Value],
        frame_bytes: usize,
    ) -> Result<Vec<u8>, IoError> {
        let frames = self.times.len();
        let start = self.times.first().copied().unwrap_or_default();
        let times: Vec<f32> = self.times.iter().map(|time| (time - start) as f32).collect();
        let input = parts.add_plain(
            times.iter().flat_map(|time| time.to_le_bytes()),
            &json!({"componentType": FLOAT, "count": frames, "type": "SCALAR",
                "min": [0.0], "max": [times.last().copied().unwrap_or_default()]}),
        );
        let weights = (0..frames * frames).map(|k| if k % (frames + 1) == 0 { 1_f32 } else { 0.0 });
        let output = parts.add_plain(
            weights.flat_map(f32::to_le_bytes),
            &json!({"componentType": FLOAT, "count": frames * frames, "type": "SCALAR"}),
        );
        let view = parts.views.len();
        let stays = parts.bin.len();
        if frame_bytes > 0 {
            parts.views.push(json!({"buffer": 0, "byteOffset": stays, "byteLength": frames * frame_bytes,
                "byteStride": VECTOR, "target": crate::io::glb::VERTICES}));
        }
        for (mesh, targets) in meshes.iter_mut().zip(targets) {
            let mut list = Vec::new();
            for target in targets {
                let mut numbered = target.clone();
                for accessor in numbered.as_object_mut().into_iter().flat_map(serde_json::Map::values_mut) {
                    accessor["bufferView"] = json!(view);
                    let number = parts.accessors.len();
                    parts.accessors.push(std::mem::replace(accessor, json!(number)));
                }
                list.push(numbered);
            }
            for primitive in mesh["primitives"].as_array_mut().into_iter().flatten() {
                primitive["targets"] = json!(list);
            }
        }
        let count = meshes.len();
        let channel = |node: usize| json!({"sampler": 0, "target": {"node": node, "path": "weights"}});
        let nodes: Vec<Value> =
            meshes.iter().enumerate().map(|(mesh, of)| json!({"mesh": mesh, "name": of["name"]})).collect();
        let mut document = json!({
            "asset": {"version": "2.0", "generator": "sinew"},
            "scene": 0,
            "scenes": [{"name": self.subject.name}],
            "buffers": [{"byteLength": stays + frames * frame_bytes}],
            "bufferViews": parts.views,
            "accessors": parts.accessors,
        });
        // Lists may not be empty in the format.
        if count > 0 {
            document["scenes"][0]["nodes"] = (0..count).collect();
            document["nodes"] = json!(nodes);
            document["meshes"] = json!(meshes);
            document["animations"] = json!([{"name": "motion",
                "samplers": [{"input": input, "output": output, "interpolation": "LINEAR"}],
                "channels": (0..count).map(channel).collect::<Vec<_>>()}]);
        }
        if !materials.is_empty() {
            document["materials"] = json!(materials);
        }
        let mut head = container_head(&document, stays + frames * frame_bytes)?;
        head.extend(parts.bin);
        Ok(head)
    }
}

/// Bytes of a body in a frame: its vertices, and behind them its normals, if it has any.
fn frame_bytes(mesh: &ClipMesh) -> usize {
    VECTOR * (mesh.source.len() + mesh.normals.as_ref().map_or(0, Vec::len))
}

fn bounds_of(vectors: &[Vec3]) -> [Vec3; 2] {
    vectors.iter().map(|&v| [v; 2]).reduce(|a, b| [a[0].min(b[0]), a[1].max(b[1])]).unwrap_or_default()
}

/// Materials, no two alike.
#[derive(Default)]
struct Materials<'a> {
    list: Vec<Value>,
    numbers: HashMap<Look<'a>, usize>,
}

impl<'a> Materials<'a> {
    /// The number of a part's material in the list, put there unless it is.
    fn number(&mut self, part: &'a FilePart) -> usize {
        let list = &mut self.list;
        *self.numbers.entry(Look::of(part)).or_insert_with(|| {
            let colour = part.colour.unwrap_or([1.0; 4]).map(|share| share.clamp(0.0, 1.0));
            let mut material = json!({"pbrMetallicRoughness":
                {"baseColorFactor": colour, "metallicFactor": 0.0, "roughnessFactor": 0.55}});
            if !part.material.is_empty() {
                material["name"] = json!(part.material);
            }
            if colour[3] < 1.0 {
                // Opacity counts for nothing otherwise.
                material["alphaMode"] = json!("BLEND");
            }
            list.push(material);
            list.len() - 1
        })
    }
}

/// Whether a motion is short enough.
///
/// # Errors
/// [`IoError::TooLong`] where it is not.
fn check(meshes: &[ClipMesh], frames: &Planned) -> Result<(), IoError> {
    check_length(meshes.iter().map(frame_bytes).sum(), frames)
}

/// Whether frames of so many bytes are few enough.
///
/// # Errors
/// [`IoError::TooLong`].
pub(super) fn check_length(frame_bytes: usize, frames: &Planned) -> Result<(), IoError> {
    let count = frames.end() - frames.start() + 1;
    let bytes = frame_bytes as u64;
    let most = MOST_FRAMES.min(MOST_BYTES / bytes.max(1));
    if count <= most { Ok(()) } else { Err(IoError::TooLong { format: "gltf", frames: count, most }) }
}

/// The clip.
pub(super) fn file(folder: &Path) -> PathBuf {
    folder.join("motion.glb")
}

impl MotionWriter for Gltf {
    fn push(&mut self, frame: &Frame) -> Result<(), IoError> {
        let (mut bytes, mut bounds) = (Vec::new(), Vec::new());
        for (index, mesh) in self.meshes.iter().enumerate() {
            let rest = &self.subject.bodies[index].mesh.points;
            // From where single precision puts the rest shape.
            let pairs = mesh.places(rest).zip(mesh.places(&frame.bodies[index].vertices));
            let moved = pairs.map(|(rest, now)| (self.space.back(now) - rest.as_vec3().as_dvec3()).as_vec3());
            let moved: Vec<Vec3> = moved.collect();
            if let Some(vertex) = moved.iter().position(|moved| !moved.is_finite()) {
                let name = &self.subject.bodies[index].name;
                let what = format!("frame {}, body {name:?}: displacement of vertex {vertex}", frame.number);
                return Err(IoError::NotFinite { what, value: moved[vertex].to_string() }.within(&self.path));
            }
            bytes.extend(moved.iter().flat_map(Vec3::to_array).flat_map(f32::to_le_bytes));
            let (up, now) = (self.space.up, &frame.bodies[index].normals);
            let rest = self.subject.bodies[index].mesh.normals.as_ref().map_or(&[][..], |normals| &normals.values);
            let pairs = mesh.directions(rest).zip(mesh.directions(now));
            let turned: Vec<Vec3> = pairs.map(|(rest, now)| up.stand_up(now).as_vec3() - rest.as_vec3()).collect();
            bytes.extend(turned.iter().flat_map(Vec3::to_array).flat_map(f32::to_le_bytes));
            bounds.push([bounds_of(&moved), bounds_of(&turned)]);
        }
        let file = match &mut self.file {
            Some(file) => file,
            none => none.insert(Republished::create(self.path.clone())?),
        };
        let is_due = file.add(&bytes)?;
        // Told of once it is there.
        for (all, bounds) in self.bounds.iter_mut().zip(bounds) {
            all.push(bounds);
        }
        self.times.push(frame.time);
        if is_due { self.publish() } else { Ok(()) }
    }

    fn finish(&mut self) -> Result<(), IoError> {
        if self.file.as_ref().is_some_and(Republished::is_behind) { self.publish() } else { Ok(()) }
    }

    fn written(&self) -> Vec<(String, PathBuf)> {
        let told = (format!("glTF clip of {} frames", self.times.len()), self.path.clone());
        if self.times.is_empty() { Vec::new() } else { vec![told] }
    }
}

impl Gltf {
    fn publish(&mut self) -> Result<(), IoError> {
        let head = self.head()?;
        self.file.as_mut().map_or(Ok(()), |file| file.publish(&head, &[]))
    }
}
