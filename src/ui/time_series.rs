//! Energies, momenta and measures of the running scene, as plots below the views.

use super::action::Action;
use super::context::Context;
use super::controls::button;
use super::plots::{BOLD, LINE, THIN, Trace, over_time, thinned};
use super::theme::{self, GRID, Tone};
use crate::sim::{ColumnKind, TimeSeries, TimeSeriesSet};
use crate::solver::energy::Energies;
use crate::text::number::three_figures;
use egui::{Align2, Color32, Panel, RichText, Role, ScrollArea, Sense, TextStyle, Ui, Vec2, WidgetInfo};
use std::collections::BTreeSet;

/// Height of the panel and of a plot in it [points].
const HEIGHT: f32 = 212.0;
const PLOT: f32 = 168.0;
/// Width of the legend and height of its rows [points].
const LEGEND: f32 = 200.0;
const ROW: f32 = 16.0;
/// Hue of the first kind of energy [turns].
const FIRST_HUE: f32 = 0.05;
/// Time that is plotted [s], and points that a line has at most, or twice that.
const SPAN: f64 = 30.0;
const POINTS: u64 = 300;

/// The plots of what was recorded of the scene, with their legend.
#[derive(Default)]
pub(super) struct TimeSeriesPanel {
    /// Whether the panel is open.
    pub open: bool,
    tab: Tab,
    /// Lines that are left out, by their names.
    hidden: BTreeSet<String>,
}

/// Which plot is shown.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
enum Tab {
    #[default]
    Energies,
    Momenta,
    /// Measures in this unit.
    Measures(&'static str),
}

/// A quantity that is plotted: the sum of some columns, or the length of the vector that three such sums are.
struct Curve {
    name: String,
    colour: Color32,
    width: f32,
    sums: Vec<Vec<usize>>,
}

impl Curve {
    fn of(name: impl Into<String>, colour: Color32, sums: Vec<Vec<usize>>) -> Self {
        Self { name: name.into(), colour, width: LINE, sums }
    }

    fn bold(self) -> Self {
        Self { width: BOLD, ..self }
    }

    fn read(&self, row: &[f64]) -> f64 {
        let sum = |columns: &Vec<usize>| columns.iter().map(|&column| row[column]).sum::<f64>();
        match self.sums.as_slice() {
            [one] => sum(one),
            several => several.iter().map(|columns| sum(columns).powi(2)).sum::<f64>().sqrt(),
        }
    }

    /// Its line through the last rows.
    fn trace(&self, series: &TimeSeries) -> Trace {
        let now = series.last().map_or(0.0, |row| row[0]);
        let rows = series.rows().rev().take_while(|(_, row)| row[0] >= now - SPAN).count();
        let bucket = (rows as u64).div_ceil(POINTS).next_power_of_two();
        let shown = series.rows().skip(series.len() - rows);
        let points = thinned(
            shown.map(|(number, row)| (number, [row[0], self.read(row)])).filter(|(_, [_, value])| value.is_finite()),
            bucket,
        );
        Trace { name: self.name.clone(), colour: self.colour, width: self.width, dashed: false, points }
    }
}

/// A plot with its title and unit.
struct Chart {
    title: &'static str,
    unit: &'static str,
    curves: Vec<Curve>,
}

/// Columns of one kind.
fn columns(series: &TimeSeries, kind: ColumnKind) -> Vec<usize> {
    (0..series.columns().len()).filter(|&k| series.columns()[k].kind == kind).collect()
}

/// The units of the measures, each once, in their order.
fn units(series: &TimeSeries) -> Vec<&'static str> {
    let mut units = Vec::new();
    for column in series.columns().iter().filter(|column| column.kind == ColumnKind::Measure) {
        if !units.contains(&column.unit) {
            units.push(column.unit);
        }
    }
    units
}

/// An energy's name as people read it.
fn spoken(name: &str) -> String {
    let name = name.replace('_', "-");
    name[..1].to_uppercase() + &name[1..]
}

impl TimeSeriesPanel {
    /// Shows the panel below the views, if it is open.
    pub(super) fn show(&mut self, ui: &mut Ui, cx: &mut Context) {
        if self.open {
            Panel::bottom("readings").exact_size(HEIGHT).frame(theme::panel(ui)).show(ui, |ui| self.content(ui, cx));
        }
    }

