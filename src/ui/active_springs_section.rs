//! The springs of a two-layer body that act, as numbers that can be changed.

use super::context::Context;
use super::drives::keyed_field;
use super::field::NumberField;
use super::theme::GRID;
use crate::scene::{ActiveSprings, Drivable, SpringChoice, TwoLayer};
use egui::{ComboBox, Ui};

const CONTRACT: NumberField = NumberField::new(
    "Contract by",
    "",
    -0.5..=0.8,
    Some(0.0),
    "Share by which their rest lengths are shorter where their drive is 1: L0 (1 - c)",
);
/// Share by which new ones contract.
const FIRST_CONTRACTION: f64 = 0.2;

/// Shows the springs that act, and lets more of them.
pub(super) fn active_springs_section(ui: &mut Ui, cx: &mut Context, body: &mut TwoLayer) {
    ui.add_space(GRID);
    ui.heading("Springs that act");
    let regions: Vec<String> = TwoLayer::REGIONS
        .into_iter()
        .map(str::to_owned)
        .chain(body.regions.iter().map(|region| region.id.clone()))
        .collect();
    let id = body.id.clone();
    let mut gone = None;
    for (index, of) in body.active_springs.iter_mut().enumerate() {
        ui.push_id(index, |ui| {
            ui.horizontal(|ui| {
                region_choice(ui, of, &regions);
                kind_choice(ui, of);
                let tooltip = "They only resist again; their drive goes with it";
                if ui.small_button("Remove").on_hover_text(tooltip).clicked() {
                    gone = Some(index);
                }
            });
            let drivable = Drivable::Springs { body: id.clone(), springs: of.id.clone() };
            keyed_field(ui, cx, &CONTRACT, &mut of.contract, &drivable);
        });
    }
    if let Some(index) = gone {
        body.active_springs.remove(index);
    }
    let tooltip = "Lets rest lengths change in time: a number, and a lane under Drives";
    if ui.button("Let springs act").on_hover_text(tooltip).clicked() {
        let is_free = |name: &String| body.active_springs.iter().all(|one| one.id != *name);
        let most = body.active_springs.len() + 1;
        let name = (1..=most).map(|k| format!("pull-{k}")).find(is_free).unwrap_or_default();
        body.active_springs.push(ActiveSprings::new(name, TwoLayer::REGIONS[0], FIRST_CONTRACTION, 1.0));
    }
}

fn region_choice(ui: &mut Ui, of: &mut ActiveSprings, regions: &[String]) {
    let menu = ComboBox::from_id_salt("region").width(84.0).selected_text(of.region.clone()).show_ui(ui, |ui| {
        for region in regions {
            ui.selectable_value(&mut of.region, region.clone(), region);
        }
    });
    menu.response.on_hover_text("Region in which both ends of a spring lie");
}

fn kind_choice(ui: &mut Ui, of: &mut ActiveSprings) {
    let kinds = [
        (SpringChoice::All, "All", "Every spring"),
        (SpringChoice::Structural, "Structural", "Those along the edges of both layers"),
        (SpringChoice::Radius, "Radius", "Those between the same vertices of both layers"),
        (SpringChoice::Shear, "Shear", "Those that cross between the layers"),
    ];
    let name = kinds.iter().find(|(kind, ..)| *kind == of.springs).map_or("", |(_, name, _)| name);
    let menu = ComboBox::from_id_salt("kind").width(84.0).selected_text(name).show_ui(ui, |ui| {
        for (kind, name, tooltip) in kinds {
            ui.selectable_value(&mut of.springs, kind, name).on_hover_text(tooltip);
        }
    });
    menu.response.on_hover_text("Which of its springs");
}
