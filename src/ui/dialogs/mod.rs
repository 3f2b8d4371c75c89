//! What opens over the window: the palette, the help, the request for a path, questions, the examples.

mod answer;
mod dialog;
mod first_scene;
mod palette;
mod path;
mod show;

pub(crate) use answer::Answer;
pub(crate) use dialog::{Dialog, PathPurpose};
pub(crate) use show::show;
