//! Pictures of a run's frames: one by one as PNG files, and all in one as a moving picture.

use super::{SceneRenderer, TransferError, Written};
use crate::io::{AnimatedPng, FrameFolder, make_folder};
use crate::scene::Scene;
use crate::solver::snapshot::Snapshot;
use std::path::Path;

/// A format of moving pictures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum MovingPicture {
    /// Animated PNG.
    Apng,
}

impl MovingPicture {
    /// All of them, by their names.
    pub(crate) const ALL: [(&'static str, Self); 1] = [("apng", Self::Apng)];

    /// The file that it is written to unless another one is named.
    pub(crate) fn file(self) -> &'static str {
        match self {
            Self::Apng => "motion.apng",
        }
    }
}

/// Where pictures go.
pub(crate) struct Pictures {
    renderer: SceneRenderer,
    single: Option<FrameFolder>,
    animated: Vec<AnimatedPng>,
}

impl Pictures {
    /// PNG files in the folder `single`, the first of them of frame `first`, and moving pictures in the folder `animated`, in
    /// which a frame lasts `seconds` [s].
    ///
    /// # Errors
    /// A folder that cannot be written.
    pub(super) fn create(
        renderer: SceneRenderer,
        (single, first): (Option<&Path>, u64),
        (animated, formats): (Option<&Path>, &[MovingPicture]),
        seconds: f64,
    ) -> Result<Self, TransferError> {
        let single = single.map(|folder| FrameFolder::numbered(folder, "frame", "png", first)).transpose()?;
        animated.map_or(Ok(()), make_folder)?;
        let file = |folder: &Path| {
            formats.iter().map(|format| AnimatedPng::new(folder.join(format.file()), seconds)).collect()
        };
        Ok(Self { renderer, single, animated: animated.map_or_else(Vec::new, file) })
    }

    /// Takes the next picture.
    ///
    /// # Errors
    /// A picture that cannot be made, a file that cannot be written.
    pub(super) fn push(&mut self, scene: &Scene, snapshot: &Snapshot) -> Result<(), TransferError> {
        let picture = self.renderer.picture(scene, snapshot)?;
        if let Some(single) = &mut self.single {
            single.push(|out| out.write_all(&picture))?;
        }
        Ok(self.animated.iter_mut().try_for_each(|animated| animated.push(&picture))?)
    }

    /// What was written.
    pub(super) fn written(&self) -> Vec<Written> {
        let single = self.single.as_ref().filter(|single| single.frames() > 0).map(|single| Written {
            what: format!("{} pictures", single.frames()),
            path: single.folder().to_owned(),
            left_over: single.left_over(),
        });
        let animated = self.animated.iter().filter(|animated| animated.pictures() > 0).map(|animated| Written {
            what: format!("a moving picture of {} frames", animated.pictures()),
            path: animated.path().to_owned(),
            left_over: 0,
        });
        single.into_iter().chain(animated).collect()
    }
}
