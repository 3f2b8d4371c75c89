//! `sinew compare`: a scene under several integrators, each with several steps.

use super::error::printable;
use super::interruption::Interruption;
use super::order_plot::{PlotLine, order_plot};
use super::output;
use super::prepare::{Loaded, Sets, Threads, bake_with_notes, load, tell};
use super::table::{Align, Table};
use super::{CliError, Console, Outcome};
use crate::scene::IntegratorKind;
use crate::sim::{Convergence, Study, Trial};
use crate::text::number::four_figures;
use clap::Args;
use serde::Serialize;
use std::f64::consts::TAU;
use std::path::PathBuf;
use std::time::Instant;

/// Arguments of `sinew compare`.
#[derive(Debug, Args)]
pub struct Compare {
    /// Scene file, or a model: OBJ, STL, PLY, glTF or GLB
    scene: PathBuf,
    #[arg(long, help = format!("Integrators to compare: {}", words()), value_name = "a,b,c", value_delimiter = ',', default_value = "euler,midpoint,rk4", value_parser = integrator)]
    integrators: Vec<IntegratorKind>,
    /// Steps [s]; each run takes exactly this step
    #[arg(long, value_name = "a,b,c", value_delimiter = ',', default_value = "0.003,0.03,0.3", value_parser = step, allow_negative_numbers = true)]
    dt: Vec<f64>,
    /// Simulated time of each run [s]; the scene's duration unless given
    #[arg(long, value_name = "S", value_parser = step, allow_negative_numbers = true)]
    seconds: Option<f64>,
    /// Fit the order of convergence of each integrator
    #[arg(long)]
    order: bool,
    /// Draw the errors over the steps, log-log, as SVG; fits the orders too
    #[arg(long, value_name = "FILE.svg")]
    plot: Option<PathBuf>,
    #[command(flatten)]
    sets: Sets,
    #[command(flatten)]
    threads: Threads,
    /// Write all runs as JSON
    #[arg(long, value_name = "FILE")]
    report: Option<PathBuf>,
}

/// What a comparison has shown.
#[derive(Debug, Serialize)]
struct CompareReport {
    scene: String,
    /// Simulated time that was asked for [s].
    seconds: f64,
    /// Whether every run was made to its end; those that were not are left out.
    complete: bool,
    /// Slowest swing of the first body [Hz], if something holds it.
    #[serde(skip_serializing_if = "Option::is_none")]
    first_mode: Option<f64>,
    runs: Vec<Run>,
    /// One for each integrator, if asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    orders: Option<Vec<Order>>,
}

/// One integrator with one step.
#[derive(Debug, Serialize)]
struct Run {
    integrator: IntegratorKind,
    /// Step [s].
    dt: f64,
    /// Greatest step that this integrator is estimated to take [s]; null where it takes any.
    stable_dt: Option<f64>,
    /// Whether it neither blew up nor gained more energy than it ever handled.
    stable: bool,
    /// By how much of the most energy that it handled it gained at the most.
    energy_gained: f64,
    /// When it blew up [s]; null where it did not.
    blew_up_at: Option<f64>,
    /// Difference from the reference's energy at the end over the greatest that it was given; null once blown up.
    energy_error: Option<f64>,
    /// Root mean square distance from the reference's particles at the end [m]; null once blown up.
    position_error: Option<f64>,
    /// By how much of itself the first mode's frequency is too high; null where nothing swings.
    frequency_error: Option<f64>,
    /// Rate at which the first mode fades without any damping [1/s]; null where nothing swings.
    decay: Option<f64>,
    /// Force evaluations.
    evaluations: u64,
    /// Time spent stepping [s].
    wall_seconds: f64,
}

/// Order of convergence of an integrator.
#[derive(Debug, Serialize)]
struct Order {
    integrator: IntegratorKind,
    /// Slope of log(position error) over log(step); null with fewer than two stable runs.
    order: Option<f64>,
}

/// Runs every pair, writes what was asked for and prints a table.
///
/// # Errors
/// A scene or an option that cannot be used, before anything runs; a file that cannot be written.
pub(super) fn run(args: &Compare, interruption: &Interruption, console: &mut Console) -> Result<Outcome, CliError> {
    args.threads.run(|| compare(args, interruption, console))
}

