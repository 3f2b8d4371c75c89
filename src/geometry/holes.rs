//! A surface with holes: what its winding number calls inside, row by row.
//!
//! Why. The winding number at a point costs a walk through a tree of far fields, and a row through a model asks for
//! dozens. Hardly any has to be computed: with every hole closed by a cap the surface turns around each point a whole
//! number of times, which is found by counting what the row crosses. What the caps turn around the point has to be
//! taken from that again; it is at most the share of the sky that they fill. Where that is too little to matter nothing
//! else is looked at, and elsewhere only the caps are, of which there are mostly few.

use super::bvh::Bvh;
use super::caps::caps;
use super::row_index::RowIndex;
use super::scanline::crossings;
use super::winding::Winding;
use glam::DVec3;
use rayon::prelude::*;
use std::collections::HashMap;
use std::f64::consts::PI;

/// A surface with holes, and the caps that would close them.
#[derive(Clone, Debug)]
pub(crate) struct OpenSurface {
    /// Points of the surface, then one for each cap.
    points: Vec<DVec3>,
    capped: Vec<[u32; 3]>,
    capped_index: RowIndex,
    caps_bvh: Bvh,
    /// How often the caps turn around a point.
    caps_turn: Winding,
    /// Area of the caps in each node of their tree [m²].
    cap_areas: Vec<f64>,
    /// Least and greatest corner [m].
    bounds: [DVec3; 2],
    /// Steps in which a row is looked at where it has to be [m].
    step: f64,
    /// Rows that were looked at, by the bits of where they run.
    known: HashMap<[u64; 2], OpenRow>,
}

/// A place at which the winding number was looked at.
#[derive(Clone, Copy, Debug)]
struct Look {
    x: f64,
    /// The winding number less one half.
    value: f64,
    /// Whether only its sign is to be trusted, and that it is not doubtful.
    is_rough: bool,
}

impl Look {
    fn exact(self, at: &impl Fn(f64) -> f64) -> (f64, f64) {
        (self.x, if self.is_rough { at(self.x) } else { self.value })
    }
}

/// A row through a surface with holes.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct OpenRow {
    /// Stretches where the winding number is above one half, in order [m].
    pub inside: Vec<[f64; 2]>,
    /// Length where it is within a quarter of one half [m]: there the surface does not say clearly.
    pub doubtful: f64,
    /// Crossings of the surface with its caps, in order.
    pub crossings: Vec<(f64, i32)>,
    /// How many winding numbers were looked at.
    pub looks: u32,
}

/// Steps along the diagonal in which the rows are looked at.
const LOOKS: f64 = 24.0;

/// How much nearer to one half, or to being doubtful, a rough winding number may be than it looks: while neither
/// changes it stands for the exact one.
const ROUGH: f64 = 0.06;

/// Steps that find where a winding number passes one half, and how near they come, in steps of the look.
const TRIES: usize = 12;
const NEAR: f64 = 5e-3;

/// Winding numbers this close to one half are doubtful.
const DOUBT: f64 = 0.25;

/// Winding number of a single face that the point may lie on, at most.
const TOUCHING: f64 = 0.5;

/// Part of the certainty that one node of the tree of caps may take before its children are looked at.
const COARSE: f64 = 0.02;

impl OpenSurface {
    /// Closes the holes of oriented faces.
    pub(crate) fn new(points: &[DVec3], faces: &[[u32; 3]]) -> Self {
        let mut points = points.to_vec();
        let caps = caps(&mut points, faces);
        let capped = [faces, &caps].concat();
        let capped_index = RowIndex::new(&points, &capped);
        let caps_bvh = Bvh::new(&points, &caps);
        let caps_turn = Winding::new(&points, &caps, &caps_bvh);
        let area = |&face: &u32| {
            let [a, b, c] = caps[face as usize].map(|i| points[i as usize]);
            0.5 * (b - a).cross(c - a).length()
        };
        let cap_areas =
            (0..caps_bvh.nodes().len()).map(|node| caps_bvh.triangles(node).iter().map(area).sum()).collect();
        // Caps lie between the points of the surface.
        let corners = || capped.iter().flatten().map(|&i| points[i as usize]);
        let bounds = if capped.is_empty() {
            [DVec3::ZERO; 2]
        } else {
            [corners().fold(DVec3::INFINITY, DVec3::min), corners().fold(DVec3::NEG_INFINITY, DVec3::max)]
        };
        let step = if capped.is_empty() { 1.0 } else { (bounds[1] - bounds[0]).length() / LOOKS };
        Self { points, capped, capped_index, caps_bvh, caps_turn, cap_areas, bounds, step, known: HashMap::new() }
    }

