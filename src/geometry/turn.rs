//! Where a group of points is, and how far it has turned.

use glam::DVec3;

/// Middle of some of the points.
pub(crate) fn mean(group: &[u32], positions: &[DVec3]) -> DVec3 {
    group.iter().map(|&i| positions[i as usize]).sum::<DVec3>() / group.len().max(1) as f64
}

/// Best turn [degrees] of a group about an axis from `rest` to `now`, in the plane across the axis.
pub(crate) fn turn_about(group: &[u32], rest: &[DVec3], now: &[DVec3], axis: DVec3) -> f64 {
    let (center_rest, center_now) = (mean(group, rest), mean(group, now));
    let (mut sine, mut cosine) = (0.0, 0.0);
    for &i in group {
        let across = |x: DVec3| x - axis * x.dot(axis);
        let (from, to) = (across(rest[i as usize] - center_rest), across(now[i as usize] - center_now));
        sine += from.cross(to).dot(axis);
        cosine += from.dot(to);
    }
    sine.atan2(cosine).to_degrees()
}
