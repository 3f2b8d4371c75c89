//! Pictures of a run's frames: one by one as PNG files, and all in one as moving pictures.

use super::{SceneRenderer, TransferError, Written};
use crate::io::{FrameFolder, MovingFormat, MovingPicture, PictureAs, make_folder};
use crate::scene::Scene;
use crate::sim::Runner;
use crate::solver::snapshot::Snapshot;
use std::path::Path;
#[cfg(feature = "gui")]
use std::path::PathBuf;

/// Where pictures go.
pub(crate) struct Pictures {
    renderer: SceneRenderer,
    single: Option<FrameFolder>,
    moving: Vec<MovingPicture>,
}

impl Pictures {
    /// PNG files in the folder `single`, the first of them of frame `first`, and moving pictures in a folder, in which
    /// a frame lasts `seconds` [s].
    ///
    /// # Errors
    /// A folder that cannot be written.
    pub(super) fn create(
        renderer: SceneRenderer,
        (single, first): (Option<&Path>, u64),
        (moving, formats): (Option<&Path>, &[MovingFormat]),
        seconds: f64,
    ) -> Result<Self, TransferError> {
        let single = single.map(|folder| FrameFolder::numbered(folder, "frame", "png", first)).transpose()?;
        let mut pictures = Self { renderer, single, moving: Vec::new() };
        if let Some(folder) = moving {
            make_folder(folder)?;
            let all = formats.iter().map(|&format| MovingPicture::new(format, format.file(folder), seconds));
            pictures.moving = all.collect();
        }
        Ok(pictures)
    }

    /// One moving picture, in the format by which its name ends, or else the first that there is.
    #[cfg(feature = "gui")]
    pub(crate) fn moving(renderer: SceneRenderer, path: PathBuf, seconds: f64) -> Self {
        let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
        let named = MovingFormat::ALL.iter().find(|(name, _)| name.eq_ignore_ascii_case(ending));
        let (_, format) = *named.unwrap_or(&MovingFormat::ALL[0]);
        Self { renderer, single: None, moving: vec![MovingPicture::new(format, path, seconds)] }
    }

    /// Turns the camera about what it looks at [rad].
    #[cfg(feature = "gui")]
    pub(crate) fn turn(&mut self, by: f64) {
        self.renderer.turn(by);
    }

    /// Takes a picture of a run as it stands.
    ///
    /// # Errors
    /// A picture that cannot be made, a file that cannot be written.
    pub(crate) fn push(&mut self, scene: &Scene, runner: &Runner) -> Result<(), TransferError> {
        let snapshot = self.renderer.seen(runner)?;
        self.push_state(scene, &snapshot)
    }

    /// Takes a picture of a state.
    ///
    /// # Errors
    /// As [`Pictures::push`].
    pub(crate) fn push_state(&mut self, scene: &Scene, snapshot: &Snapshot) -> Result<(), TransferError> {
        let wanted: Vec<PictureAs> = self.moving.iter_mut().map(MovingPicture::next_frame).collect();
        if self.single.is_none() && wanted.iter().all(|as_what| *as_what == PictureAs::Nothing) {
            return Ok(());
        }
        let picture = self.renderer.picture(scene, snapshot)?;
        let png = if self.single.is_some() || wanted.contains(&PictureAs::Png) { picture.png()? } else { Vec::new() };
        if let Some(single) = &mut self.single {
            single.push(|out| out.write_all(&png))?;
        }
        for (moving, as_what) in self.moving.iter_mut().zip(wanted) {
            match as_what {
                PictureAs::Png => moving.push(&png)?,
                PictureAs::Gif(delay) => moving.push(&self.renderer.gif(&picture, delay)?)?,
                PictureAs::Nothing => {}
            }
        }
        Ok(())
    }

    /// What was written.
    pub(crate) fn written(&self) -> Vec<Written> {
        let single = self.single.as_ref().filter(|single| single.frames() > 0).map(|single| Written {
            what: format!("{} pictures", single.frames()),
            path: single.folder().to_owned(),
            left_over: single.left_over(),
        });
        let moving = self.moving.iter().filter_map(MovingPicture::written);
        let moving = moving.map(|(what, path)| Written { what, path: path.to_owned(), left_over: 0 });
        single.into_iter().chain(moving).collect()
    }
}
