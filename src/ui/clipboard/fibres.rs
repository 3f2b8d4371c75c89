//! Fibres as text, with the drives that they follow.

use crate::draw::Bounds;
use crate::edit::Command;
use crate::edit::fibre_ops::{self, Transform};
use crate::scene::{Body, Drive, Fibre, SharedDrive};
use crate::ui::context::{Context, Severity, Step};
use glam::DVec3;
use serde::{Deserialize, Serialize};

/// What the text says that it holds.
pub(super) const FIBRES: &str = "fibres";
/// Fibres that would lie on their like are put aside by this share of the body's diagonal.
const APART: f64 = 0.04;

/// What is put on the clipboard. Places are those of the model frame [m].
#[derive(Serialize, Deserialize)]
struct Clipping {
    sinew: String,
    fibres: Vec<Fibre>,
    /// Those of the body's drives that the fibres name.
    #[serde(default)]
    drives: Vec<SharedDrive>,
}

/// The selected fibres as text.
pub(super) fn copied(cx: &mut Context) -> Option<String> {
    let fibres: Vec<Fibre> = cx.selected_fibres().into_iter().cloned().collect();
    let count = fibres.len();
    let names = |drive: &&SharedDrive| fibres.iter().any(|fibre| shared(fibre).is_some_and(|id| *id == drive.id));
    let drives = cx.active_body().map_or_else(Vec::new, |body| body.drives.iter().filter(names).cloned().collect());
    let text = serde_json::to_string_pretty(&Clipping { sinew: FIBRES.to_owned(), fibres, drives }).ok()?;
    cx.say(Severity::Note, format!("Copied {}", counted(count)));
    Some(text)
}

/// Puts the fibres of a text into the body, selected; false where the text holds none.
pub(super) fn paste(text: &str, cx: &mut Context) -> bool {
    let clipping = serde_json::from_str::<Clipping>(text).ok().filter(|clipping| !clipping.fibres.is_empty());
    let Some(Clipping { mut fibres, drives, .. }) = clipping else { return false };
    let Some(body) = cx.active_body() else {
        cx.say(Severity::Error, "Fibres go into fibre solids: choose one in the list of bodies");
        return true;
    };
    let id = body.id.clone();
    for fibre in &mut fibres {
        settle(fibre, &drives, body);
    }
    let copies = fibre_ops::copies(fibres.iter(), &body.fibres);
    let by = Transform::translation(aside(&copies, cx));
    let sampling = cx.sampling();
    let moved: Result<Vec<Fibre>, _> =
        copies.iter().map(|fibre| fibre_ops::transform(fibre, &by, sampling).map(|edited| edited.fibre)).collect();
    match moved {
        Ok(fibres) => {
            let (count, chosen): (_, Vec<String>) = (fibres.len(), fibres.iter().map(|f| f.id.clone()).collect());
            cx.say(Severity::Note, format!("Pasted {}", counted(count)));
            cx.edit(&Command::add_fibres("Paste", &id, fibres), Step::Own);
            let there = chosen.into_iter().filter(|id| is_there(cx, id)).collect::<Vec<_>>();
            cx.selection.set(there);
        }
        Err(error) => cx.say(Severity::Error, error.to_string()),
    }
    true
}

/// The name of the shared drive that a fibre follows.
fn shared(fibre: &Fibre) -> Option<&String> {
    match &fibre.activation.as_ref()?.drive {
        Drive::Shared(id) => Some(id),
        _ => None,
    }
}

/// Gives a fibre the drive that it followed where it is from, one of `drives`, for its own, unless the body that it
/// goes into has the same.
fn settle(fibre: &mut Fibre, drives: &[SharedDrive], body: &Body) {
    let drive_in = |drives: &[SharedDrive]| {
        let id = shared(fibre)?;
        drives.iter().find(|drive| drive.id == *id).map(|drive| drive.drive.clone())
    };
    let (followed, here) = (drive_in(drives), drive_in(&body.drives));
    if followed != here
        && let (Some(activation), Some(followed)) = (&mut fibre.activation, followed)
    {
        activation.drive = followed;
    }
}

/// By how much pasted fibres are moved [m]: into a body that lies elsewhere, and off their like.
fn aside(fibres: &[Fibre], cx: &Context) -> DVec3 {
    let (Some(room), Some(body)) = (cx.active.bounds(), cx.active_body()) else { return DVec3::ZERO };
    let sampling = cx.sampling();
    let points = fibres.iter().flat_map(|fibre| fibre_ops::vertices(fibre, sampling).unwrap_or_default());
    let Some(bounds) = Bounds::of(points) else { return DVec3::ZERO };
    let middle = bounds.center();
    if middle.cmplt(room.min).any() || middle.cmpgt(room.max).any() {
        return room.center() - middle;
    }
    let lies_on_like = fibres.iter().any(|fibre| body.fibres.iter().any(|known| known.source == fibre.source));
    if !lies_on_like {
        return DVec3::ZERO;
    }
    let inwards = if room.center().x < middle.x { -1.0 } else { 1.0 };
    inwards * sampling.spacing.max(APART * cx.active.diagonal()) * DVec3::X
}

fn is_there(cx: &Context, fibre: &str) -> bool {
    cx.active_body().is_some_and(|body| body.fibres.iter().any(|known| known.id == fibre))
}

fn counted(count: usize) -> String {
    if count == 1 { "one fibre".to_owned() } else { format!("{count} fibres") }
}
