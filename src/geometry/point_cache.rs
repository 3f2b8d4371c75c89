//! Point caches: the points of a mesh at the times of samples, and smoothly in between.

use super::track::cubic;
use glam::{DVec3, Vec3};

/// Points at ascending times.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct PointCache {
    /// Time of every sample: [s], or in frames where the file does not say how long they take.
    times: Vec<f64>,
    in_frames: bool,
    points: usize,
    /// Sample after sample, in the file's unit and axes.
    values: Vec<Vec3>,
}

impl PointCache {
    /// Samples of so many points each at ascending times, which are frames or seconds.
    pub(crate) fn new(times: Vec<f64>, in_frames: bool, points: usize, values: Vec<Vec3>) -> Self {
        debug_assert_eq!(values.len(), points * times.len());
        Self { times, in_frames, points, values }
    }

    /// Points of a sample.
    pub(crate) fn points(&self) -> usize {
        self.points
    }

    /// Seconds to the unit of its times, where a second has so many frames.
    pub(crate) fn seconds(&self, frames_per_second: f64) -> f64 {
        if self.in_frames { frames_per_second.recip() } else { 1.0 }
    }

    /// From the first sample to the last, in the unit of its times.
    pub(crate) fn length(&self) -> f64 {
        self.times[self.times.len() - 1] - self.times[0]
    }

    fn value(&self, sample: usize, point: u32) -> DVec3 {
        self.values[sample * self.points + point as usize].as_dvec3()
    }

    /// What is looked at around a time since the first sample, in the unit of the cache's times.
    pub(crate) fn around(&self, time: f64) -> Around<'_> {
        let time = self.times[0] + time;
        let last = self.times.len() - 1;
        let next = self.times.partition_point(|&sample| sample <= time).clamp(1, last.max(1));
        Around { cache: self, before: (next - 1).min(last), time: time.clamp(self.times[0], self.times[last]) }
    }
}

/// A cache at a time.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Around<'a> {
    cache: &'a PointCache,
    before: usize,
    time: f64,
}

impl Around<'_> {
    /// Where a point is, and its rate by the unit of the cache's times: through the samples by cubic pieces whose
    /// slopes at a sample are those between its neighbours.
    pub(crate) fn point(&self, point: u32) -> [DVec3; 2] {
        let PointCache { times, .. } = self.cache;
        let value = |sample: usize| self.cache.value(sample, point);
        let (k, last) = (self.before, times.len() - 1);
        if k == last {
            return [value(k), DVec3::ZERO];
        }
        let span = times[k + 1] - times[k];
        let slope = |sample: usize| {
            let [from, to] = [sample.saturating_sub(1), (sample + 1).min(last)];
            (value(to) - value(from)) / (times[to] - times[from])
        };
        let ends = [value(k), span * slope(k), value(k + 1), span * slope(k + 1)];
        cubic(ends, (self.time - times[k]) / span, span)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cache() -> PointCache {
        let times = vec![0.5, 1.0, 2.0, 2.5];
        let values = times.iter().flat_map(|&t| [Vec3::splat(t as f32), Vec3::new((t * t) as f32, 0.0, 1.0)]).collect();
        PointCache::new(times, false, 2, values)
    }

    #[test]
    fn what_moves_steadily_stays_so_and_samples_are_met() {
        let cache = cache();
        for time in [0.0, 0.2, 0.5, 1.1, 1.9] {
            let [x, v] = cache.around(time).point(0);
            assert!(x.distance(DVec3::splat(0.5 + time)) < 1e-14 && v.distance(DVec3::ONE) < 1e-14, "{time}");
        }
        for (time, value) in [(0.0, 0.25), (0.5, 1.0), (1.5, 4.0), (2.0, 6.25), (9.0, 6.25)] {
            assert!((cache.around(time).point(1)[0].x - value).abs() < 1e-14, "{time}");
        }
    }

    #[test]
    fn rates_are_those_of_the_places_and_have_no_jumps() {
        let cache = cache();
        let d = 1e-6;
        for time in [0.2, 0.49, 0.51, 1.1, 1.4, 1.6] {
            let [before, here, after] = [time - d, time, time + d].map(|time| cache.around(time).point(1));
            assert!(((after[0] - before[0]) / (2.0 * d)).distance(here[1]) < 1e-7, "{time}");
        }
        for time in [0.5, 1.5] {
            let [before, after] = [time - 1e-9, time + 1e-9].map(|time| cache.around(time).point(1)[1]);
            assert!(before.distance(after) < 1e-6, "{time}: {before} and {after}");
        }
    }

    #[test]
    fn a_single_sample_stays() {
        let cache = PointCache::new(vec![3.0], true, 1, vec![Vec3::X]);
        assert_eq!(cache.around(0.0).point(0), [DVec3::X, DVec3::ZERO]);
        assert_eq!((cache.length(), cache.seconds(25.0)), (0.0, 0.04));
    }
}
