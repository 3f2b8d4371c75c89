//! What drives make of fibres: other lengths, curvatures, twists at rest, and the pull of muscles.

use super::muscle::Muscle;
use crate::solver::drive::Drive;
use crate::solver::drive_along::DriveAlong;
use crate::solver::hand::Hand;
use glam::DVec3;

/// What a drive does to a fibre.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct FibreActivation {
    /// The drive at the middle of every edge.
    edges: DriveAlong,
    /// The drive at every inner vertex.
    inner: DriveAlong,
    /// Share by which the edges want to be shorter where the drive is 1.
    contract: f64,
    /// A quarter of the angle [rad] by which both edges of every inner vertex want to turn there where the drive is 1,
    /// and the unit axis of that, model frame.
    curl: Option<(Vec<f64>, DVec3)>,
    /// Pull of the edges where the drive is 1.
    muscle: Option<Muscle>,
    /// Angle [rad] by which every edge wants to be twisted where the drive is 1.
    twist: Vec<f64>,
    /// Share of its stiffness that it has where the drive is 0, and where it is 1; none where it is as stiff at all
    /// times.
    thickness: Option<[f64; 2]>,
    /// Whether it stands for all that it may ever be: see [`Self::at_extreme`].
    stiffest: bool,
}

impl FibreActivation {
    /// A drive of the fibre through vertices at `x` [m], the first of them `start` [m] along it, that does nothing as
    /// yet.
    pub(crate) fn new(drive: &Drive, start: f64, x: &[DVec3]) -> Self {
        let mut along = vec![start];
        for edge in x.windows(2) {
            along.push(along[along.len() - 1] + edge[0].distance(edge[1]));
        }
        let inner = along.get(1..along.len().saturating_sub(1)).unwrap_or_default();
        Self {
            edges: DriveAlong::new(drive, along.windows(2).map(|ends| 0.5 * (ends[0] + ends[1]))),
            inner: DriveAlong::new(drive, inner.iter().copied()),
            contract: 0.0,
            curl: None,
            muscle: None,
            twist: Vec::new(),
            thickness: None,
            stiffest: false,
        }
    }

    /// With edges that want to be shorter by a share.
    pub(crate) fn contracting(self, contract: f64) -> Self {
        Self { contract, ..self }
    }

    /// With a curvature at rest [rad/m] about a unit axis of the model frame, of a fibre with edges of these lengths
    /// [m].
    pub(crate) fn curling(self, curvature: f64, axis: DVec3, lengths: &[f64]) -> Self {
        let turns = lengths.windows(2).map(|edges| 0.25 * curvature * (edges[0] + edges[1])).collect();
        Self { curl: Some((turns, axis)), ..self }
    }

    /// With edges that pull as a muscle does.
    pub(crate) fn pulling(self, muscle: Muscle) -> Self {
        Self { muscle: Some(muscle), ..self }
    }

    /// With a twist at rest [rad/m], of a fibre with edges of these lengths [m].
    pub(crate) fn twisting(self, twist: f64, lengths: &[f64]) -> Self {
        Self { twist: lengths.iter().map(|length| twist * length).collect(), ..self }
    }

    /// With shares of the stiffness where the drive is 0 and where it is 1.
    pub(crate) fn thickening(self, thickness: Option<[f64; 2]>) -> Self {
        Self { thickness, ..self }
    }

    /// An activation under which the fibre resists any move as much as it ever does under this one, with the drive at
    /// its greatest or at its least.
    pub(super) fn at_extreme(&self, greatest: bool) -> Self {
        let (edges, inner) = (self.edges.at_extreme(greatest), self.inner.at_extreme(greatest));
        // Of several fibres all are thick in one copy and thin in the other, whichever way their drives go.
        let thickness = self.thickness.map(|ends| [self.edges.thickest(ends, greatest); 2]);
        Self { edges, inner, thickness, stiffest: true, ..self.clone() }
    }

    /// Length over the drawn one to which it shortens an edge that nothing holds, with the drive at its greatest or at
    /// its least; 1 where it does not.
    pub(super) fn shortest(&self, greatest: bool) -> f64 {
        let shorter = |greatest: bool| (self.contract * self.edges.extreme(greatest)).max(0.0);
        // One may be thick at one end of its drive and short at the other.
        1.0 - if self.thickens() { shorter(true).max(shorter(false)) } else { shorter(greatest) }
    }

    /// Has a hand lead a shared drive, or none.
    pub(super) fn give(&mut self, to: &str, led: Option<Hand>) {
        self.edges.give(to, led);
        self.inner.give(to, led);
    }

    /// Until when [s] it changes.
    pub(super) fn until(&self) -> f64 {
        self.edges.until()
    }

    /// Shares by which the edges want to be shorter at a time [s].
    pub(super) fn contractions(&self, time: f64) -> impl Fn(usize) -> f64 + '_ {
        let value = self.edges.at(time);
        // An edge without length at rest resists sideways as it does along itself, which is the most that any does.
        move |edge| if self.stiffest { 1.0 } else { self.contract * value(edge) }
    }

    /// The drive at the edges at a time [s], and by what share it has them want to be shorter.
    pub(super) fn values(&self, time: f64) -> impl Fn(usize) -> [f64; 2] + '_ {
        let value = self.edges.at(time);
        move |edge| [value(edge), self.contract * value(edge)]
    }

    /// What is added to the curvature binormals at rest at a time [s], model frame; nothing where it does not curl.
    pub(super) fn binormals(&self, time: f64) -> Option<impl Fn(usize) -> DVec3 + '_> {
        let (turns, axis) = self.curl.as_ref()?;
        let value = self.inner.at(time);
        Some(move |bend: usize| 2.0 * (turns[bend] * value(bend)).tan() * *axis)
    }

    /// Shares of their stiffness that edges and bends have at a time [s]; nothing where these do not change.
    pub(super) fn thicknesses(&self, time: f64) -> Option<[impl Fn(usize) -> f64 + '_; 2]> {
        let [thin, thick] = self.thickness?;
        Some([&self.edges, &self.inner].map(|along| {
            let value = along.at(time);
            move |place: usize| thin + (thick - thin) * value(place)
        }))
    }

    /// Whether it gets thicker or thinner.
    pub(super) fn thickens(&self) -> bool {
        self.thickness.is_some()
    }

    /// Whether it curls.
    pub(super) fn curls(&self) -> bool {
        self.curl.is_some()
    }

    /// The muscle and how far each edge's is excited at a time [s]; nothing where there is none.
    pub(super) fn excitations(&self, time: f64) -> Option<(Muscle, impl Fn(usize) -> f64 + '_)> {
        let muscle = if self.stiffest { self.muscle?.stiffest() } else { self.muscle? };
        Some((muscle, self.edges.at(time)))
    }

    /// Angles [rad] by which edges want to be twisted at a time [s].
    pub(super) fn twists(&self, time: f64) -> impl Fn(usize) -> f64 + '_ {
        let value = self.edges.at(time);
        move |edge| self.twist.get(edge).map_or(0.0, |twist| twist * value(edge))
    }
}
