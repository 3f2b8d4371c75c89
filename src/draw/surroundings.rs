//! What is around the bodies: ground, room, panels, colliders, and the strokes in the planes in which they were drawn.

use super::list::{DrawList, Faces, Ground, Line, Mesh, PickId, PickKind, Points, Size, SurfaceStyle, Vertex};
use super::options::Display;
use super::{Bounds, Colour};
use crate::geometry::lattice::Cuboid;
use crate::geometry::mesh::{TriangleMesh, box_surface};
use crate::scene::{Body, FibreSource, Panel, Scene, Shape, ViewStroke};
use crate::solver::snapshot::Snapshot;
use glam::{DQuat, DVec3, Vec3};

/// A floor belongs into the picture when it is no further below than this many radii of what is above it.
const FLOOR_REACH: f64 = 4.0;
/// A room's walls reach this many radii around the bodies where nothing else ends them.
const WALL_REACH: f64 = 3.0;
/// Width of a stroke and radius of the dots at its ends [pixels].
const STROKE_WIDTH: f32 = 2.5;
const DOT_RADIUS: f32 = 5.0;
/// Strokes stay readable over the model.
const STROKE_THROUGH: f32 = 0.55;

/// What is worth framing: bodies, panels, colliders, and the floor below them when it is near.
pub(super) fn bounds(scene: &Scene, snapshot: &Snapshot) -> Option<Bounds> {
    let bodies = snapshot.bodies.iter().flat_map(|body| {
        let solid = if body.skin.is_empty() { &body.particles } else { &body.skin };
        solid.iter().copied()
    });
    let panels = scene.panels.iter().zip(&snapshot.panels).flat_map(|(panel, &height)| {
        let [x, z] = panel.center;
        let [a, b] = panel.size.map(|extent| 0.5 * extent);
        [DVec3::new(x - a, height, z - b), DVec3::new(x + a, height, z + b)]
    });
    let colliders = snapshot.colliders.iter().filter(|collider| !collider.is_endless);
    let colliders = colliders.flat_map(|collider| collider.in_world().map(|[x, _]| x));
    let bounds = Bounds::of(bodies.chain(panels).chain(colliders))?;
    Some(match scene.room.floor {
        Some(floor) if floor < bounds.min.y && bounds.min.y - floor < FLOOR_REACH * bounds.radius() => {
            Bounds { min: bounds.min.with_y(floor), ..bounds }
        }
        _ => bounds,
    })
}

/// The room's floor, or the grid at the world's origin where there is none: it stands still whatever moves.
pub(super) fn ground(scene: &Scene, display: &Display) -> Ground {
    Ground {
        height: scene.room.floor.unwrap_or(0.0),
        solid: scene.room.floor.is_some(),
        grid: display.grid,
        axes: display.axes,
    }
}

/// Panels, with their undersides where the snapshot has them.
pub(super) fn panels(scene: &Scene, snapshot: &Snapshot, list: &mut DrawList) {
    for (index, (panel, &height)) in scene.panels.iter().zip(&snapshot.panels).enumerate() {
        let [width, depth] = panel.size;
        let thickness = Panel::THICKNESS * width.min(depth);
        let center = DVec3::new(panel.center[0], height + 0.5 * thickness, panel.center[1]);
        let shape = Cuboid { center, size: DVec3::new(width, thickness, depth) };
        let pick = list.register(PickId { body: 0, kind: PickKind::Panel, index: index as u32 }, 1);
        let (vertices, indices) = faceted(list, &box_surface(&shape, width.max(depth)));
        let colour = list.theme.panel;
        let faces = Faces::Free(vertices, indices);
        list.meshes.push(Mesh {
            faces,
            colour,
            tints: Vec::new(),
            surface: SurfaceStyle::Solid,
            casts_shadow: true,
            pick,
        });
    }
}

/// Colliders where the snapshot has them.
pub(super) fn colliders(snapshot: &Snapshot, list: &mut DrawList) {
    for (index, collider) in snapshot.colliders.iter().enumerate() {
        let pick = list.register(PickId { body: 0, kind: PickKind::Collider, index: index as u32 }, 1);
        let corners = collider.in_world();
        let vertices: Vec<Vertex> =
            corners.map(|[x, normal]| Vertex { position: list.local(x), normal: normal.as_vec3() }).collect();
        let indices = (0..vertices.len() as u32).collect();
        list.meshes.push(Mesh {
            faces: Faces::Free(vertices, indices),
            colour: list.theme.panel,
            tints: Vec::new(),
            surface: SurfaceStyle::Solid,
            casts_shadow: !collider.is_endless,
            pick,
        });
    }
}

