//! Contact between two bodies of either kind: particles of one against the surface of the other, evaluated at the ends
//! of an outer step, equal and opposite, and given as impulses by the [`super::world`]. It is no force of either body's
//! list.
//!
//! Fibre solids meet by their surfaces ([`solids`]). A two-layer body is the surface of its outer layer, whose
//! particles are points; for it a fibre solid is a heap of balls, one around each particle. What is pushed with a
//! normal force keeps both momenta of the pair. Friction between solids acts where their surfaces meet, with the moment
//! that it has about the particles that take it up ([`lever`]), and keeps them, too; that on a heap of balls acts at
//! the centre of the ball, and so with the lever of its radius (zero for points) against the angular momentum.
//!
//! Bodies that overlap at the start are granted an [`Allowance`]: contact is found as if each touch were less deep, or
//! as if one body stood aside, so far that the two just touch. Standing aside, a push across that way has a lever about
//! the place aside, and the pair's angular momentum changes by it; its linear momentum never does.

mod lever;
mod solids;
mod touch;

pub(super) use touch::{Allowance, Touch};

use lever::Turning;
use solids::{Solid, balls_on_surface};
use touch::Aabb;

use super::body::Body;
use super::forces::pressure::Surface;
use super::forces::{ContactLaw, Grip};
use crate::geometry::closest::{closest_on_segment, closest_on_triangle};
use crate::geometry::neighbours::PointGrid;
use glam::DVec3;
use std::f64::consts::FRAC_1_SQRT_2;

/// Points nearer than this share of the distance to two faces count as between them.
const SAME: f64 = 1e-9;

/// Two particles that touch, or a particle that touches a surface: whether it is one of the second body, its index, and
/// the other's.
pub(super) type TouchKey = (bool, u32, Option<u32>);

/// Adds to the external forces of two bodies what they push on each other with over the next outer step, `dt` [s] after
/// this was last done. What they hold on to is kept as stretches.
pub(super) fn add_body_contact(a: &mut Body, b: &mut Body, allowance: &Allowance, grip: &mut Grip<TouchKey>, dt: f64) {
    let mut law = together(&a.parts().contact, &b.parts().contact);
    if meet_by_surfaces(a, b) {
        law = of_a_side(law);
    }
    let heaps = are_heaps(a, b) && !meet_by_surfaces(a, b);
    let mut held = Vec::new();
    for touch in touches(a, b, &law, allowance) {
        let (one, other) = if touch.of_second { (&mut *b, &mut *a) } else { (&mut *a, &mut *b) };
        let key = (touch.of_second, touch.particle, heaps.then_some(touch.carried_by[0].0));
        let slid = touch.meeting.map_or(dt * touch.velocity, |of| of.slid);
        let stretch = grip.of(key).map_or(DVec3::ZERO, |stretch| stretch + slid);
        let stretch = stretch.reject_from_normalized(touch.normal);
        let force = law.force(touch.gap, touch.normal, touch.velocity, stretch);
        let kept = law.dragged(touch.gap, touch.normal, touch.velocity, stretch);
        held.extend(kept.map(|stretch| (key, stretch)));
        one.add_external_force(touch.particle as usize, force);
        for &(k, w) in &touch.carried_by[..touch.carriers] {
            other.add_external_force(k as usize, -w * force);
        }
        if let Some(meeting) = touch.meeting {
            turn(one, other, &touch, meeting.levers, force);
        }
        share(one, other, law.energy(touch.gap, stretch));
    }
    grip.renew(held);
}

/// Adds the moments that friction has about the particles that take it up: the force on the one acts where the surfaces
/// meet, and so does that on the other.
fn turn(one: &mut Body, other: &mut Body, touch: &Touch, levers: [f64; 2], force: DVec3) {
    let along = force.reject_from_normalized(touch.normal);
    if along == DVec3::ZERO {
        return;
    }
    let face = touch.carried_by.map(|(k, _)| k);
    let around: Vec<u32> =
        one.parts().contact_surface.iter().flat_map(|of| of.around(touch.particle).to_vec()).collect();
    let turned = Turning::of(&around, &one.state().positions);
    let carrying = Turning::of(&face, &other.state().positions);
    // What cannot be turned leaves the whole moment to the other.
    let [near, far] = match (&turned, &carrying) {
        (Some(_), Some(_)) => levers,
        (Some(_), None) => [levers[0] + levers[1], 0.0],
        _ => [0.0, levers[0] + levers[1]],
    };
    let moments = [-near * touch.normal.cross(along), -far * touch.normal.cross(along)];
    let forces = [
        turned.map_or_else(Vec::new, |turning| turning.forces(moments[0], &one.state().positions)),
        carrying.map_or_else(Vec::new, |turning| turning.forces(moments[1], &other.state().positions)),
    ];
    for (body, forces) in [one, other].into_iter().zip(forces) {
        for (k, force) in forces {
            body.add_external_force(k as usize, force);
        }
    }
}

