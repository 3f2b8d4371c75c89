//! Where a lattice lies in a shape, and how it is stretched: so that flat faces along its axes fall between two layers,
//! and elsewhere so that the particles' volume and second moments come closest to the shape's.
//!
//! How a section bends hangs on its second moments, and a section three spacings wide holds 0.6 to 1.6 of them by where
//! the lattice falls.

use super::lattice::LatticeSample;
use super::moments::Moments;
use super::scanlines::Scanlines;
use super::whole_layers::{CHANGES, UNEVEN, price, stretch_to, whole_changes};
use glam::{DMat3, DVec3, IVec3};
use rayon::prelude::*;
use std::f64::consts::TAU;
use std::ops::ControlFlow;

/// A lattice along the axes of coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct FittedLattice {
    /// Spacing before it is stretched [m].
    pub(crate) spacing: f64,
    /// By how much it is stretched along each axis.
    pub(crate) stretch: DVec3,
    /// One of its points [m].
    pub(crate) origin: DVec3,
}

/// Changes of the spacing that are tried where not all faces are flat, in hundredths, and what a finer and a coarser
/// one cost: layers are few where it matters, and fewer of them bend and twist further from theory.
const FREE_CHANGES: [i32; 16] = [98, 102, 96, 104, 94, 106, 92, 108, 90, 110, 88, 112, 86, 84, 82, 80];
const FREE_FINER: f64 = 0.15;
const FREE_COARSER: f64 = 1.0;

/// Cosine from which a face is flat along an axis, and the share of all that is seen along it that has to be.
const FLAT: f64 = 1.0 - 1e-6;
const MOSTLY: f64 = 0.6;

/// How well the faces have to agree on where layers end: 1 where all do.
const AGREED: f64 = 0.98;

/// Quarters of the spacing by which a lattice is moved along axes without flat faces.
const SHIFTS: i32 = 4;

/// Cost of a lattice that does not lie symmetrically to the shape's extents, for each axis.
const ASYMMETRIC: f64 = 5e-4;

/// Own second moment of a particle about its centre, in squared spacings. That of a cube is 1/12; what a section of 3
/// to 6 layers bends too easily is made up for by asking for a little more.
pub(crate) const OWN_MOMENT: f64 = 0.05;

/// Particles up to which lattices are searched through: where there are more of them, each weighs little.
const SEARCHED: f64 = 60_000.0;

impl FittedLattice {
    /// Spacings along the axes [m].
    pub(crate) fn spacings(&self) -> DVec3 {
        self.spacing * self.stretch
    }

    /// Rows of a lattice through the box around a shape.
    pub(crate) fn rows_through(shape: &dyn Scanlines, spacing: f64) -> f64 {
        let [min, max] = shape.bounds();
        let rows = (max - min) / spacing + 2.0;
        rows.y * rows.z
    }

    /// Lattices that are tried to find the one that fits a shape best, at most, those that differ along x only counting
    /// as one.
    pub(crate) const TRIED: f64 = (1.0 + FREE_CHANGES.len() as f64) * (SHIFTS * SHIFTS) as f64;

