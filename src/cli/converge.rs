//! `sinew converge`: a body of fixed size, filled more and more finely, and what its measures come to.

use super::drive::{RunEnd, drive, warn_unbalanced};
use super::error::printable;
use super::interruption::Interruption;
use super::output;
use super::prepare::{Sets, Span, Threads, bake_with_notes, load, load_models, tell};
use super::svg::{Canvas, Scale};
use super::table::{Align, Table};
use super::{CliError, Console, Outcome};
use crate::edit::body_ops::of_any_filling;
use crate::scene::{Assets, Body, MeshShape, Scene, Shape, one_line};
use crate::sim::{MeasureReport, Report, Runner};
use crate::text::number::four_figures;
use clap::Args;
use serde::Serialize;
use serde_json::Value;
use std::path::PathBuf;

/// Arguments of `sinew converge`.
#[derive(Debug, Args)]
pub struct Converge {
    /// Scene file
    scene: PathBuf,
    /// Layers of particles through the body where it is thinnest, of a mesh through its least extent, one run each. Of
    /// boxes they are what fills it; the lattice of another shape is fitted to that, and its spacing differs by up to a
    /// fifth
    #[arg(long, value_name = "a,b,c", value_delimiter = ',', default_value = "3,5,7,9", value_parser = clap::value_parser!(u32).range(2..=100))]
    layers: Vec<u32>,
    /// Identifier of the fibre solid; the first one unless given
    #[arg(long, value_name = "ID")]
    body: Option<String>,
    #[command(flatten)]
    span: Span,
    #[command(flatten)]
    sets: Sets,
    #[command(flatten)]
    threads: Threads,
    /// Write all runs as JSON
    #[arg(long, value_name = "FILE")]
    report: Option<PathBuf>,
    /// Draw the measures over the spacing, each over its finest value, as SVG
    #[arg(long, value_name = "FILE.svg")]
    plot: Option<PathBuf>,
}

/// What a study of the resolution has shown.
#[derive(Debug, Serialize)]
struct Study {
    scene: String,
    body: String,
    /// Whether every run was made to its end; those that were not are left out.
    complete: bool,
    runs: Vec<Run>,
    limits: Vec<Limit>,
}

/// A run at one resolution.
#[derive(Debug, Serialize)]
struct Run {
    layers: u32,
    /// Spacing of the particles that was asked for [m].
    spacing: f64,
    particles: usize,
    at_rest: bool,
    /// Values of the measures, of vectors their lengths, in the order of `limits`.
    values: Vec<f64>,
}

/// Where a measure goes as the spacing D goes to zero: `value + c D^order` through all runs.
#[derive(Debug, Serialize)]
struct Limit {
    measure: String,
    unit: String,
    /// Observed order; null where the runs show none, as they do with fewer than three.
    order: Option<f64>,
    /// Extrapolated value; null without an order.
    value: Option<f64>,
}

/// Runs every resolution, writes what was asked for and prints a table.
///
/// # Errors
/// A scene, a body or an option that cannot be used; a file that cannot be written.
pub(super) fn run(args: &Converge, interruption: &Interruption, console: &mut Console) -> Result<Outcome, CliError> {
    args.threads.run(|| converge(args, interruption, console))
}

