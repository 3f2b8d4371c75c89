//! `--trace FILE`: how long what took, with any command and with the window.

use super::error::printable;
use super::{BAD_INPUT, Console};
use crate::io::Trace;
use std::path::Path;
use std::process::ExitCode;

/// Does the work of the program; where a path is given, with a trace of it, which is written unless the input could not
/// be used.
pub fn traced(path: Option<&Path>, console: &mut Console, work: impl FnOnce(&mut Console) -> ExitCode) -> ExitCode {
    let Some(path) = path else { return work(console) };
    let trace = match Trace::start(path) {
        Ok(trace) => trace,
        Err(error) => {
            console.error(&error);
            return ExitCode::from(BAD_INPUT);
        }
    };
    let code = work(console);
    if code == ExitCode::from(BAD_INPUT) {
        return code;
    }
    match trace.finish() {
        Ok(()) => {
            console.say("note", &format!("trace written to {}", printable(path)));
            code
        }
        Err(error) => {
            console.error(&error);
            ExitCode::from(BAD_INPUT)
        }
    }
}
