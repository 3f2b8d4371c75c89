//! `sinew render`: a picture of a scene at some time.

use super::drive::drive;
use super::picture::Look;
use super::prepare::{Sets, Threads, frames_to, load, notes, put_together, seconds, tell};
use super::{CliError, Console, Outcome, SceneRenderer, output};
use crate::sim::Runner;
use clap::Args;
use std::path::PathBuf;

/// Arguments of `sinew render`.
#[derive(Debug, Args)]
pub struct Render {
    /// Scene file; the built-in scene unless given
    scene: Option<PathBuf>,
    /// Simulated time at which the picture is taken [s]
    #[arg(long, value_name = "S", default_value = "0", value_parser = seconds, allow_negative_numbers = true)]
    at: f64,
    /// Where the picture goes
    #[arg(long, value_name = "FILE.png")]
    out: PathBuf,
    #[command(flatten)]
    sets: Sets,
    #[command(flatten)]
    threads: Threads,
    #[command(flatten)]
    look: Look,
}

/// Runs the scene up to the time that was asked for and writes the picture.
///
/// # Errors
/// A scene or an option that cannot be used, or no driver, before any file is made; a file that cannot be written.
pub(super) fn run(args: &Render, console: &mut Console) -> Result<Outcome, CliError> {
    args.threads.run(|| render(args, console))
}

fn render(args: &Render, console: &mut Console) -> Result<Outcome, CliError> {
    let scene = load(args.scene.as_ref(), &args.sets, None)?;
    let baked = put_together(&scene, args.scene.as_deref(), console)?;
    tell(&notes(&scene, &baked), console);
    output::check(args.scene.as_ref(), &[("--out", Some(&args.out))])?;

    let mut runner = Runner::new(baked);
    let mut renderer = SceneRenderer::open(&args.look, &scene, &runner.snapshot())?;
    let frames = frames_to(args.at, &runner, console);
    console.begin();
    let ran = drive(&mut runner, frames, false, &mut |runner| {
        console.progress(runner.world().frame(), frames, "frames");
        Ok(())
    });
    console.end();
    ran?;
    let divergence = runner.world().divergence();
    if let Some(divergence) = divergence {
        console.error(divergence);
    }
    // What moved on from where it started is in the picture as well.
    let snapshot = runner.snapshot();
    renderer.take_in(&scene, &snapshot);
    output::write_bytes(&args.out, &renderer.picture(&scene, &snapshot)?)?;
    console.print(&output::wrote("picture", &args.out))?;
    Ok(if divergence.is_some() { Outcome::Diverged } else { Outcome::Done })
}
