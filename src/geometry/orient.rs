//! Turning the faces of a surface outwards.

use super::edges::{Edges, Groups};
use super::winding::solid_angle;
use glam::DVec3;
use std::f64::consts::PI;

/// Which faces to turn round, and what was found on the way.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Orientation {
    /// Whether each face is to be turned round.
    pub flipped: Vec<bool>,
    /// Faces that disagreed with most of their piece.
    pub disagreeing: usize,
    /// Edges across which no turning brings the faces to agree (a Möbius strip has one at least).
    pub twisted: usize,
    /// Pieces of surface that are connected through edges.
    pub pieces: usize,
    /// Pieces that were inside out.
    pub inverted: usize,
    /// Pieces inside another that turn the other way: its cavities.
    pub cavities: usize,
    /// Pieces inside another that turn the same way, which fills nothing anew.
    pub nested: usize,
}

/// One connected piece of surface.
#[derive(Clone, Debug)]
struct Component {
    faces: Vec<u32>,
    min: DVec3,
    max: DVec3,
    volume: f64,
}

/// Solid angles that may be summed to find out which piece lies in which; beyond that pieces count as separate.
const BUDGET: usize = 200_000_000;

/// Finds out how to turn the faces so that neighbours agree and every piece has its outside outside. A piece within
/// another keeps its sense relative to that, so that a cavity remains one.
pub(crate) fn orientation(points: &[DVec3], faces: &[[u32; 3]], edges: &Edges) -> Orientation {
    let mut found = agree(points, faces, edges);
    let pieces = pieces(points, faces, edges, &found.flipped);
    found.pieces = pieces.len();
    let mut budget = BUDGET;
    let outermost: Vec<Option<usize>> = (0..pieces.len())
        .map(|inner| (0..pieces.len()).find(|&outer| contains(points, faces, &pieces, outer, inner, &mut budget)))
        .map(|outer| outer.filter(|&k| pieces[k].volume != 0.0))
        .collect();
    let is_inverted = |piece: usize| pieces[outermost[piece].unwrap_or(piece)].volume < 0.0;
    for (index, piece) in pieces.iter().enumerate() {
        if is_inverted(index) {
            found.inverted += 1;
            for &face in &piece.faces {
                found.flipped[face as usize] ^= true;
            }
        }
        if outermost[index].is_some() {
            let cavity = (piece.volume < 0.0) != is_inverted(index);
            if cavity { found.cavities += 1 } else { found.nested += 1 }
        }
    }
    found
}

/// Makes neighbours agree with most of their piece, by area.
fn agree(points: &[DVec3], faces: &[[u32; 3]], edges: &Edges) -> Orientation {
    let mut around: Vec<Vec<(u32, bool)>> = vec![Vec::new(); faces.len()];
    for ([a, b], opposite) in edges.neighbours() {
        around[a as usize].push((b, opposite));
        around[b as usize].push((a, opposite));
    }
    let mut found = Orientation { flipped: vec![false; faces.len()], ..Orientation::default() };
    let mut seen = vec![false; faces.len()];
    for seed in 0..faces.len() {
        if seen[seed] {
            continue;
        }
        seen[seed] = true;
        let mut patch = vec![seed];
        let mut next = 0;
        while next < patch.len() {
            let face = patch[next];
            next += 1;
            for &(other, opposite) in &around[face] {
                let wanted = found.flipped[face] == opposite;
                let other = other as usize;
                if !seen[other] {
                    seen[other] = true;
                    found.flipped[other] = wanted;
                    patch.push(other);
                } else if found.flipped[other] != wanted {
                    found.twisted += 1;
                }
            }
        }
        let area = |turned: bool| -> f64 {
            patch.iter().filter(|&&face| found.flipped[face] == turned).map(|&face| area(points, faces[face])).sum()
        };
        if area(true) > area(false) {
            for &face in &patch {
                found.flipped[face] ^= true;
            }
        }
    }
    // Every twisted edge was met from both sides.
    found.twisted /= 2;
    found.disagreeing = found.flipped.iter().filter(|&&flipped| flipped).count();
    found
}

fn pieces(points: &[DVec3], faces: &[[u32; 3]], edges: &Edges, flipped: &[bool]) -> Vec<Component> {
    let mut groups = Groups::new(faces.len());
    for edge in edges.iter() {
        for half in &edge[1..] {
            groups.join(edge[0].face as usize, half.face as usize);
        }
    }
    let (labels, count) = groups.labels();
    let empty = Component { faces: Vec::new(), min: DVec3::INFINITY, max: DVec3::NEG_INFINITY, volume: 0.0 };
    let mut pieces = vec![empty; count];
    for (face, &label) in labels.iter().enumerate() {
        let piece = &mut pieces[label as usize];
        piece.faces.push(face as u32);
        for i in faces[face] {
            piece.min = piece.min.min(points[i as usize]);
            piece.max = piece.max.max(points[i as usize]);
        }
    }
    for piece in &mut pieces {
        // About its centre: what an open piece lacks weighs least there.
        let center = 0.5 * (piece.min + piece.max);
        piece.volume = piece
            .faces
            .iter()
            .map(|&face| {
                let [a, b, c] = faces[face as usize].map(|i| points[i as usize] - center);
                a.dot(b.cross(c)) / if flipped[face as usize] { -6.0 } else { 6.0 }
            })
            .sum();
    }
    pieces
}

/// Whether a piece surrounds another.
fn contains(
    points: &[DVec3],
    faces: &[[u32; 3]],
    pieces: &[Component],
    outer: usize,
    inner: usize,
    budget: &mut usize,
) -> bool {
    let [around, within] = [&pieces[outer], &pieces[inner]];
    let fits = around.min.cmplt(within.min).all() && within.max.cmplt(around.max).all();
    if outer == inner || !fits || around.faces.len() > *budget {
        return false;
    }
    *budget -= around.faces.len();
    let at = points[faces[within.faces[0] as usize][0] as usize];
    let angle: f64 =
        around.faces.iter().map(|&face| solid_angle(faces[face as usize].map(|i| points[i as usize] - at))).sum();
    angle.abs() > 2.0 * PI
}

/// Area of a face [m²].
pub(crate) fn area(points: &[DVec3], face: [u32; 3]) -> f64 {
    let [a, b, c] = face.map(|i| points[i as usize]);
    0.5 * (b - a).cross(c - a).length()
}
