//! The one test of what is inside: volume, mass and particles all follow from it.
//!
//! Inside is what lies in any closed piece of the surface, cavities taken away, or where the pieces with holes turn
//! around a point more than half a time. It is asked for row by row.

use super::holes::OpenSurface;
use super::progress::GoOn;
use super::row_index::RowIndex;
use super::scanline::{crossings, crossings_within, inside_stretches, joined};
use glam::DVec3;
use rayon::prelude::*;
use std::ops::ControlFlow;

/// What is inside of a surface.
#[derive(Clone, Debug, Default)]
pub(crate) struct Inside {
    faces: Vec<[u32; 3]>,
    index: RowIndex,
    open: Vec<OpenSurface>,
}

/// A row, and how often which of its places are inside.
#[derive(Clone, Debug, Default)]
struct CountedRow {
    /// Length inside [m].
    inside: f64,
    /// Length by which the surface with its caps turns around the row, counted as often as it does [m].
    turned: f64,
    /// Length where inside and outside are not clearly told apart [m].
    doubtful: f64,
    /// Whether any of it lies inside more than one piece, or in a cavity of none.
    overlaps: bool,
    /// Winding numbers that were looked at.
    looks: u32,
}

/// What was measured along rows.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Measured {
    /// Volume that the surface with its caps encloses, counted as often as it turns around it, less the volume inside
    /// [m³].
    pub shared: f64,
    /// Volume where inside and outside are not clearly told apart [m³].
    pub doubtful: f64,
    /// Winding numbers that were looked at for a row, on average.
    pub looks_a_row: f64,
}

/// Rows after which it is asked whether to go on.
const AT_ONCE: usize = 512;

impl Inside {
    /// Sorts oriented faces: those of all closed pieces, each with the span of its piece along x [m], and those with
    /// holes, a surface for each group of pieces.
    pub(crate) fn new(
        points: &[DVec3],
        (closed, spans): (Vec<[u32; 3]>, Vec<[f64; 2]>),
        open: Vec<OpenSurface>,
    ) -> Self {
        let index = RowIndex::of_spans(points, &closed, spans);
        Self { faces: closed, index, open }
    }

    /// Stretches of the row through (y, z) along x that lie inside [m], in order; the points are those of the surface.
    pub(crate) fn row(&self, points: &[DVec3], y: f64, z: f64) -> Vec<[f64; 2]> {
        let closed = inside_stretches(&crossings(points, &self.faces, &self.index, [y, z]));
        let open = self.open.iter().filter(|open| open.is_near([y, z]));
        open.fold(closed, |all, open| joined(all, open.row([y, z]).inside))
    }

    /// [`Self::row`] as far as it is asked for from one place along x to another [m]: outside of that it may lack
    /// pieces that lie there. Of many pieces in a row only those are looked at that reach into it.
    pub(crate) fn row_within(&self, points: &[DVec3], row: [f64; 2], part: [f64; 2]) -> Vec<[f64; 2]> {
        let closed = inside_stretches(&crossings_within(points, &self.faces, &self.index, row, part));
        let open = self.open.iter().filter(|open| open.is_near(row));
        open.fold(closed, |all, open| joined(all, open.row(row).inside))
    }

    /// How often the closed pieces turn around a point.
    pub(crate) fn turns_around(&self, points: &[DVec3], point: DVec3) -> i32 {
        let crossings = crossings_within(points, &self.faces, &self.index, [point.y, point.z], [point.x; 2]);
        crossings.iter().take_while(|(x, _)| *x < point.x).map(|(_, step)| step).sum()
    }

    /// Faces of closed pieces that a row looks at, on average.
    pub(crate) fn faces_a_row(&self) -> f64 {
        self.index.faces_a_row()
    }

    /// Signed volume of the surfaces with holes within a box that holds whole ones, their holes closed by caps [m³].
    pub(crate) fn capped_volume(&self, bounds: [DVec3; 2]) -> f64 {
        let open = self.open.iter().filter(|open| open.meets(bounds));
        open.map(|open| open.capped_volume(bounds[0])).sum()
    }

