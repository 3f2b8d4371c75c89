//! The `sinew` binary: arguments in, a headless command or the window out.

use clap::Parser;
use sinew::cli::{Cli, Console, built_in, run};
use std::process::ExitCode;

fn main() -> ExitCode {
    let cli = Cli::parse();
    let mut console = Console::of_process();
    match &cli.command {
        Some(command) => run(command, &mut console),
        None => built_in(&mut console),
    }
}
