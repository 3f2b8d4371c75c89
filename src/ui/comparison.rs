//! The same scene under several integrators: what is chosen, what is plotted, the orders of convergence.

use super::app::{App, Gravity};
use super::field::Field;
use super::plots::{LINE, Trace, over_time, still};
use super::properties::{INTEGRATORS, integrator_name};
use super::theme::{self, GRID};
use crate::scene::{Assets, IntegratorKind, Scene};
use crate::sim::{ComparedRun, ComparedSample, Convergence, SimCommand, convergence_study};
use egui::{Color32, RichText, Ui};
use egui_plot::{Line, MarkerShape, Plot, PlotPoints, Points};
use std::collections::VecDeque;
use std::sync::Arc;
use std::sync::mpsc::{Receiver, TryRecvError, channel};

/// Readings of a run that are kept: half a minute at sixty frames a second.
const KEPT: usize = 1800;
/// Height of the plots below the views [points].
const PLOTS_HEIGHT: f32 = 180.0;
/// The study of orders: its length [frames], its coarsest run [steps a frame] and how often the step is halved.
const STUDY_SECONDS: f64 = 0.1;
const STUDY_STEPS: u32 = 32;
const STUDY_HALVINGS: u32 = 4;
/// Why nothing can be started.
const NONE_CHOSEN: &str = "Choose an integrator first";

const DT: Field =
    Field::new("Step", "s", 1e-7..=1.0, None, "DT: every run takes exactly this step, whatever comes of it");

/// What a person compares.
#[derive(Default)]
pub(super) struct Comparison {
    chosen: Vec<IntegratorKind>,
    dt: Option<f64>,
    /// Readings of each run.
    histories: Vec<VecDeque<ComparedSample>>,
    studying: Option<Receiver<Result<Vec<Convergence>, String>>>,
    orders: Vec<Convergence>,
}

impl Comparison {
    /// Keeps what was published.
    pub(super) fn record(&mut self, compared: &[ComparedRun]) {
        self.histories.resize(compared.len(), VecDeque::new());
        for (history, run) in self.histories.iter_mut().zip(compared) {
            let fresh = history.back().is_none_or(|last| last.time != run.sample.time);
            if history.back().is_some_and(|last| last.time > run.sample.time) {
                history.clear();
            }
            if fresh && run.blew_up_at.is_none() {
                history.push_back(run.sample);
            }
            if history.len() > KEPT {
                history.pop_front();
            }
        }
    }

    fn study(&mut self, scene: Arc<Scene>, assets: Arc<Assets>, ctx: egui::Context) {
        let (sender, receiver) = channel();
        let chosen = self.chosen.clone();
        std::thread::spawn(move || {
            let found = convergence_study(&scene, &assets, &chosen, STUDY_SECONDS, STUDY_STEPS, STUDY_HALVINGS);
            // The window may be gone by now.
            let _ = sender.send(found.map_err(|error| error.to_string()));
            ctx.request_repaint();
        });
        self.studying = Some(receiver);
    }
}

impl App {
    pub(super) fn comparison_tab(&mut self, ui: &mut Ui) {
        ui.heading("Compare integrators");
        ui.label(RichText::new("Runs the scene side by side from its start, in step").weak());
        for (index, (kind, name)) in INTEGRATORS.into_iter().enumerate() {
            let mut on = self.comparison.chosen.contains(&kind);
            ui.horizontal(|ui| {
                let (spot, _) = ui.allocate_exact_size(egui::vec2(10.0, 10.0), egui::Sense::hover());
                ui.painter().circle_filled(spot.center(), 5.0, self.run_colour(index));
                if ui.checkbox(&mut on, name).changed() {
                    self.comparison.chosen.retain(|old| *old != kind);
                    if on {
                        self.comparison.chosen.push(kind);
                    }
                    self.comparison.chosen.sort_by_key(|kind| place(*kind));
                }
            });
        }
        let present = self.published.status.bodies.iter().map(|body| body.dt).fold(f64::INFINITY, f64::min);
        let mut dt = self.comparison.dt.unwrap_or(if present.is_finite() { present } else { 1e-3 });
        if DT.show(ui, &mut dt) {
            self.comparison.dt = Some(dt);
        }
        ui.add_space(GRID);
        ui.horizontal(|ui| {
            let some = !self.comparison.chosen.is_empty();
            let tooltip = "Starts every chosen integrator at the start of the scene";
            let button = ui.add_enabled(some, egui::Button::new("Start comparison")).on_hover_text(tooltip);
            if button.on_disabled_hover_text(NONE_CHOSEN).clicked() {
                self.comparison.histories.clear();
                self.ask(SimCommand::Compare { integrators: self.comparison.chosen.clone(), dt });
                self.ask(SimCommand::Play);
            }
            let running = !self.published.compared.is_empty();
            let button = ui.add_enabled(running, egui::Button::new("End")).on_hover_text("Goes back to the scene");
            if button.on_disabled_hover_text("Nothing is being compared").clicked() {
                self.ask(SimCommand::Compare { integrators: Vec::new(), dt });
            }
        });
        self.runs(ui, dt);
        self.orders(ui);
    }

