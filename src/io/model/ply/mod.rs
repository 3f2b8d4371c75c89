//! PLY, text and binary of either byte order.
//!
//! Read here: the crates that read PLY take coordinates through single precision, or tell of a fault neither its line
//! nor its property, and want headers in UTF-8 with the names and line ends of their own choice.

mod header;
mod values;

use self::header::{Element, Header, Property, Scalar};
use self::values::{Place, Values};
use super::failure::Failure;
use super::polygon::{Cutter, too_long};
use super::text::without_mark;
use crate::geometry::file_mesh::{CornerValues, FileMesh, UvSet};
use crate::geometry::model::{MeshData, Model};
use crate::io::colours::linear;
use glam::{DVec3, Vec3};
use std::ops::Range;
use std::sync::Arc;

pub(super) fn read(bytes: &[u8]) -> Result<Model, Failure> {
    let text = without_mark(bytes);
    let (header, body) = Header::read(&text)?;
    // Every element takes a byte at least. A header that claims more would be believed for as long as memory lasts.
    let claimed = header.elements.iter().map(|element| element.count).fold(0, usize::saturating_add);
    if claimed > body.len() {
        return Err(Failure::new(format_args!(
            "its header announces more than the file holds: {claimed} elements in {} bytes",
            body.len()
        )));
    }
    let mut values = Values::new(&header, body);
    let (mut vertices, mut faces) = (Vertices::default(), Faces::default());
    for element in &header.elements {
        match element.name.as_str() {
            "vertex" => vertices.read(element, &mut values)?,
            "face" => faces.read(element, &mut values, false)?,
            "tristrips" => faces.read(element, &mut values, true)?,
            _ => skip(element, &mut values)?,
        }
    }
    let textures = std::mem::take(&mut vertices.textures);
    let mut piece = vertices.into_mesh();
    piece.triangles = faces.triangles(&piece.positions)?;
    let mut listed = faces.as_listed(&piece.positions, textures);
    let values: Vec<DVec3> = piece.normals.iter().map(|normal| normal.as_dvec3()).collect();
    let of_vertex = |&vertex: &u32| {
        values.get(vertex as usize).filter(|normal| **normal != DVec3::ZERO).map_or(UvSet::NONE, |_| vertex)
    };
    let corners = listed.corners.iter().map(of_vertex).collect();
    listed.normals = Some(CornerValues { values, corners });
    listed.complete_normals();
    listed.colours.clone_from(&piece.colours);
    let mut model = Model { file: Some(Arc::new(listed)), ..Model::default() };
    model.add(piece);
    Ok(model)
}

fn skip(element: &Element, values: &mut Values<'_>) -> Result<(), Failure> {
    for index in 0..element.count {
        for property in &element.properties {
            let place = Place { element, index, property };
            skip_property(property, &place, values)?;
        }
        values.end(element, index)?;
    }
    Ok(())
}

fn skip_property(property: &Property, place: &Place<'_>, values: &mut Values<'_>) -> Result<(), Failure> {
    let length = match property.count {
        Some(count) => values.length(count, place)?,
        None => 1,
    };
    (0..length).try_for_each(|_| values.next(property.scalar, place).map(drop))
}

/// What a vertex may have, by the names of its properties.
const NAMES: [[&str; 3]; 11] = [
    ["x", "", ""],
    ["y", "", ""],
    ["z", "", ""],
    ["nx", "normal_x", ""],
    ["ny", "normal_y", ""],
    ["nz", "normal_z", ""],
    ["red", "r", "diffuse_red"],
    ["green", "g", "diffuse_green"],
    ["blue", "b", "diffuse_blue"],
    ["s", "u", "texture_u"],
    ["t", "v", "texture_v"],
];

#[derive(Default)]
struct Vertices {
    positions: Vec<DVec3>,
    normals: Vec<Vec3>,
    colours: Vec<[f32; 4]>,
    textures: Vec<[f64; 2]>,
}

