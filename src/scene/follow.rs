//! What bodies follow: the skeleton of an animated model, or a cache of points.

use super::extra::is_zero;
use super::{AfterLast, Axis, Dab, Extra, painted};
use glam::DVec3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Particles that follow a motion made elsewhere. They are bound to it once, as the body is at rest, in the model
/// frame.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Follow {
    /// Stable identifier, unique within the body.
    pub id: String,
    /// What is followed.
    pub leader: Leader,
    /// When the body begins to follow [s].
    #[serde(default)]
    pub start: f64,
    /// How long it takes then to be eased from its rest pose into that of the first frame [s]; the motion begins after
    /// that.
    #[serde(default)]
    pub pre_roll: f64,
    /// Time in the motion [s] of the frame that is the first to be played; what comes before is left out.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub from: f64,
    /// How many times as fast as it was made the motion is played.
    #[serde(default = "one")]
    pub speed: f64,
    /// What comes after the last frame.
    #[serde(default)]
    pub after: AfterLast,
    /// Which particles follow.
    #[serde(default)]
    pub select: FollowSelect,
    /// How they follow.
    #[serde(default)]
    pub hold: Hold,
    /// Painted share, one dab after the other: 1 unless painted, or 0 where what is painted alone follows. What springs
    /// pull with is multiplied by it; what is held follows from one half on.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub paint: Vec<Dab>,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

impl Follow {
    /// All particles held to a leader from the start on, without a pre-roll.
    pub fn new(id: impl Into<String>, leader: impl Into<Leader>) -> Self {
        Self {
            id: id.into(),
            leader: leader.into(),
            start: 0.0,
            pre_roll: 0.0,
            from: 0.0,
            speed: one(),
            after: AfterLast::default(),
            select: FollowSelect::default(),
            hold: Hold::default(),
            paint: Vec::new(),
            extra: Extra::new(),
        }
    }

    /// Played from this time of the motion on [s].
    #[must_use]
    pub fn with_from(self, from: f64) -> Self {
        Self { from, ..self }
    }

    /// Only the particles that are chosen so.
    #[must_use]
    pub fn with_select(self, select: FollowSelect) -> Self {
        Self { select, ..self }
    }

    /// Pulled by springs.
    #[must_use]
    pub fn with_springs(self, springs: FollowSprings) -> Self {
        Self { hold: Hold::Springs(springs), ..self }
    }

    /// Painted share at a point of the model frame [m], 0 to 1.
    pub fn share(&self, at: DVec3) -> f64 {
        let unpainted = if self.select == FollowSelect::Painted { 0.0 } else { 1.0 };
        painted(unpainted, at, &self.paint)
    }
}

/// What is followed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Leader {
    /// The joints of a skinned model, moved by one of its animations.
    Skeleton(SkeletonLeader),
    /// The vertices of a mesh, as a point cache has them frame by frame.
    Cache(CacheLeader),
}

impl From<SkeletonLeader> for Leader {
    fn from(of: SkeletonLeader) -> Self {
        Self::Skeleton(of)
    }
}

impl From<CacheLeader> for Leader {
    fn from(of: CacheLeader) -> Self {
        Self::Cache(of)
    }
}

impl Leader {
    /// The file, relative to the scene file.
    pub fn path(&self) -> &str {
        match self {
            Self::Skeleton(of) => &of.path,
            Self::Cache(of) => &of.path,
        }
    }

    /// Metres to a unit of the file, and the axis of it that points up.
    pub fn units(&self) -> (f64, Axis) {
        match self {
            Self::Skeleton(of) => (of.scale, of.up),
            Self::Cache(of) => (of.scale, of.up),
        }
    }

    /// Metres to a unit of the file, to be changed.
    pub(crate) fn scale_mut(&mut self) -> &mut f64 {
        match self {
            Self::Skeleton(of) => &mut of.scale,
            Self::Cache(of) => &mut of.scale,
        }
    }

    /// The paths of the files that it names.
    pub(crate) fn paths_mut(&mut self) -> impl Iterator<Item = &mut String> {
        let (own, rest) = match self {
            Self::Skeleton(of) => (&mut of.path, None),
            Self::Cache(of) => (&mut of.path, of.rest.as_mut()),
        };
        std::iter::once(own).chain(rest)
    }
}

