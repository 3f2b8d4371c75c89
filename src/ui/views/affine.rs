//! Moves, turns and stretches of space.

use glam::{DMat3, DVec3};

/// A move, turn and stretch of space.
pub(super) struct Affine {
    matrix: DMat3,
    offset: DVec3,
}

impl Default for Affine {
    fn default() -> Self {
        Self { matrix: DMat3::IDENTITY, offset: DVec3::ZERO }
    }
}

impl Affine {
    /// Where a point goes.
    pub(super) fn at(&self, point: DVec3) -> DVec3 {
        self.matrix * point + self.offset
    }

    /// The one that comes nearest to taking `rest` to `now` in the mean of squares; a move alone where these are not
    /// the same points or lie in a plane.
    pub(super) fn between(rest: &[DVec3], now: &[DVec3]) -> Self {
        let mean = |points: &[DVec3]| points.iter().sum::<DVec3>() / points.len().max(1) as f64;
        let (from, to) = (mean(rest), mean(now));
        let outer = |a: DVec3, b: DVec3| DMat3::from_cols(a * b.x, a * b.y, a * b.z);
        let (mut moved, mut spread) = (DMat3::ZERO, DMat3::ZERO);
        for (&rest, &now) in rest.iter().zip(now) {
            moved += outer(now - to, rest - from);
            spread += outer(rest - from, rest - from);
        }
        let size = (spread.x_axis.x + spread.y_axis.y + spread.z_axis.z) / 3.0;
        let solid = rest.len() == now.len() && spread.determinant() > 1e-9 * size.powi(3) && moved.is_finite();
        let matrix = if solid { moved * spread.inverse() } else { DMat3::IDENTITY };
        Self { matrix, offset: to - matrix * from }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_preview_goes_with_a_body_that_turned_and_stretched() {
        let rest: Vec<DVec3> =
            (0..27).map(|k| DVec3::new(f64::from(k % 3), f64::from(k / 3 % 3), f64::from(k / 9))).collect();
        let (matrix, offset) =
            (DMat3::from_rotation_y(0.7) * DMat3::from_diagonal(DVec3::new(1.0, 0.8, 1.1)), DVec3::Y);
        let now: Vec<DVec3> = rest.iter().map(|&point| matrix * point + offset).collect();
        let map = Affine::between(&rest, &now);
        let point = DVec3::new(0.3, 1.7, 0.9);
        assert!(map.at(point).distance(matrix * point + offset) < 1e-12);
        // Points in a plane say nothing of what leaves it.
        let flat: Vec<DVec3> = rest.iter().map(|point| point.with_z(0.0)).collect();
        assert!(Affine::between(&flat, &flat).at(point).distance(point) < 1e-12);
        assert!(Affine::between(&[], &[]).at(point).is_finite());
    }
}