impl Vertices {
    fn read(&mut self, element: &Element, values: &mut Values<'_>) -> Result<(), Failure> {
        let roles: Vec<Option<usize>> = element
            .properties
            .iter()
            .map(|property| NAMES.iter().position(|names| names.contains(&property.name.as_str())))
            .collect();
        let has = |wanted: Range<usize>| wanted.clone().all(|role| roles.contains(&Some(role)));
        if !has(0..3) {
            let missing = ["x", "y", "z"].into_iter().enumerate().find(|(role, _)| !roles.contains(&Some(*role)));
            let name = missing.map_or("x", |(_, name)| name);
            return Err(Failure::new(format_args!("its vertices have no property `{name}`")));
        }
        for index in 0..element.count {
            let mut found = [0.0; 11];
            for (property, role) in element.properties.iter().zip(&roles) {
                let place = Place { element, index, property };
                match (role, property.count) {
                    (Some(role), None) => {
                        let value = values.next(property.scalar, &place)?;
                        found[*role] = if (6..9).contains(role) { share(value, property.scalar).into() } else { value };
                    }
                    (Some(_), Some(_)) => return Err(values.fail(&place, "this is a list where one number is meant")),
                    (None, _) => skip_property(property, &place, values)?,
                }
            }
            values.end(element, index)?;
            let [x, y, z, nx, ny, nz, red, green, blue, s, t] = found;
            self.positions.push(DVec3::new(x, y, z));
            if has(3..6) {
                self.normals.push(DVec3::new(nx, ny, nz).as_vec3().normalize_or_zero());
            }
            if has(6..9) {
                self.colours.push(linear([red, green, blue].map(|share| share.clamp(0.0, 1.0))));
            }
            if has(9..11) {
                self.textures.push([s, t]);
            }
        }
        Ok(())
    }

    fn into_mesh(self) -> MeshData {
        let Self { positions, normals, colours, .. } = self;
        MeshData { positions, normals, colours, ..MeshData::default() }
    }
}

/// A colour as a share of the full one: whole numbers of a type have its greatest for that.
fn share(value: f64, scalar: Scalar) -> f32 {
    let value = value as f32;
    match scalar {
        Scalar::F32 | Scalar::F64 => value,
        Scalar::U16 => value / 65535.0,
        _ => value / 255.0,
    }
}

/// Faces as they are listed; vertices may come behind them.
#[derive(Default)]
struct Faces {
    corners: Vec<i64>,
    /// Where each face ends in the list, and what a message calls it.
    ends: Vec<(usize, bool)>,
    /// Texture coordinates of the faces' corners, and where those of each face end in the list; a face's are used where
    /// they are as many as its corners.
    textures: Vec<[f64; 2]>,
    texture_ends: Vec<usize>,
}

impl Faces {
    fn read(&mut self, element: &Element, values: &mut Values<'_>, strips: bool) -> Result<(), Failure> {
        for index in 0..element.count {
            for property in &element.properties {
                let place = Place { element, index, property };
                let (true, Some(count)) = (is_corners(property), property.count) else {
                    match property.count.filter(|_| property.name == "texcoord") {
                        Some(count) => self.read_textures(count, property, &place, values)?,
                        None => skip_property(property, &place, values)?,
                    }
                    continue;
                };
                for _ in 0..values.length(count, &place)? {
                    let corner = values.next(property.scalar, &place)?;
                    if corner.fract() != 0.0 || !corner.is_finite() {
                        return Err(values.fail(&place, format_args!("{corner} is no number of a vertex")));
                    }
                    self.corners.push(corner as i64);
                }
                self.ends.push((self.corners.len(), strips));
            }
            // One end a face, with and without coordinates.
            self.texture_ends.resize(self.ends.len(), self.textures.len());
            values.end(element, index)?;
        }
        Ok(())
    }

    /// Coordinates of a face's corners, two numbers each.
    fn read_textures(
        &mut self,
        count: Scalar,
        property: &Property,
        place: &Place<'_>,
        values: &mut Values<'_>,
    ) -> Result<(), Failure> {
        let length = values.length(count, place)?;
        let numbers: Vec<f64> = (0..length).map(|_| values.next(property.scalar, place)).collect::<Result<_, _>>()?;
        self.textures.extend(numbers.as_chunks::<2>().0);
        self.texture_ends.push(self.textures.len());
        Ok(())
    }

