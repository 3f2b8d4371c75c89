//! What overlaps when a motion begins, how far, and how it is eased apart (see [`super::easing`]).
//!
//! From a plane or a panel the way out is known. Of two bodies the shorter of the ways out is taken, among some
//! directions: how far the first has to stand aside until nothing of it lies in the other. A touch that is everywhere
//! shallow while every way out is long, as of a rod in a tight tube, is granted its depth instead.

use super::body::Body;
use super::body_contact::{Allowance, stiffness_between, together, touches};
use super::eased_overlap::{EasedOverlap, GENTLE};
use super::forces::Plane;
use super::panel::Panel;
use super::way_out::way_out;
use glam::DVec3;

/// What a body overlaps with.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Against {
    /// A plane of the room, by its unit normal into the free side.
    Plane(DVec3),
    /// A panel, by its index.
    Panel(usize),
    /// A collider, by its index.
    Collider(usize),
    /// Another body, by its index.
    Body(usize),
}

/// An overlap at the start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Overlap {
    /// Index of the body.
    pub body: usize,
    /// What it overlaps with.
    pub against: Against,
    /// How the body would have to be moved so that it does not overlap [m].
    pub out: DVec3,
    /// Particles of the body that lie inside.
    pub inside: usize,
    /// Middle of these [m].
    pub at: DVec3,
    /// How it is eased apart; none where contact is too soft to throw anything.
    pub easing: Option<EasedOverlap>,
}

/// How two bodies are eased apart.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct EasedPair {
    pub(super) first: usize,
    pub(super) second: usize,
    /// Unit vector along which the first stands aside; none where each touch is granted its depth.
    pub(super) along: Option<DVec3>,
    pub(super) easing: EasedOverlap,
}

impl EasedPair {
    /// What the pair is granted at a time [s].
    pub(super) fn allowance(&self, time: f64) -> Allowance {
        let (left, rate) = self.easing.at(time);
        match self.along {
            Some(along) => Allowance { aside: left * along, aside_rate: rate * along, ..Allowance::default() },
            None => Allowance { depth: left, depth_rate: rate, ..Allowance::default() },
        }
    }
}

/// Share of a body's extent that is a doubtful depth however soft the contact is.
const DEEP: f64 = 0.25;

/// Depth [m] up to which a body counts as touching only: a share of the radius of a particle, or of a two-layer body's.
fn touching_depth(body: &Body) -> f64 {
    let parts = body.parts();
    if parts.layers.is_some() { 0.01 * parts.reach } else { 0.1 * parts.contact.radius }
}

/// Whether a particle can move along a direction.
fn movable(body: &Body, along: DVec3) -> Vec<bool> {
    let mut field = vec![along; body.state().len()];
    for constraint in &body.parts().constraints {
        constraint.mask(&mut field);
    }
    field.into_iter().map(|left| left.length_squared() > 0.5).collect()
}

/// Extent of a body along a direction [m].
fn extent(body: &Body, along: DVec3) -> f64 {
    let places = body.state().positions.iter().map(|x| x.dot(along));
    let (least, most) = places.fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), x| (least.min(x), most.max(x)));
    most - least + 2.0 * body.parts().contact.radius
}

/// The easing of an overlap of `depth` [m] that holds `energy` [J], and whether the overlap is worth a word. A contact
/// that holds less than the work of easing out `mass` [kg] does not throw it.
fn eased(depth: f64, energy: f64, mass: f64, gravity: DVec3, extent: f64, time: f64) -> (Option<EasedOverlap>, bool) {
    let payable = energy > mass * (gravity.length() + GENTLE) * depth;
    (payable.then(|| EasedOverlap::new(depth, energy, time)), payable || depth > DEEP * extent)
}

/// A body behind something flat: `depth_of` gives how far a particle's centre is behind it [m], where it is before it
/// or beside it nothing. `out` is the way to where it belongs.
fn behind(
    body: &Body,
    out: DVec3,
    depth_of: impl Fn(DVec3) -> Option<f64>,
    gravity: DVec3,
    time: f64,
) -> Option<(f64, usize, DVec3, Option<EasedOverlap>)> {
    let law = &body.parts().contact;
    let (mut depth, mut energy, mut inside, mut sum) = (0.0_f64, 0.0, 0, DVec3::ZERO);
    let movable = movable(body, out);
    for (&x, _) in body.state().positions.iter().zip(movable).filter(|(_, movable)| *movable) {
        let Some(behind) = depth_of(x) else { continue };
        energy += law.energy(-behind, DVec3::ZERO);
        let sunk = behind + law.radius;
        depth = depth.max(sunk);
        if sunk > touching_depth(body) {
            inside += 1;
            sum += x;
        }
    }
    if inside == 0 || law.stiffness <= 0.0 {
        return None;
    }
    let (easing, doubtful) = eased(depth, energy, body.state().mass(), gravity, extent(body, out), time);
    doubtful.then(|| (depth, inside, sum / inside as f64, easing))
}

