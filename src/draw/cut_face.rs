//! The face that a cut opens in a body.

use super::list::{DrawList, Faces, Mesh, SurfaceStyle, Vertex};
use super::{Colour, colour_map};
use crate::geometry::neighbours::PointGrid;
use crate::geometry::section::{Section, section};
use crate::solver::snapshot::BodySnapshot;
use glam::{DVec3, Vec2};

/// How much darker than the skin it is, and how opaque: what lies in the body shines through, as through jelly.
const SHADE: f32 = 0.62;
const OPACITY: f32 = 0.6;

/// Distance within which particles give it the colour of a field, in particle spacings D, and the edges of its
/// triangles then, at most so many of them.
const REACH: f64 = 1.5;
const EDGE: f64 = 0.5;
const MOST_TRIANGLES: usize = 40_000;

/// The face of a body with a skin where the list cuts it open, with the colours of a field over its range if there is
/// one; none where the cut misses it.
pub(super) fn cut_face(
    body: &BodySnapshot,
    skin: &Mesh,
    spacing: f64,
    field: Option<([f64; 2], &[f64])>,
    list: &DrawList,
) -> Option<Mesh> {
    let (slice, Faces::Skinned(skinned)) = (list.slice?, &skin.faces) else { return None };
    let (axis, normal) = (slice.axis.index(), slice.normal());
    // The other two axes, so that the plane is right-handed seen from what is cut away.
    let [u, v] = if slice.flipped { [(axis + 2) % 3, (axis + 1) % 3] } else { [(axis + 1) % 3, (axis + 2) % 3] };
    let plane = (slice.at - list.origin[axis]) as f32;
    let sign = normal[axis] as f32;
    let positions = skinned.positions();
    let at = |i: u32| positions[i as usize];
    let triangles = &skinned.rig.triangles;
    let mut face = section(triangles, |i| sign * (at(i)[axis] - plane), |i| Vec2::new(at(i)[u], at(i)[v]));
    if face.triangles.is_empty() {
        return None;
    }
    let tints = field.map_or_else(Vec::new, |(range, values)| {
        face.refine((EDGE * spacing) as f32, MOST_TRIANGLES);
        let place = |corner: &Vec2| {
            let mut place = list.origin;
            place[axis] = slice.at;
            place[u] += f64::from(corner.x);
            place[v] += f64::from(corner.y);
            place
        };
        let places: Vec<DVec3> = face.corners.iter().map(place).collect();
        colour_map::of(&means(&places, &body.particles, values, REACH * spacing), range)
    });
    let surface = if field.is_some() { SurfaceStyle::Solid } else { SurfaceStyle::Faint };
    let Colour { red, green, blue, .. } = skin.colour;
    let colour = Colour { red: SHADE * red, green: SHADE * green, blue: SHADE * blue, alpha: OPACITY };
    let vertex = |corner: &Vec2| {
        let mut position = glam::Vec3::ZERO;
        (position[axis], position[u], position[v]) = (plane, corner.x, corner.y);
        Vertex { position, normal: normal.as_vec3() }
    };
    let Section { corners, triangles } = &face;
    let faces = Faces::Free(corners.iter().map(vertex).collect(), triangles.iter().flatten().copied().collect());
    Some(Mesh { faces, colour, tints, surface, casts_shadow: false, pick: 0 })
}

/// Values at places from those at particles: the mean of those near it, the nearer the heavier; where none is, that of
/// the nearest of all.
fn means(places: &[DVec3], particles: &[DVec3], values: &[f64], reach: f64) -> Vec<f64> {
    let grid = PointGrid::new(particles, reach);
    let mean = |&place: &DVec3| {
        let (mut sum, mut total) = (0.0, 0.0);
        for i in grid.within(place) {
            let near = 1.0 - particles[i as usize].distance_squared(place) / (reach * reach);
            sum += near * near * values[i as usize];
            total += near * near;
        }
        if total > 0.0 {
            return sum / total;
        }
        let distance = |i: &usize| particles[*i].distance_squared(place);
        let nearest = (0..particles.len()).min_by(|a, b| distance(a).total_cmp(&distance(b)));
        nearest.map_or(f64::NAN, |i| values[i])
    };
    places.iter().map(mean).collect()
}
