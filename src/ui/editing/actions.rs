//! What the menu does to the selected fibres and vertices.

use super::motion::DUPLICATE;
use super::set::{set_fibres, set_sheet};
use crate::edit::fibre_ops::{self, Edited, FibreEditError, ResampleTo, Transform};
use crate::edit::{Command, Item, sheet_ops};
use crate::scene::Fibre;
use crate::ui::context::{Context, Severity, Step};
use glam::DVec3;

/// Passes of smoothing that one command makes.
const SMOOTHING: usize = 4;
/// Depth under the surface to which fibres are snapped, in particle spacings: at the surface itself they would carry
/// little.
const SNAP_DEPTH: f64 = 0.5;
/// What is done where copies are mirrored.
const MIRRORED: &str = "Mirrored copy of";
/// Where a vertex is inserted on its edge.
const MIDDLE: f64 = 0.5;

/// Changes every selected fibre in one step.
fn each(cx: &mut Context, verb: &str, change: impl Fn(&Fibre) -> Result<Edited, FibreEditError>) {
    let edited = cx.selected_fibres().into_iter().map(change).collect();
    set_fibres(cx, verb, edited, Step::Own);
}

/// Selects every fibre of the body, or every vertex of the fibre.
pub(crate) fn select_all(cx: &mut Context) {
    if cx.selection.vertices().is_some() {
        let count = cx.active_vertices().len();
        cx.selection.set_vertices((0..count).collect());
        return;
    }
    let Some(body) = cx.active_body() else { return };
    let shown: Vec<String> = body.fibres.iter().filter(|f| !f.hidden).map(|fibre| fibre.id.clone()).collect();
    cx.selection.set(shown);
}

/// Copies of the selected fibres, which are selected then. Gives the number of the gesture that goes on with them, and
/// what they are copies of.
pub(crate) fn duplicate(cx: &mut Context) -> (u64, Vec<String>) {
    let (gesture, of) = (cx.begin_gesture(), cx.selection.fibres().to_vec());
    let Some(body) = cx.active_body() else { return (gesture, of) };
    let copies = fibre_ops::copies(cx.selected_fibres(), &body.fibres);
    let (id, chosen) = (body.id.clone(), copies.iter().map(|fibre| fibre.id.clone()).collect::<Vec<_>>());
    cx.edit(&Command::add_fibres(DUPLICATE, &id, copies), Step::Of(gesture));
    cx.selection.set(chosen);
    (gesture, of)
}

/// A copy of the selected sheet, beside it and selected.
pub(crate) fn duplicate_sheet(cx: &mut Context) {
    let by = Transform::translation(cx.sampling().spacing * DVec3::ONE);
    copy_sheet(cx, DUPLICATE, &by);
}

/// A copy of the selected sheet, moved, and selected.
fn copy_sheet(cx: &mut Context, verb: &str, by: &Transform) {
    let Some((body, sheet)) = cx.selected_sheet() else { return };
    match sheet_ops::transform(&sheet_ops::copy(sheet, &body.sheets), by, cx.sampling()) {
        Ok(sheet) => {
            let (body, id) = (body.id.clone(), sheet.id.clone());
            let name = format!("{verb} {}", sheet.title());
            cx.edit(&Command::Many { name, commands: vec![Command::AddSheet { body, sheet }] }, Step::Own);
            cx.selection.choose_sheet(id);
        }
        Err(error) => cx.say(Severity::Error, error.to_string()),
    }
}

/// Deletes the selected fibres, vertices or sheet.
pub(crate) fn delete(cx: &mut Context) {
    if let Some(chosen) = cx.selection.vertices().map(<[usize]>::to_vec) {
        let sampling = cx.sampling();
        each(cx, "Delete vertices of", |fibre| fibre_ops::delete_vertices(fibre, &chosen, sampling));
        cx.selection.enter_vertices(true);
        return;
    }
    let Some(body) = cx.active_body().map(|body| body.id.clone()) else { return };
    if let Some(sheet) = cx.selection.sheet().cloned() {
        cx.selection.clear();
        cx.edit(&Command::RemoveSheet { body, sheet }, Step::Own);
        return;
    }
    let command = Command::remove_fibres(&body, cx.selection.fibres().iter().map(String::as_str));
    cx.selection.clear();
    cx.edit(&command, Step::Own);
}

