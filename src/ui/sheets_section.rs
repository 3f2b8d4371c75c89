//! The sheets of the active body by name, and what the selected one is like.

use super::action::Action;
use super::activation_fields::sheet_activation_fields;
use super::context::{Context, Step};
use super::controls::button;
use super::field::{NumberField, vector};
use super::outline_row::{colour, row};
use super::theme::{self, GRID};
use crate::edit::sheet_ops::{displaced, stiffness_of};
use crate::edit::{Command, Item};
use crate::scene::{
    Grain, GrainAlong, Material, SEAM_STRETCH, Seam, Sheet, SheetRestShape, SheetSource, SheetStiffness,
};
use crate::solver::snapshot::SheetSnapshot;
use egui::{Checkbox, RichText, Slider, SliderClamping, Ui};
use std::collections::BTreeMap;

const ET: NumberField = NumberField::new(
    "Et",
    "N/m",
    0.0..=1e12,
    None,
    "Young's modulus times thickness: resistance to stretch and shear in the surface",
);
const POISSON: NumberField =
    NumberField::new("Poisson's ratio", "", 0.0..=0.49, Some(0.33), "How much narrower it becomes where it is pulled");
const BENDING: NumberField =
    NumberField::new("Bending", "N m", 0.0..=1e9, None, "Bending stiffness E t³ / 12, the same in all directions");
const GRAIN: NumberField = NumberField::new(
    "Et of the grain",
    "N/m",
    0.0..=1e12,
    None,
    "Of threads along the grain, beside that of the sheet",
);
const VOLUME_FRACTION: NumberField = NumberField::new(
    "Volume fraction",
    "",
    0.0..=1.0,
    Some(0.5),
    "l_s: share of the material that is sheet in its surface (eq. 18)",
);
const STRETCH: NumberField = NumberField::new(
    "Tears past",
    "×",
    SEAM_STRETCH[0]..=SEAM_STRETCH[1],
    Some(FIRST_STRETCH),
    "Length over that at rest past which neighbours across it part",
);

/// What a sheet stands that is first made a seam.
const FIRST_STRETCH: f64 = 1.3;

/// A sheet may be so many times softer or stiffer than what it displaces.
const TIMES: std::ops::RangeInclusive<f64> = 0.1..=1000.0;

/// Shows the sheets of the active body, and what the selected one is like.
pub(super) fn sheets_section(ui: &mut Ui, cx: &mut Context) {
    let Some(body) = cx.active_body().filter(|body| !body.sheets.is_empty()) else { return };
    let (sheets, fibres, id) = (body.sheets.clone(), body.fibres.len(), body.id.clone());
    ui.heading("Sheets");
    for (k, sheet) in sheets.iter().enumerate() {
        let item = Item::Sheet { body: id.clone(), sheet: sheet.id.clone() };
        ui.horizontal(|ui| {
            colour(ui, cx, &item, sheet.color, theme::color(cx.tone.pictures().fibre(fibres + k)));
            let chosen = cx.selection.sheet() == Some(&sheet.id);
            let is_in = is_in_solid(cx, sheet);
            if row(ui, cx, &item, sheet.title(), sheet.hidden, chosen) {
                if chosen {
                    cx.selection.clear();
                } else {
                    cx.selection.choose_sheet(sheet.id.clone());
                }
            }
            if !is_in {
                let why = "Too little of this sheet lies in the solid for it to act, or its strokes sweep no surface";
                ui.label(RichText::new("outside").small().color(cx.tone.warning())).on_hover_text(why);
            }
        });
    }
    ui.add_space(2.0 * GRID);
    if cx.selection.sheet().is_some() {
        ui.separator();
        inspector(ui, cx);
    }
}

/// Whether a sheet acts: the solid was put together with it, or is still to be.
fn is_in_solid(cx: &Context, sheet: &Sheet) -> bool {
    let status = &cx.simulation.published().status;
    let is_settled = cx.simulation.is_up_to_date() && status.baking.is_none() && !status.stopped;
    let known = cx.active.model.bodies.first().map(|body| &body.sheets);
    let is_there = |known: &Vec<_>| known.iter().any(|shown: &SheetSnapshot| shown.id == sheet.id);
    !is_settled || status.failure.is_some() || known.is_none_or(is_there)
}

fn inspector(ui: &mut Ui, cx: &mut Context) {
    let Some((body, sheet)) = cx.selected_sheet() else { return };
    let (body, material, sheet) = (body.id.clone(), body.material.clone(), sheet.clone());
    ui.heading(sheet.title().to_owned());
    let mut edited = sheet.clone();
    let is_elastic = material.viscosity.is_none() && material.plasticity.is_none();
    seam(ui, &mut edited, is_elastic);
    if edited.seam.is_none() {
        resistance(ui, &mut edited, &material);
        sheet_activation_fields(ui, cx, &mut edited, &body);
    }
    if edited != sheet {
        cx.edit(&Command::SetSheet { verb: "Change".to_owned(), body, sheet: edited }, Step::Present);
    }
    ui.add_space(GRID);
    ui.horizontal_wrapped(|ui| {
        button(ui, cx, Action::Duplicate, "Duplicate");
        button(ui, cx, Action::Delete, "Delete sheet");
    });
}