/// Every face with a normal and corners of its own.
fn faceted(list: &DrawList, mesh: &TriangleMesh) -> (Vec<Vertex>, Vec<u32>) {
    let vertices: Vec<Vertex> = mesh
        .triangles
        .iter()
        .flat_map(|triangle| {
            let [a, b, c] = triangle.map(|k| list.local(mesh.positions[k as usize]));
            let normal = (b - a).cross(c - a).normalize_or(Vec3::Y);
            [a, b, c].map(|position| Vertex { position, normal })
        })
        .collect();
    let indices = (0..vertices.len() as u32).collect();
    (vertices, indices)
}

/// Walls and ceiling, as faint sheets around the bodies, outlined where they meet the picture's subject.
pub(super) fn walls(scene: &Scene, list: &mut DrawList) {
    let Some(bounds) = list.bounds else { return };
    let room = &scene.room;
    let reach = DVec3::splat(WALL_REACH * bounds.radius());
    let (low, high) = (bounds.center() - reach, bounds.center() + reach);
    let least = DVec3::new(room.x_min.unwrap_or(low.x), room.floor.unwrap_or(low.y), room.z_min.unwrap_or(low.z));
    let most = DVec3::new(room.x_max.unwrap_or(high.x), room.ceiling.unwrap_or(high.y), room.z_max.unwrap_or(high.z));
    let sheets = [
        (0, room.x_min, false),
        (0, room.x_max, true),
        (1, room.ceiling, true),
        (2, room.z_min, false),
        (2, room.z_max, true),
    ];
    for (axis, at, far) in sheets {
        let Some(at) = at else { continue };
        let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
        let corner = |a: bool, b: bool| {
            let mut point = DVec3::ZERO;
            point[axis] = at;
            point[u] = if a { most[u] } else { least[u] };
            point[v] = if b { most[v] } else { least[v] };
            list.local(point)
        };
        let mut normal = Vec3::ZERO;
        normal[axis] = if far { -1.0 } else { 1.0 };
        let corners = [corner(false, false), corner(true, false), corner(true, true), corner(false, true)];
        let vertices = corners.map(|position| Vertex { position, normal }).to_vec();
        let colour = list.theme.wall;
        let faces = Faces::Free(vertices, vec![0, 1, 2, 0, 2, 3]);
        let mut points = corners.to_vec();
        points.push(corners[0]);
        list.meshes.push(Mesh {
            faces,
            colour,
            tints: Vec::new(),
            surface: SurfaceStyle::Faint,
            casts_shadow: false,
            pick: 0,
        });
        let outline = colour.with_alpha(4.0 * colour.alpha);
        list.lines.push(Line { points, width: 1.0, colour: outline, through: 0.0, pick: 0 });
    }
}

/// The strokes of a body's fibres, as drawn, through the middle of the body at rest.
pub(super) fn strokes(body: &Body, list: &mut DrawList) {
    // What has its middle at the origin is drawn into about that; a box, wherever its middle is.
    let center = match &body.shape {
        Shape::Box(shape) => DVec3::from_array(shape.center),
        _ => DVec3::ZERO,
    };
    let turn = &body.placement.rotation;
    let axis = DVec3::from_array(turn.axis).normalize_or(DVec3::Y);
    let turn = DQuat::from_axis_angle(axis, turn.degrees.to_radians());
    let in_world = |point: DVec3| turn * point + DVec3::from_array(body.placement.translation);
    for fibre in &body.fibres {
        let FibreSource::Strokes(pair) = &fibre.source else { continue };
        for stroke in [&pair.first, &pair.second] {
            let points: Vec<DVec3> = in_space(stroke, center).map(in_world).collect();
            draw_stroke(&points, list);
        }
    }
}

/// A stroke's points in the model frame [m], on the plane of its view through `center`.
fn in_space(stroke: &ViewStroke, center: DVec3) -> impl Iterator<Item = DVec3> {
    let [horizontal, vertical] = stroke.view.axes();
    stroke.points.iter().map(move |&[a, b]| {
        let mut point = center;
        point[horizontal] = a;
        point[vertical] = b;
        point
    })
}

fn draw_stroke(points: &[DVec3], list: &mut DrawList) {
    let theme = list.theme;
    let points: Vec<Vec3> = points.iter().map(|&point| list.local(point)).collect();
    let (Some(&start), Some(&end)) = (points.first(), points.last()) else { return };
    let mut dot = |at: Vec3, colour: Colour| {
        let size = Size::Pixels(DOT_RADIUS);
        list.points.push(Points { centres: vec![at], size, colour, tints: Vec::new(), through: 1.0, pick: 0 });
    };
    dot(start, theme.stroke_start);
    dot(end, theme.stroke_end);
    list.lines.push(Line { points, width: STROKE_WIDTH, colour: theme.stroke, through: STROKE_THROUGH, pick: 0 });
}
