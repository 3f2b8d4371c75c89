//! Bars and side panels: play controls, outliner and inspector, material and world, status.

use super::action::{Action, Menu};
use super::app::{App, Gravity};
use super::theme::{self, GRID, SIDE_WIDTH};
use crate::edit::Command;
use crate::scene::{Fibre, Mass, PaperStiffness, RestShape, Rigidity, Stiffness};
use crate::sim::SimCommand;
use egui::{Button, DragValue, Panel, RichText, Ui};
use std::ops::RangeInclusive;

impl App {
    /// A button or menu entry for an action.
    fn entry(&mut self, ui: &mut Ui, action: Action, text: &str) {
        let shortcut = action.shortcuts().first().map(|shortcut| ui.ctx().format_shortcut(shortcut));
        let mut button = Button::new(text);
        if let Some(shortcut) = &shortcut {
            button = button.shortcut_text(shortcut);
        }
        let response = ui.add_enabled(self.can(action), button).on_hover_text(action.tooltip());
        if response.clicked() {
            let ctx = ui.ctx().clone();
            self.perform(&ctx, action);
            ui.close();
        }
    }

    /// A plain button for an action, with its name and key in the tooltip.
    fn control(&mut self, ui: &mut Ui, action: Action, text: &str) {
        let key = action.shortcuts().first().map_or_else(String::new, |shortcut| ui.ctx().format_shortcut(shortcut));
        let hover = format!("{} ({key})", action.tooltip());
        if ui.add_enabled(self.can(action), Button::new(text)).on_hover_text(hover).clicked() {
            let ctx = ui.ctx().clone();
            self.perform(&ctx, action);
        }
    }

    pub(super) fn top_bar(&mut self, ui: &mut Ui) {
        Panel::top("top").show(ui, |ui| {
            ui.add_space(GRID);
            ui.horizontal(|ui| {
                for menu in Menu::ALL {
                    ui.menu_button(menu.title(), |ui| {
                        for action in Action::ALL.into_iter().filter(|action| action.menu() == menu) {
                            self.entry(ui, action, &self.menu_text(action));
                        }
                    });
                }
                ui.separator();
                let playing = self.published.status.playing;
                self.control(ui, Action::PlayPause, if playing { "Pause" } else { "Play" });
                self.control(ui, Action::Step, "Step");
                self.control(ui, Action::Reset, "Reset");
                ui.separator();
                ui.label("Speed");
                let speed = DragValue::new(&mut self.speed).range(0.01..=4.0).speed(0.01).max_decimals(2).suffix(" ×");
                if ui.add(speed).on_hover_text("Simulated over real time that is aimed at").changed() {
                    self.ask(SimCommand::Speed(self.speed));
                }
                ui.separator();
                self.read_out(ui);
            });
            ui.add_space(GRID);
        });
    }

    /// Undo and redo say what they would do.
    fn menu_text(&self, action: Action) -> String {
        let name = match action {
            Action::Undo => self.editor.undo_name(),
            Action::Redo => self.editor.redo_name(),
            _ => None,
        };
        name.map_or_else(|| action.name().to_owned(), |step| format!("{}: {}", action.name(), lower_first(step)))
    }

    fn read_out(&self, ui: &mut Ui) {
        let status = &self.published.status;
        let text = if let Some(baking) = &status.baking {
            format!("Putting together {baking}…")
        } else if status.real_time_factor > 0.0 && status.playing {
            let factor = status.real_time_factor / self.speed;
            let pace = if factor < 0.9 {
                format!("slow motion, {:.2} × real time", status.real_time_factor)
            } else {
                format!("{:.2} × real time", status.real_time_factor)
            };
            format!("{:.2} s   {:.0} frames/s   {pace}", status.time, status.frames_per_second)
        } else {
            format!("{:.2} s", status.time)
        };
        let substeps = status.substeps.iter().max().copied().unwrap_or(0);
        let why = format!(
            "{} particles, {substeps} steps a frame. Stiffer materials and fibres need shorter steps; below 1 × the \
             simulation cannot keep up with real time",
            status.particles
        );
        ui.label(RichText::new(text).monospace()).on_hover_text(why);
    }

