//! What can be asked of a running world. None of it is saved, none of it is undone.

use super::taken::MotionTaker;
use crate::scene::{Assets, IntegratorKind, Scene};
use crate::solver::snapshot::FieldKind;
use glam::DVec3;
use std::sync::Arc;

/// A request to the [`super::Worker`].
#[derive(Clone, Debug)]
pub enum SimCommand {
    /// Run; where an earlier frame is shown, replay from there to the last one, then go on.
    Play,
    /// Compute so much simulated time [s] from where the simulation has come to, as fast as it can be, then replay it
    /// from there. What moves the motion otherwise, or looks at it, ends that; what was computed until then is kept.
    Compute(f64),
    /// Hold still.
    Pause,
    /// Advance by one frame, then hold still; while an earlier frame is shown, show the next one.
    Step,
    /// Back to the start of the scene.
    Reset,
    /// Simulated time over wall time that is aimed at.
    Speed(f64),
    /// The document has changed: put it together again and go on from the present motion.
    Edit(Arc<Scene>),
    /// Another document and its models: put it together and start anew.
    Open(Arc<Scene>, Arc<Assets>),
    /// Take hold of a point of a body and pull it to another place.
    Grab {
        /// Index of the body.
        body: usize,
        /// Vertex of its skin, or particle where it has none.
        vertex: usize,
        /// Where to [m], world.
        target: DVec3,
    },
    /// Move what was grabbed last [m], world.
    MoveGrab(DVec3),
    /// Let go of what was grabbed last.
    Release,
    /// Leave what was grabbed last where it is held now.
    PinGrab,
    /// Let go of a point that was pinned.
    Unpin {
        /// Index of the body.
        body: usize,
        /// Its place among what pulls at the body.
        grab: usize,
    },
    /// Let go of everything that was pinned.
    ReleaseAll,
    /// Run the scene under several integrators side by side from its start, each in steps of exactly `dt` [s]; none
    /// ends the comparison.
    Compare {
        /// Which.
        integrators: Vec<IntegratorKind>,
        /// Time step [s].
        dt: f64,
    },
    /// Put a field over the bodies into every picture from now on; none for no field.
    Field(Option<FieldKind>),
    /// Put what the fibres carry into every picture from now on, or no longer.
    Tension(bool),
    /// Put what the fibres do by themselves into every picture from now on, or no longer.
    Activation(bool),
    /// Run another scene of the same models in step, from where the world is now; what is pulled or struck in one is in
    /// both. None ends it.
    Ghost(Option<Arc<Scene>>),
    /// Show the kept frame that is nearest to a simulated time [s], and hold the simulation.
    Show(f64),
    /// Show the kept frame before the one that is shown, and hold the simulation.
    StepBack,
    /// Show the kept frames from the one that is shown on, or from the first, as fast as they were meant to be, and
    /// hold at the end.
    Replay,
    /// Go on from the frame that is shown; the later ones are dropped. A grab, a strike and an edit do so, too.
    ContinueHere,
    /// Back from earlier frames to where the simulation has come to.
    Live,
    /// Memory that the kept frames may take [bytes].
    Memory(usize),
    /// Hand the motion over as it is kept, to be written meanwhile.
    Take(MotionTaker),
    /// Has a hand lead a drive that parts of a body share, from the next frame on.
    Lead {
        /// Index of the body.
        body: usize,
        /// Identifier of the drive.
        drive: String,
        /// To which value, no further than the drive goes by itself; none lets go of it.
        aim: Option<f64>,
    },
    /// Strike a whole body.
    Strike {
        /// Index of the body.
        body: usize,
        /// Impulse [N s], world.
        impulse: DVec3,
    },
}
