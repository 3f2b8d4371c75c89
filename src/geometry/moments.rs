//! Volume and first and second moments of a shape.

use super::scanlines::Scanlines;
use glam::{DMat3, DVec3};
use rayon::prelude::*;

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
    pub(crate) fn of(shape: &dyn Scanlines, center: DVec3) -> Self {
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
