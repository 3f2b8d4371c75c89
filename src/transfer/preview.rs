//! What will be written, told beforehand.

use super::{Format, FrameChoice};
use crate::export::BodySize;
use crate::io::is_there;
use std::path::Path;

/// What will be written in a format.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct FormatPreview {
    /// Name of the format.
    pub(crate) name: &'static str,
    /// Files, as they are told.
    pub(crate) files: Vec<String>,
    /// What it does not hold.
    pub(crate) left_out: Vec<&'static str>,
    /// Why the motion cannot be written in it.
    pub(crate) refused: Option<String>,
}

/// What will be written of bodies of these sizes, format by format.
pub(crate) fn preview(formats: &[Format], bodies: &[BodySize], frames: FrameChoice) -> Vec<FormatPreview> {
    let chosen = Format::all().filter(|(_, format)| formats.contains(format));
    let each = chosen.map(|(name, format)| match format {
        Format::Motion(format) => {
            let outline = format.outline(bodies, &frames.numbers());
            let refused = outline.refused.map(|error| error.to_string());
            FormatPreview { name, files: outline.files, left_out: outline.left_out, refused }
        }
        Format::Picture(format) => FormatPreview {
            name,
            files: vec![format.file(Path::new("")).display().to_string()],
            left_out: Vec::new(),
            refused: None,
        },
    });
    each.collect()
}

/// How many files of a folder would be replaced.
pub(crate) fn replaced(formats: &[Format], folder: &Path, bodies: &[BodySize], frames: FrameChoice) -> usize {
    let of = |format: &Format| match format {
        Format::Motion(format) => format.replaced(folder, bodies, &frames.numbers()),
        Format::Picture(format) => usize::from(is_there(&format.file(folder))),
    };
    formats.iter().map(of).sum()
}
