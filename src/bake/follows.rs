//! What bodies follow: how their particles are bound to it, once, at rest.

use super::error::{BakeError, known};
use super::note::Note;
use super::supports::{Regions, find};
use crate::geometry::bvh::Bvh;
use crate::geometry::closest::closest_on_segment;
use crate::geometry::file_mesh::FileMesh;
use crate::geometry::model::UpAxis;
use crate::geometry::nearest::nearest_face;
use crate::geometry::skeleton::Skeleton;
use crate::scene::{
    AnyBody, Assets, CacheLeader, Follow, FollowSelect, Hold, Leader, ModelFile, Placement, Scene, SkeletonLeader,
};
use crate::solver::constraint::{Constraint, PrescribedMotion};
use crate::solver::forces::{Force, LedSprings, StepLimit};
use crate::solver::led::{self, BoundToFace, BoundToJoints, Led, Playing};
use crate::solver::state::ParticleState;
use crate::text::number::compact;
use glam::{BVec3, DMat4, DVec3};
use std::sync::Arc;

/// From which painted share on a particle is held.
const HELD: f64 = 0.5;

/// A body that follows something.
struct Followers<'a> {
    scene: &'a Scene,
    body: AnyBody<'a>,
    assets: &'a Assets,
    /// Particles at rest in the model frame [m].
    points: &'a [DVec3],
    regions: &'a Regions,
}

/// Particles that follow one motion.
pub(super) struct Bound {
    id: String,
    /// In ascending order.
    particles: Vec<u32>,
    /// Painted share of each.
    shares: Vec<f64>,
    led: Arc<Led>,
    hold: Hold,
}

/// Where one particle could be led, and what chooses it.
struct Candidate<B> {
    bound: B,
    /// By how much the chosen joints hold it.
    held: f64,
    /// Distance from what it is bound to [m].
    distance: f64,
}

