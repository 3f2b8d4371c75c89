//! Grabbing a body by the point under the pointer.

use super::frame::ViewFrame;
use crate::draw::Slice;
use crate::geometry::ray::nearest_hit;
use crate::render::Ray;
use crate::solver::snapshot::BodySnapshot;
use crate::ui::context::{Context, Grabbed};
use egui::{Key, PointerButton, Pos2, Response, Ui};
use glam::DVec3;

/// A particle is taken hold of from so far away [points].
const NEAR: f64 = 16.0;

/// Grabs a body by the point under the pointer, moves what is grabbed along and lets it go.
pub(super) fn grab(ui: &Ui, response: &Response, frame: &ViewFrame, slice: Option<Slice>, cx: &mut Context) {
    let primary = PointerButton::Primary;
    let (origin, now, alt, pin) = ui.input(|input| {
        let pointer = &input.pointer;
        (pointer.press_origin(), pointer.latest_pos(), input.modifiers.alt, input.key_pressed(Key::P))
    });
    let starts = response.drag_started_by(primary) || response.drag_started_by(PointerButton::Secondary);
    if starts
        && !alt
        && !cx.simulation.is_comparing()
        && let Some(at) = origin
    {
        let hit = hit(frame, slice, at, &cx.simulation.published().snapshot.bodies);
        cx.simulation.grab(hit);
    }
    if let (Some(grabbed), Some(at)) = (cx.simulation.grabbed(), now) {
        cx.status.hint = "Release to let go; P leaves the point pinned here";
        cx.simulation.move_grab(frame.camera.point_at(frame.pixel(at), grabbed.depth, frame.size()));
        if pin {
            cx.simulation.pin_grab();
        } else if response.drag_stopped() {
            cx.simulation.release_grab();
        }
    } else if response.hovered() {
        cx.status.hint = if cx.simulation.is_replaying() {
            "Drag a body to pull it and go on from this frame; the later ones are dropped then"
        } else {
            cx.navigation.hint()
        };
    }
}

/// The vertex of a skin that lies nearest to what is seen at a pixel, or the particle there of a body without one.
fn hit(frame: &ViewFrame, slice: Option<Slice>, at: Pos2, bodies: &[BodySnapshot]) -> Option<Grabbed> {
    let hits = bodies.iter().enumerate().filter_map(|(body, shown)| {
        if shown.triangles.is_empty() {
            let (vertex, depth) = nearest_particle(shown, slice, frame, at)?;
            return Some((body, vertex, depth));
        }
        let skin = shown.surface();
        let (triangle, point) = seen_on(&skin, &shown.triangles, slice, frame, at)?;
        let near = |&vertex: &u32| skin[vertex as usize].distance_squared(point);
        let vertex = *shown.triangles[triangle].iter().min_by(|a, b| near(a).total_cmp(&near(b)))? as usize;
        Some((body, vertex, frame.camera.project(point, frame.size())?.depth))
    });
    let (body, vertex, _) = hits.min_by(|a, b| a.2.total_cmp(&b.2))?;
    let target = grabbed_point(bodies.get(body)?, vertex)?;
    let depth = frame.camera.project(target, frame.size())?.depth;
    Some(Grabbed { body, vertex, depth, target })
}

/// The number of the body that is seen at a pixel of the result view; none where there is none.
pub(crate) fn body_at(frame: &ViewFrame, slice: Option<Slice>, at: Pos2, bodies: &[BodySnapshot]) -> Option<usize> {
    hit(frame, slice, at, bodies).map(|hit| hit.body)
}

/// What is seen of a skin at a pixel of the result view: a face, and where on it [m].
pub(crate) fn seen_on(
    skin: &[DVec3],
    triangles: &[[u32; 3]],
    slice: Option<Slice>,
    frame: &ViewFrame,
    at: Pos2,
) -> Option<(usize, DVec3)> {
    let Ray { origin, direction } = frame.camera.ray(frame.pixel(at), frame.size());
    let [from, to] = slice.map_or(Some([0.0, f64::INFINITY]), |slice| slice.kept(origin, direction))?;
    let start = origin + from * direction;
    let hit = nearest_hit(skin, triangles, start, direction)?;
    (from + hit.distance <= to).then(|| (hit.triangle, start + hit.distance * direction))
}

/// Where a body is held by a vertex of its skin, or by a particle where it has none.
pub(super) fn grabbed_point(body: &BodySnapshot, vertex: usize) -> Option<DVec3> {
    let surface = body.surface();
    if surface.is_empty() { body.particles.get(vertex).copied() } else { surface.get(vertex).copied() }
}

/// The outer particle that is seen nearest to a pixel, and its depth [m]; none that is near enough.
fn nearest_particle(body: &BodySnapshot, slice: Option<Slice>, frame: &ViewFrame, at: Pos2) -> Option<(usize, f64)> {
    let outer = body.layers.as_ref().map_or(body.particles.len(), |layers| layers.outer);
    let hidden = |point: DVec3| slice.is_some_and(|slice| slice.hides(point));
    let seen = body.particles.iter().take(outer).enumerate().filter(|(_, at)| !hidden(**at));
    let seen = seen.filter_map(|(index, &particle)| {
        let seen = frame.camera.project(particle, frame.size())?;
        let distance = seen.pixel.distance(frame.pixel(at));
        (distance <= NEAR).then_some((index, seen.depth, distance))
    });
    seen.min_by(|a, b| a.2.total_cmp(&b.2)).map(|(index, depth, _)| (index, depth))
}