fn compare(args: &Compare, interruption: &Interruption, console: &mut Console) -> Result<Outcome, CliError> {
    let source = printable(&args.scene);
    let path = Some(args.scene.as_path());
    let mut loaded = load(Some(&args.scene), &args.sets, None, console)?;
    let baked = bake_with_notes(&mut loaded, path, console)?;
    tell(loaded.made(), console);
    let Loaded { scene, .. } = loaded;
    output::check(
        &output::inputs(path, &scene),
        &[("--report", args.report.as_ref()), ("--plot", args.plot.as_ref())],
    )?;

    let seconds = args.seconds.unwrap_or(scene.time.duration);
    let pairs: Vec<(IntegratorKind, f64)> =
        args.integrators.iter().flat_map(|&integrator| args.dt.iter().map(move |&dt| (integrator, dt))).collect();
    console.begin();
    let study = Study::of(scene.clone(), baked);
    let references = References::new(&study, seconds, &args.dt);
    interruption.wait_for_end();
    let first_mode = study.first_mode();
    let mut runs = Vec::new();
    for (index, &(integrator, dt)) in pairs.iter().enumerate() {
        console.progress(index as u64, pairs.len() as u64, "runs");
        let mut trial = study.trial(integrator, dt);
        match stepped(&mut trial, steps(seconds, dt), interruption) {
            Some(wall_seconds) => {
                let swing = first_mode.and_then(|omega| Some((omega, study.swing(integrator, omega, dt)?)));
                let run = shown(&trial, integrator, dt, steps(seconds, dt), wall_seconds, &references);
                runs.push(Run {
                    frequency_error: swing.map(|(omega, swing)| swing.frequency / omega - 1.0),
                    decay: swing.map(|(_, swing)| swing.decay),
                    ..run
                });
            }
            None => break,
        }
    }
    console.end();
    let interrupted = interruption.signal().filter(|_| runs.len() < pairs.len());
    if let Some(signal) = interrupted {
        let (done, all) = (runs.len(), pairs.len());
        console.say(
            "interrupted",
            &format!("by {signal} when {done} of {all} runs had been made; those are given, marked as incomplete"),
        );
    }

    let size = references.size();
    let lines: Vec<PlotLine> = args.integrators.iter().map(|&integrator| line(integrator, &runs, size)).collect();
    let orders = (args.order || args.plot.is_some()).then(|| {
        let of = |(&integrator, line): (&IntegratorKind, &PlotLine)| Order { integrator, order: line.order };
        args.integrators.iter().zip(&lines).map(of).collect()
    });
    let name = if scene.name.is_empty() { source } else { scene.name.clone() };
    let report = CompareReport {
        scene: name,
        seconds,
        complete: interrupted.is_none(),
        first_mode: first_mode.map(|omega| omega / TAU),
        runs,
        orders,
    };
    let mut text = table(&report);
    if let Some(path) = &args.report {
        text.push('\n');
        text += &output::write_report(path, &report)?;
    }
    if let Some(path) = &args.plot {
        output::write_bytes(path, order_plot(&report.scene, &lines).as_bytes())?;
        text.push('\n');
        text += &output::wrote("plot", path);
    }
    console.print(&text)?;
    Ok(interrupted.map_or(Outcome::Done, Outcome::Interrupted))
}

/// Whole steps of `dt` that come nearest to `seconds`, at least one.
fn steps(seconds: f64, dt: f64) -> u64 {
    (seconds / dt).round().max(1.0) as u64
}

/// One reference for every time at which a run ends: a time that is no multiple of a step is missed by a little.
struct References(Vec<(f64, Trial)>);

impl References {
    fn new(study: &Study, seconds: f64, dts: &[f64]) -> Self {
        let finest = dts.iter().copied().fold(f64::INFINITY, f64::min);
        let mut found: Vec<(f64, Trial)> = Vec::new();
        for &dt in dts {
            let end = steps(seconds, dt) as f64 * dt;
            if !found.iter().any(|(other, _)| is_same(*other, end)) {
                found.push((end, study.reference(end, finest)));
            }
        }
        Self(found)
    }

    fn at(&self, end: f64) -> Option<&Trial> {
        self.0.iter().find(|(other, _)| is_same(*other, end)).map(|(_, trial)| trial)
    }

    /// Extent of the particles [m].
    fn size(&self) -> f64 {
        let bodies = self.0.iter().flat_map(|(_, trial)| trial.world().bodies());
        bodies.flat_map(|body| &body.state().positions).map(|x| x.length()).fold(0.0, f64::max)
    }
}

fn is_same(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-9 * a
}

/// Takes so many steps; gives the time that took [s], or none where it was interrupted.
fn stepped(trial: &mut Trial, steps: u64, interruption: &Interruption) -> Option<f64> {
    let begun = Instant::now();
    for _ in 0..steps {
        if interruption.signal().is_some() {
            return None;
        }
        trial.step();
    }
    Some(begun.elapsed().as_secs_f64())
}

fn shown(
    trial: &Trial,
    integrator: IntegratorKind,
    dt: f64,
    steps: u64,
    wall_seconds: f64,
    references: &References,
) -> Run {
    let ended = trial.blew_up_at().is_none();
    let reference = references.at(steps as f64 * dt).filter(|reference| ended && reference.blew_up_at().is_none());
    Run {
        integrator,
        dt,
        stable_dt: Some(trial.stable_dt()).filter(|limit| limit.is_finite()),
        stable: trial.is_stable(),
        energy_gained: trial.gained(),
        blew_up_at: trial.blew_up_at(),
        energy_error: reference.map(|reference| trial.energy_error(reference)),
        position_error: reference.map(|reference| trial.position_error(reference)),
        frequency_error: None,
        decay: None,
        evaluations: trial.evaluations(),
        wall_seconds,
    }
}