/// Where two bodies touch, in a fixed order.
pub(super) fn touches(a: &Body, b: &Body, law: &ContactLaw, allowance: &Allowance) -> Vec<Touch> {
    let solids = solids(a, b);
    let reach = solids.map_or(law.radius, |[a, b]| law.radius.max(a.surface.largest + b.surface.largest));
    let Some(overlap) = bounds_overlap(a, b, reach, allowance.aside) else { return Vec::new() };
    let mut found = Vec::new();
    if are_heaps(a, b) && solids.is_none() {
        balls_on_balls(a, b, law, &overlap, allowance, &mut found);
        return found;
    }
    let beside = Aabb { min: overlap.min - allowance.aside, max: overlap.max - allowance.aside };
    let second = allowance.seen_by_second();
    let first = if let Some([a, b]) = solids {
        balls_on_surface(a, b, law, &overlap, allowance, &mut found);
        let first = found.len();
        balls_on_surface(b, a, law, &beside, &second, &mut found);
        first
    } else {
        points_on_surface(a, b, law, &overlap, allowance, &mut found);
        let first = found.len();
        points_on_surface(b, a, law, &beside, &second, &mut found);
        first
    };
    found[first..].iter_mut().for_each(|touch| touch.of_second = true);
    found
}

/// Two fibre solids that meet by their surfaces; none of other bodies.
fn solids<'a>(a: &'a Body, b: &'a Body) -> Option<[Solid<'a>; 2]> {
    Some([Solid::of(a)?, Solid::of(b)?])
}

/// Whether two bodies touch as heaps of balls, and not by points and surfaces.
pub(super) fn are_heaps(a: &Body, b: &Body) -> bool {
    match (outer_surface(a), outer_surface(b)) {
        (None, None) => true,
        (Some(surface), None) | (None, Some(surface)) => !matches!(surface, OuterSurface::Faces(_)),
        _ => false,
    }
}

/// The law of the particles of one of two bodies that meet by their surfaces, where those of the other push as well.
/// Along the surface both sides together are as stiff as two balls; across it they are as stiff as one against a wall,
/// and as near to critical damping as two balls.
fn of_a_side(law: ContactLaw) -> ContactLaw {
    ContactLaw { damping: FRAC_1_SQRT_2 * law.damping, sticking: 0.5 * law.sticking, holding: 0.5 * law.holding, ..law }
}

/// Whether two bodies are fibre solids that meet by their surfaces.
pub(super) fn meet_by_surfaces(a: &Body, b: &Body) -> bool {
    solids(a, b).is_some()
}

/// Stiffness [N/m] with which particles of two bodies push on each other.
pub(crate) fn stiffness_between(a: &ContactLaw, b: &ContactLaw) -> f64 {
    together(a, b).stiffness
}

/// Two contacts one behind the other. Friction is the geometric mean.
pub(super) fn together(a: &ContactLaw, b: &ContactLaw) -> ContactLaw {
    let series = |a: f64, b: f64| if a + b > 0.0 { a * b / (a + b) } else { 0.0 };
    ContactLaw {
        radius: a.radius + b.radius,
        stiffness: series(a.stiffness, b.stiffness),
        damping: series(a.damping, b.damping),
        friction: (a.friction * b.friction).sqrt(),
        sticking: series(a.sticking, b.sticking),
        holding: series(a.holding, b.holding),
    }
}

