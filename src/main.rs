//! The `sinew` binary: arguments in, a headless command or the window out.

use clap::Parser;
use sinew::cli::{Cli, Console, quiet_importers, run, traced};
use std::path::PathBuf;
use std::process::ExitCode;

fn main() -> ExitCode {
    quiet_importers();
    let cli = Cli::parse();
    let mut console = Console::of_process();
    traced(cli.trace.as_deref(), &mut console, |console| match &cli.command {
        Some(command) => run(command, console),
        None => show(cli.scene, console),
    })
}

#[cfg(feature = "gui")]
fn show(path: Option<PathBuf>, console: &mut Console) -> ExitCode {
    let document = match sinew::ui::Document::load_or_ask(path) {
        Ok(document) => document,
        Err(problem) => return sinew::cli::bad_input(&problem, console),
    };
    match sinew::ui::run(document) {
        Ok(()) => ExitCode::SUCCESS,
        Err(problem) => sinew::cli::no_window(&problem, console),
    }
}

#[cfg(not(feature = "gui"))]
fn show(path: Option<PathBuf>, console: &mut Console) -> ExitCode {
    sinew::cli::without_window(path, console)
}
