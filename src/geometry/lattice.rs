//! Filling a shape with points on a cubic lattice.

use super::cell_map::CellMap;
use super::whole_layers::{price, stretch_to, whole_changes};
use glam::{DMat3, DVec3, IVec3};
use std::array::from_fn;
use std::borrow::Cow;

/// The corners of a cell.
pub(crate) const CORNERS: [IVec3; 8] = [
    IVec3::new(0, 0, 0),
    IVec3::new(1, 0, 0),
    IVec3::new(0, 1, 0),
    IVec3::new(1, 1, 0),
    IVec3::new(0, 0, 1),
    IVec3::new(1, 0, 1),
    IVec3::new(0, 1, 1),
    IVec3::new(1, 1, 1),
];

/// Points of a cubic lattice inside a shape, ordered by z, then y, then x of the lattice (rows along x are contiguous).
#[derive(Clone, Debug, PartialEq)]
pub struct LatticeSample {
    /// Lattice spacing D [m].
    pub spacing: f64,
    /// Unit axes of the lattice, as columns.
    pub axes: DMat3,
    /// By how much it is stretched along each of them, so that its layers fit the shape.
    pub stretch: DVec3,
    /// Positions [m].
    pub points: Vec<DVec3>,
    /// Lattice index of every point: `points[i] = origin + spacing * axes * (stretch * cells[i])`.
    pub cells: Vec<IVec3>,
}

/// A box along the coordinate axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cuboid {
    /// Centre [m].
    pub center: DVec3,
    /// Full extents [m].
    pub size: DVec3,
}

impl Cuboid {
    /// Whether `point` lies inside or on the surface.
    pub fn contains(&self, point: DVec3) -> bool {
        (point - self.center).abs().cmple(0.5 * self.size).all()
    }

    /// Volume [m³].
    pub fn volume(&self) -> f64 {
        self.size.x * self.size.y * self.size.z
    }
}

/// Points after which a long piece of work asks once more whether it is still wanted.
pub(crate) const ASK_EVERY: usize = 1 << 13;

/// Lattice positions tried along each axis when a shape lies askew to the lattice.
const OFFSETS_PER_AXIS: u32 = 4;

/// Fills a box with points of a lattice with unit `axes` at `spacing` [m].
///
/// Along the lattice the box is filled exactly by whole layers: the spacing changes to where its thinnest side is a
/// whole number of them, and the lattice is stretched along the others. A box askew to the lattice gets the points
/// inside it, for that position of the lattice at which the sampled volume comes closest to the box's.
pub fn fill_box(shape: &Cuboid, spacing: f64, axes: DMat3) -> LatticeSample {
    fill_box_unless(shape, spacing, axes, &mut || false).unwrap_or_else(|| empty(spacing, axes))
}

/// [`fill_box`]; none where `stop`, asked before every position of the lattice that is tried, says that it is no longer
/// wanted.
pub(crate) fn fill_box_unless(
    shape: &Cuboid,
    spacing: f64,
    axes: DMat3,
    stop: &mut dyn FnMut() -> bool,
) -> Option<LatticeSample> {
    if axes == DMat3::IDENTITY { Some(fill_aligned(shape, spacing)) } else { fill_askew(shape, spacing, axes, stop) }
}

fn empty(spacing: f64, axes: DMat3) -> LatticeSample {
    LatticeSample { spacing, axes, stretch: DVec3::ONE, points: Vec::new(), cells: Vec::new() }
}

/// Lattice points that filling a box looks at: as many as it gets along the lattice, those of its bounds askew to it.
/// A float, since it may be more than any integer holds.
pub(crate) fn points_looked_at(size: DVec3, spacing: f64, axes: DMat3) -> f64 {
    let along = if axes == DMat3::IDENTITY {
        (size / spacing).round().max(DVec3::ONE)
    } else {
        2.0 * (0.5 * (axes.transpose().abs() * size) / spacing).ceil() + 3.0
    };
    along.element_product()
}

