//! The same scene under several integrators: what is chosen, what is plotted, the orders of convergence.

use super::context::{Context, Severity};
use super::field::NumberField;
use super::plots::{LINE, Trace, over_time, still};
use super::runs::{place, run_colour};
use super::theme::{self, GRID};
use crate::scene::{Assets, IntegratorKind, Scene};
use crate::sim::{ComparedRun, ComparedSample, Convergence, SimCommand, Study};
use egui::{RichText, Ui};
use egui_plot::{Line, MarkerShape, Plot, PlotPoints, Points};
use std::collections::VecDeque;
use std::sync::Arc;
use std::sync::mpsc::{Receiver, TryRecvError, channel};

/// Samples of a run that are kept: half a minute at sixty frames a second.
const KEPT: usize = 1800;
/// Height of the plots below the views [points].
const PLOTS_HEIGHT: f32 = 180.0;
/// The study of orders: its length [s], its coarsest run [steps a frame] and how often the step is halved.
const STUDY_SECONDS: f64 = 0.1;
const STUDY_STEPS: u32 = 32;
const STUDY_HALVINGS: u32 = 4;
/// Why nothing can be started.
const NONE_CHOSEN: &str = "Choose an integrator first";

const DT: NumberField =
    NumberField::new("Step", "s", 1e-7..=1.0, None, "DT: every run takes exactly this step, whatever comes of it");

/// What a person compares, with what was published of it.
#[derive(Default)]
pub(super) struct Comparison {
    chosen: Vec<IntegratorKind>,
    dt: Option<f64>,
    /// Samples of each run.
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
            let found = Study::new(&scene, &assets)
                .map(|study| study.convergence(&chosen, STUDY_SECONDS, STUDY_STEPS, STUDY_HALVINGS));
            // The window may be gone by now.
            let _ = sender.send(found.map_err(|error| error.to_string()));
            ctx.request_repaint();
        });
        self.studying = Some(receiver);
    }

    /// The tab: what is compared, how the runs stand and the orders of convergence.
    pub(super) fn tab(&mut self, ui: &mut Ui, cx: &mut Context) {
        ui.heading("Compare integrators");
        ui.label(RichText::new("Runs the scene side by side from its start, in step").weak());
        for kind in IntegratorKind::ALL {
            let mut on = self.chosen.contains(&kind);
            ui.horizontal(|ui| {
                let (spot, _) = ui.allocate_exact_size(egui::vec2(10.0, 10.0), egui::Sense::hover());
                ui.painter().circle_filled(spot.center(), 5.0, run_colour(cx.tone, kind));
                if ui.checkbox(&mut on, kind.name()).changed() {
                    self.chosen.retain(|old| *old != kind);
                    if on {
                        self.chosen.push(kind);
                    }
                    self.chosen.sort_by_key(|kind| place(*kind));
                }
            });
        }
        let present = cx.simulation.published().status.bodies.iter().map(|body| body.dt).fold(f64::INFINITY, f64::min);
        let mut dt = self.dt.unwrap_or(if present.is_finite() { present } else { 1e-3 });
        if DT.show(ui, &mut dt) {
            self.dt = Some(dt);
        }
        ui.add_space(GRID);
        ui.horizontal(|ui| {
            let some = !self.chosen.is_empty();
            let tooltip = "Starts every chosen integrator at the start of the scene";
            let button = ui.add_enabled(some, egui::Button::new("Start comparison")).on_hover_text(tooltip);
            if button.on_disabled_hover_text(NONE_CHOSEN).clicked() {
                self.histories.clear();
                cx.ask(SimCommand::Compare { integrators: self.chosen.clone(), dt });
                cx.ask(SimCommand::Play);
            }
            let running = cx.simulation.is_comparing();
            let button = ui.add_enabled(running, egui::Button::new("End")).on_hover_text("Goes back to the scene");
            if button.on_disabled_hover_text("Nothing is being compared").clicked() {
                cx.ask(SimCommand::Compare { integrators: Vec::new(), dt });
            }
        });
        runs(ui, cx, dt);
        self.order_study(ui, cx);
    }

    /// The log-log plot of errors over steps.
    fn order_study(&mut self, ui: &mut Ui, cx: &mut Context) {
        ui.add_space(2.0 * GRID);
        let obstacle = if self.chosen.is_empty() {
            Some(NONE_CHOSEN)
        } else {
            self.studying.is_some().then_some("The orders are being measured")
        };
        let tooltip = "Runs the first tenth of a second with ever finer steps and plots the error against the step";
        let button = ui.add_enabled(obstacle.is_none(), egui::Button::new("Measure the orders")).on_hover_text(tooltip);
        if button.on_disabled_hover_text(obstacle.unwrap_or_default()).clicked() {
            let (scene, assets) = (Arc::clone(cx.scene()), Arc::clone(cx.document.assets()));
            self.study(scene, assets, ui.ctx().clone());
        }
        if let Some(receiver) = &self.studying {
            match receiver.try_recv() {
                Ok(Ok(found)) => {
                    self.orders = found;
                    self.studying = None;
                }
                Ok(Err(problem)) => {
                    self.studying = None;
                    cx.say(Severity::Error, problem);
                }
                Err(TryRecvError::Disconnected) => self.studying = None,
                Err(TryRecvError::Empty) => {
                    ui.horizontal(|ui| {
                        ui.spinner();
                        ui.label("Measuring…");
                    });
                }
            }
        }
        if self.orders.is_empty() {
            return;
        }
        for found in &self.orders {
            let order = found.order.map_or("no two stable runs".to_owned(), |order| format!("order {order:.2}"));
            let colour = run_colour(cx.tone, found.integrator);
            ui.colored_label(colour, format!("{}: {order}", found.integrator.name()));
        }
        ui.label(RichText::new("log10 of the position error [m] over log10 of DT [s]").weak().small());
        still(Plot::new("orders")).height(180.0).show(ui, |plot| {
            for found in &self.orders {
                let colour = run_colour(cx.tone, found.integrator);
                let points: Vec<[f64; 2]> = found.points.iter().map(|(dt, e)| [dt.log10(), e.log10()]).collect();
                let name = found.integrator.name();
                plot.line(Line::new(name, PlotPoints::from(points.clone())).color(colour).width(1.5));
                let marks = Points::new(name, PlotPoints::from(points));
                plot.points(marks.color(colour).radius(3.0).shape(MarkerShape::Circle));
            }
        });
    }

    /// Plots of what is compared, below the views.
    pub(super) fn plots(&self, ui: &mut Ui, cx: &Context) {
        egui::Panel::bottom("plots").exact_size(PLOTS_HEIGHT).frame(theme::panel(ui)).show(ui, |ui| {
            ui.columns(4, |columns| {
                let [energy, momentum, volume, pressure] = columns else { return };
                self.plot(energy, cx, ["Energy [J]", "J"], |sample| Some(sample.energy));
                self.plot(momentum, cx, ["Momentum [kg m/s]", "kg m/s"], |sample| Some(sample.momentum));
                self.plot(volume, cx, ["Volume [m³], area [m²]", ""], |sample| sample.volume);
                self.plot(pressure, cx, ["Pressure [Pa]", "Pa"], |sample| sample.pressure);
            });
        });
    }

    fn plot(&self, ui: &mut Ui, cx: &Context, [title, unit]: [&str; 2], value: fn(&ComparedSample) -> Option<f64>) {
        ui.label(RichText::new(title).small());
        let compared = &cx.simulation.published().compared;
        let histories = compared.iter().zip(&self.histories);
        if let Some(why) = why_empty(compared, self.histories.iter().flatten(), value) {
            ui.label(RichText::new(why).weak().small());
            return;
        }
        let trace = |(run, history): (&ComparedRun, &VecDeque<ComparedSample>)| Trace {
            name: run.integrator.name().to_owned(),
            colour: run_colour(cx.tone, run.integrator),
            width: LINE,
            dashed: false,
            points: history.iter().filter_map(|sample| Some([sample.time, value(sample)?])).collect(),
        };
        over_time(ui, title, PLOTS_HEIGHT - 7.0 * GRID, unit, histories.map(trace).collect(), None);
    }
}

