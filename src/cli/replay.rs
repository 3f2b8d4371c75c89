//! `sinew replay`: the motion of a journal made again, frame by frame, and held against what it came to in the window.

use super::drive::warn_unbalanced;
use super::error::printable;
use super::interruption::Interruption;
use super::output;
use super::parting::{cause_of, parting};
use super::prepare::folder_of;
use super::{CliError, Console, Outcome};
use crate::io::{complete_assets, read_json, refuse_outside, typed};
use crate::scene::{Assets, one_line};
use crate::sim::{Journal, Report, Rerun};
use crate::transfer::Inputs;
use clap::Args;
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// Arguments of `sinew replay`.
#[derive(Debug, Args)]
pub struct Replay {
    /// Journal, as the window saves it beside a scene; its models are looked for from its own folder
    journal: PathBuf,
    /// Let its scenes read models outside of its folder and of the folder `assets` beside that
    #[arg(long)]
    outside: bool,
    /// Write a report of the end as JSON
    #[arg(long, value_name = "FILE")]
    report: Option<PathBuf>,
    /// Make the motion on each of these numbers of threads, and say where they part first, as in 1,4
    #[arg(long, value_name = "N,N", value_delimiter = ',')]
    threads: Vec<NonZeroUsize>,
}

/// Makes the motion again, and says whether every frame came to the same bits.
///
/// # Errors
/// A journal or a model that cannot be read, a scene that cannot be put together, a report that cannot be written.
pub(super) fn run(args: &Replay, interruption: &Interruption, console: &mut Console) -> Result<Outcome, CliError> {
    let journal = read_journal(&args.journal)?;
    let mut assets = Assets::default();
    console.begin();
    for scene in journal.scenes() {
        if !args.outside {
            refuse_outside(scene, &args.journal)?;
        }
        complete_assets(&mut assets, scene, folder_of(Some(&args.journal)), &mut |stage| console.stage(&stage))?;
    }
    console.end();
    let inputs = Inputs::default().and("the journal", Some(&args.journal));
    output::check(&inputs, &[("--report", args.report.as_ref())])?;
    if journal.program != env!("CARGO_PKG_VERSION") {
        console.warn(&format!(
            "{}: version {} of the program wrote it, so that its bits may be others than those of this one",
            printable(&args.journal),
            one_line(&journal.program)
        ));
    }
    interruption.wait_for_end();
    if args.threads.is_empty() {
        again(args, journal, assets, interruption, console)
    } else {
        beside(args, &journal, &assets, interruption, console)
    }
}

/// Reads a journal whose scenes can be used.
///
/// # Errors
/// A file that cannot be read, is no journal, or holds a scene that cannot be used.
pub(crate) fn read_journal(path: &Path) -> Result<Journal, CliError> {
    let refused = |problem: String| CliError::Journal { path: path.to_owned(), problem };
    let journal: Journal =
        typed(&read_json(path)?).map_err(|why| refused(format!("it is no journal of the window ({why})")))?;
    for scene in journal.scenes() {
        scene.validate().map_err(|error| refused(format!("a scene in it cannot be used: {error}")))?;
    }
    Ok(journal)
}

/// Once, against what the journal says of each frame.
fn again(
    args: &Replay,
    journal: Journal,
    assets: Assets,
    interruption: &Interruption,
    console: &mut Console,
) -> Result<Outcome, CliError> {
    let refused = |problem: String| CliError::Journal { path: args.journal.clone(), problem };
    let (frames, scene) = (journal.frames(), journal.scenes().last().cloned());
    let begun = Instant::now();
    let mut rerun = Rerun::new(journal, assets).map_err(refused)?;
    let (mut differs, mut told) = (None, Vec::new());
    console.begin();
    while interruption.signal().is_none() && rerun.advance().map_err(refused)? {
        console.progress(rerun.frame(), frames, "frames");
        if let Some(runner) = rerun.runner() {
            warn_unbalanced(runner.world(), &mut told, console);
        }
        if differs.is_none() && !rerun.agrees() {
            differs = Some(rerun.frame());
        }
    }
    console.end();
    let done = rerun.frame();
    let mut text = match differs {
        None => format!("{}: {done} frames, each to the same bits\n", printable(&args.journal)),
        Some(frame) => format!("{}: {done} frames, other bits from frame {frame} on\n", printable(&args.journal)),
    };
    if let (Some(path), Some(runner), Some(scene)) = (&args.report, rerun.runner(), scene) {
        let mut report = Report::new(&scene, runner, begun.elapsed().as_secs_f64(), Vec::new());
        report.complete = interruption.signal().is_none();
        text += &output::write_report(path, &report)?;
    }
    console.print(&text)?;
    Ok(match interruption.signal() {
        Some(signal) => Outcome::Interrupted(signal),
        None if differs.is_some() => Outcome::Differs,
        None => Outcome::Done,
    })
}

/// In step on several numbers of threads, until they part.
fn beside(
    args: &Replay,
    journal: &Journal,
    assets: &Assets,
    interruption: &Interruption,
    console: &mut Console,
) -> Result<Outcome, CliError> {
    let refused = |problem: String| CliError::Journal { path: args.journal.clone(), problem };
    let mut runs = Vec::new();
    for threads in &args.threads {
        let pool = rayon::ThreadPoolBuilder::new().num_threads((*threads).into()).build()?;
        let rerun = pool.install(|| Rerun::new(journal.clone(), assets.clone())).map_err(refused)?;
        runs.push((pool, rerun));
    }
    console.begin();
    let mut parted = None;
    'frames: while interruption.signal().is_none() {
        let mut is_over = false;
        let mut before = Vec::new();
        for (pool, rerun) in &mut runs {
            is_over |= !pool.install(|| rerun.ask()).map_err(refused)?;
            before.push(rerun.runner().cloned());
        }
        if is_over {
            break;
        }
        for (pool, rerun) in &mut runs {
            pool.install(|| rerun.advance()).map_err(refused)?;
        }
        let Some(((pool, first), others)) = runs.split_first() else { break };
        console.progress(first.frame(), journal.frames(), "frames");
        for (k, (other_pool, other)) in others.iter().enumerate() {
            let Some(place) = first.runner().zip(other.runner()).and_then(|(a, b)| parting(a, b)) else { continue };
            let cause = before[0].as_ref().zip(before[k + 1].as_ref());
            let cause = cause.map_or_else(String::new, |(a, b)| format!(": {}", cause_of((pool, a), (other_pool, b))));
            let on = format!("on {} and {} threads", args.threads[0], args.threads[k + 1]);
            parted = Some(format!("frame {}: {place} {on}{cause}", first.frame()));
            break 'frames;
        }
    }
    console.end();
    let on: Vec<String> = args.threads.iter().map(ToString::to_string).collect();
    let done = runs.first().map_or(0, |(_, rerun)| rerun.frame());
    let (name, on) = (printable(&args.journal), on.join(", "));
    console.print(&match &parted {
        None => format!("{name}: {done} frames, the same bits on {on} threads\n"),
        Some(place) => format!("{name}: {place}\n"),
    })?;
    Ok(match interruption.signal() {
        Some(signal) => Outcome::Interrupted(signal),
        None if parted.is_some() => Outcome::Differs,
        None => Outcome::Done,
    })
}
