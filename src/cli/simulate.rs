//! `sinew simulate`: one run of a scene, and what it shows.

use super::drive::{Drive, FailedRun, RunEnd, drive, warn_unbalanced};
use super::finite::NotFinite;
use super::interruption::Interruption;
use super::motion::{MotionOptions, told};
use super::output;
use super::picture::Look;
use super::prepare::{
    Loaded, Sets, Span, Threads, bake_with_notes, folder_of, frames_to, load, source_name, tell, word,
};
use super::repeat::{Repeated, Run, RunReport};
use super::summary::summary;
use super::{CliError, Console, Outcome};
use crate::io::fingerprint;
use crate::scene::{Assets, Scene};
use crate::sim::{Report, Runner, TimeSeries};
use crate::solver::world::World;
use crate::text::number::four_figures;
use crate::transfer::{Inputs, Order, RunFiles};
use clap::Args;
use std::path::PathBuf;

/// Arguments of `sinew simulate`.
#[derive(Clone, Debug, Default, Args)]
pub struct Simulate {
    /// Scene file, or a model: OBJ, STL, PLY, glTF or GLB; the built-in scene unless given
    scene: Option<PathBuf>,
    #[command(flatten)]
    span: Span,
    #[command(flatten)]
    sets: Sets,
    #[command(flatten)]
    threads: Threads,
    /// Make the run of a report again, from its scene with all that was set, and say whether it came to the same bits
    #[arg(long, value_name = "REPORT", conflicts_with_all = ["sets", "seconds", "fps", "until_rest"])]
    from: Option<PathBuf>,
    /// Write a report as JSON
    #[arg(long, value_name = "FILE")]
    report: Option<PathBuf>,
    /// Write energies, momenta and measures of every frame as CSV
    #[arg(long, value_name = "FILE.csv")]
    series: Option<PathBuf>,
    /// Write the shapes of every frame to this folder, each on the vertices of the file that it is from
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    #[command(flatten)]
    motion: MotionOptions,
    /// Write a picture of every frame as a PNG file in this folder
    #[arg(long, value_name = "DIR")]
    png: Option<PathBuf>,
    #[command(flatten)]
    look: Look,
}

#[cfg(not(feature = "gui"))]
impl Simulate {
    /// Runs a scene, the built-in one unless given, with nothing else asked for.
    pub(super) fn of(scene: Option<PathBuf>) -> Self {
        Self { scene, ..Self::default() }
    }
}

/// Runs the scene, writes the files that were asked for and prints a summary.
///
/// # Errors
/// A scene or an option that cannot be used, before any file is made; a file that cannot be written.
pub(super) fn run(args: &Simulate, interruption: &Interruption, console: &mut Console) -> Result<Outcome, CliError> {
    args.threads.run(|| simulate(args, interruption, console))
}

fn simulate(args: &Simulate, interruption: &Interruption, console: &mut Console) -> Result<Outcome, CliError> {
    if args.png.is_none() && !args.motion.wants_pictures() && args.look != Look::default() {
        return Err(CliError::NoPicturesAsked);
    }
    let repeated = args.from.as_deref().map(Repeated::read).transpose()?;
    let args = &match &repeated {
        Some(repeated) => {
            let (scene, sets, span) = repeated.arguments()?;
            Simulate {
                scene: args.scene.clone().or(scene),
                sets: Sets { sets, ..args.sets.clone() },
                span,
                ..args.clone()
            }
        }
        None => args.clone(),
    };
    args.motion.check(args.out.is_some(), args.png.is_some())?;
    let source = source_name(args.scene.as_deref());
    let mut loaded = load(args.scene.as_ref(), &args.sets, args.span.fps, console)?;
    let baked = bake_with_notes(&mut loaded, args.scene.as_deref(), console)?;
    let notes = loaded.notes(&baked);
    let Loaded { scene, assets, .. } = loaded;
    tell(&notes, console);
    // Now, since files may change while it runs.
    let scene_hash = fingerprint(&scene, folder_of(args.scene.as_deref()));
    let inputs = output::inputs(args.scene.as_deref(), &scene);
    output::check(&inputs, &[("--report", args.report.as_ref()), ("--series", args.series.as_ref())])?;

    let mut runner = Runner::new(baked);
    let most = runner.frames_for(args.span.limit(&scene));
    let last = args.motion.last_frame(most, args.span.seconds)?;
    let mut outputs = FrameOutputs::new(args, (&scene, &assets), &inputs, &runner, last)?;
    interruption.wait_for_end();
    // What was computed until a frame could not be written is told, and written as far as it can be.
    let (wall_seconds, end, failed) =
        match watch(args, (&scene, last), &mut runner, interruption, &mut outputs, console) {
            Ok(ran) => (ran.wall_seconds, Some(ran.end), None),
            Err(FailedRun { wall_seconds, error }) => (wall_seconds, None, Some(*error)),
        };
    let lines = notes.iter().map(|note| format!("{}: {note}", word(note))).collect();
    let mut report = Report::new(&scene, &runner, wall_seconds, lines);
    report.complete = !matches!(end, None | Some(RunEnd::Interrupted(_)));
    let mut text = summary(&report, runner.world(), &source);
    let finite = outputs.is_finite(&report, console);
    let run = Run::new(scene_hash.clone(), args.scene.as_ref(), &args.sets.sets, args.span.fps);
    let whole = RunReport { report: &report, run };
    let (written, unwritten) = outputs.finish(args, finite.then_some(&whole), console);
    if !written.is_empty() {
        text.push('\n');
        text.push_str(&written);
    }
    if !finite && (args.report.is_some() || args.series.is_some()) {
        console.warn(&"report and series are not written: they would hold what is no number");
    }
    console.print(&text)?;
    let mut errors = failed.into_iter().chain(unwritten);
    if let Some(first) = errors.next() {
        errors.for_each(|error| console.error(&error));
        return Err(first);
    }
    let differs = repeated.is_some_and(|repeated| !repeated.compare(&scene_hash, &report, console));
    Ok(match end {
        Some(RunEnd::Interrupted(signal)) => Outcome::Interrupted(signal),
        _ if differs => Outcome::Differs,
        _ if runner.world().divergence().is_some() || !finite => Outcome::Diverged,
        _ => Outcome::Done,
    })
}

