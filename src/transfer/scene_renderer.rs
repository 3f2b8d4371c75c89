//! The making of pictures.

use super::{Look, TransferError, Viewpoint};
use crate::draw::{Bounds, Display, Subject, Theme, draw};
use crate::render::{Camera, Facing, Offscreen};
use crate::scene::Scene;
use crate::solver::snapshot::Snapshot;

/// Makes pictures of a scene, all from the same point of view.
pub(crate) struct SceneRenderer {
    offscreen: Offscreen,
    camera: Camera,
    display: Display,
    theme: Theme,
    aspect: f64,
    bounds: Option<Bounds>,
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
        let mut renderer = Self { offscreen, camera, display, theme, aspect: width / height, bounds: None };
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

    /// A picture as a PNG file.
    ///
    /// # Errors
    /// [`TransferError::Render`].
    pub(crate) fn picture(&mut self, scene: &Scene, snapshot: &Snapshot) -> Result<Vec<u8>, TransferError> {
        let list = draw(&Subject { scene, snapshot, ghost: None }, &self.display, &self.theme);
        Ok(self.offscreen.draw(list, &self.camera)?.to_png()?)
    }
}
