//! A mesh as its file has it: every vertex in the file's order, polygons uncut, texture coordinates corner by corner.
//!
//! What is filled and drawn is another mesh, cut, split and welded ([`super::model`], [`super::weld`]). Motion that
//! goes back to the program that the file is from must come on this one, or what hangs on vertices there is lost.

use glam::DVec3;
use std::ops::Range;

/// Vertices and polygons of a file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FileMesh {
    /// Every vertex, those that no face uses included; in the file's unit until the model stands up, in metres after.
    /// Those that no face uses may be no numbers.
    pub points: Vec<DVec3>,
    /// How many corners each face has, three or more.
    pub counts: Vec<u32>,
    /// Vertices of the corners of all faces, one face after the other.
    pub corners: Vec<u32>,
    /// Texture coordinates.
    pub uv_sets: Vec<UvSet>,
    /// Normals of length one, of every corner; none where the file has none.
    pub normals: Option<CornerValues<DVec3>>,
    /// Linear red, green, blue and opacity of every vertex, without those of materials; empty where the file has none.
    pub colours: Vec<[f32; 4]>,
    /// Runs of faces, one after the other, every face in one.
    pub parts: Vec<FilePart>,
}

/// What corners have, several of them often the same.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CornerValues<T> {
    /// What there is.
    pub values: Vec<T>,
    /// Index of what every corner has; [`CornerValues::NONE`] for one that has nothing.
    pub corners: Vec<u32>,
}

/// One set of texture coordinates, right and up.
pub type UvSet = CornerValues<[f64; 2]>;

impl<T> CornerValues<T> {
    /// What stands for nothing.
    pub const NONE: u32 = u32::MAX;

    /// Index of what a corner has.
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

    /// Gives corners that have no normal that of their face, as it is lit then; where none has any there are none.
    pub(crate) fn complete_normals(&mut self) {
        let Some(mut normals) = self.normals.take() else { return };
        normals.corners.resize(self.corners.len(), CornerValues::<DVec3>::NONE);
        let is_given = |corner: usize| normals.of(corner).is_some();
        let missing: Vec<usize> = (0..self.corners.len()).filter(|&corner| !is_given(corner)).collect();
        if missing.len() == self.corners.len() {
            return;
        }
        if !missing.is_empty() {
            let faces: Vec<Range<usize>> = self.faces().collect();
            let flat = face_normals(self, &self.points);
            for corner in missing {
                let face = faces.partition_point(|face| face.end <= corner);
                normals.corners[corner] = normals.values.len() as u32;
                normals.values.push(flat[face].normalize_or_zero());
            }
        }
        self.normals = Some(normals);
    }

    /// Which normal every vertex has, one behind the last for those of no face; none where a vertex has several.
    pub(crate) fn normals_of_vertices(&self) -> Option<Vec<u32>> {
        let normals = self.normals.as_ref()?;
        let nothing = normals.values.len() as u32;
        let mut found = vec![nothing; self.points.len()];
        for (&vertex, &normal) in self.corners.iter().zip(&normals.corners) {
            let of_vertex = &mut found[vertex as usize];
            if *of_vertex != normal && *of_vertex != nothing {
                return None;
            }
            *of_vertex = normal;
        }
        Some(found)
    }

    /// Turns every normal.
    pub(crate) fn turn_normals(&mut self, turn: impl Fn(DVec3) -> DVec3) {
        for normal in self.normals.iter_mut().flat_map(|normals| &mut normals.values) {
            *normal = turn(*normal);
        }
    }

    /// Puts every vertex elsewhere.
    pub(crate) fn move_points(&mut self, to: impl Fn(DVec3) -> DVec3) {
        for point in &mut self.points {
            *point = to(*point);
        }
    }
}

/// Normals of all faces of a mesh over `points`, twice as long as their areas.
pub(crate) fn face_normals(mesh: &FileMesh, points: &[DVec3]) -> Vec<DVec3> {
    let at = |corner: usize| points.get(mesh.corners[corner] as usize).copied().unwrap_or_default();
    let of = |face: Range<usize>| {
        // From a corner of its own: the further from the origin, the less would be left of a small face.
        let origin = at(face.start);
        let pairs = face.clone().zip(face.clone().skip(1).chain(face.clone().take(1)));
        pairs.map(|(a, b)| (at(a) - origin).cross(at(b) - origin)).sum::<DVec3>()
    };
    mesh.faces().map(of).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn corners_without_a_normal_are_lit_as_their_face_is() {
        let mut mesh =
            FileMesh { points: vec![DVec3::ZERO, DVec3::X, DVec3::X + DVec3::Y, DVec3::Y], ..FileMesh::default() };
        mesh.add_face(&[0, 1, 2, 3]);
        mesh.normals = Some(CornerValues { values: vec![DVec3::X], corners: vec![0] });
        mesh.complete_normals();
        let normals =
            mesh.normals.as_ref().map(|n| n.corners.iter().map(|&c| n.values[c as usize]).collect::<Vec<_>>());
        assert_eq!(normals, Some(vec![DVec3::X, DVec3::Z, DVec3::Z, DVec3::Z]));
        mesh.normals = Some(CornerValues::default());
        mesh.complete_normals();
        assert_eq!(mesh.normals, None);
    }

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
