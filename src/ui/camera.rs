//! The cameras of the views: fitting, moving by pointer and keys, easing.

use super::pane::{Pane, PaneKind, View3d};
use crate::draw::Bounds;
use crate::render::{Camera, Facing, Projection};
use crate::sketch::View;
use crate::solver::snapshot::{BodySnapshot, Snapshot};
use egui::{Key, PointerButton, Rect, Response, Ui};
use glam::{DVec2, DVec3};
use std::f64::consts::{PI, TAU};

/// How long a camera takes to where it was sent [s].
const EASE_SECONDS: f64 = 0.18;
/// A drawing view leaves this much room around the model.
const DRAWING_MARGIN: f64 = 1.15;
/// Turn of the result view for each pixel of a drag [rad].
const TURN: f64 = 0.008;

/// A camera on its way.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ease {
    from: Camera,
    to: Camera,
    /// When it started [s].
    start: f64,
}

impl Ease {
    /// Where it is, and whether it has arrived.
    fn at(&self, time: f64) -> (Camera, bool) {
        let share = ((time - self.start) / EASE_SECONDS).clamp(0.0, 1.0);
        if share == 1.0 {
            return (self.to, true);
        }
        let eased = share * share * (3.0 - 2.0 * share);
        // The shorter way round.
        let turn = (self.to.yaw - self.from.yaw + PI).rem_euclid(TAU) - PI;
        let camera = Camera {
            target: self.from.target.lerp(self.to.target, eased),
            yaw: self.from.yaw + eased * turn,
            pitch: self.from.pitch + eased * (self.to.pitch - self.from.pitch),
            height: self.from.height * (self.to.height / self.from.height).powf(eased),
            projection: self.to.projection,
        };
        (camera, false)
    }
}

/// From where a drawing view looks.
pub(super) fn facing(view: View) -> Facing {
    match view {
        View::Front => Facing::Front,
        View::Side => Facing::Side,
        View::Top => Facing::Top,
    }
}

fn aspect(rect: Rect) -> f64 {
    f64::from(rect.width() / rect.height().max(1.0))
}

impl Pane {
    /// Sends the camera somewhere.
    pub(super) fn ease_to(&mut self, to: Camera, now: f64) {
        self.ease = Some(Ease { from: self.camera, to, start: now });
    }
}

