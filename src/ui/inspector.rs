//! What the selected fibres are like: what is changed of one is changed of all.

use super::action::Action;
use super::activation_fields::{activation_fields, twisting_field};
use super::context::{Context, Step};
use super::controls::button;
use super::field::NumberField;
use super::inelastic_fields::yield_fields;
use super::sampling::material_in_truth;
use super::stroke_choices::stroke_choices;
use super::theme::GRID;
use crate::edit::Command;
use crate::edit::fibre_ops::{displaced, rigidity_of};
use crate::scene::{Activation, Fibre, FibreSource, Material, PaperStiffness, RestShape, Rigidity, Stiffness};
use egui::{Slider, SliderClamping, Ui};

const EA: NumberField =
    NumberField::new("EA", "N", 0.0..=1e9, None, "Axial rigidity: resistance to stretching, l_f EA / 2 l0 per edge");
const EI: NumberField = NumberField::new(
    "EI",
    "N m²",
    0.0..=1e6,
    None,
    "Bending stiffness, l_f EI / L0 per vertex (eq. 7 with EI = Kb / 2)",
);
const KB: NumberField = NumberField::new("Kb", "", 0.0..=1e12, None, "Table 1's bending stiffness: EI = Kb V / 2");
const KS: NumberField = NumberField::new("Ks", "", 0.0..=1e9, None, "Table 1's stretching stiffness: EA = 2 Ks");
const VOLUME_FRACTION: NumberField = NumberField::new(
    "Volume fraction",
    "",
    0.0..=1.0,
    Some(0.5),
    "l_f: share of the material that is fibre at its centre line (eq. 18)",
);

/// Radius of the round rod that has the fibre's EA and EI.
const RADIUS: NumberField = NumberField::new(
    "Radius",
    "m",
    1e-6..=10.0,
    None,
    "Of a round rod with this EA and EI, r = 2 sqrt(EI / EA): a change keeps EA and takes EI = EA r² / 4",
);

/// A fibre may be so many times softer or stiffer than what it displaces.
const TIMES: std::ops::RangeInclusive<f64> = 0.1..=1000.0;

/// Shows what the selected fibres of a body are like.
pub(super) fn inspector(ui: &mut Ui, cx: &mut Context, body: &str) {
    let Some((of, fibre)) = cx.selected_fibre() else { return };
    let (material, fibre) = (material_in_truth(cx, of), fibre.clone());
    let count = cx.selection.fibres().len();
    ui.heading(if count > 1 { format!("{count} fibres") } else { fibre.title().to_owned() });
    let mut edited = fibre.clone();
    stiffness(ui, &mut edited, &material);
    VOLUME_FRACTION.show(ui, &mut edited.volume_fraction);
    ui.horizontal(|ui| {
        ui.label("Rest shape");
        ui.selectable_value(&mut edited.rest_shape, RestShape::AsDrawn, "As drawn")
            .on_hover_text("Nothing moves by itself");
        ui.selectable_value(&mut edited.rest_shape, RestShape::Straight, "Straight")
            .on_hover_text("A fibre drawn curved pulls the solid straight");
    });
    yield_fields(ui, &mut edited);
    activation_fields(ui, cx, &mut edited, body);
    if edited != fibre {
        let changed = cx.selected_fibres().into_iter().map(|other| with_change(other, &fibre, &edited)).collect();
        cx.edit(&Command::set_fibres("Change", body, changed), Step::Present);
    }
    ui.add_space(GRID);
    let is_asked_already = cx.status.offers_stretch || cx.status.drawn_fibre.as_ref() == cx.selection.active();
    if matches!(fibre.source, FibreSource::Strokes(_)) && !is_asked_already {
        stroke_choices(ui, cx);
    }
    ui.horizontal_wrapped(|ui| {
        button(ui, cx, Action::Vertices, "Edit vertices");
        button(ui, cx, Action::Duplicate, "Duplicate");
        let delete = match (cx.selection.vertices(), count) {
            (Some(_), _) => "Delete vertices",
            (None, 1) => "Delete fibre",
            (None, _) => "Delete fibres",
        };
        button(ui, cx, Action::Delete, delete);
    });
}

