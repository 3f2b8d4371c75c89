//! Particles that follow a motion made elsewhere: the joints of a skeleton, or the points of a cache.
//!
//! How it works. Each particle is bound once, as the body is at rest. To a skeleton it is bound as a vertex of its skin
//! is, by shares of joints, in the frame in which the skin was bound: where the joints go there, linearly blended, it
//! goes. To a cache it is bound to the face that is nearest to it: its foot there keeps its shares of the corners, and
//! its height over it stays. What a clip does between its keys, and a cache between its samples, is known at any time
//! with its rate, so that what is held has the velocity of its motion.

use super::drive::After;
use crate::geometry::point_cache::PointCache;
use crate::geometry::skeleton::{Moment, Skeleton, product};
use glam::{DMat4, DVec3};
use std::sync::Arc;

/// Where some particles are led.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Led {
    /// What leads them.
    pub(crate) leader: Leader,
    /// When.
    pub(crate) playing: Playing,
    /// From the leader's space to the world.
    pub(crate) frame: DMat4,
}

/// What leads particles, and how each of them is bound to it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Leader {
    /// A clip of a skeleton.
    Skeleton { skeleton: Arc<Skeleton>, clip: usize, bound: Vec<BoundToJoints> },
    /// A cache; the units of its times take so many seconds.
    Cache { cache: Arc<PointCache>, seconds: f64, bound: Vec<BoundToFace> },
}

/// How a particle hangs on joints.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct BoundToJoints {
    /// Joints, and their shares, which make one.
    pub(crate) joints: Vec<(u32, f64)>,
    /// Where it is in the frame in which the skin was bound.
    pub(crate) point: DVec3,
}

/// How a particle hangs on a face of a cache's mesh.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct BoundToFace {
    /// The corners.
    pub(crate) corners: [u32; 3],
    /// Their shares in its foot, which make one.
    pub(crate) shares: [f64; 3],
    /// Its height over the face, on the side to which that looks.
    pub(crate) height: f64,
    /// Where it is at rest, in the leader's space.
    pub(crate) rest: DVec3,
}

/// When a motion is played: from a start on the body is eased into the first frame, and then goes on with it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Playing {
    /// When the easing begins [s].
    pub(crate) start: f64,
    /// How long it takes [s].
    pub(crate) pre_roll: f64,
    /// How many seconds of the motion go by in one.
    pub(crate) speed: f64,
    /// From which time of it on it is played [s].
    pub(crate) from: f64,
    /// How long the motion is from there on [s].
    pub(crate) length: f64,
    /// What comes after its end.
    pub(crate) after: After,
}

impl Playing {
    /// What is played at a time [s].
    pub(crate) fn at(&self, time: f64) -> Moment {
        let since = time - self.start;
        if since < self.pre_roll || since < 0.0 {
            if since <= 0.0 {
                return Skeleton::AT_REST;
            }
            let s = since / self.pre_roll;
            let (share, rate) = (s * s * (3.0 - 2.0 * s), 6.0 * s * (1.0 - s) / self.pre_roll);
            return Moment::Eased { to: self.from, share, rate };
        }
        let (played, length) = (self.speed * (since - self.pre_roll), self.length);
        let (time, rate) = match self.after {
            _ if length == 0.0 => (0.0, 0.0),
            _ if played < length => (played, self.speed),
            After::Hold => (length, 0.0),
            After::Repeat => (played.rem_euclid(length), self.speed),
            After::Mirror => {
                let round = played.rem_euclid(2.0 * length);
                if round < length { (round, self.speed) } else { (2.0 * length - round, -self.speed) }
            }
        };
        Moment::Played { time: self.from + time, rate }
    }

    /// When nothing moves any more [s].
    pub(crate) fn end(&self) -> f64 {
        let begins = self.start + self.pre_roll;
        match self.after {
            _ if self.length == 0.0 => begins,
            After::Hold => begins + self.length / self.speed,
            After::Repeat | After::Mirror => f64::INFINITY,
        }
    }

    /// Times [s] at which all that it does in one round is seen.
    pub(crate) fn moments(&self) -> Vec<f64> {
        const EASING: u32 = 8;
        const PLAYING: u32 = 48;
        let between = |start: f64, length: f64, pieces: u32| {
            (0..=pieces).map(move |k| start + length * f64::from(k) / f64::from(pieces))
        };
        let eased = between(self.start, self.pre_roll, EASING);
        eased.chain(between(self.start + self.pre_roll, self.length / self.speed, PLAYING)).collect()
    }
}

impl Led {
    /// Where each of the particles is led at a time [s]: places [m] and velocities [m/s].
    pub(crate) fn places(&self, time: f64) -> Vec<[DVec3; 2]> {
        let moment = self.playing.at(time);
        match &self.leader {
            Leader::Skeleton { skeleton, clip, bound } => {
                let frame = [self.frame, DMat4::ZERO];
                let maps = skeleton.joint_maps(*clip, moment);
                let maps: Vec<_> = maps.iter().map(|map| product(&frame, map)).collect();
                bound.iter().map(|particle| particle.place(&maps)).collect()
            }
            Leader::Cache { cache, seconds, bound } => {
                let [x, v] = [self.frame, DMat4 { w_axis: glam::DVec4::W, ..self.frame }];
                let place = |particle: &BoundToFace| {
                    let [at, rate] = particle.place(cache, *seconds, moment);
                    [x.transform_point3(at), v.transform_vector3(rate)]
                };
                bound.iter().map(place).collect()
            }
        }
    }

