//! The bar of menus and play controls above, the line of status below.

use super::action::Action;
use super::app::{App, Gravity};
use super::menu::Menu;
use super::sketch_tool::Stage;
use super::theme::{self, GRID};
use crate::edit::Command;
use crate::scene::TimeStep;
use crate::sim::SimCommand;
use crate::text::number::{moment, ratio};
use egui::{Button, DragValue, Label, Panel, RichText, Ui};

impl App {
    /// A menu entry for an action, marked where it is a switch that is on.
    fn entry(&mut self, ui: &mut Ui, action: Action) {
        let shortcut = action.shortcuts().first().map(|shortcut| ui.ctx().format_shortcut(shortcut));
        let text = self.menu_text(action);
        let mut button = match self.is_on(action) {
            Some(on) => Button::selectable(on, text),
            None => Button::new(text),
        };
        if let Some(shortcut) = &shortcut {
            button = button.shortcut_text(shortcut);
        }
        let obstacle = self.obstacle(action);
        let response = ui.add_enabled(obstacle.is_none(), button).on_hover_text(action.tooltip());
        let response = response.on_disabled_hover_text(obstacle.unwrap_or_default());
        if response.clicked() {
            let ctx = ui.ctx().clone();
            self.perform(&ctx, action);
            ui.close();
        }
    }

    /// A plain button for an action, with its name and key in the tooltip.
    pub(super) fn control(&mut self, ui: &mut Ui, action: Action, text: &str) {
        let key = action.shortcuts().first().map_or_else(String::new, |shortcut| ui.ctx().format_shortcut(shortcut));
        let hover = if key.is_empty() { action.tooltip().to_owned() } else { format!("{} ({key})", action.tooltip()) };
        let obstacle = self.obstacle(action);
        let response = ui.add_enabled(obstacle.is_none(), Button::new(text)).on_hover_text(hover);
        if response.on_disabled_hover_text(obstacle.unwrap_or_default()).clicked() {
            let ctx = ui.ctx().clone();
            self.perform(&ctx, action);
        }
    }

    pub(super) fn top_bar(&mut self, ui: &mut Ui) {
        Panel::top("top").frame(theme::panel(ui)).show(ui, |ui| {
            ui.add_space(GRID);
            ui.horizontal(|ui| {
                for menu in Menu::ALL {
                    ui.menu_button(menu.title(), |ui| {
                        for action in Action::ALL.into_iter().filter(|action| action.menu() == menu) {
                            self.entry(ui, action);
                            if action == Action::Open {
                                self.recent_menu(ui);
                            }
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
        let slow = status.real_time_factor < 0.9 * self.speed;
        let now = |time| moment(time, self.scene().time.frame_seconds());
        let text = if let Some(baking) = &status.baking {
            format!("Putting together {baking}…")
        } else if status.real_time_factor > 0.0 && status.playing {
            let pace = if slow { "slow motion, " } else { "" };
            format!(
                "{}   {:.0} frames/s, {} drawn   {pace}{} × real time",
                now(status.time),
                status.frames_per_second,
                self.frame_times.len(),
                ratio(status.real_time_factor)
            )
        } else if self.in_replay() {
            let last = status.recording.span.map_or(status.time, |span| span[1]);
            format!("{} of {}", now(status.time), now(last))
        } else {
            now(status.time)
        };
        let mut why = vec![format!("{} particles", status.particles)];
        if let Some(body) = status.bodies.iter().max_by_key(|body| body.substeps) {
            why.push(format!(
                "{} steps a frame of {:.3e} s, which {} needs: its stable step is {:.3e} s",
                body.substeps, body.dt, body.name, body.stable_dt
            ));
        }
        if slow && status.playing {
            let slow = "Slow motion: these steps take longer to compute than they last. Softer materials and fibres, fewer \
                        particles or a greater density need fewer";
            why.push(slow.to_owned());
        }
        let software = self.painter.as_ref().is_some_and(super::picture::Painter::saves_work);
        if software {
            let saves = "Drawn in software: no anti-aliasing, coarser shadows, and views are drawn anew only when what they \
                         show changes";
            why.push(saves.to_owned());
        }
        let why = why.join("\n");
        ui.label(RichText::new(text).monospace()).on_hover_text(&why);
        if software {
            ui.label(RichText::new("software driver").weak()).on_hover_text(why);
        }
    }

    pub(super) fn status_bar(&mut self, ui: &mut Ui) {
        Panel::bottom("status").frame(theme::panel(ui)).show(ui, |ui| {
            ui.add_space(0.5 * GRID);
            ui.horizontal(|ui| {
                let status = &self.published.status;
                if let Some(failure) = status.failure.clone() {
                    ui.colored_label(self.tone.error(), format!("Stopped: {}", self.scene().with_names(&failure)));
                    return;
                }
                if let Some(divergence) = status.divergence.clone() {
                    self.offer_fix(ui);
                    ui.colored_label(self.tone.error(), format!("Stopped: {}", self.scene().with_names(&divergence)));
                    return;
                }
                self.offer_after_sketch(ui);
                if let Some((gravity, text)) = &self.message {
                    let (mark, color) = match gravity {
                        Gravity::Note => ("", ui.visuals().text_color()),
                        Gravity::Warning => ("Warning: ", self.tone.warning()),
                        Gravity::Error => ("Error: ", self.tone.error()),
                    };
                    let text = format!("{mark}{text}");
                    ui.add(Label::new(RichText::new(&text).color(color)).truncate()).on_hover_text(text);
                    ui.separator();
                }
                let hint = self.editing.hint().unwrap_or_else(|| self.hint.to_owned());
                ui.add(Label::new(RichText::new(hint).weak()).truncate());
            });
            ui.add_space(0.5 * GRID);
        });
    }

    /// What takes a body that was stopped on again.
    fn offer_fix(&mut self, ui: &mut Ui) {
        let mut time = self.scene().time.clone();
        let (text, tooltip) = match &mut time.step {
            TimeStep::Manual(_) => {
                time.step = TimeStep::default();
                ("Step automatically and restart", "Chooses the time step from the stable one that is measured")
            }
            TimeStep::Automatic(step) => {
                step.safety = (0.5 * step.safety).max(0.01);
                ("Halve the step and restart", "Halves the share of the stable time step that is used")
            }
        };
        if ui.button(text).on_hover_text(tooltip).clicked() {
            self.gesture += 1;
            self.apply(&Command::SetTime(time));
            self.ask(SimCommand::Reset);
            self.ask(SimCommand::Play);
        }
    }

    /// What may be meant otherwise by the strokes that were drawn last.
    fn offer_after_sketch(&mut self, ui: &mut Ui) {
        if matches!(self.tool.stage(), Stage::Refused { .. })
            && ui.button("Stretch instead").on_hover_text("Stretches the second stroke onto the first").clicked()
        {
            let diagonal = self.model_diagonal();
            if let Some(outcome) = self.tool.stretch(diagonal) {
                self.sketched(outcome);
            }
        }
        if self.drawn_last.is_some() && self.drawn_last.as_ref() == self.editing.selection.active() {
            self.stroke_choices(ui);
        }
    }
}

fn lower_first(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_lowercase().chain(letters).collect())
}