/// Why there is nothing to plot; none where there is something.
fn why_empty<'a>(
    compared: &[ComparedRun],
    mut samples: impl Iterator<Item = &'a ComparedSample>,
    value: fn(&ComparedSample) -> Option<f64>,
) -> Option<&'static str> {
    if samples.any(|sample| value(sample).is_some()) {
        return None;
    }
    // What was published of a run that has blown up still tells whether there is such a value.
    Some(if !compared.iter().any(|run| value(&run.sample).is_some()) {
        "The scene has no two-layer body that encloses gas"
    } else if compared.iter().all(|run| run.blew_up_at.is_some()) {
        "Every run blew up before there was anything to plot: choose a smaller step"
    } else {
        "Nothing is computed yet"
    })
}

/// How each run stands.
fn runs(ui: &mut Ui, cx: &Context, dt: f64) {
    let published = cx.simulation.published();
    for run in &published.compared {
        ui.add_space(GRID);
        ui.colored_label(run_colour(cx.tone, run.integrator), run.integrator.name());
        let limit =
            if run.stable_dt.is_finite() { format!("limit {:.3e} s", run.stable_dt) } else { "any step".to_owned() };
        if dt > run.stable_dt {
            let limits = published.status.bodies.iter().find_map(|body| body.limited_by.as_deref());
            let set_by = cx.set_by(limits);
            ui.colored_label(cx.tone.error(), format!("DT {dt:.3e} s is beyond its {limit}{set_by}"));
        } else {
            ui.label(format!("DT {dt:.3e} s, {limit}"));
        }
        if let Some(at) = run.blew_up_at {
            ui.colored_label(cx.tone.error(), format!("Blew up at {at:.3} s"));
        } else if let Some(gained) = run.gained {
            ui.colored_label(cx.tone.warning(), format!("Gained {gained:.1} times its energy"));
        }
    }
}
