//! What there is to know of a touch between two bodies.

use glam::DVec3;

/// What two bodies that overlapped at the start are still granted.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(in crate::solver) struct Allowance {
    /// How far the first body stands aside of where it is [m], as far as contact is concerned.
    pub(in crate::solver) aside: DVec3,
    /// Rate of that [m/s].
    pub(in crate::solver) aside_rate: DVec3,
    /// Depth [m] that every touch is granted.
    pub(in crate::solver) depth: f64,
    /// Rate of that [m/s].
    pub(in crate::solver) depth_rate: f64,
}

impl Allowance {
    /// The same, seen from the second body: it stands aside the other way.
    pub(super) fn seen_by_second(self) -> Self {
        Self { aside: -self.aside, aside_rate: -self.aside_rate, ..self }
    }
}

/// A particle of one body that touches the other.
#[derive(Clone, Copy, Debug)]
pub(in crate::solver) struct Touch {
    /// Whether the particle is one of the second body.
    pub(super) of_second: bool,
    pub(super) particle: u32,
    /// What it touches: particles of the other body and their weights, of which the first `carriers` count.
    pub(super) carried_by: [(u32, f64); 3],
    pub(super) carriers: usize,
    /// Distance [m], granted depth included.
    pub(in crate::solver) gap: f64,
    /// Unit vector from what is touched to the particle.
    pub(in crate::solver) normal: DVec3,
    pub(super) velocity: DVec3,
    /// What is known where surfaces meet; none of particles on what is touched, at which friction acts with the lever
    /// of their radius.
    pub(super) meeting: Option<Meeting>,
}

/// Where two surfaces meet.
#[derive(Clone, Copy, Debug)]
pub(super) struct Meeting {
    /// How far from the particle, and from what carries it, they meet [m], along the normal: friction acts there.
    pub(super) levers: [f64; 2],
    /// How far the one has slid on the other since the last outer step began [m].
    pub(super) slid: DVec3,
}

/// A box along the world's axes.
pub(super) struct Aabb {
    pub(super) min: DVec3,
    pub(super) max: DVec3,
}

impl Aabb {
    pub(super) fn contains(&self, x: DVec3) -> bool {
        x.cmpge(self.min).all() && x.cmple(self.max).all()
    }
}
