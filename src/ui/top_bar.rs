//! The bar of menus and play controls above, with the read-out of the running simulation.

use super::action::Action;
use super::ahead::told;
use super::context::Context;
use super::controls::{button, menu_entry};
use super::menu::Menu;
use super::recent_menu::recent_menu;
use super::theme::{self, GRID};
use crate::sim::SimCommand;
use crate::text::number::{moment, ratio};
use egui::{DragValue, Label, Panel, RichText, Ui};
use std::collections::VecDeque;
use std::path::PathBuf;

/// Width [points] below which only the pace is read out.
const ROOMY: f32 = 420.0;

/// The bar above the views.
pub(super) struct TopBar {
    /// Simulated over real time that is aimed at.
    speed: f64,
    /// When the last frames were shown [s].
    frame_times: VecDeque<f64>,
}

impl Default for TopBar {
    fn default() -> Self {
        Self { speed: 1.0, frame_times: VecDeque::new() }
    }
}

impl TopBar {
    /// Keeps the times of the last second's frames.
    pub(super) fn count_frame(&mut self, ctx: &egui::Context) {
        if ctx.will_discard() {
            // It is one of several passes over the input of a frame, and not drawn.
            return;
        }
        let now = ctx.input(|input| input.time);
        self.frame_times.push_back(now);
        while self.frame_times.front().is_some_and(|time| *time < now - 1.0) {
            self.frame_times.pop_front();
        }
    }

    /// Simulated over real time that is aimed at.
    pub(super) fn speed(&self) -> f64 {
        self.speed
    }

    /// Aims at so much simulated over real time.
    pub(super) fn choose_speed(&mut self, speed: f64, cx: &Context) {
        self.speed = speed;
        cx.ask(SimCommand::Speed(speed));
    }

    /// Shows the bar, with the files that were used in its menu.
    pub(super) fn show(&mut self, ui: &mut Ui, cx: &mut Context, recent: &[PathBuf], draws_in_software: bool) {
        Panel::top("top").frame(theme::panel(ui)).show(ui, |ui| {
            ui.add_space(GRID);
            ui.horizontal(|ui| {
                menus(ui, cx, recent);
                ui.separator();
                let playing = cx.simulation.is_playing();
                button(ui, cx, Action::PlayPause, if playing { "Pause" } else { "Play" });
                button(ui, cx, Action::Step, "Step");
                button(ui, cx, Action::Reset, "Reset");
                ui.separator();
                ui.label("Speed");
                let speed = DragValue::new(&mut self.speed).range(0.01..=4.0).speed(0.01).max_decimals(2).suffix(" ×");
                if ui.add(speed).on_hover_text("Simulated over real time that is aimed at").changed() {
                    cx.ask(SimCommand::Speed(self.speed));
                }
                ui.separator();
                self.read_out(ui, cx, draws_in_software);
            });
            ui.add_space(GRID);
        });
    }

    /// Time and pace of the simulation; why it is slow, where it is.
    fn read_out(&self, ui: &mut Ui, cx: &Context, draws_in_software: bool) {
        if cx.simulation.published().status.baking.is_some() {
            let stop =
                ui.button("Stop").on_hover_text("Stops putting the scene together; what was there before goes on");
            if stop.clicked() {
                cx.simulation.stop_building();
            }
        }
        let is_ahead = cx.simulation.published().status.ahead.is_some();
        if is_ahead && ui.button("Stop").on_hover_text("Stops computing; what is there is kept").clicked() {
            cx.ask(SimCommand::Pause);
        }
        let status = &cx.simulation.published().status;
        let slow = status.real_time_factor < 0.9 * self.speed;
        let now = |time| moment(time, cx.scene().time.frame_seconds());
        let text = if let Some(baking) = &status.baking {
            format!("Putting together {baking}…")
        } else if status.stopped {
            "Stopped before it was put together; Reset does that".to_owned()
        } else if let Some(ahead) = status.ahead {
            told(ahead, status.time, status.real_time_factor)
        } else if status.real_time_factor > 0.0 && status.playing {
            let pace = if slow { "slow motion, " } else { "" };
            let pace = format!("{pace}{} × real time", ratio(status.real_time_factor));
            if ui.available_width() < ROOMY {
                format!("{}   {pace}", now(status.time))
            } else {
                format!("{}   {} pictures/s   {pace}", now(status.time), self.frame_times.len())
            }
        } else if cx.simulation.is_replaying() {
            let last = status.recording.span.map_or(status.time, |span| span[1]);
            format!("{} of {}", now(status.time), now(last))
        } else {
            now(status.time)
        };
        let mut why = vec![format!("{} particles", status.particles)];
        if status.playing {
            why.push(format!("{:.0} frames computed a second", status.frames_per_second));
        }
        if let Some(body) = status.bodies.iter().max_by_key(|body| body.substeps) {
            why.push(format!(
                "{} steps a frame of {:.3e} s, which {} needs: its stable step is {:.3e} s",
                body.substeps, body.dt, body.name, body.stable_dt
            ));
        }
        if slow && status.playing && !is_ahead {
            let slow = "Slow motion: these steps take longer to compute than they last. Softer materials and fibres, \
                        fewer particles or a greater density need fewer";
            why.push(slow.to_owned());
        }
        if draws_in_software {
            let saves = "Drawn in software: no anti-aliasing, coarser shadows, and views are drawn anew only when what \
                         they show changes";
            why.push(saves.to_owned());
        }
        let why = why.join("\n");
        ui.add(Label::new(RichText::new(text).monospace()).truncate()).on_hover_text(&why);
        if draws_in_software {
            ui.add(Label::new(RichText::new("software driver").weak()).truncate()).on_hover_text(why);
        }
    }
}

/// The menus of all actions.
fn menus(ui: &mut Ui, cx: &mut Context, recent: &[PathBuf]) {
    for menu in Menu::ALL {
        ui.menu_button(menu.title(), |ui| {
            for action in Action::ALL.into_iter().filter(|action| action.menu() == menu) {
                menu_entry(ui, cx, action);
                if action == Action::Open {
                    recent_menu(ui, recent, cx);
                }
            }
        });
    }
}
