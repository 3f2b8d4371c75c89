//! What was asked of a world from outside, frame by frame: with it a motion is made again from its scene, bit for bit.
//!
//! Only what moves the world counts for that: what is grabbed, struck and edited. Whether time ran and how fast is
//! noted for who reads it. A motion that goes on from an earlier frame has never been where it was after that, and one
//! that is put back to its start begins a new journal.

use super::command::SimCommand;
use super::report::state_hash;
use crate::scene::Scene;
use crate::solver::world::World;
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// The journal of a motion.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Journal {
    /// Version of the program that wrote it: the bits of another one may differ.
    pub program: String,
    /// The scene that the motion started from.
    #[serde(with = "shared")]
    pub scene: Arc<Scene>,
    /// What was asked, in order.
    pub asked: Vec<JournalEntry>,
    /// Hash of the state after every frame, equal only for equal bits; to be compared on one machine.
    pub hashes: Vec<String>,
    /// How much of it has been told to who keeps it as it grows.
    #[serde(skip)]
    pub(super) told: Told,
}

/// How much of a journal has been told. No part of what it holds: any two are equal.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Told {
    /// Whether the start was.
    pub(super) has_begun: bool,
    /// Whether something that was told is no longer so.
    pub(super) goes_back: bool,
    /// How much of what was asked, and how many frames.
    pub(super) asked: usize,
    pub(super) frames: usize,
}

impl PartialEq for Told {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

impl Told {
    /// All is told.
    pub(super) fn all(&mut self, asked: usize, frames: usize) {
        *self = Self { has_begun: true, goes_back: false, asked, frames };
    }

    /// Only so much still holds.
    fn back_to(&mut self, asked: usize, frames: usize) {
        self.goes_back |= asked < self.asked || frames < self.frames;
        (self.asked, self.frames) = (self.asked.min(asked), self.frames.min(frames));
    }
}

/// Something that was asked.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct JournalEntry {
    /// Frames that had been computed before it.
    pub frame: u64,
    /// What.
    pub what: Asked,
}

/// What can be asked of a moving world.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Asked {
    /// Time was let run.
    Play,
    /// Time was held.
    Pause,
    /// One frame was asked for.
    Step,
    /// So much simulated for each second was aimed at.
    Speed(f64),
    /// The scene was changed, and the motion went on.
    Edit(#[serde(with = "shared")] Arc<Scene>),
    /// A point of a body was taken hold of.
    Grab {
        /// Index of the body.
        body: usize,
        /// Vertex of its skin, or particle where it has none.
        vertex: usize,
        /// Where it was pulled to [m], world.
        target: [f64; 3],
    },
    /// What was held was pulled to another place [m], world.
    MoveGrab([f64; 3]),
    /// What was held was let go.
    Release,
    /// What was held was left pinned there.
    PinGrab,
    /// A pinned point was let go.
    Unpin {
        /// Index of the body.
        body: usize,
        /// Its place among what pulled at the body.
        grab: usize,
    },
    /// All was let go.
    ReleaseAll,
    /// A hand led a drive that parts of a body share.
    Lead {
        /// Index of the body.
        body: usize,
        /// Identifier of the drive.
        drive: String,
        /// To which value; none let go of it.
        aim: Option<f64>,
    },
    /// A whole body was struck.
    Strike {
        /// Index of the body.
        body: usize,
        /// Impulse [N s], world.
        impulse: [f64; 3],
    },
}

impl Asked {
    /// The request that does it again; none for what only concerned the clock.
    pub(super) fn command(&self) -> Option<SimCommand> {
        Some(match *self {
            Self::Play | Self::Pause | Self::Step | Self::Speed(_) => return None,
            Self::Edit(ref scene) => SimCommand::Edit(Arc::clone(scene)),
            Self::Grab { body, vertex, target } => SimCommand::Grab { body, vertex, target: target.into() },
            Self::MoveGrab(target) => SimCommand::MoveGrab(target.into()),
            Self::Release => SimCommand::Release,
            Self::PinGrab => SimCommand::PinGrab,
            Self::Unpin { body, grab } => SimCommand::Unpin { body, grab },
            Self::ReleaseAll => SimCommand::ReleaseAll,
            Self::Lead { body, ref drive, aim } => SimCommand::Lead { body, drive: drive.clone(), aim },
            Self::Strike { body, impulse } => SimCommand::Strike { body, impulse: impulse.into() },
        })
    }
}