    /// How each run stands.
    fn runs(&self, ui: &mut Ui, dt: f64) {
        for run in &self.published.compared {
            ui.add_space(GRID);
            ui.colored_label(self.run_colour(place(run.integrator)), integrator_name(run.integrator));
            let limit = if run.stable_dt.is_finite() {
                format!("limit {:.3e} s", run.stable_dt)
            } else {
                "any step".to_owned()
            };
            if dt > run.stable_dt {
                let limits = self.published.status.bodies.iter().find_map(|body| body.limited_by.as_deref());
                let set_by = self.set_by(limits);
                ui.colored_label(self.tone.error(), format!("DT {dt:.3e} s is beyond its {limit}{set_by}"));
            } else {
                ui.label(format!("DT {dt:.3e} s, {limit}"));
            }
            if let Some(at) = run.blew_up_at {
                ui.colored_label(self.tone.error(), format!("Blew up at {at:.3} s"));
            }
        }
    }

    /// The log-log plot of errors over steps.
    fn orders(&mut self, ui: &mut Ui) {
        ui.add_space(2.0 * GRID);
        let obstacle = if self.comparison.chosen.is_empty() {
            Some(NONE_CHOSEN)
        } else {
            self.comparison.studying.is_some().then_some("The orders are being measured")
        };
        let tooltip = "Runs the first tenth of a second with ever finer steps and plots the error against the step";
        let button = ui.add_enabled(obstacle.is_none(), egui::Button::new("Measure the orders")).on_hover_text(tooltip);
        if button.on_disabled_hover_text(obstacle.unwrap_or_default()).clicked() {
            let (scene, assets) = (Arc::clone(self.scene()), Arc::clone(&self.assets));
            self.comparison.study(scene, assets, ui.ctx().clone());
        }
        if let Some(receiver) = &self.comparison.studying {
            match receiver.try_recv() {
                Ok(Ok(found)) => {
                    self.comparison.orders = found;
                    self.comparison.studying = None;
                }
                Ok(Err(problem)) => {
                    self.comparison.studying = None;
                    self.say(Gravity::Error, problem);
                }
                Err(TryRecvError::Disconnected) => self.comparison.studying = None,
                Err(TryRecvError::Empty) => {
                    ui.horizontal(|ui| {
                        ui.spinner();
                        ui.label("Measuring…");
                    });
                }
            }
        }
        if self.comparison.orders.is_empty() {
            return;
        }
        for found in &self.comparison.orders {
            let order = found.order.map_or("no two stable runs".to_owned(), |order| format!("order {order:.2}"));
            let colour = self.run_colour(place(found.integrator));
            ui.colored_label(colour, format!("{}: {order}", integrator_name(found.integrator)));
        }
        ui.label(RichText::new("log10 of the position error [m] over log10 of DT [s]").weak().small());
        still(Plot::new("orders")).height(180.0).show(ui, |plot| {
            for found in &self.comparison.orders {
                let colour = self.run_colour(place(found.integrator));
                let points: Vec<[f64; 2]> = found.points.iter().map(|(dt, e)| [dt.log10(), e.log10()]).collect();
                let name = integrator_name(found.integrator);
                plot.line(Line::new(name, PlotPoints::from(points.clone())).color(colour).width(1.5));
                let marks = Points::new(name, PlotPoints::from(points));
                plot.points(marks.color(colour).radius(3.0).shape(MarkerShape::Circle));
            }
        });
    }

    /// Plots of what is compared, below the views.
    pub(super) fn compared_plots(&mut self, ui: &mut Ui) {
        egui::Panel::bottom("plots").exact_size(PLOTS_HEIGHT).frame(theme::panel(ui)).show(ui, |ui| {
            ui.columns(4, |columns| {
                let [energy, momentum, volume, pressure] = columns else { return };
                self.plot(energy, ["Energy [J]", "J"], |reading| Some(reading.energy));
                self.plot(momentum, ["Momentum [kg m/s]", "kg m/s"], |reading| Some(reading.momentum));
                self.plot(volume, ["Volume [m³], area [m²]", ""], |reading| reading.volume);
                self.plot(pressure, ["Pressure [Pa]", "Pa"], |reading| reading.pressure);
            });
        });
    }

    fn plot(&self, ui: &mut Ui, [title, unit]: [&str; 2], value: impl Fn(&ComparedSample) -> Option<f64>) {
        ui.label(RichText::new(title).small());
        let histories = self.published.compared.iter().zip(&self.comparison.histories);
        if !self.comparison.histories.iter().flatten().any(|reading| value(reading).is_some()) {
            ui.label(RichText::new("The scene has no two-layer body that encloses gas").weak().small());
            return;
        }
        let trace = |(run, history): (&ComparedRun, &VecDeque<ComparedSample>)| Trace {
            name: integrator_name(run.integrator).to_owned(),
            colour: self.run_colour(place(run.integrator)),
            width: LINE,
            dashed: false,
            points: history.iter().filter_map(|reading| Some([reading.time, value(reading)?])).collect(),
        };
        over_time(ui, title, PLOTS_HEIGHT - 7.0 * GRID, unit, histories.map(trace).collect(), None);
    }

    /// The colour of an integrator's run.
    fn run_colour(&self, index: usize) -> Color32 {
        theme::color(self.tone.pictures().fibre(index))
    }

    /// Colours of the bodies in the order of the snapshot; none where nothing is compared.
    pub(super) fn tints(&self) -> Vec<crate::draw::Colour> {
        let theme = self.tone.pictures();
        let runs = self.published.compared.iter();
        runs.flat_map(|run| std::iter::repeat_n(theme.fibre(place(run.integrator)), run.bodies)).collect()
    }
}

fn place(kind: IntegratorKind) -> usize {
    INTEGRATORS.iter().position(|(known, _)| *known == kind).unwrap_or_default()
}
