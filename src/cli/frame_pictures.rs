//! Pictures of a run's frames: one by one as PNG files, and all in one as a moving picture.

use super::motion::warn_of_left_over;
use super::{CliError, Console, SceneRenderer, output};
use crate::io::{AnimatedPng, FrameFolder, make_folder};
use crate::scene::Scene;
use crate::solver::snapshot::Snapshot;
use std::path::Path;

/// The file of a moving picture.
const ANIMATED: &str = "motion.apng";

/// Where pictures go.
pub(super) struct Pictures {
    renderer: SceneRenderer,
    single: Option<FrameFolder>,
    animated: Option<AnimatedPng>,
}

impl Pictures {
    /// PNG files in the folder `single`, the first of them of frame `first`, and a moving picture in the folder `animated`, in
    /// which a frame lasts `seconds` [s].
    ///
    /// # Errors
    /// A folder that cannot be written.
    pub(super) fn create(
        renderer: SceneRenderer,
        single: Option<&Path>,
        animated: Option<&Path>,
        first: u64,
        seconds: f64,
    ) -> Result<Self, CliError> {
        let single = single.map(|folder| FrameFolder::numbered(folder, "frame", "png", first)).transpose()?;
        animated.map_or(Ok(()), make_folder)?;
        let animated = animated.map(|folder| AnimatedPng::new(folder.join(ANIMATED), seconds));
        Ok(Self { renderer, single, animated })
    }

    /// Takes the next picture.
    ///
    /// # Errors
    /// A picture that cannot be made, a file that cannot be written.
    pub(super) fn push(&mut self, scene: &Scene, snapshot: &Snapshot) -> Result<(), CliError> {
        let picture = self.renderer.picture(scene, snapshot)?;
        if let Some(single) = &mut self.single {
            single.push(|out| out.write_all(&picture))?;
        }
        self.animated.as_mut().map_or(Ok(()), |animated| animated.push(&picture))?;
        Ok(())
    }

    /// A line about what was written.
    pub(super) fn written(&self, console: &mut Console) -> String {
        let mut text = String::new();
        if let Some(single) = self.single.as_ref().filter(|single| single.frames() > 0) {
            text += &output::wrote(&format!("{} pictures", single.frames()), single.folder());
            warn_of_left_over(single.folder(), single.left_over(), console);
        }
        if let Some(animated) = self.animated.as_ref().filter(|animated| animated.pictures() > 0) {
            text += &output::wrote(&format!("a moving picture of {} frames", animated.pictures()), animated.path());
        }
        text
    }
}
