//! Moves and turns of what is selected, from the first touch to the last.

use super::courses::{seen_pivot, view_from_model};
use super::moving::{Asked, Kind, Moving, seen_angle, step_for};
use super::set::set_fibres;
use super::state::Editing;
use crate::edit::fibre_ops::{self, Edited, FibreEditError, Transform};
use crate::ui::context::{Context, Severity, Step};
use crate::ui::views::{PaneKind, ViewFrame};
use egui::{Pos2, Response, Ui};
use glam::DVec3;

/// What undo calls copies, moved or not.
pub(super) const DUPLICATE: &str = "Duplicate";
/// Copies that were not moved are put aside by this share of the body's diagonal.
const APART: f64 = 0.04;

/// Begins to move or turn what is selected.
pub(crate) fn begin_moving(
    editing: &mut Editing,
    kind: Kind,
    axis: Option<usize>,
    view: PaneKind,
    start: Pos2,
    by_drag: bool,
    cx: &mut Context,
) {
    let Some(pivot) = cx.pivot() else {
        cx.say(Severity::Warning, "Select a fibre first: click it in a view or in the list");
        return;
    };
    let vertices = cx.selection.vertices().map(<[usize]>::to_vec);
    let originals = match vertices {
        Some(_) => cx.selected_fibre().map(|(_, fibre)| fibre.clone()).into_iter().collect(),
        None => cx.selected_fibres().into_iter().cloned().collect(),
    };
    let (gesture, step) = (cx.begin_gesture(), step_for(cx.active.diagonal()));
    let typed = String::new();
    let copied = None;
    let moving = Moving { kind, axis, typed, by_drag, start, pivot, originals, vertices, gesture, step, copied };
    editing.moving = Some((moving, view));
}

/// What is moved are copies of these fibres: to copy and to move them are one step of undo.
pub(crate) fn moves_copies(editing: &mut Editing, gesture: u64, of: Vec<String>) {
    if let Some((moving, _)) = &mut editing.moving {
        moving.gesture = gesture;
        moving.copied = Some(of);
    }
}

/// Copies that were not moved are put beside what they are copies of.
fn part_copies(editing: &mut Editing, cx: &mut Context) {
    let Some((moving, _)) = &editing.moving else { return };
    let are_there = cx.selected_fibres().into_iter().eq(moving.originals.iter());
    if moving.copied.is_none() || !are_there {
        return;
    }
    let bounds = cx.active.bounds();
    let inwards = bounds.map_or(1.0, |bounds| if bounds.center().x < moving.pivot.x { -1.0 } else { 1.0 });
    let apart = cx.sampling().spacing.max(APART * cx.active.diagonal());
    editing.pending = Some(Transform::translation(inwards * apart * DVec3::X));
    follow_moving(editing, true, cx);
}

/// Puts the fibres where a gesture has them now, once the simulation has taken up where they were before, or `at_once`.
fn follow_moving(editing: &mut Editing, at_once: bool, cx: &mut Context) {
    let taken_up = at_once || cx.simulation.is_up_to_date();
    let Some(by) = editing.pending.take_if(|_| taken_up) else { return };
    let Some((moving, _)) = &editing.moving else { return };
    let sampling = cx.sampling();
    let moved: Result<Vec<Edited>, FibreEditError> = moving
        .originals
        .iter()
        .map(|fibre| match &moving.vertices {
            Some(chosen) => fibre_ops::transform_vertices(fibre, chosen, &by, sampling),
            None => fibre_ops::transform(fibre, &by, sampling),
        })
        .collect();
    let verb = match (moving.kind, &moving.copied) {
        (_, Some(_)) => DUPLICATE,
        (Kind::Move, None) => "Move",
        (Kind::Turn, None) => "Turn",
    };
    set_fibres(cx, verb, moved, Step::Of(moving.gesture));
}

/// Ends a gesture: what it has come to stays, or everything is as it was.
pub(super) fn end_moving(editing: &mut Editing, keep: bool, cx: &mut Context) {
    if keep {
        // What waits for the simulation is not lost.
        follow_moving(editing, true, cx);
        part_copies(editing, cx);
    }
    editing.pending = None;
    let Some((moving, _)) = editing.moving.take() else { return };
    if !keep {
        cx.abandon(moving.gesture);
        if let Some(copied) = moving.copied {
            cx.selection.set(copied);
        }
    }
    cx.begin_gesture();
}

/// Follows a move or turn in the view in which it goes on; whether there is one here.
pub(super) fn follow_pointer(
    editing: &mut Editing,
    ui: &Ui,
    response: &Response,
    frame: &ViewFrame,
    cx: &mut Context,
) -> bool {
    let Some((moving, view)) = &editing.moving else { return false };
    if *view != frame.kind {
        return false;
    }
    let (at, modifiers, pressed, other, released) = ui.input(|input| {
        let pointer = &input.pointer;
        (
            pointer.latest_pos(),
            input.modifiers,
            pointer.primary_pressed(),
            pointer.secondary_pressed(),
            pointer.primary_released(),
        )
    });
    let Some(at) = at else { return true };
    let size = frame.size();
    let view_from_model = view_from_model(frame.kind, cx);
    let pivot = seen_pivot(frame.kind, moving.pivot, cx);
    if let Some(seen) = frame.camera.project(pivot, size) {
        let place = |at: Pos2| frame.camera.point_at(frame.pixel(at), seen.depth, size);
        let by = view_from_model.transpose() * (place(at) - place(moving.start));
        let asked = Asked {
            to: moving.pivot + by,
            angle: seen_angle(frame.pixel(moving.start), frame.pixel(at), seen.pixel),
            toward_eye: view_from_model.transpose() * frame.camera.world_from_view().z_axis,
            fine: modifiers.shift,
            snap: modifiers.command,
        };
        editing.pending = moving.transform(&asked).ok();
    }
    let by_drag = moving.by_drag;
    follow_moving(editing, false, cx);
    ui.ctx().request_repaint();
    if other {
        end_moving(editing, false, cx);
        editing.given_up = true;
    } else if (by_drag && released) || (!by_drag && pressed && response.contains_pointer()) {
        end_moving(editing, true, cx);
    }
    true
}
