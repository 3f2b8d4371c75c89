//! What somebody needs who looks for a fault, as plain data, and the archive that it is written as.

use super::gallery::shipped_bytes;
use crate::io::{Archive, IoError, Stages, scene_to_json};
use crate::scene::Scene;
use crate::sim::Journal;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// All that goes into the archive, as it was when it was asked for.
#[derive(Clone, Debug)]
pub(crate) struct FaultReport {
    /// The archive.
    pub(crate) path: PathBuf,
    /// The document.
    pub(super) scene: Arc<Scene>,
    /// What was done to its motion.
    pub(super) journal: Journal,
    /// The folder from which its scenes name their models.
    pub(super) folder: PathBuf,
    /// Whether these came with the program.
    pub(super) is_example: bool,
    /// What was said.
    pub(super) log: String,
    /// Of program, system and driver.
    pub(super) versions: String,
}

impl FaultReport {
    /// Writes the archive; none where it was no longer wanted. Gives what could not go along.
    ///
    /// # Errors
    /// A file that cannot be read or written.
    pub(crate) fn write(self, progress: &mut Stages<'_>) -> Result<Option<Vec<String>>, IoError> {
        if progress("Gathering the scene, its models and what was done").is_break() {
            return Ok(None);
        }
        let mut archive = Archive::default();
        let scene = self.in_archive(&self.scene, &mut archive);
        archive.add("scene.json", scene_to_json(&scene).into_bytes());
        let journal = self.journal.clone();
        let journal = journal.with_scenes(|scene| Ok::<_, IoError>(self.in_archive(scene, &mut archive)))?;
        archive.add_json("recording.journal.json", &journal)?;
        archive.add("log.txt", self.log.clone().into_bytes());
        let missing: Vec<String> = archive.missing().iter().map(|what| format!("not in here: {what}\n")).collect();
        archive.add("versions.txt", format!("{}{}", self.versions, missing.concat()).into_bytes());
        let missing = archive.missing().to_vec();
        Ok(archive.write(&self.path, progress)?.then_some(missing))
    }

    /// A scene as it stands in the archive, whose models go there.
    fn in_archive(&self, scene: &Scene, archive: &mut Archive) -> Scene {
        let mut scene = scene.clone();
        for path in scene.model_paths_mut() {
            let given = if self.is_example { shipped_bytes(path) } else { None };
            let source = if given.is_some() { Path::new(path.as_str()).to_owned() } else { self.folder.join(&*path) };
            *path = archive.add_model(&source, given);
        }
        scene
    }
}