/// A glTF or GLB file with a skin and an animation. Its joints are where the file shows them while the body is at rest.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SkeletonLeader {
    /// The file, relative to the scene file.
    pub path: String,
    /// Metres to a unit of the file.
    #[serde(default = "one")]
    pub scale: f64,
    /// Axis of the file that points up; it becomes Y.
    #[serde(default = "default_up")]
    pub up: Axis,
    /// Name of the animation; the first unless given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub animation: Option<String>,
    /// Joints that are followed, by their names; all unless given.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub joints: Vec<String>,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

impl SkeletonLeader {
    /// All joints of a file relative to the scene file, in metres, moved by its first animation.
    pub fn new(path: impl Into<String>) -> Self {
        Self {
            path: path.into(),
            scale: one(),
            up: default_up(),
            animation: None,
            joints: Vec::new(),
            extra: Extra::new(),
        }
    }

    /// Only the joints of these names.
    #[must_use]
    pub fn with_joints<S: Into<String>>(self, joints: impl IntoIterator<Item = S>) -> Self {
        Self { joints: joints.into_iter().map(Into::into).collect(), ..self }
    }

    /// Moved by the animation of this name.
    #[must_use]
    pub fn with_animation(self, animation: impl Into<String>) -> Self {
        Self { animation: Some(animation.into()), ..self }
    }
}

/// A PC2 or MDD file. The particles are bound to the mesh that its points are the vertices of.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct CacheLeader {
    /// The file, relative to the scene file.
    pub path: String,
    /// The model whose vertices its points are, relative to the scene file: the shape that the body is at rest. The
    /// model of the body's own shape unless given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rest: Option<String>,
    /// Metres to a unit of both files.
    #[serde(default = "one")]
    pub scale: f64,
    /// Axis of both files that points up; it becomes Y.
    #[serde(default = "default_up")]
    pub up: Axis,
    /// Frames a second of a PC2 file, which does not say; the scene's unless given. MDD files have times.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub frames_per_second: Option<f64>,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

impl CacheLeader {
    /// A file relative to the scene file, in metres, of the vertices of the model of the body's own shape.
    pub fn new(path: impl Into<String>) -> Self {
        Self {
            path: path.into(),
            rest: None,
            scale: one(),
            up: default_up(),
            frames_per_second: None,
            extra: Extra::new(),
        }
    }

    /// Of the vertices of another model, relative to the scene file.
    #[must_use]
    pub fn with_rest(self, rest: impl Into<String>) -> Self {
        Self { rest: Some(rest.into()), ..self }
    }
}

/// Which particles follow.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum FollowSelect {
    /// Every particle of the body.
    #[default]
    Everything,
    /// Those that the chosen joints hold by this much at least, 0 to 1, as the skin has it where it is nearest.
    SkinWeight(f64),
    /// Those as near as this [m] to the bones of the chosen joints, which lead from a joint to those that hang on it,
    /// or to the surface of a cache's mesh.
    Distance(f64),
    /// Those of a region.
    Region(String),
    /// Those that are painted.
    Painted,
}

/// How particles follow.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Hold {
    /// They are where the motion has them, as pins are.
    #[default]
    Hard,
    /// Springs pull them there.
    Springs(FollowSprings),
}

/// Springs from particles to where the motion has them.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct FollowSprings {
    /// Stiffness [N/m] for each kilogram of the particles: the square of the angular frequency with which they would
    /// swing about the motion alone.
    pub stiffness: f64,
    /// Damping of the velocity against the motion's, as a share of what lets them swing no more.
    #[serde(default = "half")]
    pub damping: f64,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

impl FollowSprings {
    /// Of this stiffness [N/m to the kilogram], damped by half of what lets them swing no more.
    pub fn new(stiffness: f64) -> Self {
        Self { stiffness, damping: half(), extra: Extra::new() }
    }
}

fn one() -> f64 {
    1.0
}

fn half() -> f64 {
    0.5
}

fn default_up() -> Axis {
    Axis::Y
}
