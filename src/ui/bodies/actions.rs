//! What menus and keys do to whole bodies.

use super::free_place::{beside, usual_size};
use super::made::NewBody;
use crate::draw::Bounds;
use crate::edit::body_ops::{copy, moved};
use crate::edit::{Command, Item};
use crate::scene::{OwnedBody, TwoLayerShape};
use crate::sim::SimCommand;
use crate::ui::context::{Context, Request, Severity, Step};
use glam::DVec3;

/// Adds a new body beside the others, as large as those are, and draws into it from now on.
pub(crate) fn add(new: NewBody, cx: &mut Context) {
    let body = new.of_size(usual_size(cx));
    let half = half_size(&body);
    add_body("Add", &body, Bounds { min: -half, max: half }, "", cx);
}

/// Half the extents [m] of a body that is no mesh, about the model's origin.
fn half_size(body: &OwnedBody) -> DVec3 {
    match body {
        OwnedBody::Solid(body) => 0.5 * DVec3::from_array(body.shape.size().unwrap_or_default()),
        OwnedBody::TwoLayer(body) => match &body.shape {
            TwoLayerShape::Segment(shape) => DVec3::new(0.5 * shape.length, 0.05 * shape.length, 0.0),
            TwoLayerShape::Ring(shape) => DVec3::new(shape.outer_radius, shape.outer_radius, 0.0),
            TwoLayerShape::Ball(shape) => DVec3::splat(shape.outer_radius),
            TwoLayerShape::Mesh(_) => DVec3::ZERO,
        },
    }
}

/// Adds a body under an identifier that is free, where it stands free; `bounds` is the box around it as it is placed
/// [m], `what` what else is to be said of it. It is chosen then, and drawn into from now on.
pub(crate) fn add_body(verb: &str, body: &OwnedBody, bounds: Bounds, what: &str, cx: &mut Context) {
    let at = beside(0.5 * (bounds.max - bounds.min), cx);
    let body = moved(&copy(body, cx.scene()), at - bounds.center());
    let (id, title) = (body.view().id().to_owned(), body.view().title().to_owned());
    let name = format!("{verb} {title}");
    let before = cx.scene().all_bodies().count();
    cx.edit(&Command::Many { name, commands: vec![Command::AddBody(body)] }, Step::Own);
    if cx.scene().all_bodies().count() > before {
        cx.request(Request::ChooseBody(id));
        cx.say(Severity::Note, format!("{verb}: {title}{what}. G moves it, R turns it, S scales it"));
    }
}

/// Takes the chosen body out of the scene.
pub(crate) fn delete(cx: &mut Context) {
    let Some((body, title)) = cx.chosen_body().map(|body| (body.id().to_owned(), body.title().to_owned())) else {
        return;
    };
    let measures = cx.scene().measures.iter().filter(|measure| measure.body == body).count();
    cx.selection.clear();
    let command = Command::RemoveBody { body };
    cx.edit(&Command::Many { name: format!("Delete {title}"), commands: vec![command] }, Step::Own);
    if measures > 0 {
        let lost = if measures == 1 { "a measure".to_owned() } else { format!("{measures} measures") };
        cx.say(Severity::Note, format!("Deleted {title}, and {lost} of it; Ctrl+Z brings them back"));
    }
}

/// Hides the chosen body.
pub(crate) fn hide(cx: &mut Context) {
    if let Some(id) = cx.chosen_body().map(|body| body.id().to_owned()) {
        cx.edit(&Command::SetHidden { items: vec![Item::Body(id)], hidden: true }, Step::Own);
    }
}

/// The scene begins anew: what was changed is of its start.
pub(crate) fn begin_anew(cx: &Context) {
    cx.ask(SimCommand::Reset);
}
