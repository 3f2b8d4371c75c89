//! `sinew sweep`: a scene once for every combination of some values.

use super::drive::{RunEnd, drive};
use super::error::printable;
use super::finite::NotFinite;
use super::interruption::{Interruption, Signal};
use super::parallel::in_parallel;
use super::prepare::{Loaded, Sets, Span, Threads, folder_of, load, notes, tell, with_frame_rate, with_sets, word};
use super::table::{Align, Table, readable};
use super::vary::{Product, Vary};
use super::{CliError, Console, Outcome, output};
use crate::bake::{Baked, Note, bake};
use crate::io::complete_assets;
use crate::scene::{Assets, Scene, one_line};
use crate::sim::{BodyReport, MeasureReport, Report, Runner};
use crate::text::number::four_figures;
use clap::Args;
use serde::Serialize;
use serde_json::{Map, Value};
use std::path::PathBuf;

/// Arguments of `sinew sweep`.
#[derive(Debug, Args)]
pub struct Sweep {
    /// Scene file, or a model: OBJ, STL, PLY, glTF or GLB
    scene: PathBuf,
    /// Values to try, as in /bodies/0/fibres/0/volume_fraction=0,0.25,0.5; several lists give every combination
    #[arg(long, value_name = "POINTER=a,b,c", required = true)]
    vary: Vec<Vary>,
    #[command(flatten)]
    span: Span,
    #[command(flatten)]
    sets: Sets,
    #[command(flatten)]
    threads: Threads,
    /// Write all rows as JSON
    #[arg(long, value_name = "FILE")]
    report: Option<PathBuf>,
}

/// What a sweep has shown.
#[derive(Debug, Serialize)]
struct SweepReport<'a> {
    scene: &'a str,
    vary: &'a [Vary],
    /// Whether every row was run to its end; those that were not are left out.
    complete: bool,
    rows: &'a [Row],
}

/// One combination of values and what it gave.
#[derive(Debug, Serialize)]
struct Row {
    values: Map<String, Value>,
    seconds: f64,
    at_rest: bool,
    /// Why the first body that was stopped was stopped.
    diverged: Option<String>,
    measures: Map<String, Value>,
    bodies: Vec<BodyReport>,
    wall_seconds: f64,
    /// Measures with their units, for the table.
    #[serde(skip)]
    readings: Vec<MeasureReport>,
    #[serde(skip)]
    end: RunEnd,
    /// Which of all combinations it is.
    #[serde(skip)]
    index: usize,
}

impl Row {
    /// Measures that are no finite numbers: null in the report.
    fn not_finite(&self) -> impl Iterator<Item = &String> {
        self.measures.iter().filter(|(_, value)| value.is_null()).map(|(name, _)| name)
    }
}

/// Runs every combination, writes the report and prints a table.
///
/// # Errors
/// A scene, a combination or an option that cannot be used, before anything runs; a report that cannot be written.
pub(super) fn run(args: &Sweep, interruption: &Interruption, console: &mut Console) -> Result<Outcome, CliError> {
    let loaded = load(Some(&args.scene), &args.sets, None, console)?;
    tell(loaded.made(), console);
    let Loaded { scene: base, mut assets, .. } = loaded;
    let product = Product::of(&args.vary)?;
    // A model that cannot be used is the rows' error: they may all have another.
    complete_assets(&mut assets, &base, folder_of(Some(&args.scene)), &mut |_| {}).ok();
    let plan = Plan { args, base: &base, assets: &assets, product };
    let threads = args.threads.count();
    let all = product.rows() as u64;

    console.begin();
    let checked =
        in_parallel(product.rows(), threads, |row| plan.check(row), |done| console.progress(done, all, "checked"));
    console.end();
    let checked = checked?;
    output::check(Some(&args.scene), &[("--report", args.report.as_ref())])?;

    // Before the first word: whoever reads one may count on the rest.
    interruption.wait_for_end();
    tell_all(&checked, console);
    console.begin();
    let run = |row| plan.run(row, interruption);
    let ran = in_parallel(product.rows(), threads, run, |done| console.progress(done, all, "rows"));
    console.end();
    let rows: Vec<Row> = ran?.into_iter().flatten().collect();
    let interrupted = interruption.signal().filter(|_| rows.len() < product.rows());
    for row in &rows {
        if let Some(message) = &row.diverged {
            console.error(&format!("{}: {message}", product.line(row.index)));
        }
        for what in row.not_finite() {
            console.error(&format!("{}: {}", product.line(row.index), NotFinite(what)));
        }
    }
    tell_interrupted(interrupted, &rows, product.rows(), console);
    warn_of_restless(args, &rows, console);
    let mut text = table(&product, &rows).render();
    if let Some(path) = &args.report {
        let scene = if base.name.is_empty() { &*printable(&args.scene) } else { &base.name };
        text.push('\n');
        text += &output::write_report(
            path,
            &SweepReport { scene, vary: &args.vary, complete: interrupted.is_none(), rows: &rows },
        )?;
    }
    console.print(&text)?;
    Ok(match interrupted {
        Some(signal) => Outcome::Interrupted(signal),
        None if rows.iter().any(|row| row.diverged.is_some() || row.not_finite().next().is_some()) => Outcome::Diverged,
        None => Outcome::Done,
    })
}

