//! `sinew table1`: the fibre paper's Table 1, measured again beside its print.

use super::drive::{drive, warn_unbalanced};
use super::interruption::Interruption;
use super::output;
use super::prepare::{Sets, bake_with_notes, load};
use super::{CliError, Console, Outcome};
use crate::bake::Baked;
use crate::io::missing_files;
use crate::scene::{IntegratorKind, Scene};
use crate::sim::Runner;
use crate::solver::body::Body;
use crate::text::number::four_figures;
use clap::Args;
use glam::DVec3;
use serde::Serialize;
use std::fmt::Write;
use std::path::PathBuf;
use std::time::Instant;

/// Arguments of `sinew table1`.
#[derive(Debug, Args)]
pub struct Table1 {
    /// Folder with short_bar.json, long_bar.json, plant.json and leaf.json
    #[arg(long, value_name = "DIR", default_value = "scenes")]
    scenes: PathBuf,
    /// Write the rows as JSON
    #[arg(long, value_name = "FILE")]
    report: Option<PathBuf>,
}

/// A row as the paper prints it.
struct Printed {
    model: &'static str,
    file: &'static str,
    particles: usize,
    fibres: usize,
    structure_particles: usize,
    matrix_ms: f64,
    fibre_ms: f64,
}

const fn printed(
    names: [&'static str; 2],
    [particles, fibres, structure_particles]: [usize; 3],
    [matrix_ms, fibre_ms]: [f64; 2],
) -> Printed {
    Printed { model: names[0], file: names[1], particles, fibres, structure_particles, matrix_ms, fibre_ms }
}

const PAPER: [Printed; 4] = [
    printed(["Short bar", "short_bar.json"], [588, 4, 52], [1.755, 0.072]),
    printed(["Long bar", "long_bar.json"], [375, 2, 28], [1.067, 0.045]),
    printed(["Plant", "plant.json"], [2723, 5, 90], [18.75, 0.235]),
    printed(["Leaf", "leaf.json"], [1159, 5, 86], [7.422, 0.198]),
];

/// A row as measured here.
#[derive(Clone, Debug, PartialEq, Serialize)]
struct Row {
    model: &'static str,
    particles: usize,
    fibres: usize,
    structure_particles: usize,
    /// Elastic force of the matrix, one evaluation [ms].
    matrix_ms: f64,
    /// Bending and stretching of the fibres, one evaluation [ms].
    fibre_ms: f64,
    /// Time step [s].
    dt: f64,
    /// Simulated over wall seconds, everything included.
    real_time_factor: f64,
    /// The integrator that is chosen for 60 frames a second.
    integrator: &'static str,
    /// The share of real time under integrators that suit the scene.
    shares: Vec<Share>,
}

/// How a scene runs under one integrator.
#[derive(Clone, Debug, PartialEq, Serialize)]
struct Share {
    integrator: &'static str,
    /// Simulated over wall seconds.
    real_time_factor: f64,
}

/// Pictures a second that a person sees.
const SEEN: f64 = 60.0;

/// Steps of each scene that are run for the real-time factor.
const STEPS: f64 = 200.0;

/// Rounds in which each force is timed; the shortest counts, which other programs disturb least.
const ROUNDS: u32 = 50;

/// Evaluations in a round. Fibres take a microsecond, of which reading the clock for each would be a few hundredths.
const EVALUATIONS: u32 = 8;

/// Runs the four scenes and prints a table in Markdown.
///
/// # Errors
/// A scene that is missing or cannot be used, a report that cannot be written.
pub(super) fn run(args: &Table1, console: &mut Console) -> Result<Outcome, CliError> {
    let missing = missing_files(PAPER.iter().map(|row| args.scenes.join(row.file)));
    if !missing.is_empty() {
        return Err(CliError::NoScenes { folder: args.scenes.clone(), missing });
    }
    output::check(&crate::transfer::Inputs::default(), &[("--report", args.report.as_ref())])?;
    let mut rows = Vec::new();
    let mut diverged = false;
    for printed in &PAPER {
        let path = args.scenes.join(printed.file);
        let mut loaded = load(Some(&path), &Sets::default(), None, console)?;
        let baked = bake_with_notes(&mut loaded, Some(&path), console)?;
        let (mut row, stopped) = measured(printed.model, baked, console)?;
        let scene = loaded.scene.clone();
        loaded.scene.time.frames_per_second = SEEN;
        let at_sixty = bake_with_notes(&mut loaded, Some(&path), console)?;
        let first = at_sixty.world.bodies().first();
        row.integrator = first.map_or("", |body| body.parts().integrator_word);
        for kind in IntegratorKind::ALL {
            if !suits(kind, &row) {
                continue;
            }
            loaded.scene = under(scene.clone(), kind);
            let frame_seconds = loaded.scene.time.frame_seconds();
            let baked = bake_with_notes(&mut loaded, Some(&path), console)?;
            let real_time_factor = real_time(baked, frame_seconds, console)?;
            row.shares.push(Share { integrator: kind.word(), real_time_factor });
        }
        rows.push(row);
        diverged |= stopped;
    }
    let mut text = markdown(&rows);
    if let Some(path) = &args.report {
        text += "\n";
        text += &output::write_report(path, &rows)?;
    }
    console.print(&text)?;
    Ok(if diverged { Outcome::Diverged } else { Outcome::Done })
}

/// Whether a scene is run under an integrator too: by leap-frog, beside which others are seen, with fibres implicit
/// where it has any, and under the one that was chosen for it.
fn suits(kind: IntegratorKind, row: &Row) -> bool {
    match kind {
        IntegratorKind::LeapFrog => true,
        IntegratorKind::FibresImplicit => row.fibres > 0,
        other => other.word() == row.integrator,
    }
}

/// The scene under an integrator; one that takes steps of any length is run as it is seen.
fn under(mut scene: Scene, kind: IntegratorKind) -> Scene {
    scene.bodies.iter_mut().for_each(|body| body.integrator = kind.into());
    if kind == IntegratorKind::TrBdf2 {
        scene.time.frames_per_second = SEEN;
    }
    scene
}

/// Simulated over wall seconds once the first frame, in which much is prepared, is over.
fn real_time(baked: Baked, frame_seconds: f64, console: &mut Console) -> Result<f64, CliError> {
    /// Frames of a step each that are timed.
    const FRAMES: f64 = 12.0;
    let mut runner = Runner::new(baked);
    let first = runner.world().bodies().first().map_or(0.0, |body| body.parts().dt);
    let per_frame = frame_seconds / first;
    let frames = if per_frame > 1.5 { (STEPS / per_frame).ceil() } else { FRAMES };
    let none = Interruption::default();
    drive(&mut runner, 1, false, &none, &mut |_| Ok(()))?;
    let begun = runner.world().time();
    let ran = drive(&mut runner, 1 + frames as u64, false, &none, &mut |_| Ok(()))?;
    warn_unbalanced(runner.world(), &mut Vec::new(), console);
    Ok((runner.world().time() - begun) / ran.wall_seconds.max(f64::MIN_POSITIVE))
}

/// Runs one scene for a while, then times its forces in the state that it has come to; tells whether it diverged.
fn measured(model: &'static str, baked: Baked, console: &mut Console) -> Result<(Row, bool), CliError> {
    let mut runner = Runner::new(baked);
    let dt = runner.world().bodies().first().map_or(0.0, |body| body.parts().dt);
    let frames = runner.frames_for(STEPS * dt).max(1);
    let ran = drive(&mut runner, frames, false, &Interruption::default(), &mut |_| Ok(()))?;
    let world = runner.world();
    warn_unbalanced(world, &mut Vec::new(), console);
    let mut row = Row {
        model,
        particles: 0,
        fibres: 0,
        structure_particles: 0,
        matrix_ms: 0.0,
        fibre_ms: 0.0,
        dt,
        real_time_factor: world.time() / ran.wall_seconds.max(f64::MIN_POSITIVE),
        integrator: "",
        shares: Vec::new(),
    };
    for body in world.bodies() {
        let parts = body.parts();
        row.particles += body.state().len();
        row.fibres += parts.fibres.len();
        row.structure_particles += parts.fibres.iter().map(|fibre| fibre.vertices.len()).sum::<usize>();
        row.matrix_ms += milliseconds(body, "matrix");
        row.fibre_ms += milliseconds(body, "fibres");
    }
    Ok((row, world.divergence().is_some()))
}

/// Shortest time of one evaluation of the forces with this name [ms].
fn milliseconds(body: &Body, name: &str) -> f64 {
    let mut forces: Vec<_> = body.parts().forces.iter().filter(|force| force.name() == name).cloned().collect();
    if forces.is_empty() {
        return 0.0;
    }
    let mut sums = vec![DVec3::ZERO; body.state().len()];
    let mut least = f64::INFINITY;
    for _ in 0..ROUNDS {
        let begun = Instant::now();
        for _ in 0..EVALUATIONS {
            for force in &mut forces {
                force.add_forces(0.0, body.state(), &mut sums);
            }
        }
        least = least.min(begun.elapsed().as_secs_f64());
    }
    1e3 * least / f64::from(EVALUATIONS)
}

/// Our rows above the paper's.
fn markdown(rows: &[Row]) -> String {
    let mut text = String::from(
        "| model | | particles | fibres / structure particles | matrix [ms] | fibres [ms] | fibres / matrix | dt [s] | real time |\n\
         | --- | --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n",
    );
    for (row, paper) in rows.iter().zip(&PAPER) {
        let Row { model, particles, fibres, structure_particles, matrix_ms, fibre_ms, .. } = row;
        let share = |fibre: f64, matrix: f64| format!("{:.1} %", 100.0 * fibre / matrix);
        // Writing to a string cannot fail.
        let _ = writeln!(
            text,
            "| {model} | here | {particles} | {fibres} / {structure_particles} | {} | {} | {} | {} | {} |",
            four_figures(*matrix_ms),
            four_figures(*fibre_ms),
            share(*fibre_ms, *matrix_ms),
            four_figures(row.dt),
            four_figures(row.real_time_factor),
        );
        let _ = writeln!(
            text,
            "| | paper | {} | {} / {} | {} | {} | {} | | |",
            paper.particles,
            paper.fibres,
            paper.structure_particles,
            four_figures(paper.matrix_ms),
            four_figures(paper.fibre_ms),
            share(paper.fibre_ms, paper.matrix_ms),
        );
    }
    text += "\n| model | integrator | real time | x leap-frog | |\n| --- | --- | ---: | ---: | --- |\n";
    for row in rows {
        let of_leap_frog = row.shares.iter().find(|share| share.integrator == IntegratorKind::LeapFrog.word());
        for share in &row.shares {
            let times = of_leap_frog.map(|other| four_figures(share.real_time_factor / other.real_time_factor));
            let chosen = if share.integrator == row.integrator { "chosen" } else { "" };
            let (model, integrator) = (row.model, share.integrator);
            let (real_time, times) = (four_figures(share.real_time_factor), times.unwrap_or_default());
            let _ = writeln!(text, "| {model} | {integrator} | {real_time} | {times} | {chosen} |");
        }
    }
    text
}
