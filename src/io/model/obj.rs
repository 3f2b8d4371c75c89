//! Wavefront OBJ with its MTL: objects, groups and materials are parts, a material's diffuse colour is their colour.
//!
//! Read here: the crates that read OBJ in double precision take polylines for faces, know no continued lines, pass over
//! a first line behind a byte order mark so that every index is off by one, and say of no fault in which line it is.

use super::failure::Failure;
use super::limits::MOST_PARTS;
use super::mtl::Materials;
use super::notes::note;
use super::obj_piece::{Corner, Piece, Vertices};
use super::polygon::{Cutter, too_long};
use super::text::{Lines, decoded, named, number, shown, without_mark, words};
use crate::geometry::file_mesh::{CornerValues, FileMesh, FilePart, UvSet};
use crate::geometry::model::Model;
use crate::io::colours::linear;
use glam::{DVec3, Vec3};
use std::borrow::Cow;
use std::path::Path;
use std::sync::Arc;

pub(super) fn read(bytes: &[u8], folder: &Path) -> Result<Model, Failure> {
    let text = without_mark(bytes);
    // First what faces refer to: some files have the faces before it.
    let mut vertices = Vertices::default();
    each_statement(&text, |line| add_vertex(line, &mut vertices))?;
    let mut reader = Reader::new(folder, &vertices);
    each_statement(&text, |line| reader.add(line))?;
    Ok(reader.finish())
}

/// Hands over every line, with those that a backslash joins to it.
pub(super) fn each_statement(
    text: &[u8],
    mut read: impl FnMut(&Statement<'_>) -> Result<(), Failure>,
) -> Result<(), Failure> {
    let mut lines = Lines::new(text);
    while let Some((number, line)) = lines.next() {
        let statement = continued(line, &mut lines);
        read(&Statement { number, text: &statement })?;
    }
    Ok(())
}

/// A line with those that a backslash at its end joins to it.
fn continued<'a>(line: &'a [u8], lines: &mut Lines<'a>) -> Cow<'a, [u8]> {
    let mut statement = Cow::Borrowed(line);
    while let Some(open) = statement.trim_ascii_end().strip_suffix(b"\\").map(<[u8]>::len) {
        let Some((_, next)) = lines.next() else { break };
        let statement = statement.to_mut();
        statement.truncate(open);
        statement.push(b' ');
        statement.extend(next);
    }
    statement
}

/// A line and its number.
pub(super) struct Statement<'a> {
    pub(super) number: usize,
    text: &'a [u8],
}

impl<'a> Statement<'a> {
    pub(super) fn keyword(&self) -> &'a [u8] {
        words(self.text).next().unwrap_or_default()
    }

    pub(super) fn fail(&self, problem: impl std::fmt::Display) -> Failure {
        Failure::in_line(self.number, &shown(self.text), problem)
    }

    /// The words behind the first, up to a comment.
    pub(super) fn values(&self) -> impl Iterator<Item = &'a [u8]> {
        words(self.text).skip(1).take_while(|word| !word.starts_with(b"#"))
    }

    /// What stands behind the first word.
    pub(super) fn name(&self) -> &'a [u8] {
        let text = self.text.trim_ascii_start();
        let end = text.iter().position(u8::is_ascii_whitespace).unwrap_or(text.len());
        text[end..].trim_ascii()
    }

    /// Numbers, of which a comment may touch the last.
    pub(super) fn numbers<const N: usize>(&self, out: &mut [f64; N]) -> Result<usize, Failure> {
        let mut count = 0;
        for word in self.values() {
            let end = word.iter().position(|&byte| byte == b'#').filter(|_| number(word).is_none());
            let value = number(&word[..end.unwrap_or(word.len())]);
            let Some(value) = value else {
                let fault = self.fail(format_args!("`{}` is not a number", shown(word)));
                let remedy = "export it again, with points and not commas in its numbers";
                return Err(if word.contains(&b',') { fault.remedied(remedy) } else { fault });
            };
            if let Some(place) = out.get_mut(count) {
                *place = value;
            }
            count += 1;
            if end.is_some() {
                break;
            }
        }
        Ok(count)
    }
}

