//! A body that is moved, turned or scaled.
//!
//! How it works. What is changed is where it starts, so that the simulation goes back there and rests while the gesture
//! goes on. The result view shows the bodies as they would be placed ([`Context::placed`]); the document changes once,
//! at the end, and the simulation goes on if it ran.

use super::moving::{Change, Kind, Subject};
use super::state::Editing;
use crate::edit::Command;
use crate::edit::body_ops::{copy, moved, placed, scaled, turned};
use crate::edit::fibre_ops::FibreEditError;
use crate::scene::OwnedBody;
use crate::sim::SimCommand;
use crate::solver::snapshot::{BodySnapshot, Snapshot};
use crate::ui::bodies::{begin_anew, beside, scaled_model};
use crate::ui::context::{Context, Request, Severity, Step};
use glam::{DQuat, DVec3};
use std::sync::Arc;

/// The body that is selected, and its middle where it starts [m]; none before it is put together. The simulation rests
/// at its start from now on.
pub(super) fn body_subject(cx: &mut Context) -> Option<(Subject, DVec3)> {
    let (original, pivot) = (cx.chosen_body()?.owned(), cx.body_pivot()?);
    let plays = cx.simulation.is_playing();
    cx.ask(SimCommand::Pause);
    begin_anew(cx);
    Some((Subject::Body { original, copies: false, plays }, pivot))
}

/// What is moved is a copy of the body.
pub(crate) fn move_copy(editing: &mut Editing) {
    if let Some((moving, _)) = &mut editing.moving
        && let Subject::Body { copies, .. } = &mut moving.subject
    {
        *copies = true;
    }
}

/// The point that stays where it is as a body is scaled: what stands on a floor goes on standing as high above it.
fn foot(pivot: DVec3, cx: &Context) -> DVec3 {
    let rest = cx.active.model.bodies.first().map(|body| &body.particles);
    let placement = cx.chosen_body().map(|body| body.placement().clone());
    let (Some(rest), Some(placement), Some(_)) = (rest, placement, cx.scene().room.floor) else { return pivot };
    let low = rest.iter().map(|&at| placed(&placement, at).y).fold(f64::INFINITY, f64::min);
    if low.is_finite() { pivot.with_y(low) } else { pivot }
}

fn changed(body: &OwnedBody, change: Change, pivot: DVec3, cx: &Context) -> Result<OwnedBody, FibreEditError> {
    match change {
        Change::Move(by) => Ok(moved(body, by)),
        Change::Turn(axis, radians) => turned(body, pivot, axis, radians),
        Change::Scale(factor) => scaled(body, foot(pivot, cx), factor),
    }
}

/// Shows every body where it starts, and the one that is moved where it would be put.
pub(super) fn show_placed(editing: &Editing, cx: &mut Context) {
    let (Some((moving, _)), Some(change)) = (&editing.moving, editing.pending) else { return };
    let Subject::Body { copies, .. } = &moving.subject else { return };
    let rest = &cx.simulation.published().at_rest.bodies;
    let (about, turn, factor, by) = match change {
        Change::Move(by) => (moving.pivot, DQuat::IDENTITY, 1.0, by),
        Change::Turn(axis, radians) => {
            (moving.pivot, DQuat::from_axis_angle(axis.normalize_or(DVec3::Y), radians), 1.0, DVec3::ZERO)
        }
        Change::Scale(factor) => (foot(moving.pivot, cx), DQuat::IDENTITY, factor, DVec3::ZERO),
    };
    let mut bodies = Vec::with_capacity(rest.len() + 1);
    let mut copied = None;
    for (index, (body, rest)) in cx.scene().all_bodies().zip(rest).enumerate() {
        let place = |at: DVec3| placed(body.placement(), at);
        let change = |at: DVec3| about + factor * (turn * (place(at) - about)) + by;
        if index != cx.active.index {
            bodies.push(mapped(rest, place));
        } else if *copies {
            bodies.push(mapped(rest, place));
            copied = Some(mapped(rest, change));
        } else {
            bodies.push(mapped(rest, change));
        }
    }
    bodies.extend(copied);
    let panels = cx.scene().panels.iter().map(|panel| panel.height).collect();
    let shown = Snapshot { bodies, panels, ..Snapshot::default() };
    if cx.placed.as_deref() != Some(&shown) {
        cx.placed = Some(Arc::new(shown));
    }
}

/// A body elsewhere; its skin follows its particles.
fn mapped(body: &BodySnapshot, map: impl Fn(DVec3) -> DVec3) -> BodySnapshot {
    let mut mapped = body.clone();
    (mapped.skin, mapped.normals) = (Vec::new(), Vec::new());
    mapped.breaks.clear();
    let fibres = mapped.fibres.iter_mut().flat_map(|fibre| &mut fibre.vertices);
    let sheets = mapped.sheets.iter_mut().flat_map(|sheet| &mut sheet.vertices);
    for point in mapped.particles.iter_mut().chain(fibres).chain(sheets) {
        *point = map(*point);
    }
    mapped
}

/// Ends a gesture: the body, or a copy of it, is put where it was brought, or nothing has been.
pub(super) fn end_body(editing: &mut Editing, keep: bool, cx: &mut Context) {
    let change = editing.pending.take();
    cx.placed = None;
    let Some((moving, _)) = editing.moving.take() else { return };
    let Subject::Body { original, copies, plays } = moving.subject else { return };
    if keep {
        let change = change.unwrap_or(Change::Move(DVec3::ZERO));
        match changed(&original, change, moving.pivot, cx) {
            Ok(body) if copies => put_copy(&body, moving.pivot, cx),
            Ok(body) => put(&original, body, moving.kind, cx),
            Err(error) => cx.say(Severity::Error, error.to_string()),
        }
    }
    if plays {
        cx.ask(SimCommand::Play);
    }
    cx.begin_gesture();
}

fn put(original: &OwnedBody, body: OwnedBody, kind: Kind, cx: &mut Context) {
    if original.view().model().is_some_and(|model| !scaled_model(model, &body, cx)) {
        cx.say(Severity::Error, "The model has no inside in that size");
        return;
    }
    let verb = match kind {
        Kind::Move => "Move",
        Kind::Turn => "Turn",
        Kind::Scale => "Scale",
    };
    cx.edit(&Command::SetBody { verb: verb.to_owned(), body }, Step::Own);
    begin_anew(cx);
}

/// A copy that was hardly moved is put where there is room for it.
fn put_copy(body: &OwnedBody, pivot: DVec3, cx: &mut Context) {
    let mut body = copy(body, cx.scene());
    let was = cx.chosen_body().map(|body| DVec3::from_array(body.placement().translation));
    let now = DVec3::from_array(body.view().placement().translation);
    if was.is_some_and(|was| was.distance(now) < 0.05 * cx.active.diagonal())
        && let Some(bounds) = cx.active.bounds()
    {
        let half = 0.5 * (bounds.max - bounds.min);
        let aside = beside(half, cx);
        // As high as what it is a copy of.
        body = moved(&body, aside.with_y(pivot.y) - pivot);
    }
    let (id, name) = (body.view().id().to_owned(), format!("Duplicate {}", body.view().title()));
    cx.edit(&Command::Many { name, commands: vec![Command::AddBody(body)] }, Step::Own);
    begin_anew(cx);
    cx.request(Request::ChooseBody(id));
}
