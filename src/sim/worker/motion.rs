//! What moves, and what is shown of it: the live run and its ghost, what was recorded of them, and a comparison.

mod ahead;
mod hands;
mod looking;
mod publishing;

use super::build::guarded;
use super::comparison::ComparedRuns;
use super::grabs::PointerGrab;
use super::playback::Playback;
use super::replay::Replaying;
use super::runs::Runs;
use super::shared::Outlet;
use super::stop::Stop;
use super::time_series_set::TimeSeriesSet;
use super::views::ViewRequests;
use crate::bake::Baked;
use crate::scene::{Assets, Scene};
use crate::sim::command::SimCommand;
use crate::sim::journal::{Asked, Journal};
use crate::sim::recording::RecordedFrame;
use crate::sim::runner::Runner;
use crate::sim::side_by_side::SideBySide;
use crate::sim::status::Status;
use crate::sim::taken::TakenMotion;
use std::sync::Arc;
use std::time::{Duration, Instant};

/// A frame that takes longer is one that a person waits for.
const NOTICEABLE: Duration = Duration::from_millis(100);

/// The motion of a document's world.
pub(super) struct Motion {
    /// What was put together last.
    scene: Arc<Scene>,
    pub(super) runs: Runs,
    grab: PointerGrab,
    pub(super) replay: Replaying,
    pub(super) comparison: ComparedRuns,
    views: ViewRequests,
    playback: Playback,
    pub(super) status: Status,
    outlet: Outlet,
    /// Ends the frame that is being computed.
    stop: Stop,
    /// Frames that were asked for and ended by what came meanwhile: they follow.
    owed: u32,
    /// How long the last frame took; none where it was ended, and of a scene of which none has been computed.
    took: Option<Duration>,
}

impl Motion {
    /// Of nothing yet.
    pub(super) fn new(scene: Arc<Scene>, playing: bool, outlet: Outlet, stop: Stop) -> Self {
        Self {
            scene,
            runs: Runs::default(),
            grab: PointerGrab::default(),
            replay: Replaying::default(),
            comparison: ComparedRuns::default(),
            views: ViewRequests::default(),
            playback: Playback::new(playing),
            status: Status::default(),
            outlet,
            stop,
            owed: 0,
            took: None,
        }
    }

    /// Does what concerns the motion; other commands change the document or what is put together of it.
    pub(super) fn handle(&mut self, command: &SimCommand) {
        self.leave_ahead_for(command);
        match *command {
            SimCommand::Compute(seconds) => self.compute_ahead(seconds),
            SimCommand::Play => {
                self.note(Asked::Play);
                self.owed = 0;
                self.replay.set_goes_on(true);
                self.playback.play();
            }
            SimCommand::Pause => {
                self.note(Asked::Pause);
                self.owed = 0;
                self.replay.hold(&mut self.playback);
            }
            SimCommand::Step => self.step(),
            SimCommand::Speed(speed) => {
                self.note(Asked::Speed(speed));
                self.playback.set_speed(speed);
            }
            SimCommand::Grab { body, vertex, target } => self.grab(body, vertex, target),
            SimCommand::MoveGrab(target) => self.move_grab(target),
            SimCommand::Release => self.release(),
            SimCommand::PinGrab => self.pin_grab(),
            SimCommand::Unpin { body, grab } => self.unpin(body, grab),
            SimCommand::ReleaseAll => self.release_all(),
            SimCommand::Strike { body, impulse } => self.strike(body, impulse),
            SimCommand::Lead { body, ref drive, aim } => self.lead(body, drive, aim),
            SimCommand::Field(kind) => self.views.choose_field(kind),
            SimCommand::Tension(on) => self.views.choose_tension(on),
            SimCommand::Activation(on) => self.views.choose_activation(on),
            SimCommand::Show(time) => self.show(self.replay.recording().nearest(time)),
            SimCommand::StepBack => match self.replay.recording().before(self.shown_time()) {
                None => self.replay.hold(&mut self.playback),
                earlier => self.show(earlier),
            },
            SimCommand::Replay => self.start_replay(),
            SimCommand::ContinueHere => {
                self.continue_here();
                self.playback.play();
            }
            SimCommand::Live => self.replay.return_to_live(&mut self.playback),
            SimCommand::Memory(limit) => self.limit_memory(limit),
            SimCommand::Reset
            | SimCommand::Edit(_)
            | SimCommand::Open(..)
            | SimCommand::Compare { .. }
            | SimCommand::Ghost(_)
            | SimCommand::Take(_) => {}
        }
    }