fn converge(args: &Converge, interruption: &Interruption, console: &mut Console) -> Result<Outcome, CliError> {
    let mut loaded = load(Some(&args.scene), &args.sets, args.span.fps, console)?;
    tell(loaded.made(), console);
    let mut base = loaded.scene.clone();
    let index = chosen(args, &base)?;
    load_models(&mut loaded, Some(&args.scene), console)?;
    let thickness = thickness(&base.bodies[index].shape, &loaded.assets);
    let as_it_is = bake_with_notes(&mut loaded, Some(&args.scene), console)?;
    let volume = as_it_is.world.bodies()[index].particle_volume();
    base.bodies[index] = of_any_filling(&base.bodies[index], volume.expect("it is a fibre solid"));
    let inputs = output::inputs(Some(&args.scene), &base);
    output::check(&inputs, &[("--report", args.report.as_ref()), ("--plot", args.plot.as_ref())])?;
    if base.measures.is_empty() {
        return Err(CliError::NothingMeasured { scene: printable(&args.scene) });
    }
    let mut layers = args.layers.clone();
    layers.sort_unstable();
    layers.dedup();
    interruption.wait_for_end();
    let mut study = Study {
        scene: if base.name.is_empty() { printable(&args.scene) } else { base.name.clone() },
        body: base.bodies[index].id.clone(),
        complete: true,
        runs: Vec::new(),
        limits: Vec::new(),
    };
    let (mut diverged, mut interrupted) = (false, None);
    for (done, &layers) in layers.iter().enumerate() {
        console.progress(done as u64, args.layers.len() as u64, "runs");
        loaded.scene = refined(&base, index, thickness / f64::from(layers));
        let spacing = loaded.scene.bodies[index].material.spacing();
        let baked = bake_with_notes(&mut loaded, Some(&args.scene), console)?;
        let mut runner = Runner::new(baked);
        let frames = runner.frames_for(args.span.limit(&loaded.scene));
        console.begin();
        let ran = drive(&mut runner, frames, args.span.until_rest, interruption, &mut |_| Ok(()))?;
        console.end();
        if let RunEnd::Interrupted(signal) = ran.end {
            (study.complete, interrupted) = (false, Some(signal));
            break;
        }
        warn_unbalanced(runner.world(), &mut Vec::new(), console);
        if let Some(divergence) = runner.world().divergence() {
            console.error(&format!("{layers} layers: {divergence}"));
            diverged = true;
            continue;
        }
        let report = Report::new(&loaded.scene, &runner, ran.wall_seconds, Vec::new());
        study.push(layers, spacing, &report, index);
    }
    study.extrapolate();
    let mut text = study.table();
    if let Some(path) = &args.report {
        text.push('\n');
        text += &output::write_report(path, &study)?;
    }
    if let Some(path) = &args.plot {
        output::write_bytes(path, study.plot().as_bytes())?;
        text += &output::wrote("plot", path);
    }
    console.print(&text)?;
    Ok(match interrupted {
        Some(signal) => Outcome::Interrupted(signal),
        None if diverged => Outcome::Diverged,
        None => Outcome::Done,
    })
}

/// The body that is refined.
fn chosen(args: &Converge, scene: &Scene) -> Result<usize, CliError> {
    let wanted = |body: &Body| args.body.as_ref().is_none_or(|id| *id == body.id);
    scene.bodies.iter().position(wanted).ok_or_else(|| CliError::NotRefined {
        given: args.body.clone().unwrap_or_default(),
        known: scene.bodies.iter().map(|body| &*body.id).collect::<Vec<_>>().join(", "),
    })
}

/// Thickness [m] of a shape where it is thinnest, of a mesh its least extent.
fn thickness(shape: &Shape, assets: &Assets) -> f64 {
    let of_mesh = |mesh: &MeshShape| assets.solid(mesh).map(|solid| solid.size().min_element());
    let found = if let Shape::Mesh(mesh) = shape { of_mesh(mesh) } else { shape.thickness() };
    found.expect("models are loaded, and other shapes have one")
}

/// The scene with a body at another spacing [m] of its particles, of which nothing is said particle by particle: it
/// stays as large, as heavy and as stiff as it is.
fn refined(scene: &Scene, index: usize, spacing: f64) -> Scene {
    let mut scene = scene.clone();
    let Body { material, shape, .. } = &mut scene.bodies[index];
    if let Shape::Mesh(mesh) = shape {
        // A count would set the spacing.
        mesh.particles = None;
    }
    material.support_radius = spacing / material.spacing_ratio;
    scene
}

impl Study {
    fn push(&mut self, layers: u32, spacing: f64, report: &Report, body: usize) {
        if self.limits.is_empty() {
            let of = |measure: &MeasureReport| Limit {
                measure: measure.name.clone(),
                unit: measure.unit.to_owned(),
                order: None,
                value: None,
            };
            self.limits = report.measures.iter().map(of).collect();
        }
        let length = |value: &Value| match value.as_array() {
            Some(parts) => parts.iter().filter_map(Value::as_f64).map(|x| x * x).sum::<f64>().sqrt(),
            None => value.as_f64().unwrap_or(f64::NAN),
        };
        self.runs.push(Run {
            layers,
            spacing,
            particles: report.bodies[body].particles,
            at_rest: report.at_rest,
            values: report.measures.iter().map(|measure| length(&measure.value)).collect(),
        });
    }

    fn extrapolate(&mut self) {
        for (k, limit) in self.limits.iter_mut().enumerate() {
            let points: Vec<(f64, f64)> = self.runs.iter().map(|run| (run.spacing, run.values[k])).collect();
            (limit.order, limit.value) = extrapolated(&points).unzip();
        }
    }