/// Takes what faces refer to out of a line.
fn add_vertex(line: &Statement<'_>, vertices: &mut Vertices) -> Result<(), Failure> {
    match line.keyword() {
        b"v" => {
            let mut values = [0.0; 7];
            let count = line.numbers(&mut values)?;
            let [x, y, z, w, ..] = values;
            let mut position = DVec3::new(x, y, z);
            match count {
                0..=2 => return Err(line.fail("a vertex has three coordinates")),
                4 if w == 0.0 => return Err(line.fail("its fourth coordinate is the weight to divide by, and zero")),
                4 => position /= w,
                // Red, green and blue behind it, and opacity.
                6 | 7 => vertices.set_colour(linear([values[3], values[4], values[5]])),
                _ => {}
            }
            vertices.add(position, line.number);
        }
        b"vn" => {
            let mut n = [0.0; 3];
            // One that is not whole stands for none: faces do without.
            let whole = line.numbers(&mut n).is_ok_and(|count| count >= 3);
            let normal = DVec3::from_array(n).as_vec3().normalize_or_zero();
            vertices.normals.push(whole.then_some(normal));
        }
        b"vt" => {
            let mut uv = [0.0; 3];
            // One coordinate alone runs along a line; one that is no number stands for none.
            let whole = line.numbers(&mut uv).is_ok_and(|count| count >= 1) && uv.iter().all(|c| c.is_finite());
            vertices.textures.push(whole.then_some([uv[0], uv[1]]));
        }
        _ => {}
    }
    Ok(())
}

struct Reader<'a> {
    folder: &'a Path,
    vertices: &'a Vertices,
    /// Vertices, texture coordinates and normals so far, which negative indices count back from.
    seen: [usize; 3],
    materials: Materials,
    material: Option<String>,
    name: String,
    piece: Piece,
    cutter: Cutter,
    corners: Vec<Corner>,
    model: Model,
    file: FileMesh,
    /// Name of the present material, known or not.
    material_name: String,
    textures: Vec<u32>,
    normals: Vec<u32>,
    /// Lines of faces that have no three corners: how many, and the first.
    too_few: Option<(usize, usize)>,
}

impl<'a> Reader<'a> {
    fn new(folder: &'a Path, vertices: &'a Vertices) -> Self {
        Self {
            folder,
            vertices,
            seen: [0; 3],
            materials: Materials::default(),
            material: None,
            name: String::new(),
            piece: Piece::default(),
            cutter: Cutter::default(),
            corners: Vec::new(),
            model: Model::default(),
            file: FileMesh::default(),
            material_name: String::new(),
            textures: Vec::new(),
            normals: Vec::new(),
            too_few: None,
        }
    }

    fn add(&mut self, line: &Statement<'_>) -> Result<(), Failure> {
        match line.keyword() {
            b"v" => self.seen[0] += 1,
            b"vt" => self.seen[1] += 1,
            b"vn" => self.seen[2] += 1,
            // The second is how the first versions of the format name it.
            b"f" | b"fo" => self.add_face(line)?,
            b"o" | b"g" => {
                self.finish_piece();
                self.name = named(line.name());
                self.begin_part(line)?;
            }
            b"mtllib" => self.materials.load(self.folder, &decoded(line.name())),
            b"usemtl" => {
                let material = Some(named(line.name())).filter(|name| self.materials.knows(name));
                if material != self.material {
                    self.finish_piece();
                    self.material = material;
                }
                self.material_name = named(line.name());
                self.begin_part(line)?;
            }
            // Lines, points, curves and what else is no surface.
            _ => {}
        }
        Ok(())
    }

    fn add_face(&mut self, line: &Statement<'_>) -> Result<(), Failure> {
        self.corners.clear();
        for word in line.values() {
            let end = word.iter().position(|&byte| byte == b'#');
            self.corners.push(self.corner(&word[..end.unwrap_or(word.len())], line)?);
            if end.is_some() {
                break;
            }
        }
        if self.corners.len() < 3 {
            // Programs leave an edge here and there where they cut or merged faces: it is no surface.
            let (count, first) = self.too_few.unwrap_or((0, line.number));
            self.too_few = Some((count + 1, first));
            return Ok(());
        }
        if !self.piece.add_face(&self.corners, self.vertices, &mut self.cutter) {
            return Err(too_long(self.corners.len()));
        }
        let Self { corners, file, vertices, textures, normals, .. } = self;
        let is_there = |index: &u32| vertices.textures.get(*index as usize).is_some_and(Option::is_some);
        textures.extend(corners.iter().map(|corner| corner.texture.filter(is_there).unwrap_or(UvSet::NONE)));
        // One without length is none.
        let is_normal =
            |index: &u32| vertices.normals.get(*index as usize).is_some_and(|n| n.is_some_and(|n| n != Vec3::ZERO));
        normals.extend(corners.iter().map(|corner| corner.normal.filter(is_normal).unwrap_or(UvSet::NONE)));
        let corners: Vec<u32> = corners.iter().map(|corner| corner.vertex).collect();
        file.add_face(&corners);
        Ok(())
    }

