//! By how much a body differs from what it would be without a change: twist, lean and length between its ends.

use super::turn::{mean, turn_about};
use glam::{DQuat, DVec3};

/// Share of a body's length that counts as one of its ends.
const END: f64 = 0.25;

/// The particles at both ends of a body's longest extent, and how far these lie apart.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Ends {
    groups: [Vec<u32>; 2],
    length: f64,
}

impl Ends {
    /// Those of a body at rest [m]; none where it has no extent.
    pub(crate) fn of(rest: &[DVec3]) -> Option<Self> {
        let first = *rest.first()?;
        let (low, high) = rest.iter().fold((first, first), |(low, high), at| (low.min(*at), high.max(*at)));
        let extent = high - low;
        let axis = (0..3).max_by(|a, b| extent[*a].total_cmp(&extent[*b]))?;
        let within = |least: f64, most: f64| {
            let share = |at: &DVec3| (at[axis] - low[axis]) / extent[axis];
            let inside = rest.iter().zip(0..).filter(|(at, _)| (least..=most).contains(&share(at)));
            inside.map(|(_, k)| k).collect::<Vec<u32>>()
        };
        let groups = [within(0.0, END), within(1.0 - END, 1.0)];
        let length = mean(&groups[1], rest).distance(mean(&groups[0], rest));
        (extent[axis] > 0.0 && groups.iter().all(|group| group.len() > 2)).then_some(Self { groups, length })
    }
}

/// By how much a body differs.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Difference {
    /// Turn of one end against the other about the line between them, right-handed [degrees].
    pub(crate) twist: f64,
    /// Angle between the lines from end to end [degrees].
    pub(crate) lean: f64,
    /// By how much further the ends lie apart [m], and over their distance at rest.
    pub(crate) longer: [f64; 2],
}

impl Difference {
    /// Between a body as it is and as it would have been, of the same particles [m].
    pub(crate) fn between(ends: &Ends, is: &[DVec3], was: &[DVec3]) -> Self {
        if is.len() != was.len() || ends.groups.iter().flatten().any(|&k| k as usize >= is.len()) {
            return Self::default();
        }
        let line = |points: &[DVec3]| mean(&ends.groups[1], points) - mean(&ends.groups[0], points);
        let (line_is, line_was) = (line(is), line(was));
        let lean = line_is.angle_between(line_was).to_degrees();
        // What it leans by is no twist.
        let axis = line_was.normalize_or_zero();
        let upright = DQuat::from_rotation_arc(line_is.normalize_or_zero(), axis);
        let is: Vec<DVec3> = is.iter().map(|&at| upright * at).collect();
        let [bottom, top] = ends.groups.each_ref().map(|group| turn_about(group, was, &is, axis));
        let twist = top - bottom;
        // By the shorter way round.
        let twist = twist - 360.0 * (twist / 360.0).round();
        let longer = line_is.length() - line_was.length();
        Self { twist, lean, longer: [longer, longer / ends.length] }
    }

    /// Of each the one that is greater in size; what is no number is none.
    pub(crate) fn greater(self, other: Self) -> Self {
        let of = |a: f64, b: f64| if b.abs() > a.abs() { b } else { a };
        let [a, b] = [self.longer, other.longer];
        let longer = if b[1].abs() > a[1].abs() { b } else { a };
        Self { twist: of(self.twist, other.twist), lean: of(self.lean, other.lean), longer }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A bar of points along y, 3 x 9 x 3.
    fn bar() -> Vec<DVec3> {
        let at = |k: usize| DVec3::new((k % 3) as f64, (k / 9) as f64, (k / 3 % 3) as f64) * 0.01;
        (0..81).map(at).collect()
    }

    #[test]
    fn a_twist_a_lean_and_a_stretch_are_told_apart_wherever_the_body_lies() {
        let rest = bar();
        let ends = Ends::of(&rest).expect("it has ends");
        let lies = DQuat::from_axis_angle(DVec3::new(1.0, 2.0, -0.5).normalize_or_zero(), 0.7);
        let placed = |by: &dyn Fn(DVec3) -> DVec3| {
            rest.iter().map(|&at| lies * by(at) + DVec3::new(3.0, -1.0, 2.0)).collect::<Vec<_>>()
        };
        let was = placed(&|at| at);
        let axis = DVec3::new(0.01, 0.0, 0.01);
        // 10 degrees from end to end, of which the middles of the ends are 7/8 apart.
        let twisted = placed(&|at| axis + DQuat::from_rotation_y((at.y / 0.08) * 10_f64.to_radians()) * (at - axis));
        let now = Difference::between(&ends, &twisted, &was);
        assert!((now.twist - 7.5).abs() < 1e-9 && now.lean < 1e-5 && now.longer[0].abs() < 1e-12, "{now:?}");
        let leant = placed(&|at| DQuat::from_rotation_z(0.3) * at);
        let now = Difference::between(&ends, &leant, &was);
        assert!((now.lean - 0.3_f64.to_degrees()).abs() < 1e-9 && now.twist.abs() < 1e-9, "{now:?}");
        let longer = placed(&|at| at * DVec3::new(1.0, 1.1, 1.0));
        let now = Difference::between(&ends, &longer, &was);
        assert!((now.longer[1] - 0.1).abs() < 1e-12 && now.twist.abs() < 1e-9 && now.lean < 1e-5, "{now:?}");
        let none = Difference::between(&ends, &was, &was);
        assert!(none.twist.abs() < 1e-9 && none.lean < 1e-5 && none.longer == [0.0; 2], "{none:?}");
        assert_eq!(Difference::between(&ends, &was[1..], &was), Difference::default());
    }

    #[test]
    fn the_greatest_is_kept_and_what_is_no_number_is_not() {
        let of = |twist: f64| Difference { twist, ..Difference::default() };
        assert_eq!(of(3.0).greater(of(-8.0)).greater(of(f64::NAN)).twist, -8.0);
        assert!(Ends::of(&[]).is_none() && Ends::of(&[DVec3::ONE; 4]).is_none());
    }
}