/// Runs to frame `last` at most; every frame is recorded, every divergence said when it happens.
fn watch(
    args: &Simulate,
    (scene, last): (&Scene, u64),
    runner: &mut Runner,
    interruption: &Interruption,
    outputs: &mut FrameOutputs,
    console: &mut Console,
) -> Result<Drive, FailedRun> {
    let limit = args.span.limit(scene);
    let frames = frames_to(limit, runner, console).min(last);
    let pieces = if args.span.until_rest { "frames at most" } else { "frames" };
    let mut stopped = vec![false; runner.world().bodies().len()];
    let mut told = Vec::new();
    let mut tell = |world: &World, console: &mut Console| {
        warn_unbalanced(world, &mut told, console);
        for (body, stopped) in world.bodies().iter().zip(&mut stopped) {
            if let (Some(divergence), false) = (body.divergence(), *stopped) {
                console.error(divergence);
                *stopped = true;
            }
        }
    };
    console.begin();
    let ran = drive(runner, frames, args.span.until_rest, interruption, &mut |runner| {
        tell(runner.world(), console);
        console.progress(runner.world().frame(), frames, pieces);
        outputs.push(scene, runner)
    });
    console.end();
    tell(runner.world(), console);
    let ran = ran?;
    if args.span.until_rest && ran.end == RunEnd::Time {
        let limit = four_figures(limit);
        console.warn(&format!(
            "not everything has come to rest after {limit} s; give more --seconds, or the material damping"
        ));
    }
    if let RunEnd::Interrupted(signal) = ran.end {
        let [done, all] = [runner.world().time(), limit].map(four_figures);
        console.say(
            "interrupted",
            &format!("by {signal} at {done} s of {all} s; the results until then are given, marked as incomplete"),
        );
    }
    Ok(ran)
}

/// What is kept of every frame.
struct FrameOutputs {
    series: Option<TimeSeries>,
    files: RunFiles,
}

impl FrameOutputs {
    fn new(
        args: &Simulate,
        of: (&Scene, &Assets),
        inputs: &Inputs,
        runner: &Runner,
        last: u64,
    ) -> Result<Self, CliError> {
        let series = args.series.as_ref().map(|_| TimeSeries::new(runner.world(), usize::MAX));
        let order = Order {
            formats: &args.motion.formats(),
            folder: args.out.as_deref(),
            stills: args.png.as_deref(),
            frames: args.motion.choice(last),
            space: args.motion.space(),
            look: &args.look.asked(),
            target: "--out",
        };
        Ok(Self { series, files: RunFiles::create(&order, of, inputs, runner)? })
    }

    fn push(&mut self, scene: &Scene, runner: &Runner) -> Result<(), CliError> {
        if let Some(series) = &mut self.series {
            series.push(runner.world());
        }
        Ok(self.files.push(scene, runner)?)
    }

    /// Whether all that was collected is made of numbers; what is not is said.
    fn is_finite(&self, report: &Report, console: &mut Console) -> bool {
        let series = self.series.as_ref().and_then(TimeSeries::not_finite);
        let series = series.map(|(time, column)| format!("{column} at {} s in the series", four_figures(time)));
        let found = report.not_finite().into_iter().chain(series);
        let found: Vec<String> = found.collect();
        for what in &found {
            console.error(&NotFinite(what));
        }
        found.is_empty()
    }

    /// Writes what was collected, the report and the series where they are made of numbers; gives a line about each
    /// file, and why others could not be written.
    fn finish(
        mut self,
        args: &Simulate,
        report: Option<&RunReport<'_>>,
        console: &mut Console,
    ) -> (String, Vec<CliError>) {
        let mut errors = Vec::new();
        errors.extend(self.files.keep().err().map(CliError::from));
        let report_line = args.report.as_ref().zip(report).map(|(path, report)| output::write_report(path, report));
        let series_line = args.series.as_ref().zip(self.series).filter(|_| report.is_some()).map(|(path, series)| {
            output::write_bytes(path, &series.to_csv()?)?;
            Ok(output::wrote("series", path))
        });
        let mut text = String::new();
        for line in report_line.into_iter().chain(series_line) {
            match line {
                Ok(line) => text += &line,
                Err(error) => errors.push(error),
            }
        }
        text += &told(&self.files.written(), console);
        (text, errors)
    }
}
