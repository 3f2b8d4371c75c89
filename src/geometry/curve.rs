//! Polylines in the plane and in space: length, resampling, smoothing, turning points, distance.
//!
//! Every function is total: an empty polyline gives an empty answer, a polyline of zero length gives repeated points.
//! Coordinates must be small enough for their squares to be finite; callers that take foreign input check that first.

use glam::{DVec2, DVec3};
use std::ops::{Add, Mul, Sub};

/// A point of a polyline, in the plane or in space [m].
pub trait Point: Copy + PartialEq + Add<Output = Self> + Sub<Output = Self> + Mul<f64, Output = Self> {
    /// Scalar product [m²].
    fn dot(self, other: Self) -> f64;

    /// Euclidean distance to `other` [m].
    fn distance(self, other: Self) -> f64 {
        let offset = self - other;
        offset.dot(offset).sqrt()
    }

    /// The point at fraction `t` of the way to `other`.
    #[must_use]
    fn mix(self, other: Self, t: f64) -> Self {
        self + (other - self) * t
    }
}

impl Point for DVec2 {
    fn dot(self, other: Self) -> f64 {
        Self::dot(self, other)
    }
}

impl Point for DVec3 {
    fn dot(self, other: Self) -> f64 {
        Self::dot(self, other)
    }
}

/// Length of the polyline [m]; 0 for fewer than two points.
pub fn arc_length<P: Point>(points: &[P]) -> f64 {
    // Not `sum`, which begins at minus zero.
    segments(points).map(|(a, b)| a.distance(b)).fold(0.0, |length, segment| length + segment)
}

/// `count` points spaced uniformly by arc length along the polyline, both ends kept to the bit.
///
/// An empty polyline gives no points. One of zero length gives `count` copies of its first point.
pub(crate) fn resample<P: Point>(points: &[P], count: usize) -> Vec<P> {
    let (Some(&first), Some(&last)) = (points.first(), points.last()) else {
        return Vec::new();
    };
    let step = arc_length(points) / count.saturating_sub(1).max(1) as f64;
    if step <= 0.0 || count < 2 {
        return vec![first; count];
    }
    let mut resampled = Vec::with_capacity(count);
    resampled.push(first);
    let mut walked = 0.0;
    for (a, b) in segments(points) {
        let length = a.distance(b);
        // The last point is set apart: the sum of the segments may end just short of it.
        while resampled.len() < count - 1 {
            let along = resampled.len() as f64 * step - walked;
            if along > length {
                break;
            }
            resampled.push(if length > 0.0 { a.mix(b, along / length) } else { a });
        }
        walked += length;
    }
    resampled.resize(count, last);
    resampled
}

/// The same polyline with every segment longer than `spacing` [m] cut into equal parts no longer than that.
///
/// Adds at most length / `spacing` points; a `spacing` that is not positive adds none.
pub(crate) fn refine<P: Point>(points: &[P], spacing: f64) -> Vec<P> {
    let mut refined: Vec<P> = points.first().copied().into_iter().collect();
    for (a, b) in segments(points) {
        let parts = if spacing > 0.0 { (a.distance(b) / spacing).ceil() as usize } else { 1 };
        refined.extend((1..parts).map(|part| a.mix(b, part as f64 / parts as f64)));
        refined.push(b);
    }
    refined
}

/// Smooths in place with `passes` passes of the filter [1/4 1/2 1/4]; both ends stay.
pub(crate) fn smooth<P: Point>(points: &mut [P], passes: usize) {
    for _ in 0..passes {
        let Some(&(mut before)) = points.first() else { return };
        for i in 1..points.len().saturating_sub(1) {
            let here = points[i];
            points[i] = here * 0.5 + (before + points[i + 1]) * 0.25;
            before = here;
        }
    }
}

/// Indices at which a sequence of coordinates turns back by at least `prominence` [m] on both sides, in order.
///
/// The ends never count. Smaller wiggles are taken for noise.
pub(crate) fn turning_points(values: &[f64], prominence: f64) -> Vec<usize> {
    let Some(&start) = values.first() else { return Vec::new() };
    let (mut turns, mut rising) = (Vec::new(), None);
    // Highest and lowest value since the last turn: whichever the sequence leaves by `prominence` is the next turn.
    let (mut high, mut low) = ((0, start), (0, start));
    for (i, &value) in values.iter().enumerate() {
        if value > high.1 {
            high = (i, value);
        }
        if value < low.1 {
            low = (i, value);
        }
        if rising != Some(false) && high.1 - value >= prominence && high.1 > value {
            turns.extend(rising.map(|_| high.0));
            rising = Some(false);
            low = (i, value);
        } else if rising != Some(true) && value - low.1 >= prominence && value > low.1 {
            turns.extend(rising.map(|_| low.0));
            rising = Some(true);
            high = (i, value);
        }
    }
    turns
}

