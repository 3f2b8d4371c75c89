//! The vertices and triangles of a sheet, and what directions it has.

use crate::geometry::surface_grid::grid_triangles;
use crate::scene::{GrainAlong, Sheet, SheetSource};
use crate::sketch::SketchError;
use crate::solver::body::SurfacePoint;
use glam::DVec3;
use std::collections::BTreeMap;

/// A sheet at rest, model frame.
#[derive(Clone, Debug)]
pub(super) struct SheetShape {
    /// Vertices [m].
    pub(super) points: Vec<DVec3>,
    /// Three vertices a triangle.
    pub(super) triangles: Vec<[u32; 3]>,
    /// Column and row of every vertex of a grid; empty for a sheet of triangles.
    places: Vec<[u32; 2]>,
}

impl SheetShape {
    /// What a sheet comes out as in a body of this diagonal, filled with particles at this spacing [m].
    ///
    /// # Errors
    /// Strokes that sweep no surface.
    pub(super) fn of(sheet: &Sheet, diagonal: f64, spacing: f64) -> Result<Self, SketchError> {
        Ok(match &sheet.source {
            SheetSource::Strokes(strokes) => {
                let swept = strokes.swept(diagonal, spacing)?;
                Self::grid(swept.to_a_row, swept.vertices)
            }
            SheetSource::Grid(rows) => {
                let to_a_row = rows.first().map_or(0, Vec::len);
                Self::grid(to_a_row, rows.iter().flatten().map(|&at| DVec3::from_array(at)).collect())
            }
            SheetSource::Triangles(of) => Self {
                points: of.vertices.iter().map(|&at| DVec3::from_array(at)).collect(),
                triangles: of.triangles.clone(),
                places: Vec::new(),
            },
        })
    }

    fn grid(to_a_row: usize, points: Vec<DVec3>) -> Self {
        let triangles = grid_triangles(to_a_row, points.len() / to_a_row.max(1));
        let places = (0..points.len()).map(|k| [(k % to_a_row) as u32, (k / to_a_row) as u32]).collect();
        Self { points, triangles, places }
    }

    fn corners(&self, [a, b, c]: [u32; 3]) -> [DVec3; 3] {
        [a, b, c].map(|k| self.points[k as usize])
    }