/// Where the bounding boxes of two bodies overlap, when each is `reach` [m] larger than its particles and the first
/// stands `aside` [m].
fn bounds_overlap(a: &Body, b: &Body, reach: f64, aside: DVec3) -> Option<Aabb> {
    let bounds = |body: &Body| {
        let start = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        let (min, max) = body.state().positions.iter().fold(start, |(l, m), &x| (l.min(x), m.max(x)));
        (min - reach, max + reach)
    };
    let ((min_a, max_a), (min_b, max_b)) = (bounds(a), bounds(b));
    let overlap = Aabb { min: (min_a + aside).max(min_b), max: (max_a + aside).min(max_b) };
    overlap.min.cmple(overlap.max).all().then_some(overlap)
}

/// What a two-layer body shows to others.
pub(super) enum OuterSurface {
    /// No surface: a segment.
    Bare,
    /// Edges in a plane.
    Polygon(std::sync::Arc<[[u32; 2]]>, DVec3),
    /// Faces.
    Faces(std::sync::Arc<[[u32; 3]]>),
}

/// What a body shows to others; none of a fibre solid.
pub(super) fn outer_surface(body: &Body) -> Option<OuterSurface> {
    let layers = body.parts().layers.as_ref()?;
    Some(match &layers.outer_surface {
        None => OuterSurface::Bare,
        Some(Surface::Polygon { edges, normal }) => OuterSurface::Polygon(edges.clone(), *normal),
        Some(Surface::Faces(faces)) => OuterSurface::Faces(faces.clone()),
    })
}

/// Particles of a body that touch others.
pub(super) fn touching_count(body: &Body) -> usize {
    body.parts().layers.as_ref().map_or(body.state().len(), |layers| layers.outer)
}

/// Particles of a body that touch others, in a box while the body stands `aside` [m].
fn touching(body: &Body, overlap: &Aabb, aside: DVec3) -> Vec<u32> {
    let positions = &body.state().positions;
    (0..touching_count(body) as u32).filter(|&i| overlap.contains(positions[i as usize] + aside)).collect()
}

fn balls_on_balls(a: &Body, b: &Body, law: &ContactLaw, overlap: &Aabb, allowance: &Allowance, found: &mut Vec<Touch>) {
    let (of_a, of_b) = (touching(a, overlap, allowance.aside), touching(b, overlap, DVec3::ZERO));
    if of_a.is_empty() || of_b.is_empty() || law.radius <= 0.0 {
        return;
    }
    let places: Vec<DVec3> = of_b.iter().map(|&j| b.state().positions[j as usize]).collect();
    let grid = PointGrid::new(&places, law.radius);
    for i in of_a {
        let place = a.state().positions[i as usize] + allowance.aside;
        for k in grid.within(place) {
            let j = of_b[k as usize];
            let line = place - b.state().positions[j as usize];
            let Some(normal) = line.try_normalize() else { continue };
            let velocity = a.state().velocities[i as usize] - b.state().velocities[j as usize];
            found.push(Touch {
                of_second: false,
                particle: i,
                carried_by: [(j, 1.0), (0, 0.0), (0, 0.0)],
                carriers: 1,
                gap: line.length() + allowance.depth,
                normal,
                velocity: velocity + allowance.aside_rate + allowance.depth_rate * normal,
                meeting: None,
            });
        }
    }
}

/// The place on a surface that is closest to a point: what it hangs on, and which way is out.
struct ClosestPoint<const N: usize> {
    particles: [u32; N],
    weights: [f64; N],
    at: DVec3,
    distance_squared: f64,
    /// Sum of the normals of all pieces that are equally near.
    outward: DVec3,
}

impl<const N: usize> ClosestPoint<N> {
    /// The nearer of two places; of equal ones both normals count.
    fn nearer(best: Option<Self>, next: Self) -> Self {
        match best {
            Some(best) if best.distance_squared < next.distance_squared * (1.0 - SAME) => best,
            Some(mut best) if best.distance_squared <= next.distance_squared * (1.0 + SAME) => {
                best.outward += next.outward;
                best
            }
            _ => next,
        }
    }
}