    /// The faces as the file lists them, strips as their triangles, over `points`; `textures` are those of the
    /// vertices.
    fn as_listed(&self, points: &[DVec3], textures: Vec<[f64; 2]>) -> FileMesh {
        let mut mesh = FileMesh { points: points.to_vec(), ..FileMesh::default() };
        let (mut triangles, mut textured, mut first) = (Vec::new(), Vec::new(), 0);
        let is_whole = |uvs: &[[f64; 2]]| !uvs.is_empty() && uvs.iter().flatten().all(|c| c.is_finite());
        for ((corners, is_strip), &end) in self.each().zip(&self.texture_ends) {
            let own = std::mem::replace(&mut first, end)..end;
            for run in corners.split(|&corner| is_strip && corner == -1) {
                let face: Vec<u32> = run.iter().map(|&corner| corner as u32).collect();
                if is_strip {
                    triangles.clear();
                    add_strip(&face, &mut triangles);
                    for triangle in &triangles {
                        mesh.add_face(triangle);
                    }
                } else if face.len() > 2 {
                    mesh.add_face(&face);
                    if own.len() == face.len() && is_whole(&self.textures[own.clone()]) {
                        textured.resize(mesh.corners.len() - face.len(), UvSet::NONE);
                        textured.extend(own.clone().map(|index| index as u32));
                    }
                }
            }
        }
        if !textured.is_empty() {
            textured.resize(mesh.corners.len(), UvSet::NONE);
            // What no corner uses may be no numbers, and is then none.
            let sound = |uv: &[f64; 2]| if uv.iter().all(|c| c.is_finite()) { *uv } else { [0.0; 2] };
            mesh.uv_sets.push(UvSet { values: self.textures.iter().map(sound).collect(), corners: textured });
        } else if is_whole(&textures) {
            mesh.uv_sets.push(UvSet { values: textures, corners: mesh.corners.clone() });
        }
        mesh
    }

    /// Triangles of what is there.
    fn triangles(&self, positions: &[DVec3]) -> Result<Vec<[u32; 3]>, Failure> {
        let mut triangles = Vec::with_capacity(self.ends.len());
        let (mut face, mut cutter) = (Vec::new(), Cutter::default());
        for (index, (corners, is_strip)) in self.each().enumerate() {
            // A strip may be several, with -1 between them.
            for run in corners.split(|&corner| is_strip && corner == -1) {
                face.clear();
                for &corner in run {
                    let Some(vertex) = usable(corner, positions) else {
                        return Err(self.lost(index, corner, positions));
                    };
                    face.push(vertex);
                }
                if is_strip {
                    add_strip(&face, &mut triangles);
                } else if !cutter.cut(&face, positions, &mut triangles) {
                    return Err(too_long(face.len()));
                }
            }
        }
        Ok(triangles)
    }

    /// The corners of each face or strip.
    fn each(&self) -> impl Iterator<Item = (&[i64], bool)> {
        let starts = std::iter::once(0).chain(self.ends.iter().map(|&(end, _)| end));
        starts.zip(&self.ends).map(|(start, &(end, is_strip))| (&self.corners[start..end], is_strip))
    }

    /// Faces at vertices that are not there, or nowhere, of which this is the first.
    fn lost(&self, face: usize, corner: i64, positions: &[DVec3]) -> Failure {
        let is_lost =
            |corner: &i64, is_strip: bool| !(is_strip && *corner == -1) && usable(*corner, positions).is_none();
        let faces = self.each().filter(|(face, is_strip)| face.iter().any(|corner| is_lost(corner, *is_strip))).count();
        let why = match usize::try_from(corner).ok().and_then(|index| positions.get(index)) {
            Some(DVec3 { x, y, z }) => format!("is at ({x}, {y}, {z}), no place"),
            None => format!("is not among the {} that are there, from 0", positions.len()),
        };
        Failure::new(format_args!(
            "`vertex_indices` of face {}: vertex {corner} {why}; {faces} of {} faces have such corners",
            face + 1,
            self.ends.len()
        ))
    }
}

fn is_corners(property: &Property) -> bool {
    matches!(property.name.as_str(), "vertex_indices" | "vertex_index")
}

/// A vertex that is there, and somewhere.
fn usable(corner: i64, positions: &[DVec3]) -> Option<u32> {
    let index = usize::try_from(corner).ok()?;
    positions.get(index)?.is_finite().then_some(index as u32)
}

/// Triangles of a strip: every second one is wound the other way; those that turn a corner have two corners in one.
fn add_strip(strip: &[u32], triangles: &mut Vec<[u32; 3]>) {
    for (index, corners) in strip.windows(3).enumerate() {
        let [a, b, c] = [corners[0], corners[1], corners[2]];
        if a != b && b != c && a != c {
            triangles.push(if index % 2 == 0 { [a, b, c] } else { [b, a, c] });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn strips_keep_their_sense() {
        let mut triangles = Vec::new();
        add_strip(&[0, 1, 2, 3, 3, 4], &mut triangles);
        assert_eq!(triangles, [[0, 1, 2], [2, 1, 3]]);
    }
}
