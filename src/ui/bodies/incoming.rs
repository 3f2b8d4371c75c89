//! A body that comes from elsewhere: what it names is read, and named as the document does.

use crate::draw::Bounds;
use crate::edit::body_ops::placed;
use crate::io::{IoError, Stages, add_models_of, path_from};
use crate::scene::{Assets, OwnedBody, Scene};
use crate::ui::gallery::{is_shipped, shipped_beside, shipped_bytes};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// A body from elsewhere, which names its model and the motions that it follows by whole paths or as those that ship,
/// and the document that it is to go into.
#[derive(Clone, Debug)]
pub(crate) struct Incoming {
    /// The body.
    pub body: OwnedBody,
    /// The box around it where it stands [m], unless it is of a model.
    pub bounds: Bounds,
    /// The models that the document has.
    pub known: Arc<Assets>,
    /// Folder from which the document names them.
    pub folder: PathBuf,
    /// Whether models that ship keep their names, and are put down where the document is saved; otherwise they are put
    /// beside its file at once.
    pub keeps_shipped: bool,
}

/// Such a body as the document has it.
pub(crate) struct Brought {
    /// The body.
    pub body: OwnedBody,
    /// The box around it where it stands [m].
    pub bounds: Bounds,
    /// The document's models, with those that it names.
    pub models: Assets,
    /// Whether any of them ships and keeps its name.
    pub ships: bool,
}

impl Incoming {
    /// Whether it names anything that ships.
    pub(super) fn names_shipped(&self) -> bool {
        let mut body = self.body.clone();
        body.view_mut().into_model_paths().into_iter().any(|path| !Path::new(path.as_str()).is_absolute())
    }

    /// Reads what it names, unless the document has it; `progress` hears what is being worked on and breaks it off.
    ///
    /// # Errors
    /// What cannot be read, or put beside the document's file.
    pub(crate) fn bring(mut self, progress: &mut Stages<'_>) -> Result<Brought, IoError> {
        let mut ships = false;
        for path in self.body.view_mut().into_model_paths() {
            *path = named(path, &self.folder, self.keeps_shipped, &mut ships)?;
        }
        let mut alone = Scene::new("");
        match &self.body {
            OwnedBody::Solid(body) => alone.bodies.push((**body).clone()),
            OwnedBody::TwoLayer(body) => alone.two_layer.push((**body).clone()),
        }
        let shipped = |path: &Path| shipped_bytes(path.strip_prefix(&self.folder).ok()?.to_str()?).filter(|_| ships);
        let mut models = (*self.known).clone();
        add_models_of(&mut models, &alone, &self.folder, &shipped, progress)?;
        let body = self.body.view();
        let around = body.model().and_then(|model| models.solid(model)).and_then(|solid| {
            let corners = Bounds { min: solid.min, max: solid.max }.corners();
            Bounds::of(corners.map(|at| placed(body.placement(), at)))
        });
        Ok(Brought { bounds: around.unwrap_or(self.bounds), body: self.body, models, ships })
    }
}

/// The name that a document has for what is named by a whole path or as one of those that ship.
fn named(path: &str, folder: &Path, keeps_shipped: bool, ships: &mut bool) -> Result<String, IoError> {
    let whole = Path::new(path);
    if whole.is_absolute() {
        return Ok(path_from(folder, whole));
    }
    if !is_shipped(path) {
        return Err(IoError::Missing.within(whole));
    }
    if keeps_shipped {
        *ships = true;
        return Ok(path.to_owned());
    }
    shipped_beside(folder, path)
}
