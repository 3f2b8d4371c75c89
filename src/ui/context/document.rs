//! The open document: the scene with its history, its file and the models that it names.

use crate::edit::Editor;
use crate::scene::{Assets, Scene};
use crate::ui::document::Document;
use std::path::PathBuf;
use std::sync::Arc;

/// The document that is edited.
pub(crate) struct OpenDocument {
    /// The scene and what can be undone.
    pub editor: Editor,
    /// Its file; none before it was saved.
    pub path: Option<PathBuf>,
    /// Folder from which the scene names its models.
    pub folder: PathBuf,
    /// The models that it names.
    pub assets: Arc<Assets>,
    /// Whether it is an example, whose models lie in no folder.
    pub is_example: bool,
}

impl OpenDocument {
    /// A document as it was read.
    pub(crate) fn new(document: Document) -> Self {
        let Document { scene, assets, path, folder, .. } = document;
        Self { editor: Editor::new(scene), path, folder, assets, is_example: false }
    }

    /// The scene as it is now.
    pub(crate) fn scene(&self) -> &Arc<Scene> {
        self.editor.scene()
    }

    /// What people call it.
    pub(crate) fn name(&self) -> &str {
        self.scene().title()
    }
}
