//! A plane section through a surface: the outlines in which the plane meets it, filled.

use glam::Vec2;
use lyon_tessellation::geometry_builder::{BuffersBuilder, Positions, VertexBuffers};
use lyon_tessellation::math::{Point, point};
use lyon_tessellation::{FillOptions, FillRule, FillTessellator};
use std::collections::HashMap;

/// A flat region as triangles, counter-clockwise.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Section {
    /// Corners, in the plane's coordinates [m].
    pub corners: Vec<Vec2>,
    /// Three indices a triangle.
    pub triangles: Vec<[u32; 3]>,
}

/// Coordinates are scaled to this extent while they are filled: what lies nearer together than a hundred thousandth of
/// it is one place.
const EXTENT: f32 = 1000.0;
const TOLERANCE: f32 = 0.01;

/// Fills what a closed surface encloses in the plane of height zero, where pieces overlap once. `height` and `at` are
/// those of a vertex above the plane and in it, both [m]; seen from above, faces turn outwards counter-clockwise and
/// `at` is right-handed.
pub(crate) fn section(triangles: &[[u32; 3]], height: impl Fn(u32) -> f32, at: impl Fn(u32) -> Vec2) -> Section {
    // Where an edge passes through the plane, computed alike for both of its faces.
    let crossing = |a: u32, b: u32| {
        let (low, high) = (a.min(b), a.max(b));
        let (from, to) = (height(low), height(high));
        at(low).lerp(at(high), from / (from - to))
    };
    // From where each outline enters a face to where it leaves it.
    let mut next: HashMap<[u32; 2], Vec<[u32; 2]>> = HashMap::new();
    let mut starts = Vec::new();
    for &face in triangles {
        let above = face.map(|i| height(i) > 0.0);
        let edge = |k: usize| [face[k], face[(k + 1) % 3]];
        let passes = |up: bool| (0..3).find(|&k| above[k] != up && above[(k + 1) % 3] == up);
        if let (Some(up), Some(down)) = (passes(true), passes(false)) {
            let key = |[a, b]: [u32; 2]| [a.min(b), a.max(b)];
            let (from, to) = (key(edge(down)), key(edge(up)));
            next.entry(from).or_default().push(to);
            starts.push(from);
        }
    }
    let outlines = outlines(starts, next);
    let outlines: Vec<Vec<Vec2>> =
        outlines.iter().map(|outline| outline.iter().map(|&[a, b]| crossing(a, b)).collect()).collect();
    fill(&outlines)
}

/// Chains of edges, each of which follows on the one before; an outline that does not close is closed straight.
fn outlines(starts: Vec<[u32; 2]>, mut next: HashMap<[u32; 2], Vec<[u32; 2]>>) -> Vec<Vec<[u32; 2]>> {
    let mut outlines = Vec::new();
    for start in starts {
        let mut outline = Vec::new();
        let mut place = start;
        while let Some(to) = next.get_mut(&place).and_then(Vec::pop) {
            outline.push(place);
            place = to;
            if place == start {
                break;
            }
        }
        if outline.len() > 2 {
            outlines.push(outline);
        }
    }
    outlines
}

/// What outlines turn around, holes left out.
fn fill(outlines: &[Vec<Vec2>]) -> Section {
    let all = || outlines.iter().flatten();
    let (low, high) = all().fold((Vec2::INFINITY, Vec2::NEG_INFINITY), |(low, high), &p| (low.min(p), high.max(p)));
    let scale = EXTENT / (high - low).max_element();
    if !(scale.is_finite() && scale > 0.0) {
        return Section::default();
    }
    let mut buffers: VertexBuffers<Point, u32> = VertexBuffers::new();
    let mut output = BuffersBuilder::new(&mut buffers, Positions);
    let mut tessellator = FillTessellator::new();
    let options = FillOptions::tolerance(TOLERANCE).with_fill_rule(FillRule::NonZero);
    let mut path = tessellator.builder(&options, &mut output);
    for outline in outlines {
        let mut points = outline.iter().map(|&p| (p - low) * scale).map(|p| point(p.x, p.y));
        if let Some(first) = points.next() {
            path.begin(first);
            points.for_each(|p| {
                path.line_to(p);
            });
            path.end(true);
        }
    }
    if path.build().is_err() {
        // Outlines that are no numbers any more: there is nothing to be filled.
        return Section::default();
    }
    let corners: Vec<Vec2> = buffers.vertices.iter().map(|p| low + Vec2::new(p.x, p.y) / scale).collect();
    let turned = |[a, b, c]: [u32; 3]| {
        let [p, q, r] = [a, b, c].map(|i| corners[i as usize]);
        if (q - p).perp_dot(r - p) < 0.0 { [a, c, b] } else { [a, b, c] }
    };
    let triangles = buffers.indices.as_chunks::<3>().0.iter().map(|&face| turned(face)).collect();
    Section { corners, triangles }
}