    /// Signed volume of the surface with its caps, about `origin` [m³].
    pub(crate) fn capped_volume(&self, origin: DVec3) -> f64 {
        let corners = self.capped.iter().map(|face| face.map(|i| self.points[i as usize] - origin));
        corners.map(|[a, b, c]| a.dot(b.cross(c)) / 6.0).sum()
    }

    /// Whether the row through (y, z) along x comes near: outside of the box around it a surface turns around nothing
    /// more than half a time.
    pub(crate) fn is_near(&self, [y, z]: [f64; 2]) -> bool {
        let [min, max] = self.bounds;
        min.y <= y && y <= max.y && min.z <= z && z <= max.z
    }

    /// Whether it shares a place with a box.
    pub(crate) fn meets(&self, [min, max]: [DVec3; 2]) -> bool {
        self.bounds[0].cmple(max).all() && min.cmple(self.bounds[1]).all()
    }

    /// Looks at rows through (y, z) that will be asked for again.
    pub(crate) fn remember(&mut self, rows: &[[f64; 2]]) {
        let found: Vec<OpenRow> = rows.par_iter().map(|&row| self.look(row)).collect();
        self.known.extend(rows.iter().map(|row| row.map(f64::to_bits)).zip(found));
    }

    /// Forgets those rows.
    pub(crate) fn forget(&mut self) {
        self.known = HashMap::new();
    }

    /// The row through (y, z) along x.
    pub(crate) fn row(&self, row: [f64; 2]) -> OpenRow {
        let known = if self.known.is_empty() { None } else { self.known.get(&row.map(f64::to_bits)) };
        known.cloned().unwrap_or_else(|| self.look(row))
    }

    fn look(&self, row: [f64; 2]) -> OpenRow {
        let crossings = crossings(&self.points, &self.capped, &self.capped_index, row);
        let mut found = OpenRow { inside: Vec::new(), doubtful: 0.0, crossings, looks: 0 };
        let [from, to] = self.bounds.map(|corner| corner.x);
        let mut ends = vec![(from, 0)];
        ends.extend(found.crossings.iter().map(|&(x, step)| (x.clamp(from, to), step)));
        ends.push((to, 0));
        let mut depth = 0;
        for pair in ends.windows(2) {
            depth += pair[0].1;
            if pair[0].0 < pair[1].0 {
                self.stretch(&mut found, [pair[0].0, pair[1].0], row, depth);
            }
        }
        found
    }

    /// A stretch that crosses nothing and around which the surface with its caps turns `depth` times.
    fn stretch(&self, found: &mut OpenRow, [from, to]: [f64; 2], [y, z]: [f64; 2], depth: i32) {
        if self.holes_take([from, to], [y, z]) < DOUBT {
            if depth > 0 {
                found.fill([from, to]);
            }
            return;
        }
        // What the caps turn around a point is missing from what the surface does.
        let holes = &self.caps_turn;
        let at = |x: f64| f64::from(depth) - holes.at(DVec3::new(x, y, z)) - 0.5;
        let about = |x: f64| f64::from(depth) - holes.about(DVec3::new(x, y, z)) - 0.5;
        let count = 3.0_f64.max(((to - from) / self.step).ceil());
        let length = (to - from) / count;
        let mut before: Option<Look> = None;
        let mut begin = None;
        for k in 0..count as usize {
            let x = from + length * (k as f64 + 0.5);
            let look = if count > 3.0 && self.holes_take([x - 0.5 * length, x + 0.5 * length], [y, z]) < DOUBT {
                Look { x, value: f64::from(depth) - 0.5, is_rough: false }
            } else {
                found.looks += 1;
                let value = about(x);
                if value.abs() > ROUGH && (value.abs() - DOUBT).abs() > ROUGH {
                    Look { x, value, is_rough: true }
                } else {
                    Look { x, value: at(x), is_rough: false }
                }
            };
            found.doubtful += if look.value.abs() < DOUBT { length } else { 0.0 };
            match before {
                None => begin = (look.value > 0.0).then_some(from),
                Some(last) if (last.value > 0.0) == (look.value > 0.0) => {}
                Some(before) => {
                    let place = passes(&at, before.exact(&at), look.exact(&at), NEAR * self.step);
                    match begin.take() {
                        Some(start) => found.fill([start, place]),
                        None => begin = Some(place),
                    }
                }
            }
            before = Some(look);
        }
        if let Some(start) = begin {
            found.fill([start, to]);
        }
    }

