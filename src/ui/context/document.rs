//! The open document: the scene with its history, its file and the models that it names.

use crate::edit::Editor;
use crate::scene::{Assets, Scene};
use crate::ui::document::Document;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// The document that is edited.
pub(crate) struct OpenDocument {
    /// The scene and what can be undone.
    pub(super) editor: Editor,
    /// Its file; none before it was saved.
    pub path: Option<PathBuf>,
    /// Folder from which the scene names its models.
    pub folder: PathBuf,
    /// The models that it names.
    assets: Arc<Assets>,
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

    /// The models that it names.
    pub(crate) fn assets(&self) -> &Arc<Assets> {
        &self.assets
    }

    /// Changes the models by what lies in its folder; not at all where that fails.
    pub(super) fn change_assets<T, E>(
        &mut self,
        change: impl FnOnce(&mut Assets, &Path) -> Result<T, E>,
    ) -> Result<T, E> {
        let mut assets = (*self.assets).clone();
        let made = change(&mut assets, &self.folder)?;
        self.assets = Arc::new(assets);
        Ok(made)
    }

    /// Whether it has changes that its file has not.
    pub(crate) fn is_changed(&self) -> bool {
        self.editor.is_changed()
    }

    /// What would be undone; none where nothing can be.
    pub(crate) fn undo_name(&self) -> Option<&str> {
        self.editor.undo_name()
    }

    /// What would be made again.
    pub(crate) fn redo_name(&self) -> Option<&str> {
        self.editor.redo_name()
    }

    /// Its file holds it now.
    pub(crate) fn mark_saved(&mut self) {
        self.editor.mark_saved();
    }

    /// Its file holds something else.
    pub(crate) fn mark_unsaved(&mut self) {
        self.editor.mark_unsaved();
    }

    /// What people call it.
    pub(crate) fn name(&self) -> &str {
        self.scene().title()
    }
}
