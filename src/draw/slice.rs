//! A plane that cuts bodies open, so that their inside is seen.

use crate::scene::Axis;
use glam::DVec3;

/// A plane across an axis of the world: skins and material particles on one side of it are not there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slice {
    /// Across which axis.
    pub axis: Axis,
    /// Where along it [m].
    pub at: f64,
    /// Whether the side towards smaller coordinates is cut away rather than the other.
    pub flipped: bool,
}

impl Slice {
    /// Height of a point above the plane [m]; what lies above it is cut away.
    pub fn height(&self, point: DVec3) -> f64 {
        let beyond = point[self.axis.index()] - self.at;
        if self.flipped { -beyond } else { beyond }
    }

    /// Whether a point [m] is cut away.
    pub fn hides(&self, point: DVec3) -> bool {
        self.height(point) > 0.0
    }

    /// Unit vector out of what is left.
    pub fn normal(&self) -> DVec3 {
        let axis = DVec3::AXES[self.axis.index()];
        if self.flipped { -axis } else { axis }
    }

    /// Where along a line of sight there may be something left, in lengths of its direction; none where nowhere.
    pub fn kept(&self, origin: DVec3, direction: DVec3) -> Option<[f64; 2]> {
        let (height, climb) = (self.height(origin), direction.dot(self.normal()));
        let crossing = -height / climb;
        match (height > 0.0, climb < 0.0) {
            (true, true) => Some([crossing, f64::INFINITY]),
            (true, false) => None,
            (false, true) => Some([0.0, f64::INFINITY]),
            (false, false) => Some([0.0, if climb > 0.0 { crossing } else { f64::INFINITY }]),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_of_sight_is_kept_where_nothing_hides_its_points() {
        for (flipped, at) in [(false, 0.2), (true, 0.2), (false, -3.0)] {
            let slice = Slice { axis: Axis::Y, at, flipped };
            for (origin, direction) in [
                (DVec3::new(0.0, 5.0, 1.0), DVec3::new(0.1, -1.0, 0.3)),
                (DVec3::new(0.0, -5.0, 1.0), DVec3::new(0.1, 1.0, 0.3)),
                (DVec3::new(0.0, -5.0, 1.0), DVec3::X),
                (DVec3::new(0.0, 5.0, 1.0), DVec3::X),
            ] {
                let kept = slice.kept(origin, direction);
                for k in 0..200 {
                    let along = 0.05 * f64::from(k) + 0.0123;
                    let inside = kept.is_some_and(|[from, to]| (from..=to).contains(&along));
                    assert_eq!(inside, !slice.hides(origin + along * direction), "{slice:?} {origin} {along}");
                }
            }
        }
    }
}
