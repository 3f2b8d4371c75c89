//! Which faces a row along x may meet, found without a walk through a tree: faces as they are seen along x, sorted into
//! the cells of a grid.

use glam::{DVec2, DVec3};

/// Faces by where they are seen along x.
#[derive(Clone, Debug, Default)]
pub(crate) struct RowIndex {
    /// Least corner, seen along x [m].
    min: DVec2,
    /// Greatest corner, seen along x [m].
    max: DVec2,
    /// Cells to a metre.
    scale: DVec2,
    cells: [usize; 2],
    /// Faces of every cell, by where their spans begin: those of cell `c` are `starts[c]..starts[c + 1]`.
    starts: Vec<u32>,
    faces: Vec<u32>,
    /// Span along x of every face [m]; none where rows are only met as a whole.
    spans: Vec<[f64; 2]>,
    /// The longest span in every cell [m].
    longest: Vec<f64>,
    /// Least and greatest corner of every face [m]: what tells of most of them that a row passes them by.
    bounds: Vec<[DVec2; 2]>,
    /// Faces that lie in a cell with any, on average, those along the rows included.
    faces_a_row: f64,
}

/// Share of the extent by which faces are taken for wider: round-off in the test of a row against an edge is far less.
const WIDER: f64 = 1e-12;

/// Cells that the boxes around a face cover, at most on average: large faces lie in many cells.
const COVERED: f64 = 48.0;

/// Cells for each face, and along an axis at most.
const CELLS: f64 = 4.0;
const MOST_CELLS: f64 = 2048.0;

/// A face seen along x.
struct Seen {
    corners: [DVec2; 3],
    /// Least and greatest corner [m].
    min: DVec2,
    max: DVec2,
    /// One where its corners go round counter-clockwise, minus one otherwise; zero where it is seen from its edge.
    turn: f64,
}

impl Seen {
    fn new(points: &[DVec3], face: [u32; 3], wider: f64) -> Self {
        let corners = face.map(|i| DVec2::new(points[i as usize].y, points[i as usize].z));
        let [a, b, c] = corners;
        let area = (b - a).perp_dot(c - a);
        let is_flat = area.abs() <= WIDER * (b - a).length() * (c - a).length();
        let turn = if is_flat { 0.0 } else { area.signum() };
        Self { corners, min: a.min(b).min(c) - wider, max: a.max(b).max(c) + wider, turn }
    }

    /// Whether it lies in a plane along two axes of which one is that of the rows: the test of a row against its edges
    /// then never has it on one side of them all, and no row meets it.
    fn is_along_rows(&self) -> bool {
        let [a, b, c] = self.corners;
        (a.x == b.x && b.x == c.x) || (a.y == b.y && b.y == c.y)
    }

    /// Whether it lies beside a box with this middle and half these extents: on the outer side of one of its edges.
    fn is_beside(&self, middle: DVec2, half: DVec2) -> bool {
        (0..3).any(|k| {
            let [from, to] = [self.corners[k], self.corners[(k + 1) % 3]];
            let along = to - from;
            let reach = along.abs().perp_dot(DVec2::new(-half.x, half.y)).abs();
            self.turn * along.perp_dot(middle - from) < -reach
        })
    }
}

impl RowIndex {
    /// Sorts faces that are to be met by whole rows.
    pub(crate) fn new(points: &[DVec3], faces: &[[u32; 3]]) -> Self {
        Self::of_spans(points, faces, Vec::new())
    }

