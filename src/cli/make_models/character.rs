//! A plump little figure with long ears, on a skeleton of seven joints, that bows to both sides and waves. Ears and
//! belly have no bones.

use super::field::{Stalk, smooth_union};
use crate::geometry::closest::closest_on_segment;
use crate::geometry::isosurface::isosurface;
use crate::geometry::model::Model;
use crate::geometry::skeleton::{Channel, Clip, Joint, Moves, Node, Parts, Place, Skeleton, SkinMesh};
use crate::geometry::track::{Between, Track};
use glam::{DMat4, DQuat, DVec3, DVec4};

/// Size of the cells on which it is meshed [m].
const CELL: f64 = 7.5e-3;

/// Joints with what they hang on and where they are [m].
const JOINTS: [(&str, Option<usize>, [f64; 3]); 7] = [
    ("Hips", None, [0.0, 0.06, 0.0]),
    ("Spine", Some(0), [0.0, 0.125, -0.01]),
    ("Head", Some(1), [0.0, 0.215, 0.0]),
    ("Arm.L", Some(1), [0.06, 0.168, 0.0]),
    ("Hand.L", Some(3), [0.135, 0.15, 0.0]),
    ("Arm.R", Some(1), [-0.06, 0.168, 0.0]),
    ("Hand.R", Some(5), [-0.135, 0.15, 0.0]),
];

/// Over how much distance [m] the hold of a bone gives way to that of the next.
const BLEND: f64 = 0.012;

/// A share of a joint below which it is left out.
const LEAST_SHARE: f64 = 0.02;

/// The figure and its skeleton.
pub(super) fn character() -> (Model, Skeleton) {
    let model = isosurface(&field, DVec3::new(-0.19, -0.02, -0.13), DVec3::new(0.19, 0.43, 0.13), CELL);
    let held = model.positions.iter().map(|&point| shares(point)).collect();
    let skin = SkinMesh { points: model.positions.clone(), triangles: model.triangles.clone(), held };
    let at = |joint: usize| DVec3::from_array(JOINTS[joint].2);
    let node = |(joint, (_, parent, _)): (usize, &(&str, Option<usize>, [f64; 3]))| {
        let shift = at(joint) - parent.map_or(DVec3::ZERO, at);
        Node { parent: *parent, place: Place::Parts(Parts { shift, turn: DQuat::IDENTITY, scale: DVec3::ONE }) }
    };
    let joint = |(node, (name, ..)): (usize, &(&str, Option<usize>, [f64; 3]))| Joint {
        name: (*name).to_owned(),
        node,
        inverse_bind: DMat4::from_translation(-at(node)),
    };
    let skeleton = Skeleton {
        nodes: JOINTS.iter().enumerate().map(node).collect(),
        joints: JOINTS.iter().enumerate().map(joint).collect(),
        clips: vec![greeting()],
        skin,
    };
    (model, skeleton)
}

/// Signed distance of the figure [m].
fn field(p: DVec3) -> f64 {
    let ball = |center: [f64; 3], radii: [f64; 3]| {
        let (at, radii) = (p - DVec3::from_array(center), DVec3::from_array(radii));
        // A distance near the surface: the value of the ellipsoid's form over the length of its slope.
        let (value, slope) = ((at / radii).length(), (at / (radii * radii)).length());
        if slope == 0.0 { -radii.min_element() } else { value * (value - 1.0) / slope }
    };
    let mirrored = DVec3::new(p.x.abs(), p.y, p.z);
    let stalk = |from: [f64; 3], to: [f64; 3], radius: [f64; 2]| {
        let (from, to) = (DVec3::from_array(from), DVec3::from_array(to));
        Stalk::new(move |t| from.lerp(to, t), move |t| radius[0] + t * (radius[1] - radius[0])).distance(mirrored)
    };
    let belly = ball([0.0, 0.1, 0.012], [0.082, 0.086, 0.084]);
    let chest = ball([0.0, 0.15, 0.0], [0.06, 0.055, 0.055]);
    let head = ball([0.0, 0.24, 0.008], [0.062, 0.055, 0.056]);
    let arm = stalk([0.05, 0.17, 0.0], [0.145, 0.147, 0.0], [0.023, 0.025]);
    let leg = stalk([0.045, 0.06, 0.0], [0.05, 0.026, 0.03], [0.034, 0.027]);
    let ear = stalk([0.028, 0.28, 0.0], [0.05, 0.4, -0.005], [0.021, 0.018]);
    let body = smooth_union(smooth_union(belly, chest, 0.03), head, 0.022);
    let limbs = smooth_union(smooth_union(body, arm, 0.02), leg, 0.02);
    smooth_union(limbs, ear, 0.015)
}