    /// Whether frame follows frame.
    fn is_running(&self) -> bool {
        let moves = |runner: &Runner| self.comparison.is_running() || !runner.all_stopped();
        self.playback.is_playing() && (self.replay.is_active() || self.runs.live.runner().is_some_and(moves))
    }

    /// Whether a frame follows for which nobody would want to wait, as far as is known.
    pub(super) fn may_take_long(&self) -> bool {
        (self.owes() || self.is_running()) && !self.replay.is_active() && self.took.is_none_or(|took| took > NOTICEABLE)
    }

    /// Whether a frame that was asked for is still to be computed. While an earlier one is shown it waits.
    fn owes(&self) -> bool {
        self.owed > 0 && !self.replay.is_active() && self.runs.live.runner().is_some()
    }

    /// When the next frame is due; none while no frame follows.
    pub(super) fn due(&self) -> Option<Instant> {
        if self.owes() { Some(Instant::now()) } else { self.is_running().then(|| self.playback.due()) }
    }

    /// Computes or shows the next frame if it is due; whether it was.
    pub(super) fn advance_if_due(&mut self) -> bool {
        if self.owes() {
            self.pay();
            return true;
        }
        if !self.is_running() {
            self.playback.rest();
            return false;
        }
        if !self.playback.is_due() {
            return false;
        }
        if self.advance() {
            self.playback.plan_next(self.frame_seconds());
            self.show_what_was_ahead();
        }
        true
    }

    /// One frame that was asked for; it is still owed where something that waits ended it.
    fn pay(&mut self) {
        if self.advance() {
            self.owed -= 1;
        }
    }

    /// One frame, of the live run or of a replay; false where something that waits ended it.
    pub(super) fn advance(&mut self) -> bool {
        if self.replay.is_active() {
            self.replay.advance(self.runs.live.runner().is_some(), &mut self.playback);
        } else {
            let begun = Instant::now();
            let is_whole = self.solve();
            // How long one that was ended would have taken is not known.
            self.took = is_whole.then(|| begun.elapsed());
            if !is_whole {
                return false;
            }
        }
        self.playback.count_frame(self.frame_seconds());
        true
    }

    /// False where something that waits ended it: nothing has changed then.
    fn solve(&mut self) -> bool {
        let seconds = self.frame_seconds();
        let is_compared = self.comparison.is_running();
        let stop = self.stop.of_frame();
        let before = self.runs.stored();
        let Self { runs, comparison, .. } = self;
        let solved = guarded(|| {
            if is_compared { comparison.advance_unless(seconds, &stop) } else { runs.live.advance_unless(&stop) }
        });
        let mut is_whole = solved.unwrap_or_else(|problem| {
            // What the world holds after a panic cannot be trusted; the document and the last picture can.
            self.runs.live.give_up();
            self.playback.set_playing(false);
            self.status.failure = Some(problem);
            true
        });
        if is_whole && !is_compared {
            is_whole = self.runs.advance_ghost(&stop).unwrap_or_else(|problem| {
                self.note_no_ghost(&problem);
                true
            });
            if is_whole {
                if let Some(runner) = self.runs.live.runner() {
                    self.outlet.with_journal(|journal| journal.push_frame(runner.world()));
                }
                self.record();
                self.record_series();
            } else {
                self.runs.go_back(before);
            }
        }
        is_whole
    }

    /// Notes in the journal what is asked.
    fn note(&self, what: Asked) {
        self.outlet.with_journal(|journal| journal.push(what));
    }

    /// Begins a new journal: the motion starts anew.
    fn begin_journal(&self) {
        self.outlet.with_journal(|journal| *journal = Journal::new(Arc::clone(&self.scene)));
    }

    /// Takes up a scene that was put together: from its start, or in the present motion.
    pub(super) fn take_up(&mut self, scene: Arc<Scene>, mut baked: Baked, keeps_motion: bool) {
        self.leave_ahead();
        // After a failure there is none to be kept.
        let goes_on = keeps_motion && self.runs.live.runner().is_some();
        self.scene = scene;
        self.took = None;
        if goes_on {
            self.note(Asked::Edit(Arc::clone(&self.scene)));
        } else {
            self.begin_journal();
        }
        let thin = std::mem::take(&mut baked.thin);
        baked.notes.sort_by_key(|note| note.warning);
        self.status.warns = baked.notes.last().is_some_and(|note| note.warning);
        self.status.notes = baked.notes.iter().map(ToString::to_string).collect();
        self.status.failure = None;
        self.runs.live.take_up(Runner::new(baked), thin, keeps_motion);
        if !keeps_motion {
            self.record_anew();
        }
    }

