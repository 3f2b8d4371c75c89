//! Turning the faces of a surface outwards.

use super::bvh::{Bvh, Node};
use super::edges::{Edges, Groups};
use super::row_index::RowIndex;
use super::scanline::visit_crossings;
use super::winding::solid_angle;
use glam::DVec3;
use std::collections::BTreeMap;
use std::f64::consts::PI;

/// Which faces to turn round, and what was found on the way.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Orientation {
    /// Whether each face is to be turned round.
    pub flipped: Vec<bool>,
    /// Faces that disagreed with most of their piece.
    pub disagreeing: usize,
    /// Edges across which no turning brings the faces to agree (a Möbius strip has one at least).
    pub twisted: usize,
    /// Pieces that were inside out.
    pub inverted: usize,
    /// Pieces inside another that turn the other way: its cavities.
    pub cavities: usize,
    /// Pieces inside another that turn the same way, which fills nothing anew.
    pub nested: usize,
    /// Pieces of surface that are connected through edges.
    pub pieces: Vec<Piece>,
    /// Number of the piece of every face.
    pub piece_of: Vec<u32>,
}

/// One connected piece of surface.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Piece {
    /// Its faces, in order.
    pub faces: Vec<u32>,
    /// Least corner [m].
    pub min: DVec3,
    /// Greatest corner [m].
    pub max: DVec3,
    /// Signed volume once its faces are turned [m³]; of an open piece about its centre.
    pub volume: f64,
    /// Whether it has no open edge: every point lies inside it or outside.
    pub closed: bool,
    /// Whether it is a sheet with edges, whose faces look all but one way.
    pub sheet: bool,
}

/// Solid angles that may be summed to find out which piece lies in an open one; beyond that pieces count as separate.
const BUDGET: usize = 10_000_000;

/// Sum of the area vectors over the area, from which on an open piece is a sheet: one for a flat one.
const FLAT: f64 = 0.9;

/// Points of a piece that are looked at to find out what it lies in: where it touches another one the answer is a
/// matter of round-off, so most of them decide.
const PROBES: usize = 7;

/// Finds out how to turn the faces so that neighbours agree and every piece has its outside outside. A piece within
/// another keeps its sense relative to the outermost, so that a cavity remains one.
pub(crate) fn orientation(points: &[DVec3], faces: &[[u32; 3]], edges: &Edges) -> Orientation {
    let mut found = agree(points, faces, edges);
    (found.pieces, found.piece_of) = pieces(points, faces, edges, &found.flipped);
    let outermost = outermost(points, faces, &found);
    let volume = |piece: usize| found.pieces[piece].volume;
    let is_inverted: Vec<bool> = (0..found.pieces.len()).map(|k| volume(outermost[k].unwrap_or(k)) < 0.0).collect();
    for (index, piece) in found.pieces.iter_mut().enumerate() {
        if is_inverted[index] {
            found.inverted += 1;
            piece.volume = -piece.volume;
            for &face in &piece.faces {
                found.flipped[face as usize] ^= true;
            }
        }
        if outermost[index].is_some() {
            if piece.volume < 0.0 { found.cavities += 1 } else { found.nested += 1 }
        }
    }
    found
}

