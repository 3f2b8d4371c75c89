//! What a window is told of a running world.

use crate::bake::ThinPlaces;
use crate::scene::IntegratorKind;
use crate::solver::body::Body;
use crate::solver::measure::MeasureValue;
use crate::solver::shared_drive::SharedDrive;
use crate::solver::snapshot::Snapshot;
use crate::solver::world::World;
use glam::DVec3;
use std::sync::Arc;

/// The state of the simulation beside its picture.
#[derive(Clone, Debug, Default)]
pub struct Status {
    /// Whether time runs.
    pub playing: bool,
    /// From when until when [s] is being computed ahead, if anything is.
    pub ahead: Option<[f64; 2]>,
    /// Simulated time [s].
    pub time: f64,
    /// Simulated frames a wall second.
    pub frames_per_second: f64,
    /// Simulated over wall time.
    pub real_time_factor: f64,
    /// How each body is stepped, in the order of the scene.
    pub bodies: Vec<Stepping>,
    /// Material particles of all bodies.
    pub particles: usize,
    /// Why a body was stopped.
    pub divergence: Option<String>,
    /// What can no longer be drawn, as it is no number.
    pub lost: Option<String>,
    /// What gained energy that nothing gave it, the last of it.
    pub unbalanced: Option<String>,
    /// Why there is no world: the scene cannot be put together, or the solver failed.
    pub failure: Option<String>,
    /// What was noticed while the scene was put together; what should be acted on comes last.
    pub notes: Vec<String>,
    /// Whether the last of them should be.
    pub warns: bool,
    /// What is being put together just now, and how far that has come.
    pub baking: Option<String>,
    /// Whether the last change was not put together, as somebody stopped that: what was there before goes on. A reset
    /// or the next change puts the scene together.
    pub stopped: bool,
    /// Present values of the scene's measures.
    pub measures: Vec<MeasureValue>,
    /// Document edits taken over so far, so that a window knows whether its last one has arrived.
    pub edits: u64,
    /// What is kept of the motion.
    pub recording: RecordingStatus,
    /// The drives that parts of bodies share, body by body.
    pub drives: Vec<DriveStatus>,
}

/// A drive that parts of a body share.
#[derive(Clone, Debug, PartialEq)]
pub struct DriveStatus {
    /// Index of the body.
    pub body: usize,
    /// Its identifier among the body's.
    pub id: String,
    /// Its present value; of a wave along fibres, where they begin.
    pub value: f64,
    /// Its least and its greatest value.
    pub limits: [f64; 2],
    /// Whether a hand holds it.
    pub is_led: bool,
}

impl Status {
    /// Reads what a world that is shown has to say.
    pub(super) fn read(&mut self, world: &World) {
        let plan = world.plan();
        let stepping = |(body, count): (&Body, &u32)| Stepping {
            name: body.parts().name.clone(),
            integrator: body.parts().integrator_word,
            integrator_reason: body.parts().integrator_reason.clone(),
            dt: body.parts().dt,
            stable_dt: body.parts().stable_dt,
            limited_by: body.parts().limited_by.clone(),
            substeps: count * plan.outer_steps,
            particle_volume: body.particle_volume(),
        };
        self.time = world.time();
        self.bodies = world.bodies().iter().zip(&plan.substeps).map(stepping).collect();
        self.particles = world.bodies().iter().map(|body| body.state().len()).sum();
        self.divergence = world.divergence().map(ToString::to_string);
        self.unbalanced = world.unbalanced().last().map(ToString::to_string);
        self.measures = world.measures();
        let time = world.time();
        let bodies = world.bodies().iter().enumerate();
        let shared = bodies.flat_map(|(body, of)| of.shared_drives().iter().map(move |shared| (body, shared)));
        let status = |(body, SharedDrive { id, drive }): (usize, &SharedDrive)| DriveStatus {
            body,
            id: id.to_string(),
            value: drive.at(time).0,
            limits: [drive.least(), drive.greatest()],
            is_led: drive.hand().is_some_and(|hand| hand.holds()),
        };
        self.drives = shared.map(status).collect();
    }
}