    /// By how much the winding number on a stretch may differ from a whole one, at most: the share of the sky that the
    /// caps fill if they all face the row, at their nearest.
    fn holes_take(&self, [from, to]: [f64; 2], [y, z]: [f64; 2]) -> f64 {
        let (mut sum, mut index) = (0.0, 0);
        while let Some(node) = self.caps_bvh.nodes().get(index) {
            let away = |least: f64, greatest: f64, [from, to]: [f64; 2]| (least - to).max(from - greatest).max(0.0);
            let distance = DVec3::new(
                away(node.min.x, node.max.x, [from, to]),
                away(node.min.y, node.max.y, [y, y]),
                away(node.min.z, node.max.z, [z, z]),
            );
            let share = self.cap_areas[index] / (4.0 * PI * distance.length_squared());
            index = if share < COARSE {
                sum += share;
                node.next()
            } else {
                if node.is_leaf() {
                    sum += share.min(TOUCHING * node.range().len() as f64);
                }
                index + 1
            };
            if sum >= DOUBT {
                break;
            }
        }
        sum
    }
}

impl OpenRow {
    /// Adds a stretch behind the others, or to the last where they touch: no place is inside twice.
    fn fill(&mut self, [from, to]: [f64; 2]) {
        match self.inside.last_mut() {
            Some(last) if last[1] >= from => last[1] = to,
            _ => self.inside.push([from, to]),
        }
    }
}

/// Where a value passes zero between two places with different signs, by the false position with the Illinois rule.
fn passes(at: &impl Fn(f64) -> f64, (mut a, mut fa): (f64, f64), (mut b, mut fb): (f64, f64), near: f64) -> f64 {
    for _ in 0..TRIES {
        if (b - a).abs() < near {
            break;
        }
        let x = (a - fa * (b - a) / (fb - fa)).clamp(a.min(b), a.max(b));
        let value = at(x);
        if value == 0.0 {
            return x;
        }
        if (value > 0.0) == (fb > 0.0) {
            fa *= 0.5;
        } else {
            (a, fa) = (b, fb);
        }
        let close = (x - b).abs() < near;
        (b, fb) = (x, value);
        if close {
            break;
        }
    }
    b
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::model::Model;
    use crate::geometry::octahedron::sphere;
    use crate::geometry::weld::Welded;

    fn with_holes() -> (Vec<DVec3>, Vec<[u32; 3]>) {
        let mesh = sphere(3);
        // Two holes that touch in a point, and one apart.
        let far = |t: &&[u32; 3]| {
            let middle = t.iter().map(|&i| mesh.positions[i as usize]).sum::<DVec3>() / 3.0;
            middle.distance(DVec3::Y) > 0.4 && !t.contains(&1)
        };
        let triangles = mesh.triangles.iter().filter(far).copied().collect();
        let welded = Welded::new(&Model { positions: mesh.positions.clone(), triangles, ..Model::default() });
        (welded.points, welded.faces)
    }

    #[test]
    fn a_row_runs_inside_where_the_winding_number_is_above_one_half() {
        let (points, faces) = with_holes();
        let surface = OpenSurface::new(&points, &faces);
        let bvh = Bvh::new(&points, &faces);
        let winding = Winding::new(&points, &faces, &bvh);
        for k in 0..400_u32 {
            let (y, z) = (1.1 * f64::from(k % 20) / 10.0 - 1.07, 1.1 * f64::from(k / 20) / 10.0 - 1.03);
            let row = surface.row([y, z]).inside;
            for x in (0..50).map(|k| 0.0437 * f64::from(k) - 1.1) {
                let value = winding.at(DVec3::new(x, y, z));
                let inside = row.iter().any(|[from, to]| (*from..=*to).contains(&x));
                assert!((value - 0.5).abs() < 0.02 || inside == (value > 0.5), "{x} {y} {z}: {value} {inside}");
            }
        }
    }
}