/// Whether the sheet is a seam, and what that stands.
fn seam(ui: &mut Ui, sheet: &mut Sheet, is_elastic: bool) {
    let mut is_seam = sheet.seam.is_some();
    let why = match (&sheet.activation, is_elastic) {
        (Some(_), _) => "A seam carries nothing, and this sheet acts",
        (None, false) => "A material that flows or yields does not tear",
        (None, true) => "",
    };
    let tooltip = "The body tears along it; it carries nothing itself. Reset mends it";
    let shown = ui.add_enabled(why.is_empty() || is_seam, Checkbox::new(&mut is_seam, "Seam"));
    if shown.on_hover_text(tooltip).on_disabled_hover_text(why).changed() {
        sheet.seam = is_seam.then(|| Seam { stretch: FIRST_STRETCH, extra: BTreeMap::new() });
    }
    if let Some(seam) = &mut sheet.seam {
        STRETCH.show(ui, &mut seam.stretch);
    }
}

/// How the sheet resists.
fn resistance(ui: &mut Ui, edited: &mut Sheet, material: &Material) {
    stiffness(ui, &mut edited.stiffness, material);
    grain(ui, edited);
    VOLUME_FRACTION.show(ui, &mut edited.volume_fraction);
    ui.horizontal(|ui| {
        ui.label("Rest shape");
        ui.selectable_value(&mut edited.rest_shape, SheetRestShape::AsDrawn, "As drawn")
            .on_hover_text("Nothing moves by itself");
        ui.selectable_value(&mut edited.rest_shape, SheetRestShape::Flat, "Flat")
            .on_hover_text("A sheet drawn curved pulls the solid flat, as far as it resists bending");
    });
}

fn stiffness(ui: &mut Ui, of: &mut SheetStiffness, material: &Material) {
    let mut times = of.et / displaced(material);
    ui.label("Softer – stiffer than the material");
    ui.spacing_mut().slider_width = 120.0;
    // To show a sheet rounds nothing of it.
    let slider = Slider::new(&mut times, TIMES).logarithmic(true).suffix(" ×").max_decimals(1);
    let tooltip = "Et over that of the material that the sheet displaces, 0.8 E h; its bending stiffness goes with it";
    if ui.add(slider.clamping(SliderClamping::Edits)).on_hover_text(tooltip).changed() {
        let SheetStiffness { et, bending, .. } = stiffness_of(material, times);
        (of.et, of.bending) = (et, bending);
    }
    if times < 1.0 {
        let warning = ui.visuals().warn_fg_color;
        ui.colored_label(warning, "Softer than what it displaces: it weakens the solid");
    }
    ET.show(ui, &mut of.et);
    POISSON.show(ui, &mut of.poisson_ratio);
    BENDING.show(ui, &mut of.bending);
}

/// Whether the sheet has threads, which way they run and how stiff they are.
fn grain(ui: &mut Ui, sheet: &mut Sheet) {
    let has_rows = !matches!(sheet.source, SheetSource::Triangles(_));
    let SheetStiffness { et, grain, .. } = &mut sheet.stiffness;
    let along = grain.as_ref().map(|grain| grain.along.clone());
    let mut chosen = along.clone();
    ui.horizontal_wrapped(|ui| {
        ui.label("Grain");
        ui.selectable_value(&mut chosen, None, "None").on_hover_text("As stiff in every direction");
        if has_rows {
            ui.selectable_value(&mut chosen, Some(GrainAlong::First), "First")
                .on_hover_text("Threads along the first stroke");
            ui.selectable_value(&mut chosen, Some(GrainAlong::Second), "Second")
                .on_hover_text("Threads along the second stroke");
        }
        let direction = match &along {
            Some(GrainAlong::Direction(axis)) => *axis,
            _ => [0.0, 1.0, 0.0],
        };
        ui.selectable_value(&mut chosen, Some(GrainAlong::Direction(direction)), "Direction")
            .on_hover_text("Threads as a direction lies in the sheet");
    });
    if chosen != along {
        let stiff = grain.as_ref().map_or(*et, |grain| grain.et);
        let extra = grain.take().map_or_else(BTreeMap::new, |grain| grain.extra);
        *grain = chosen.map(|along| Grain { along, et: stiff, extra });
    }
    if let Some(Grain { along, et, .. }) = grain {
        GRAIN.show(ui, et);
        if let GrainAlong::Direction(axis) = along {
            vector(ui, "Along", "", axis, "In the model frame; of any length but zero");
        }
    }
}
