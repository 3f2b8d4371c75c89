//! The right panel's first tab: what the active body is made of and how it is stepped.

use super::bodies::place_and_shape;
use super::context::{Context, Step};
use super::elements_section::elements_section;
use super::follows_section::follows_section;
use super::material_fields::material_fields;
use super::region_material_fields::region_material_fields;
use super::sampling;
use super::theme::GRID;
use super::two_layer_fields::two_layer_fields;
use super::voids_section::voids_section;
use crate::edit::Command;
use crate::scene::{IntegratorChoice, IntegratorKind, OwnedBody};
use egui::{ComboBox, RichText, Ui};

/// Shows what the active body is made of and how it is stepped.
pub(super) fn body_tab(ui: &mut Ui, cx: &mut Context) {
    if let Some(body) = cx.active_body().cloned() {
        let shown = sampling::material_in_truth(cx, &body);
        let mut material = shown.clone();
        material_fields(ui, &mut material);
        if let Some(command) = sampling::change(cx, &body, &shown, material) {
            cx.edit(&command, Step::Present);
        }
        let mut changed = body.clone();
        if touches_itself(ui, &mut changed.self_contact) {
            let body = OwnedBody::from(changed);
            cx.edit(&Command::SetBody { verb: "Change".to_owned(), body }, Step::Own);
        }
        region_material_fields(ui, cx, &body);
        elements_section(ui, cx, &body);
        voids_section(ui, cx, &body);
        follows_section(ui, cx);
        integrator(ui, cx, body.id, body.integrator);
    } else if let Some(body) = cx.active_two_layer().cloned() {
        let mut changed = body.clone();
        two_layer_fields(ui, cx, &mut changed);
        touches_itself(ui, &mut changed.self_contact);
        if changed != body {
            cx.edit(&Command::SetTwoLayer(Box::new(changed)), Step::Present);
        }
        follows_section(ui, cx);
        integrator(ui, cx, body.id, body.integrator);
    } else {
        ui.label("No body is chosen");
    }
    place_and_shape(ui, cx);
    if let Some(baking) = &cx.simulation.published().status.baking {
        ui.add_space(GRID);
        // On as many lines as it needs: a wider panel would make the views jump.
        ui.horizontal_wrapped(|ui| {
            ui.spinner();
            ui.label(format!("Putting together {baking}…"));
        });
    }
}

/// Whether the body's parts push each other away; true if that was changed.
fn touches_itself(ui: &mut Ui, on: &mut bool) -> bool {
    ui.add_space(GRID);
    let why = "Its parts push each other away where they come to meet, and pass through each other without it. \
        The stable step is a little shorter with it";
    ui.checkbox(on, "Touches itself").on_hover_text(why).changed()
}

/// The body's integrator, its step and what that must not exceed.
fn integrator(ui: &mut Ui, cx: &mut Context, body: String, present: IntegratorChoice) {
    ui.add_space(2.0 * GRID);
    let title = ui.heading("Integrator");
    let mut chosen = present;
    let choice = ComboBox::from_id_salt("integrator").selected_text(present.name()).show_ui(ui, |ui| {
        let given = IntegratorKind::ALL.map(IntegratorChoice::Given);
        for choice in std::iter::once(IntegratorChoice::Automatic).chain(given) {
            ui.selectable_value(&mut chosen, choice, choice.name());
        }
    });
    choice.response.labelled_by(title.id);
    if chosen != present {
        cx.edit(&Command::SetIntegrator { body, integrator: chosen }, Step::Own);
    }
    let Some(step) = cx.simulation.published().status.bodies.get(cx.active.index) else { return };
    if present == IntegratorChoice::Automatic {
        let name =
            IntegratorKind::ALL.into_iter().find(|kind| kind.word() == step.integrator).map(IntegratorKind::name);
        let by = step.integrator_reason.as_deref().or(name).unwrap_or(step.integrator);
        ui.label(RichText::new(format!("Chosen: {by}")).weak().small());
    }
    let exceeded = step.dt > step.stable_dt;
    let text = format!("DT    {:.3e} s\nlimit {:.3e} s", step.dt, step.stable_dt);
    let colour = if exceeded { cx.tone.error() } else { ui.visuals().text_color() };
    let set_by = cx.set_by(step.limited_by.as_deref());
    let why = format!("The limit is the stable step of this integrator{set_by}");
    ui.label(RichText::new(text).monospace().color(colour)).on_hover_text(&why);
    if exceeded {
        ui.colored_label(cx.tone.error(), format!("Beyond the limit{set_by}"));
    } else if let Some(pointer) = &step.limited_by {
        ui.label(RichText::new(format!("Set by {}", cx.scene().with_names(pointer))).weak().small());
    }
}
