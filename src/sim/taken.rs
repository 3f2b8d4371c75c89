//! A motion that is handed over to be written while the simulation goes on: its start, to be computed anew, and what is
//! kept of it.

use super::recording::{RestoredRun, StoredState};
use super::runner::Runner;
use crate::scene::{Assets, Scene};
use std::collections::VecDeque;
use std::sync::Arc;
use std::sync::mpsc::Sender;

/// A scene that was put together, and the frames that are kept of it since.
#[derive(Clone)]
pub(crate) struct TakenMotion {
    scene: Arc<Scene>,
    assets: Arc<Assets>,
    start: Arc<Runner>,
    frames: VecDeque<Arc<StoredState>>,
}

impl TakenMotion {
    /// Of a scene and its models, put together as `start`.
    pub(super) fn new(
        scene: Arc<Scene>,
        assets: Arc<Assets>,
        start: Arc<Runner>,
        frames: VecDeque<Arc<StoredState>>,
    ) -> Self {
        Self { scene, assets, start, frames }
    }

    /// The scene and its models.
    pub(crate) fn scene(&self) -> (&Arc<Scene>, &Assets) {
        (&self.scene, &self.assets)
    }

    /// Its start.
    pub(crate) fn start(&self) -> &Runner {
        &self.start
    }

    /// The kept frames, one after the other; each is let go of as the next is asked for.
    pub(crate) fn into_frames(self) -> TakenFrames {
        TakenFrames { frames: self.frames, restored: None }
    }
}

/// Frames that were kept.
pub(crate) struct TakenFrames {
    frames: VecDeque<Arc<StoredState>>,
    restored: Option<RestoredRun>,
}

impl TakenFrames {
    /// The run at the next frame; none behind the last.
    pub(crate) fn next(&mut self) -> Option<&Runner> {
        let frame = self.frames.pop_front()?;
        frame.restore_into(&mut self.restored);
        self.restored.as_ref().map(|restored| &restored.runner)
    }
}

/// Who asked for a motion; none is sent where there is no world.
#[derive(Clone, Debug)]
pub struct MotionTaker(pub(crate) Sender<Option<TakenMotion>>);