    /// The lattice that fits a shape best; none where there are so many particles that none is looked for. `progress`
    /// is asked from time to time whether to go on.
    pub(crate) fn to(
        shape: &dyn Scanlines,
        spacing: f64,
        progress: &mut dyn FnMut() -> ControlFlow<()>,
    ) -> ControlFlow<(), Option<Self>> {
        let [min, max] = shape.bounds();
        let center = 0.5 * (min + max);
        if ((max - min) / spacing).element_product() > SEARCHED {
            return ControlFlow::Continue(None);
        }
        if let Some(lattice) = Self::between_faces(shape, spacing) {
            return ControlFlow::Continue(Some(lattice));
        }
        let planes: [Option<Planes>; 3] = std::array::from_fn(|axis| Planes::along(shape, axis, spacing));
        let target = Target::of(shape, center);
        let mut best: Option<(f64, Self)> = None;
        for change in changes(&planes, spacing) {
            progress()?;
            let spacing = change * spacing;
            let flats = planes.each_ref().map(|planes| planes.as_ref().and_then(|planes| planes.fitted(spacing)));
            let stretch = DVec3::from_array(flats.map(|flat| flat.map_or(1.0, |flat| flat.stretch)));
            let by = if change < 1.0 { FREE_FINER } else { FREE_COARSER };
            let price = by * change.ln().abs() + price(1.0, stretch);
            if best.is_some_and(|(least, _)| price > least) {
                continue;
            }
            let shifts = |axis: usize| if flats[axis].is_none() { SHIFTS } else { 1 };
            let place = |axis: usize, shift: i32| match flats[axis] {
                Some(flat) => flat.point,
                None => center[axis] + spacing * f64::from(shift) / f64::from(SHIFTS),
            };
            let across: Vec<(i32, i32)> = (0..shifts(2)).flat_map(|z| (0..shifts(1)).map(move |y| (y, z))).collect();
            let tried: Vec<Vec<(f64, Self)>> = across
                .par_iter()
                .map(|&(y, z)| {
                    let at = |x: i32| DVec3::new(place(0, x), place(1, y), place(2, z));
                    let lattices: Vec<Self> =
                        (0..shifts(0)).map(|x| Self { spacing, stretch, origin: at(x) }).collect();
                    let sums = whole_moments(shape, &lattices, center);
                    let askew = |shift: i32| ASYMMETRIC * f64::from(2 * shift % SHIFTS);
                    let each = (0..).zip(sums.iter().zip(&lattices));
                    each.map(|(x, (sums, lattice))| {
                        (target.error(sums) + price + askew(x) + askew(y) + askew(z), *lattice)
                    })
                    .collect()
                })
                .collect();
            for (cost, lattice) in tried.into_iter().flatten() {
                if best.is_none_or(|(least, _)| cost < least - 1e-9) {
                    best = Some((cost, lattice));
                }
            }
        }
        ControlFlow::Continue(best.map(|(_, lattice)| lattice))
    }

    /// The lattice that has a shape's faces between its layers where it is flat along all axes.
    pub(crate) fn between_faces(shape: &dyn Scanlines, spacing: f64) -> Option<Self> {
        let planes: [Option<Planes>; 3] = std::array::from_fn(|axis| Planes::along(shape, axis, spacing));
        if planes.iter().any(Option::is_none) {
            return None;
        }
        let mut best: Option<(f64, Self)> = None;
        for change in changes(&planes, spacing) {
            let spacing = change * spacing;
            let flats = planes.each_ref().map(|planes| planes.as_ref().and_then(|planes| planes.fitted(spacing)));
            let [Some(x), Some(y), Some(z)] = flats else { continue };
            let stretch = DVec3::new(x.stretch, y.stretch, z.stretch);
            let apart = change * stretch;
            if apart.min_element() < CHANGES[0] || apart.max_element() > CHANGES[1] {
                continue;
            }
            let lattice = Self { spacing, stretch, origin: DVec3::new(x.point, y.point, z.point) };
            let price = price(change, stretch);
            if best.is_none_or(|(least, _)| price < least - 1e-9) {
                best = Some((price, lattice));
            }
        }
        best.map(|(_, lattice)| lattice)
    }

    /// Its points inside a shape.
    pub(crate) fn collect(&self, shape: &dyn Scanlines) -> LatticeSample {
        let Self { spacing, stretch, origin } = *self;
        let mut cells = Vec::new();
        for (y, z, row) in self.rows(shape) {
            for [first, last] in self.along(&row) {
                cells.extend((first..=last).map(|x| IVec3::new(x, y, z)));
            }
        }
        let points = cells.iter().map(|cell| origin + spacing * (stretch * cell.as_dvec3())).collect();
        LatticeSample { spacing, axes: DMat3::IDENTITY, stretch, points, cells }
    }

