//! Pictures of a run's frames: one by one as PNG files, and all in one as moving pictures.

use super::motion::warn_of_left_over;
use super::{CliError, Console, SceneRenderer, output};
use crate::io::{FrameFolder, MovingFormat, MovingPicture, PictureAs, make_folder};
use crate::scene::Scene;
use crate::solver::snapshot::Snapshot;
use std::path::Path;

/// Where pictures go.
pub(super) struct Pictures {
    renderer: SceneRenderer,
    single: Option<FrameFolder>,
    moving: Vec<MovingPicture>,
}

impl Pictures {
    /// PNG files in the folder `single`, the first of them of frame `first`, and moving pictures in a folder, in which a frame
    /// lasts `seconds` [s].
    ///
    /// # Errors
    /// A folder that cannot be written.
    pub(super) fn create(
        renderer: SceneRenderer,
        single: Option<&Path>,
        moving: Option<(&Path, &[MovingFormat])>,
        first: u64,
        seconds: f64,
    ) -> Result<Self, CliError> {
        let single = single.map(|folder| FrameFolder::numbered(folder, "frame", "png", first)).transpose()?;
        let mut pictures = Self { renderer, single, moving: Vec::new() };
        if let Some((folder, formats)) = moving.filter(|(_, formats)| !formats.is_empty()) {
            make_folder(folder)?;
            let all = formats.iter().map(|&format| MovingPicture::new(format, format.file(folder), seconds));
            pictures.moving = all.collect();
        }
        Ok(pictures)
    }

    /// Takes the next picture.
    ///
    /// # Errors
    /// A picture that cannot be made, a file that cannot be written.
    pub(super) fn push(&mut self, scene: &Scene, snapshot: &Snapshot) -> Result<(), CliError> {
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

    /// A line about what was written.
    pub(super) fn written(&self, console: &mut Console) -> String {
        let mut text = String::new();
        if let Some(single) = self.single.as_ref().filter(|single| single.frames() > 0) {
            text += &output::wrote(&format!("{} pictures", single.frames()), single.folder());
            warn_of_left_over(single.folder(), single.left_over(), console);
        }
        for (what, path) in self.moving.iter().filter_map(MovingPicture::written) {
            text += &output::wrote(&what, path);
        }
        text
    }
}