/// Mirrors the selected fibres or sheet in the plane through the middle of the body.
pub(crate) fn mirror(cx: &mut Context, normal: DVec3) {
    let middle = cx.active.bounds().map_or(DVec3::ZERO, |bounds| bounds.center());
    let sampling = cx.sampling();
    match Transform::reflection(middle, normal) {
        Ok(by) if cx.selection.sheet().is_some() => {
            let Some((_, sheet)) = cx.selected_sheet() else { return };
            let mirrored = sheet_ops::transform(sheet, &by, sampling);
            set_sheet(cx, "Mirror", mirrored, Step::Own);
        }
        Ok(by) => each(cx, "Mirror", |fibre| fibre_ops::transform(fibre, &by, sampling)),
        Err(error) => cx.say(Severity::Error, error.to_string()),
    }
}

/// Copies of the selected fibres or sheet, mirrored in the plane through the middle of the body, and selected.
pub(crate) fn mirror_copies(cx: &mut Context, normal: DVec3) {
    let middle = cx.active.bounds().map_or(DVec3::ZERO, |bounds| bounds.center());
    let by = match Transform::reflection(middle, normal) {
        Ok(by) => by,
        Err(error) => return cx.say(Severity::Error, error.to_string()),
    };
    if cx.selection.sheet().is_some() {
        return copy_sheet(cx, MIRRORED, &by);
    }
    let Some(body) = cx.active_body() else { return };
    let sampling = cx.sampling();
    let copies = fibre_ops::copies(cx.selected_fibres(), &body.fibres);
    let mirrored = copies.iter().map(|copy| Ok(fibre_ops::transform(copy, &by, sampling)?.fibre));
    match mirrored.collect::<Result<Vec<Fibre>, FibreEditError>>() {
        Ok(copies) => {
            let (id, chosen) = (body.id.clone(), copies.iter().map(|fibre| fibre.id.clone()).collect::<Vec<_>>());
            cx.edit(&Command::add_fibres(MIRRORED, &id, copies), Step::Own);
            cx.selection.set(chosen);
        }
        Err(error) => cx.say(Severity::Error, error.to_string()),
    }
}

/// Runs the selected fibres from their other end.
pub(crate) fn reverse(cx: &mut Context) {
    each(cx, "Reverse", fibre_ops::reverse);
}

/// Smooths the selected fibres.
pub(crate) fn smooth(cx: &mut Context) {
    let sampling = cx.sampling();
    each(cx, "Smooth", |fibre| fibre_ops::smooth(fibre, SMOOTHING, sampling));
}

/// Spaces the vertices of the selected fibres evenly, as far apart as the particles.
pub(crate) fn resample(cx: &mut Context) {
    let sampling = cx.sampling();
    let to = ResampleTo::Spacing(sampling.spacing);
    each(cx, "Resample", |fibre| fibre_ops::resample(fibre, to, sampling));
}

/// Keeps the selected fibres as vertices and forgets their strokes.
pub(crate) fn detach(cx: &mut Context) {
    let sampling = cx.sampling();
    each(cx, "Detach", |fibre| fibre_ops::detach(fibre, sampling));
}

/// Lays the selected fibres or vertices under the surface.
pub(crate) fn snap(cx: &mut Context) {
    let sampling = cx.sampling();
    let surface = cx.active_body().and_then(|body| fibre_ops::surface(body, cx.document.assets()));
    let Some(surface) = surface else {
        cx.say(Severity::Warning, "This body has no surface to snap to");
        return;
    };
    let chosen = cx.selection.vertices().map(<[usize]>::to_vec);
    let depth = -SNAP_DEPTH * sampling.spacing;
    each(cx, "Snap", |fibre| fibre_ops::snap(fibre, chosen.as_deref(), &surface, depth, sampling));
}