    /// The rows that come near a shape with their stretches, by z, then y.
    fn rows<'a>(&self, shape: &'a dyn Scanlines) -> impl Iterator<Item = (i32, i32, Vec<[f64; 2]>)> + use<'a> {
        let [min, max] = shape.bounds();
        let (spacings, origin) = (self.spacings(), self.origin);
        let first = ((min - origin) / spacings).floor().as_ivec3();
        let last = ((max - origin) / spacings).ceil().as_ivec3();
        (first.z..=last.z).flat_map(move |z| (first.y..=last.y).map(move |y| (y, z))).map(move |(y, z)| {
            let at = |axis: usize, cell: i32| origin[axis] + spacings[axis] * f64::from(cell);
            (y, z, shape.row(at(1, y), at(2, z)))
        })
    }

    /// First and last point in every stretch of a row.
    fn along(&self, row: &[[f64; 2]]) -> impl Iterator<Item = [i32; 2]> {
        let (spacing, origin) = (self.spacings().x, self.origin.x);
        let ends = move |&[from, to]: &[f64; 2]| {
            [((from - origin) / spacing).ceil() as i32, ((to - origin) / spacing).floor() as i32]
        };
        row.iter().map(ends).filter(|[first, last]| first <= last)
    }
}

/// Volume and moments of the whole particles of lattices that differ along x only.
fn whole_moments(shape: &dyn Scanlines, lattices: &[FittedLattice], center: DVec3) -> Vec<Moments> {
    let mut sums = vec![Moments::NONE; lattices.len()];
    let Some(first) = lattices.first() else { return sums };
    let spacings = first.spacings();
    let volume = spacings.element_product();
    for (y, z, row) in first.rows(shape) {
        let at = |axis: usize, cell: i32| first.origin[axis] - center[axis] + spacings[axis] * f64::from(cell);
        for (moments, lattice) in sums.iter_mut().zip(lattices) {
            for [first, last] in lattice.along(&row) {
                let count = f64::from(last - first + 1);
                let middle = lattice.origin.x - center.x + spacings.x * 0.5 * (f64::from(first) + f64::from(last));
                let spread = spacings.x.powi(2) * (count * count - 1.0) / 12.0;
                let each = [1.0, middle, middle * middle + spread];
                moments.add_sums(each.map(|of| volume * count * of), at(1, y), at(2, z));
            }
        }
    }
    for moments in &mut sums {
        moments.second += DMat3::from_diagonal(OWN_MOMENT * moments.volume * spacings * spacings);
    }
    sums
}

/// A shape's moments, in which those of particles are measured.
pub(super) struct Target {
    volume: f64,
    /// Takes places from the centre of gravity to where the second moments are those of a unit.
    pub(super) to_unit: DMat3,
    /// Centre of gravity, from where moments are taken about [m].
    pub(super) gravity: DVec3,
}

impl Target {
    fn of(shape: &dyn Scanlines, center: DVec3) -> Self {
        Self::from_moments(&Moments::of(shape, center))
    }

    pub(super) fn from_moments(&Moments { volume, first, second }: &Moments) -> Self {
        let gravity = first / volume;
        let central = second * volume.recip() - spread(gravity);
        Self { volume, to_unit: inverse_factor(central), gravity }
    }

    /// How far volume, centre and second moments are off, relative to the shape's own along each of its directions.
    fn error(&self, found: &Moments) -> f64 {
        let (share, first) =
            (found.volume / self.volume, found.first / self.volume - found.volume / self.volume * self.gravity);
        let about = found.first / self.volume;
        let crossed = outer(about, self.gravity);
        let central = found.second * self.volume.recip() - crossed - crossed.transpose() + share * spread(self.gravity);
        let unit = self.to_unit * central * self.to_unit.transpose() - DMat3::IDENTITY;
        let norm = unit.to_cols_array().iter().map(|x| x * x).sum::<f64>().sqrt();
        (share - 1.0).abs() + norm + (self.to_unit * first).length()
    }
}

fn outer(a: DVec3, b: DVec3) -> DMat3 {
    DMat3::from_cols(a * b.x, a * b.y, a * b.z)
}

fn spread(a: DVec3) -> DMat3 {
    outer(a, a)
}

/// The inverse of the lower factor L of a symmetric, positive `a = L L^T`.
fn inverse_factor(a: DMat3) -> DMat3 {
    let l00 = a.x_axis.x.sqrt();
    let (l10, l20) = (a.x_axis.y / l00, a.x_axis.z / l00);
    let l11 = (a.y_axis.y - l10 * l10).sqrt();
    let l21 = (a.y_axis.z - l20 * l10) / l11;
    let l22 = (a.z_axis.z - l20 * l20 - l21 * l21).sqrt();
    let lower = DMat3::from_cols(DVec3::new(l00, l10, l20), DVec3::new(0.0, l11, l21), DVec3::new(0.0, 0.0, l22));
    lower.inverse()
}

