//! The cameras of the views: fitting, moving by pointer and keys.

use super::displayed::DisplayedState;
use super::frame::ViewFrame;
use super::kind::{PaneKind, facing};
use super::links::Links;
use super::pane::Pane;
use crate::draw::Bounds;
use crate::render::{Camera, Facing, Projection};
use crate::solver::snapshot::BodySnapshot;
use crate::ui::context::Context;
use crate::ui::navigation::{CameraMove, Navigation};
use egui::{Key, PointerButton, Pos2, Rect, Response, Ui, Vec2};
use glam::{DVec2, DVec3};
use std::sync::Arc;

/// A drawing view leaves this much room around the model.
const DRAWING_MARGIN: f64 = 1.15;
/// Bodies that are shown beside their ghosts leap by up to this share of their height.
const LEAP: f64 = 1.0;
/// Turn of the result view for each pixel of a drag [rad].
const TURN: f64 = 0.008;
/// What is seen grows by this power of e for each point of a drag, and shrinks by it for each of a wheel.
const ZOOM: f32 = 0.005;
const WHEEL_ZOOM: f32 = 0.002;

fn aspect(rect: Rect) -> f64 {
    f64::from(rect.width() / rect.height().max(1.0))
}

/// Fits the camera, where that was asked for, and moves it on where it is on its way.
pub(super) fn settle(pane: &mut Pane, ui: &Ui, links: &Links, follows: bool, cx: &Context) {
    let now = ui.input(|input| input.time);
    // Before the first frame it is not known where the drawing views lie, whose scales depend on each other.
    if !pane.framed
        && !links.drawing.is_empty()
        && cx.simulation.has_opened()
        && let Some(bounds) = to_fit(pane.kind, links.fits_selected, cx)
    {
        let mut camera = pane.camera;
        camera.frame(&bounds, aspect(pane.rect));
        if matches!(pane.kind, PaneKind::Drawing(_)) {
            // Both drawing views show to one scale, that of the one which needs more room.
            for (view, rect) in &links.drawing {
                let mut other = Camera::facing(facing(*view));
                other.frame(&bounds, aspect(*rect));
                camera.height = camera.height.max(other.height);
            }
            camera.height *= DRAWING_MARGIN;
        }
        // The first time there is nowhere to come from.
        if pane.shown {
            pane.ease_to(camera, now);
        } else {
            pane.camera = camera;
            pane.shown = true;
        }
        pane.framed = true;
    }
    if pane.kind == PaneKind::Result {
        keep_up(pane, follows, cx);
    }
    if let Some(ease) = pane.ease {
        let (camera, arrived) = ease.at(now);
        pane.camera = camera;
        if arrived {
            pane.ease = None;
        } else {
            ui.ctx().request_repaint();
        }
    }
}

/// Goes along with the active body, where the camera follows it.
fn keep_up(pane: &mut Pane, follows: bool, cx: &Context) {
    let particles = cx.simulation.published().snapshot.bodies.get(cx.active.index).map(|body| &body.particles[..]);
    let Some(particles) = particles.filter(|particles| follows && !particles.is_empty()) else {
        pane.followed = None;
        return;
    };
    let of = (cx.active.index, Arc::clone(&cx.simulation.published().at_rest));
    let middle = particles.iter().sum::<DVec3>() / particles.len() as f64;
    let before = pane.followed.take().filter(|(body, rest, _)| *body == of.0 && Arc::ptr_eq(rest, &of.1));
    if let Some((_, _, before)) = before
        && (middle - before).is_finite()
    {
        let by = middle - before;
        pane.camera.target += by;
        if let Some(ease) = &mut pane.ease {
            ease.shift(by);
        }
    }
    pane.followed = middle.is_finite().then_some((of.0, of.1, middle));
}

/// What a view is to be fitted to; none before there is anything.
fn to_fit(kind: PaneKind, fits_selected: bool, cx: &Context) -> Option<Bounds> {
    let points = |bodies: &[BodySnapshot]| {
        Bounds::of(bodies.iter().flat_map(|body| {
            let solid = if body.skin.is_empty() { &body.particles } else { &body.skin };
            solid.iter().copied()
        }))
    };
    let shown = DisplayedState::of(kind, cx);
    if fits_selected && let Some(bounds) = selected_bounds(&shown, cx) {
        return Some(bounds);
    }
    match kind {
        PaneKind::Drawing(_) => points(&shown.bodies),
        // The whole fall is to be seen, from the start down to the floor, whenever in it the view is fitted.
        PaneKind::Result => points(&shown.bodies).map(|bounds| {
            let [low, high] = cx.simulation.published().placed.unwrap_or([bounds.min, bounds.max]);
            let floor = cx.scene().room.floor.unwrap_or(bounds.min.y);
            // A ghost beside it needs its own room, and one that shows a leap room for that.
            let leap = if cx.ghost_beside { LEAP * (high.y - low.y) } else { 0.0 };
            let aside = cx.ghost_aside() + leap * DVec3::Y;
            Bounds { min: bounds.min.min(low).min(bounds.min.with_y(floor)), max: bounds.max.max(high) + aside }
        }),
    }
}