/// Of every piece the largest one that it lies in, if it lies in any.
fn outermost(points: &[DVec3], faces: &[[u32; 3]], found: &Orientation) -> Vec<Option<usize>> {
    let pieces = &found.pieces;
    let mut budget = BUDGET;
    let fits = |outer: usize, inner: usize| {
        let [around, within] = [&pieces[outer], &pieces[inner]];
        let [large, small] = [around, within].map(|piece| piece.volume.abs());
        let is_larger = large > small || (large == small && outer < inner);
        is_larger && around.min.cmple(within.min).all() && within.max.cmple(around.max).all()
    };
    // The boxes of pieces as faces that fill them.
    let corners: Vec<DVec3> = pieces.iter().flat_map(|piece| [piece.min, piece.max]).collect();
    let boxes: Vec<[u32; 3]> = (0..pieces.len() as u32).map(|k| [2 * k, 2 * k + 1, 2 * k + 1]).collect();
    let boxes = Bvh::new(&corners, &boxes);
    let around_it = |inner: usize| {
        let Piece { min, max, .. } = &pieces[inner];
        let mut around: Vec<usize> = Vec::new();
        let holds = |node: &Node| node.min.cmple(*min).all() && max.cmple(node.max).all();
        boxes.visit(holds, |piece| around.push(piece as usize));
        around.sort_unstable();
        around
    };
    let mut rows_of: BTreeMap<usize, Rows> = BTreeMap::new();
    let around = (0..pieces.len()).map(|inner| {
        if pieces.len() == 1 {
            return None;
        }
        let candidates: Vec<usize> = around_it(inner).into_iter().filter(|&outer| fits(outer, inner)).collect();
        if candidates.is_empty() {
            return None;
        }
        let own = &pieces[inner].faces;
        let probes: Vec<DVec3> = (0..PROBES.min(own.len()))
            .map(|k| own[k * own.len() / PROBES.min(own.len())])
            .map(|face| faces[face as usize].map(|i| points[i as usize]))
            .map(|[a, b, c]| (a + b + c) / 3.0)
            .collect();
        let mut votes: BTreeMap<usize, usize> = BTreeMap::new();
        for &probe in &probes {
            for &outer in &candidates {
                let around = &pieces[outer];
                if around.closed {
                    // How often it turns around the point: what a row from it crosses in the end.
                    let turns = rows_of.entry(outer).or_insert_with(|| Rows::new(points, faces, around)).turns(
                        points,
                        probe,
                        |k| found.flipped[around.faces[k as usize] as usize],
                    );
                    *votes.entry(outer).or_default() += usize::from(turns != 0);
                } else if around.faces.len() <= budget {
                    budget -= around.faces.len();
                    let corners = |&face: &u32| faces[face as usize].map(|i| points[i as usize] - probe);
                    let angle: f64 = around.faces.iter().map(|face| solid_angle(corners(face))).sum();
                    *votes.entry(outer).or_default() += usize::from(angle.abs() > 2.0 * PI);
                }
            }
        }
        votes
            .into_iter()
            .filter(|&(outer, votes)| 2 * votes > probes.len() && fits(outer, inner))
            .map(|(outer, _)| outer)
            .filter(|&outer| pieces[outer].volume != 0.0)
            .reduce(|a, b| if pieces[b].volume.abs() > pieces[a].volume.abs() { b } else { a })
    });
    around.collect()
}

/// The faces of one piece, to be met by rows.
struct Rows {
    faces: Vec<[u32; 3]>,
    index: RowIndex,
}

impl Rows {
    fn new(points: &[DVec3], faces: &[[u32; 3]], piece: &Piece) -> Self {
        let faces: Vec<[u32; 3]> = piece.faces.iter().map(|&face| faces[face as usize]).collect();
        Self { index: RowIndex::new(points, &faces), faces }
    }

    /// How often the piece turns around a point, where `is_flipped` tells which of its faces are turned round first.
    fn turns(&self, points: &[DVec3], from: DVec3, is_flipped: impl Fn(u32) -> bool) -> i32 {
        let mut turns = 0;
        visit_crossings(points, &self.faces, &self.index, [from.y, from.z], |face, x, step| {
            if x > from.x {
                turns += if is_flipped(face) { -step } else { step };
            }
        });
        turns
    }
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

fn pieces(points: &[DVec3], faces: &[[u32; 3]], edges: &Edges, flipped: &[bool]) -> (Vec<Piece>, Vec<u32>) {
    let mut groups = Groups::new(faces.len());
    for edge in edges.iter() {
        for half in &edge[1..] {
            groups.join(edge[0].face as usize, half.face as usize);
        }
    }
    let (labels, count) = groups.labels();
    let empty = Piece {
        faces: Vec::new(),
        min: DVec3::INFINITY,
        max: DVec3::NEG_INFINITY,
        volume: 0.0,
        closed: true,
        sheet: false,
    };
    let mut pieces = vec![empty; count];
    for (face, &label) in labels.iter().enumerate() {
        let piece = &mut pieces[label as usize];
        piece.faces.push(face as u32);
        for i in faces[face] {
            piece.min = piece.min.min(points[i as usize]);
            piece.max = piece.max.max(points[i as usize]);
        }
    }
    for edge in edges.unbalanced(flipped) {
        pieces[labels[edge[0].face as usize] as usize].closed = false;
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
        let (mut sum, mut size) = (DVec3::ZERO, 0.0);
        for &face in &piece.faces {
            let [a, b, c] = faces[face as usize].map(|i| points[i as usize]);
            let vector = (b - a).cross(c - a);
            size += vector.length();
            sum += if flipped[face as usize] { -vector } else { vector };
        }
        piece.sheet = !piece.closed && sum.length() >= FLAT * size;
        if piece.sheet {
            // Which side of a sheet is outside only the file knows.
            piece.volume = 0.0;
        }
    }
    (pieces, labels)
}

/// Area of a face [m²].
pub(crate) fn area(points: &[DVec3], face: [u32; 3]) -> f64 {
    let [a, b, c] = face.map(|i| points[i as usize]);
    0.5 * (b - a).cross(c - a).length()
}
