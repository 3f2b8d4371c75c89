//! Where words go: results to standard output, everything else to standard error.

use super::CliError;
use crate::scene::one_line;
use indicatif::{HumanDuration, ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::fmt::Display;
use std::io::{self, IsTerminal, Write};
use std::time::{Duration, Instant};

/// Work shorter than this shows no progress bar.
const LONG: Duration = Duration::from_secs(1);

/// The two streams of a command, and the progress bar that may stand on the second.
pub struct Console {
    out: Box<dyn Write + Send>,
    err: Box<dyn Write + Send>,
    interactive: bool,
    bar: Option<ProgressBar>,
    begun: Instant,
}

impl Console {
    /// The streams of the process; progress is shown only when its standard error is a terminal.
    pub fn of_process() -> Self {
        Self::new(Box::new(io::stdout()), Box::new(io::stderr()), io::stderr().is_terminal())
    }

    /// Any streams; `interactive` tells whether progress may be drawn on the process's standard error.
    pub fn new(out: Box<dyn Write + Send>, err: Box<dyn Write + Send>, interactive: bool) -> Self {
        Self { out, err, interactive, bar: None, begun: Instant::now() }
    }

    /// Prints a result.
    ///
    /// # Errors
    /// [`CliError::Output`] where it cannot be written; a reader that has gone away is no error.
    pub fn print(&mut self, text: &str) -> Result<(), CliError> {
        match self.out.write_all(text.as_bytes()).and_then(|()| self.out.flush()) {
            Err(error) if error.kind() != io::ErrorKind::BrokenPipe => Err(CliError::Output(error)),
            _ => Ok(()),
        }
    }

    /// Says what stopped the command or one of its bodies.
    pub fn error(&mut self, text: &dyn Display) {
        self.say("error", text);
    }

    /// Says what a person should act on.
    pub fn warn(&mut self, text: &dyn Display) {
        self.say("warning", text);
    }

    /// Says one line of a kind.
    pub fn say(&mut self, kind: &str, text: &dyn Display) {
        let line = format!("{kind}: {}\n", one_line(&text.to_string()));
        let err = &mut self.err;
        // Nobody is left to be told when standard error itself is gone.
        let mut write = || err.write_all(line.as_bytes()).ok();
        match &self.bar {
            Some(bar) => bar.suspend(write),
            None => write(),
        };
    }

    /// Begins work whose progress may be worth showing.
    pub fn begin(&mut self) {
        self.end();
        self.begun = Instant::now();
    }

    /// Shows that `done` of `total` pieces of work are done, once the work has turned out to be long.
    pub fn progress(&mut self, done: u64, total: u64, pieces: &str) {
        if self.is_long() && self.bar.is_none() && done < total {
            let bar = ProgressBar::with_draw_target(Some(total), ProgressDrawTarget::stderr());
            let template = format!("{{bar:40}} {{pos}}/{{len}} {pieces}, {{elapsed}} gone{{msg}}");
            bar.set_style(ProgressStyle::with_template(&template).unwrap_or_else(|_| ProgressStyle::default_bar()));
            self.bar = Some(bar.with_elapsed(self.begun.elapsed()));
        }
        if let Some(bar) = &self.bar {
            bar.set_position(done);
            bar.set_message(time_left(self.begun.elapsed(), done, total));
        }
    }

    /// Shows what is being worked on, once the work has turned out to be long.
    pub fn stage(&mut self, text: &dyn Display) {
        if self.is_long() {
            let bar = self.bar.get_or_insert_with(|| {
                let bar = ProgressBar::with_draw_target(None, ProgressDrawTarget::stderr());
                bar.enable_steady_tick(Duration::from_millis(100));
                bar
            });
            bar.set_message(one_line(&text.to_string()));
        }
    }

    /// Ends work that was begun: the bar, if there was one, goes away.
    pub fn end(&mut self) {
        if let Some(bar) = self.bar.take() {
            bar.finish_and_clear();
        }
    }

    fn is_long(&self) -> bool {
        self.interactive && self.begun.elapsed() >= LONG
    }
}

/// The time that is left when the rest goes as the part that is done. The bar's own estimate takes what was done
/// before it appeared for the work of an instant.
fn time_left(gone: Duration, done: u64, total: u64) -> String {
    if done == 0 {
        return String::new();
    }
    let left = gone.as_secs_f64() * total.saturating_sub(done) as f64 / done as f64;
    format!(", {:#} left", HumanDuration(Duration::try_from_secs_f64(left).unwrap_or(Duration::MAX)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_long_work_at_a_terminal_shows_a_bar() {
        for (interactive, age, shown) in [(true, LONG, true), (true, Duration::ZERO, false), (false, LONG, false)] {
            let mut console = Console::new(Box::new(io::sink()), Box::new(io::sink()), interactive);
            console.begun = Instant::now().checked_sub(age).unwrap();
            console.progress(3, 10, "rows");
            assert_eq!(console.bar.as_ref().map(ProgressBar::position), shown.then_some(3));
            console.end();
            assert!(console.bar.is_none());
        }
    }

    #[test]
    fn the_rest_takes_as_long_as_the_part_that_is_done() {
        assert_eq!(time_left(Duration::from_secs(20), 40, 180), ", 70s left");
        assert_eq!(time_left(Duration::from_secs(20), 0, 180), "");
    }
}
