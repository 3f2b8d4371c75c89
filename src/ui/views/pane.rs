//! One of the three views: two to draw in, one to watch.

use super::ease::Ease;
use super::kind::{PaneKind, facing};
use super::picture::ViewPicture;
use crate::render::Camera;
use crate::solver::snapshot::Snapshot;
use egui::Rect;
use glam::DVec3;
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::sync::Arc;

/// One view.
pub(crate) struct Pane {
    /// What it is for.
    pub kind: PaneKind,
    /// From where it looks.
    pub camera: Camera,
    /// Where its camera was sent, until it arrives.
    pub ease: Option<Ease>,
    /// Whether its camera has been fitted to what is there.
    pub framed: bool,
    /// Whether it has been fitted before.
    pub shown: bool,
    /// The body that its camera follows, of which scene, and where the middle of that was [m].
    pub followed: Option<(usize, Arc<Snapshot>, DVec3)>,
    /// Where it lay in the last frame.
    pub rect: Rect,
    /// What it showed in the last frame.
    pub picture: ViewPicture,
}

impl Pane {
    /// A view that has not been shown yet.
    pub(crate) fn new(kind: PaneKind) -> Self {
        let camera = match kind {
            PaneKind::Drawing(view) => Camera::facing(facing(view)),
            PaneKind::Result => Camera::perspective(),
        };
        Self {
            kind,
            camera,
            ease: None,
            framed: false,
            shown: false,
            followed: None,
            rect: Rect::NOTHING,
            picture: ViewPicture::default(),
        }
    }

    /// Sends the camera somewhere, from now on [s].
    pub(crate) fn ease_to(&mut self, to: Camera, now: f64) {
        self.ease = Some(Ease::new(self.camera, to, now));
    }
}

/// Only what a view is for is remembered: where its camera stands follows from what there is to see.
impl Serialize for Pane {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.kind.serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for Pane {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        PaneKind::deserialize(deserializer).map(Self::new)
    }
}
