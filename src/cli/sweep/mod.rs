//! `sinew sweep`: a scene once for every combination of some values.

mod memory;
mod plot;
mod results;
mod vary;

use self::memory::Memory;
use self::plot::{Against, plot};
use self::results::{Plan as SweepPlan, Results, Row, measured, names_of, to_csv};
use self::vary::{Product, Samples, Vary};
use super::drive::{RunEnd, drive};
use super::error::printable;
use super::finite::NotFinite;
use super::interruption::{Interruption, Signal};
use super::output;
use super::parallel::in_parallel;
use super::prepare::{Loaded, Sets, Span, Threads, folder_of, load, notes, tell, with_frame_rate, with_sets, word};
use super::table::{Align, Table, readable};
use super::{CliError, Console, Outcome};
use crate::bake::{Baked, Note, bake};
use crate::io::{complete_assets, fingerprint, make_folder};
use crate::scene::{Assets, Scene, one_line};
use crate::sim::{Report, Runner, TimeSeries};
use crate::text::number::four_figures;
use clap::Args;
use serde_json::json;
use std::path::{Path, PathBuf};

/// Arguments of `sinew sweep`.
#[derive(Debug, Args)]
pub struct Sweep {
    /// Scene file, or a model: OBJ, STL, PLY, glTF or GLB
    scene: PathBuf,
    /// Values to try, as in /bodies/0/fibres/0/volume_fraction=0,0.25,0.5; several lists give every combination. Also
    /// 0.1..0.9/9 (nine values), 1e4..1e7/4/log (four, equal factors apart), 0.1..0.9/random (see --samples); /a,/b=1,2
    /// changes two values together
    #[arg(long, value_name = "POINTER=a,b,c", required = true)]
    vary: Vec<Vary>,
    /// How many rows to draw of every combination, where something is `random`
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=100_000))]
    samples: Option<u32>,
    /// What the draws follow from: the same number draws the same rows
    #[arg(long, value_name = "N", default_value_t = 0)]
    seed: u64,
    #[command(flatten)]
    span: Span,
    #[command(flatten)]
    sets: Sets,
    #[command(flatten)]
    threads: Threads,
    /// Memory that rows which run side by side may take [MiB]; most of what is free unless given
    #[arg(long, value_name = "MIB", value_parser = clap::value_parser!(u32).range(1..))]
    memory: Option<u32>,
    /// Write all rows as JSON, those that are done while others run too
    #[arg(long, value_name = "FILE")]
    report: Option<PathBuf>,
    /// Go on with the rows that the report of an interrupted sweep lacks
    #[arg(long, requires = "report")]
    resume: bool,
    /// Write all rows as CSV
    #[arg(long, value_name = "FILE.csv")]
    csv: Option<PathBuf>,
    /// Write energies, momenta and measures of every frame of each row as CSV into this folder
    #[arg(long, value_name = "DIR")]
    series: Option<PathBuf>,
    /// Draw a measure over what is varied, as SVG
    #[arg(long, value_name = "FILE.svg")]
    plot: Option<PathBuf>,
    /// What the plot is drawn over; the first that is varied unless given
    #[arg(long, value_name = "POINTER", requires = "plot")]
    plot_x: Option<String>,
    /// The measure that is drawn; the first unless given
    #[arg(long, value_name = "MEASURE", requires = "plot")]
    plot_y: Option<String>,
}

