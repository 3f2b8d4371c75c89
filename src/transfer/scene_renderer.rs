//! The making of pictures.

use super::{Look, TransferError, Viewpoint, check_finite};
use crate::draw::{Bounds, Display, Subject, Theme, draw};
use crate::render::{Camera, Facing, GifPictures, Offscreen, Picture};
use crate::scene::Scene;
use crate::sim::Runner;
use crate::solver::snapshot::{ActivationSnapshot, FieldKind, FieldSnapshot, Snapshot, TensionSnapshot};

/// Makes pictures of a scene, all from the same point of view.
pub(crate) struct SceneRenderer {
    offscreen: Offscreen,
    camera: Camera,
    display: Display,
    theme: Theme,
    aspect: f64,
    bounds: Option<Bounds>,
    /// By which field solids are coloured, and the upper end of its range so far.
    field: Option<(FieldKind, f64)>,
    /// The end of the range of tensions so far [N], where fibres are coloured by them.
    tension: Option<f64>,
    /// Whether they are coloured by what they do by themselves.
    activation: bool,
    gifs: GifPictures,
}

impl SceneRenderer {
    /// Opens a driver, and looks at the scene as it starts.
    ///
    /// # Errors
    /// [`TransferError::Render`] where there is no driver, or none for pictures of this size.
    pub(crate) fn open(look: &Look, scene: &Scene, start: &Snapshot) -> Result<Self, TransferError> {
        let camera = match look.view {
            Viewpoint::Front => Camera::facing(Facing::Front),
            Viewpoint::Side => Camera::facing(Facing::Side),
            Viewpoint::Top => Camera::facing(Facing::Top),
            Viewpoint::Persp => Camera::perspective(),
            #[cfg(feature = "gui")]
            Viewpoint::Placed(camera) => camera,
        };
        let [width, height] = look.size.map(f64::from);
        let offscreen = Offscreen::new(look.size)?;
        let (display, theme) = (look.display.clone(), look.theme);
        let mut renderer = Self {
            offscreen,
            camera,
            display,
            theme,
            aspect: width / height,
            bounds: None,
            field: look.field.map(|field| (field, 0.0)),
            tension: look.tension.then_some(0.0),
            activation: look.activation,
            gifs: GifPictures::default(),
        };
        #[cfg(feature = "gui")]
        if matches!(look.view, Viewpoint::Placed(_)) {
            return Ok(renderer);
        }
        renderer.take_in(scene, start);
        Ok(renderer)
    }

    /// Steps back far enough to see this state too, beside all that was to be seen before.
    pub(crate) fn take_in(&mut self, scene: &Scene, snapshot: &Snapshot) {
        let list = draw(&Subject { scene, snapshot, ghost: None }, &self.display, &self.theme);
        self.bounds = match (self.bounds, list.bounds) {
            (Some(a), Some(b)) => Some(a.union(b)),
            (a, b) => a.or(b),
        };
        if let Some(bounds) = &self.bounds {
            self.camera.frame(bounds, self.aspect);
        }
    }

    /// A run as it stands, with the colours that were asked for. Their ranges widen as they must, so that a colour
    /// hardly changes its meaning from one picture to the next.
    ///
    /// # Errors
    /// [`TransferError::NotFinite`].
    pub(crate) fn seen(&mut self, runner: &Runner) -> Result<Snapshot, TransferError> {
        let mut snapshot = runner.particles();
        check_finite(&snapshot)?;
        if let Some((kind, end)) = &mut self.field {
            let mut field = FieldSnapshot::of(runner.world(), *kind);
            *end = end.max(field.range[1]);
            field.range[1] = *end;
            snapshot.field = Some(field);
        }
        if let Some(end) = &mut self.tension {
            let mut tension = TensionSnapshot::of(runner.world());
            *end = end.max(tension.range);
            tension.range = *end;
            snapshot.tension = Some(tension);
        }
        snapshot.activation = self.activation.then(|| ActivationSnapshot::of(runner.world()));
        Ok(snapshot)
    }

    /// Turns the camera about what it looks at [rad].
    #[cfg(feature = "gui")]
    pub(crate) fn turn(&mut self, by: f64) {
        self.camera.yaw += by;
    }

    /// A picture.
    ///
    /// # Errors
    /// [`TransferError::Render`].
    pub(crate) fn picture(&mut self, scene: &Scene, snapshot: &Snapshot) -> Result<ScenePicture, TransferError> {
        let list = draw(&Subject { scene, snapshot, ghost: None }, &self.display, &self.theme);
        Ok(ScenePicture(self.offscreen.draw(list, &self.camera)?))
    }

    /// A picture as a GIF file, to be shown for so long [s/100] after those that were made so before.
    ///
    /// # Errors
    /// [`TransferError::Render`].
    pub(super) fn gif(&mut self, picture: &ScenePicture, delay: u16) -> Result<Vec<u8>, TransferError> {
        Ok(self.gifs.next(&picture.0, delay)?)
    }
}

/// A picture of a scene.
pub(crate) struct ScenePicture(Picture);

impl ScenePicture {
    /// As a PNG file.
    ///
    /// # Errors
    /// [`TransferError::Render`].
    pub(crate) fn png(&self) -> Result<Vec<u8>, TransferError> {
        Ok(self.0.to_png()?)
    }
}