    /// Ends the ghost that is no longer wanted; gives the scene of the one that is wanted in its place, to be put
    /// together. While an earlier frame is shown all waits.
    pub(super) fn replace_ghost(&mut self) -> Option<Arc<Scene>> {
        if self.replay.is_active() {
            return None;
        }
        let scene = self.runs.ghost.replace()?;
        self.outlet.with_series(|series| series.ghost = None);
        Some(scene)
    }

    /// Says why there is no ghost.
    pub(super) fn note_no_ghost(&mut self, problem: &str) {
        self.status.notes.push(format!("There is no ghost: {problem}"));
        self.status.warns = true;
    }

    /// Compares what was put together, from the live run on: an earlier frame that is looked at is left.
    pub(super) fn compare(&mut self, runs: SideBySide) {
        self.leave_ahead();
        self.replay.return_to_live(&mut self.playback);
        self.comparison.start(runs);
    }

    /// Nothing is left of the last document; what is done from now on is done to this scene.
    pub(super) fn forget(&mut self, scene: Arc<Scene>) {
        self.leave_ahead();
        self.scene = scene;
        self.begin_journal();
        self.grab.pin();
        self.owed = 0;
        self.comparison.choose(Vec::new(), 0.0);
        self.replay.clear(&mut self.playback);
        self.outlet.with_series(|series| *series = TimeSeriesSet::default());
        self.runs = Runs::default();
        self.status.divergence = None;
        self.status.lost = None;
        self.status.unbalanced = None;
        self.status.bodies.clear();
        self.status.measures.clear();
    }

    /// What is kept of the scene as it was put together last, to be written; none where that has failed.
    pub(super) fn taken(&self, scene: &Arc<Scene>, assets: &Arc<Assets>) -> Option<TakenMotion> {
        let start = Arc::clone(self.runs.live.start()?);
        let kept = self.replay.recording().of_last_build().filter(|frame| frame.world.is_of(&start));
        let frames = kept.map(|frame| Arc::clone(&frame.world)).collect();
        Some(TakenMotion::new(Arc::clone(scene), Arc::clone(assets), start, frames))
    }

    /// Back to the start, the ghost too, with nothing held; false where the scene has not been put together yet.
    pub(super) fn restart(&mut self) -> bool {
        self.leave_ahead();
        self.grab.pin();
        self.owed = 0;
        self.views.forget_ranges();
        let is_built = self.runs.restart();
        if is_built {
            self.status.failure = None;
            self.begin_journal();
            self.record_anew();
        }
        is_built
    }

    /// To the next frame; where there is none it is computed.
    fn step(&mut self) {
        self.replay.hold(&mut self.playback);
        let has_live = self.runs.live.runner().is_some();
        if self.replay.step(has_live) {
            return;
        }
        if has_live {
            self.replay.leave();
        } else {
            self.continue_here();
        }
        self.note(Asked::Step);
        self.owed += 1;
        self.pay();
    }

    /// Time of what is shown [s].
    fn shown_time(&self) -> f64 {
        // After a failure there is no live run, but what was kept before it.
        self.shown().map_or(f64::INFINITY, |runner| runner.world().time())
    }

    fn frame_seconds(&self) -> f64 {
        self.shown().map_or(1.0, |runner| runner.world().plan().frame_seconds)
    }

    /// The run that is shown: at an earlier frame, or the live one.
    fn shown(&self) -> Option<&Runner> {
        self.replay.shown().or(self.runs.live.runner())
    }

    /// Keeps the present state as a frame.
    fn record(&mut self) {
        let [Some(stored), ghost] = self.runs.stored() else { return };
        let Some(runner) = self.runs.live.runner() else { return };
        let number = self.outlet.with_journal(|journal| journal.frames());
        self.replay.record(RecordedFrame::new(stored, runner, ghost, self.grab.body(), number));
    }

    /// Nothing is kept but the start.
    fn record_anew(&mut self) {
        self.replay.clear(&mut self.playback);
        self.record();
    }

    /// Writes the numbers of the present frame.
    pub(super) fn record_series(&self) {
        let [live, ghost] = [self.runs.live.runner(), self.runs.ghost.runner()].map(|run| run.map(Runner::world));
        self.outlet.with_series(|series| series.record(live, ghost));
    }
}
