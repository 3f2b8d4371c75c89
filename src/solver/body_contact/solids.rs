//! Where two fibre solids touch: outer particles of each, as balls, against the swept surface of the other
//! ([`ContactSurface`]).
//!
//! The depth of a ball in a surface is a smooth function of the particles as long as that is convex there, and the
//! forces are the slopes of its energy: at the point that is nearest only what is kept fixed counts.

use super::lever::Turning;
use super::touch::{Aabb, Allowance, Meeting, Touch};
use crate::geometry::bvh::{Bvh, Node};
use crate::geometry::swollen::nearest_on_swollen;
use crate::solver::body::Body;
use crate::solver::contact_surface::ContactSurface;
use crate::solver::forces::ContactLaw;
use glam::DVec3;
use std::cell::Cell;

/// Points nearer than this share of the reach to two faces count as between them.
const SAME: f64 = 1e-9;

/// A solid and the surface that it shows.
#[derive(Clone, Copy)]
pub(super) struct Solid<'a> {
    pub(super) body: &'a Body,
    pub(super) surface: &'a ContactSurface,
}

impl<'a> Solid<'a> {
    /// None of a body that shows no faces.
    pub(super) fn of(body: &'a Body) -> Option<Self> {
        let surface = body.parts().contact_surface.as_deref()?;
        (!surface.faces.is_empty()).then_some(Self { body, surface })
    }

    fn place(&self, i: u32) -> DVec3 {
        self.body.state().positions[i as usize]
    }

    fn radius(&self, i: u32) -> f64 {
        self.surface.radii[i as usize]
    }
}

/// The place on a surface whose ball is nearest to a point.
struct Nearest {
    face: [u32; 3],
    weights: [f64; 3],
    /// Radius of its ball [m].
    radius: f64,
    /// Distance from the point [m], negative inside the faces.
    distance: f64,
    /// Unit vector from there to the point, or outwards.
    normal: DVec3,
}

/// Faces of a solid that are worth a look.
struct Faces<'a> {
    solid: Solid<'a>,
    near: Vec<[u32; 3]>,
    bvh: Bvh,
}

impl<'a> Faces<'a> {
    /// Those that come into a box.
    fn within(solid: Solid<'a>, bounds: &Aabb) -> Self {
        let meets = |face: &&[u32; 3]| {
            let [a, b, c] = face.map(|i| solid.place(i));
            a.min(b).min(c).cmple(bounds.max).all() && a.max(b).max(c).cmpge(bounds.min).all()
        };
        let faces: Vec<[u32; 3]> = solid.surface.faces.iter().filter(meets).copied().collect();
        let bvh = Bvh::new(&solid.body.state().positions, &faces);
        Self { solid, near: faces, bvh }
    }

    /// The place whose ball is nearest to `x`, if it is nearer than `reach` [m].
    fn nearest(&self, x: DVec3, reach: f64) -> Option<Nearest> {
        let outside = self.least(x, reach, |i| self.solid.radius(i))?;
        if (x - outside.at).dot(outside.outward) >= 0.0 {
            return Some(outside.signed(x, 1.0));
        }
        // Behind the faces the nearest of them is the way out, however large its balls are.
        Some(self.least(x, reach + self.solid.surface.largest, |_| 0.0)?.signed(x, -1.0))
    }