fn points_on_surface(
    points: &Body,
    surface: &Body,
    law: &ContactLaw,
    overlap: &Aabb,
    allowance: &Allowance,
    found: &mut Vec<Touch>,
) {
    let chosen = touching(points, overlap, allowance.aside);
    let place = |i: u32| points.state().positions[i as usize] + allowance.aside;
    match outer_surface(surface) {
        Some(OuterSurface::Faces(faces)) => {
            for i in chosen {
                let closest = nearest_on_faces(place(i), &surface.state().positions, &faces);
                found.extend(closest.and_then(|closest| touch([points, surface], law, i, &closest, allowance)));
            }
        }
        Some(OuterSurface::Polygon(edges, normal)) => {
            // Two rings meet in their common plane only.
            let origin = surface.state().positions.first().copied().unwrap_or_default();
            let flat = |x: DVec3| (x - origin).dot(normal).abs() <= 1e-6 * surface.parts().reach;
            let flat_points = chosen.iter().all(|&i| flat(place(i)));
            if !matches!(outer_surface(points), Some(OuterSurface::Polygon(..))) || !flat_points {
                return;
            }
            for i in chosen {
                let closest = nearest_on_edges(place(i), &surface.state().positions, &edges, normal);
                found.extend(closest.and_then(|closest| touch([points, surface], law, i, &closest, allowance)));
            }
        }
        _ => {}
    }
}

/// A point and the place on a surface that is nearest to it, if they are so near that they push each other apart.
fn touch<const N: usize>(
    [points, surface]: [&Body; 2],
    law: &ContactLaw,
    i: u32,
    closest: &ClosestPoint<N>,
    allowance: &Allowance,
) -> Option<Touch> {
    let line = points.state().positions[i as usize] + allowance.aside - closest.at;
    let outside = line.dot(closest.outward) >= 0.0;
    let distance = closest.distance_squared.sqrt();
    let along = line.try_normalize().map_or(closest.outward.normalize_or_zero(), |n| if outside { n } else { -n });
    let gap = if outside { distance } else { -distance } + allowance.depth;
    if gap >= law.radius {
        return None;
    }
    let velocities = &surface.state().velocities;
    let moving: DVec3 = closest.particles.iter().zip(closest.weights).map(|(&k, w)| w * velocities[k as usize]).sum();
    let velocity = points.state().velocities[i as usize] - moving;
    let mut carried_by = [(0, 0.0); 3];
    for (carrier, (&k, w)) in carried_by.iter_mut().zip(closest.particles.iter().zip(closest.weights)) {
        *carrier = (k, w);
    }
    Some(Touch {
        of_second: false,
        particle: i,
        carried_by,
        carriers: N,
        gap,
        normal: along,
        velocity: velocity + allowance.aside_rate + allowance.depth_rate * along,
        meeting: None,
    })
}

/// The energy [J] of a contact is half the one's and half the other's.
fn share(a: &mut Body, b: &mut Body, energy: f64) {
    a.add_contact_energy(0.5 * energy);
    b.add_contact_energy(0.5 * energy);
}

fn nearest_on_faces(x: DVec3, positions: &[DVec3], faces: &[[u32; 3]]) -> Option<ClosestPoint<3>> {
    let mut best: Option<ClosestPoint<3>> = None;
    for face in faces {
        let [a, b, c] = face.map(|i| positions[i as usize]);
        // No point of the face is nearer than its first corner less its longest side.
        if let Some(best) = &best {
            let longest = (b - a).length_squared().max((c - a).length_squared());
            if (x - a).length_squared() > 2.0 * (best.distance_squared * (1.0 + SAME) + longest) {
                continue;
            }
        }
        let weights = closest_on_triangle(x, [a, b, c]);
        let at = weights[0] * a + weights[1] * b + weights[2] * c;
        let outward = (b - a).cross(c - a).normalize_or_zero();
        let closest = ClosestPoint { particles: *face, weights, at, distance_squared: x.distance_squared(at), outward };
        best = Some(ClosestPoint::nearer(best, closest));
    }
    best
}

fn nearest_on_edges(x: DVec3, positions: &[DVec3], edges: &[[u32; 2]], normal: DVec3) -> Option<ClosestPoint<2>> {
    let mut best = None;
    for edge in edges {
        let [a, b] = edge.map(|i| positions[i as usize]);
        let weights = closest_on_segment(x, [a, b]);
        let at = weights[0] * a + weights[1] * b;
        let outward = (b - a).cross(normal).normalize_or_zero();
        let closest = ClosestPoint { particles: *edge, weights, at, distance_squared: x.distance_squared(at), outward };
        best = Some(ClosestPoint::nearer(best, closest));
    }
    best
}