fn fill_aligned(shape: &Cuboid, spacing: f64) -> LatticeSample {
    let size = shape.size.to_array();
    let changes = size.into_iter().flat_map(|length| whole_changes(length, spacing));
    let mut best: Option<(f64, f64, IVec3, DVec3)> = None;
    for change in [1.0].into_iter().chain(changes) {
        let spacing = change * spacing;
        let layers = (shape.size / spacing).round().max(DVec3::ONE);
        let stretch = DVec3::from_array(from_fn(|k| stretch_to(size[k], layers[k], spacing)));
        let price = price(change, stretch);
        if best.is_none_or(|(least, ..)| price < least - 1e-12) {
            best = Some((price, spacing, layers.as_ivec3(), stretch));
        }
    }
    let Some((_, spacing, layers, stretch)) = best else { return empty(spacing, DMat3::IDENTITY) };
    let origin = shape.center - 0.5 * spacing * (stretch * (layers - IVec3::ONE).as_dvec3());
    let lattice = LatticeSample { stretch, ..empty(spacing, DMat3::IDENTITY) };
    lattice.collect([IVec3::ZERO, layers - IVec3::ONE], origin, |_| true)
}

fn fill_askew(shape: &Cuboid, spacing: f64, axes: DMat3, stop: &mut dyn FnMut() -> bool) -> Option<LatticeSample> {
    // Half extents of the box as the lattice sees it.
    let half = 0.5 * (axes.transpose().abs() * shape.size);
    let reach = (half / spacing).ceil().as_ivec3() + IVec3::ONE;
    let mut best = (f64::INFINITY, empty(spacing, axes));
    for k in 0..OFFSETS_PER_AXIS.pow(3) {
        if stop() {
            return None;
        }
        let n = OFFSETS_PER_AXIS;
        let shift = DVec3::new(f64::from(k % n), f64::from(k / n % n), f64::from(k / (n * n))) / f64::from(n);
        let origin = shape.center + axes * (spacing * shift);
        let sample = empty(spacing, axes).collect([-reach, reach], origin, |point| shape.contains(point));
        let error = (sample.points.len() as f64 * spacing.powi(3) - shape.volume()).abs();
        if error < best.0 {
            best = (error, sample);
        }
    }
    Some(best.1)
}

impl LatticeSample {
    /// Volume of a cell [m³].
    pub fn cell_volume(&self) -> f64 {
        self.spacing.powi(3) * self.stretch.element_product()
    }

    /// By how much it is stretched along the directions in which it is long, more by the longer ones.
    pub(crate) fn stretch_along(&self) -> f64 {
        if self.stretch == DVec3::ONE {
            return 1.0;
        }
        let [least, most] =
            [IVec3::min, IVec3::max].map(|of| self.cells.iter().copied().reduce(of).unwrap_or_default());
        let squares = (self.stretch * (most - least).as_dvec3()).powf(2.0);
        (squares.dot(self.stretch.powf(2.0)) / squares.element_sum()).sqrt()
    }

