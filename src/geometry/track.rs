//! Values at times, and what is between them: stepped, straight, or cubic (Khronos: *glTF 2.0 Specification*, appendix
//! C).

use glam::{DQuat, DVec4};

/// How a track goes from one key to the next.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Between {
    /// It keeps its value up to the next.
    Stepped,
    /// Straight; a rotation the shorter way round, at a steady rate.
    Linear,
    /// Cubic, with the tangents [1/s] into and out of each key.
    Cubic(Vec<[DVec4; 2]>),
}

/// A value that changes in time: a vector of three numbers and a zero, or a rotation as x, y, z, w.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Track {
    /// Ascending, one at least [s].
    pub(crate) times: Vec<f64>,
    /// A value a time; rotations are of length one.
    pub(crate) values: Vec<DVec4>,
    pub(crate) between: Between,
}

impl Track {
    /// A vector at a time [s], and its rate [1/s]; before the first key and after the last it stays.
    pub(crate) fn vector(&self, time: f64) -> [DVec4; 2] {
        let (k, s, span) = match self.place(time) {
            Place::At(k) => return [self.values[k], DVec4::ZERO],
            Place::Between(k, s, span) => (k, s, span),
        };
        let [a, b] = [self.values[k], self.values[k + 1]];
        match &self.between {
            Between::Stepped => [a, DVec4::ZERO],
            Between::Linear => [a + s * (b - a), (b - a) / span],
            Between::Cubic(tangents) => cubic([a, span * tangents[k][1], b, span * tangents[k + 1][0]], s, span),
        }
    }

    /// A rotation at a time [s], and the rate of its numbers [1/s].
    pub(crate) fn rotation(&self, time: f64) -> [DQuat; 2] {
        if let (Place::Between(k, s, span), Between::Linear) = (self.place(time), &self.between) {
            let [a, b] = [self.values[k], self.values[k + 1]].map(DQuat::from_vec4);
            let [turn, rate] = slerp(a, b, s);
            return [turn, rate * span.recip()];
        }
        let [value, rate] = self.vector(time);
        unit(value, rate)
    }

    fn place(&self, time: f64) -> Place {
        let next = self.times.partition_point(|&key| key <= time);
        if next == 0 {
            return Place::At(0);
        }
        if next == self.times.len() {
            return Place::At(next - 1);
        }
        let (start, end) = (self.times[next - 1], self.times[next]);
        Place::Between(next - 1, (time - start) / (end - start), end - start)
    }
}

/// Where among its keys a track is.
enum Place {
    /// At one of them.
    At(usize),
    /// Behind one, by this share of the way to the next, which is so far [s].
    Between(usize, f64, f64),
}

/// From `a` to `b` with the tangents out of the one and into the other, over a span [s]: the value at `s` of the way
/// and its rate [1/s].
pub(crate) fn cubic<T>([a, from, b, to]: [T; 4], s: f64, span: f64) -> [T; 2]
where
    T: Copy + std::ops::Mul<f64, Output = T> + std::ops::Add<Output = T>,
{
    let (s2, s3) = (s * s, s * s * s);
    let sum = |w: [f64; 4]| a * w[0] + from * w[1] + b * w[2] + to * w[3];
    let value = sum([2.0 * s3 - 3.0 * s2 + 1.0, s3 - 2.0 * s2 + s, 3.0 * s2 - 2.0 * s3, s3 - s2]);
    let slope = [6.0 * (s2 - s), 3.0 * s2 - 4.0 * s + 1.0, 6.0 * (s - s2), 3.0 * s2 - 2.0 * s];
    [value, sum(slope.map(|w| w / span))]
}

/// The rotation between two, the shorter way round, at `s` of the way, and the rate of its numbers by `s`.
pub(crate) fn slerp(a: DQuat, b: DQuat, s: f64) -> [DQuat; 2] {
    let b = if a.dot(b) < 0.0 { -b } else { b };
    let difference = (a.conjugate() * b).normalize();
    let (axis, angle) = difference.to_axis_angle();
    let turn = a * DQuat::from_axis_angle(axis, s * angle);
    // The rate of a turn by an angle about a fixed axis n is (1/2) q n.
    let half = 0.5 * angle * axis;
    [turn, turn * DQuat::from_xyzw(half.x, half.y, half.z, 0.0)]
}

/// Numbers on the way between rotations as a rotation, with the rate of that.
fn unit(value: DVec4, rate: DVec4) -> [DQuat; 2] {
    let length = value.length();
    if length == 0.0 {
        return [DQuat::IDENTITY, DQuat::from_xyzw(0.0, 0.0, 0.0, 0.0)];
    }
    let direction = value / length;
    [DQuat::from_vec4(direction), DQuat::from_vec4((rate - direction * direction.dot(rate)) / length)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    fn rotations(between: Between) -> Track {
        let turns = [
            DQuat::from_axis_angle(DVec3::Z, 0.3),
            DQuat::from_axis_angle(DVec3::X, -1.9),
            -DQuat::from_axis_angle(DVec3::new(0.6, 0.0, 0.8), 1.0),
        ];
        Track { times: vec![0.2, 0.7, 1.5], values: turns.map(DVec4::from).to_vec(), between }
    }

    #[test]
    fn keys_are_met_and_rates_are_those_of_the_values() {
        let tangents = vec![[DVec4::new(0.3, -0.1, 0.2, 0.5), DVec4::new(-0.2, 0.6, 0.1, 0.4)]; 3];
        for between in [Between::Stepped, Between::Linear, Between::Cubic(tangents)] {
            let track = rotations(between);
            for (&time, &value) in track.times.iter().zip(&track.values) {
                assert!((track.vector(time)[0] - value).length() < 1e-15);
                assert!(track.rotation(time)[0].angle_between(DQuat::from_vec4(value)) < 1e-7);
            }
            for time in [0.0, 0.31, 0.69, 0.9, 1.4, 2.0] {
                let d = 1e-6;
                let [before, after] = [time - d, time + d];
                let slope = (track.vector(after)[0] - track.vector(before)[0]) / (2.0 * d);
                assert!((slope - track.vector(time)[1]).length() < 1e-8, "{time} {track:?}");
                let of = |time| DVec4::from(track.rotation(time)[0]);
                let slope = (of(after) - of(before)) / (2.0 * d);
                assert!((slope - DVec4::from(track.rotation(time)[1])).length() < 1e-8, "{time} {track:?}");
                assert!((of(time).length() - 1.0).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn a_rotation_goes_the_shorter_way_at_a_steady_rate() {
        let (a, b) = (DQuat::from_rotation_y(0.2), -DQuat::from_rotation_y(1.2));
        for s in [0.0, 0.3, 1.0] {
            assert!(slerp(a, b, s)[0].angle_between(DQuat::from_rotation_y(0.2 + s)) < 1e-7);
        }
        assert_eq!(slerp(a, a, 0.5)[0].angle_between(a), 0.0);
    }
}
