//! Points that can be asked which of them are near, at any distance.

use glam::DVec3;

/// Points of a piece that is looked through one by one.
const LEAF: usize = 8;

/// Points, halved again and again across their widest extent. Unlike a grid of cells it has no size of its own: a point
/// far outside finds its nearest as fast as one among them.
#[derive(Clone, Debug, Default)]
pub(crate) struct PointTree {
    points: Vec<DVec3>,
    /// Indices of the points; the middle one of a piece divides it, and both its halves are pieces again.
    order: Vec<u32>,
    /// Axis across which a piece is divided, at the place of its middle point.
    axes: Vec<u8>,
}

impl PointTree {
    /// Sorts the points for asking.
    pub(crate) fn new(points: Vec<DVec3>) -> Self {
        let mut order: Vec<u32> = (0..points.len() as u32).collect();
        let mut axes = vec![0; points.len()];
        divide(&points, &mut order, &mut axes);
        Self { points, order, axes }
    }

    /// Distance to the nearest point [m]; infinite where there is none.
    pub(crate) fn distance(&self, x: DVec3) -> f64 {
        let mut least = f64::INFINITY;
        self.nearest_in(x, 0, self.order.len(), &mut least);
        least.sqrt()
    }

    fn nearest_in(&self, x: DVec3, low: usize, high: usize, least: &mut f64) {
        let square = |place: usize| self.points[self.order[place] as usize].distance_squared(x);
        if high - low <= LEAF {
            *least = (low..high).map(square).fold(*least, f64::min);
            return;
        }
        let middle = low.midpoint(high);
        *least = least.min(square(middle));
        let beyond = self.beyond(x, middle);
        let sides = [(low, middle), (middle + 1, high)];
        let (near, far) = if beyond < 0.0 { (sides[0], sides[1]) } else { (sides[1], sides[0]) };
        self.nearest_in(x, near.0, near.1, least);
        if beyond * beyond < *least {
            self.nearest_in(x, far.0, far.1, least);
        }
    }

    /// Indices of the points nearer to `x` than `radius` [m], in ascending order.
    pub(crate) fn within(&self, x: DVec3, radius: f64) -> Vec<u32> {
        let mut found = Vec::new();
        self.collect(x, radius, 0, self.order.len(), &mut found);
        // Sums over them must not depend on the tree.
        found.sort_unstable();
        found
    }

    fn collect(&self, x: DVec3, radius: f64, low: usize, high: usize, found: &mut Vec<u32>) {
        let near = |index: &u32| self.points[*index as usize].distance_squared(x) < radius * radius;
        if high - low <= LEAF {
            found.extend(self.order[low..high].iter().filter(|index| near(index)));
            return;
        }
        let middle = low.midpoint(high);
        found.extend(self.order[middle..=middle].iter().filter(|index| near(index)));
        let beyond = self.beyond(x, middle);
        if beyond < radius {
            self.collect(x, radius, low, middle, found);
        }
        if beyond > -radius {
            self.collect(x, radius, middle + 1, high, found);
        }
    }

    /// How far `x` lies past the middle point of a piece, along the axis that divides it [m].
    fn beyond(&self, x: DVec3, middle: usize) -> f64 {
        let axis = usize::from(self.axes[middle]);
        x[axis] - self.points[self.order[middle] as usize][axis]
    }
}

fn divide(points: &[DVec3], order: &mut [u32], axes: &mut [u8]) {
    if order.len() <= LEAF {
        return;
    }
    let (mut low, mut high) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    for &index in &*order {
        low = low.min(points[index as usize]);
        high = high.max(points[index as usize]);
    }
    let axis = (high - low).max_position();
    let middle = order.len() / 2;
    let along = |index: u32| points[index as usize][axis];
    order.select_nth_unstable_by(middle, |&a, &b| along(a).total_cmp(&along(b)).then(a.cmp(&b)));
    axes[middle] = axis as u8;
    let (left, right) = order.split_at_mut(middle);
    let (left_axes, right_axes) = axes.split_at_mut(middle);
    divide(points, left, left_axes);
    divide(points, &mut right[1..], &mut right_axes[1..]);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn agrees_with_looking_at_every_point() {
        let mut points: Vec<DVec3> = (0..400)
            .map(|i| DVec3::new(f64::from(i % 7), f64::from(i * 31 % 11), f64::from(i * 17 % 13)) * 0.3)
            .collect();
        // Many at one place, which no axis divides.
        points.extend([DVec3::ONE; 40]);
        for count in [0, 1, 7, 9, 440] {
            let points = &points[..count];
            let tree = PointTree::new(points.to_vec());
            for k in 0..200 {
                let k = f64::from(k);
                let scale = if k < 100.0 { 1.0 } else { 1e3 };
                let x = scale * DVec3::new((1.3 * k).sin(), 2.0 + (2.1 * k).cos(), (0.7 * k).sin());
                let square = |point: &DVec3| point.distance_squared(x);
                let least = points.iter().map(square).fold(f64::INFINITY, f64::min).sqrt();
                assert_eq!(tree.distance(x), least);
                for radius in [0.5, 1.7, 1.01 * least] {
                    let near = |i: &u32| square(&points[*i as usize]) < radius * radius;
                    let expected: Vec<u32> = (0..count as u32).filter(near).collect();
                    assert_eq!(tree.within(x, radius), expected);
                }
            }
        }
    }
}
