//! What can open over the window, as plain data.

use crate::ui::ahead::AheadQuestion;
use crate::ui::autosave::Question;
use crate::ui::bodies::Layers;
use crate::ui::loading::Loading;
use crate::ui::next::Next;
use crate::ui::patterns::PatternQuestion;
use crate::ui::preferences::Preferences;
use crate::ui::transfer::TransferQuestion;
use std::path::{Path, PathBuf};
use std::sync::mpsc::Receiver;

/// What a path is asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum PathPurpose {
    /// To open a scene.
    Open,
    /// To add a model to the scene.
    Add(Layers),
    /// To save the scene.
    Save,
    /// To write the time series as a table.
    Export,
    /// To write the recording of this number of those that were left behind.
    Recording(usize),
    /// To write what a report of a fault needs.
    Report,
    /// To add a model as a collider.
    Collider,
    /// To have the active body follow a motion.
    Follow,
}

/// What is open over the window.
pub(crate) enum Dialog {
    /// Finds an action by its name.
    Palette {
        /// What has been typed.
        text: String,
        /// Which of the matches would be taken.
        chosen: usize,
    },
    /// Lists keys and gestures.
    Help,
    /// Asks how much is to be computed ahead.
    Ahead(AheadQuestion),
    /// Asks how the window is to be.
    Preferences(Preferences),
    /// Tells how a first scene is made.
    FirstScene,
    /// Asks for a path.
    Path {
        /// What for.
        purpose: PathPurpose,
        /// What has been typed.
        text: String,
        /// The desktop's own dialog, when it is open.
        browsing: Option<Receiver<Option<PathBuf>>>,
        /// What is gone on to after saving.
        next: Option<Next>,
    },
    /// Asks what is to become of the document or its file.
    Question(Question),
    /// Shows the scenes that ship.
    Examples,
    /// Shows how far a document that is being read has come.
    Loading(Loading),
    /// Asks about a person's own patterns.
    Pattern(PatternQuestion),
    /// Asks about what leaves the window for other programs, or comes from them.
    Transfer(TransferQuestion),
}

impl Dialog {
    /// The palette, with nothing typed.
    pub(crate) fn palette() -> Self {
        Self::Palette { text: String::new(), chosen: 0 }
    }

    /// A request for a path, beginning with the present one.
    pub(crate) fn path(purpose: PathPurpose, present: Option<&Path>) -> Self {
        let usual = if matches!(purpose, PathPurpose::Add(_)) { "model.obj" } else { "scene.json" };
        let text = present.map_or_else(|| usual.to_owned(), |path| path.display().to_string());
        Self::Path { purpose, text, browsing: None, next: None }
    }

    /// A request for a path after which is gone on to something else.
    #[must_use]
    pub(crate) fn then(self, next: Option<Next>) -> Self {
        match self {
            Self::Path { purpose, text, browsing, .. } => Self::Path { purpose, text, browsing, next },
            other => other,
        }
    }
}
