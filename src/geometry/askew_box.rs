//! A box as the rows of a lattice that is turned against it see it.

use super::lattice::Cuboid;
use super::scanlines::Scanlines;
use glam::{DMat3, DVec3};

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

impl Scanlines for AskewBox {
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