impl View3d<'_> {
    /// Fits the camera, where that was asked for, and moves it on where it is on its way.
    pub(super) fn settle_camera(&mut self, ui: &Ui, rect: Rect) {
        let now = ui.input(|input| input.time);
        // Before the first frame it is not known where the drawing views lie, whose scales depend on each other.
        if !self.pane.framed
            && !self.app.drawing.is_empty()
            && let Some(bounds) = self.to_fit()
        {
            let mut camera = self.pane.camera;
            camera.frame(&bounds, aspect(rect));
            if matches!(self.pane.kind, PaneKind::Drawing(_)) {
                // Both drawing views show to one scale, that of the one which needs more room.
                for (view, rect) in &self.app.drawing {
                    let mut other = Camera::facing(facing(*view));
                    other.frame(&bounds, aspect(*rect));
                    camera.height = camera.height.max(other.height);
                }
                camera.height *= DRAWING_MARGIN;
            }
            // The first time there is nowhere to come from.
            if self.pane.shown {
                self.pane.ease_to(camera, now);
            } else {
                self.pane.camera = camera;
                self.pane.shown = true;
            }
            self.pane.framed = true;
        }
        if let Some(ease) = self.pane.ease {
            let (camera, arrived) = ease.at(now);
            self.pane.camera = camera;
            if arrived {
                self.pane.ease = None;
            } else {
                ui.ctx().request_repaint();
            }
        }
    }

    /// What this view is to be fitted to; none before there is anything.
    fn to_fit(&self) -> Option<Bounds> {
        let points = |bodies: &[BodySnapshot]| {
            Bounds::of(bodies.iter().flat_map(|body| {
                let solid = if body.skin.is_empty() { &body.particles } else { &body.skin };
                solid.iter().copied()
            }))
        };
        let shown = self.snapshot();
        if self.app.fit_selected
            && let Some(bounds) = self.selected_bounds(&shown)
        {
            return Some(bounds);
        }
        match self.pane.kind {
            PaneKind::Drawing(_) => points(&shown.bodies),
            // The whole fall is to be seen, from the start down to the floor, whenever in it the view is fitted.
            PaneKind::Result => points(&shown.bodies).map(|bounds| {
                let [low, high] = self.app.published.placed.unwrap_or([bounds.min, bounds.max]);
                let floor = self.app.scene().room.floor.unwrap_or(bounds.min.y);
                Bounds { min: bounds.min.min(low).min(bounds.min.with_y(floor)), max: bounds.max.max(high) }
            }),
        }
    }

    fn selected_bounds(&self, shown: &Snapshot) -> Option<Bounds> {
        let selection = &self.app.editing.selection;
        let fibres = shown.bodies.iter().flat_map(|body| &body.fibres);
        let chosen = fibres.filter(|fibre| selection.contains(&fibre.id));
        let bounds = Bounds::of(chosen.flat_map(|fibre| fibre.vertices.iter().copied()))?;
        // Room to see what it lies in.
        let room = DVec3::splat(0.25 * bounds.radius());
        Some(Bounds { min: bounds.min - room, max: bounds.max + room })
    }

    pub(super) fn move_camera(&mut self, ui: &Ui, response: &Response) {
        let rect = response.rect;
        let size = DVec2::new(f64::from(rect.width()), f64::from(rect.height()));
        let before = self.pane.camera;
        let (delta, modifiers, wheel) =
            ui.input(|input| (input.pointer.delta(), input.modifiers, input.smooth_scroll_delta().y));
        let by = DVec2::new(f64::from(delta.x), f64::from(delta.y));
        let held = |button| response.dragged_by(button);
        let middle = held(PointerButton::Middle);
        let pans = middle && (modifiers.shift || modifiers.alt);
        let turns = middle || (modifiers.alt && held(PointerButton::Primary));
        let result = self.pane.kind == PaneKind::Result;
        if pans || (turns && !result) {
            self.pane.camera.pan(by, size);
        } else if turns {
            self.pane.camera.orbit(-TURN * by.x, TURN * by.y);
        } else if modifiers.alt && held(PointerButton::Secondary) {
            self.pane.camera.zoom((0.005 * by.y).exp(), 0.5 * size, size);
        }
        if response.hovered() && wheel != 0.0 {
            let at = ui.input(|input| input.pointer.hover_pos()).unwrap_or(rect.center());
            let pixel = DVec2::new(f64::from(at.x - rect.min.x), f64::from(at.y - rect.min.y));
            self.pane.camera.zoom((-0.002 * f64::from(wheel)).exp(), pixel, size);
        }
        if self.pane.camera != before {
            // A hand on the camera is stronger than where it was sent.
            self.pane.ease = None;
        }
        if result && response.hovered() && !ui.ctx().egui_wants_keyboard_input() {
            self.turn_by_keys(ui);
        }
        if let PaneKind::Drawing(view) = self.pane.kind
            && self.pane.camera != before
        {
            self.app.moved = Some((view, self.pane.camera));
        }
    }

    fn turn_by_keys(&mut self, ui: &Ui) {
        let (opposite, pressed) = ui.input(|input| {
            let keys = [Key::Num1, Key::Num3, Key::Num7, Key::Num5];
            (input.modifiers.command, keys.into_iter().find(|&key| input.key_pressed(key)))
        });
        let facing = match (pressed, opposite) {
            (Some(Key::Num1), false) => Facing::Front,
            (Some(Key::Num1), true) => Facing::Back,
            (Some(Key::Num3), false) => Facing::Side,
            (Some(Key::Num3), true) => Facing::OtherSide,
            (Some(Key::Num7), false) => Facing::Top,
            (Some(Key::Num7), true) => Facing::Bottom,
            (Some(Key::Num5), _) => return self.change_projection(),
            _ => return,
        };
        self.face(ui, facing);
    }

    /// Looks along an axis.
    pub(super) fn face(&mut self, ui: &Ui, facing: Facing) {
        let turned = Camera::facing(facing);
        let to = Camera { yaw: turned.yaw, pitch: turned.pitch, ..self.pane.camera };
        self.pane.ease_to(to, ui.input(|input| input.time));
    }

    /// Between perspective and parallel lines.
    pub(super) fn change_projection(&mut self) {
        let camera = &mut self.pane.camera;
        let parallel = camera.projection == Projection::Parallel;
        camera.projection = if parallel { Camera::perspective().projection } else { Projection::Parallel };
        self.pane.ease = None;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_camera_eases_the_shorter_way_and_arrives() {
        let from = Camera { yaw: 0.1, height: 1.0, ..Camera::perspective() };
        let to = Camera { yaw: TAU - 0.1, height: 4.0, ..from };
        let ease = Ease { from, to, start: 2.0 };
        let (half, arrived) = ease.at(2.0 + 0.5 * EASE_SECONDS);
        assert!(!arrived && half.yaw.abs() < 1e-12 && (half.height - 2.0).abs() < 1e-12, "{half:?}");
        assert_eq!(ease.at(3.0), (to, true));
    }
}