    pub(super) fn status_bar(&mut self, ui: &mut Ui) {
        Panel::bottom("status").show(ui, |ui| {
            ui.add_space(0.5 * GRID);
            ui.horizontal(|ui| {
                let status = &self.published.status;
                let trouble = status.failure.clone().or_else(|| status.divergence.clone());
                if let Some(trouble) = trouble {
                    ui.colored_label(self.tone.error(), format!("Stopped: {trouble}"));
                    return;
                }
                if matches!(self.tool.stage(), super::sketch_tool::Stage::Refused { .. })
                    && ui
                        .button("Stretch instead")
                        .on_hover_text("Stretches the second stroke onto the first")
                        .clicked()
                {
                    let diagonal = self.model_diagonal();
                    if let Some(outcome) = self.tool.stretch(diagonal) {
                        self.sketched(outcome);
                    }
                }
                if let Some((gravity, text)) = &self.message {
                    let (mark, color) = match gravity {
                        Gravity::Note => ("", ui.visuals().text_color()),
                        Gravity::Warning => ("Warning: ", self.tone.warning()),
                        Gravity::Error => ("Error: ", self.tone.error()),
                    };
                    ui.colored_label(color, format!("{mark}{text}"));
                    ui.separator();
                }
                ui.label(RichText::new(self.hint).weak());
            });
            ui.add_space(0.5 * GRID);
        });
    }

    pub(super) fn left_panel(&mut self, ui: &mut Ui) {
        Panel::left("outliner").default_size(SIDE_WIDTH).show(ui, |ui| {
            // The same width whatever stands in it: the views must not jump when a fibre is selected.
            ui.set_min_width(ui.available_width());
            ui.add_space(GRID);
            ui.heading("Fibres");
            let Some(body) = self.active_body() else {
                ui.label("The scene has no body. Open a scene, or start from the soft bar (Ctrl+N).");
                return;
            };
            let (fibres, id) = (body.fibres.clone(), body.id.clone());
            if fibres.is_empty() {
                ui.label("None yet: draw one stroke in the front view and one in the side view.");
            }
            for (k, fibre) in fibres.iter().enumerate() {
                let name = if fibre.name.is_empty() { &fibre.id } else { &fibre.name };
                let hue = theme::color(self.tone.pictures().fibre(k));
                ui.horizontal(|ui| {
                    let (spot, _) = ui.allocate_exact_size(egui::vec2(10.0, 10.0), egui::Sense::hover());
                    ui.painter().circle_filled(spot.center(), 5.0, hue);
                    let chosen = self.selected.as_ref() == Some(&fibre.id);
                    if ui.selectable_label(chosen, name).clicked() {
                        self.selected = (!chosen).then(|| fibre.id.clone());
                    }
                });
            }
            ui.add_space(2.0 * GRID);
            if let Some(fibre) = fibres.into_iter().find(|fibre| self.selected.as_ref() == Some(&fibre.id)) {
                ui.separator();
                self.inspector(ui, id, &fibre);
            }
        });
    }

    fn inspector(&mut self, ui: &mut Ui, body: String, fibre: &Fibre) {
        ui.heading(if fibre.name.is_empty() { &fibre.id } else { &fibre.name });
        let mut edited = fibre.clone();
        match &mut edited.stiffness {
            Stiffness::Rigidity(Rigidity { ea, ei, .. }) => {
                number(
                    ui,
                    "EA",
                    ea,
                    0.0..=1e9,
                    "N",
                    "Axial rigidity: resistance to stretching, l_f EA / 2 l0 per edge",
                );
                number(
                    ui,
                    "EI",
                    ei,
                    0.0..=1e6,
                    "N m²",
                    "Bending stiffness, l_f EI / L0 per vertex (eq. 7 with EI = Kb / 2)",
                );
            }
            Stiffness::Paper(PaperStiffness { kb, ks, .. }) => {
                number(ui, "Kb", kb, 0.0..=1e12, "", "Table 1's bending stiffness: EI = Kb V / 2");
                number(ui, "Ks", ks, 0.0..=1e9, "", "Table 1's stretching stiffness: EA = 2 Ks");
            }
        }
        number(
            ui,
            "Volume fraction",
            &mut edited.volume_fraction,
            0.0..=1.0,
            "",
            "Share of the material that is fibre at its centre line (eq. 18)",
        );
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
        self.control(ui, Action::Delete, "Delete fibre");
    }

