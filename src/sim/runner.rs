//! Fixed frames, no clock: the window and a headless run take identical steps.

use crate::bake::Baked;
use crate::solver::body::Body;
use crate::solver::measure::MeasureValue;
use crate::solver::snapshot::Snapshot;
use crate::solver::world::{Checkpoint, World};

/// Frames in a row that must look at rest: a single one may catch a swing in passing.
const REST_FRAMES: u32 = 2;

/// Advances a world frame by frame and keeps what the measures ask for over time.
#[derive(Clone)]
pub struct Runner {
    world: World,
    restful_frames: u32,
}

/// What a runner goes on from.
pub(super) struct RunCheckpoint {
    world: Checkpoint,
    restful_frames: u32,
}

impl RunCheckpoint {
    /// Memory that it takes [bytes].
    pub(super) fn bytes(&self) -> usize {
        self.world.bytes()
    }
}

impl Runner {
    /// A runner at the start.
    pub fn new(baked: Baked) -> Self {
        Self { world: baked.world, restful_frames: 0 }
    }

    /// Advances by one frame.
    pub fn advance_frame(&mut self) {
        self.frame_unless(&|| false);
    }

    /// Advances by one frame, unless `stop` says in the midst of it that it is no longer wanted: false then, and all is
    /// as it was before, bit for bit. It is asked before every step of a body.
    pub fn advance_frame_unless(&mut self, stop: &dyn Fn() -> bool) -> bool {
        let before = self.checkpoint();
        self.advance_frame_from(&before, stop)
    }

    /// [`Self::advance_frame_unless`] from a checkpoint of the present state.
    pub(super) fn advance_frame_from(&mut self, present: &RunCheckpoint, stop: &dyn Fn() -> bool) -> bool {
        let is_whole = self.frame_unless(stop);
        if !is_whole {
            self.go_back(present);
        }
        is_whole
    }

    /// Advances by one frame; false, half way, where `stop` ended it.
    pub(crate) fn frame_unless(&mut self, stop: &dyn Fn() -> bool) -> bool {
        let _frame = tracing::info_span!("frame", number = self.world.frame()).entered();
        let is_whole = self.world.advance_frame_unless(stop);
        if is_whole {
            self.restful_frames = if self.world.at_rest() { self.restful_frames + 1 } else { 0 };
        }
        is_whole
    }

    /// What the run goes on from.
    pub(super) fn checkpoint(&self) -> RunCheckpoint {
        RunCheckpoint { world: self.world.checkpoint(), restful_frames: self.restful_frames }
    }

    /// Back to a checkpoint of this run, or of another of the same start.
    pub(super) fn go_back(&mut self, to: &RunCheckpoint) {
        self.world.go_back(&to.world);
        self.restful_frames = to.restful_frames;
    }

    /// Goes on with the motion of `before`, a runner of the same scene before an edit.
    pub fn adopt(&mut self, before: &Self) {
        self.world.adopt(&before.world);
    }

    /// One body, to grab it.
    pub fn body_mut(&mut self, index: usize) -> Option<&mut Body> {
        self.world.body_mut(index)
    }

    /// The place of the body of this identifier.
    pub(super) fn find(&self, id: &str) -> Option<usize> {
        self.world.bodies().iter().position(|body| body.parts().id == id)
    }

    /// Has a hand lead a drive that parts of a body share, over the frame that comes next, to a value, no further than
    /// the drive ever goes by itself, and hold it there; or let go of it. False where there is no such drive.
    pub fn lead(&mut self, body: usize, drive: &str, aim: Option<f64>) -> bool {
        self.world.lead(body, drive, aim)
    }

    /// Lets go of everything that is grabbed.
    pub fn release_all(&mut self) {
        for index in 0..self.world.bodies().len() {
            if let Some(body) = self.world.body_mut(index) {
                body.grabs_mut().clear();
            }
        }
    }

    /// Whether anything is grabbed.
    pub(crate) fn is_held(&self) -> bool {
        self.world.bodies().iter().any(|body| !body.grabs().is_empty())
    }

    /// The world as it stands.
    pub fn world(&self) -> &World {
        &self.world
    }

    /// Plain positions of the present state.
    pub fn snapshot(&self) -> Snapshot {
        Snapshot::of(&self.world)
    }

    /// As [`Runner::snapshot`], without the positions of skins.
    pub fn particles(&self) -> Snapshot {
        Snapshot::of_particles(&self.world)
    }

    /// Looks at the balance of energy and work once more: for the end of a run, see [`World::look`].
    pub fn look(&mut self) {
        self.world.look();
    }

    /// Whether everything has come to rest and stayed so.
    pub fn at_rest(&self) -> bool {
        self.restful_frames >= REST_FRAMES
    }

    /// Whether nothing is left to simulate because every body was stopped.
    pub fn all_stopped(&self) -> bool {
        let bodies = self.world.bodies();
        !bodies.is_empty() && bodies.iter().all(|body| body.divergence().is_some())
    }

    /// Number of frames that reach `seconds`.
    pub fn frames_for(&self, seconds: f64) -> u64 {
        (seconds / self.world.plan().frame_seconds - 1e-9).ceil().max(0.0) as u64
    }

    /// What a report gives of each measure: its last value or its peak.
    pub fn reported_measures(&self) -> Vec<MeasureValue> {
        self.world.reported_measures()
    }
}