fn tell_interrupted(signal: Option<Signal>, rows: &[Row], all: usize, console: &mut Console) {
    if let Some(signal) = signal {
        let done = rows.len();
        console.say(
            "interrupted",
            &format!(
                "by {signal} when {done} of {all} rows had run to their end; those are given, marked as incomplete"
            ),
        );
    }
}

/// The combinations of a scene.
#[derive(Clone, Copy)]
struct Plan<'a> {
    args: &'a Sweep,
    base: &'a Scene,
    assets: &'a Assets,
    product: Product<'a>,
}

impl Plan<'_> {
    /// The scene of a row, put together.
    fn prepare(&self, row: usize) -> Result<(Scene, Baked), CliError> {
        let attempt = || {
            let scene = with_sets(self.base, &self.product.assignments(row))?;
            let scene = with_frame_rate(scene, self.args.span.fps)?;
            // The models of most rows are those of the scene as it is.
            let mut assets = self.assets.clone();
            complete_assets(&mut assets, &scene, folder_of(Some(&self.args.scene)), &mut |_| {})?;
            let source = printable(&self.args.scene);
            let baked = bake(&scene, &assets).map_err(|error| CliError::Bake { scene: source, source: error })?;
            Ok((scene, baked))
        };
        attempt().map_err(|error| CliError::Row { values: self.product.line(row), source: Box::new(error) })
    }

    /// What is worth saying about a row. Putting it together costs little beside running it, so it is done twice
    /// rather than kept.
    fn check(&self, row: usize) -> Result<Vec<Note>, CliError> {
        let (scene, baked) = self.prepare(row)?;
        Ok(notes(&scene, &baked))
    }

    /// What a row shows; none where it was interrupted.
    fn run(&self, row: usize, interruption: &Interruption) -> Result<Option<Row>, CliError> {
        if interruption.signal().is_some() {
            return Ok(None);
        }
        let (scene, baked) = self.prepare(row)?;
        let span = self.args.span;
        let mut runner = Runner::new(baked);
        let frames = runner.frames_for(span.limit(&scene));
        let ran = drive(&mut runner, frames, span.until_rest, interruption, &mut |_| Ok(()))?;
        if matches!(ran.end, RunEnd::Interrupted(_)) {
            return Ok(None);
        }
        let report = Report::new(&scene, &runner, ran.wall_seconds, Vec::new());
        let measures = report.measures.iter().map(|measure| (measure.name.clone(), measure.value.clone())).collect();
        Ok(Some(Row {
            values: self.product.object(row),
            seconds: report.seconds,
            at_rest: report.at_rest,
            diverged: runner.world().divergence().map(ToString::to_string),
            measures,
            bodies: report.bodies,
            wall_seconds: report.wall_seconds,
            readings: report.measures,
            end: ran.end,
            index: row,
        }))
    }
}

/// Says every note once, and in how many rows it holds where that is not all.
fn tell_all(rows: &[Vec<Note>], console: &mut Console) {
    let mut seen: Vec<(&Note, usize)> = Vec::new();
    for note in rows.iter().flatten() {
        match seen.iter_mut().find(|(other, _)| *other == note) {
            Some((_, count)) => *count += 1,
            None => seen.push((note, 1)),
        }
    }
    for (note, count) in seen {
        let all = rows.len();
        let share = if count < all { format!(" (in {count} of {all} rows)") } else { String::new() };
        console.say(word(note), &format!("{note}{share}"));
    }
}

fn warn_of_restless(args: &Sweep, rows: &[Row], console: &mut Console) {
    let restless = rows.iter().filter(|row| row.end == RunEnd::Time).count();
    if args.span.until_rest && restless > 0 {
        let all = rows.len();
        console.warn(&format!(
            "{restless} of {all} rows have not come to rest in their time; give more --seconds, or the material damping"
        ));
    }
}

/// One line a row: its values, then its measures.
fn table(product: &Product<'_>, rows: &[Row]) -> Table {
    let mut names: Vec<(&str, &str)> = Vec::new();
    for reading in rows.iter().flat_map(|row| &row.readings) {
        if !names.iter().any(|(name, _)| *name == reading.name) {
            names.push((&reading.name, reading.unit));
        }
    }
    let pointers = product.row(0).into_iter().map(|(pointer, _)| one_line(pointer));
    let measures = names.iter().map(|(name, unit)| one_line(&format!("{name} [{unit}]")));
    let ends = ["time [s]", "at rest", ""].map(str::to_owned);
    let mut table = Table::new(pointers.chain(measures).chain(ends).map(|name| (name, Align::Right)));
    for row in rows {
        let values = product.row(row.index).into_iter().map(|(_, value)| one_line(&value.to_string()));
        let measures = names.iter().map(|(name, _)| row.measures.get(*name).map_or("-".to_owned(), readable));
        let rest = if row.at_rest { "yes" } else { "no" }.to_owned();
        let diverged = if row.diverged.is_some() { "diverged" } else { "" }.to_owned();
        table.push(values.chain(measures).chain([four_figures(row.seconds), rest, diverged]));
    }
    table
}
