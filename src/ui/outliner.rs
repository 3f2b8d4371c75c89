//! The left panel: bodies and fibres by name, and what the chosen fibre is like.

use super::action::Action;
use super::app::App;
use super::field::Field;
use super::theme::{self, GRID, SIDE_WIDTH};
use crate::edit::Command;
use crate::scene::{Fibre, FibreSource, PaperStiffness, RestShape, Rigidity, Stiffness};
use crate::solver::snapshot::SpringKind;
use egui::{Panel, ScrollArea, Ui};

const EA: Field =
    Field::new("EA", "N", 0.0..=1e9, None, "Axial rigidity: resistance to stretching, l_f EA / 2 l0 per edge");
const EI: Field =
    Field::new("EI", "N m²", 0.0..=1e6, None, "Bending stiffness, l_f EI / L0 per vertex (eq. 7 with EI = Kb / 2)");
const KB: Field = Field::new("Kb", "", 0.0..=1e12, None, "Table 1's bending stiffness: EI = Kb V / 2");
const KS: Field = Field::new("Ks", "", 0.0..=1e9, None, "Table 1's stretching stiffness: EA = 2 Ks");
const VOLUME_FRACTION: Field = Field::new(
    "Volume fraction",
    "",
    0.0..=1.0,
    Some(0.5),
    "l_f: share of the material that is fibre at its centre line (eq. 18)",
);

impl App {
    pub(super) fn left_panel(&mut self, ui: &mut Ui) {
        Panel::left("outliner").default_size(SIDE_WIDTH).frame(theme::panel(ui)).show(ui, |ui| {
            // The same width whatever stands in it: the views must not jump when a fibre is selected.
            ui.set_min_width(ui.available_width());
            ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
                ui.add_space(GRID);
                self.bodies(ui);
                self.layers(ui);
                self.fibres(ui);
            });
        });
    }

    /// The bodies of the scene, where there is a choice.
    fn bodies(&mut self, ui: &mut Ui) {
        let names: Vec<String> = self
            .scene()
            .bodies
            .iter()
            .map(|body| (&body.name, &body.id))
            .chain(self.scene().two_layer.iter().map(|body| (&body.name, &body.id)))
            .map(|(name, id)| if name.is_empty() { id.clone() } else { name.clone() })
            .collect();
        if names.is_empty() {
            ui.label("The scene has no body. Open a scene or a model, or start from the soft bar (Ctrl+N).");
        }
        if names.len() < 2 {
            return;
        }
        ui.heading("Bodies");
        for (index, name) in names.iter().enumerate() {
            if ui.selectable_label(index == self.active, name).on_hover_text("Draw into this body").clicked() {
                self.activate(index);
            }
        }
        ui.add_space(2.0 * GRID);
    }

    /// What a two-layer body is made of.
    fn layers(&self, ui: &mut Ui) {
        let (Some(body), Some(shown)) = (self.active_two_layer(), self.model.bodies.first()) else { return };
        ui.heading(if body.name.is_empty() { &body.id } else { &body.name });
        let Some(layers) = &shown.layers else { return };
        ui.label(format!("Two-layer body of {} dimensions", body.shape.dimension()));
        ui.label(format!("{} particles outside, {} inside", layers.outer, shown.particles.len() - layers.outer));
        let theme = self.tone.pictures();
        for (kind, range) in &layers.kinds {
            let (name, colour) = match kind {
                SpringKind::Structural => ("structural", theme.text),
                SpringKind::Radius => ("radius", theme.axes[1]),
                SpringKind::ShearLeft => ("shear-left", theme.axes[0]),
                SpringKind::ShearRight => ("shear-right", theme.axes[2]),
            };
            ui.colored_label(theme::color(colour), format!("{} {name} springs", range.len()));
        }
    }

    fn fibres(&mut self, ui: &mut Ui) {
        let Some(body) = self.active_body() else { return };
        let (fibres, id) = (body.fibres.clone(), body.id.clone());
        ui.heading("Fibres");
        if fibres.is_empty() {
            ui.label("None yet: draw one stroke in each of the two drawing views.");
        }
        for (k, fibre) in fibres.iter().enumerate() {
            let hue = theme::color(self.tone.pictures().fibre(k));
            ui.horizontal(|ui| {
                let (spot, _) = ui.allocate_exact_size(egui::vec2(10.0, 10.0), egui::Sense::hover());
                ui.painter().circle_filled(spot.center(), 5.0, hue);
                let chosen = self.selected.as_ref() == Some(&fibre.id);
                if ui.selectable_label(chosen, title(fibre)).clicked() {
                    self.selected = (!chosen).then(|| fibre.id.clone());
                }
            });
        }
        ui.add_space(2.0 * GRID);
        if let Some(fibre) = fibres.into_iter().find(|fibre| self.selected.as_ref() == Some(&fibre.id)) {
            ui.separator();
            self.inspector(ui, id, &fibre);
        }
    }

    fn inspector(&mut self, ui: &mut Ui, body: String, fibre: &Fibre) {
        ui.heading(title(fibre));
        let mut edited = fibre.clone();
        match &mut edited.stiffness {
            Stiffness::Rigidity(Rigidity { ea, ei, .. }) => {
                EA.show(ui, ea);
                EI.show(ui, ei);
            }
            Stiffness::Paper(PaperStiffness { kb, ks, .. }) => {
                KB.show(ui, kb);
                KS.show(ui, ks);
            }
        }
        VOLUME_FRACTION.show(ui, &mut edited.volume_fraction);
        ui.horizontal(|ui| {
            ui.label("Rest shape");
            ui.selectable_value(&mut edited.rest_shape, RestShape::AsDrawn, "As drawn")
                .on_hover_text("Nothing moves by itself");
            ui.selectable_value(&mut edited.rest_shape, RestShape::Straight, "Straight")
                .on_hover_text("A fibre drawn curved pulls the solid straight");
        });
        if edited != *fibre {
            self.apply(&Command::SetFibre { body, fibre: edited });
        }
        ui.add_space(GRID);
        if matches!(fibre.source, FibreSource::Strokes(_)) && self.drawn_last != self.selected {
            self.stroke_choices(ui);
        }
        self.control(ui, Action::Delete, "Delete fibre");
    }
}

fn title(fibre: &Fibre) -> &str {
    if fibre.name.is_empty() { &fibre.id } else { &fibre.name }
}
