//! One drawn piece of a glTF mesh: its vertices in the pose of the file, its faces, its colours.

use super::super::failure::Failure;
use super::super::text::shortened;
use super::accessor::{Accessors, Whole};
use super::buffers::compressed;
use super::document::{Material, Mesh, Primitive};
use crate::geometry::model::MeshData;
use crate::io::glb::PART;
use glam::{DMat3, DMat4, DVec3, Vec3};

/// Where vertices go.
pub(super) enum Pose<'a> {
    /// All by the place of the node that shows them.
    Placed(DMat4),
    /// By the joints that hold them.
    Skinned(&'a [DMat4]),
}

/// A piece of a mesh in a list of meshes.
pub(super) struct Piece<'a, 'b> {
    pub(super) accessors: &'a Accessors<'b>,
    pub(super) mesh: &'a Mesh,
    pub(super) primitive: &'a Primitive,
    /// What a message calls it.
    pub(super) name: String,
    /// How much of each morph target is there.
    pub(super) weights: &'a [f64],
}

/// Of the values of some vertices those of `used`.
fn only<T: Copy>(values: &[T], used: &[u32]) -> Vec<T> {
    used.iter().filter_map(|&vertex| values.get(vertex as usize).copied()).collect()
}

impl Drawn {
    /// The piece without the vertices that it has no faces at: those of other pieces, where they share a list.
    fn without_strays(self) -> Self {
        let Self { mut mesh, uv_sets, own_colours, .. } = self;
        let mut places = vec![u32::MAX; mesh.positions.len()];
        mesh.triangles.iter().flatten().for_each(|&vertex| places[vertex as usize] = 0);
        let used: Vec<u32> = (0..places.len() as u32).filter(|&vertex| places[vertex as usize] == 0).collect();
        for (place, &vertex) in (0..).zip(&used) {
            places[vertex as usize] = place;
        }
        mesh.triangles.iter_mut().flatten().for_each(|vertex| *vertex = places[*vertex as usize]);
        mesh.positions = only(&mesh.positions, &used);
        mesh.normals = only(&mesh.normals, &used);
        mesh.colours = only(&mesh.colours, &used);
        let uv_sets = uv_sets.iter().map(|set| only(set, &used)).collect();
        let own_colours = only(&own_colours, &used);
        Self { mesh, uv_sets, own_colours, ..self }
    }
}

/// A piece as it is drawn.
pub(super) struct Drawn {
    pub(super) mesh: MeshData,
    /// Coordinates a vertex, right and up, of every set; empty for one that cannot be read.
    pub(super) uv_sets: Vec<Vec<[f64; 2]>>,
    /// Name and base colour of its material; none without one.
    pub(super) material: Option<(String, [f32; 4])>,
    /// Colours of the vertices themselves; empty where they have none.
    pub(super) own_colours: Vec<[f32; 4]>,
    /// Name of the part that it is; empty for one that has none but that of the mesh.
    pub(super) part: String,
}

impl Piece<'_, '_> {
    /// The piece as a mesh; nothing where it has no faces.
    pub(super) fn read(&self, pose: &Pose<'_>) -> Result<Option<Drawn>, Failure> {
        let mode = self.primitive.mode.unwrap_or(TRIANGLES);
        if !matches!(mode, TRIANGLES | STRIP | FAN) {
            return Ok(None);
        }
        if !self.primitive.attributes.contains_key("POSITION") {
            return Err(Failure::new(format_args!("{} has no POSITION", self.name)));
        }
        self.refuse_compressed()?;
        let mut positions = self.vectors("POSITION")?;
        let mut normals = self.vectors("NORMAL")?;
        normals.resize(if normals.len() == positions.len() { normals.len() } else { 0 }, DVec3::ZERO);
        let indices = self.indices(positions.len())?;
        let mut triangles = triangles_of(&indices, mode);
        self.check(&triangles, &positions)?;
        let maps = self.maps(pose, positions.len())?;
        let map = |vertex: usize| &maps[vertex.min(maps.len() - 1)];
        for (vertex, position) in positions.iter_mut().enumerate() {
            *position = map(vertex).transform_point3(*position);
        }
        // A mirroring map turns faces inside out.
        let mirrors = |t: &[u32; 3]| DMat3::from_mat4(*map(t[0] as usize)).determinant() < 0.0;
        triangles.iter_mut().filter(|t| mirrors(t)).for_each(|t| t.swap(1, 2));
        let mut turn = (usize::MAX, DMat3::IDENTITY);
        let normals = normals.iter().enumerate().map(|(vertex, normal)| {
            let which = vertex.min(maps.len() - 1);
            if turn.0 != which {
                turn = (which, DMat3::from_mat4(maps[which]).inverse().transpose());
            }
            (turn.1 * *normal).as_vec3().normalize_or_zero()
        });
        let normals: Vec<Vec3> = normals.collect();
        self.check(&triangles, &positions)?;
        let own_colours = self.own_colours()?;
        let base = self.material().map_or([1.0; 4], base_colour);
        let tinted = |colour: &[f32; 4]| [0, 1, 2, 3].map(|k| colour[k] * base[k]);
        let colours =
            if own_colours.is_empty() { vec![base; positions.len()] } else { own_colours.iter().map(tinted).collect() };
        let name = shortened(self.mesh.name.as_deref().unwrap_or_default());
        if triangles.is_empty() {
            return Ok(None);
        }
        let uv_sets = self.uv_sets(positions.len());
        let material = self.material().map(|material| (shortened(&material.name), base_colour(material)));
        let part = shortened(self.primitive.extras[PART].as_str().unwrap_or_default());
        let mesh = MeshData { name, positions, normals, colours, triangles };
        let drawn = Drawn { mesh, uv_sets, material, own_colours, part };
        // The first has all of them, in the file's order.
        let again = self.primitive.attributes.get("POSITION").is_some_and(|&at| self.accessors.is_shown_again(at));
        Ok(Some(if again { drawn.without_strays() } else { drawn }))
    }