    fn table(&self) -> String {
        let names = self.limits.iter().map(|limit| one_line(&format!("{} [{}]", limit.measure, limit.unit)));
        let head = ["layers", "spacing [m]", "particles", "at rest"].map(str::to_owned).into_iter().chain(names);
        let mut table = Table::new(head.map(|name| (name, Align::Right)));
        for run in &self.runs {
            let rest = if run.at_rest { "yes" } else { "no" }.to_owned();
            let own = [run.layers.to_string(), four_figures(run.spacing), run.particles.to_string(), rest];
            table.push(own.into_iter().chain(run.values.iter().map(|value| four_figures(*value))));
        }
        let or_dash = |value: Option<f64>| value.map_or_else(|| "-".to_owned(), four_figures);
        let row = |name: &str, of: &dyn Fn(&Limit) -> Option<f64>| {
            let own = [name.to_owned(), String::new(), String::new(), String::new()];
            own.into_iter().chain(self.limits.iter().map(|limit| or_dash(of(limit)))).collect::<Vec<_>>()
        };
        table.push(row("extrapolated", &|limit| limit.value));
        table.push(row("order", &|limit| limit.order));
        table.render()
    }

    fn plot(&self) -> String {
        let share = |k: usize| {
            let over = self.limits[k].value.or_else(|| self.runs.last().map(|run| run.values[k])).unwrap_or(1.0);
            self.runs.iter().map(|run| (run.spacing, run.values[k] / over)).collect::<Vec<_>>()
        };
        let lines: Vec<Vec<(f64, f64)>> = (0..self.limits.len()).map(share).collect();
        let points = || lines.iter().flatten();
        let zero = std::iter::once(0.0);
        let scales = [
            Scale::linear(points().map(|point| point.0).chain(zero)),
            Scale::linear(points().map(|point| point.1).filter(|share| share.is_finite()).chain([1.0])),
        ];
        let names = ["spacing [m]", "over the extrapolated value"];
        let mut canvas = Canvas::new(&one_line(&self.scene), names, scales);
        for (index, (line, limit)) in lines.iter().zip(&self.limits).enumerate() {
            canvas.line(index, &one_line(&limit.measure), line);
        }
        canvas.finish()
    }
}

/// The order p and the value a of `a + c D^p` that come nearest to values at some spacings D, by least squares over a
/// fine net of orders. None with fewer than three, or where none of the orders does better than those beside it.
fn extrapolated(points: &[(f64, f64)]) -> Option<(f64, f64)> {
    const ORDERS: std::ops::RangeInclusive<u32> = 20..=500;
    if points.len() < 3 || points.iter().any(|(_, value)| !value.is_finite()) {
        return None;
    }
    let longest = points.iter().map(|point| point.0).fold(0.0, f64::max);
    let fit = |order: f64| {
        let n = points.len() as f64;
        let x = |spacing: f64| (spacing / longest).powf(order);
        let mean_x = points.iter().map(|&(spacing, _)| x(spacing)).sum::<f64>() / n;
        let mean_y = points.iter().map(|point| point.1).sum::<f64>() / n;
        let (mut xx, mut xy) = (0.0, 0.0);
        for &(spacing, y) in points {
            xx += (x(spacing) - mean_x).powi(2);
            xy += (x(spacing) - mean_x) * (y - mean_y);
        }
        let slope = xy / xx;
        let value = mean_y - slope * mean_x;
        let error: f64 = points.iter().map(|&(spacing, y)| (value + slope * x(spacing) - y).powi(2)).sum();
        (error, value)
    };
    let tried = ORDERS.map(|hundredths| f64::from(hundredths) / 100.0).map(|order| (order, fit(order)));
    let (order, (_, value)) = tried.min_by(|a, b| a.1.0.total_cmp(&b.1.0))?;
    let at_end = [*ORDERS.start(), *ORDERS.end()].map(|hundredths| f64::from(hundredths) / 100.0).contains(&order);
    (!at_end).then_some((order, value))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_known_order_and_limit_are_found() {
        let values =
            |order: f64| [3.0, 5.0, 7.0, 9.0].map(|layers: f64| (1.0 / layers, 2.0 - 0.7 * layers.powf(-order)));
        for order in [1.0, 1.65, 2.0] {
            let (found, value) = extrapolated(&values(order)).expect("an order");
            assert!((found - order).abs() < 0.011 && (value - 2.0).abs() < 1e-3, "{order}: {found}, {value}");
        }
        assert_eq!(extrapolated(&values(1.0)[..2]), None);
        assert_eq!(extrapolated(&[(0.1, 1.0), (0.2, f64::NAN), (0.3, 2.0)]), None);
    }
}
