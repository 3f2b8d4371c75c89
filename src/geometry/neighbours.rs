//! Fixed-radius neighbour search over points that do not move.

use super::cell_map::CellMap;
use glam::{DVec3, IVec3};

/// Points sorted into cells of one search radius.
#[derive(Clone, Debug)]
pub(crate) struct PointGrid<'a> {
    points: &'a [DVec3],
    radius: f64,
    cells: CellMap<Vec<u32>>,
}

impl<'a> PointGrid<'a> {
    /// Sorts `points` for searches within `radius` [m].
    pub(crate) fn new(points: &'a [DVec3], radius: f64) -> Self {
        let mut cells: CellMap<Vec<u32>> = CellMap::default();
        for (i, &point) in points.iter().enumerate() {
            cells.entry(cell_of(point, radius)).or_default().push(i as u32);
        }
        Self { points, radius, cells }
    }

    /// Indices of the points nearer to `center` than the search radius, in ascending order.
    pub(crate) fn within(&self, center: DVec3) -> Vec<u32> {
        let home = cell_of(center, self.radius);
        let mut found = Vec::new();
        for k in 0..27 {
            let step = IVec3::new(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1);
            for &i in self.cells.get(&(home + step)).into_iter().flatten() {
                if self.points[i as usize].distance_squared(center) < self.radius * self.radius {
                    found.push(i);
                }
            }
        }
        // The order of summation must not depend on the order of the cells.
        found.sort_unstable();
        found
    }
}

/// Cells are counted up to here, those further off as the last of them: their neighbours still have a number.
const FURTHEST: f64 = 1e9;

fn cell_of(point: DVec3, size: f64) -> IVec3 {
    (point / size).floor().clamp(DVec3::splat(-FURTHEST), DVec3::splat(FURTHEST)).as_ivec3()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_that_are_far_off_for_their_cells_are_found() {
        let far = DVec3::splat(1e12);
        let points = [DVec3::ZERO, far, far + DVec3::splat(1e-3), -far];
        let grid = PointGrid::new(&points, 1e-2);
        assert_eq!(grid.within(far), [1, 2]);
        assert_eq!(grid.within(-far), [3]);
    }

    #[test]
    fn agrees_with_brute_force() {
        let points: Vec<DVec3> = (0..400)
            .map(|i| DVec3::new(f64::from(i % 7), f64::from(i * 31 % 11), f64::from(i * 17 % 13)) * 0.3)
            .collect();
        let grid = PointGrid::new(&points, 0.9);
        for &center in &points {
            let expected: Vec<u32> = (0..400).filter(|&i| points[i as usize].distance_squared(center) < 0.81).collect();
            assert_eq!(grid.within(center), expected);
        }
    }
}
