//! Elements: what a body resists with besides its matrix, fibres and sheets, without code: a measure of a few points
//! and a law.

use super::extra::is_zero;
use super::{Drive, Extra, MusclePull};
use glam::DVec3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Most elements in a body.
pub const MAX_ELEMENTS: usize = 10_000;

/// Most points of a law's table.
pub const MAX_TABLE_POINTS: usize = 1000;

/// Greatest angle by which one may want to be larger or smaller [degrees].
pub(super) const MOST_TURNED: f64 = 170.0;

/// Between which angles a bend stays that a drive turns [degrees]: a straight one has no direction in which to bend,
/// and neither has one that is folded flat.
pub(super) const BENT: [f64; 2] = [1e-6, 180.0 - 1e-6];

/// One element of a body: an energy of what a few points that ride on the material measure.
///
/// It takes no share of the material, as fibres do, and no room: several may lie on each other.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Element {
    /// Stable identifier, unique among the body's elements.
    pub id: String,
    /// Name a person reads.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub name: String,
    /// What it measures; as drawn, it is at rest.
    pub measure: ElementMeasure,
    /// Its points in the model frame [m], as many as the measure takes. Those that lie just outside of the particles
    /// are moved in.
    pub points: Vec<[f64; 3]>,
    /// What it does about it.
    pub law: ElementLaw,
    /// How it acts by itself; it only resists unless given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub activation: Option<ElementActivation>,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

impl Element {
    /// An element between points of the model frame [m].
    pub fn new(
        id: impl Into<String>,
        measure: ElementMeasure,
        points: impl IntoIterator<Item = [f64; 3]>,
        law: ElementLaw,
    ) -> Self {
        let points = points.into_iter().collect();
        Self { id: id.into(), name: String::new(), measure, points, law, activation: None, extra: Extra::new() }
    }

    /// With a name that a person reads.
    #[must_use]
    pub fn with_name(self, name: impl Into<String>) -> Self {
        Self { name: name.into(), ..self }
    }

    /// Acting by itself.
    #[must_use]
    pub fn with_activation(self, activation: ElementActivation) -> Self {
        Self { activation: Some(activation), ..self }
    }

    /// Angle between the two legs of a bend as drawn [degrees]; none of what measures something else.
    pub(super) fn drawn_bend(&self) -> Option<f64> {
        let at = |k: usize| self.points.get(k).copied().map(DVec3::from_array);
        match (self.measure, at(0), at(1), at(2)) {
            (ElementMeasure::Turn, Some(a), Some(b), Some(c)) => Some((b - a).angle_between(c - b).to_degrees()),
            _ => None,
        }
    }

    /// Least and greatest number of a drive that turns it by so many degrees where it is 1.
    pub(super) fn turn_limits(&self, degrees: f64) -> [f64; 2] {
        if degrees == 0.0 {
            return [f64::NEG_INFINITY, f64::INFINITY];
        }
        let bent = self.drawn_bend().map_or([-MOST_TURNED, MOST_TURNED], |drawn| {
            let [least, most] = BENT.map(|angle| angle - drawn);
            [least.max(-MOST_TURNED), most.min(MOST_TURNED)]
        });
        let [a, b] = bent.map(|angle| angle / degrees);
        [a.min(b), a.max(b)]
    }
}

/// What an element measures.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ElementMeasure {
    /// Distance of two points.
    Length,
    /// Angle by which the line through three points turns at the second.
    Turn,
    /// Area of the triangle of three points.
    Area,
    /// Volume of the tetrahedron of four points.
    Volume,
    /// Angle at the edge from the first point to the second between the triangles with the third and with the fourth.
    Dihedral,
    /// Angle by which the material around the second of two points is turned against that around the first, about the
    /// line between them.
    Twist,
}

impl ElementMeasure {
    /// All of them.
    pub const ALL: [Self; 6] = [Self::Length, Self::Turn, Self::Area, Self::Volume, Self::Dihedral, Self::Twist];

    /// How many points it takes.
    pub fn points(self) -> usize {
        match self {
            Self::Length | Self::Twist => 2,
            Self::Turn | Self::Area => 3,
            Self::Volume | Self::Dihedral => 4,
        }
    }

    /// Whether it is an angle; else a size.
    pub fn is_angle(self) -> bool {
        matches!(self, Self::Turn | Self::Dihedral | Self::Twist)
    }

    /// Unit of the force by which it is resisted.
    pub fn unit(self) -> &'static str {
        match self {
            Self::Length => "N",
            Self::Area => "N/m",
            Self::Volume => "Pa",
            Self::Turn | Self::Dihedral | Self::Twist => "N m",
        }
    }

    /// Its word in scene files.
    pub fn word(self) -> &'static str {
        match self {
            Self::Length => "length",
            Self::Turn => "turn",
            Self::Area => "area",
            Self::Volume => "volume",
            Self::Dihedral => "dihedral",
            Self::Twist => "twist",
        }
    }
}

/// What an element does about what it measures. Forces are in N of a length, in N/m of an area, in Pa of a volume, and
/// moments in N m of an angle; above zero they make it smaller.
///
/// They hang on s, a length, an area or a volume over that as drawn, 1 at rest; or an angle less that as drawn
/// [degrees], 0 at rest.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ElementLaw {
    /// In proportion to how far it is from rest.
    Spring(SpringLaw),
    /// The same where it is larger than at rest, and nothing where it is smaller.
    TensionOnly(SpringLaw),
    /// The pull of a muscle; the drive, from 0 to 1, excites it, all the time without one.
    Muscle(MusclePull),
    /// s and the force there, in the order of s; between two of them straight, beyond the first and the last as there.
    Table(Vec<[f64; 2]>),
}

impl ElementLaw {
    /// In proportion, by a stiffness as of [`SpringLaw`].
    pub fn spring(stiffness: f64) -> Self {
        Self::Spring(SpringLaw { stiffness, extra: Extra::new() })
    }

    /// Where it is pulled only, by a stiffness as of [`SpringLaw`].
    pub fn tension_only(stiffness: f64) -> Self {
        Self::TensionOnly(SpringLaw { stiffness, extra: Extra::new() })
    }

    /// The pull of a muscle of this greatest force, which ends where it is smaller or larger by the share 0.5, or by an
    /// angle of 0.5 rad.
    pub fn muscle(force: f64) -> Self {
        Self::Muscle(MusclePull { force, width: 0.5, extra: Extra::new() })
    }
}

/// A force in proportion.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SpringLaw {
    /// Force where a size is twice that at rest: EA [N] of a length, [N/m] of an area, [Pa] of a volume; or moment per
    /// radian [N m] of an angle.
    pub stiffness: f64,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

/// What a drive does to an element. It excites a muscle, too.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ElementActivation {
    /// What all below is multiplied by.
    pub drive: Drive,
    /// Share by which a length, an area or a volume wants to be smaller than it was drawn; with the drive from -0.5 to
    /// 0.8.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub contract: f64,
    /// By what an angle wants to be larger than it was drawn [degrees]; with the drive from -170 to 170.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub turn_degrees: f64,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

impl ElementActivation {
    /// Smaller by a share, times a drive.
    pub fn contracting(contract: f64, drive: impl Into<Drive>) -> Self {
        Self { drive: drive.into(), contract, turn_degrees: 0.0, extra: Extra::new() }
    }

    /// Turned by an angle [degrees], times a drive.
    pub fn turning(degrees: f64, drive: impl Into<Drive>) -> Self {
        Self { turn_degrees: degrees, ..Self::contracting(0.0, drive) }
    }
}