/// The bones, each with the joint that moves it: what hangs on the head and the hands goes on beyond them.
const BONES: [(usize, [f64; 3], [f64; 3]); 7] = [
    (0, [0.0, 0.03, 0.0], [0.0, 0.125, -0.01]),
    (1, [0.0, 0.125, -0.01], [0.0, 0.215, 0.0]),
    (2, [0.0, 0.215, 0.0], [0.0, 0.42, 0.0]),
    (3, [0.06, 0.168, 0.0], [0.135, 0.15, 0.0]),
    (4, [0.135, 0.15, 0.0], [0.18, 0.139, 0.0]),
    (5, [-0.06, 0.168, 0.0], [-0.135, 0.15, 0.0]),
    (6, [-0.135, 0.15, 0.0], [-0.18, 0.139, 0.0]),
];

/// Joints that hold a point of the skin, by how near their bones are.
fn shares(at: DVec3) -> Vec<(u32, f64)> {
    let distance = |(_, from, to): &(usize, [f64; 3], [f64; 3])| {
        let ends = [from, to].map(|end| DVec3::from_array(*end));
        let weights = closest_on_segment(at, ends);
        at.distance(weights[0] * ends[0] + weights[1] * ends[1])
    };
    let distances: Vec<f64> = BONES.iter().map(distance).collect();
    let least = distances.iter().copied().fold(f64::INFINITY, f64::min);
    let weight = |distance: &f64| (-(distance - least) / (0.3 * BLEND)).exp();
    let mut shares: Vec<(u32, f64)> =
        BONES.iter().zip(&distances).map(|(bone, distance)| (bone.0 as u32, weight(distance))).collect();
    shares.sort_by(|a, b| b.1.total_cmp(&a.1));
    shares.truncate(4);
    shares.retain(|(_, share)| *share > LEAST_SHARE);
    let sum: f64 = shares.iter().map(|(_, share)| share).sum();
    for (_, share) in &mut shares {
        *share /= sum;
    }
    shares.sort_by_key(|(joint, _)| *joint);
    shares
}

/// Two bows with a wave, from arms held out and back to them. Every key is a rest, and the last is the first.
fn greeting() -> Clip {
    // Degrees about z, to the figure's right where positive, at every key.
    let times = [0.0, 0.5, 1.0, 1.5, 2.0];
    let turns: [(usize, [f64; 5]); 6] = [
        (0, [0.0, 4.0, -4.0, 4.0, 0.0]),
        (1, [0.0, 14.0, -14.0, 10.0, 0.0]),
        (2, [0.0, 12.0, -12.0, 14.0, 0.0]),
        (3, [20.0, 50.0, 10.0, 45.0, 20.0]),
        (4, [0.0, 25.0, -5.0, 30.0, 0.0]),
        (5, [-20.0, -10.0, -50.0, -5.0, -20.0]),
    ];
    let keyed = |values: Vec<DVec4>| Track {
        times: times.to_vec(),
        between: Between::Cubic(vec![[DVec4::ZERO; 2]; values.len()]),
        values,
    };
    let turn = |(node, degrees): &(usize, [f64; 5])| {
        let values = degrees.iter().map(|degrees| DVec4::from(DQuat::from_rotation_z(degrees.to_radians())));
        Channel { node: *node, moves: Moves::Turn, track: keyed(values.collect()) }
    };
    let hips = DVec3::from_array(JOINTS[0].2);
    let sway = [0.0, -0.02, 0.02, -0.015, 0.0].map(|x| (hips + x * DVec3::X).extend(0.0));
    let shift = Channel { node: 0, moves: Moves::Shift, track: keyed(sway.to_vec()) };
    let channels = turns.iter().map(turn).chain([shift]).collect();
    Clip { name: "Greeting".to_owned(), channels, span: [times[0], times[times.len() - 1]] }
}
