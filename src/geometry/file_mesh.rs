//! A mesh as its file has it: every vertex in the file's order, polygons uncut, texture coordinates corner by corner.
//!
//! What is filled and drawn is another mesh, cut, split and welded ([`super::model`], [`super::weld`]). Motion that goes back
//! to the program that the file is from must come on this one, or what hangs on vertices there is lost.

use glam::DVec3;
use std::ops::Range;

/// Vertices and polygons of a file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FileMesh {
    /// Every vertex, those that no face uses included; in the file's unit until the model stands up, in metres after. Those
    /// that no face uses may be no numbers.
    pub points: Vec<DVec3>,
    /// How many corners each face has, three or more.
    pub counts: Vec<u32>,
    /// Vertices of the corners of all faces, one face after the other.
    pub corners: Vec<u32>,
    /// Texture coordinates.
    pub uv_sets: Vec<UvSet>,
    /// Runs of faces, one after the other, every face in one.
    pub parts: Vec<FilePart>,
}

/// One set of texture coordinates.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct UvSet {
    /// Coordinates, right and up.
    pub values: Vec<[f64; 2]>,
    /// Index of the coordinates of every corner; [`UvSet::NONE`] for one that has none.
    pub corners: Vec<u32>,
}

impl UvSet {
    /// What stands for no coordinates.
    pub const NONE: u32 = u32::MAX;

    /// Index of a corner's coordinates.
    pub fn of(&self, corner: usize) -> Option<u32> {
        self.corners.get(corner).copied().filter(|&index| (index as usize) < self.values.len())
    }
}

/// A run of faces of one name and material.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FilePart {
    /// Name of the object or group; may be empty.
    pub name: String,
    /// Name of the material; empty where there is none.
    pub material: String,
    /// Its base colour, linear red, green, blue and opacity; none where the file does not say.
    pub colour: Option<[f32; 4]>,
    /// Its faces, as a range of [`FileMesh::counts`].
    pub faces: Range<usize>,
}

impl FileMesh {
    /// Triangles over points, as one part; those at points that are not there are left out.
    pub fn of_triangles(name: &str, points: Vec<DVec3>, triangles: &[[u32; 3]]) -> Self {
        let mut mesh = Self { points, ..Self::default() };
        mesh.begin_part(FilePart { name: name.to_owned(), ..FilePart::default() });
        let count = mesh.points.len();
        for triangle in triangles.iter().filter(|triangle| triangle.iter().all(|&vertex| (vertex as usize) < count)) {
            mesh.add_face(triangle);
        }
        mesh.end_part();
        mesh
    }

    /// Begins a run of faces; one that has none goes.
    pub(crate) fn begin_part(&mut self, part: FilePart) {
        self.end_part();
        let next = self.counts.len();
        self.parts.push(FilePart { faces: next..next, ..part });
    }

    /// Ends the last run of faces.
    pub(crate) fn end_part(&mut self) {
        self.parts.pop_if(|part| part.faces.is_empty());
    }

    /// Adds a face to the run that was begun last.
    pub(crate) fn add_face(&mut self, corners: &[u32]) {
        self.corners.extend(corners);
        self.counts.push(corners.len() as u32);
        let end = self.counts.len();
        match self.parts.last_mut() {
            Some(part) => part.faces.end = end,
            None => self.parts.push(FilePart { faces: 0..end, ..FilePart::default() }),
        }
    }

    /// The ranges of the faces' corners.
    pub fn faces(&self) -> impl Iterator<Item = Range<usize>> {
        let mut next = 0;
        self.counts.iter().map(move |&count| {
            let start = next;
            next += count as usize;
            start..next
        })
    }

    /// Puts every vertex elsewhere.
    pub(crate) fn move_points(&mut self, to: impl Fn(DVec3) -> DVec3) {
        for point in &mut self.points {
            *point = to(*point);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn faces_fall_into_the_parts_that_were_begun() {
        let named = |name: &str| FilePart { name: name.to_owned(), ..FilePart::default() };
        let mut mesh = FileMesh::default();
        mesh.add_face(&[0, 1, 2]);
        mesh.begin_part(named("empty"));
        mesh.begin_part(named("b"));
        mesh.add_face(&[0, 1, 2, 3]);
        mesh.begin_part(named("nothing behind it"));
        mesh.end_part();
        let parts: Vec<_> = mesh.parts.iter().map(|part| (part.name.as_str(), part.faces.clone())).collect();
        assert_eq!(parts, [("", 0..1), ("b", 1..2)]);
        assert_eq!(mesh.faces().collect::<Vec<_>>(), [0..3, 3..7]);
    }
}
