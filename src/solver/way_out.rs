//! The shortest way by which one body comes out of another.
//!
//! Along a direction every particle of the one is inside the other over a stretch or several of its way, which is found
//! without moving anything: for balls from how far their lines pass each other, for a surface from where a line crosses
//! it. The first length that is in none of the stretches is the way out.

use super::body::Body;
use super::body_contact::{
    Allowance, OuterSurface, are_heaps, meet_by_surfaces, outer_surface, together, touches, touching_count,
};
use crate::geometry::neighbours::PointGrid;
use glam::{BVec3, DVec3};

/// How the first of two bodies comes out of the second.
#[derive(Clone, Copy, Debug)]
pub(super) struct WayOut {
    /// Unit vector.
    pub(super) along: DVec3,
    /// How far [m].
    pub(super) distance: f64,
    /// Greatest depth of a touch [m].
    pub(super) depth: f64,
    /// Whether the depths of the touches say how deep the bodies are in each other.
    pub(super) is_shallow: bool,
    /// Particles of the second body inside the first.
    pub(super) inside: usize,
    /// Middle of what lies inside [m].
    pub(super) at: DVec3,
}

/// A direction is preferred to an earlier one if it is shorter by more than this share.
const SHORTER: f64 = 0.01;

/// Ways that are looked at at most, of points times faces; more points are thinned out.
const MOST_CROSSINGS: usize = 2_000_000;

/// The shortest way by which the first of two bodies comes out of the second; none if they do not overlap by more than
/// `slack` [m].
pub(super) fn way_out(a: &Body, b: &Body, slack: f64) -> Option<WayOut> {
    let law = together(&a.parts().contact, &b.parts().contact);
    let reach = law.radius;
    let [box_a, box_b] = [bounds(a), bounds(b)];
    if (box_a[0].max(box_b[0]) - reach).cmpgt(box_a[1].min(box_b[1]) + reach).any() {
        return None;
    }
    let found = touches(a, b, &law, &Allowance::default());
    let depth = found.iter().map(|touch| law.radius - touch.gap).fold(0.0, f64::max);
    let push: DVec3 = found.iter().map(|touch| touch.normal).sum();
    let mut best: Option<(DVec3, f64)> = None;
    for along in directions(a, b, push) {
        let distance = touching_on(a, b, along, distance_out(a, b, along, reach, slack), slack);
        if distance <= slack {
            return None;
        }
        if best.is_none_or(|(_, least)| distance < (1.0 - SHORTER) * least) {
            best = Some((along, distance));
        }
    }
    let (along, distance) = best?;
    let (inside, at, is_surrounded) = inside(a, b, along, reach, slack);
    let narrowest = (box_a[1] - box_a[0]).max_element().min((box_b[1] - box_b[0]).max_element());
    let is_deep = found.is_empty() || if are_heaps(a, b) { is_surrounded } else { depth > 0.1 * narrowest };
    Some(WayOut { along, distance, depth, is_shallow: !is_deep && distance > 3.0 * depth, inside, at })
}

fn bounds(body: &Body) -> [DVec3; 2] {
    let places = body.state().positions.iter();
    places.fold([DVec3::INFINITY, DVec3::NEG_INFINITY], |[min, max], &x| [min.min(x), max.max(x)])
}

/// Axes along which no particle of a body can move.
fn held(body: &Body) -> BVec3 {
    let mut field = vec![DVec3::ONE; body.state().len()];
    for constraint in &body.parts().constraints {
        constraint.mask(&mut field);
    }
    field.iter().fold(BVec3::TRUE, |held, left| held & left.cmpeq(DVec3::ZERO))
}

/// Directions in which a way out is looked for: those to the 26 neighbours in a grid, from centre to centre, and where
/// contact pushes. Level ones come first: of equal ways they are taken, since nothing is lifted.
fn directions(a: &Body, b: &Body, push: DVec3) -> Vec<DVec3> {
    let both_held = held(a) & held(b);
    let rings: Vec<DVec3> = [a, b]
        .iter()
        .filter_map(|body| match outer_surface(body) {
            Some(OuterSurface::Polygon(_, normal)) => Some(normal),
            _ => None,
        })
        .collect();
    let steps = [0.0, -1.0, 1.0];
    let grid = steps.into_iter().flat_map(|y| {
        let level = [[-1.0, 0.0], [1.0, 0.0], [0.0, -1.0], [0.0, 1.0], [-1.0, -1.0], [-1.0, 1.0], [1.0, -1.0]];
        level.into_iter().chain([[1.0, 1.0], [0.0, 0.0]]).map(move |[x, z]| DVec3::new(x, y, z))
    });
    let mut found: Vec<DVec3> = Vec::new();
    for wanted in grid.chain([a.state().center() - b.state().center(), push]) {
        let mut along = DVec3::select(both_held, DVec3::ZERO, wanted);
        if let [normal, _] = rings[..] {
            // Two rings touch in their plane only.
            along -= along.dot(normal) * normal;
        }
        let Some(along) = along.try_normalize() else { continue };
        if found.iter().all(|known| known.dot(along) < 1.0 - 1e-9) {
            found.push(along);
        }
    }
    found
}