/// Binds the particles of a body, which are at these points of the model frame [m] at rest, to all that it follows;
/// `path` is its pointer.
pub(super) fn bind(
    scene: &Scene,
    assets: &Assets,
    (body, points, regions): (AnyBody<'_>, &[DVec3], &Regions),
    path: &str,
    notes: &mut Vec<Note>,
) -> Result<Vec<Bound>, BakeError> {
    let followers = Followers { scene, body, assets, points, regions };
    let follows = body.follows().iter().enumerate();
    follows.map(|(k, of)| followers.bind_one(of, &format!("{path}/follows/{k}"), notes)).collect()
}

/// A skeleton, the clip of it that is meant, and how every particle hangs on it.
type ToJoints = (Arc<Skeleton>, usize, Vec<Candidate<BoundToJoints>>);

impl Followers<'_> {
    fn bind_one(&self, of: &Follow, path: &str, notes: &mut Vec<Note>) -> Result<Bound, BakeError> {
        let frame = frame_of(&of.leader);
        let region = match &of.select {
            FollowSelect::Region(id) => Some(find(self.regions, id, &format!("{path}/select/region"))?),
            _ => None,
        };
        let chooses = |i: usize, held: f64, distance: f64| match &of.select {
            FollowSelect::Everything | FollowSelect::Painted => true,
            FollowSelect::SkinWeight(least) => held >= *least,
            FollowSelect::Distance(greatest) => distance <= *greatest,
            FollowSelect::Region(_) => region.is_some_and(|region| region.binary_search(&(i as u32)).is_ok()),
        };
        let least = if of.hold == Hold::Hard { HELD } else { f64::MIN_POSITIVE };
        let mut chosen: Vec<(u32, f64)> = Vec::new();
        let mut choose = |i: usize, held: f64, distance: f64| {
            let share = of.share(self.points[i]);
            let follows = share >= least && chooses(i, held, distance);
            if follows {
                chosen.push((i as u32, share));
            }
            follows
        };
        let (leader, played) = match &of.leader {
            Leader::Skeleton(skeleton) => {
                let bound = self.to_joints(skeleton, &frame, &format!("{path}/leader/skeleton"), notes)?;
                let (skeleton, clip, candidates) = bound;
                let [first, last] = skeleton.clips[clip].span;
                let from = played_from(of, last - first, path, notes);
                let bound = kept(candidates, &mut choose);
                (led::Leader::Skeleton { skeleton, clip, bound }, [from, last - first])
            }
            Leader::Cache(cache) => {
                let candidates = self.to_faces(cache, &frame, &format!("{path}/leader/cache"), notes)?;
                let cached = self.assets.cache(&cache.path).ok_or_else(|| not_loaded(path, "cache"))?;
                let rate = cache.frames_per_second.unwrap_or(self.scene.time.frames_per_second);
                let (seconds, bound) = (cached.seconds(rate), kept(candidates, &mut choose));
                let length = seconds * cached.length();
                let from = played_from(of, length, path, notes);
                (led::Leader::Cache { cache: Arc::clone(cached), seconds, bound }, [from, length])
            }
        };
        if chosen.is_empty() {
            return Err(BakeError::NothingFollows { path: format!("{path}/select"), particles: self.points.len() });
        }
        let led = Led { leader, playing: playing(of, played), frame: to_world(self.body.placement()) * frame };
        let (particles, shares) = chosen.into_iter().unzip();
        Ok(Bound { id: of.id.clone(), particles, shares, led: Arc::new(led), hold: of.hold.clone() })
    }

    /// Binds every particle to the joints of a skeleton, as its skin is where that is nearest.
    fn to_joints(
        &self,
        of: &SkeletonLeader,
        frame: &DMat4,
        path: &str,
        notes: &mut Vec<Note>,
    ) -> Result<ToJoints, BakeError> {
        let skeleton = self.assets.skeleton(&of.path).ok_or_else(|| not_loaded(path, ""))?;
        let clip = match &of.animation {
            None => 0,
            Some(name) => skeleton.clips.iter().position(|clip| clip.name == *name).ok_or_else(|| {
                let names = skeleton.clips.iter().map(|clip| clip.name.as_str());
                unknown(format!("{path}/animation"), "animation", name, names)
            })?,
        };
        let mut is_chosen = vec![of.joints.is_empty(); skeleton.joints.len()];
        for (k, name) in of.joints.iter().enumerate() {
            let mut found = skeleton.joints.iter().enumerate().filter(|(_, joint)| joint.name == *name).peekable();
            if found.peek().is_none() {
                let names = skeleton.joints.iter().map(|joint| joint.name.as_str());
                return Err(unknown(format!("{path}/joints/{k}"), "joint", name, names));
            }
            found.for_each(|(index, _)| is_chosen[index] = true);
        }
        let worlds = skeleton.worlds(clip, Skeleton::AT_REST);
        let chosen = (0..skeleton.joints.len()).filter(|&joint| is_chosen[joint]);
        let bones: Vec<[DVec3; 2]> = chosen.flat_map(|joint| skeleton.bones(joint, &worlds)).collect();
        let maps = skeleton.joint_maps(clip, Skeleton::AT_REST);
        let skin = &skeleton.skin;
        let bvh = Bvh::new(&skin.points, &skin.triangles);
        let (to_file, scale) = (frame.inverse(), frame.x_axis.truncate().length());
        let mut candidates = Vec::with_capacity(self.points.len());
        for &point in self.points {
            let at = to_file.transform_point3(point);
            let joints = nearest_face(&skin.points, &skin.triangles, &bvh, at)
                .map_or_else(|| vec![(0, 1.0)], |(face, weights, _)| shares(skeleton, face, weights));
            let map = joints.iter().fold(DMat4::ZERO, |map, &(joint, share)| map + maps[joint as usize][0] * share);
            let bound = map.inverse().transform_point3(at);
            if !bound.is_finite() {
                let joint = &skeleton.joints[joints[0].0 as usize].name;
                return Err(BakeError::FlatJoint { path: format!("{path}/path"), joint: joint.clone() });
            }
            let held = joints.iter().filter(|(joint, _)| is_chosen[*joint as usize]).map(|(_, share)| share).sum();
            let distance = bones.iter().map(|bone| distance_to(at, *bone)).fold(f64::INFINITY, f64::min);
            let bound = BoundToJoints { joints, point: bound };
            candidates.push(Candidate { bound, held, distance: scale * distance });
        }
        self.note_apart(skin.points.iter().map(|&point| frame.transform_point3(point)), path, notes);
        Ok((Arc::clone(skeleton), clip, candidates))
    }

    /// Says where a body and what it follows have no place in common.
    fn note_apart(&self, led: impl Iterator<Item = DVec3>, path: &str, notes: &mut Vec<Note>) {
        let around = |points: &mut dyn Iterator<Item = DVec3>| {
            points.fold([DVec3::INFINITY, DVec3::NEG_INFINITY], |[low, high], at| [low.min(at), high.max(at)])
        };
        let own = around(&mut self.points.iter().copied());
        let other = around(&mut { led });
        if own[0].cmpgt(other[1]).any() || other[0].cmpgt(own[1]).any() {
            let text = "lies apart from the body at rest: are its scale, its upward axis and the body's shape right?";
            notes.push(Note { path: format!("{path}/path"), text: text.to_owned(), warning: true });
        }
    }

    /// Binds every particle to the face of a cache's mesh that is nearest to it.
    fn to_faces(
        &self,
        of: &CacheLeader,
        frame: &DMat4,
        path: &str,
        notes: &mut Vec<Note>,
    ) -> Result<Vec<Candidate<BoundToFace>>, BakeError> {
        let cache = self.assets.cache(&of.path).ok_or_else(|| not_loaded(path, ""))?;
        let (to_file, scale) = (frame.inverse(), frame.x_axis.truncate().length());
        let own = || {
            let solid = self.body.model().and_then(|model| self.assets.solid(model));
            solid.and_then(|solid| solid.model.file.as_deref())
        };
        let (mesh, points): (&FileMesh, Vec<DVec3>) = if let Some(rest) = &of.rest {
            let mesh = self.assets.rest_mesh(rest).ok_or_else(|| not_loaded(path, ""))?;
            (mesh, mesh.points.clone())
        } else {
            let mesh = own().ok_or_else(|| BakeError::NoRest { path: path.to_owned() })?;
            if self.body.model().is_some_and(|model| (model.scale, model.up) != (of.scale, of.up)) {
                let text = "has another scale or upward axis than the body's own model, whose vertices it moves";
                notes.push(Note { path: path.to_owned(), text: text.to_owned(), warning: true });
            }
            (mesh, mesh.points.iter().map(|&point| to_file.transform_point3(point)).collect())
        };
        if points.len() != cache.points() {
            let path = format!("{path}/path");
            return Err(BakeError::CacheCount { path, points: cache.points(), vertices: points.len() });
        }
        let faces = faces_of(mesh, &points);
        let bvh = Bvh::new(&points, &faces);
        let bind = |&point: &DVec3| {
            let at = to_file.transform_point3(point);
            let (face, _, foot) = nearest_face(&points, &faces, &bvh, at)?;
            let corners = faces[face as usize];
            let [a, b, c] = corners.map(|corner| points[corner as usize]);
            let normal = (b - a).cross(c - a);
            let square = normal.length_squared();
            // In the plane of the face, which may be beside it: so that it is where it is.
            let share = |one: DVec3, other: DVec3| (one - at).cross(other - at).dot(normal) / square;
            let shares = [share(b, c), share(c, a), share(a, b)];
            let height = (at - a).dot(normal) / square.sqrt();
            let bound = BoundToFace { corners, shares, height, rest: at };
            Some(Candidate { bound, held: 1.0, distance: scale * at.distance(foot) })
        };
        let bound: Option<Vec<_>> = self.points.iter().map(bind).collect();
        bound.ok_or_else(|| BakeError::NoRest { path: path.to_owned() })
    }
}