    /// Looks at rows through the surfaces with holes that [`Self::measure`] is going to ask for several times over.
    pub(crate) fn remember(&mut self, bounds: [DVec3; 2], rows: usize, go_on: &mut GoOn<'_>) -> ControlFlow<()> {
        let rows: Vec<[f64; 2]> = (0..rows).map(|k| row_at(k, bounds)).collect();
        for rows in rows.chunks(AT_ONCE) {
            go_on()?;
            self.open.iter_mut().for_each(|open| open.remember(rows));
        }
        ControlFlow::Continue(())
    }

    /// Forgets those rows.
    pub(crate) fn forget(&mut self) {
        self.open.iter_mut().for_each(OpenSurface::forget);
    }

    /// The surfaces with holes.
    pub(crate) fn into_open(self) -> Vec<OpenSurface> {
        self.open
    }

    /// What pieces share, so that it counts once, and what is doubtful, within a box that holds whole pieces: summed
    /// over so many rows, spread evenly.
    pub(crate) fn measure(
        &self,
        points: &[DVec3],
        [min, max]: [DVec3; 2],
        rows: usize,
        go_on: &mut GoOn<'_>,
    ) -> ControlFlow<(), Measured> {
        let sums = self.count(points, [min, max], rows, go_on)?;
        let differs = sums.overlaps || !self.open.is_empty();
        // Without any overlap the two differ by round-off only.
        let shared = if differs { sums.turned - sums.inside } else { 0.0 };
        let looks_a_row = f64::from(sums.looks) / rows.max(1) as f64;
        ControlFlow::Continue(Measured { shared, doubtful: sums.doubtful, looks_a_row })
    }

    /// Sums over rows that are spread evenly over a box.
    fn count(
        &self,
        points: &[DVec3],
        [min, max]: [DVec3; 2],
        rows: usize,
        go_on: &mut GoOn<'_>,
    ) -> ControlFlow<(), CountedRow> {
        let mut found: Vec<CountedRow> = Vec::with_capacity(rows);
        for first in (0..rows).step_by(AT_ONCE) {
            go_on()?;
            let these = (first..rows.min(first + AT_ONCE)).into_par_iter();
            found.par_extend(these.map(|k| self.counted(points, row_at(k, [min, max]), [min, max])));
        }
        let area = (max.y - min.y) * (max.z - min.z) / rows as f64;
        let sums = found.iter().fold(CountedRow::default(), |sum, row| CountedRow {
            inside: sum.inside + area * row.inside,
            turned: sum.turned + area * row.turned,
            doubtful: sum.doubtful + area * row.doubtful,
            overlaps: sum.overlaps || row.overlaps,
            looks: sum.looks + row.looks,
        });
        ControlFlow::Continue(sums)
    }

    fn counted(&self, points: &[DVec3], row: [f64; 2], [min, max]: [DVec3; 2]) -> CountedRow {
        let mut counted = CountedRow::default();
        let mut turn = |crossings: &[(f64, i32)]| {
            let mut depth = 0;
            for pair in crossings.windows(2) {
                depth += pair[0].1;
                let length = pair[1].0.min(max.x) - pair[0].0.max(min.x);
                if length > 0.0 {
                    counted.turned += f64::from(depth) * length;
                    counted.overlaps |= !(0..=1).contains(&depth);
                }
            }
        };
        let closed = crossings(points, &self.faces, &self.index, row);
        turn(&closed);
        let mut inside = inside_stretches(&closed);
        for open in self.open.iter().filter(|open| open.is_near(row) && open.meets([min, max])) {
            let row = open.row(row);
            turn(&row.crossings);
            counted.doubtful += row.doubtful;
            counted.looks += row.looks;
            inside = joined(inside, row.inside);
        }
        for [a, b] in inside {
            counted.inside += (b.min(max.x) - a.max(min.x)).max(0.0);
        }
        counted
    }
}

/// One of the rows that are spread evenly over a box.
fn row_at(k: usize, [min, max]: [DVec3; 2]) -> [f64; 2] {
    let share = spread(k);
    [min.y + (max.y - min.y) * share[0], min.z + (max.z - min.z) * share[1]]
}

/// The first of many places that fill a square ever more evenly, each less than one: none of them lie in line, so that
/// a plate along the axes is not missed or met by all (Roberts 2018, after the plastic number).
pub(crate) fn spread(k: usize) -> [f64; 2] {
    const PLASTIC: f64 = 1.324_717_957_244_746;
    [PLASTIC.recip(), PLASTIC.powi(2).recip()].map(|step| (0.5 + step * (k as f64 + 1.0)).fract())
}
