//! The last minutes of a motion, frame by frame, in bounded memory: to be looked at again and gone on from.

use super::runner::{RunCheckpoint, Runner};
use crate::solver::body::Body;
use std::collections::VecDeque;
use std::sync::Arc;

/// Memory that a recording takes at most unless it is told otherwise [bytes].
pub const DEFAULT_MEMORY: usize = 512 << 20;

/// A state of a run, and the run's start, which has the rest data that it goes with.
pub(super) struct StoredState {
    /// The start of the scene as it was put together then.
    build: Arc<Runner>,
    state: RunCheckpoint,
}

impl StoredState {
    /// The present state of a runner that was put together as `build`.
    pub(super) fn new(build: &Arc<Runner>, runner: &Runner) -> Self {
        Self { build: Arc::clone(build), state: runner.checkpoint() }
    }

    /// Advances a runner in this state by a frame, unless `stop` says in the midst of it that it is no longer wanted:
    /// false then, and the runner is in this state again.
    pub(super) fn advance_unless(&self, runner: &mut Runner, stop: &dyn Fn() -> bool) -> bool {
        runner.advance_frame_from(&self.state, stop)
    }

    /// Whether it is one of a runner that was put together as `build`.
    pub(super) fn is_of(&self, build: &Arc<Runner>) -> bool {
        Arc::ptr_eq(&self.build, build)
    }

    /// Brings a runner of the same build to this state.
    pub(super) fn restore(&self, runner: &mut Runner) {
        runner.go_back(&self.state);
    }

    /// Brings a restored run to this state; a new one where there is none, or one of another build.
    pub(super) fn restore_into(&self, restored: &mut Option<RestoredRun>) {
        let fresh = || RestoredRun { build: Arc::clone(&self.build), runner: (*self.build).clone() };
        let run = restored.take().filter(|run| self.is_of(&run.build));
        self.restore(&mut restored.insert(run.unwrap_or_else(fresh)).runner);
    }
}

/// A run as it was at some time.
pub(super) struct RestoredRun {
    /// What it was put together as.
    pub(super) build: Arc<Runner>,
    pub(super) runner: Runner,
}

/// One frame.
pub(super) struct RecordedFrame {
    /// Simulated time [s].
    time: f64,
    /// The number of its world, as its time counts it.
    world_number: u64,
    /// The document's world; shared with who writes it to files.
    pub(super) world: Arc<StoredState>,
    /// The ghost's, where there was one.
    pub(super) ghost: Option<Arc<StoredState>>,
    /// Body whose last grab followed the pointer.
    grabbed: Option<usize>,
    /// Frames that had been computed by then, this one among them.
    pub(super) number: u64,
    /// Breaks of fibres so far, and seams that have begun to tear.
    breaks: usize,
    bytes: usize,
}

impl RecordedFrame {
    /// A frame of a world by its number, a ghost beside it and what is grabbed.
    pub(super) fn new(
        world: Arc<StoredState>,
        runner: &Runner,
        ghost: Option<Arc<StoredState>>,
        grabbed: Option<usize>,
        number: u64,
    ) -> Self {
        let bytes = |stored: &Arc<StoredState>| stored.state.bytes();
        Self {
            time: runner.world().time(),
            world_number: runner.world().number(),
            bytes: size_of::<Self>() + size_of_val(&world) + bytes(&world) + ghost.as_ref().map_or(0, bytes),
            breaks: runner.world().bodies().iter().map(broken).sum(),
            world,
            ghost,
            grabbed,
            number,
        }
    }

    /// Identifier of the body whose last grab followed the pointer.
    pub(super) fn grabbed_id(&self) -> Option<&str> {
        self.world.build.world().bodies().get(self.grabbed?).map(|body| body.parts().id.as_str())
    }

    fn builds(&self) -> [Option<&Arc<Runner>>; 2] {
        [Some(&self.world.build), self.ghost.as_ref().map(|ghost| &ghost.build)]
    }
}

/// Frames in the order of time. The oldest are dropped for new ones.
pub(super) struct Recording {
    frames: VecDeque<RecordedFrame>,
    /// Times [s] of the last frames before the scene was put together anew, and of frames in which fibres broke
    /// or seams began to tear.
    marks: [VecDeque<f64>; 2],
    /// Memory of all frames, and of what they were put together as [bytes].
    bytes: usize,
    limit: usize,
}

impl Default for Recording {
    fn default() -> Self {
        Self { frames: VecDeque::new(), marks: Default::default(), bytes: 0, limit: DEFAULT_MEMORY }
    }
}

impl Recording {
    /// Appends a frame and drops the oldest ones until all fit; even the new one where it is too large alone.
    pub(super) fn push(&mut self, frame: RecordedFrame) {
        self.bytes += frame.bytes + new_builds(&frame, self.frames.back());
        if let Some(last) = self.frames.back() {
            if !Arc::ptr_eq(&last.world.build, &frame.world.build) {
                self.marks[0].push_back(last.time);
            }
            if frame.breaks > last.breaks {
                self.marks[1].push_back(frame.time);
            }
        }
        self.frames.push_back(frame);
        self.shrink();
    }