impl Sweep {
    /// What its plot shows of a scene.
    fn against(&self, scene: &Scene) -> Result<Against, CliError> {
        Against::of(&self.vary, self.plot_x.as_ref(), self.plot_y.as_ref(), scene)
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
    let samples = args.samples.map(|count| Samples { count, seed: args.seed });
    let product = Product::of(&args.vary, samples)?;
    let against = args.plot.as_ref().map(|_| args.against(&base)).transpose()?;
    // A model that cannot be used is the rows' error: they may all have another.
    complete_assets(&mut assets, &base, folder_of(Some(&args.scene)), &mut |_| {}).ok();
    let plan = Plan { args, base: &base, assets: &assets, product };
    let threads = args.threads.count();
    let all = product.rows() as u64;

    let memory = Memory::new(args.memory);
    let first = if product.rows() > 1 && threads > 1 { plan.check(0)?.bytes } else { 0 };
    // Nothing is said of this: rows that run take longer, and it is said of them.
    let abreast = memory.abreast(threads, first, None);
    console.begin();
    let checked = in_parallel(
        product.rows(),
        (threads, abreast),
        |row| plan.check(row),
        |done, _| {
            console.progress(done, all, "checked");
            Ok(())
        },
    );
    console.end();
    let checked = checked?;
    let targets = [("--report", &args.report), ("--csv", &args.csv), ("--plot", &args.plot)];
    output::check(&output::inputs(Some(&args.scene), &base), &targets.map(|(option, path)| (option, path.as_ref())))?;
    let series = args.series.as_deref().map(SeriesFolder::create).transpose()?;

    let scene = if base.name.is_empty() { &*printable(&args.scene) } else { &base.name };
    let Span { seconds, fps, until_rest } = args.span;
    let of = json!({"scene": fingerprint(&base, folder_of(Some(&args.scene))), "seconds": seconds, "fps": fps, "until_rest": until_rest});
    let mut results =
        Results::new(SweepPlan { scene, vary: &args.vary, samples, of }, args.report.as_deref(), product.rows());
    let kept = if args.resume { results.resume(&product, &base.measures)? } else { 0 };
    let missing = results.missing();

    // Before the first word: whoever reads one may count on the rest.
    interruption.wait_for_end();
    tell_all(&checked, console);
    let largest = checked.iter().map(|row| row.bytes).max().unwrap_or_default();
    let abreast = memory.abreast(threads.min(missing.len()), largest, Some(console));
    if kept > 0 {
        console.say("resumed", &format!("{kept} of {all} rows are in the report already and are kept"));
    }
    console.begin();
    let run = |k: usize| plan.run(missing[k], series.as_ref(), interruption);
    let ran = in_parallel(missing.len(), (threads, abreast), run, |done, row: Option<&Option<Row>>| {
        console.progress(kept as u64 + done, all, "rows");
        row.and_then(Option::as_ref).map_or(Ok(()), |row| results.push(row.clone()))
    });
    console.end();
    ran?;
    let rows: Vec<Row> = results.rows().cloned().collect();
    let interrupted = interruption.signal().filter(|_| rows.len() < product.rows());
    for row in &rows {
        for message in &row.unbalanced {
            console.warn(&format!("{}: {message}", product.line(row.index)));
        }
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
    if args.report.is_some() {
        text.push('\n');
        text += &results.write()?;
    }
    if let Some(path) = &args.csv {
        output::write_bytes(path, &to_csv(&product, &rows)?)?;
        text += &output::wrote("rows", path);
    }
    if let (Some(path), Some(against)) = (&args.plot, &against) {
        output::write_bytes(path, plot(scene, against, &rows).as_bytes())?;
        text += &output::wrote("plot", path);
    }
    if let Some(series) = &series {
        text += &output::wrote(&format!("{} series", rows.len() - kept), &series.0);
    }
    console.print(&text)?;
    Ok(match interrupted {
        Some(signal) => Outcome::Interrupted(signal),
        None if rows.iter().any(|row| row.diverged.is_some() || row.not_finite().next().is_some()) => Outcome::Diverged,
        None => Outcome::Done,
    })
}

/// A folder for a series of each row.
struct SeriesFolder(PathBuf);

impl SeriesFolder {
    fn create(path: &Path) -> Result<Self, CliError> {
        make_folder(path)?;
        Ok(Self(path.to_owned()))
    }

    /// Writes the series of a row.
    fn write(&self, row: usize, series: &TimeSeries) -> Result<(), CliError> {
        output::write_bytes(&self.0.join(format!("row_{row:05}.csv")), &series.to_csv()?)
    }
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
            self.args.sets.refuse_outside(&scene, Some(&self.args.scene))?;
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

    /// What is worth saying about a row, and what it takes. Putting it together costs little beside running it, so it
    /// is done twice rather than kept.
    fn check(&self, row: usize) -> Result<Checked, CliError> {
        let (scene, baked) = self.prepare(row)?;
        Ok(Checked { notes: notes(&scene, &baked), bytes: baked.world.bytes() })
    }

    /// What a row shows; none where it was interrupted.
    fn run(
        &self,
        row: usize,
        folder: Option<&SeriesFolder>,
        interruption: &Interruption,
    ) -> Result<Option<Row>, CliError> {
        if interruption.signal().is_some() {
            return Ok(None);
        }
        let (scene, baked) = self.prepare(row)?;
        let span = self.args.span;
        let mut runner = Runner::new(baked);
        let frames = runner.frames_for(span.limit(&scene));
        let mut series = folder.map(|_| TimeSeries::new(runner.world(), usize::MAX));
        let ran = drive(&mut runner, frames, span.until_rest, interruption, &mut |runner| {
            if let Some(series) = &mut series {
                series.push(runner.world());
            }
            Ok(())
        })?;
        if matches!(ran.end, RunEnd::Interrupted(_)) {
            return Ok(None);
        }
        let report = Report::new(&scene, &runner, ran.wall_seconds, Vec::new());
        if let (Some(folder), Some(series)) = (folder, &series) {
            folder.write(row, series)?;
        }
        let (measures, units) = measured(report.measures);
        Ok(Some(Row {
            values: self.product.object(row),
            seconds: report.seconds,
            at_rest: report.at_rest,
            diverged: runner.world().divergence().map(ToString::to_string),
            unbalanced: report.unbalanced,
            measures,
            bodies: json!(report.bodies),
            wall_seconds: report.wall_seconds,
            units,
            index: row,
        }))
    }
}

/// What was seen of a row before it is run.
struct Checked {
    notes: Vec<Note>,
    /// Memory that its world takes [bytes].
    bytes: usize,
}

/// Says every note once, and in how many rows it holds where that is not all.
fn tell_all(rows: &[Checked], console: &mut Console) {
    let mut seen: Vec<(&Note, usize)> = Vec::new();
    for note in rows.iter().flat_map(|row| &row.notes) {
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
    let restless = rows.iter().filter(|row| row.is_restless()).count();
    if args.span.until_rest && restless > 0 {
        let all = rows.len();
        console.warn(&format!(
            "{restless} of {all} rows have not come to rest in their time; give more --seconds, or the material damping"
        ));
    }
}

/// One line a row: its values, then its measures.
fn table(product: &Product<'_>, rows: &[Row]) -> Table {
    let names = names_of(rows);
    let pointers = product.row(0).into_iter().map(|(list, _)| one_line(&list.pointer));
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