/// What is kept of the motion so far, and what is seen of it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RecordingStatus {
    /// Times of the first and the last frame [s]; none where nothing is kept.
    pub span: Option<[f64; 2]>,
    /// Number of frames.
    pub frames: usize,
    /// Numbers, as their times count them, of the first and the last frame of the scene as it was put together last;
    /// none where there is none.
    pub numbers: Option<[u64; 2]>,
    /// Whether an earlier frame is shown, not what the simulation has come to.
    pub in_replay: bool,
    /// Whether the frame that is shown was computed before the scene was last put together: what goes on from it is the
    /// present scene in the motion of that frame.
    pub of_another_scene: bool,
    /// Memory taken [bytes].
    pub bytes: usize,
    /// Memory that may be taken [bytes]; the oldest frames are dropped for new ones.
    pub limit: usize,
    /// Times of the last frames before the scene was put together anew [s].
    pub edits: Vec<f64>,
    /// Times of frames in which fibres broke or seams began to tear [s].
    pub breaks: Vec<f64>,
    /// How often the simulation continued from an earlier frame, and what is to be said of the last time.
    pub continued: (u64, String),
}

/// How a body is stepped.
#[derive(Clone, Debug, PartialEq)]
pub struct Stepping {
    /// Name a person reads.
    pub name: String,
    /// The integrator's word, as in scene files.
    pub integrator: &'static str,
    /// Why it was chosen, where the scene leaves that open and it is not the usual one.
    pub integrator_reason: Option<String>,
    /// Time step [s].
    pub dt: f64,
    /// Greatest stable time step that was measured [s].
    pub stable_dt: f64,
    /// JSON pointer of the parameter that sets that; none where no single one does.
    pub limited_by: Option<String>,
    /// Steps in a frame.
    pub substeps: u32,
    /// Volume of a material particle at rest [m³]; none of a two-layer body.
    pub particle_volume: Option<f64>,
}

/// One of the runs that are compared side by side.
#[derive(Clone, Debug, PartialEq)]
pub struct ComparedRun {
    /// Its integrator.
    pub integrator: IntegratorKind,
    /// Greatest step that the integrator is estimated to take [s].
    pub stable_dt: f64,
    /// When it blew up [s].
    pub blew_up_at: Option<f64>,
    /// By how much of the most energy that it handled it gained at the most, where that is more than all of it.
    pub gained: Option<f64>,
    /// Bodies of the snapshot that are its own; the runs follow each other.
    pub bodies: usize,
    /// What is plotted.
    pub sample: ComparedSample,
}

/// What is plotted of a run at one time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ComparedSample {
    /// Simulated time [s].
    pub time: f64,
    /// Total energy [J].
    pub energy: f64,
    /// Linear momentum [kg m/s].
    pub momentum: f64,
    /// Volume [m³] or area [m²] of the first two-layer body.
    pub volume: Option<f64>,
    /// Pressure of the gas in it [Pa], in 2D for each metre of depth.
    pub pressure: Option<f64>,
}

/// A point at which a grab stays pinned.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PinnedPoint {
    /// Index of its body.
    pub body: usize,
    /// Its place among what pulls at the body.
    pub grab: usize,
    /// Where it is [m], world.
    pub at: DVec3,
    /// Where it is pulled to [m], world.
    pub target: DVec3,
}

/// A picture of the world and what is to be said about it.
#[derive(Clone, Debug, Default)]
pub struct Published {
    /// Positions.
    pub snapshot: Snapshot,
    /// The scene that runs in step, where there is one; not while runs are compared.
    pub ghost: Option<Snapshot>,
    /// Every body at rest in its model frame; the same one until the scene is put together again.
    pub at_rest: Arc<Snapshot>,
    /// Where each body is thinner than its particles resolve, as far as a note tells of it; the same places until the
    /// scene is put together again.
    pub thin: Arc<[ThinPlaces]>,
    /// Opposite corners of the box around all bodies where the scene places them [m], world; none without a body.
    pub placed: Option<[DVec3; 2]>,
    /// Particles that each constraint of each body holds, its pins last; the same ones until the scene is put together
    /// again.
    pub held: Arc<[Vec<Vec<u32>>]>,
    /// Points at which grabs stay pinned, as they are shown.
    pub pinned: Vec<PinnedPoint>,
    /// The rest.
    pub status: Status,
    /// Runs that are compared; the snapshot shows them side by side then. Empty where none are.
    pub compared: Vec<ComparedRun>,
}
