//! STL, binary and text. It has neither units nor connections, and its normals say no more than its corners.
//!
//! Read here: the crates that read STL stop after the first of several solids, or tell text by its first word alone,
//! and say of a damaged file neither line nor bytes.

use super::failure::{Failure, missing};
use super::notes::{note, warning};
use super::text::{Lines, decoded, number, shown, without_mark, words};
use crate::geometry::model::{MeshData, Model};
use glam::Vec3;
use std::collections::HashMap;

/// What helps where a corner has no numbers.
const COMMAS: &str = "export it again, with points and not commas in its numbers";

/// Bytes before the first facet of a binary file, and of each.
const HEADER: usize = 84;
const FACET: usize = 50;

/// Bytes that are looked at to tell text.
const LOOK: usize = 512;

pub(super) fn read(bytes: &[u8]) -> Result<Model, Failure> {
    let count = bytes.get(80..HEADER).and_then(|count| count.try_into().ok()).map(u32::from_le_bytes);
    let length_of = |count: u32| HEADER as u64 + FACET as u64 * u64::from(count);
    // Text begins with "solid", but so do some binary files: their length gives them away, or else a byte that no text
    // has, such as every count below 16 million ends in, and most numbers.
    if count.is_some_and(|count| length_of(count) == bytes.len() as u64) {
        return read_binary(bytes);
    }
    let text = without_mark(bytes);
    let first = words(&text).next().unwrap_or_default().to_ascii_lowercase();
    let is_text = matches!(first.as_slice(), b"solid" | b"facet") && !text[..text.len().min(LOOK)].contains(&0);
    if is_text { read_text(&text) } else { read_binary(bytes) }
}

fn read_binary(bytes: &[u8]) -> Result<Model, Failure> {
    let Some((header, body)) = bytes.split_at_checked(HEADER) else {
        return Err(Failure::new(format_args!(
            "it is neither text that begins with `solid` nor binary: {} bytes are less than a header",
            bytes.len()
        )));
    };
    let announced = header.last_chunk().map_or(0, |count| u32::from_le_bytes(*count));
    let held = body.len() / FACET;
    let mut model = Model::default();
    // Programs that write as they compute announce none, or the greatest number, and may never come back to correct it.
    let unknown = matches!(announced, 0 | u32::MAX) && held > 0 && body.len() % FACET == 0;
    let count = if unknown { held } else { announced as usize };
    if unknown {
        model.notes.push(note(format!("its header announces {announced} facets: the {held} that are there are read")));
    }
    if held < count {
        return Err(Failure::new(format_args!(
            "its header announces {count} facets, and {held} are there: {}",
            missing(FACET * count - body.len())
        )));
    }
    let mut piece = Piece::default();
    for (index, facet) in body.as_chunks::<FACET>().0[..count].iter().enumerate() {
        let coordinate = |at: usize| {
            let at = 12 + 4 * at;
            f32::from_le_bytes([facet[at], facet[at + 1], facet[at + 2], facet[at + 3]])
        };
        let corners = [0, 3, 6].map(|at| Vec3::new(coordinate(at), coordinate(at + 1), coordinate(at + 2)));
        if let Some(corner) = corners.iter().position(|corner| !corner.is_finite()) {
            let [x, y, z] = corners[corner].to_array();
            return Err(Failure::new(format_args!(
                "facet {} of {count}: corner {} is at ({x}, {y}, {z}), which is no place",
                index + 1,
                corner + 1
            )));
        }
        piece.add(corners);
    }
    model.add(piece.mesh);
    Ok(model)
}

/// Facets whose corners are told apart by their bits.
#[derive(Default)]
struct Piece {
    mesh: MeshData,
    known: HashMap<[u32; 3], u32>,
}

impl Piece {
    fn add(&mut self, corners: [Vec3; 3]) {
        let Self { mesh, known } = self;
        mesh.triangles.push(corners.map(|corner| {
            let next = mesh.positions.len() as u32;
            let index = *known.entry(corner.to_array().map(f32::to_bits)).or_insert(next);
            if index == next {
                mesh.positions.push(corner.as_dvec3());
            }
            index
        }));
    }

