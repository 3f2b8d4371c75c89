//! Pins of the active body: the regions that are held, and along which axes.

use super::context::{ChosenPin, Context, Step};
use super::motion_fields::motion_fields;
use crate::edit::Command;
use crate::scene::{Axis, Drivable, Pin, Region, Side};
use egui::{ComboBox, Ui};

/// Layers of the lattice that a new pin holds.
const PINNED_LAYERS: u32 = 1;

/// Shows the pins of the active body.
pub(super) fn pins_section(ui: &mut Ui, cx: &mut Context) {
    let active = cx.scene().any_body(cx.active.index);
    let supports = active.map(|body| (body.id().to_owned(), body.regions().to_vec(), body.pins().to_vec()));
    let Some((id, regions, pins)) = supports else {
        ui.label("No body is chosen");
        return;
    };
    let (mut new_regions, mut new_pins) = (regions.clone(), pins.clone());
    let mut step = Step::Present;
    let mut gone = None;
    for (index, pin) in new_pins.iter_mut().enumerate() {
        ui.push_id(index, |ui| {
            ui.horizontal(|ui| {
                let which = ChosenPin::Region { body: id.clone(), pin: pin.id.clone() };
                let text = format!("{}: holds \"{}\"", pin.id, pin.region);
                if ui.selectable_label(cx.selection.pin() == Some(&which), text).clicked() {
                    cx.selection.choose_pin(which);
                }
                if ui.button("Remove").on_hover_text("Lets go of this region").clicked() {
                    gone = Some(index);
                }
            });
            ui.horizontal(|ui| held_axes(ui, &mut pin.axes));
            let of = Drivable::Pin { body: id.clone(), pin: pin.id.clone() };
            motion_fields(ui, cx, &mut pin.motion, &of);
        });
    }
    // A pin that holds nothing is none.
    new_pins.retain(|pin| !pin.axes.is_empty());
    if let Some(index) = gone.filter(|index| *index < new_pins.len()) {
        new_pins.remove(index);
        step = Step::Own;
    }
    if let Some(added) = new_pin(ui, cx, &regions) {
        add_pin(added, &mut new_regions, &mut new_pins);
        step = Step::Own;
    }
    if new_pins != pins || new_regions != regions {
        cx.edit(&Command::SetPins { body: id, regions: new_regions, pins: new_pins }, step);
    }
}

/// A switch for each axis along which a region is held.
fn held_axes(ui: &mut Ui, axes: &mut Vec<Axis>) {
    ui.label("along");
    for (axis, name) in [(Axis::X, "X"), (Axis::Y, "Y"), (Axis::Z, "Z")] {
        let mut held = axes.contains(&axis);
        if ui.checkbox(&mut held, name).changed() {
            axes.retain(|old| *old != axis);
            if held {
                axes.push(axis);
            }
            axes.sort_by_key(|axis| axis.index());
        }
    }
}

/// The region that a person wants pinned.
fn new_pin(ui: &mut Ui, cx: &Context, regions: &[Region]) -> Option<Region> {
    let mut chosen = None;
    let title = ui.label("Pin a region");
    let choice = ComboBox::from_id_salt("new pin").selected_text("Choose…").show_ui(ui, |ui| {
        for region in regions {
            if ui.selectable_label(false, &region.id).clicked() {
                chosen = Some(region.clone());
            }
        }
        if cx.active_body().is_none() {
            return;
        }
        for (id, axis, side) in [
            ("bottom", Axis::Y, Side::Min),
            ("top", Axis::Y, Side::Max),
            ("left", Axis::X, Side::Min),
            ("right", Axis::X, Side::Max),
            ("back", Axis::Z, Side::Min),
            ("front", Axis::Z, Side::Max),
        ] {
            if regions.iter().all(|region| region.id != id) && ui.selectable_label(false, id).clicked() {
                chosen = Some(Region::layers(id, axis, side, PINNED_LAYERS));
            }
        }
    });
    choice.response.labelled_by(title.id);
    chosen
}

fn add_pin(region: Region, regions: &mut Vec<Region>, pins: &mut Vec<Pin>) {
    let number = (1..=pins.len() + 1).find(|n| pins.iter().all(|pin| pin.id != format!("pin-{n}"))).unwrap_or(1);
    pins.push(Pin::new(format!("pin-{number}"), region.id.as_str()));
    if regions.iter().all(|old| old.id != region.id) {
        regions.push(region);
    }
}
