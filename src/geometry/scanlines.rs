//! A shape as the rows of a lattice see it, with the lattice's axes for coordinates.

use super::solid::Solid;
use glam::DVec3;

/// A shape that is asked for row by row.
pub(crate) trait Scanlines: Sync {
    /// Its least and greatest corner [m].
    fn bounds(&self) -> [DVec3; 2];

    /// Its volume [m³].
    fn volume(&self) -> f64;

    /// Stretches of the row through (y, z) along x that lie inside [m], in order.
    fn row(&self, y: f64, z: f64) -> Vec<[f64; 2]>;

    /// What a row costs, in faces that are looked at.
    fn looks_a_row(&self) -> f64 {
        1.0
    }

    /// Calls `found` with the unit normal of every flat face, a point of it [m] and its area [m²].
    fn visit_faces(&self, found: &mut dyn FnMut(DVec3, DVec3, f64));
}

/// What a row costs beside the faces that it looks at; where there are holes far fields are looked at.
const CLOSED_ROW: f64 = 8.0;
const OPEN_ROW: f64 = 400.0;

impl Scanlines for Solid {
    fn bounds(&self) -> [DVec3; 2] {
        [self.min, self.max]
    }

    fn volume(&self) -> f64 {
        self.volume
    }

    fn row(&self, y: f64, z: f64) -> Vec<[f64; 2]> {
        self.scanline(y, z)
    }

    fn looks_a_row(&self) -> f64 {
        let own = if self.report.closed { CLOSED_ROW } else { OPEN_ROW };
        own + self.faces_a_row()
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
