//! The command line: one file a command, and what they share. Knows nothing of the window.
//!
//! Results go to standard output; errors, warnings and progress to standard error, one line each. The exit code is 0
//! when a command has done its work, 2 when its input cannot be used (nothing is written then) and 3 when a body
//! diverged (what was good until then is written all the same).

mod check;
mod check_model;
mod console;
mod drive;
mod error;
mod make_models;
mod output;
mod parallel;
mod prepare;
mod schema;
mod series;
mod simulate;
mod summary;
mod sweep;
mod table;
mod vary;

pub use console::Console;
pub use error::CliError;

use clap::{Parser, Subcommand};
use std::process::ExitCode;

/// Sketch fibres into soft solids and watch them bend, shear, twist or stiffen.
#[derive(Debug, Parser)]
#[command(name = "sinew", version)]
pub struct Cli {
    /// What to do.
    #[command(subcommand)]
    pub command: Option<Command>,
}

/// What the program does without its window.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Run a scene and report what it shows
    Simulate(simulate::Simulate),
    /// Run a scene once for every combination of some values
    Sweep(sweep::Sweep),
    /// Look a scene or a model over without running it
    Check(check::Check),
    /// Print the JSON Schema of scene files
    Schema,
    /// Make the models in assets/ anew
    #[command(hide = true)]
    MakeModels(make_models::MakeModels),
}

/// How a command ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// It has done its work.
    Done,
    /// It has done its work, but a body diverged.
    Diverged,
}

const BAD_INPUT: u8 = 2;
const DIVERGED: u8 = 3;

/// Runs a command, says what is to be said and gives the exit code.
pub fn run(command: &Command, console: &mut Console) -> ExitCode {
    let outcome = match command {
        Command::Simulate(args) => simulate::run(args, console),
        Command::Sweep(args) => sweep::run(args, console),
        Command::Check(args) => check::run(args, console),
        Command::Schema => schema::run(console),
        Command::MakeModels(args) => make_models::run(args, console),
    };
    match outcome {
        Ok(Outcome::Done) => ExitCode::SUCCESS,
        Ok(Outcome::Diverged) => ExitCode::from(DIVERGED),
        Err(error) => {
            console.error(&error);
            ExitCode::from(BAD_INPUT)
        }
    }
}

/// What the program says, and how it ends, when it is asked for nothing and has no window to open.
pub fn nothing_asked(console: &mut Console) -> ExitCode {
    console.error(&"nothing to do; run a scene with `sinew simulate [SCENE]`, or see `sinew --help`");
    ExitCode::from(BAD_INPUT)
}
