//! Pulling a body by the point under the pointer.

use super::app::Pull;
use super::overlay::handle;
use super::pane::{Frame, View3d};
use crate::draw::Slice;
use crate::geometry::mesh::nearest_hit;
use crate::render::Ray;
use crate::sim::SimCommand;
use crate::solver::snapshot::BodySnapshot;
use egui::{Key, PointerButton, Pos2, Response, Ui};
use glam::DVec3;

/// A particle is taken hold of from so far away [points].
const NEAR: f64 = 16.0;

impl View3d<'_> {
    /// Pulls a body by the point under the pointer.
    pub(super) fn pull(&mut self, ui: &Ui, response: &Response, frame: Frame) {
        let primary = PointerButton::Primary;
        let (origin, now, alt, pin) = ui.input(|input| {
            let pointer = &input.pointer;
            (pointer.press_origin(), pointer.latest_pos(), input.modifiers.alt, input.key_pressed(Key::P))
        });
        let starts = response.drag_started_by(primary) || response.drag_started_by(PointerButton::Secondary);
        if starts
            && !alt
            && self.app.published.compared.is_empty()
            && let Some(at) = origin
        {
            self.app.pull = self.hit(frame, at);
            if let Some(Pull { body, vertex, target, .. }) = self.app.pull {
                self.app.ask(SimCommand::Grab { body, vertex, target });
            }
        }
        let size = frame.size();
        if let (Some(mut pull), Some(at)) = (self.app.pull, now) {
            self.app.hint = "Release to let go; P leaves the point pinned here";
            let target = frame.camera.point_at(frame.pixel(at), pull.depth, size);
            if target != pull.target {
                pull.target = target;
                self.app.pull = Some(pull);
                self.app.ask(SimCommand::MoveGrab(target));
            }
            if pin {
                self.app.ask(SimCommand::PinGrab);
                self.app.pull = None;
            } else if response.drag_stopped() {
                self.app.ask(SimCommand::Release);
                self.app.pull = None;
            }
        } else if response.hovered() {
            self.app.hint = if self.app.in_replay() {
                "Drag a body to pull it and go on from this frame; the later ones are dropped then"
            } else {
                "Drag a body to pull it; middle drag turns the view, the wheel comes closer"
            };
        }
    }

    /// The vertex of a skin that lies nearest to what is seen at a pixel, or the particle there of a body without one.
    fn hit(&self, frame: Frame, at: Pos2) -> Option<Pull> {
        let slice = self.app.display.slice;
        let bodies = self.app.published.snapshot.bodies.iter().enumerate();
        let hits = bodies.filter_map(|(body, shown)| {
            if shown.triangles.is_empty() {
                let (vertex, depth) = nearest_particle(shown, slice, frame, at)?;
                return Some((body, vertex, depth));
            }
            let skin = shown.surface();
            let (triangle, point) = self.seen_on(&skin, &shown.triangles, frame, at)?;
            let near = |&vertex: &u32| skin[vertex as usize].distance_squared(point);
            let vertex = *shown.triangles[triangle].iter().min_by(|a, b| near(a).total_cmp(&near(b)))? as usize;
            Some((body, vertex, frame.camera.project(point, frame.size())?.depth))
        });
        let (body, vertex, _) = hits.min_by(|a, b| a.2.total_cmp(&b.2))?;
        let held = handle(self.app.published.snapshot.bodies.get(body)?, vertex)?;
        let depth = frame.camera.project(held, frame.size())?.depth;
        Some(Pull { body, vertex, depth, target: held })
    }

    /// What is seen of a skin at a pixel of the result view: a face, and where on it [m].
    pub(super) fn seen_on(
        &self,
        skin: &[DVec3],
        triangles: &[[u32; 3]],
        frame: Frame,
        at: Pos2,
    ) -> Option<(usize, DVec3)> {
        let Ray { origin, direction } = frame.camera.ray(frame.pixel(at), frame.size());
        let slice = self.app.display.slice;
        let [from, to] = slice.map_or(Some([0.0, f64::INFINITY]), |slice| slice.kept(origin, direction))?;
        let start = origin + from * direction;
        let hit = nearest_hit(skin, triangles, start, direction)?;
        (from + hit.distance <= to).then(|| (hit.triangle, start + hit.distance * direction))
    }
}

/// The outer particle that is seen nearest to a pixel, and its depth [m]; none that is near enough.
fn nearest_particle(body: &BodySnapshot, slice: Option<Slice>, frame: Frame, at: Pos2) -> Option<(usize, f64)> {
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