    /// When nothing moves any more [s].
    pub(crate) fn end(&self) -> f64 {
        self.playing.end()
    }
}

impl BoundToJoints {
    fn place(&self, maps: &[[DMat4; 2]]) -> [DVec3; 2] {
        let mut place = [DVec3::ZERO; 2];
        for &(joint, share) in &self.joints {
            let [map, rate] = &maps[joint as usize];
            place[0] += share * map.transform_point3(self.point);
            place[1] += share * (rate.transform_vector3(self.point) + rate.w_axis.truncate());
        }
        place
    }
}

impl BoundToFace {
    fn place(&self, cache: &PointCache, seconds: f64, moment: Moment) -> [DVec3; 2] {
        match moment {
            Moment::Eased { share: 0.0, .. } => [self.rest, DVec3::ZERO],
            Moment::Eased { to, share, rate } => {
                let way = self.on(cache, to / seconds, 0.0)[0] - self.rest;
                [self.rest + share * way, rate * way]
            }
            Moment::Played { time, rate } => self.on(cache, time / seconds, rate / seconds),
        }
    }

    /// On its face at a time of the cache, which goes by at a rate [1/s].
    fn on(&self, cache: &PointCache, time: f64, rate: f64) -> [DVec3; 2] {
        let around = cache.around(time);
        let [a, b, c] = self.corners.map(|corner| around.point(corner));
        let foot = [0, 1].map(|k| self.shares[0] * a[k] + self.shares[1] * b[k] + self.shares[2] * c[k]);
        let [one, other] = [b, c].map(|corner| [corner[0] - a[0], corner[1] - a[1]]);
        let across = one[0].cross(other[0]);
        let turning = one[1].cross(other[0]) + one[0].cross(other[1]);
        let length = across.length();
        if length == 0.0 {
            return [foot[0], rate * foot[1]];
        }
        let normal = across / length;
        let turned = (turning - normal * normal.dot(turning)) / length;
        [foot[0] + self.height * normal, rate * (foot[1] + self.height * turned)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;

    fn played(after: After) -> Playing {
        Playing { start: 0.5, pre_roll: 0.5, speed: 2.0, from: 0.25, length: 3.0, after }
    }

    #[test]
    fn a_motion_is_eased_into_then_played_and_then_held_repeated_or_mirrored() {
        let at = |after, time| played(after).at(time);
        assert_eq!(at(After::Hold, 0.5), Skeleton::AT_REST);
        assert_eq!(at(After::Hold, 0.75), Moment::Eased { to: 0.25, share: 0.5, rate: 3.0 });
        assert_eq!(at(After::Hold, 1.0), Moment::Played { time: 0.25, rate: 2.0 });
        assert_eq!(at(After::Hold, 9.0), Moment::Played { time: 3.25, rate: 0.0 });
        assert_eq!(at(After::Repeat, 3.0), Moment::Played { time: 1.25, rate: 2.0 });
        assert_eq!(at(After::Mirror, 3.0), Moment::Played { time: 2.25, rate: -2.0 });
        assert_eq!(played(After::Hold).end(), 2.5);
        assert_eq!(Playing { length: 0.0, ..played(After::Repeat) }.end(), 1.0);
        let at_once = Playing { start: 0.0, pre_roll: 0.0, ..played(After::Hold) };
        assert_eq!(at_once.at(0.0), Moment::Played { time: 0.25, rate: 2.0 });
    }

    #[test]
    fn what_hangs_on_a_face_keeps_its_place_on_it_and_its_velocity() {
        let samples = [0.0_f64, 0.5, 1.0, 1.5].map(|t| {
            let turn = glam::DQuat::from_axis_angle(DVec3::new(0.6, 0.0, 0.8), t * t);
            [DVec3::ZERO, DVec3::X, DVec3::new(0.2, 1.1, 0.0)].map(|corner| (turn * corner + t * DVec3::Z).as_vec3())
        });
        let values: Vec<Vec3> = samples.into_iter().flatten().collect();
        let cache = PointCache::new(vec![0.0, 0.5, 1.0, 1.5], false, 3, values);
        let rest = DVec3::new(0.3, 0.3, 0.2);
        let bound = BoundToFace { corners: [0, 1, 2], shares: [0.4, 0.4, 0.2], height: 0.2, rest };
        let frame = DMat4::from_scale_rotation_translation(DVec3::splat(2.0), glam::DQuat::from_rotation_y(1.0), rest);
        let led = Led {
            leader: Leader::Cache { cache: Arc::new(cache), seconds: 0.5, bound: vec![bound] },
            playing: Playing { start: 0.1, pre_roll: 0.2, speed: 1.3, from: 0.1, length: 0.65, after: After::Mirror },
            frame,
        };
        let d = 1e-6;
        assert_eq!(led.places(0.05)[0], [frame.transform_point3(rest), DVec3::ZERO]);
        for time in [0.15, 0.25, 0.35, 0.6, 0.95, 1.2] {
            let [before, here, after] = [time - d, time, time + d].map(|time| led.places(time)[0]);
            let slope = (after[0] - before[0]) / (2.0 * d);
            assert!(slope.distance(here[1]) < 1e-6, "{time} s: {slope}, not {}", here[1]);
        }
    }
}