    fn content(&mut self, ui: &mut Ui, cx: &mut Context) {
        let (units, rows) = cx.simulation.time_series(|recorded| (units(&recorded.world), recorded.world.len()));
        if let Tab::Measures(unit) = self.tab
            && !units.contains(&unit)
        {
            self.tab = Tab::Energies;
        }
        ui.horizontal(|ui| {
            let mut tabs = vec![
                (Tab::Energies, "Energies".to_owned(), "Energies of all bodies, by what stores them"),
                (Tab::Momenta, "Momenta".to_owned(), "Linear and angular momentum of all bodies"),
            ];
            let measures = "What the scene measures, in this unit";
            tabs.extend(units.iter().map(|unit| (Tab::Measures(unit), format!("Measures [{unit}]"), measures)));
            for (tab, name, tooltip) in tabs {
                if ui.selectable_label(self.tab == tab, name).on_hover_text(tooltip).clicked() {
                    self.tab = tab;
                }
            }
            if units.is_empty() {
                ui.label(RichText::new("The scene measures nothing").weak());
            }
            ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
                button(ui, cx, Action::Plots, "Close");
                button(ui, cx, Action::Export, "Export as CSV…");
            });
        });
        if rows < 2 {
            ui.add_space(GRID);
            ui.label(RichText::new("Lines appear as the simulation runs: press Play").weak());
            return;
        }
        let seen = cx.simulation.is_replaying().then_some(cx.simulation.published().status.time);
        let (entries, shown, mark) = cx.simulation.time_series(|recorded| {
            let charts = self.charts(&recorded.world, cx.tone);
            let traces = |chart: &Chart| (chart.title, chart.unit, self.traces(chart, recorded));
            let series = &recorded.world;
            let row = seen.map_or_else(|| series.last(), |time| series.at(time));
            // What lies before all that is plotted has no place there.
            let begin = series.last().map_or(0.0, |last| last[0] - SPAN);
            let mark = seen.filter(|time| *time >= begin);
            (entries(&charts, row), charts.iter().map(traces).collect::<Vec<_>>(), mark)
        });
        let ghost = shown.iter().any(|(_, _, traces)| traces.iter().any(|trace| trace.dashed));
        ui.horizontal_top(|ui| {
            let width = (ui.available_width() - LEGEND) / shown.len() as f32 - 2.0 * GRID;
            for (title, unit, traces) in shown {
                ui.vertical(|ui| {
                    ui.set_width(width.max(20.0 * GRID));
                    ui.label(RichText::new(format!("{title} [{unit}]")).small());
                    over_time(ui, title, PLOT - 4.0 * GRID, unit, traces, mark);
                });
            }
            ui.vertical(|ui| self.legend(ui, &entries, ghost));
        });
    }

    /// What the tab shows.
    fn charts(&self, series: &TimeSeries, tone: Tone) -> Vec<Chart> {
        let pictures = tone.pictures();
        let ink = theme::color(pictures.text);
        let hue = |k: usize| theme::color(pictures.fibre(k));
        // Kinds that follow each other are far apart in hue, and none of the first nine comes near another; a tenth
        // lies between two of them.
        let of_kind =
            |k: usize| theme::color(pictures.hue(FIRST_HUE + ((4 * k % 9) as f32 + 0.5 * (k / 9) as f32) / 9.0));
        match self.tab {
            Tab::Energies => {
                let all = Energies::NAMES.iter().enumerate();
                let by_kind: Vec<(usize, &str, Vec<usize>)> =
                    all.map(|(k, name)| (k, *name, columns(series, ColumnKind::Energy(k)))).collect();
                let total = by_kind.iter().flat_map(|(_, _, columns)| columns.iter().copied()).collect();
                let mut curves = vec![Curve::of("Total", ink, vec![total]).bold()];
                let used = by_kind.into_iter().filter(|(_, _, sum)| sum.iter().any(|&column| series.is_used(column)));
                curves.extend(used.map(|(k, name, sum)| Curve::of(spoken(name), of_kind(k), vec![sum])));
                vec![Chart { title: "Energy", unit: "J", curves }]
            }
            Tab::Momenta => {
                let chart = |title, unit, kind: fn(usize) -> ColumnKind| {
                    let axes = [0, 1, 2].map(|axis| columns(series, kind(axis)));
                    let mut curves = vec![Curve::of("Size", ink, axes.to_vec()).bold()];
                    let named = ["X", "Y", "Z"].into_iter().zip(pictures.axes).zip(axes);
                    curves.extend(named.map(|((name, colour), sum)| Curve::of(name, theme::color(colour), vec![sum])));
                    Chart { title, unit, curves }
                };
                vec![
                    chart("Linear momentum", "kg m/s", ColumnKind::LinearMomentum),
                    chart("Angular momentum about the origin", "kg m²/s", ColumnKind::AngularMomentum),
                ]
            }
            Tab::Measures(unit) => {
                let measures = series.columns().iter().enumerate();
                let these = measures.filter(|(_, column)| column.kind == ColumnKind::Measure && column.unit == unit);
                let curves = these.enumerate().map(|(k, (at, column))| Curve::of(&column.name, hue(k), vec![vec![at]]));
                vec![Chart { title: "Measures", unit, curves: curves.collect() }]
            }
        }
    }

    /// The lines of a plot, those of the ghost thin and dashed behind them.
    fn traces(&self, chart: &Chart, recorded: &TimeSeriesSet) -> Vec<Trace> {
        let shown = || chart.curves.iter().filter(|curve| !self.hidden.contains(&curve.name));
        // A ghost with other bodies or measures has other columns, of which these curves know nothing.
        let is_there = |ghost: &TimeSeries, curve: &Curve| {
            let mut columns = curve.sums.iter().flatten();
            columns.all(|&column| ghost.columns().get(column) == recorded.world.columns().get(column))
        };
        let ghosts = recorded.ghost.iter().flat_map(|ghost| {
            shown().filter(|curve| is_there(ghost, curve)).map(|curve| Trace {
                name: format!("{}, ghost", curve.name),
                width: THIN,
                dashed: true,
                ..curve.trace(ghost)
            })
        });
        ghosts.chain(shown().map(|curve| curve.trace(&recorded.world))).collect()
    }

    /// Names with their colours and present values; a click leaves a line out.
    fn legend(&mut self, ui: &mut Ui, entries: &[(String, Color32, String)], ghost: bool) {
        ui.set_width(LEGEND - 4.0 * GRID);
        ui.spacing_mut().item_spacing.y = 0.0;
        ScrollArea::vertical().max_height(PLOT).auto_shrink(false).show(ui, |ui| {
            for (name, colour, value) in entries {
                let hidden = self.hidden.contains(name);
                let size = Vec2::new(ui.available_width() - 2.0 * GRID, ROW);
                let (row, response) = ui.allocate_exact_size(size, Sense::click());
                response.widget_info(|| WidgetInfo::selected(Role::CheckBox, true, !hidden, format!("{name} {value}")));
                let visuals = ui.style().interact(&response);
                let ink = if hidden { visuals.text_color().gamma_multiply(0.4) } else { visuals.text_color() };
                let spot = if hidden { colour.gamma_multiply(0.25) } else { *colour };
                let painter = ui.painter_at(row);
                painter.circle_filled(row.left_center() + Vec2::new(2.0 * GRID, 0.0), GRID, spot);
                let name_at = row.left_center() + Vec2::new(5.0 * GRID, 0.0);
                painter.text(name_at, Align2::LEFT_CENTER, name, TextStyle::Small.resolve(ui.style()), ink);
                let font = TextStyle::Monospace.resolve(ui.style());
                painter.text(row.right_center(), Align2::RIGHT_CENTER, value, font, ink);
                let tooltip = if hidden { "Shows this line again" } else { "Leaves this line out" };
                if response.on_hover_text(tooltip).clicked() && !self.hidden.remove(name) {
                    self.hidden.insert(name.clone());
                }
            }
            if ghost {
                ui.label(RichText::new("Dashed: the ghost").small().weak());
            }
        });
    }
}

/// What the legend says: names, colours and, where each name stands once, the values of a row.
fn entries(charts: &[Chart], row: Option<&[f64]>) -> Vec<(String, Color32, String)> {
    let Some(chart) = charts.first() else { return Vec::new() };
    let row = row.filter(|_| charts.len() == 1);
    let value = |curve: &Curve| {
        row.map_or_else(String::new, |row| format!("{} {}", three_figures(curve.read(row)), chart.unit))
    };
    chart.curves.iter().map(|curve| (curve.name.clone(), curve.colour, value(curve))).collect()
}
