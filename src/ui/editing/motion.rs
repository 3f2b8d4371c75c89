//! Moves, turns and scalings of what is selected, from the first touch to the last.

use super::body::{body_subject, end_body, show_placed};
use super::courses::{seen_pivot, view_from_model};
use super::moving::{Asked, Change, Kind, Moving, Subject, seen_angle, step_for};
use super::set::{set_fibres, set_sheet};
use super::state::Editing;
use crate::edit::fibre_ops::{self, Edited, FibreEditError};
use crate::edit::sheet_ops;
use crate::ui::context::{Context, Severity, Step};
use crate::ui::views::{PaneKind, ViewFrame};
use egui::{Pos2, Response, Ui};
use glam::{DMat3, DVec3};

/// What undo calls copies, moved or not.
pub(super) const DUPLICATE: &str = "Duplicate";
/// Copies that were not moved are put aside by this share of the body's diagonal.
const APART: f64 = 0.04;
/// A scaling that begins nearer to the pivot than this goes on from there as if it were so far away [points].
const LEAST_LEVER: f64 = 40.0;

/// Begins to move, turn or scale what is selected.
pub(crate) fn begin_moving(
    editing: &mut Editing,
    kind: Kind,
    axis: Option<usize>,
    view: PaneKind,
    start: Pos2,
    by_drag: bool,
    cx: &mut Context,
) {
    let found = if cx.selection.is_body() {
        body_subject(cx)
    } else if let Some((_, sheet)) = cx.selected_sheet() {
        let subject = Subject::Sheet(Box::new(sheet.clone()));
        cx.pivot().map(|pivot| (subject, pivot))
    } else {
        fibres_subject(cx)
    };
    let Some((subject, pivot)) = found else {
        cx.say(Severity::Warning, "Select a fibre, a sheet or a body first: click it in a view or in the list");
        return;
    };
    let (gesture, step) = (cx.begin_gesture(), step_for(cx.active.diagonal()));
    let typed = String::new();
    let moving = Moving { kind, axis, typed, by_drag, start, pivot, subject, gesture, step };
    editing.pending = None;
    editing.moving = Some((moving, view));
}

/// The selected fibres or vertices, and their middle [m]; none if nothing is selected.
fn fibres_subject(cx: &Context) -> Option<(Subject, DVec3)> {
    let pivot = cx.pivot()?;
    let vertices = cx.selection.vertices().map(<[usize]>::to_vec);
    let originals = match vertices {
        Some(_) => cx.selected_fibre().map(|(_, fibre)| fibre.clone()).into_iter().collect(),
        None => cx.selected_fibres().into_iter().cloned().collect(),
    };
    Some((Subject::Fibres { originals, vertices, copied: None }, pivot))
}

/// What is moved are copies of these fibres: to copy and to move them are one step of undo.
pub(crate) fn moves_copies(editing: &mut Editing, number: u64, of: Vec<String>) {
    if let Some((Moving { gesture, subject: Subject::Fibres { copied, .. }, .. }, _)) = &mut editing.moving {
        *gesture = number;
        *copied = Some(of);
    }
}

/// Copies that were not moved are put beside what they are copies of.
fn part_copies(editing: &mut Editing, cx: &mut Context) {
    let Some((Moving { pivot, subject: Subject::Fibres { originals, copied, .. }, .. }, _)) = &editing.moving else {
        return;
    };
    let are_there = cx.selected_fibres().into_iter().eq(originals.iter());
    if copied.is_none() || !are_there {
        return;
    }
    let bounds = cx.active.bounds();
    let inwards = bounds.map_or(1.0, |bounds| if bounds.center().x < pivot.x { -1.0 } else { 1.0 });
    let apart = cx.sampling().spacing.max(APART * cx.active.diagonal());
    editing.pending = Some(Change::Move(inwards * apart * DVec3::X));
    follow_moving(editing, true, cx);
}

