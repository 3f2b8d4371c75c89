//! What can be asked of a running world. None of it is saved, none of it is undone.

use crate::scene::{Assets, IntegratorKind, Scene};
use crate::solver::snapshot::FieldKind;
use glam::DVec3;
use std::sync::Arc;

/// A request to the [`super::Worker`].
#[derive(Clone, Debug)]
pub enum SimCommand {
    /// Run.
    Play,
    /// Hold still.
    Pause,
    /// Advance by one frame, then hold still.
    Step,
    /// Back to the start of the scene.
    Reset,
    /// Simulated time over wall time that is aimed at.
    Speed(f64),
    /// The document has changed: put it together again and go on from the present motion.
    Edit(Arc<Scene>),
    /// Another document and its models: put it together and start anew.
    Open(Arc<Scene>, Arc<Assets>),
    /// Pull on a point of a body.
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
    /// Let go of everything that was pinned.
    ReleaseAll,
    /// Run the scene under several integrators side by side from its start, each in steps of exactly `dt` [s]; none ends
    /// the comparison.
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
    /// Run another scene of the same models in step, from where the world is now; what is pulled or struck in one is in
    /// both. None ends it.
    Ghost(Option<Arc<Scene>>),
    /// Strike a whole body.
    Strike {
        /// Index of the body.
        body: usize,
        /// Impulse [N s], world.
        impulse: DVec3,
    },
}