    /// Texture coordinates, whose second one points down in the format. Those that cannot be read are none: a shape
    /// does without.
    fn uv_sets(&self, vertices: usize) -> Vec<Vec<[f64; 2]>> {
        let set = |number: usize| self.primitive.attributes.get(&format!("TEXCOORD_{number}"));
        let read = |&index: &usize| {
            let rows = self.accessors.read(index, &["VEC2"], Whole::Shares, "texture coordinates").ok()?;
            let uvs: Vec<[f64; 2]> = rows.rows().map(|row| [row[0], 1.0 - row[1]]).collect();
            (uvs.len() == vertices && uvs.iter().flatten().all(|c| c.is_finite())).then_some(uvs)
        };
        (0..MOST_SETS).map_while(set).map(|index| read(index).unwrap_or_default()).collect()
    }

    fn material(&self) -> Option<&Material> {
        self.primitive.material.and_then(|index| self.accessors.document.materials.get(index))
    }

    /// Refuses data that stands in the file only in a form that is not read.
    pub(super) fn refuse_compressed(&self) -> Result<(), Failure> {
        let draco = self.primitive.extensions.keys().find(|name| name.contains("draco"));
        let plain = |index: &usize| {
            let accessor = self.accessors.document.accessors.get(*index);
            accessor.is_none_or(|accessor| accessor.buffer_view.is_some() || accessor.sparse.is_some())
        };
        match draco {
            Some(name) if !self.primitive.attributes.get("POSITION").is_some_and(plain) => Err(compressed(name)),
            _ => Ok(()),
        }
    }

    /// An attribute of vectors with what the morph targets add to it; nothing where it is missing.
    pub(super) fn vectors(&self, name: &str) -> Result<Vec<DVec3>, Failure> {
        let Some(&index) = self.primitive.attributes.get(name) else { return Ok(Vec::new()) };
        let purpose = format!("{name} of {}", self.name);
        let rows = self.accessors.read(index, &["VEC3"], Whole::AsSaid, &purpose)?;
        let mut vectors: Vec<DVec3> = rows.rows().map(DVec3::from_slice).collect();
        for (target, (attributes, &weight)) in self.primitive.targets.iter().zip(self.weights).enumerate() {
            let Some(&index) = attributes.get(name).filter(|_| weight != 0.0) else { continue };
            let purpose = format!("{name} of morph target {target} of {}", self.name);
            let rows = self.accessors.read(index, &["VEC3"], Whole::AsSaid, &purpose)?;
            for (vector, added) in vectors.iter_mut().zip(rows.rows()) {
                *vector += weight * DVec3::from_slice(added);
            }
        }
        Ok(vectors)
    }

    pub(super) fn indices(&self, vertices: usize) -> Result<Vec<u32>, Failure> {
        let Some(index) = self.primitive.indices else { return Ok((0..vertices as u32).collect()) };
        let purpose = format!("indices of {}", self.name);
        let rows = self.accessors.read(index, &["SCALAR"], Whole::Themselves, &purpose)?;
        Ok(rows.values.iter().map(|&index| index as u32).collect())
    }

    /// Refuses faces at vertices that are not there, or nowhere.
    pub(super) fn check(&self, triangles: &[[u32; 3]], positions: &[DVec3]) -> Result<(), Failure> {
        let count = positions.len();
        let missing = |index: &u32| *index as usize >= count;
        if let Some(vertex) = triangles.iter().flatten().find(|index| missing(index)) {
            let faces = triangles.iter().filter(|t| t.iter().any(missing)).count();
            return Err(Failure::new(format_args!(
                "{}: {faces} of {} faces refer to vertices that are not there, such as {vertex} of {count}, from 0",
                self.name,
                triangles.len()
            )));
        }
        let lost = triangles.iter().flatten().find(|&&index| !positions[index as usize].is_finite());
        lost.map_or(Ok(()), |vertex| {
            Err(Failure::new(format_args!("{}: vertex {vertex} (POSITION, from 0) is at no place", self.name)))
        })
    }