    /// Sorts faces each of which counts only where a row runs through its span along x [m]; all do where there are
    /// none.
    pub(crate) fn of_spans(points: &[DVec3], faces: &[[u32; 3]], spans: Vec<[f64; 2]>) -> Self {
        let corners = faces.iter().flatten().map(|&i| points[i as usize]);
        let (low, high) = corners.fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(a, b), p| (a.min(p), b.max(p)));
        if faces.is_empty() {
            return Self::default();
        }
        let size = high - low;
        let wider = WIDER * size.max_element();
        let mut this =
            Self { min: DVec2::new(low.y, low.z) - wider, max: DVec2::new(high.y, high.z) + wider, ..Self::default() };
        this.spans = spans;
        let seen: Vec<Seen> = faces.iter().map(|&face| Seen::new(points, face, wider)).collect();
        // Seen along a plane they all lie in, they have no area.
        let least = (size.y.max(size.z) / MOST_CELLS).max(f64::MIN_POSITIVE);
        let mut width = (size.y * size.z / (CELLS * faces.len() as f64)).sqrt().max(least);
        loop {
            this.divide(width);
            let covered: usize = seen.iter().map(|seen| this.covered(seen).count()).sum();
            if this.cells == [1, 1] || covered as f64 <= COVERED * faces.len() as f64 {
                break;
            }
            width *= 2.0;
        }
        this.sort(&seen);
        this
    }

    /// Cells of about this width [m].
    fn divide(&mut self, width: f64) {
        let extents = self.max - self.min;
        self.cells = extents.to_array().map(|extent| (extent / width).ceil().clamp(1.0, MOST_CELLS) as usize);
        let scale = |k: usize| if extents[k] > 0.0 { self.cells[k] as f64 / extents[k] } else { 0.0 };
        self.scale = DVec2::new(scale(0), scale(1));
    }

    fn sort(&mut self, seen: &[Seen]) {
        let width = self.scale.map(|scale| if scale > 0.0 { scale.recip() } else { 1.0 });
        // A little more than half a cell: round-off decides which one a row on the border looks into.
        let half = 0.500_1 * width;
        let mut entries: Vec<[u32; 2]> = Vec::with_capacity(2 * seen.len());
        let (mut lie_in, mut is_used) = (0_u32, vec![false; self.cells[0] * self.cells[1]]);
        let mut order: Vec<u32> = (0..seen.len() as u32).collect();
        if !self.spans.is_empty() {
            order.sort_by(|&a, &b| self.spans[a as usize][0].total_cmp(&self.spans[b as usize][0]));
        }
        for face in order {
            let seen = &seen[face as usize];
            for [y, z] in self.covered(seen) {
                let middle = self.min + width * DVec2::new(y as f64 + 0.5, z as f64 + 0.5);
                if seen.turn == 0.0 || !seen.is_beside(middle, half) {
                    let cell = z * self.cells[0] + y;
                    (lie_in, is_used[cell]) = (lie_in + 1, true);
                    if !seen.is_along_rows() {
                        entries.push([cell as u32, face]);
                    }
                }
            }
        }
        self.faces_a_row = f64::from(lie_in) / is_used.iter().filter(|&&used| used).count().max(1) as f64;
        let mut starts = vec![0; self.cells[0] * self.cells[1] + 1];
        for [cell, _] in &entries {
            starts[*cell as usize + 1] += 1;
        }
        for cell in 1..starts.len() {
            starts[cell] += starts[cell - 1];
        }
        let mut next = starts.clone();
        self.faces = vec![0; entries.len()];
        self.longest = vec![0.0; if self.spans.is_empty() { 0 } else { next.len() - 1 }];
        for [cell, face] in entries {
            self.faces[next[cell as usize] as usize] = face;
            next[cell as usize] += 1;
            if let Some([from, to]) = self.spans.get(face as usize) {
                let longest = &mut self.longest[cell as usize];
                *longest = longest.max(to - from);
            }
        }
        self.starts = starts;
        self.bounds = seen.iter().map(|seen| [seen.min, seen.max]).collect();
    }

    /// Faces that a row looks at, on average over the rows that look at any.
    pub(crate) fn faces_a_row(&self) -> f64 {
        self.faces_a_row
    }

    fn cell(&self, at: DVec2) -> [usize; 2] {
        // What lies outside counts to the first cell or the last.
        let cell = (at - self.min) * self.scale;
        [(cell.x as usize).min(self.cells[0] - 1), (cell.y as usize).min(self.cells[1] - 1)]
    }

    /// Cells that the box around a face covers.
    fn covered(&self, seen: &Seen) -> impl Iterator<Item = [usize; 2]> + use<> {
        let ([y, z], [to_y, to_z]) = (self.cell(seen.min), self.cell(seen.max));
        (z..=to_z).flat_map(move |z| (y..=to_y).map(move |y| [y, z]))
    }

    /// Calls `found` for every face that the row through (y, z) may meet, in order.
    pub(crate) fn visit(&self, row: [f64; 2], mut found: impl FnMut(u32)) {
        if let Some(cell) = self.cell_of(row) {
            self.faces_in(cell).iter().filter(|&&face| self.may_meet(face, row)).for_each(|&face| found(face));
        }
    }

    /// Calls `found` for every face that the row through (y, z) may meet and whose span meets a part of it along x [m].
    pub(crate) fn visit_within(&self, row: [f64; 2], [from, to]: [f64; 2], mut found: impl FnMut(u32)) {
        if self.spans.is_empty() {
            return self.visit(row, found);
        }
        let Some(cell) = self.cell_of(row) else { return };
        let (faces, span) = (self.faces_in(cell), |face: u32| self.spans[face as usize]);
        // What begins before this ends before the part does.
        let least = from - self.longest[cell] - WIDER * from.abs();
        let first = faces.partition_point(|&face| span(face)[0] < least);
        for &face in faces[first..].iter().take_while(|&&face| span(face)[0] <= to) {
            if span(face)[1] >= from && self.may_meet(face, row) {
                found(face);
            }
        }
    }

    fn may_meet(&self, face: u32, [y, z]: [f64; 2]) -> bool {
        let [min, max] = self.bounds[face as usize];
        min.x <= y && y <= max.x && min.y <= z && z <= max.y
    }

    /// The cell into which a row looks; none where it passes all faces.
    fn cell_of(&self, [y, z]: [f64; 2]) -> Option<usize> {
        let at = DVec2::new(y, z);
        if self.starts.is_empty() || at.cmplt(self.min).any() || at.cmpgt(self.max).any() {
            return None;
        }
        let [y, z] = self.cell(at);
        Some(z * self.cells[0] + y)
    }

    fn faces_in(&self, cell: usize) -> &[u32] {
        &self.faces[self.starts[cell] as usize..self.starts[cell + 1] as usize]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DMat3;

    #[test]
    fn flat_faces_are_found_but_for_those_along_rows() {
        let points = |by: DMat3| [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::ONE].map(|point| by * point).to_vec();
        let along = |by: DVec3| DMat3::from_diagonal(by);
        let aslant = DMat3::from_cols(DVec3::X, DVec3::new(0.0, 1.0, 1.0), DVec3::ZERO);
        let nothing = |by| (along(by), false);
        for (by, is_found) in
            [(aslant, true), nothing(DVec3::new(1.0, 1.0, 0.0)), nothing(DVec3::X), nothing(DVec3::ZERO)]
        {
            let index = RowIndex::new(&points(by), &[[0, 1, 2], [1, 2, 3]]);
            let mut found = Vec::new();
            index.visit([0.0, 0.0], |face| found.push(face));
            assert_eq!(found.contains(&0), is_found, "{by}: {found:?}");
            // They count for what a row costs all the same.
            assert!(index.faces_a_row() > 0.0, "{by}");
        }
    }

    #[test]
    fn no_face_that_a_row_meets_is_left_out() {
        // Long and short ones, some seen from their edges.
        let random = |k: u32, scale: f64| {
            let at = |step: f64| (f64::from(k + 1) * step).fract();
            scale * DVec3::new(at(0.618_033_988_7), at(0.754_877_666_2), at(0.569_840_290_9))
        };
        let mut points = Vec::new();
        for k in 0..300 {
            let corner = random(k, 1.0);
            let size = if k % 7 == 0 { 1.0 } else { 0.05 };
            let flat = if k % 5 == 0 { DVec3::new(1.0, 1.0, 0.0) } else { DVec3::ONE };
            points.extend([corner, corner + flat * random(k + 900, size), corner + flat * random(k + 5000, size)]);
        }
        let faces: Vec<[u32; 3]> = (0..300).map(|k| [3 * k, 3 * k + 1, 3 * k + 2]).collect();
        let index = RowIndex::new(&points, &faces);
        let spans: Vec<[f64; 2]> = faces
            .iter()
            .map(|face| face.map(|i| points[i as usize].x))
            .map(|[a, b, c]| [a.min(b).min(c), a.max(b).max(c)])
            .collect();
        let of_spans = RowIndex::of_spans(&points, &faces, spans.clone());
        let (mut met, mut parts) = (0, 0);
        for k in 0..2000 {
            let DVec3 { y, z, .. } = 1.2 * random(k, 1.0) - 0.1;
            let mut found = vec![false; faces.len()];
            index.visit([y, z], |face| found[face as usize] = true);
            // Of a part of the row those that reach into it, and no other.
            let (from, to) = (0.3 + 0.1 * y, 0.3 + 0.4 * z.abs());
            let mut within = vec![false; faces.len()];
            of_spans.visit_within([y, z], [from, to], |face| within[face as usize] = true);
            for ((found, within), [least, most]) in found.iter().zip(&within).zip(&spans) {
                assert_eq!(*within, *found && *least <= to && *most >= from, "{y} {z}");
                parts += usize::from(*within);
            }
            for (face, found) in faces.iter().zip(found) {
                let [a, b, c] = face.map(|i| DVec2::new(points[i as usize].y - y, points[i as usize].z - z));
                let sides = [a.perp_dot(b), b.perp_dot(c), c.perp_dot(a)];
                let meets = sides.iter().all(|&side| side > 0.0) || sides.iter().all(|&side| side < 0.0);
                assert!(found || !meets, "{y} {z}");
                met += usize::from(meets);
            }
        }
        assert!(met > 1000 && parts > 1000, "{met} {parts}");
    }
}
