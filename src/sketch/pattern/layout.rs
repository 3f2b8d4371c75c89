//! What layouts are made of: polylines in the unit cube.

use glam::DVec3;

/// Vertices of one fibre [m].
pub type Polyline = Vec<DVec3>;

/// The box that is filled, less its margin.
pub(super) struct Inner {
    /// Extents [m].
    pub(super) size: DVec3,
    /// Axes from the longest to the thinnest; of equal ones Y before X before Z.
    pub(super) order: [usize; 3],
}

impl Inner {
    pub(super) fn new(size: DVec3) -> Self {
        let mut order = [1, 0, 2];
        order.sort_by(|&a, &b| size[b].total_cmp(&size[a]));
        Self { size, order }
    }

    /// A place of the unit cube by its share along the longest, the middle and the thinnest axis.
    pub(super) fn place(&self, along: f64, across: f64, through: f64) -> DVec3 {
        let mut place = DVec3::ZERO;
        for (axis, share) in self.order.into_iter().zip([along, across, through]) {
            place[axis] = share;
        }
        place
    }
}

/// `count` vertices of a curve over [0, 1].
pub(super) fn curve(count: f64, at: impl Fn(f64) -> DVec3) -> Polyline {
    let last = (count - 1.0).max(1.0);
    (0..=last as usize).map(|k| at(k as f64 / last)).collect()
}

/// A straight fibre of `count` vertices.
pub(super) fn line(count: f64, from: DVec3, to: DVec3) -> Polyline {
    curve(count, |t| from.lerp(to, t))
}

/// Shares of [0, 1] for `count` things side by side: the middle for a single one, from end to end for more.
pub(super) fn side_by_side(count: f64) -> impl Iterator<Item = f64> + Clone {
    let count = count as usize;
    (0..count).map(move |k| if count == 1 { 0.5 } else { k as f64 / (count - 1) as f64 })
}