    fn finish(self, model: &mut Model) {
        if !self.mesh.triangles.is_empty() {
            model.add(self.mesh);
        }
    }
}

/// What a text file is in the middle of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Within {
    Solid,
    /// Before its first corner, where its normal stands.
    Facet,
    Loop,
}

fn read_text(text: &[u8]) -> Result<Model, Failure> {
    let mut model = Model::default();
    let mut piece = Piece::default();
    let mut corners: Vec<Vec3> = Vec::new();
    let (mut within, mut ended, mut last) = (Within::Solid, true, 0);
    for (line_number, line) in Lines::new(text) {
        let fail = |problem: &str| Err(Failure::in_line(line_number, &shown(line), problem));
        let mut rest = words(line).peekable();
        last = line_number;
        while let Some(word) = rest.next() {
            let mut word = word.to_ascii_lowercase();
            // "end facet" and "end loop" are written too.
            if word == b"end" {
                word.extend(rest.next().unwrap_or_default().to_ascii_lowercase());
            }
            match word.as_slice() {
                b"solid" | b"endsolid" if within != Within::Solid => return fail("the facet before it has no end"),
                b"solid" => {
                    std::mem::take(&mut piece).finish(&mut model);
                    let mut name = Vec::new();
                    while let Some(word) = rest.next_if(|word| !word.eq_ignore_ascii_case(b"facet")) {
                        name.push(decoded(word));
                    }
                    piece.mesh.name = name.join(" ");
                }
                b"endsolid" => {
                    while rest.next_if(|word| !word.eq_ignore_ascii_case(b"solid")).is_some() {}
                    ended = true;
                }
                b"facet" if within == Within::Solid => (within, ended) = (Within::Facet, false),
                b"outer" | b"loop" if within != Within::Solid => within = Within::Loop,
                b"vertex" if within != Within::Solid => {
                    within = Within::Loop;
                    let mut next = || rest.next().and_then(single);
                    let (Some(x), Some(y), Some(z)) = (next(), next(), next()) else {
                        return fail("a corner has three numbers").map_err(|fault| fault.remedied(COMMAS));
                    };
                    let corner = Vec3::new(x, y, z);
                    if !corner.is_finite() {
                        return fail("this is no place");
                    }
                    corners.push(corner);
                }
                b"endloop" if within == Within::Loop => {}
                b"endfacet" if within != Within::Solid => {
                    let &[a, b, c] = corners.as_slice() else {
                        return fail(&format!("the facet that ends here has {} corners, not three", corners.len()));
                    };
                    piece.add([a, b, c]);
                    corners.clear();
                    within = Within::Solid;
                }
                // The normal, which need not even be numbers.
                _ if within == Within::Facet => {}
                b"color" if within == Within::Solid => break,
                _ => return fail("this is out of place in an STL file"),
            }
        }
    }
    if within != Within::Solid {
        let where_from = "it is cut off within a facet";
        return Err(Failure::new(format_args!("line {last}: {where_from}, after {} corners", corners.len())));
    }
    if !ended {
        model.notes.push(warning("it ends without `endsolid`: if it was cut off, faces are missing".to_owned()));
    }
    piece.finish(&mut model);
    Ok(model)
}

/// A coordinate, in the precision of the format.
fn single(word: &[u8]) -> Option<f32> {
    let exact = str::from_utf8(word).ok().and_then(|text| text.parse().ok());
    exact.or_else(|| number(word).map(|value| value as f32))
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    #[test]
    fn corners_are_shared_within_a_solid() {
        let mut piece = Piece::default();
        piece.add([Vec3::ZERO, Vec3::X, Vec3::Y]);
        piece.add([Vec3::X, Vec3::ZERO, Vec3::Z]);
        assert_eq!(piece.mesh.positions, [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z]);
        assert_eq!(piece.mesh.triangles, [[0, 1, 2], [1, 0, 3]]);
    }
}
