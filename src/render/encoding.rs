//! The items of a draw list as the shaders read them: rows of 32-bit words.

use crate::draw::{Colour, Faces, Line, Points, Size};
use glam::Vec3;
use std::ops::Range;

/// Bytes of a word.
pub(super) const WORD: usize = 4;

/// 32-bit words of a mesh vertex (position, normal), of what is told of a whole mesh (colour, pick, cut), of a point
/// (centre, radius, colour, share through, pick) and of a segment (four points, colour, style, flags, pick).
pub(super) const VERTEX_WORDS: usize = 6;
pub(super) const ITEM_WORDS: usize = 6;
/// Red, green and blue of a vertex, 8 bits each, and in the highest 8 whether it has a colour of its own.
pub(super) const TINT_WORDS: usize = 1;
pub(super) const POINT_WORDS: usize = 10;
pub(super) const SEGMENT_WORDS: usize = 20;

/// A segment's flags, as in line.wgsl.
const HAS_PREVIOUS: u32 = 1;
const HAS_NEXT: u32 = 2;
pub(super) const ON_SCREEN: u32 = 4;

pub(super) fn push<const N: usize>(words: &mut Vec<u32>, values: [f32; N]) {
    words.extend(values.map(f32::to_bits));
}

/// Puts a mesh into the common buffers; gives the range of its indices.
pub(super) fn push_mesh(vertices: &mut Vec<u32>, indices: &mut Vec<u32>, faces: &Faces) -> Range<u32> {
    let (first_vertex, first_index) = ((vertices.len() / VERTEX_WORDS) as u32, indices.len() as u32);
    let (new_vertices, new_indices) = faces.worked_out();
    for vertex in &*new_vertices {
        push(vertices, vertex.position.to_array());
        push(vertices, vertex.normal.to_array());
    }
    indices.extend(new_indices.iter().map(|index| first_vertex + index));
    first_index..indices.len() as u32
}

pub(super) fn push_points(words: &mut Vec<u32>, set: &Points) {
    // A radius in pixels goes as a negative one, as in point.wgsl.
    let radius = match set.size {
        Size::Metres(radius) => radius.max(1e-12),
        Size::Pixels(radius) => -radius.max(1e-3),
    };
    for (number, centre) in (0..).zip(&set.centres) {
        // Numbers go by place, so what is left out still counts.
        if !centre.is_finite() {
            continue;
        }
        push(words, centre.to_array());
        push(words, [radius]);
        let own = set.tints.get(number as usize).map(|&[red, green, blue]| Colour::from_rgb([red, green, blue]));
        push(words, own.unwrap_or(set.colour).linear());
        push(words, [set.through]);
        words.push(if set.pick == 0 { 0 } else { set.pick + number });
    }
}

/// Segments of a line, with the flags that all of them have.
pub(super) fn push_line(words: &mut Vec<u32>, line: &Line, flags: u32) {
    let points: Vec<Vec3> = line.points.iter().copied().filter(|point| point.is_finite()).collect();
    let last = points.len().saturating_sub(2);
    for k in 0..points.len().saturating_sub(1) {
        let before = if k > 0 { HAS_PREVIOUS } else { 0 };
        let behind = if k < last { HAS_NEXT } else { 0 };
        for point in [points[k], points[k + 1], points[k.saturating_sub(1)], points[(k + 2).min(last + 1)]] {
            push(words, point.to_array());
        }
        push(words, Colour::linear(line.colour));
        push(words, [line.width, line.through]);
        words.extend([flags | before | behind, line.pick]);
    }
}

/// Words of a buffer's row as an offset [bytes].
pub(super) fn row_offset(row: u32, words: usize) -> u64 {
    u64::from(row) * (words * WORD) as u64
}