fn selected_bounds(shown: &DisplayedState, cx: &Context) -> Option<Bounds> {
    if cx.selection.is_body() && matches!(shown, DisplayedState::Running(_)) {
        return Bounds::of(shown.bodies.get(cx.active.index)?.particles.iter().copied());
    }
    let fibres = shown.bodies.iter().flat_map(|body| &body.fibres);
    let chosen = fibres.filter(|fibre| cx.selection.contains(&fibre.id));
    let sheets = shown.bodies.iter().flat_map(|body| &body.sheets);
    let sheets = sheets.filter(|sheet| cx.selection.sheet() == Some(&sheet.id));
    let points = chosen.flat_map(|fibre| &fibre.vertices).chain(sheets.flat_map(|sheet| &sheet.vertices));
    let bounds = Bounds::of(points.copied())?;
    // Room to see what it lies in.
    let room = DVec3::splat(0.25 * bounds.radius());
    Some(Bounds { min: bounds.min - room, max: bounds.max + room })
}

/// Moves the camera as the pointer, the fingers and the keys ask for; a drawing view takes the other one along.
pub(super) fn follow(pane: &mut Pane, ui: &Ui, response: &Response, links: &mut Links, navigation: Navigation) {
    let frame = ViewFrame { kind: pane.kind, rect: response.rect, camera: pane.camera };
    let before = pane.camera;
    let (delta, modifiers) = ui.input(|input| (input.pointer.delta(), input.modifiers));
    let buttons = [PointerButton::Primary, PointerButton::Middle, PointerButton::Secondary];
    let held = buttons.into_iter().filter(|button| response.dragged_by(*button));
    if let Some(what) = held.filter_map(|button| navigation.dragged(button, modifiers)).next_back() {
        let by = if what == CameraMove::Zoom { ZOOM * delta.y } else { 0.0 };
        go(pane, &frame, what, delta, by, frame.rect.center());
    }
    if response.hovered() {
        let at = ui.input(|input| input.pointer.hover_pos()).unwrap_or(frame.rect.center());
        if let Some((what, by)) = navigation.scrolled(ui) {
            go(pane, &frame, what, by, -WHEEL_ZOOM * by.y, at);
        }
        let pinched = ui.input(egui::InputState::zoom_delta);
        if pinched > 0.0 && pinched != 1.0 {
            go(pane, &frame, CameraMove::Zoom, Vec2::ZERO, -pinched.ln(), at);
        }
    }
    if pane.camera != before {
        // A hand on the camera is stronger than where it was sent.
        pane.ease = None;
    }
    if pane.kind == PaneKind::Result && response.hovered() && !ui.ctx().egui_wants_keyboard_input() {
        turn_by_keys(pane, ui);
    }
    if let PaneKind::Drawing(view) = pane.kind
        && pane.camera != before
    {
        links.moved = Some((view, pane.camera));
    }
}

/// Turns or moves the camera by so many points, or has what it sees grow by the power of e that `further` is, about
/// what lies under `at`.
fn go(pane: &mut Pane, frame: &ViewFrame, what: CameraMove, by: Vec2, further: f32, at: Pos2) {
    let moved = DVec2::new(f64::from(by.x), f64::from(by.y));
    match what {
        CameraMove::Turn if pane.kind == PaneKind::Result => pane.camera.orbit(-TURN * moved.x, TURN * moved.y),
        CameraMove::Turn | CameraMove::Pan => pane.camera.pan(moved, frame.size()),
        CameraMove::Zoom => pane.camera.zoom(f64::from(further).exp(), frame.pixel(at), frame.size()),
    }
}

fn turn_by_keys(pane: &mut Pane, ui: &Ui) {
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
        (Some(Key::Num5), _) => return change_projection(pane),
        _ => return,
    };
    face(pane, ui, facing);
}

/// Looks along an axis.
pub(super) fn face(pane: &mut Pane, ui: &Ui, facing: Facing) {
    let turned = Camera::facing(facing);
    let to = Camera { yaw: turned.yaw, pitch: turned.pitch, ..pane.camera };
    pane.ease_to(to, ui.input(|input| input.time));
}

/// Between perspective and parallel lines.
pub(super) fn change_projection(pane: &mut Pane) {
    let camera = &mut pane.camera;
    let parallel = camera.projection == Projection::Parallel;
    camera.projection = if parallel { Camera::perspective().projection } else { Projection::Parallel };
    pane.ease = None;
}