impl Journal {
    /// Of a motion that starts now.
    pub(super) fn new(scene: Arc<Scene>) -> Self {
        let program = env!("CARGO_PKG_VERSION").to_owned();
        Self { program, scene, asked: Vec::new(), hashes: Vec::new(), told: Told::default() }
    }

    /// Has all of it told once more, from its start.
    #[cfg_attr(not(feature = "gui"), allow(dead_code, reason = "the window is who keeps journals"))]
    pub(super) fn tell_anew(&mut self) {
        self.told = Told::default();
    }

    /// Frames that have been computed.
    pub fn frames(&self) -> u64 {
        self.hashes.len() as u64
    }

    /// Every scene in it: that of the start and those that it was changed to.
    pub fn scenes(&self) -> impl Iterator<Item = &Arc<Scene>> {
        let edits = self.asked.iter().filter_map(|entry| match &entry.what {
            Asked::Edit(scene) => Some(scene),
            _ => None,
        });
        std::iter::once(&self.scene).chain(edits)
    }

    /// With other scenes in place of its own.
    ///
    /// # Errors
    /// The first that `other` gives.
    #[cfg(feature = "gui")]
    pub(crate) fn with_scenes<E>(mut self, mut other: impl FnMut(&Scene) -> Result<Scene, E>) -> Result<Self, E> {
        self.scene = Arc::new(other(&self.scene)?);
        for entry in &mut self.asked {
            if let Asked::Edit(scene) = &mut entry.what {
                *scene = Arc::new(other(scene)?);
            }
        }
        Ok(self)
    }

    /// Whether hands have led any shared drive.
    pub(super) fn was_performed(&self) -> bool {
        self.asked.iter().any(|entry| matches!(entry.what, Asked::Lead { aim: Some(_), .. }))
    }

    /// Notes what is asked now. Of the places to which something is pulled or led between two frames only the last
    /// counts.
    pub(super) fn push(&mut self, what: Asked) {
        let frame = self.frames();
        let is_like = |last: &Asked| match (&what, last) {
            (Asked::MoveGrab(_), Asked::MoveGrab(_)) => true,
            (Asked::Lead { body, drive, .. }, Asked::Lead { body: of, drive: old, .. }) => (body, drive) == (of, old),
            _ => false,
        };
        if let Some(last) = self.asked.last_mut()
            && is_like(&last.what)
            && last.frame == frame
        {
            last.what = what;
            self.told.back_to(self.asked.len() - 1, self.hashes.len());
            return;
        }
        self.asked.push(JournalEntry { frame, what });
    }

    /// Notes that a frame has come to this.
    pub(super) fn push_frame(&mut self, world: &World) {
        self.hashes.push(state_hash(world.bodies()));
    }

    /// Back to where so many frames had been computed and nothing asked since.
    pub(super) fn go_back(&mut self, frames: u64) {
        self.hashes.truncate(frames as usize);
        self.asked.retain(|entry| entry.frame < frames);
        self.told.back_to(self.asked.len(), self.hashes.len());
    }
}

/// Scenes that are shared in memory and written each for itself.
mod shared {
    use crate::scene::Scene;
    use serde::{Deserialize, Deserializer, Serialize, Serializer};
    use std::sync::Arc;

    pub(super) fn serialize<S: Serializer>(scene: &Arc<Scene>, to: S) -> Result<S::Ok, S::Error> {
        Scene::serialize(scene, to)
    }

    pub(super) fn deserialize<'de, D: Deserializer<'de>>(from: D) -> Result<Arc<Scene>, D::Error> {
        Scene::deserialize(from).map(Arc::new)
    }
}