    pub(super) fn right_panel(&mut self, ui: &mut Ui) {
        Panel::right("properties").default_size(SIDE_WIDTH).show(ui, |ui| {
            ui.set_min_width(ui.available_width());
            ui.add_space(GRID);
            if let Some(body) = self.active_body().cloned() {
                ui.heading("Material");
                let mut material = body.material.clone();
                number(
                    ui,
                    "Young's modulus",
                    &mut material.young_modulus,
                    1e2..=1e10,
                    "Pa",
                    "E: stiffness of the matrix; enters lambda and mu",
                );
                number(
                    ui,
                    "Poisson's ratio",
                    &mut material.poisson_ratio,
                    0.0..=0.49,
                    "",
                    "nu: how much it thins when pulled",
                );
                match &mut material.mass {
                    Mass::Density(density) => {
                        number(ui, "Density", density, 1.0..=1e5, "kg/m³", "Mass of the shape by its volume");
                    }
                    Mass::PerParticle(mass) => number(
                        ui,
                        "Particle mass",
                        mass,
                        1e-9..=1e3,
                        "kg",
                        "Mass of each material particle; the paper uses 4e-4",
                    ),
                }
                number(
                    ui,
                    "Damping",
                    &mut material.damping.pair,
                    0.0..=1e5,
                    "1/s",
                    "Between neighbours; keeps momentum",
                );
                number(
                    ui,
                    "Air drag",
                    &mut material.damping.air,
                    0.0..=1e5,
                    "1/s",
                    "Acceleration against the velocity",
                );
                number(
                    ui,
                    "Support radius",
                    &mut material.support_radius,
                    1e-4..=10.0,
                    "m",
                    "h: reach of the kernel; particles lie 0.4 h apart, so this samples the shape anew",
                );
                if material != body.material {
                    self.apply(&Command::SetMaterial { body: body.id, material });
                }
                ui.add_space(2.0 * GRID);
                ui.separator();
            }
            ui.heading("World");
            let mut gravity = self.scene().gravity;
            number(ui, "Gravity", &mut gravity[1], -100.0..=100.0, "m/s²", "Upwards; the earth's is -9.81");
            if gravity != self.scene().gravity {
                self.apply(&Command::SetGravity(gravity));
            }
            let mut room = self.scene().room.clone();
            let mut floor = room.floor.is_some();
            ui.checkbox(&mut floor, "Floor");
            room.floor = floor.then_some(room.floor.unwrap_or(0.0));
            if let Some(height) = &mut room.floor {
                number(ui, "Floor height", height, -100.0..=100.0, "m", "World Y");
            }
            number(ui, "Friction", &mut room.friction, 0.0..=10.0, "", "Coulomb's coefficient of floor and walls");
            if room != self.scene().room {
                self.apply(&Command::SetRoom(room));
            }
        });
    }
}

/// A labelled number with its unit, aligned over the panel.
fn number(ui: &mut Ui, label: &str, value: &mut f64, range: RangeInclusive<f64>, unit: &str, tooltip: &str) {
    ui.horizontal(|ui| {
        let text = ui.label(label).on_hover_text(tooltip);
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            // A drag across the panel changes the value by its own size, whatever that is.
            let speed = (value.abs() * 0.01).max(1e-6);
            let suffix = if unit.is_empty() { String::new() } else { format!(" {unit}") };
            let drag = DragValue::new(value)
                .range(range)
                .speed(speed)
                .suffix(suffix)
                .custom_formatter(|value, _| short(value));
            ui.add(drag).on_hover_text(tooltip).labelled_by(text.id);
        });
    });
}

/// A number in as few characters as it needs.
fn short(value: f64) -> String {
    if value == 0.0 || (1e-2..1e5).contains(&value.abs()) {
        let text = format!("{value:.4}");
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        format!("{value:.3e}")
    }
}

fn lower_first(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_lowercase().chain(letters).collect())
}