/// Puts the fibres where a gesture has them now, once the simulation has taken up where they were before, or `at_once`.
fn follow_moving(editing: &mut Editing, at_once: bool, cx: &mut Context) {
    let Some((Moving { kind, pivot, gesture, subject, .. }, _)) = &editing.moving else { return };
    let taken_up = at_once || cx.simulation.is_up_to_date();
    let Some(change) = editing.pending.take_if(|_| taken_up) else { return };
    let sampling = cx.sampling();
    let verb = match kind {
        Kind::Move => "Move",
        Kind::Turn => "Turn",
        Kind::Scale => "Scale",
    };
    let (originals, vertices, copied) = match subject {
        Subject::Fibres { originals, vertices, copied } => (originals, vertices, copied),
        Subject::Sheet(original) => {
            let moved = change.about(*pivot).and_then(|by| sheet_ops::transform(original, &by, sampling));
            return set_sheet(cx, verb, moved, Step::Of(*gesture));
        }
        Subject::Body { .. } => return,
    };
    let moved: Result<Vec<Edited>, FibreEditError> = change.about(*pivot).and_then(|by| {
        let edit = |fibre| match vertices {
            Some(chosen) => fibre_ops::transform_vertices(fibre, chosen, &by, sampling),
            None => fibre_ops::transform(fibre, &by, sampling),
        };
        originals.iter().map(edit).collect()
    });
    let verb = if copied.is_some() { DUPLICATE } else { verb };
    set_fibres(cx, verb, moved, Step::Of(*gesture));
}

/// Ends a gesture: what it has come to stays, or everything is as it was.
pub(super) fn end_moving(editing: &mut Editing, keep: bool, cx: &mut Context) {
    if editing.moving.as_ref().is_some_and(|(moving, _)| moving.is_body()) {
        return end_body(editing, keep, cx);
    }
    if keep {
        // What waits for the simulation is not lost.
        follow_moving(editing, true, cx);
        part_copies(editing, cx);
    }
    editing.pending = None;
    let Some((moving, _)) = editing.moving.take() else { return };
    if !keep {
        cx.abandon(moving.gesture);
        if let Subject::Fibres { copied: Some(copied), .. } = moving.subject {
            cx.selection.set(copied);
        }
    }
    cx.begin_gesture();
}

/// Follows a move, turn or scaling in the view in which it goes on; whether there is one here.
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
    let view_from_model = if moving.is_body() { DMat3::IDENTITY } else { view_from_model(frame.kind, cx) };
    let pivot = match (frame.kind, moving.is_body()) {
        (PaneKind::Result, true) => moving.pivot,
        _ => seen_pivot(frame.kind, moving.pivot, cx),
    };
    if let Some(seen) = frame.camera.project(pivot, size) {
        let place = |at: Pos2| frame.camera.point_at(frame.pixel(at), seen.depth, size);
        let by = view_from_model.transpose() * (place(at) - place(moving.start));
        let away = |at: Pos2| frame.pixel(at).distance(seen.pixel);
        let asked = Asked {
            to: moving.pivot + by,
            stretch: 1.0 + (away(at) - away(moving.start)) / away(moving.start).max(LEAST_LEVER),
            angle: seen_angle(frame.pixel(moving.start), frame.pixel(at), seen.pixel),
            toward_eye: view_from_model.transpose() * frame.camera.world_from_view().z_axis,
            fine: modifiers.shift,
            snap: modifiers.command,
        };
        editing.pending = Some(moving.change(&asked));
    }
    let by_drag = moving.by_drag;
    if moving.is_body() {
        show_placed(editing, cx);
    } else {
        follow_moving(editing, false, cx);
    }
    ui.ctx().request_repaint();
    if other {
        end_moving(editing, false, cx);
        editing.given_up = true;
    } else if (by_drag && released) || (!by_drag && pressed && response.contains_pointer()) {
        end_moving(editing, true, cx);
    }
    true
}
