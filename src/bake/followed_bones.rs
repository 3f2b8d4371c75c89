//! The bones that bodies follow, as the window shows them.

use super::follows::{frame_of, playing, to_world};
use crate::geometry::skeleton::Clip;
use crate::scene::{AnyBody, Assets, Leader};
use glam::DVec3;

/// The bones that a body follows without or with springs, as they are at a time [s]; none of what is not loaded.
pub(crate) fn followed_bones(body: AnyBody<'_>, assets: &Assets, time: f64) -> Vec<[DVec3; 2]> {
    let mut found: Vec<[DVec3; 2]> = Vec::new();
    for of in body.follows() {
        let Leader::Skeleton(leader) = &of.leader else { continue };
        let Some(skeleton) = assets.skeleton(&leader.path) else { continue };
        let is_meant = |clip: &&Clip| leader.animation.as_ref().is_none_or(|name| *name == clip.name);
        let Some((clip, [first, last])) =
            skeleton.clips.iter().enumerate().find(|(_, clip)| is_meant(clip)).map(|(index, clip)| (index, clip.span))
        else {
            continue;
        };
        let length = last - first;
        let worlds = skeleton.worlds(clip, playing(of, [of.from.min(length), length]).at(time));
        let frame = to_world(body.placement()) * frame_of(&of.leader);
        let is_chosen = |name: &String| leader.joints.is_empty() || leader.joints.contains(name);
        let chosen = skeleton.joints.iter().enumerate().filter(|(_, joint)| is_chosen(&joint.name));
        for bone in chosen.flat_map(|(joint, _)| skeleton.bones(joint, &worlds)) {
            let bone = bone.map(|end| frame.transform_point3(end));
            if !found.contains(&bone) {
                found.push(bone);
            }
        }
    }
    found
}