    /// Takes at most so much memory from now on [bytes].
    pub(super) fn set_limit(&mut self, limit: usize) {
        self.limit = limit;
        self.shrink();
    }

    fn shrink(&mut self) {
        while self.bytes > self.limit {
            let Some(oldest) = self.frames.pop_front() else { return };
            self.bytes -= oldest.bytes + new_builds(&oldest, self.frames.front());
            for marks in &mut self.marks {
                while marks.front().is_some_and(|time| *time <= oldest.time) {
                    marks.pop_front();
                }
            }
        }
    }

    /// Drops every frame after one; gives how many.
    pub(super) fn drop_after(&mut self, index: usize) -> usize {
        let mut dropped = 0;
        while self.frames.len() > index + 1
            && let Some(last) = self.frames.pop_back()
        {
            self.bytes -= last.bytes + new_builds(&last, self.frames.back());
            dropped += 1;
        }
        let end = self.frames.back().map_or(f64::NEG_INFINITY, |frame| frame.time);
        for (marks, after) in self.marks.iter_mut().zip([|time: f64, end: f64| time >= end, |time, end| time > end]) {
            while marks.back().is_some_and(|time| after(*time, end)) {
                marks.pop_back();
            }
        }
        dropped
    }

    pub(super) fn clear(&mut self) {
        self.frames.clear();
        self.marks.iter_mut().for_each(VecDeque::clear);
        self.bytes = 0;
    }

    /// Number of the frame that is nearest to a time [s]; none where nothing is kept.
    pub(super) fn nearest(&self, time: f64) -> Option<usize> {
        let after = self.frames.partition_point(|frame| frame.time < time);
        let distance = |&index: &usize| self.frames.get(index).map_or(f64::INFINITY, |frame| (frame.time - time).abs());
        let last = self.frames.len().checked_sub(1)?;
        let candidates = [after.saturating_sub(1), after.min(last)];
        candidates.into_iter().min_by(|a, b| distance(a).total_cmp(&distance(b)))
    }

    /// Number of the last frame before a time [s].
    pub(super) fn before(&self, time: f64) -> Option<usize> {
        self.frames.partition_point(|frame| frame.time < time).checked_sub(1)
    }

    /// Number of the first frame after a time [s].
    pub(super) fn after(&self, time: f64) -> Option<usize> {
        let index = self.frames.partition_point(|frame| frame.time <= time);
        (index < self.frames.len()).then_some(index)
    }

    /// Number of the first frame that is kept.
    pub(super) fn first(&self) -> Option<usize> {
        (!self.frames.is_empty()).then_some(0)
    }

    pub(super) fn frame(&self, index: usize) -> Option<&RecordedFrame> {
        self.frames.get(index)
    }

    /// Number of frames.
    pub(super) fn len(&self) -> usize {
        self.frames.len()
    }

    /// Memory that is taken, and the most that may be [bytes].
    pub(super) fn memory(&self) -> [usize; 2] {
        [self.bytes, self.limit]
    }

    /// The frames of the world as it was put together last.
    pub(super) fn of_last_build(&self) -> impl ExactSizeIterator<Item = &RecordedFrame> {
        let build = self.frames.back().map(|last| &last.world.build);
        let is_earlier = |frame: &RecordedFrame| build.is_some_and(|build| !frame.world.is_of(build));
        // Every other one is before them.
        self.frames.range(self.frames.partition_point(is_earlier)..)
    }

    /// Numbers of the first and the last of these.
    pub(super) fn numbers(&self) -> Option<[u64; 2]> {
        let first = self.of_last_build().next()?;
        Some([first.world_number, self.frames.back()?.world_number])
    }

    /// Times of the first and the last frame [s].
    pub(super) fn span(&self) -> Option<[f64; 2]> {
        Some([self.frames.front()?.time, self.frames.back()?.time])
    }

    /// Times [s] at which the scene was put together anew, and at which fibres broke or seams began to tear.
    pub(super) fn marks(&self) -> [Vec<f64>; 2] {
        let [edits, breaks] = &self.marks;
        [edits, breaks].map(|marks| marks.iter().copied().collect())
    }
}

/// Breaks of a body's fibres, and its seams that have begun to tear.
fn broken(body: &Body) -> usize {
    body.breaks().count() + body.tears().iter().filter(|seam| seam.first.is_some()).count()
}

/// Memory of what a frame was put together as and its neighbour was not [bytes].
fn new_builds(frame: &RecordedFrame, neighbour: Option<&RecordedFrame>) -> usize {
    let of_neighbour = neighbour.map(RecordedFrame::builds);
    let pairs = frame.builds().into_iter().zip(of_neighbour.unwrap_or_default());
    let fresh = pairs.filter_map(|(build, other)| {
        let build = build?;
        let same = other.is_some_and(|other| Arc::ptr_eq(build, other));
        (!same).then(|| build.world().bytes())
    });
    fresh.sum()
}
