//! Fibres element by element.

use super::elements::{CurvedBend, Pull, StraightBend, Stretching, Twisting};
use super::muscle::Muscle;
use super::rest::FibreRest;
use crate::solver::forces::element::{ElementForce, Kind, Structure};
use glam::{DQuat, DVec3};

impl FibreRest {
    /// Stretch of edge `k`, which rests at a length [m], has become longer by another for good, and is this share as
    /// stiff.
    pub(super) fn edge(&self, k: usize, [rest, yielded]: [f64; 2], share: f64) -> Stretching {
        let (points, (whole, drawn)) = ([k as u32, k as u32 + 1], self.edges[k]);
        let stiffness = share * whole;
        Stretching { points, stiffness, drawn, contract: 0.0, rest, yielded }
    }

    /// Pull of edge `k` by a muscle that is excited so far, and this share as strong.
    pub(super) fn pull(&self, k: usize, muscle: Muscle, excited: f64, share: f64) -> Pull {
        Pull { points: [k as u32, k as u32 + 1], muscle: muscle.scaled(share), drawn: self.edges[k].1, excited }
    }

    /// Bend `k`, which rests at this curvature binormal of the model frame where it has any, and is this share as
    /// stiff.
    pub(super) fn bend(&self, k: usize, rest: DVec3, share: f64) -> Kind {
        let points = [k as u32, k as u32 + 1, k as u32 + 2];
        let stiffness = share * self.bends[k].stiffness;
        if self.bends[k].curved.is_none() {
            return Kind::StraightBend(StraightBend { points, stiffness });
        }
        Kind::CurvedBend(CurvedBend { points, at: [points[1]], stiffness, drawn: rest, curl: None, rest })
    }

    /// All elements of the fibre as its drive has them at a time [s].
    fn structure(&self, time: f64) -> Structure {
        let mut turns = vec![None; self.vertices.len()];
        for (k, bend) in self.bends.iter().enumerate() {
            turns[k + 1] = bend.curved.as_ref().map(|rest| rest.turn.clone());
        }
        if let Some(twist) = &self.twist {
            turns = twist.turns.iter().cloned().map(Some).collect();
        }
        let (length, binormal, wanted) = (self.lengths_at(time), self.binormals_at(time), self.twists_at(time));
        let [edges, bends] = self.thicknesses_at(time);
        let mut elements: Vec<Kind> = Vec::new();
        elements.extend((0..self.edges.len()).map(|k| Kind::Stretching(self.edge(k, [length(k), 0.0], edges(k)))));
        if let Some((muscle, excited)) = self.activation.as_ref().and_then(|of| of.excitations(time)) {
            elements.extend((0..self.edges.len()).map(|k| Kind::Pull(self.pull(k, muscle, excited(k), edges(k)))));
        }
        elements.extend((0..self.bends.len()).map(|k| self.bend(k, binormal(k), bends(k))));
        let twists = self.twist.iter().flat_map(|twist| twist.edges.iter().enumerate());
        elements.extend(twists.map(|(k, of)| {
            let (points, stiffness, axis) = ([k as u32, k as u32 + 1], edges(k) * of.stiffness, of.axis);
            Kind::Twist(Twisting { points, stiffness, axis, wanted: wanted(k), rest: wanted(k) })
        }));
        Structure::new("", self.vertices.clone(), turns, elements)
    }
}

impl ElementForce {
    /// The elements of fibres as their drives have them at a time [s], over particles that start at `positions` [m],
    /// the model frame turned by `orientation`: what [`super::FibreForce`] is held against.
    pub fn of_fibres(fibres: &[FibreRest], time: f64, positions: &[DVec3], orientation: DQuat) -> Self {
        Self::new(fibres.iter().map(|fibre| fibre.structure(time)).collect(), positions, orientation)
    }
}