    /// The points as they would lie if the lattice were not stretched [m].
    pub(crate) fn unstretched(&self) -> Cow<'_, [DVec3]> {
        if self.stretch == DVec3::ONE {
            return Cow::Borrowed(&self.points);
        }
        let shrunk = |x: &DVec3| self.axes * (self.axes.transpose() * *x / self.stretch);
        Cow::Owned(self.points.iter().map(shrunk).collect())
    }

    /// Adds the lattice points between two corners that lie inside.
    fn collect(mut self, [first, last]: [IVec3; 2], origin: DVec3, mut inside: impl FnMut(DVec3) -> bool) -> Self {
        for z in first.z..=last.z {
            for y in first.y..=last.y {
                for x in first.x..=last.x {
                    let cell = IVec3::new(x, y, z);
                    let point = origin + self.axes * (self.spacing * (self.stretch * cell.as_dvec3()));
                    if inside(point) {
                        self.points.push(point);
                        self.cells.push(cell);
                    }
                }
            }
        }
        self
    }

    /// Pieces that are not connected through faces, edges or corners of the lattice: the piece number of every point,
    /// and how many pieces there are.
    pub fn pieces(&self) -> (Vec<usize>, usize) {
        self.pieces_unless(&mut || false).unwrap_or_default()
    }

    /// [`Self::pieces`]; none where `stop`, asked again and again, says that they are no longer wanted.
    pub(crate) fn pieces_unless(&self, stop: &mut dyn FnMut() -> bool) -> Option<(Vec<usize>, usize)> {
        let index: CellMap<usize> = self.cells.iter().enumerate().map(|(i, &cell)| (cell, i)).collect();
        let mut seen = 0_usize;
        let mut piece = vec![usize::MAX; self.cells.len()];
        let mut count = 0;
        let mut open = Vec::new();
        for seed in 0..self.cells.len() {
            if piece[seed] != usize::MAX {
                continue;
            }
            piece[seed] = count;
            open.push(seed);
            while let Some(i) = open.pop() {
                seen += 1;
                if seen.is_multiple_of(ASK_EVERY) && stop() {
                    return None;
                }
                for k in 0..27 {
                    let step = IVec3::new(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1);
                    if let Some(&j) = index.get(&(self.cells[i] + step))
                        && piece[j] == usize::MAX
                    {
                        piece[j] = count;
                        open.push(j);
                    }
                }
            }
            count += 1;
        }
        Some((piece, count))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn boxed(size: DVec3) -> Cuboid {
        Cuboid { center: DVec3::new(0.1, 0.2, 0.3), size }
    }

    #[test]
    fn a_box_of_whole_spacings_is_filled_exactly() {
        let sample = fill_box(&boxed(DVec3::new(0.042, 0.072, 0.042)), 0.006, DMat3::IDENTITY);
        assert_eq!(sample.points.len(), 588);
        let mean = sample.points.iter().sum::<DVec3>() / 588.0;
        assert!(mean.distance(DVec3::new(0.1, 0.2, 0.3)) < 1e-12);
        assert_eq!(sample.pieces().1, 1);
    }

    #[test]
    fn a_box_of_any_size_is_filled_exactly() {
        for layers in [2.6, 3.25, 3.5, 4.75] {
            let shape = boxed(DVec3::new(0.006 * layers, 0.006 * layers, 0.08));
            let sample = fill_box(&shape, 0.006, DMat3::IDENTITY);
            let volume = sample.points.len() as f64 * sample.cell_volume();
            assert!((volume / shape.volume() - 1.0).abs() < 1e-12, "{layers}: {volume}");
            assert!((sample.stretch - DVec3::ONE).abs().max_element() < 0.04, "{layers}: {}", sample.stretch);
            assert!((sample.spacing / 0.006 - 1.0).abs() < 0.2, "{layers}: {}", sample.spacing);
            let half = sample.points.iter().map(|x| x.x - 0.1).fold(0.0, f64::max);
            let half = half + 0.5 * sample.spacing * sample.stretch.x;
            assert!((half - 0.003 * layers).abs() < 1e-12, "{layers}: {half}");
        }
    }

    #[test]
    fn a_turned_lattice_keeps_the_volume() {
        for degrees in [10.0_f64, 30.0, 45.0] {
            let shape = boxed(DVec3::new(0.03, 0.12, 0.03));
            let axes = DMat3::from_rotation_z(degrees.to_radians());
            let sample = fill_box(&shape, 0.006, axes);
            let volume = sample.points.len() as f64 * 0.006_f64.powi(3);
            assert!((volume / shape.volume() - 1.0).abs() < 0.02, "{degrees}: {volume}");
            assert!(sample.points.iter().all(|&point| shape.contains(point)));
            let step = sample.points[1] - sample.points[0];
            let cells = (sample.cells[1] - sample.cells[0]).as_dvec3();
            assert!(step.distance(axes * (0.006 * cells)) < 1e-15);
        }
    }

    #[test]
    fn separate_pieces_are_counted() {
        let mut sample = fill_box(&boxed(DVec3::splat(0.018)), 0.006, DMat3::IDENTITY);
        let keep: Vec<usize> = (0..27).filter(|&i| sample.cells[i].x != 1).collect();
        sample.points = keep.iter().map(|&i| sample.points[i]).collect();
        sample.cells = keep.iter().map(|&i| sample.cells[i]).collect();
        assert_eq!(sample.pieces().1, 2);
    }
}
