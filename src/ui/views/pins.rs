//! Pins where they hold: those of the scene's regions, and points that were left pinned while they were dragged. They
//! are chosen and removed there.

use super::frame::ViewFrame;
use super::kind::PaneKind;
use crate::bake::followed_bones;
use crate::scene::Hold;
use crate::sim::PinnedPoint;
use crate::ui::context::{ChosenPin, Context};
use crate::ui::theme;
use crate::ui::unpin::remove_pin;
use egui::{Color32, Painter, Pos2, Rect, Role, Sense, Stroke, Ui, Vec2, WidgetInfo};
use glam::DVec3;

/// Marks on the particles that a pin holds, at most.
const MARKS: usize = 200;
/// A mark's size, the pin's length and the radius of its head [points].
const MARK: f32 = 1.6;
const LENGTH: f32 = 14.0;
const HEAD: f32 = 5.0;

/// A pin as a view shows it.
struct ShownPin {
    which: ChosenPin,
    name: String,
    /// What it holds [m].
    holds: Vec<DVec3>,
    /// Where its needle stands [m].
    at: DVec3,
}

/// Shows every pin; a click chooses one, and its menu removes it.
pub(super) fn pins(ui: &mut Ui, frame: &ViewFrame, cx: &mut Context) {
    if cx.simulation.is_comparing() {
        return;
    }
    let painter = ui.painter_at(frame.rect);
    let pictures = cx.tone.pictures();
    let (ink, accent) = (theme::color(pictures.text), theme::color(pictures.accent));
    for (number, pin) in shown(frame.kind, cx).into_iter().enumerate() {
        let is_chosen = cx.selection.pin() == Some(&pin.which);
        let colour = if is_chosen { accent } else { ink };
        for &point in pin.holds.iter().step_by(pin.holds.len().div_ceil(MARKS).max(1)) {
            if let Some(at) = frame.screen(point) {
                painter.circle_filled(at, MARK, colour.gamma_multiply(if is_chosen { 1.0 } else { 0.6 }));
            }
        }
        let Some(at) = frame.screen(pin.at).filter(|at| frame.rect.contains(*at)) else { continue };
        let head = at - Vec2::new(-0.4 * LENGTH, LENGTH);
        let spot = Rect::from_two_pos(at, head).expand(HEAD);
        let response = ui.interact(spot, ui.scope_id().with(("pin", number, &pin.name)), Sense::click());
        response.widget_info(|| WidgetInfo::labeled(Role::Button, true, &pin.name));
        paint_pin(&painter, [at, head], colour, response.hovered());
        if response.hovered() {
            cx.status.hint = "Click chooses this pin, X removes it";
        }
        if response.clicked() {
            cx.selection.choose_pin(pin.which.clone());
        }
        response.context_menu(|ui| {
            if ui.button("Remove pin").clicked() {
                remove_pin(&pin.which, cx);
                ui.close();
            }
        });
        response.on_hover_text(format!("{}: X removes it", pin.name));
    }
}

fn paint_pin(painter: &Painter, [at, head]: [Pos2; 2], colour: Color32, hovered: bool) {
    let radius = if hovered { 1.25 * HEAD } else { HEAD };
    painter.line_segment([at, head], Stroke::new(1.5, colour));
    painter.circle(head, radius, colour, Stroke::new(1.0, Color32::from_black_alpha(120)));
}

/// Shows what the bodies follow: the bones as the result has them, and the particles that are held to a motion, as pins
/// hold theirs.
pub(super) fn follows(ui: &Ui, frame: &ViewFrame, cx: &Context) {
    if cx.simulation.is_comparing() || frame.kind != PaneKind::Result {
        return;
    }
    let published = cx.simulation.published();
    if !cx.simulation.is_up_to_date() || published.status.baking.is_some() {
        return;
    }
    let painter = ui.painter_at(frame.rect);
    let ink = theme::color(cx.tone.pictures().text);
    let bodies = cx.scene().all_bodies().zip(published.held.iter()).zip(&published.snapshot.bodies);
    for ((body, held), shown) in bodies.filter(|((body, _), _)| !body.hidden() && !body.follows().is_empty()) {
        // What is followed is held before the pins.
        let hard = body.follows().iter().filter(|of| of.hold == Hold::Hard).count();
        let end = held.len().saturating_sub(body.pins().len());
        for particles in &held[end.saturating_sub(hard)..end] {
            for &i in particles.iter().step_by(particles.len().div_ceil(MARKS).max(1)) {
                if let Some(at) = shown.particles.get(i as usize).and_then(|&point| frame.screen(point)) {
                    painter.circle_filled(at, MARK, ink.gamma_multiply(0.6));
                }
            }
        }
        for bone in followed_bones(body, cx.document.assets(), published.snapshot.time) {
            if let [Some(from), Some(to)] = bone.map(|end| frame.screen(end)) {
                painter.line_segment([from, to], Stroke::new(1.0, ink.gamma_multiply(0.8)));
                painter.circle_stroke(from, 2.0 * MARK, Stroke::new(1.0, ink.gamma_multiply(0.8)));
            }
        }
    }
}

/// The pins that a view shows: all of them in the result, those of the body that is drawn into elsewhere.
fn shown(kind: PaneKind, cx: &Context) -> Vec<ShownPin> {
    let published = cx.simulation.published();
    // What is held is known by its number among the particles; of an edit that is not put together yet it is not.
    let is_settled = cx.simulation.is_up_to_date() && published.status.baking.is_none();
    let mut all = Vec::new();
    let bodies = cx.scene().all_bodies().enumerate().zip(published.held.iter()).filter(|_| is_settled);
    for ((index, body), held) in bodies {
        let places = match kind {
            PaneKind::Result => published.snapshot.bodies.get(index).map(|body| &body.particles),
            PaneKind::Drawing(_) if index == cx.active.index => {
                cx.active.model.bodies.first().map(|body| &body.particles)
            }
            PaneKind::Drawing(_) => None,
        };
        let Some(places) = places.filter(|_| !body.hidden()) else { continue };
        // The pins of a body are its last constraints.
        let first = held.len().saturating_sub(body.pins().len());
        for (pin, particles) in body.pins().iter().zip(&held[first..]) {
            let holds: Vec<DVec3> = particles.iter().filter_map(|&i| places.get(i as usize).copied()).collect();
            if holds.is_empty() {
                continue;
            }
            all.push(ShownPin {
                which: ChosenPin::Region { body: body.id().to_owned(), pin: pin.id.clone() },
                name: format!("Pin of \"{}\"", pin.region),
                at: holds.iter().sum::<DVec3>() / holds.len() as f64,
                holds,
            });
        }
    }
    if kind == PaneKind::Result {
        for (k, &PinnedPoint { body, grab, at, target }) in published.pinned.iter().enumerate() {
            let (which, name) = (ChosenPin::Point { body, grab }, format!("Pinned point {}", k + 1));
            // It stands where the point is held, and does not swing with it.
            all.push(ShownPin { which, name, holds: vec![at], at: target });
        }
    }
    all
}
