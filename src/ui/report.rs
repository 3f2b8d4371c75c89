//! What somebody needs who looks for a fault, gathered from the window: the scene with its models, what was done to the
//! motion, what was said, and the versions.

use super::context::Context;
use super::fault_report::FaultReport;
use crate::io::{free_memory, system};
use std::fmt::Write;
use std::path::PathBuf;
use std::sync::Arc;

/// Where it goes unless another place is chosen.
const USUAL: &str = "sinew-report.zip";

/// Where the archive goes unless another place is chosen: beside the scene.
pub(super) fn usual_place(cx: &Context) -> PathBuf {
    cx.document.path.as_ref().map_or_else(|| USUAL.into(), |path| path.with_extension("report.zip"))
}

/// A report of the window as it stands; `adapter` is what pictures are drawn by.
pub(super) fn report(path: PathBuf, cx: &Context, adapter: Option<&str>) -> FaultReport {
    let mut versions = format!("sinew {}\n{}\n", env!("CARGO_PKG_VERSION"), system());
    let mut line = |name: &str, value: &str| writeln!(versions, "{name}: {value}").unwrap_or_default();
    line("pictures", adapter.unwrap_or("none"));
    line("threads", &rayon::current_num_threads().to_string());
    if let Some(bytes) = free_memory() {
        line("free memory", &format!("{} MiB", bytes >> 20));
    }
    line("scene", &cx.document.path.as_deref().map_or_else(|| "no file".to_owned(), |path| path.display().to_string()));
    let status = &cx.simulation.published().status;
    let mut log: String = cx.log().fold(String::new(), |all, said| all + said + "\n");
    let mut also = |what: &str| writeln!(log, "{what}").unwrap_or_default();
    status.notes.iter().for_each(|note| also(&format!("noticed: {note}")));
    for (kind, said) in [
        ("failed", &status.failure),
        ("diverged", &status.divergence),
        ("out of balance", &status.unbalanced),
        ("no longer a number", &status.lost),
        ("putting together", &status.baking),
    ] {
        if let Some(said) = said {
            also(&format!("{kind}: {said}"));
        }
    }
    FaultReport {
        path,
        scene: Arc::clone(cx.scene()),
        journal: cx.simulation.journal(),
        folder: cx.document.folder.clone(),
        is_example: cx.document.is_example,
        log,
        versions,
    }
}