/// Stiffness by either pair of numbers, and by how it compares with the material around.
fn stiffness(ui: &mut Ui, fibre: &mut Fibre, material: &Material) {
    let volume = material.spacing().powi(3);
    let (ea, ei) = fibre.stiffness.rigidity(volume);
    let mut times = ea / displaced(material);
    ui.label("Softer – stiffer than the material");
    ui.spacing_mut().slider_width = 120.0;
    // To show a fibre rounds nothing of it.
    let slider = Slider::new(&mut times, TIMES).logarithmic(true).suffix(" ×").max_decimals(1);
    let slider = slider.clamping(SliderClamping::Edits);
    let tooltip = "Axial rigidity EA over that of the material that the fibre displaces, E 0.2 pi h²; EI goes with it";
    if ui.add(slider).on_hover_text(tooltip).changed() {
        let Rigidity { ea, ei, .. } = rigidity_of(material, times);
        fibre.stiffness = with_rigidity(&fibre.stiffness, ea, ei, volume);
    }
    let driven = fibre.activation.as_ref().and_then(|of| of.volume_fraction).unwrap_or(0.0);
    if times < 1.0 && fibre.volume_fraction.max(driven) > 0.0 {
        let warning = ui.visuals().warn_fg_color;
        ui.colored_label(
            warning,
            "Softer than what it displaces: it weakens the solid and does the reverse of its shape",
        );
    }
    ui.horizontal(|ui| {
        ui.label("Entered as");
        let mut paper = matches!(fibre.stiffness, Stiffness::Paper(_));
        let before = paper;
        ui.selectable_value(&mut paper, false, "EA, EI");
        ui.selectable_value(&mut paper, true, "Kb, Ks").on_hover_text("Table 1 of the fibre paper");
        if paper != before {
            fibre.stiffness = if paper {
                PaperStiffness::new(2.0 * ei / volume, 0.5 * ea).into()
            } else {
                Rigidity::new(ea, ei).into()
            };
        }
    });
    match &mut fibre.stiffness {
        Stiffness::Rigidity(Rigidity { ea, ei, .. }) => {
            EA.show(ui, ea);
            EI.show(ui, ei);
        }
        Stiffness::Paper(PaperStiffness { kb, ks, .. }) => {
            KB.show(ui, kb);
            KS.show(ui, ks);
        }
    }
    twisting_field(ui, &mut fibre.stiffness);
    let (ea, ei) = fibre.stiffness.rigidity(volume);
    let mut radius = if ea > 0.0 { 2.0 * (ei / ea).sqrt() } else { 0.0 };
    if RADIUS.show(ui, &mut radius) {
        fibre.stiffness = with_rigidity(&fibre.stiffness, ea, 0.25 * ea * radius * radius, volume);
    }
}

/// This rigidity, entered as before.
fn with_rigidity(before: &Stiffness, ea: f64, ei: f64, volume: f64) -> Stiffness {
    match before {
        Stiffness::Rigidity(old) => Stiffness::Rigidity(Rigidity { ea, ei, ..old.clone() }),
        Stiffness::Paper(old) => {
            Stiffness::Paper(PaperStiffness { kb: 2.0 * ei / volume, ks: 0.5 * ea, extra: old.extra.clone() })
        }
    }
}

/// A fibre with what was changed of another one.
fn with_change(fibre: &Fibre, before: &Fibre, after: &Fibre) -> Fibre {
    let mut fibre = fibre.clone();
    if before.stiffness != after.stiffness {
        fibre.stiffness = after.stiffness.clone();
    }
    if before.volume_fraction != after.volume_fraction {
        fibre.volume_fraction = after.volume_fraction;
    }
    if before.rest_shape != after.rest_shape {
        fibre.rest_shape = after.rest_shape;
    }
    if before.yields != after.yields && fibre.activation.is_none() {
        fibre.yields.clone_from(&after.yields);
    }
    if before.activation != after.activation && fibre.yields.is_none() {
        fibre.activation = match (&after.activation, &fibre.activation) {
            // Each keeps the drive that it follows.
            (Some(after), Some(own)) if before.activation.is_some() => {
                Some(Activation { drive: own.drive.clone(), ..after.clone() })
            }
            (after, _) => after.clone(),
        };
    }
    fibre
}
