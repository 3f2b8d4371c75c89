//! Moves and turns of what is selected, from the first touch to the last.

use super::courses::{seen_pivot, view_from_model};
use super::moving::{Asked, Kind, Moving, seen_angle, step_for};
use super::set::set_fibres;
use super::state::Editing;
use crate::edit::fibre_ops::{self, Edited, FibreEditError};
use crate::ui::context::{Context, Severity, Step};
use crate::ui::views::{PaneKind, ViewFrame};
use egui::{Pos2, Response, Ui};

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
    let moving = Moving { kind, axis, typed, by_drag, start, pivot, originals, vertices, gesture, step };
    editing.moving = Some((moving, view));
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
    let verb = match moving.kind {
        Kind::Move => "Move",
        Kind::Turn => "Turn",
    };
    set_fibres(cx, verb, moved, Step::Of(moving.gesture));
}

/// Ends a gesture: what it has come to stays, or everything is as it was.
pub(super) fn end_moving(editing: &mut Editing, keep: bool, cx: &mut Context) {
    if keep {
        // What waits for the simulation is not lost.
        follow_moving(editing, true, cx);
    }
    editing.pending = None;
    let Some((moving, _)) = editing.moving.take() else { return };
    if !keep {
        cx.abandon(moving.gesture);
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
    } else if (by_drag && released) || (!by_drag && pressed && response.contains_pointer()) {
        end_moving(editing, true, cx);
    }
    true
}
