//! Contact between two bodies of either kind: particles of one against the surface of the other, evaluated at the ends
//! of an outer step, equal and opposite, and given as impulses by the [`super::world`]. It is no force of either body's
//! list.
//!
//! A fibre solid is a heap of balls, one around each particle. A two-layer body is the surface of its outer layer,
//! whose particles are points. What is pushed with a normal force keeps both momenta of the pair; friction acts at the
//! particle's centre, and so with the lever of its radius (zero for points) against the angular one.
//!
//! Bodies that overlap at the start are granted an [`Allowance`]: contact is found as if each touch were less deep, or
//! as if one body stood aside, so far that the two just touch. Standing aside, a push across that way has a lever about
//! the place aside, and the pair's angular momentum changes by it; its linear momentum never does.

use super::body::Body;
use super::forces::pressure::Surface;
use super::forces::{ContactLaw, Grip};
use crate::geometry::closest::{closest_on_segment, closest_on_triangle};
use crate::geometry::neighbours::PointGrid;
use glam::DVec3;

/// Points nearer than this share of the distance to two faces count as between them.
const SAME: f64 = 1e-9;

/// What two bodies that overlapped at the start are still granted.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Allowance {
    /// How far the first body stands aside of where it is [m], as far as contact is concerned.
    pub(super) aside: DVec3,
    /// Rate of that [m/s].
    pub(super) aside_rate: DVec3,
    /// Depth [m] that every touch is granted.
    pub(super) depth: f64,
    /// Rate of that [m/s].
    pub(super) depth_rate: f64,
}

impl Allowance {
    /// The same, seen from the second body: it stands aside the other way.
    fn seen_by_second(self) -> Self {
        Self { aside: -self.aside, aside_rate: -self.aside_rate, ..self }
    }
}

/// A particle of one body that touches the other.
#[derive(Clone, Copy, Debug)]
pub(super) struct Touch {
    /// Whether the particle is one of the second body.
    of_second: bool,
    particle: u32,
    /// What it touches: particles of the other body and their weights, of which the first `carriers` count.
    carried_by: [(u32, f64); 3],
    carriers: usize,
    /// Distance [m], granted depth included.
    pub(super) gap: f64,
    /// Unit vector from what is touched to the particle.
    pub(super) normal: DVec3,
    velocity: DVec3,
}

/// Two particles that touch, or a particle that touches a surface: whether it is one of the second body, its index, and
/// the other's.
pub(super) type TouchKey = (bool, u32, Option<u32>);

/// Adds to the external forces of two bodies what they push on each other with over the next outer step, `dt` [s] after
/// this was last done. What they hold on to is kept as stretches.
pub(super) fn add_body_contact(a: &mut Body, b: &mut Body, allowance: &Allowance, grip: &mut Grip<TouchKey>, dt: f64) {
    let law = together(&a.parts().contact, &b.parts().contact);
    let heaps = are_heaps(a, b);
    let mut held = Vec::new();
    for touch in touches(a, b, &law, allowance) {
        let (one, other) = if touch.of_second { (&mut *b, &mut *a) } else { (&mut *a, &mut *b) };
        let key = (touch.of_second, touch.particle, heaps.then_some(touch.carried_by[0].0));
        let stretch = grip.of(key).map_or(DVec3::ZERO, |stretch| stretch + dt * touch.velocity);
        let stretch = stretch.reject_from_normalized(touch.normal);
        let force = law.force(touch.gap, touch.normal, touch.velocity, stretch);
        let kept = law.dragged(touch.gap, touch.normal, touch.velocity, stretch);
        held.extend(kept.map(|stretch| (key, stretch)));
        one.add_external_force(touch.particle as usize, force);
        for &(k, w) in &touch.carried_by[..touch.carriers] {
            other.add_external_force(k as usize, -w * force);
        }
        share(one, other, law.energy(touch.gap, stretch));
    }
    grip.renew(held);
}

/// Where two bodies touch, in a fixed order.
pub(super) fn touches(a: &Body, b: &Body, law: &ContactLaw, allowance: &Allowance) -> Vec<Touch> {
    let Some(overlap) = bounds_overlap(a, b, law.radius, allowance.aside) else { return Vec::new() };
    let mut found = Vec::new();
    if are_heaps(a, b) {
        balls_on_balls(a, b, law, &overlap, allowance, &mut found);
    } else {
        points_on_surface(a, b, law, &overlap, allowance, &mut found);
        let first = found.len();
        let beside = Aabb { min: overlap.min - allowance.aside, max: overlap.max - allowance.aside };
        points_on_surface(b, a, law, &beside, &allowance.seen_by_second(), &mut found);
        found[first..].iter_mut().for_each(|touch| touch.of_second = true);
    }
    found
}

/// Whether two bodies touch as heaps of balls, and not by points and surfaces.
pub(super) fn are_heaps(a: &Body, b: &Body) -> bool {
    match (outer_surface(a), outer_surface(b)) {
        (None, None) => true,
        (Some(surface), None) | (None, Some(surface)) => !matches!(surface, OuterSurface::Faces(_)),
        _ => false,
    }
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

/// A box along the world's axes.
struct Aabb {
    min: DVec3,
    max: DVec3,
}

impl Aabb {
    fn contains(&self, x: DVec3) -> bool {
        x.cmpge(self.min).all() && x.cmple(self.max).all()
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