/// Stretches of a way, by how many times each piece of it is covered.
struct Stretches {
    step: f64,
    /// Changes from piece to piece.
    changes: Vec<i32>,
    /// Whether the very start is covered.
    covers_start: bool,
}

impl Stretches {
    /// Of a way of `length` [m].
    fn new(length: f64, step: f64) -> Self {
        Self { step, changes: vec![0; (length / step).ceil() as usize + 2], covers_start: false }
    }

    fn cover(&mut self, from: f64, to: f64) {
        if to <= 0.0 || from >= to {
            return;
        }
        self.covers_start |= from <= 0.0;
        let last = self.changes.len() - 1;
        let piece = |at: f64| ((at.max(0.0) / self.step) as usize).min(last);
        let (from, to) = (piece(from), piece(to) + 1);
        self.changes[from] += 1;
        self.changes[to.min(last)] -= 1;
    }

    /// The first length that nothing covers [m].
    fn first_free(&self) -> f64 {
        if !self.covers_start {
            return 0.0;
        }
        let mut covered = 0;
        for (k, change) in self.changes.iter().enumerate() {
            covered += change;
            if covered <= 0 {
                return k as f64 * self.step;
            }
        }
        self.changes.len() as f64 * self.step
    }
}

/// How far the first body has to go along a unit vector until it is out of the second [m].
fn distance_out(a: &Body, b: &Body, along: DVec3, reach: f64, slack: f64) -> f64 {
    let last = |body: &Body| body.state().positions.iter().map(|x| x.dot(along)).fold(f64::NEG_INFINITY, f64::max);
    let first = |body: &Body| body.state().positions.iter().map(|x| x.dot(along)).fold(f64::INFINITY, f64::min);
    let length = (last(b) - first(a) + 2.0 * reach).max(slack);
    let mut stretches = Stretches::new(length, slack.max(length / 4096.0));
    if are_heaps(a, b) {
        cover_balls(a, b, along, reach - slack, &mut stretches);
    } else {
        cover_surface(a, b, along, reach - slack, &mut stretches);
        cover_surface(b, a, -along, reach - slack, &mut stretches);
    }
    stretches.first_free()
}

/// How far the first body has to go along a unit vector, from `distance` [m] on, until it no longer touches the second
/// [m]: surfaces of fibre solids have no hollows between the balls of their particles.
fn touching_on(a: &Body, b: &Body, along: DVec3, mut distance: f64, slack: f64) -> f64 {
    /// Steps by the depth of the deepest touch; one that slants is left after a few.
    const STEPS: u32 = 8;
    let law = together(&a.parts().contact, &b.parts().contact);
    if distance <= 0.0 || !meet_by_surfaces(a, b) {
        return distance;
    }
    for _ in 0..STEPS {
        let allowance = Allowance { aside: distance * along, ..Allowance::default() };
        let depth = touches(a, b, &law, &allowance).iter().map(|touch| law.radius - touch.gap).fold(0.0, f64::max);
        if depth <= slack {
            break;
        }
        distance += depth;
    }
    distance
}

/// Covers the stretches over which a ball of the first overlaps one of the second.
fn cover_balls(a: &Body, b: &Body, along: DVec3, radius: f64, stretches: &mut Stretches) {
    if radius <= 0.0 {
        return;
    }
    let across = |x: DVec3| x - x.dot(along) * along;
    let of_b = &b.state().positions[..touching_count(b)];
    let flat: Vec<DVec3> = of_b.iter().map(|&x| across(x)).collect();
    let grid = PointGrid::new(&flat, radius);
    for &x in &a.state().positions[..touching_count(a)] {
        let foot = across(x);
        for k in grid.within(foot) {
            let k = k as usize;
            let passes = (of_b[k] - x).dot(along);
            let half = (radius * radius - flat[k].distance_squared(foot)).max(0.0).sqrt();
            stretches.cover(passes - half, passes + half);
        }
    }
}