    fn begin_part(&mut self, line: &Statement<'_>) -> Result<(), Failure> {
        if self.file.parts.len() > MOST_PARTS {
            return Err(line.fail(format_args!("it begins more than {MOST_PARTS} parts")));
        }
        let colour = self.material.as_ref().and_then(|name| self.materials.colour(name));
        let (name, material) = (self.name.clone(), self.material_name.clone());
        self.file.begin_part(FilePart { name, material, colour, ..FilePart::default() });
        Ok(())
    }

    /// One corner of a face: `vertex`, `vertex/texture`, `vertex//normal` or `vertex/texture/normal`.
    fn corner(&self, word: &[u8], line: &Statement<'_>) -> Result<Corner, Failure> {
        let no_corner = || line.fail(format_args!("`{}` is no corner of a face", shown(word)));
        let mut parts = word.split(|&byte| byte == b'/');
        let mut index = |seen: usize| match parts.next() {
            None | Some([]) => Ok(None),
            Some(digits) => {
                let given = whole(digits).ok_or_else(no_corner)?;
                // From 1, or backwards from the last one so far.
                let from_zero = if given < 0 { given.saturating_add_unsigned(seen as u64) } else { given - 1 };
                Ok(Some((given, u32::try_from(from_zero).unwrap_or(u32::MAX))))
            }
        };
        let (given, vertex) = index(self.seen[0])?.ok_or_else(no_corner)?;
        let texture = index(self.seen[1])?.map(|(_, texture)| texture);
        let normal = index(self.seen[2])?.map(|(_, normal)| normal);
        if parts.next().is_some() {
            return Err(no_corner());
        }
        let count = self.vertices.positions.len();
        if vertex as usize >= count {
            return Err(line.fail(match given {
                0 => "vertices are counted from 1, and this is 0".to_owned(),
                _ => format!("it refers to vertex {given}, and {count} are there"),
            }));
        }
        if let Some(at) = self.vertices.lost(vertex) {
            return Err(line.fail(format_args!("it refers to vertex {given}, which in line {at} is at no place")));
        }
        Ok(Corner { vertex, texture, normal })
    }

    fn finish_piece(&mut self) {
        let piece = std::mem::take(&mut self.piece);
        if !piece.is_empty() {
            let colour = self.material.as_ref().and_then(|name| self.materials.colour(name));
            self.model.add(piece.finish(self.name.clone(), colour, self.vertices));
        }
    }

    fn finish(mut self) -> Model {
        self.finish_piece();
        self.file.end_part();
        self.file.points.clone_from(&self.vertices.positions);
        if self.textures.iter().any(|&index| index != UvSet::NONE) {
            let values = self.vertices.textures.iter().map(|uv| uv.unwrap_or_default()).collect();
            self.file.uv_sets.push(UvSet { values, corners: self.textures });
        }
        let values = self.vertices.normals.iter().map(|normal| normal.unwrap_or_default().as_dvec3()).collect();
        self.file.normals = Some(CornerValues { values, corners: self.normals });
        self.file.complete_normals();
        self.file.colours = self.vertices.all_colours();
        self.model.file = Some(Arc::new(self.file));
        self.model.notes.extend(self.materials.told().map(note));
        if let Some((count, line)) = self.too_few {
            let faces = if count == 1 { "1 face has" } else { &format!("{count} faces have") };
            let text = format!("{faces} fewer than three corners and no part in the surface, the first in line {line}");
            self.model.notes.push(note(text));
        }
        self.model
    }
}

/// A whole number, as fast as its digits allow.
fn whole(digits: &[u8]) -> Option<i64> {
    str::from_utf8(digits).ok()?.parse().ok()
}