/// A vertex in the middle of every edge between selected ones.
pub(crate) fn insert_vertices(cx: &mut Context) {
    let Some(chosen) = cx.selection.vertices().map(<[usize]>::to_vec) else { return };
    let sampling = cx.sampling();
    let edges: Vec<usize> = chosen.windows(2).filter(|ends| ends[1] == ends[0] + 1).map(|ends| ends[0]).collect();
    if edges.is_empty() {
        cx.say(Severity::Warning, "Select two vertices beside each other: a third is put between them");
        return;
    }
    each(cx, "Insert vertices into", |fibre| {
        let mut edited = Edited { fibre: fibre.clone(), note: None };
        // From the end, so that the edges before keep their numbers.
        for &edge in edges.iter().rev() {
            let next = fibre_ops::insert_vertex(&edited.fibre, edge, MIDDLE, sampling)?;
            edited = Edited { note: edited.note.or(next.note), fibre: next.fibre };
        }
        Ok(edited)
    });
    let last = chosen.last().copied().unwrap_or_default() + edges.len();
    cx.selection.set_vertices((chosen[0]..=last).collect());
}

/// The knife: two fibres that meet at the selected vertex.
pub(crate) fn split(cx: &mut Context) {
    let Some((body, fibre)) = cx.selected_fibre() else { return };
    let Some(&[vertex]) = cx.selection.vertices() else { return };
    match fibre_ops::split(fibre, vertex, &body.fibres, &body.drives, cx.sampling()) {
        Ok((first, second)) => {
            let (body, ids) = (body.id.clone(), [first.fibre.id.clone(), second.id.clone()]);
            let name = format!("Split {}", fibre.title());
            let commands = vec![
                Command::SetFibre { body: body.clone(), fibre: first.fibre },
                Command::AddFibre { body, fibre: second },
            ];
            cx.edit(&Command::Many { name, commands }, Step::Own);
            cx.selection.set(ids);
            if let Some(note) = first.note {
                cx.say(Severity::Note, note);
            }
        }
        Err(error) => cx.say(Severity::Error, error.to_string()),
    }
}

/// Hides the selected fibres or sheet.
pub(crate) fn hide(cx: &mut Context) {
    let Some(body) = cx.active_body().map(|body| body.id.clone()) else { return };
    let item = |fibre: &String| Item::Fibre { body: body.clone(), fibre: fibre.clone() };
    let sheet = cx.selection.sheet().map(|sheet| Item::Sheet { body: body.clone(), sheet: sheet.clone() });
    let items: Vec<Item> = cx.selection.fibres().iter().map(item).chain(sheet).collect();
    cx.selection.clear();
    cx.edit(&Command::SetHidden { items, hidden: true }, Step::Own);
}

/// Shows every hidden body, and fibre and sheet of the active one.
pub(crate) fn show_all(cx: &mut Context) {
    let bodies = cx.scene().all_bodies().filter(|body| body.hidden());
    let mut items: Vec<Item> = bodies.map(|body| Item::Body(body.id().to_owned())).collect();
    if let Some(body) = cx.active_body() {
        let hidden = body.fibres.iter().filter(|fibre| fibre.hidden);
        items.extend(hidden.map(|fibre| Item::Fibre { body: body.id.clone(), fibre: fibre.id.clone() }));
        let hidden = body.sheets.iter().filter(|sheet| sheet.hidden);
        items.extend(hidden.map(|sheet| Item::Sheet { body: body.id.clone(), sheet: sheet.id.clone() }));
    }
    cx.edit(&Command::SetHidden { items, hidden: false }, Step::Own);
}