/// Changes of the spacing that are worth a try: none, those that bring flat faces between layers, and, where not all
/// are flat, some others.
fn changes(planes: &[Option<Planes>; 3], spacing: f64) -> Vec<f64> {
    let mut changes = vec![1.0];
    for planes in planes.iter().flatten() {
        changes.extend(planes.distances().flat_map(|distance| whole_changes(distance, spacing)));
    }
    if planes.iter().any(Option::is_none) {
        changes.extend(FREE_CHANGES.map(|hundredths| 0.01 * f64::from(hundredths)));
    }
    changes
}

/// Planes of flat faces along an axis: where they are [m] and their areas, in order.
struct Planes(Vec<(f64, f64)>);

/// Distances between planes that are looked at, at most.
const DISTANCES: usize = 12;

/// What fits them: a stretch of the lattice, and a place of its points [m].
#[derive(Clone, Copy, Debug, PartialEq)]
struct Flat {
    stretch: f64,
    point: f64,
}

impl Planes {
    /// Those of a shape that is mostly flat along an axis.
    fn along(shape: &dyn Scanlines, axis: usize, spacing: f64) -> Option<Self> {
        let (mut seen, mut flat) = (0.0, 0.0);
        let mut faces: Vec<(f64, f64)> = Vec::new();
        shape.visit_faces(&mut |normal, point, area| {
            seen += area * normal[axis].abs();
            if normal[axis].abs() > FLAT {
                flat += area;
                faces.push((point[axis], area));
            }
        });
        if flat < MOSTLY * seen || flat == 0.0 {
            return None;
        }
        faces.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut planes: Vec<(f64, f64)> = Vec::new();
        for (at, area) in faces {
            match planes.last_mut() {
                Some(last) if at - last.0 < 1e-6 * spacing => last.1 += area,
                _ => planes.push((at, area)),
            }
        }
        Some(Self(planes))
    }

    /// From the lowest plane to the highest, and to some of the others.
    fn distances(&self) -> impl Iterator<Item = f64> {
        let lowest = self.0.first().map_or(0.0, |plane| plane.0);
        let from_lowest = move |plane: &(f64, f64)| plane.0 - lowest;
        self.0.last().into_iter().chain(self.0.iter().skip(1).take(DISTANCES)).map(from_lowest)
    }

    /// How a lattice of this spacing [m] is stretched to have them between its layers; none where they do not agree on
    /// that.
    fn fitted(&self, spacing: f64) -> Option<Flat> {
        let whole =
            self.distances().map(|distance| stretch_to(distance, (distance / spacing).round().max(1.0), spacing));
        let mut best: Option<(f64, f64)> = None;
        for stretch in [1.0].into_iter().chain(whole) {
            let score = self.agreement(stretch * spacing).0 - UNEVEN * stretch.ln().abs();
            if best.is_none_or(|(most, _)| score > most + 1e-12) {
                best = Some((score, stretch));
            }
        }
        let stretch = best?.1;
        let (agreed, phase) = self.agreement(stretch * spacing);
        // From the lowest, which is exact where all agree.
        let face = if agreed > 1.0 - 1e-9 { self.0.first()?.0 } else { phase * stretch * spacing };
        (agreed > AGREED).then_some(Flat { stretch, point: face + 0.5 * stretch * spacing })
    }

    /// How well they agree on where layers of this thickness [m] end, 0 to 1, and where that is, in layers.
    fn agreement(&self, thickness: f64) -> (f64, f64) {
        let (mut even, mut odd, mut all) = (0.0, 0.0, 0.0);
        for (at, area) in &self.0 {
            let phase = TAU * (at / thickness).rem_euclid(1.0);
            even += area * phase.cos();
            odd += area * phase.sin();
            all += area;
        }
        (even.hypot(odd) / all, odd.atan2(even) / TAU)
    }
}
