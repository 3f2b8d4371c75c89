//! What a report says of how its run was made, and making that run again.

use super::error::printable;
use super::prepare::{Assignment, Span};
use super::{CliError, Console};
use crate::io::read_json;
use crate::sim::Report;
use serde::{Deserialize, Serialize};
use serde_json::Value;
use std::path::{Path, PathBuf};

/// What a run was made of.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Run {
    /// Version of the program.
    version: String,
    /// The scene's file as it was named; null for the built-in scene.
    scene_file: Option<PathBuf>,
    /// Hash of the scene with all that was set in it, and of its models' files.
    scene_hash: String,
    /// What was set, as `--set` takes it.
    sets: Vec<String>,
    /// Frames a second, if they were asked for.
    fps: Option<f64>,
    /// Threads it ran on.
    threads: usize,
    /// Bits of a machine word.
    word_bits: u32,
}

impl Run {
    /// Of a scene of this hash from a file, with these values set in it.
    pub(super) fn new(scene_hash: String, file: Option<&PathBuf>, sets: &[Assignment], fps: Option<f64>) -> Self {
        Self {
            version: env!("CARGO_PKG_VERSION").to_owned(),
            scene_file: file.cloned(),
            scene_hash,
            sets: sets.iter().map(|set| format!("{}={}", set.pointer, set.text)).collect(),
            fps,
            threads: rayon::current_num_threads(),
            word_bits: usize::BITS,
        }
    }
}

/// A report with what its run was made of.
#[derive(Serialize)]
pub(super) struct RunReport<'a> {
    #[serde(flatten)]
    pub(super) report: &'a Report,
    pub(super) run: Run,
}

/// A report whose run is made again.
pub(super) struct Repeated {
    path: PathBuf,
    run: Run,
    seconds: f64,
    /// Hashes of the bodies' states, by their identifiers.
    hashes: Vec<(String, String)>,
}

impl Repeated {
    /// Reads a report.
    ///
    /// # Errors
    /// A file that is no report of a run, or of an older program, which did not say how it was made.
    pub(super) fn read(path: &Path) -> Result<Self, CliError> {
        let report = read_json(path)?;
        let refused = || CliError::NotARun { path: printable(path) };
        let run = report.get("run").cloned().and_then(|run| serde_json::from_value(run).ok()).ok_or_else(refused)?;
        let seconds = report.get("seconds").and_then(Value::as_f64).ok_or_else(refused)?;
        let bodies = report.get("bodies").and_then(Value::as_array).ok_or_else(refused)?;
        let word = |body: &Value, name| body.get(name).and_then(Value::as_str).map(str::to_owned);
        let of = |body: &Value| Some((word(body, "id")?, word(body, "state_hash")?));
        let hashes = bodies.iter().map(of).collect::<Option<_>>().ok_or_else(refused)?;
        Ok(Self { path: path.to_owned(), run, seconds, hashes })
    }

    /// The scene's file, what is set in it and how long it is run.
    ///
    /// # Errors
    /// A value that was set and cannot be read any more.
    pub(super) fn arguments(&self) -> Result<(Option<PathBuf>, Vec<Assignment>, Span), CliError> {
        let sets = self.run.sets.iter().map(|set| set.parse::<Assignment>());
        let sets = sets.collect::<Result<_, _>>().map_err(|_| CliError::NotARun { path: printable(&self.path) })?;
        let span = Span { seconds: Some(self.seconds), fps: self.run.fps, until_rest: false };
        Ok((self.run.scene_file.clone(), sets, span))
    }

    /// Says whether a run came to the same bits as the report's; tells it too.
    pub(super) fn compare(&self, scene_hash: &str, report: &Report, console: &mut Console) -> bool {
        let path = printable(&self.path);
        if scene_hash != self.run.scene_hash {
            console.warn(&format!("{path}: the scene or a model of it is not what it was when the report was made"));
        }
        let found: Vec<(&String, &String)> = report.bodies.iter().map(|body| (&body.id, &body.state_hash)).collect();
        let same = found.len() == self.hashes.len();
        let differs =
            found.iter().zip(&self.hashes).find(|((id, hash), (before, expected))| *id != before || *hash != expected);
        match differs {
            None if same => {
                let bodies = if found.len() == 1 { "body" } else { "bodies" };
                console.say("repeated", &format!("{} {bodies}, the same bits as in {path}", found.len()));
                true
            }
            Some(((id, _), _)) => {
                let Run { version, word_bits, .. } = &self.run;
                console.error(&format!(
                    "{path}: body {id} came to another state than in the report, which version {version} made on a machine of \
                     {word_bits} bits"
                ));
                false
            }
            None => {
                console.error(&format!(
                    "{path}: it tells of {} bodies, and {} were run",
                    self.hashes.len(),
                    found.len()
                ));
                false
            }
        }
    }
}
