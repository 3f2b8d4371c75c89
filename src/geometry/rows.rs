//! A shape as the rows of a lattice see it, with the lattice's axes for coordinates.

use super::lattice::Cuboid;
use super::solid::Solid;
use glam::{DMat3, DVec3};
use rayon::prelude::*;

/// A shape that is asked for row by row.
pub(crate) trait Rows: Sync {
    /// Its least and greatest corner [m].
    fn bounds(&self) -> [DVec3; 2];

    /// Its volume [m³].
    fn volume(&self) -> f64;

    /// Stretches of the row through (y, z) along x that lie inside [m], in order.
    fn row(&self, y: f64, z: f64) -> Vec<[f64; 2]>;

    /// Calls `found` with the unit normal of every flat face, a point of it [m] and its area [m²].
    fn visit_faces(&self, found: &mut dyn FnMut(DVec3, DVec3, f64));
}

impl Rows for Solid {
    fn bounds(&self) -> [DVec3; 2] {
        [self.min, self.max]
    }

    fn volume(&self) -> f64 {
        self.volume
    }

    fn row(&self, y: f64, z: f64) -> Vec<[f64; 2]> {
        self.scanline(y, z)
    }

    fn visit_faces(&self, found: &mut dyn FnMut(DVec3, DVec3, f64)) {
        for face in &self.surface.faces {
            let [a, b, c] = face.map(|i| self.surface.points[i as usize]);
            let doubled = (b - a).cross(c - a);
            if let Some(normal) = doubled.try_normalize() {
                found(normal, a, 0.5 * doubled.length());
            }
        }
    }
}

/// A box about the origin that lies askew to the axes.
pub(crate) struct AskewBox {
    /// Half extents along its own axes [m].
    half: DVec3,
    /// Its own axes, as columns.
    own: DMat3,
}

impl AskewBox {
    /// A box as a lattice with unit `axes` sees it from its centre.
    pub(crate) fn new(shape: &Cuboid, axes: DMat3) -> Self {
        Self { half: 0.5 * shape.size, own: axes.transpose() }
    }
}

/// Cosines below this are those of a right angle.
const ALONG: f64 = 1e-12;

impl Rows for AskewBox {
    fn bounds(&self) -> [DVec3; 2] {
        let reach = self.own.abs() * self.half;
        [-reach, reach]
    }

    fn volume(&self) -> f64 {
        8.0 * self.half.element_product()
    }

    fn row(&self, y: f64, z: f64) -> Vec<[f64; 2]> {
        let [mut from, mut to] = [f64::NEG_INFINITY, f64::INFINITY];
        for k in 0..3 {
            let normal = self.own.col(k);
            let (beside, half) = (normal.y * y + normal.z * z, self.half[k]);
            if normal.x.abs() < ALONG {
                if beside.abs() > half {
                    return Vec::new();
                }
                continue;
            }
            let ends = [(-half - beside) / normal.x, (half - beside) / normal.x];
            from = from.max(ends[0].min(ends[1]));
            to = to.min(ends[0].max(ends[1]));
        }
        if from < to { vec![[from, to]] } else { Vec::new() }
    }

    fn visit_faces(&self, found: &mut dyn FnMut(DVec3, DVec3, f64)) {
        for k in 0..3 {
            let area = 4.0 * self.half[(k + 1) % 3] * self.half[(k + 2) % 3];
            for side in [-1.0, 1.0] {
                let normal = side * self.own.col(k);
                found(normal, self.half[k] * normal, area);
            }
        }
    }
}

/// Rows by which a shape is measured.
const MEASURED: f64 = 40_000.0;

/// How much nearer than a square's they lie along y, and further apart along z: the root of the golden ratio.
const UNLIKE: f64 = 1.272;

/// Volume [m³] and first and second moments about the origin of what was added.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Moments {
    pub(crate) volume: f64,
    pub(crate) first: DVec3,
    pub(crate) second: DMat3,
}

impl Moments {
    /// Those of nothing.
    pub(crate) const NONE: Self = Self { volume: 0.0, first: DVec3::ZERO, second: DMat3::ZERO };

    /// Adds those of something else.
    pub(crate) fn add(&mut self, other: &Self) {
        self.volume += other.volume;
        self.first += other.first;
        self.second += other.second;
    }

    /// Adds a stretch of a row of this section [m²], in which y and z are the same everywhere.
    pub(crate) fn add_stretch(&mut self, [from, to]: [f64; 2], [y, z]: [f64; 2], section: f64) {
        let powers = [to - from, 0.5 * (to * to - from * from), (to.powi(3) - from.powi(3)) / 3.0];
        self.add_sums(powers.map(|sum| section * sum), y, z);
    }

    /// Adds what has these sums of 1, x and x², weighted with the volume.
    pub(crate) fn add_sums(&mut self, [volume, x, xx]: [f64; 3], y: f64, z: f64) {
        self.volume += volume;
        self.first += DVec3::new(x, volume * y, volume * z);
        self.second += DMat3::from_cols(
            DVec3::new(xx, x * y, x * z),
            DVec3::new(x * y, volume * y * y, volume * y * z),
            DVec3::new(x * z, volume * y * z, volume * z * z),
        );
    }

    /// Those of a shape about `center` [m], by many rows.
    pub(crate) fn of(shape: &dyn Rows, center: DVec3) -> Self {
        let [min, max] = shape.bounds();
        let apart = ((max.y - min.y) * (max.z - min.z) / MEASURED).sqrt();
        // Not alike along y and z, so that no face lies along their diagonals.
        let count = |length: f64, apart: f64| (length / apart).ceil().max(1.0);
        let [columns, layers] = [count(max.y - min.y, apart / UNLIKE), count(max.z - min.z, apart * UNLIKE)];
        let steps = [(max.y - min.y) / columns, (max.z - min.z) / layers];
        let of_layer = |layer: u32| {
            let mut moments = Self::NONE;
            let z = min.z + (f64::from(layer) + 0.5) * steps[1];
            for column in 0..columns as u32 {
                let y = min.y + (f64::from(column) + 0.5) * steps[0];
                for stretch in shape.row(y, z) {
                    let along = stretch.map(|x| x - center.x);
                    moments.add_stretch(along, [y - center.y, z - center.z], steps[0] * steps[1]);
                }
            }
            moments
        };
        let layers: Vec<Self> = (0..layers as u32).into_par_iter().map(of_layer).collect();
        layers.iter().fold(Self::NONE, |mut sum, of| {
            sum.add(of);
            sum
        })
    }
}