    /// The place at which the distance from `x` less the radius of a ball is least.
    fn least(&self, x: DVec3, reach: f64, radius: impl Fn(u32) -> f64) -> Option<Least> {
        let largest = self.solid.surface.largest;
        let least = Cell::new(reach);
        let slack = SAME * (reach + largest);
        let enter = |node: &Node| (x - x.clamp(node.min, node.max)).length() < least.get() + largest + slack;
        let mut best: Option<Least> = None;
        self.bvh.visit(enter, |index| {
            let face = self.near[index as usize];
            let corners = face.map(|i| self.solid.place(i));
            let radii = face.map(&radius);
            let weights = nearest_on_swollen(x, corners, radii);
            let mix = |values: [f64; 3]| weights[0] * values[0] + weights[1] * values[1] + weights[2] * values[2];
            let at = weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2];
            let gap = x.distance(at) - mix(radii);
            if gap >= least.get() + slack {
                return;
            }
            let outward = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalize_or_zero();
            match &mut best {
                Some(best) if gap > best.gap - slack => best.outward += outward,
                _ => {
                    let radius = mix(face.map(|i| self.solid.radius(i)));
                    best = Some(Least { face, weights, at, radius, gap, outward });
                    least.set(gap.min(least.get()));
                }
            }
        });
        best.filter(|best| best.gap < reach)
    }
}

/// A place on a surface that is nearest in some sense.
struct Least {
    face: [u32; 3],
    weights: [f64; 3],
    at: DVec3,
    radius: f64,
    gap: f64,
    /// Sum of the normals of all faces that are equally near.
    outward: DVec3,
}

impl Least {
    fn signed(self, x: DVec3, sign: f64) -> Nearest {
        let Self { face, weights, at, radius, outward, .. } = self;
        let line = x - at;
        let normal = line.try_normalize().map_or(outward.normalize_or_zero(), |normal| sign * normal);
        Nearest { face, weights, radius, distance: sign * line.length(), normal }
    }
}

/// Adds the touches of the first solid's particles on the second's surface. Their gaps count as of balls of the law's
/// radius.
pub(super) fn balls_on_surface(
    points: Solid<'_>,
    surface: Solid<'_>,
    law: &ContactLaw,
    overlap: &Aabb,
    allowance: &Allowance,
    found: &mut Vec<Touch>,
) {
    let beside = |i: u32| points.place(i) + allowance.aside;
    let mut chosen = points.surface.outer.iter().copied().filter(|&i| overlap.contains(beside(i))).peekable();
    if chosen.peek().is_none() {
        return;
    }
    let faces = Faces::within(surface, overlap);
    let states = [points.body.state(), surface.body.state()];
    for i in chosen {
        let radius = points.radius(i);
        let Some(nearest) = faces.nearest(beside(i), radius) else { continue };
        let Nearest { face, weights, normal, .. } = nearest;
        let depth = radius + nearest.radius - nearest.distance - allowance.depth;
        if depth <= 0.0 {
            continue;
        }
        let apart = |motion: &dyn Fn(usize, u32) -> DVec3| {
            let carried: DVec3 = face.iter().zip(weights).map(|(&k, w)| w * motion(1, k)).sum();
            motion(0, i) - carried
        };
        let mut velocity = apart(&|side, k| states[side].velocities[k as usize]);
        let moved = |side: usize, k: u32| [points.body, surface.body][side].moved(k as usize);
        let mut slid = DVec3::ZERO;
        // Where both balls have sunk in alike.
        let share = radius / (radius + nearest.radius);
        let levers = [share * nearest.distance, (1.0 - share) * nearest.distance];
        if law.friction > 0.0 {
            slid = apart(&moved);
            for (side, around) in [points.surface.around(i), &face].into_iter().enumerate() {
                let positions = &states[side].positions;
                if let Some(turning) = Turning::of(around, positions) {
                    let spin = turning.turn(positions, |k| states[side].velocities[k as usize]);
                    velocity -= levers[side] * spin.cross(normal);
                    slid -= levers[side] * turning.turn(positions, |k| moved(side, k)).cross(normal);
                }
            }
        }
        found.push(Touch {
            of_second: false,
            particle: i,
            carried_by: [0, 1, 2].map(|k| (face[k], weights[k])),
            carriers: 3,
            gap: law.radius - depth,
            normal,
            velocity: velocity + allowance.aside_rate + allowance.depth_rate * normal,
            meeting: Some(Meeting { levers, slid }),
        });
    }
}