/// The candidates that follow, in their order.
fn kept<B>(candidates: Vec<Candidate<B>>, choose: &mut dyn FnMut(usize, f64, f64) -> bool) -> Vec<B> {
    let candidates = candidates.into_iter().enumerate();
    candidates.filter(|(i, of)| choose(*i, of.held, of.distance)).map(|(_, of)| of.bound).collect()
}

/// When a motion is played from a time to its end [s].
pub(super) fn playing(of: &Follow, [from, end]: [f64; 2]) -> Playing {
    let after = super::drives::after(of.after);
    Playing { start: of.start, pre_roll: of.pre_roll, speed: of.speed, from, length: end - from, after }
}

/// From a leader's space to the model frame.
pub(super) fn frame_of(leader: &Leader) -> DMat4 {
    let (scale, up) = leader.units();
    frame(ModelFile { path: leader.path(), scale, up }.up_axis(), scale)
}

/// From a file's space to the model frame.
fn frame(up: UpAxis, scale: f64) -> DMat4 {
    let [x, y, z] = [DVec3::X, DVec3::Y, DVec3::Z].map(|axis| (scale * up.stand_up(axis)).extend(0.0));
    DMat4::from_cols(x, y, z, glam::DVec4::W)
}

pub(super) fn to_world(placement: &Placement) -> DMat4 {
    DMat4::from_rotation_translation(placement.rotation.quaternion(), DVec3::from_array(placement.translation))
}