    /// What maps each vertex, or one map for all of them.
    fn maps(&self, pose: &Pose<'_>, vertices: usize) -> Result<Vec<DMat4>, Failure> {
        let joints = match pose {
            Pose::Placed(place) => return Ok(vec![*place]),
            Pose::Skinned(joints) => joints,
        };
        let mut maps = vec![(DMat4::ZERO, 0.0); vertices];
        self.each_hold(joints.len(), &mut |vertex, joint, weight| {
            if let Some((map, sum)) = maps.get_mut(vertex) {
                *map += joints[joint as usize] * weight;
                *sum += weight;
            }
        })?;
        // Shares make one; a vertex that nothing holds goes with the first joint.
        let first = joints.first().copied().unwrap_or(DMat4::IDENTITY);
        let whole = |(map, sum): (DMat4, f64)| match sum {
            0.0 => first,
            1.0 => map,
            _ => map * (1.0 / sum),
        };
        Ok(if vertices == 0 { vec![first] } else { maps.into_iter().map(whole).collect() })
    }

    /// Tells of every vertex which of so many joints hold it, and by how much, those by nothing left out.
    pub(super) fn each_hold(&self, joints: usize, told: &mut dyn FnMut(usize, u32, f64)) -> Result<(), Failure> {
        for set in 0..=MOST_SETS {
            let (held, by) = (format!("JOINTS_{set}"), format!("WEIGHTS_{set}"));
            let attributes = &self.primitive.attributes;
            let (Some(&held_at), Some(&by_at)) = (attributes.get(&held), attributes.get(&by)) else { break };
            if set == MOST_SETS {
                return Err(Failure::new(format_args!(
                    "{} is held by more than {} joints a vertex",
                    self.name,
                    4 * set
                )));
            }
            let read = |index, whole, name: &str| {
                self.accessors.read(index, &["VEC4"], whole, &format!("{name} of {}", self.name))
            };
            let (held, by) = (read(held_at, Whole::Themselves, &held)?, read(by_at, Whole::Shares, &by)?);
            for (vertex, (held, by)) in held.rows().zip(by.rows()).enumerate() {
                for (&joint, &weight) in held.iter().zip(by).filter(|(_, weight)| **weight != 0.0) {
                    if joint as usize >= joints {
                        return Err(Failure::new(format_args!("{} is held by joint {joint} of {joints}", self.name)));
                    }
                    told(vertex, joint as u32, weight);
                }
            }
        }
        Ok(())
    }

    /// Colours of the vertices; empty where they have none.
    fn own_colours(&self) -> Result<Vec<[f32; 4]>, Failure> {
        let Some(&index) = self.primitive.attributes.get("COLOR_0") else { return Ok(Vec::new()) };
        let purpose = format!("COLOR_0 of {}", self.name);
        let rows = self.accessors.read(index, &["VEC3", "VEC4"], Whole::Shares, &purpose)?;
        // What is no number tints nothing.
        let share =
            |row: &[f64], k: usize| row.get(k).filter(|share| share.is_finite()).map_or(1.0, |&share| share as f32);
        let colour = |row: &[f64]| [0, 1, 2, 3].map(|k| share(row, k));
        Ok(rows.rows().map(colour).collect())
    }
}

fn base_colour(material: &Material) -> [f32; 4] {
    material.pbr_metallic_roughness.base_color_factor
}

/// Sets of texture coordinates, and of joints, that are read of a piece, at most.
const MOST_SETS: usize = 8;

// The format's numbers for how vertices make faces.
pub(super) const TRIANGLES: u32 = 4;
const STRIP: u32 = 5;
const FAN: u32 = 6;

pub(super) fn triangles_of(indices: &[u32], mode: u32) -> Vec<[u32; 3]> {
    match mode {
        TRIANGLES => indices.chunks_exact(3).map(|t| [t[0], t[1], t[2]]).collect(),
        STRIP => {
            // Every second one is wound the other way.
            let strip = indices.windows(3).enumerate();
            strip.map(|(k, t)| if k % 2 == 0 { [t[0], t[1], t[2]] } else { [t[1], t[0], t[2]] }).collect()
        }
        _ => indices.get(1..).unwrap_or_default().windows(2).map(|t| [indices[0], t[0], t[1]]).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn strips_and_fans_keep_their_sense() {
        assert_eq!(triangles_of(&[0, 1, 2, 3], STRIP), [[0, 1, 2], [2, 1, 3]]);
        assert_eq!(triangles_of(&[0, 1, 2, 3], FAN), [[0, 1, 2], [0, 2, 3]]);
        assert!(triangles_of(&[], FAN).is_empty());
    }
}
