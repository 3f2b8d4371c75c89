//! Motions out and lines in, as the command line and the window do it alike: which frames of a run go into which
//! formats for which program, pictures of them, and fibres as lines of other programs and back.
//!
//! [`RunFiles`] takes a run frame by frame and is the only one that writes motions; who runs it, at what pace and until
//! when, is its caller's business. Options of the command line and dialogs are their own's, too; what both offer stands
//! in tables here ([`Format`], [`Program`]).

mod behind;
mod error;
mod finite;
mod format;
mod frames;
mod inputs;
mod lines;
mod look;
#[cfg(not(feature = "render"))]
mod no_scene_renderer;
mod pictures;
#[cfg(feature = "gui")]
mod preview;
mod program;
mod run_files;
#[cfg(feature = "render")]
mod scene_renderer;
mod shapes;
mod written;

pub(crate) use error::TransferError;
pub(crate) use finite::check_finite;
pub(crate) use format::Format;
pub(crate) use frames::FrameChoice;
pub(crate) use inputs::Inputs;
pub(crate) use lines::{LineSites, LineSpace};
pub(crate) use look::{Look, Viewpoint};
#[cfg(not(feature = "render"))]
pub(crate) use no_scene_renderer::SceneRenderer;
#[cfg(feature = "gui")]
pub(crate) use pictures::Pictures;
#[cfg(feature = "gui")]
pub(crate) use preview::{FormatPreview, preview, replaced};
pub(crate) use program::Program;
pub(crate) use run_files::{Order, RunFiles};
#[cfg(feature = "render")]
pub(crate) use scene_renderer::SceneRenderer;
pub(crate) use written::Written;