impl Section {
    /// Splits triangles until no edge is longer than `length` [m], as far as there are no more than `most` triangles.
    pub(crate) fn refine(&mut self, length: f32, most: usize) {
        loop {
            let mut middles: HashMap<[u32; 2], u32> = HashMap::new();
            let mut fine = Vec::with_capacity(2 * self.triangles.len());
            for &face in &self.triangles {
                let corners = &mut self.corners;
                let middle = |k: usize, corners: &mut Vec<Vec2>, middles: &mut HashMap<[u32; 2], u32>| {
                    let [a, b] = [face[k], face[(k + 1) % 3]];
                    let [p, q] = [a, b].map(|i| corners[i as usize]);
                    (p.distance(q) > length).then(|| {
                        *middles.entry([a.min(b), a.max(b)]).or_insert_with(|| {
                            corners.push(0.5 * (p + q));
                            corners.len() as u32 - 1
                        })
                    })
                };
                let split = [0, 1, 2].map(|k| middle(k, corners, &mut middles));
                fine.extend(divided(face, split));
            }
            let is_done = fine.len() == self.triangles.len();
            self.triangles = fine;
            if is_done || self.triangles.len() > most {
                return;
            }
        }
    }
}

/// A triangle with points on some of its edges, that from each corner to the next, in triangles.
fn divided([a, b, c]: [u32; 3], split: [Option<u32>; 3]) -> Vec<[u32; 3]> {
    match split {
        [None, None, None] => vec![[a, b, c]],
        [Some(ab), Some(bc), Some(ca)] => vec![[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]],
        // Turned until the first edge is the one, or the one before the other.
        [Some(ab), None, None] => vec![[a, ab, c], [ab, b, c]],
        [Some(ab), Some(bc), None] => vec![[ab, b, bc], [a, ab, bc], [a, bc, c]],
        [first, second, third] => divided([b, c, a], [second, third, first]),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::lattice::Cuboid;
    use crate::geometry::mesh::box_surface;
    use glam::DVec3;

    fn area(section: &Section) -> f32 {
        let doubled = |face: &[u32; 3]| {
            let [p, q, r] = face.map(|i| section.corners[i as usize]);
            (q - p).perp_dot(r - p)
        };
        section.triangles.iter().map(|face| 0.5 * doubled(face)).sum()
    }

    #[test]
    fn sections_have_their_areas_with_holes_and_where_pieces_overlap() {
        // Boxes about the origin and one beside it, at heights that are their corners' and others.
        let boxed = |center: [f64; 3], size: [f64; 3], hollow: bool| {
            let mesh = box_surface(&Cuboid { center: center.into(), size: size.into() }, 0.25);
            let faces = mesh.triangles.into_iter().map(move |[a, b, c]| if hollow { [c, b, a] } else { [a, b, c] });
            (mesh.positions, faces.collect::<Vec<_>>())
        };
        let joined = |parts: Vec<(Vec<DVec3>, Vec<[u32; 3]>)>| {
            parts.into_iter().fold((Vec::new(), Vec::new()), |(mut points, mut faces), (more, triangles)| {
                faces.extend(triangles.into_iter().map(|face| face.map(|i| i + points.len() as u32)));
                points.extend(more);
                (points, faces)
            })
        };
        let outer = || boxed([0.0; 3], [2.0, 1.0, 1.0], false);
        for (parts, expected) in [
            (vec![outer()], 2.0),
            (vec![outer(), boxed([0.0; 3], [1.0, 0.5, 0.5], true)], 1.5),
            (vec![outer(), boxed([1.0, 0.0, 0.0], [1.0, 0.5, 0.5], false)], 2.25),
            (vec![outer(), boxed([5.0, 0.0, 0.0], [1.0, 1.0, 1.0], false)], 3.0),
        ] {
            let (points, faces) = joined(parts);
            for plane in [-0.2, 0.0, 0.1] {
                let of = |i: u32| points[i as usize].as_vec3();
                let mut section = section(&faces, |i| of(i).y - plane, |i| Vec2::new(of(i).z, of(i).x));
                assert!((area(&section) - expected).abs() < 1e-3, "{plane}: {} not {expected}", area(&section));
                section.refine(0.3, 100_000);
                assert!((area(&section) - expected).abs() < 1e-3, "{plane}: {}", area(&section));
                let longest = section.triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
                let length = |[a, b]: [u32; 2]| section.corners[a as usize].distance(section.corners[b as usize]);
                assert!(longest.map(length).fold(0.0, f32::max) <= 0.3);
            }
        }
        let (points, faces) = outer();
        let of = |i: u32| points[i as usize].as_vec3();
        assert_eq!(section(&faces, |i| of(i).y - 0.7, |i| Vec2::new(of(i).z, of(i).x)), Section::default());
        assert_eq!(section(&faces, |i| of(i).y * f32::NAN, |i| Vec2::new(of(i).z, of(i).x)), Section::default());
    }
}
