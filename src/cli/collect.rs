//! `sinew collect`: a scene and its models in one folder, to be moved, copied or sent.

use super::error::printable;
use super::output::wrote;
use super::prepare::{Sets, folder_of, load, tell};
use super::{CliError, Console, Outcome};
use crate::io::{collect_scene, is_model};
use crate::scene::one_line;
use clap::Args;
use std::path::PathBuf;

/// Arguments of `sinew collect`.
#[derive(Debug, Args)]
pub struct Collect {
    /// Scene file, or a model
    scene: PathBuf,
    #[command(flatten)]
    sets: Sets,
    /// Folder for the scene and its models; nothing that is there is written over
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
}

/// Puts the scene, its models and the files that these name into the folder.
///
/// # Errors
/// A scene or model that cannot be read, before anything is written; a file that cannot be written.
pub(super) fn run(args: &Collect, console: &mut Console) -> Result<Outcome, CliError> {
    let loaded = load(Some(&args.scene), &args.sets, None, console)?;
    tell(loaded.made(), console);
    let mut name = args.scene.clone();
    if is_model(&args.scene) {
        name.set_extension("json");
    }
    let name = name.file_name().unwrap_or_default();
    let collected = collect_scene(&loaded.scene, folder_of(Some(&args.scene)), name, &args.out)?;
    for (model, names) in &collected.missing {
        let names: Vec<String> = names.iter().map(|name| format!("{:?}", one_line(name))).collect();
        console.warn(&format!(
            "{}: it names files that are not there and so did not go along: {}; find them, or do without",
            printable(model),
            names.join(", ")
        ));
    }
    console.print(&wrote(&format!("the scene with {} models", collected.models), &collected.scene))?;
    Ok(Outcome::Done)
}
