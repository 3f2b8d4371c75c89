//! What opens over the window: the palette, the help, the request for a path, questions, the examples.

mod answer;
mod dialog;
mod palette;
mod path;
mod show;

pub use answer::Answer;
pub use dialog::{Dialog, PathPurpose};
pub use show::show;
