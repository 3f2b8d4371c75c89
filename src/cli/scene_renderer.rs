//! The making of pictures.

use super::CliError;
use super::picture::{Look, ThemeName, Viewpoint};
use crate::draw::{Bounds, Display, Subject, Theme, draw};
use crate::render::{Camera, Facing, GifPictures, Offscreen, Picture};
use crate::scene::Scene;
use crate::solver::snapshot::Snapshot;

/// Makes pictures of a scene, all from the same point of view.
pub(super) struct SceneRenderer {
    offscreen: Offscreen,
    camera: Camera,
    display: Display,
    theme: Theme,
    aspect: f64,
    bounds: Option<Bounds>,
    gifs: GifPictures,
}

impl SceneRenderer {
    /// Opens a driver, and looks at the scene as it starts.
    ///
    /// # Errors
    /// [`CliError::Render`] where there is no driver, or none for pictures of this size.
    pub(super) fn open(look: &Look, scene: &Scene, start: &Snapshot) -> Result<Self, CliError> {
        let camera = match look.view {
            Viewpoint::Front => Camera::facing(Facing::Front),
            Viewpoint::Side => Camera::facing(Facing::Side),
            Viewpoint::Top => Camera::facing(Facing::Top),
            Viewpoint::Persp => Camera::perspective(),
        };
        let display = match (look.x_ray, look.particles) {
            (true, _) => Display::x_ray(),
            (_, true) => Display::particles(),
            _ => Display::default(),
        };
        let display = Display { slice: look.slice.map(|slice| slice.0), ..display };
        let theme = match look.theme {
            ThemeName::Light => Theme::light(),
            ThemeName::Dark => Theme::dark(),
        };
        let [width, height] = look.size.0.map(f64::from);
        let offscreen = Offscreen::new(look.size.0)?;
        let mut renderer = Self {
            offscreen,
            camera,
            display,
            theme,
            aspect: width / height,
            bounds: None,
            gifs: GifPictures::default(),
        };
        renderer.take_in(scene, start);
        Ok(renderer)
    }

    /// Steps back far enough to see this state too, beside all that was to be seen before.
    pub(super) fn take_in(&mut self, scene: &Scene, snapshot: &Snapshot) {
        let list = draw(&Subject { scene, snapshot, ghost: None }, &self.display, &self.theme);
        self.bounds = match (self.bounds, list.bounds) {
            (Some(a), Some(b)) => Some(a.union(b)),
            (a, b) => a.or(b),
        };
        if let Some(bounds) = &self.bounds {
            self.camera.frame(bounds, self.aspect);
        }
    }

    /// A picture.
    ///
    /// # Errors
    /// [`CliError::Render`].
    pub(super) fn picture(&mut self, scene: &Scene, snapshot: &Snapshot) -> Result<ScenePicture, CliError> {
        let list = draw(&Subject { scene, snapshot, ghost: None }, &self.display, &self.theme);
        Ok(ScenePicture(self.offscreen.draw(list, &self.camera)?))
    }

    /// A picture as a GIF file, to be shown for so long [s/100] after those that were made so before.
    ///
    /// # Errors
    /// [`CliError::Render`].
    pub(super) fn gif(&mut self, picture: &ScenePicture, delay: u16) -> Result<Vec<u8>, CliError> {
        Ok(self.gifs.next(&picture.0, delay)?)
    }
}

/// A picture of a scene.
pub(super) struct ScenePicture(Picture);

impl ScenePicture {
    /// As a PNG file.
    ///
    /// # Errors
    /// [`CliError::Render`].
    pub(super) fn png(&self) -> Result<Vec<u8>, CliError> {
        Ok(self.0.to_png()?)
    }
}
