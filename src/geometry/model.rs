//! Models: what a file of meshes holds, for the picture and as the start of a solid.

use super::file_mesh::FileMesh;
use super::model_report::Finding;
use glam::{DVec3, Vec3};
use std::ops::Range;
use std::sync::Arc;

/// Triangles as a file gives them: vertices are split where normals, colours or texture coordinates differ.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Model {
    /// Vertex positions, in the file's unit until [`Model::stand_up`], in metres after.
    pub positions: Vec<DVec3>,
    /// A unit normal a vertex; empty where the file has none.
    pub normals: Vec<Vec3>,
    /// Linear red, green, blue and opacity a vertex; empty where the file has none.
    pub colours: Vec<[f32; 4]>,
    /// Vertex indices of every face.
    pub triangles: Vec<[u32; 3]>,
    /// Named runs of faces.
    pub parts: Vec<Part>,
    /// What the reader of the file left out or took another way.
    pub notes: Vec<Finding>,
    /// The mesh as the file has it; none where the model is of no file.
    pub file: Option<Arc<FileMesh>>,
}

/// A named run of a model's faces.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Part {
    /// Name in the file; may be empty.
    pub name: String,
    /// Its faces, as a range of [`Model::triangles`].
    pub triangles: Range<usize>,
}

/// The axis of a file that points up.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum UpAxis {
    /// X: as in some scanners' files.
    X,
    /// Y: as here, in Maya, Houdini and glTF.
    #[default]
    Y,
    /// Z: as in Blender, CAD and printing.
    Z,
}

impl UpAxis {
    /// A vector of the file in the frame with Y up: a rotation, so that nothing is mirrored.
    pub fn stand_up(self, v: DVec3) -> DVec3 {
        match self {
            Self::X => DVec3::new(-v.y, v.x, v.z),
            Self::Y => v,
            Self::Z => DVec3::new(v.x, v.z, -v.y),
        }
    }
}

/// One more mesh for a model, as importers find them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MeshData {
    /// Name; may be empty.
    pub name: String,
    /// Vertex positions.
    pub positions: Vec<DVec3>,
    /// A normal a vertex, or none at all.
    pub normals: Vec<Vec3>,
    /// A colour a vertex, or none at all.
    pub colours: Vec<[f32; 4]>,
    /// Vertex indices of every face, within the piece.
    pub triangles: Vec<[u32; 3]>,
}

/// White, where some other part of a model has a colour.
const WHITE: [f32; 4] = [1.0; 4];

impl Model {
    /// Adds a piece. Faces that refer to vertices that are not there are left out: their number is returned.
    pub fn add(&mut self, piece: MeshData) -> usize {
        let base = self.positions.len() as u32;
        let count = piece.positions.len();
        let first = self.triangles.len();
        fill_up(&mut self.normals, piece.normals, base as usize, count, Vec3::ZERO);
        fill_up(&mut self.colours, piece.colours, base as usize, count, WHITE);
        self.positions.extend(piece.positions);
        let known = |t: &&[u32; 3]| t.iter().all(|&i| (i as usize) < count);
        self.triangles.extend(piece.triangles.iter().filter(known).map(|t| t.map(|i| base + i)));
        self.parts.push(Part { name: piece.name, triangles: first..self.triangles.len() });
        piece.triangles.len() - (self.triangles.len() - first)
    }

    /// Turns the file's up axis to Y and its unit into metres (`scale` metres a unit).
    pub fn stand_up(&mut self, up: UpAxis, scale: f64) {
        for position in &mut self.positions {
            *position = scale * up.stand_up(*position);
        }
        for normal in &mut self.normals {
            *normal = up.stand_up(normal.as_dvec3()).as_vec3();
        }
        if let Some(file) = &mut self.file {
            let file = Arc::make_mut(file);
            file.move_points(|point| scale * up.stand_up(point));
            file.turn_normals(|normal| up.stand_up(normal));
        }
    }

    /// Leaves out faces that `keep` refuses and vertices that no face uses any more; the rest stay in their order.
    #[must_use]
    pub fn retain(&self, keep: impl Fn(&[u32; 3]) -> bool) -> Self {
        let mut used = vec![false; self.positions.len()];
        for &vertex in self.triangles.iter().filter(|t| keep(t)).flatten() {
            used[vertex as usize] = true;
        }
        let mut kept = Self { notes: self.notes.clone(), file: self.file.clone(), ..Self::default() };
        let mut new_index = vec![0; self.positions.len()];
        for (old, _) in used.iter().enumerate().filter(|(_, used)| **used) {
            new_index[old] = kept.positions.len() as u32;
            kept.positions.push(self.positions[old]);
            kept.normals.extend(self.normals.get(old));
            kept.colours.extend(self.colours.get(old));
        }
        // How many faces stay before each: a face need not be in any part.
        let mut before = Vec::with_capacity(self.triangles.len() + 1);
        for triangle in &self.triangles {
            before.push(kept.triangles.len());
            if keep(triangle) {
                kept.triangles.push(triangle.map(|old| new_index[old as usize]));
            }
        }
        before.push(kept.triangles.len());
        let part = |part: &Part| Part {
            name: part.name.clone(),
            triangles: before[part.triangles.start]..before[part.triangles.end],
        };
        kept.parts = self.parts.iter().map(part).collect();
        kept
    }
}

/// Appends an attribute that may be missing before or now.
fn fill_up<T: Copy>(all: &mut Vec<T>, mut new: Vec<T>, before: usize, count: usize, missing: T) {
    if new.len() != count {
        new.clear();
    }
    if new.is_empty() && all.is_empty() {
        return;
    }
    all.resize(before, missing);
    all.extend(new);
    all.resize(before + count, missing);
}

#[cfg(test)]
mod tests {
    use super::*;

    fn piece(name: &str, colours: Vec<[f32; 4]>) -> MeshData {
        MeshData {
            name: name.to_owned(),
            positions: vec![DVec3::ZERO, DVec3::X, DVec3::Y],
            colours,
            triangles: vec![[0, 1, 2], [0, 1, 3]],
            ..MeshData::default()
        }
    }

    #[test]
    fn pieces_are_joined_and_missing_attributes_filled() {
        let mut model = Model::default();
        assert_eq!(model.add(piece("a", Vec::new())), 1);
        assert_eq!(model.add(piece("b", vec![[0.5; 4]; 3])), 1);
        assert_eq!(model.triangles, [[0, 1, 2], [3, 4, 5]]);
        assert_eq!(model.colours[2], WHITE);
        assert_eq!(model.colours[3], [0.5; 4]);
        assert!(model.normals.is_empty());
        assert_eq!(model.parts[1].triangles, 1..2);
    }

    #[test]
    fn standing_up_turns_without_mirroring() {
        for up in [UpAxis::X, UpAxis::Y, UpAxis::Z] {
            let [x, y, z] = [DVec3::X, DVec3::Y, DVec3::Z].map(|v| up.stand_up(v));
            assert!((x.cross(y) - z).length() < 1e-15, "{up:?}");
        }
        assert_eq!(UpAxis::X.stand_up(DVec3::X), DVec3::Y);
        assert_eq!(UpAxis::Z.stand_up(DVec3::Z), DVec3::Y);
    }

    #[test]
    fn vertices_that_no_face_uses_go() {
        let mut model = Model::default();
        model.add(piece("a", Vec::new()));
        model.add(piece("b", Vec::new()));
        let kept = model.retain(|t| t[0] == 3);
        assert_eq!(kept.positions.len(), 3);
        assert_eq!(kept.triangles, [[0, 1, 2]]);
        assert_eq!(kept.parts[0].triangles, 0..0);
    }
}
