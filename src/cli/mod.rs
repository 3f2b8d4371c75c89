//! The command line: one file a command, and what they share. Knows nothing of the window.
//!
//! Results go to standard output; errors, warnings and progress to standard error, one line each. The exit code is 0
//! when a command has done its work, 2 when its input cannot be used (nothing is written then) 3 when a body diverged
//! (what was good until then is written all the same) and 4 when there is no graphics driver to make a picture with;
//! 130, 143 or 129 when SIGINT (Ctrl-C), SIGTERM or, on Linux, SIGHUP ended a run, whose results until then are written
//! and marked as incomplete.

mod body_table;
mod check;
mod check_model;
mod collect;
mod compare;
mod console;
mod converge;
mod drive;
mod error;
mod fibres;
mod finite;
mod interruption;
mod make_models;
pub(crate) mod make_pictures;
mod motion;
mod order_plot;
mod outcome;
mod output;
mod parallel;
mod parting;
mod picture;
mod prepare;
mod render;
mod repeat;
mod replay;
mod schema;
mod simulate;
mod summary;
mod svg;
mod sweep;
mod table;
mod table1;
mod trace;

pub use crate::io::quiet_importers;
pub use console::Console;
pub use error::CliError;
pub use interruption::Signal;
pub use outcome::Outcome;
pub(crate) use replay::read_journal;
pub use trace::traced;

use clap::{Parser, Subcommand};
use interruption::Interruption;
#[cfg(feature = "gui")]
use std::fmt::Display;
use std::path::PathBuf;
use std::process::ExitCode;

/// Sketch fibres into soft solids and watch them bend, shear, twist or stiffen.
#[derive(Debug, Parser)]
#[command(name = "sinew", version, args_conflicts_with_subcommands = true)]
pub struct Cli {
    /// Scene or model to open in the window; the built-in scene unless given
    pub scene: Option<PathBuf>,
    /// Write how long what took as a trace, for Perfetto or chrome://tracing
    #[arg(long, global = true, value_name = "FILE")]
    pub trace: Option<PathBuf>,
    /// What to do.
    #[command(subcommand)]
    pub command: Option<CliCommand>,
}

/// What the program does without its window.
#[derive(Debug, Subcommand)]
pub enum CliCommand {
    /// Run a scene or a model and report what it shows
    Simulate(simulate::Simulate),
    /// Take a picture of a scene or a model at some time
    Render(render::Render),
    /// Run a scene once for every combination of some values
    Sweep(sweep::Sweep),
    /// Run a scene under several integrators, each with several steps
    Compare(compare::Compare),
    /// Run a scene with a body filled more and more finely, and extrapolate its measures
    Converge(converge::Converge),
    /// Make the motion of a journal again, and say whether it comes to the same bits
    Replay(replay::Replay),
    /// Look a scene or a model over without running it
    Check(check::Check),
    /// Write the fibres of a scene as lines for other programs, or read lines as fibres
    Fibres(fibres::Fibres),
    /// Put a scene and its models into one folder
    Collect(collect::Collect),
    /// Measure the fibre paper's Table 1 again, beside its print
    Table1(table1::Table1),
    /// Print the JSON Schema of scene files
    Schema,
    /// Make the models in assets/ anew
    #[command(hide = true)]
    MakeModels(make_models::MakeModels),
    /// Make the pictures of the window's galleries anew
    #[command(hide = true)]
    MakePictures(make_pictures::MakePictures),
}

const DIFFERS: u8 = 1;
const BAD_INPUT: u8 = 2;
const DIVERGED: u8 = 3;
#[cfg(feature = "render")]
const NO_DRIVER: u8 = 4;

/// Runs a command, says what is to be said and gives the exit code.
pub fn run(command: &CliCommand, console: &mut Console) -> ExitCode {
    let outcome = match command {
        CliCommand::Simulate(args) => simulate::run(args, &Interruption::listening(), console),
        CliCommand::Render(args) => render::run(args, &Interruption::listening(), console),
        CliCommand::Sweep(args) => sweep::run(args, &Interruption::listening(), console),
        CliCommand::Compare(args) => compare::run(args, &Interruption::listening(), console),
        CliCommand::Converge(args) => converge::run(args, &Interruption::listening(), console),
        CliCommand::Replay(args) => replay::run(args, &Interruption::listening(), console),
        CliCommand::Check(args) => check::run(args, console),
        CliCommand::Fibres(args) => fibres::run(args, console),
        CliCommand::Collect(args) => collect::run(args, console),
        CliCommand::Table1(args) => table1::run(args, console),
        CliCommand::Schema => schema::run(console),
        CliCommand::MakeModels(args) => make_models::run(args, console),
        CliCommand::MakePictures(args) => make_pictures::run(args, console),
    };
    match outcome {
        Ok(Outcome::Done) => ExitCode::SUCCESS,
        Ok(Outcome::Differs) => ExitCode::from(DIFFERS),
        Ok(Outcome::Diverged) => ExitCode::from(DIVERGED),
        Ok(Outcome::Interrupted(signal)) => ExitCode::from(signal.exit_code()),
        Err(error) => {
            console.error(&error);
            #[cfg(feature = "render")]
            if error.is_no_driver() {
                return ExitCode::from(NO_DRIVER);
            }
            ExitCode::from(BAD_INPUT)
        }
    }
}

/// What is said, and how the program ends, where a scene for the window cannot be read.
#[cfg(feature = "gui")]
pub fn bad_input(problem: &dyn Display, console: &mut Console) -> ExitCode {
    console.error(problem);
    ExitCode::from(BAD_INPUT)
}

/// What is said, and how the program ends, where no window can be opened.
#[cfg(feature = "gui")]
pub fn no_window(problem: &dyn Display, console: &mut Console) -> ExitCode {
    console.error(problem);
    ExitCode::from(NO_DRIVER)
}

/// What a program without a window does when it is given no command: it runs the scene.
#[cfg(not(feature = "gui"))]
pub fn without_window(scene: Option<PathBuf>, console: &mut Console) -> ExitCode {
    console.say(
        "note",
        &"this program was built without its window and runs the scene; `sinew --help` lists the commands",
    );
    run(&CliCommand::Simulate(simulate::Simulate::of(scene)), console)
}
