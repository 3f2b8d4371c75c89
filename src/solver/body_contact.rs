//! Contact between two bodies of either kind: particles of one against the surface of the other, evaluated at the ends
//! of an outer step, equal and opposite, and given as impulses by the [`super::world`]. It is no force of either body's
//! list.
//!
//! A fibre solid is a heap of balls, one around each particle. A two-layer body is the surface of its outer layer, whose
//! particles are points. What is pushed with a normal force keeps both momenta of the pair; friction acts at the
//! particle's centre, and so with the lever of its radius (zero for points) against the angular one.

use super::body::Body;
use super::forces::ContactLaw;
use super::forces::pressure::Surface;
use crate::geometry::closest::{closest_on_segment, closest_on_triangle};
use crate::geometry::neighbours::PointGrid;
use glam::DVec3;

/// Points nearer than this share of the distance to two faces count as between them.
const SAME: f64 = 1e-9;

/// Adds to the external forces of two bodies what they push on each other with over the next outer step.
pub(super) fn add_body_contact(a: &mut Body, b: &mut Body) {
    let law = together(&a.parts().contact, &b.parts().contact);
    let Some(overlap) = bounds_overlap(a, b, law.radius) else { return };
    match (outer_surface(a), outer_surface(b)) {
        (None, None) => balls_on_balls(a, b, &law, &overlap),
        (Some(OuterSurface::Bare | OuterSurface::Polygon(..)), None)
        | (None, Some(OuterSurface::Bare | OuterSurface::Polygon(..))) => {
            balls_on_balls(a, b, &law, &overlap);
        }
        _ => {
            points_on_surface(a, b, &law, &overlap);
            points_on_surface(b, a, &law, &overlap);
        }
    }
}

/// Stiffness [N/m] with which particles of two bodies push on each other.
pub(crate) fn stiffness_between(a: &ContactLaw, b: &ContactLaw) -> f64 {
    together(a, b).stiffness
}

/// Two contacts one behind the other. Friction is the geometric mean.
fn together(a: &ContactLaw, b: &ContactLaw) -> ContactLaw {
    let series = |a: f64, b: f64| if a + b > 0.0 { a * b / (a + b) } else { 0.0 };
    ContactLaw {
        radius: a.radius + b.radius,
        stiffness: series(a.stiffness, b.stiffness),
        damping: series(a.damping, b.damping),
        friction: (a.friction * b.friction).sqrt(),
        sticking: series(a.sticking, b.sticking),
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

/// Where the bounding boxes of two bodies overlap, when each is `reach` [m] larger than its particles.
fn bounds_overlap(a: &Body, b: &Body, reach: f64) -> Option<Aabb> {
    let bounds = |body: &Body| {
        let start = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        let (min, max) = body.state().positions.iter().fold(start, |(l, m), &x| (l.min(x), m.max(x)));
        (min - reach, max + reach)
    };
    let ((min_a, max_a), (min_b, max_b)) = (bounds(a), bounds(b));
    let overlap = Aabb { min: min_a.max(min_b), max: max_a.min(max_b) };
    overlap.min.cmple(overlap.max).all().then_some(overlap)
}

/// What a two-layer body shows to others.
enum OuterSurface {
    /// No surface: a segment.
    Bare,
    /// Edges in a plane.
    Polygon(std::sync::Arc<[[u32; 2]]>, DVec3),
    /// Faces.
    Faces(std::sync::Arc<[[u32; 3]]>),
}

fn outer_surface(body: &Body) -> Option<OuterSurface> {
    let layers = body.parts().layers.as_ref()?;
    Some(match &layers.outer_surface {
        None => OuterSurface::Bare,
        Some(Surface::Polygon { edges, normal }) => OuterSurface::Polygon(edges.clone(), *normal),
        Some(Surface::Faces(faces)) => OuterSurface::Faces(faces.clone()),
    })
}

/// Particles of a body that touch others, in a box.
fn touching(body: &Body, overlap: &Aabb) -> Vec<u32> {
    let count = body.parts().layers.as_ref().map_or(body.state().len(), |layers| layers.outer);
    let positions = &body.state().positions;
    (0..count as u32).filter(|&i| overlap.contains(positions[i as usize])).collect()
}

fn balls_on_balls(a: &mut Body, b: &mut Body, law: &ContactLaw, overlap: &Aabb) {
    let (of_a, of_b) = (touching(a, overlap), touching(b, overlap));
    if of_a.is_empty() || of_b.is_empty() || law.radius <= 0.0 {
        return;
    }
    let places: Vec<DVec3> = of_b.iter().map(|&j| b.state().positions[j as usize]).collect();
    let grid = PointGrid::new(&places, law.radius);
    for i in of_a {
        let i = i as usize;
        for k in grid.within(a.state().positions[i]) {
            let j = of_b[k as usize] as usize;
            let line = a.state().positions[i] - b.state().positions[j];
            let gap = line.length();
            let Some(normal) = line.try_normalize() else { continue };
            let force = law.force(gap, normal, a.state().velocities[i] - b.state().velocities[j]);
            a.add_external_force(i, force);
            b.add_external_force(j, -force);
            share(a, b, law.energy(gap));
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

fn points_on_surface(points: &mut Body, surface: &mut Body, law: &ContactLaw, overlap: &Aabb) {
    let chosen = touching(points, overlap);
    match outer_surface(surface) {
        Some(OuterSurface::Faces(faces)) => {
            for i in chosen {
                let closest =
                    nearest_on_faces(points.state().positions[i as usize], &surface.state().positions, &faces);
                push(points, surface, law, i, closest);
            }
        }
        Some(OuterSurface::Polygon(edges, normal)) => {
            // Two rings meet in their common plane only.
            let origin = surface.state().positions.first().copied().unwrap_or_default();
            let flat = |x: DVec3| (x - origin).dot(normal).abs() <= 1e-6 * surface.parts().reach;
            let flat_points = chosen.iter().all(|&i| flat(points.state().positions[i as usize]));
            if !matches!(outer_surface(points), Some(OuterSurface::Polygon(..))) || !flat_points {
                return;
            }
            for i in chosen {
                let x = points.state().positions[i as usize];
                let closest = nearest_on_edges(x, &surface.state().positions, &edges, normal);
                push(points, surface, law, i, closest);
            }
        }
        _ => {}
    }
}

/// Pushes a point and the place on the surface that is nearest to it apart.
fn push<const N: usize>(
    points: &mut Body,
    surface: &mut Body,
    law: &ContactLaw,
    i: u32,
    closest: Option<ClosestPoint<N>>,
) {
    let Some(closest) = closest else { return };
    let i = i as usize;
    let line = points.state().positions[i] - closest.at;
    let outside = line.dot(closest.outward) >= 0.0;
    let distance = closest.distance_squared.sqrt();
    let along = line.try_normalize().map_or(closest.outward.normalize_or_zero(), |n| if outside { n } else { -n });
    let gap = if outside { distance } else { -distance };
    if gap >= law.radius {
        return;
    }
    let velocities = &surface.state().velocities;
    let moving: DVec3 = closest.particles.iter().zip(closest.weights).map(|(&k, w)| w * velocities[k as usize]).sum();
    let force = law.force(gap, along, points.state().velocities[i] - moving);
    points.add_external_force(i, force);
    for (&k, w) in closest.particles.iter().zip(closest.weights) {
        surface.add_external_force(k as usize, -w * force);
    }
    share(points, surface, law.energy(gap));
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
