//! `sinew make-pictures`: the pictures of the window's galleries, made anew. What they show is run and drawn by the
//! program itself; the same code gives the same pictures on the same driver.

mod demos;
#[cfg(feature = "render")]
mod examples;
#[cfg(feature = "render")]
mod gallery;

pub use demos::{Demo, demo};

use super::{CliError, Console, Outcome};
use clap::Args;
use std::path::PathBuf;

/// Arguments of `sinew make-pictures`.
#[derive(Debug, Args)]
#[cfg_attr(not(feature = "render"), allow(dead_code, reason = "without pictures none of it is used"))]
pub struct MakePictures {
    /// Folder to write to: patterns/ and examples/ in it
    folder: PathBuf,
    /// Folder of the scenes
    #[arg(long, value_name = "DIR", default_value = "scenes")]
    scenes: PathBuf,
    /// Only those whose names begin like this
    #[arg(long, value_name = "NAME", default_value = "")]
    only: String,
}

/// Makes a strip of every pattern and a picture of every scene.
///
/// # Errors
/// No driver, a scene that cannot be used, or a file that cannot be written.
#[cfg(feature = "render")]
pub(crate) fn run(args: &MakePictures, console: &mut Console) -> Result<Outcome, CliError> {
    use super::output;
    use crate::io::make_folder;
    use crate::sketch::pattern::PATTERNS;

    let [patterns, scenes] = ["patterns", "examples"].map(|name| args.folder.join(name));
    make_folder(&patterns)?;
    make_folder(&scenes)?;
    let mut made = |path: PathBuf, picture: Vec<u8>| -> Result<(), CliError> {
        output::write_bytes(&path, &picture)?;
        console.print(&output::wrote(&format!("{} bytes", picture.len()), &path))
    };
    for pattern in PATTERNS.iter().filter(|pattern| pattern.id.starts_with(&args.only)) {
        if let Some(demo) = demo(pattern)? {
            made(patterns.join(format!("{}.png", pattern.id)), gallery::strip(&demo)?)?;
        }
    }
    for example in examples::EXAMPLES.iter().filter(|example| example.name.starts_with(&args.only)) {
        made(scenes.join(format!("{}.png", example.name)), gallery::picture(example, &args.scenes)?)?;
    }
    Ok(Outcome::Done)
}

/// Says that no pictures can be made.
///
/// # Errors
/// [`CliError::NoPictures`].
#[cfg(not(feature = "render"))]
pub(crate) fn run(_args: &MakePictures, _console: &mut Console) -> Result<Outcome, CliError> {
    Err(CliError::NoPictures)
}
