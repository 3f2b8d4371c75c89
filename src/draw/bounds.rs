//! Boxes along the axes.

use glam::DVec3;

/// A box along the world's axes, for framing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Least corner [m].
    pub min: DVec3,
    /// Greatest corner [m].
    pub max: DVec3,
}

impl Bounds {
    /// The smallest box around the points that are numbers; none where there is no such point.
    pub fn of(points: impl IntoIterator<Item = DVec3>) -> Option<Self> {
        points.into_iter().filter(|point| point.is_finite()).fold(None, |bounds: Option<Self>, point| {
            Some(
                bounds
                    .map_or(Self { min: point, max: point }, |b| Self { min: b.min.min(point), max: b.max.max(point) }),
            )
        })
    }

    /// The smallest box around both.
    #[must_use]
    pub fn union(self, other: Self) -> Self {
        Self { min: self.min.min(other.min), max: self.max.max(other.max) }
    }

    /// Middle [m].
    pub fn center(&self) -> DVec3 {
        0.5 * (self.min + self.max)
    }

    /// Half the diagonal [m].
    pub fn radius(&self) -> f64 {
        0.5 * (self.max - self.min).length()
    }

    /// The eight corners [m].
    pub fn corners(&self) -> [DVec3; 8] {
        std::array::from_fn(|k| {
            let pick = |bit: usize, axis: usize| if k >> bit & 1 == 0 { self.min[axis] } else { self.max[axis] };
            DVec3::new(pick(0, 0), pick(1, 1), pick(2, 2))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_no_number_has_no_part_in_it() {
        assert_eq!(Bounds::of([DVec3::NAN]), None);
        let bounds = Bounds::of([DVec3::X, DVec3::NAN, DVec3::Y]).unwrap();
        assert_eq!((bounds.min, bounds.max), (DVec3::ZERO, DVec3::new(1.0, 1.0, 0.0)));
        assert_eq!(Bounds::of(bounds.corners()), Some(bounds));
    }
}
