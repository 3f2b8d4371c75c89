//! A part of an OBJ file: its faces, and the vertices that they make of positions and normals.

use super::polygon::Cutter;
use crate::geometry::model::MeshData;
use glam::{DVec3, Vec3};
use std::collections::HashMap;

/// White, where some other vertex has a colour.
const WHITE: [f32; 4] = [1.0; 4];

/// What faces refer to, through the whole file.
#[derive(Default)]
pub(super) struct Vertices {
    pub(super) positions: Vec<DVec3>,
    /// None for those that are incomplete.
    pub(super) normals: Vec<Option<Vec3>>,
    /// Texture coordinates; none for those that are incomplete.
    pub(super) textures: Vec<Option<[f64; 2]>>,
    /// Colours of the first vertices; those behind the last coloured one have none.
    colours: Vec<Option<[f32; 4]>>,
    /// Vertices that are no numbers, and their lines.
    lost: HashMap<u32, usize>,
}

impl Vertices {
    pub(super) fn add(&mut self, position: DVec3, line: usize) {
        if !position.is_finite() {
            self.lost.insert(self.positions.len() as u32, line);
        }
        self.positions.push(position);
    }

    /// Gives a colour to the vertex that is added next.
    pub(super) fn set_colour(&mut self, colour: [f32; 4]) {
        self.colours.resize(self.positions.len(), None);
        self.colours.push(Some(colour));
    }

    /// The line of a vertex that is no numbers.
    pub(super) fn lost(&self, vertex: u32) -> Option<usize> {
        if self.lost.is_empty() { None } else { self.lost.get(&vertex).copied() }
    }

    /// A colour of every vertex, white for one that has none; nothing at all where none has any.
    pub(super) fn all_colours(&self) -> Vec<[f32; 4]> {
        let count = if self.colours.is_empty() { 0 } else { self.positions.len() };
        (0..count as u32).map(|vertex| self.colour(vertex).unwrap_or(WHITE)).collect()
    }

    fn colour(&self, vertex: u32) -> Option<[f32; 4]> {
        self.colours.get(vertex as usize).copied().flatten()
    }
}

/// A corner of a face, from 0. One without a texture coordinate or normal differs from one that has it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct Corner {
    pub(super) vertex: u32,
    pub(super) texture: Option<u32>,
    pub(super) normal: Option<u32>,
}

/// Faces so far.
#[derive(Default)]
pub(super) struct Piece {
    known: HashMap<Corner, u32>,
    corners: Vec<Corner>,
    positions: Vec<DVec3>,
    triangles: Vec<[u32; 3]>,
    face: Vec<u32>,
}

impl Piece {
    pub(super) fn is_empty(&self) -> bool {
        self.triangles.is_empty()
    }

    /// Adds a face, cut into triangles; false where that takes too long.
    pub(super) fn add_face(&mut self, corners: &[Corner], vertices: &Vertices, cutter: &mut Cutter) -> bool {
        self.face.clear();
        for &corner in corners {
            let next = self.corners.len() as u32;
            let index = *self.known.entry(corner).or_insert(next);
            if index == next {
                self.corners.push(corner);
                self.positions.push(vertices.positions[corner.vertex as usize]);
            }
            self.face.push(index);
        }
        cutter.cut(&self.face, &self.positions, &mut self.triangles)
    }

    /// The mesh, in the colours of its vertices or else in that of its material.
    pub(super) fn finish(self, name: String, material: Option<[f32; 4]>, vertices: &Vertices) -> MeshData {
        let normal = |corner: &Corner| vertices.normals.get(corner.normal? as usize).copied().flatten();
        // Normals of some corners only are of no use: the picture computes its own.
        let normals = self.corners.iter().map(normal).collect::<Option<_>>().unwrap_or_default();
        let own = self.corners.iter().any(|corner| vertices.colour(corner.vertex).is_some());
        let other = material.unwrap_or(WHITE);
        let colours = match material {
            None if !own => Vec::new(),
            _ => self.corners.iter().map(|corner| vertices.colour(corner.vertex).unwrap_or(other)).collect(),
        };
        MeshData { name, positions: self.positions, normals, colours, triangles: self.triangles }
    }
}