/// Distance from a point to a polyline [m]; infinite where the polyline is empty.
pub fn distance_to_polyline<P: Point>(point: P, polyline: &[P]) -> f64 {
    let to_first = polyline.first().map_or(f64::INFINITY, |&first| point.distance(first));
    segments(polyline).map(|(a, b)| point.distance(nearest_on_segment(point, a, b))).fold(to_first, f64::min)
}

/// The point of segment `a`-`b` nearest to `point`.
pub(crate) fn nearest_on_segment<P: Point>(point: P, a: P, b: P) -> P {
    let along = b - a;
    let length_squared = along.dot(along);
    if length_squared > 0.0 { a.mix(b, ((point - a).dot(along) / length_squared).clamp(0.0, 1.0)) } else { a }
}

fn segments<P: Point>(points: &[P]) -> impl Iterator<Item = (P, P)> + '_ {
    points.iter().copied().zip(points.iter().copied().skip(1))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn resampling_spaces_points_uniformly_and_keeps_the_ends() {
        let corner = [DVec2::ZERO, DVec2::new(1.0, 0.0), DVec2::new(1.0, 0.0), DVec2::new(1.0, 3.0)];
        let points = resample(&corner, 9);
        assert_eq!(points.len(), 9);
        assert_eq!(points[0], corner[0]);
        assert_eq!(points[8], corner[3]);
        assert!(points[2].distance(DVec2::new(1.0, 0.0)) < 1e-12);
        assert!(points[5].distance(DVec2::new(1.0, 1.5)) < 1e-12);
        assert!(points.windows(2).all(|pair| (pair[0].distance(pair[1]) - 0.5).abs() < 1e-12));
    }

    #[test]
    fn resampling_has_an_answer_for_empty_and_zero_length() {
        assert!(resample::<DVec3>(&[], 5).is_empty());
        assert_eq!(resample(&[DVec3::ONE; 3], 4), vec![DVec3::ONE; 4]);
        assert_eq!(resample(&[DVec3::ONE, DVec3::ZERO], 1), vec![DVec3::ONE]);
    }

    #[test]
    fn refining_cuts_long_segments_only() {
        let points = refine(&[DVec2::ZERO, DVec2::X, DVec2::new(1.25, 0.0)], 0.3);
        assert_eq!(points.len(), 6);
        assert_eq!(points[2], DVec2::new(0.5, 0.0));
        assert!((arc_length(&points) - 1.25).abs() < 1e-12);
    }

    #[test]
    fn one_smoothing_pass_is_the_filter_itself() {
        let mut points = [0.0, 0.0, 4.0, 0.0, 0.0].map(|y| DVec2::new(0.0, y));
        smooth(&mut points, 1);
        assert_eq!(points.map(|point| point.y), [0.0, 1.0, 2.0, 1.0, 0.0]);
    }

    #[test]
    fn turning_points_ignore_wiggles_and_ends() {
        let values = [0.0, 0.5, 0.45, 1.0, 0.9, 0.2, 0.3, 0.1, 0.8];
        assert_eq!(turning_points(&values, 0.2), [3, 7]);
        assert_eq!(turning_points(&values, 0.01), [1, 2, 3, 5, 6, 7]);
        assert!(turning_points(&[2.0; 4], 0.0).is_empty());
        assert!(turning_points(&[], 0.1).is_empty());
    }

    #[test]
    fn distance_reaches_ends_and_insides_of_segments() {
        let line = [DVec2::ZERO, DVec2::X];
        assert_eq!(distance_to_polyline(DVec2::new(0.5, 2.0), &line), 2.0);
        assert_eq!(distance_to_polyline(DVec2::new(4.0, 4.0), &line), 5.0);
        assert_eq!(distance_to_polyline(DVec2::new(3.0, 4.0), &line[..1]), 5.0);
        assert_eq!(distance_to_polyline(DVec2::ONE, &[]), f64::INFINITY);
    }
}
