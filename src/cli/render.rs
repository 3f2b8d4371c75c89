//! `sinew render`: a picture of a scene at some time.

use super::drive::{RunEnd, drive, warn_unbalanced};
use super::interruption::Interruption;
use super::output;
use super::picture::Look;
use super::prepare::{Sets, Threads, bake_with_notes, frames_to, load, seconds, tell};
use super::{CliError, Console, Outcome};
use crate::sim::Runner;
use crate::text::number::four_figures;
use crate::transfer::{SceneRenderer, check_finite};
use clap::Args;
use std::path::PathBuf;

/// Arguments of `sinew render`.
#[derive(Debug, Args)]
pub struct Render {
    /// Scene file, or a model: OBJ, STL, PLY, glTF or GLB; the built-in scene unless given
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
pub(super) fn run(args: &Render, interruption: &Interruption, console: &mut Console) -> Result<Outcome, CliError> {
    args.threads.run(|| render(args, interruption, console))
}

fn render(args: &Render, interruption: &Interruption, console: &mut Console) -> Result<Outcome, CliError> {
    let mut loaded = load(args.scene.as_ref(), &args.sets, None, console)?;
    let baked = bake_with_notes(&mut loaded, args.scene.as_deref(), console)?;
    tell(&loaded.notes(&baked), console);
    let scene = loaded.scene;
    output::check(&output::inputs(args.scene.as_deref(), &scene), &[("--out", Some(&args.out))])?;

    let mut runner = Runner::new(baked);
    let mut renderer = SceneRenderer::open(&args.look.asked(), &scene, &runner.snapshot())?;
    let frames = frames_to(args.at, &runner, console);
    console.begin();
    interruption.wait_for_end();
    let ran = drive(&mut runner, frames, false, interruption, &mut |runner| {
        console.progress(runner.world().frame(), frames, "frames");
        Ok(())
    });
    console.end();
    if let RunEnd::Interrupted(signal) = ran?.end {
        let [done, all] = [runner.world().time(), args.at].map(four_figures);
        console.say("interrupted", &format!("by {signal} at {done} s of {all} s; no picture is written"));
        return Ok(Outcome::Interrupted(signal));
    }
    warn_unbalanced(runner.world(), &mut Vec::new(), console);
    let divergence = runner.world().divergence();
    if let Some(divergence) = divergence {
        console.error(divergence);
    }
    // What moved on from where it started is in the picture as well.
    let snapshot = runner.snapshot();
    check_finite(&snapshot)?;
    renderer.take_in(&scene, &snapshot);
    output::write_bytes(&args.out, &renderer.picture(&scene, &snapshot)?.png()?)?;
    console.print(&output::wrote("picture", &args.out))?;
    Ok(if divergence.is_some() { Outcome::Diverged } else { Outcome::Done })
}
