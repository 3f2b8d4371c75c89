//! Normals of a file on a mesh that has moved.
//!
//! A normal that an artist has set is seldom that of the faces around it. What is known of the motion is where the
//! faces are: the corners of a vertex that share a normal go along with the mean of their faces, by the shortest turn
//! from where that pointed at rest to where it points now. At rest they are the file's own, to the last bit.

use crate::geometry::file_mesh::{CornerValues, FileMesh, face_normals};
use glam::{DQuat, DVec3};
use std::collections::HashMap;

/// What turns the normals of a mesh.
pub(super) struct Normals {
    /// Means of the faces at rest.
    rest: Vec<DVec3>,
    /// Faces around each normal, in a row, and where those of each end.
    faces: Vec<u32>,
    ends: Vec<u32>,
}

impl Normals {
    /// Of a mesh at rest. Its normals are put in order, one for each vertex and direction; none for a mesh without any.
    pub(super) fn of(mesh: &mut FileMesh) -> Option<Self> {
        let given = mesh.normals.take()?;
        let (mut known, mut values, mut corners) = (HashMap::new(), Vec::new(), Vec::new());
        for (corner, &vertex) in mesh.corners.iter().enumerate() {
            let value = given.of(corner).map_or(DVec3::Y, |index| given.values[index as usize]);
            // Minus zero points where zero does.
            let key = (vertex, (value + 0.0).to_array().map(f64::to_bits));
            corners.push(*known.entry(key).or_insert_with(|| {
                values.push(value);
                values.len() as u32 - 1
            }));
        }
        let mut around = vec![Vec::new(); values.len()];
        for (face, range) in mesh.faces().enumerate() {
            for corner in range {
                around[corners[corner] as usize].push(face as u32);
            }
        }
        let mut normals = Self { rest: Vec::new(), faces: Vec::new(), ends: Vec::new() };
        for faces in around {
            normals.faces.extend(faces);
            normals.ends.push(normals.faces.len() as u32);
        }
        mesh.normals = Some(CornerValues { values, corners });
        normals.rest = normals.means(mesh, &mesh.points);
        Some(normals)
    }

    /// The normals of the mesh over `places`, in the order of its own.
    pub(super) fn over(&self, mesh: &FileMesh, places: &[DVec3]) -> Vec<DVec3> {
        let Some(own) = &mesh.normals else { return Vec::new() };
        let now = self.means(mesh, places);
        let turned = |((&own, &rest), now): ((&DVec3, &DVec3), DVec3)| {
            // Faces without extent, then or now, tell nothing.
            if rest == DVec3::ZERO || now == DVec3::ZERO || rest == now {
                return own;
            }
            (DQuat::from_rotation_arc(rest, now) * own).normalize_or(own)
        };
        own.values.iter().zip(&self.rest).zip(now).map(turned).collect()
    }

    /// Means of the faces around every normal, by their areas, of length one; zero where there is none.
    fn means(&self, mesh: &FileMesh, places: &[DVec3]) -> Vec<DVec3> {
        let of_faces = face_normals(mesh, places);
        let mut start = 0;
        let mean = |&end: &u32| {
            let faces = &self.faces[std::mem::replace(&mut start, end as usize)..end as usize];
            faces.iter().map(|&face| of_faces[face as usize]).sum::<DVec3>().normalize_or_zero()
        };
        self.ends.iter().map(mean).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn normals_turn_with_their_faces_and_are_the_files_own_at_rest() {
        // Two faces that meet in an edge along X, with a hard edge between them; a leaning normal on the second.
        let leaning = DVec3::new(0.6, 0.8, 0.0);
        let points = vec![DVec3::ZERO, DVec3::X, DVec3::X - DVec3::Z, -DVec3::Z, DVec3::X - DVec3::Y, -DVec3::Y];
        let mut mesh = FileMesh { points: points.clone(), ..FileMesh::default() };
        mesh.add_face(&[0, 1, 2, 3]);
        mesh.add_face(&[0, 5, 4, 1]);
        mesh.normals =
            Some(CornerValues { values: vec![DVec3::Y, leaning, DVec3::Z], corners: vec![0, 0, 1, 1, 2, 2, 2, 2] });
        let normals = Normals::of(&mut mesh).unwrap();
        let own = mesh.normals.clone().unwrap();
        assert_eq!(own.values.len(), 8);
        assert_eq!(normals.over(&mesh, &points), own.values);
        let turn = DQuat::from_rotation_x(0.7);
        let turned: Vec<DVec3> = points.iter().map(|&point| turn * point + DVec3::X).collect();
        for (normal, rest) in normals.over(&mesh, &turned).iter().zip(&own.values) {
            assert!((*normal - turn * *rest).length() < 1e-12, "{normal} {rest}");
        }
    }
}