/// The joints that hold a point of a face of the skin, which lies there by these weights of its corners.
fn shares(skeleton: &Skeleton, face: u32, weights: [f64; 3]) -> Vec<(u32, f64)> {
    let mut found: Vec<(u32, f64)> = Vec::new();
    for (corner, weight) in skeleton.skin.triangles[face as usize].into_iter().zip(weights) {
        for &(joint, share) in &skeleton.skin.held[corner as usize] {
            match found.iter_mut().find(|(known, _)| *known == joint) {
                Some((_, sum)) => *sum += weight * share,
                None => found.push((joint, weight * share)),
            }
        }
    }
    found.retain(|(_, share)| *share != 0.0);
    found.sort_unstable_by_key(|(joint, _)| *joint);
    let sum: f64 = found.iter().map(|(_, share)| share).sum();
    for (_, share) in &mut found {
        *share /= sum;
    }
    found
}

fn distance_to(at: DVec3, bone: [DVec3; 2]) -> f64 {
    let weights = closest_on_segment(at, bone);
    at.distance(weights[0] * bone[0] + weights[1] * bone[1])
}

/// The faces of a mesh in triangles, those without a direction left out.
fn faces_of(mesh: &FileMesh, points: &[DVec3]) -> Vec<[u32; 3]> {
    let corners = mesh.faces().flat_map(|face| {
        let corners = &mesh.corners[face];
        corners.windows(2).skip(1).map(|pair| [corners[0], pair[0], pair[1]])
    });
    let has_area = |face: &[u32; 3]| {
        let [a, b, c] = face.map(|corner| points[corner as usize]);
        (b - a).cross(c - a).length_squared() > 0.0
    };
    corners.filter(has_area).collect()
}

fn unknown<'a>(path: String, what: &'static str, id: &str, names: impl Iterator<Item = &'a str>) -> BakeError {
    BakeError::Unknown { path, what, id: id.to_owned(), known: known(names) }
}

fn not_loaded(path: &str, field: &str) -> BakeError {
    let path = if field.is_empty() { format!("{path}/path") } else { format!("{path}/leader/{field}/path") };
    BakeError::NotLoaded { path }
}

/// What holds the particles that follow without springs.
pub(super) fn constraints(bound: &[Bound], rest: &[DVec3]) -> Vec<Constraint> {
    let hard = bound.iter().filter(|of| of.hold == Hold::Hard);
    let constraint = |of: &Bound| Constraint {
        id: None,
        particles: of.particles.clone(),
        start: of.particles.iter().map(|&i| rest[i as usize]).collect(),
        found: None,
        locked: BVec3::TRUE,
        motion: PrescribedMotion::Led(Arc::clone(&of.led)),
    };
    hard.map(constraint).collect()
}

/// The springs that pull the others; `follows` are those that were bound, with whatever constants.
pub(super) fn springs(bound: &[Bound], follows: &[Follow], state: &ParticleState) -> Vec<LedSprings> {
    let soft = bound.iter().zip(follows).filter_map(|(bound, of)| match &of.hold {
        Hold::Springs(springs) => Some((bound, springs)),
        Hold::Hard => None,
    });
    let of = |(bound, springs): (&Bound, &crate::scene::FollowSprings)| {
        let constants = bound.particles.iter().zip(&bound.shares).map(|(&i, share)| {
            let mass = state.masses[i as usize];
            let square = share * springs.stiffness;
            [mass * square, 2.0 * springs.damping * mass * square.sqrt()]
        });
        LedSprings::new(&bound.id, bound.particles.clone(), constants.collect(), Arc::clone(&bound.led))
    };
    soft.map(of).collect()
}

/// What they ask of the time step together.
pub(super) fn step_limit(springs: &[LedSprings], state: &ParticleState) -> StepLimit {
    springs.iter().map(|of| of.step_limit(state)).fold(StepLimit::default(), |sum, of| StepLimit {
        frequency_squared: sum.frequency_squared + of.frequency_squared,
        damping_rate: sum.damping_rate + of.damping_rate,
    })
}

/// From which time of a motion of so many seconds it is played [s]; says where that is past its end.
fn played_from(of: &Follow, length: f64, path: &str, notes: &mut Vec<Note>) -> f64 {
    if of.from > length {
        let text =
            format!("is past the end of the motion, which is {} s long: it stays in its last frame", compact(length));
        notes.push(Note { path: format!("{path}/from"), text, warning: true });
    }
    of.from.min(length)
}