/// Covers the stretches over which a particle of `points`, on its way along a direction, is inside a surface. Those of
/// the inner layer and the middle count too: bodies that coincide touch nowhere else.
fn cover_surface(points: &Body, surface: &Body, along: DVec3, grown: f64, stretches: &mut Stretches) {
    let Some(crossings) = Crossings::of(surface, along) else { return };
    let places = &points.state().positions;
    let thinned = (places.len() * crossings.len()).div_ceil(MOST_CROSSINGS).max(1);
    let middle = places.iter().sum::<DVec3>() / places.len() as f64;
    for x in places.iter().copied().step_by(thinned).chain([middle]) {
        for [enters, leaves] in crossings.of_line(x) {
            stretches.cover(enters - grown, leaves + grown);
        }
    }
}

/// A line that passes an edge of a face by no more than this share of it crosses the face.
const EDGE: f64 = -1e-12;

/// A closed surface, ready to be crossed by lines of one direction.
struct Crossings {
    along: DVec3,
    /// Corners of every face, or ends of every edge with the last repeated.
    pieces: Vec<[DVec3; 3]>,
    /// Normal of the plane of a ring.
    plane: Option<DVec3>,
}

impl Crossings {
    fn of(surface: &Body, along: DVec3) -> Option<Self> {
        let x = &surface.state().positions;
        let at = |i: u32| x[i as usize];
        Some(match outer_surface(surface)? {
            OuterSurface::Bare => return None,
            OuterSurface::Faces(faces) => {
                Self { along, pieces: faces.iter().map(|face| face.map(at)).collect(), plane: None }
            }
            OuterSurface::Polygon(edges, normal) => {
                let pieces = edges.iter().map(|&[a, b]| [at(a), at(b), at(b)]).collect();
                Self { along, pieces, plane: Some(normal) }
            }
        })
    }

    fn len(&self) -> usize {
        self.pieces.len()
    }

    /// Stretches of the line from `x` that lie inside [m].
    fn of_line(&self, x: DVec3) -> Vec<[f64; 2]> {
        let mut hits: Vec<f64> = self.pieces.iter().filter_map(|piece| self.crossing(x, piece)).collect();
        hits.sort_by(f64::total_cmp);
        // A line through an edge crosses both its faces at once, or neither.
        hits.dedup_by(|b, a| (*b - *a).abs() < 1e-12 * (1.0 + a.abs()));
        hits.chunks_exact(2).map(|pair| [pair[0], pair[1]]).collect()
    }

    fn crossing(&self, x: DVec3, &[a, b, c]: &[DVec3; 3]) -> Option<f64> {
        if let Some(normal) = self.plane {
            let side = normal.cross(self.along);
            let (from, to) = ((a - x).dot(side), (b - x).dot(side));
            if (from > 0.0) == (to > 0.0) {
                return None;
            }
            let share = from / (from - to);
            return Some((a + share * (b - a) - x).dot(self.along));
        }
        let (ab, ac) = (b - a, c - a);
        let p = self.along.cross(ac);
        let determinant = ab.dot(p);
        if determinant.abs() < f64::MIN_POSITIVE {
            return None;
        }
        let to = x - a;
        let u = to.dot(p) / determinant;
        let q = to.cross(ab);
        let v = self.along.dot(q) / determinant;
        (u >= EDGE && v >= EDGE && u + v <= 1.0 - EDGE).then(|| ac.dot(q) / determinant)
    }
}

/// How many particles of the second body lie inside the first, their middle, and whether a ball has others all around.
fn inside(a: &Body, b: &Body, along: DVec3, reach: f64, slack: f64) -> (usize, DVec3, bool) {
    let places = &b.state().positions;
    let within: Vec<DVec3>;
    let mut is_surrounded = false;
    if are_heaps(a, b) {
        const AROUND: f64 = 1.3;
        let of_a = &a.state().positions[..touching_count(a)];
        let grid = PointGrid::new(of_a, AROUND * reach);
        let near = reach - slack;
        within = places[..touching_count(b)]
            .iter()
            .copied()
            .filter(|&x| {
                let around = grid.within(x);
                let ways: DVec3 = around.iter().map(|&k| (of_a[k as usize] - x).normalize_or_zero()).sum();
                is_surrounded |= around.len() >= 6 && ways.length() < 0.35 * around.len() as f64;
                around.iter().any(|&k| of_a[k as usize].distance(x) < near)
            })
            .collect();
    } else if let Some(crossings) = Crossings::of(a, along) {
        let holds = |x: &DVec3| crossings.of_line(*x).iter().any(|[from, to]| *from < 0.0 && *to > 0.0);
        within = places.iter().copied().filter(holds).collect();
    } else {
        within = Vec::new();
    }
    let middle = |points: &[DVec3]| points.iter().sum::<DVec3>() / points.len().max(1) as f64;
    let at = if within.is_empty() { 0.5 * (a.state().center() + b.state().center()) } else { middle(&within) };
    (within.len(), at, is_surrounded)
}
