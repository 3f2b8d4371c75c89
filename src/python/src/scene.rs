//! Scenes: read, looked into and changed by pointers.

use crate::error::refused;
use crate::json::{text_of, value_of};
use pyo3::exceptions::PyKeyError;
use pyo3::prelude::*;
use sinew::io::{apply_sets, load_scene, save_scene, scene_from_json, scene_to_json};
use std::path::{Path, PathBuf};

/// A scene. `scene[pointer]` is what an RFC 6901 pointer leads to, and `scene[pointer] = value` replaces it, as `--set`
/// of the command line does; a value that the scene cannot have raises ValueError and leaves it as it was.
#[pyclass(module = "sinew")]
pub(crate) struct Scene {
    pub(crate) scene: sinew::scene::Scene,
    /// What paths of models are relative to.
    pub(crate) folder: PathBuf,
}

/// Reads a scene from a file.
#[pyfunction]
pub(crate) fn load(path: PathBuf) -> PyResult<Scene> {
    let scene = load_scene(&path).map_err(refused)?;
    Ok(Scene { scene, folder: path.parent().unwrap_or(Path::new("")).to_owned() })
}

/// Reads a scene from text; paths of its models are relative to a folder, the present one unless given.
#[pyfunction]
#[pyo3(signature = (text, folder = None))]
pub(crate) fn from_json(text: &str, folder: Option<PathBuf>) -> PyResult<Scene> {
    Ok(Scene { scene: scene_from_json(text).map_err(refused)?, folder: folder.unwrap_or_default() })
}

#[pymethods]
impl Scene {
    /// Name of the scene.
    #[getter]
    fn name(&self) -> &str {
        &self.scene.name
    }

    fn __getitem__<'py>(&self, py: Python<'py>, pointer: &str) -> PyResult<Bound<'py, PyAny>> {
        let whole = serde_json::to_value(&self.scene).map_err(refused)?;
        let found = whole.pointer(pointer).ok_or_else(|| PyKeyError::new_err(pointer.to_owned()))?;
        value_of(py, found)
    }

    fn __setitem__(&mut self, pointer: &str, value: &Bound<'_, PyAny>) -> PyResult<()> {
        let text = text_of(value)?;
        self.scene = apply_sets(&self.scene, [(pointer, text.as_str())]).map_err(refused)?;
        Ok(())
    }

    /// A copy that can be changed by itself.
    fn copy(&self) -> Self {
        Self { scene: self.scene.clone(), folder: self.folder.clone() }
    }

    /// The scene as text, as its file has it.
    fn to_json(&self) -> String {
        scene_to_json(&self.scene)
    }

    /// Writes the scene to a file, wholly or not at all.
    fn save(&self, path: PathBuf) -> PyResult<()> {
        save_scene(&path, &self.scene).map_err(refused)
    }

    fn __repr__(&self) -> String {
        format!("<sinew.Scene {:?}, {} bodies>", self.scene.name, self.scene.all_bodies().count())
    }
}