/// The errors of an integrator over its steps, and the order that they show.
fn line(integrator: IntegratorKind, runs: &[Run], size: f64) -> PlotLine {
    let own = runs.iter().filter(|run| run.integrator == integrator);
    let errors = own.filter_map(|run| run.position_error.map(|error| (run.dt, error)));
    let Convergence { order, points, .. } = Convergence::of(integrator, errors, size);
    PlotLine { name: integrator.word().to_owned(), order, points }
}

fn table(report: &CompareReport) -> String {
    let mut table = Table::new([
        ("integrator", Align::Left),
        ("time step [s]", Align::Right),
        ("estimated limit [s]", Align::Right),
        ("result", Align::Left),
        ("energy error", Align::Right),
        ("position error [m]", Align::Right),
        ("evaluations", Align::Right),
        ("stepped in [s]", Align::Right),
    ]);
    let or_dash = |value: Option<f64>| value.map_or_else(|| "-".to_owned(), four_figures);
    for run in &report.runs {
        let result = match run.blew_up_at {
            Some(at) => format!("blew up at {} s", four_figures(at)),
            None if run.stable => "stable".to_owned(),
            None => format!("gained {} times its energy", four_figures(run.energy_gained)),
        };
        table.push([
            run.integrator.word().to_owned(),
            four_figures(run.dt),
            or_dash(run.stable_dt),
            result,
            or_dash(run.energy_error),
            or_dash(run.position_error),
            run.evaluations.to_string(),
            four_figures(run.wall_seconds),
        ]);
    }
    let mut text = table.render();
    if let Some(frequency) = report.first_mode {
        text.push('\n');
        text += &first_mode(frequency, &report.runs);
    }
    if let Some(orders) = &report.orders {
        let mut table = Table::new([("integrator", Align::Left), ("order", Align::Right)]);
        for order in orders {
            table.push([order.integrator.word().to_owned(), or_dash(order.order)]);
        }
        text.push('\n');
        text += &table.render();
    }
    text
}

/// What becomes of the first mode in each run.
fn first_mode(frequency: f64, runs: &[Run]) -> String {
    let mut table = Table::new([
        ("first mode, undamped", Align::Left),
        ("time step [s]", Align::Right),
        ("frequency error", Align::Right),
        ("decay [1/s]", Align::Right),
    ]);
    for run in runs {
        let error = run.frequency_error.map(|error| format!("{:+.2} %", 100.0 * error));
        table.push([
            run.integrator.word().to_owned(),
            four_figures(run.dt),
            error.unwrap_or_else(|| "no swing".to_owned()),
            run.decay.map_or_else(|| "-".to_owned(), |decay| format!("{decay:.3}")),
        ]);
    }
    format!("The first body's slowest swing: {} Hz\n{}", four_figures(frequency), table.render())
}

/// The paper's word for explicit Euler.
const EULER: &str = "euler";

fn integrator(text: &str) -> Result<IntegratorKind, String> {
    if text == EULER {
        return Ok(IntegratorKind::ExplicitEuler);
    }
    let found = IntegratorKind::ALL.into_iter().find(|kind| kind.word() == text);
    found.ok_or_else(|| format!("use one of {}", words()))
}

/// What the option takes.
fn words() -> String {
    format!("{EULER}, {}", IntegratorKind::ALL.map(IntegratorKind::word).join(", "))
}

fn step(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(seconds) if (1e-9..=1e6).contains(&seconds) => Ok(seconds),
        _ => Err("give a number of seconds from 1e-9 to 1e6".to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cli::interruption::Signal;
    use crate::scene::{Assets, Body, Scene};

    #[test]
    fn a_run_that_is_interrupted_gives_no_figures() {
        let scene = Scene::new("box").with_body(Body::cuboid("box", [0.03; 3]));
        let study = Study::new(&scene, &Assets::default()).expect("a scene");
        let trial = || study.trial(IntegratorKind::Rk4, 1e-5);
        assert!(stepped(&mut trial(), 3, &Interruption::default()).is_some());
        let mut late = trial();
        assert!(stepped(&mut late, 3, &Interruption::by(Signal::Terminate)).is_none());
        assert_eq!(late.world().time(), 0.0);
    }

    #[test]
    fn every_integrator_has_its_name_in_scene_files() {
        for kind in IntegratorKind::ALL {
            assert_eq!(serde_json::to_value(kind).unwrap(), kind.word());
            assert_eq!(integrator(kind.word()), Ok(kind));
        }
        assert_eq!(integrator("euler"), Ok(IntegratorKind::ExplicitEuler));
        assert!(integrator("rk5").is_err());
    }
}