    /// Areas of the triangles [m²].
    pub(super) fn areas(&self) -> impl Iterator<Item = f64> + '_ {
        self.triangles.iter().map(|&of| {
            let [a, b, c] = self.corners(of);
            0.5 * (b - a).cross(c - a).length()
        })
    }

    /// Which vertices of a grid lie between others of their row, or of their column, that are `there`; none of others.
    pub(super) fn between(&self, there: &[bool]) -> Vec<bool> {
        // First and last of what is there, by the number of the column and of the row.
        let mut spans: [BTreeMap<u32, [u32; 2]>; 2] = Default::default();
        for (place, _) in self.places.iter().zip(there).filter(|(_, there)| **there) {
            for way in [0, 1] {
                let [first, last] = spans[way].entry(place[way]).or_insert([place[1 - way]; 2]);
                (*first, *last) = ((*first).min(place[1 - way]), (*last).max(place[1 - way]));
            }
        }
        let within = |place: &[u32; 2], way: usize| {
            let span = spans[way].get(&place[way]);
            span.is_some_and(|[first, last]| *first < place[1 - way] && place[1 - way] < *last)
        };
        let mut between = vec![false; self.points.len()];
        between.iter_mut().zip(&self.places).for_each(|(is, place)| *is = within(place, 0) || within(place, 1));
        between
    }

    /// The same with these triangles only, in this order, and the vertices that they need.
    pub(super) fn with_triangles(&self, kept: &[usize]) -> Self {
        let mut number = vec![u32::MAX; self.points.len()];
        let (mut points, mut places) = (Vec::new(), Vec::new());
        let mut used: Vec<u32> = kept.iter().flat_map(|&k| self.triangles[k]).collect();
        used.sort_unstable();
        used.dedup();
        for k in used {
            number[k as usize] = points.len() as u32;
            points.push(self.points[k as usize]);
            places.extend(self.places.get(k as usize));
        }
        let triangles = kept.iter().map(|&k| self.triangles[k].map(|corner| number[corner as usize])).collect();
        Self { points, triangles, places }
    }

    fn edges(&self, count: usize) -> impl Iterator<Item = f64> + '_ {
        self.triangles[..count].iter().flat_map(|&of| {
            let [a, b, c] = self.corners(of);
            [a.distance(b), b.distance(c), c.distance(a)]
        })
    }

    /// The shortest edge [m] of the first triangles.
    pub(super) fn shortest_edge(&self, count: usize) -> f64 {
        self.edges(count).fold(f64::INFINITY, f64::min)
    }

    /// The longest one [m].
    pub(super) fn longest_edge(&self, count: usize) -> f64 {
        self.edges(count).fold(0.0, f64::max)
    }

    /// Whether the edge between two vertices is the diagonal of a cell of a grid.
    pub(super) fn is_diagonal(&self, a: u32, b: u32) -> bool {
        let place = |k: u32| self.places.get(k as usize);
        place(a).zip(place(b)).is_some_and(|(a, b)| a[0] != b[0] && a[1] != b[1])
    }

    /// The edge of a triangle of a grid along its row, or across; its first one of others.
    fn edge(&self, [a, b, c]: [u32; 3], across: bool) -> DVec3 {
        let way = usize::from(!across);
        let edges = [[a, b], [b, c], [c, a]];
        let place = |k: u32| self.places.get(k as usize).map(|place| place[way]);
        let along = edges.into_iter().find(|[from, to]| place(*from) == place(*to)).unwrap_or([a, b]);
        self.points[along[1] as usize] - self.points[along[0] as usize]
    }

    fn way(&self, triangle: [u32; 3], along: &GrainAlong) -> DVec3 {
        match along {
            GrainAlong::First => self.edge(triangle, false),
            GrainAlong::Second => self.edge(triangle, true),
            GrainAlong::Direction(axis) => DVec3::from_array(*axis),
        }
    }

    /// The first direction of a triangle and that of its grain. The directions of a sheet of triangles are its grain's.
    pub(super) fn ways(&self, triangle: usize, grain: &GrainAlong) -> [DVec3; 2] {
        let triangle = self.triangles[triangle];
        let grain = self.way(triangle, grain);
        // What has no part in the triangle is no direction of it.
        let [a, b, c] = self.corners(triangle);
        let normal = (b - a).cross(c - a).normalize_or_zero();
        let lies = (grain - normal * normal.dot(grain)).length() > 1e-6 * grain.length();
        let first = if self.places.is_empty() && lies { grain } else { self.edge(triangle, false) };
        [first, grain]
    }

    /// Lines along the grain, to be drawn.
    pub(super) fn threads(&self, along: &GrainAlong) -> Vec<Vec<SurfacePoint>> {
        let way = match along {
            GrainAlong::Direction(_) => return self.triangles.iter().filter_map(|&of| self.hatch(of, along)).collect(),
            GrainAlong::First => 1,
            GrainAlong::Second => 0,
        };
        // Runs of neighbours in a row or column, as far as triangles hold them together.
        let mut edges: Vec<[u32; 2]> = Vec::new();
        for &[a, b, c] in &self.triangles {
            for [from, to] in [[a, b], [b, c], [c, a]] {
                let [one, other] = [from, to].map(|k| self.places[k as usize]);
                if one[way] == other[way] {
                    edges.push(if one[1 - way] < other[1 - way] { [from, to] } else { [to, from] });
                }
            }
        }
        let key = |edge: &[u32; 2]| {
            let place = self.places[edge[0] as usize];
            [place[way], place[1 - way]]
        };
        edges.sort_unstable_by_key(key);
        edges.dedup();
        let mut lines: Vec<Vec<SurfacePoint>> = Vec::new();
        for [from, to] in edges {
            match lines.last_mut() {
                Some(line) if line.last() == Some(&SurfacePoint::vertex(from)) => line.push(SurfacePoint::vertex(to)),
                _ => lines.push(vec![SurfacePoint::vertex(from), SurfacePoint::vertex(to)]),
            }
        }
        lines
    }

    /// A line through the middle of a triangle along a direction, from edge to edge.
    fn hatch(&self, triangle: [u32; 3], along: &GrainAlong) -> Option<Vec<SurfacePoint>> {
        let [a, b, c] = self.corners(triangle);
        let normal = (b - a).cross(c - a).try_normalize()?;
        let across = normal.cross(self.way(triangle, along)).try_normalize()?;
        let middle = (a + b + c) / 3.0;
        let side = |k: u32| (self.points[k as usize] - middle).dot(across);
        let [a, b, c] = triangle;
        let crossed = [[a, b], [b, c], [c, a]].into_iter().filter_map(|[from, to]| {
            let (before, after) = (side(from), side(to));
            (before * after < 0.0).then(|| SurfacePoint { ends: [from, to], share: before / (before - after) })
        });
        let line: Vec<SurfacePoint> = crossed.collect();
        (line.len() == 2).then_some(line)
    }

    /// Lines along the edges that belong to one triangle only.
    pub(super) fn rim(&self) -> Vec<Vec<u32>> {
        let mut met: BTreeMap<[u32; 2], (u32, [u32; 2])> = BTreeMap::new();
        for &[a, b, c] in &self.triangles {
            for [from, to] in [[a, b], [b, c], [c, a]] {
                met.entry([from.min(to), from.max(to)]).or_insert((0, [from, to])).0 += 1;
            }
        }
        let mut left: Vec<[u32; 2]> =
            met.into_values().filter(|(count, _)| *count == 1).map(|(_, edge)| edge).collect();
        let mut lines = Vec::new();
        while let Some([from, to]) = left.pop() {
            let mut line = vec![from, to];
            // Edges turn as their triangles do: where one ends the next begins.
            while let Some(next) = left.iter().position(|edge| line.last() == Some(&edge[0])) {
                line.push(left.swap_remove(next)[1]);
            }
            lines.push(line);
        }
        lines
    }
}