/// How a body overlaps with a plane of the room at a time [s].
pub(super) fn with_plane(index: usize, body: &Body, plane: &Plane, gravity: DVec3, time: f64) -> Option<Overlap> {
    let depth_of = |x: DVec3| Some(-(x - plane.point).dot(plane.normal));
    let (depth, inside, at, easing) = behind(body, plane.normal, depth_of, gravity, time)?;
    let against = Against::Plane(plane.normal);
    Some(Overlap { body: index, against, out: depth * plane.normal, inside, at, easing })
}

/// How a body overlaps with a panel at a time [s]: some of it is pressed, and all that is above its underside counts.
pub(super) fn with_panel(
    index: usize,
    body: &Body,
    (number, panel): (usize, &Panel),
    gravity: DVec3,
    time: f64,
) -> Option<Overlap> {
    let free = touching_depth(body) - body.parts().contact.radius;
    let pressed =
        |x: &DVec3| panel.is_below_or_above(*x) && (free..=body.parts().reach).contains(&(x.y - panel.height));
    if !body.state().positions.iter().any(pressed) {
        return None;
    }
    let depth_of = |x: DVec3| panel.is_below_or_above(x).then_some(x.y - panel.height);
    let (depth, inside, at, easing) = behind(body, DVec3::NEG_Y, depth_of, gravity, time)?;
    let out = DVec3::NEG_Y * depth;
    Some(Overlap { body: index, against: Against::Panel(number), out, inside, at, easing })
}

/// How a body overlaps with a collider at a time [s]. The way out is that of the particle that lies deepest.
pub(super) fn with_collider(index: usize, body: &Body, number: usize, gravity: DVec3, time: f64) -> Option<Overlap> {
    let contact = body.collider_contact()?;
    let (collider, law) = (&contact.colliders()[number], contact.law(number));
    let pose = collider.pose(time);
    let [min, max] = collider.bounds(&pose, law.radius);
    // What is kept off a shell is eased off it; a body that lies across one is not torn out to either side.
    let slack = touching_depth(body) + law.radius - body.parts().contact.radius;
    let (mut way, mut depth, mut energy, mut inside, mut sum) = (DVec3::ZERO, 0.0, 0.0, 0, DVec3::ZERO);
    for &x in &body.state().positions {
        if !(x.cmpge(min).all() && x.cmple(max).all()) {
            continue;
        }
        let Some(foot) = collider.obstacle.foot(pose.to_local(x), law.radius, f64::INFINITY) else { continue };
        energy += law.energy(foot.gap, DVec3::ZERO);
        let sunk = law.radius - foot.gap;
        if sunk > depth {
            (depth, way) = (sunk, pose.rotation * foot.normal);
        }
        if sunk > slack {
            inside += 1;
            sum += x;
        }
    }
    if inside == 0 || law.stiffness <= 0.0 {
        return None;
    }
    let (easing, doubtful) = eased(depth, energy, body.state().mass(), gravity, extent(body, way), time);
    let against = Against::Collider(number);
    let at = sum / inside as f64;
    doubtful.then(|| Overlap { body: index, against, out: depth * way, inside, at, easing })
}

/// How two bodies overlap at a time [s], the second's place in the world being what is asked for, and how they are
/// eased apart.
pub(super) fn of_bodies(
    [first, second]: [usize; 2],
    bodies: &[Body],
    gravity: DVec3,
    time: f64,
) -> Option<(Overlap, Option<EasedPair>)> {
    let (a, b) = (&bodies[first], &bodies[second]);
    if stiffness_between(&a.parts().contact, &b.parts().contact) <= 0.0 {
        return None;
    }
    let slack = touching_depth(a).min(touching_depth(b));
    let way = way_out(a, b, slack)?;
    let law = together(&a.parts().contact, &b.parts().contact);
    let energy_aside = |aside: DVec3| -> f64 {
        let touches = touches(a, b, &law, &Allowance { aside, ..Allowance::default() });
        touches.iter().map(|touch| law.energy(touch.gap, DVec3::ZERO)).sum()
    };
    let (along, depth, energy) = if way.is_shallow {
        (None, way.depth, energy_aside(DVec3::ZERO))
    } else {
        // What has to be overcome to press one into the other from outside is what the overlap holds.
        const SAMPLES: u32 = 8;
        let at = |k: u32| energy_aside(way.along * (way.distance * f64::from(k) / f64::from(SAMPLES)));
        (Some(way.along), way.distance, (0..SAMPLES).map(at).fold(0.0, f64::max))
    };
    let least = extent(a, way.along).min(extent(b, way.along));
    let mass = a.state().mass().min(b.state().mass());
    let (easing, doubtful) = eased(depth, energy, mass, gravity, least, time);
    if !doubtful {
        return None;
    }
    let out = -way.along * way.distance;
    let overlap = Overlap { body: second, against: Against::Body(first), out, inside: way.inside, at: way.at, easing };
    Some((overlap, easing.map(|easing| EasedPair { first, second, along, easing })))
}
