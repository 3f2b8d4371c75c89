//! Twist of fibres: how far the material around one vertex turns against that around the next, about the edge between.
//!
//! Per edge `l_f (GJ / 2 l0) (theta - theta0)²`, `theta = 2 atan2(q . T, w)` of `R_a^T R_b = (w, q)`, T the edge's
//! direction at rest in the model frame and R the turn of the material at both vertices. It needs no frame and no
//! unknown of its own.

use super::between::Between;
use super::material_turn::turn_of_material;
use crate::solver::embedding::TurnWeights;
use crate::solver::rotation::turn_stiffness;
use glam::{DMat3, DQuat, DVec3};

/// Twist of one edge at rest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct TwistRest {
    /// `l_f GJ / l0` [N m].
    pub(super) stiffness: f64,
    /// Direction at rest, model frame.
    pub(super) axis: DVec3,
}

/// Twist of one fibre at rest.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct FibreTwist {
    /// How the turn of the material is read at every vertex.
    pub(super) turns: Vec<TurnWeights>,
    /// Of every edge.
    pub(super) edges: Vec<TwistRest>,
}

impl FibreTwist {
    /// Of a fibre with vertices at `x` [m], of twisting rigidity `gj` [N m²], volume fraction included; `turns` are the
    /// vertices' stencils.
    pub(crate) fn new(turns: Vec<TurnWeights>, x: &[DVec3], gj: f64) -> Self {
        let edge = |ends: &[DVec3]| {
            let length = ends[0].distance(ends[1]);
            TwistRest { stiffness: gj / length, axis: (ends[1] - ends[0]) / length }
        };
        Self { turns, edges: x.windows(2).map(edge).collect() }
    }

    /// Angle [rad] by which every edge is twisted; `warm` are the last turns of its vertices.
    pub(super) fn angles(&self, positions: &[DVec3], warm: &[DQuat]) -> Vec<f64> {
        let turned = |(turn, warm): (&TurnWeights, &DQuat)| {
            let mut warm = *warm;
            turn_of_material(turn, positions, &mut warm);
            warm
        };
        let turns: Vec<DQuat> = self.turns.iter().zip(warm).map(turned).collect();
        self.edges.iter().zip(turns.windows(2)).map(|(edge, ends)| Between::new(edge.axis, ends).angle).collect()
    }

    /// Adds its forces [N] on particles to `forces`, where edge k wants to be twisted by the first of `at_rest` [rad]
    /// with the second as a share of its stiffness, and carries nothing where that is none.
    pub(super) fn add_forces(
        &self,
        at_rest: impl Fn(usize) -> Option<[f64; 2]>,
        positions: &[DVec3],
        warm: &mut [DQuat],
        forces: &mut [DVec3],
    ) {
        let found: Vec<(DMat3, DMat3)> = self
            .turns
            .iter()
            .zip(warm.iter_mut())
            .map(|(turn, warm)| turn_of_material(turn, positions, warm))
            .collect();
        let mut moments = vec![DVec3::ZERO; self.turns.len()];
        for (k, edge) in self.edges.iter().enumerate() {
            let Some([at_rest, thickness]) = at_rest(k) else { continue };
            let between = Between::new(edge.axis, &warm[k..k + 2]);
            let moment = thickness * edge.stiffness * (between.angle - at_rest);
            let [a, b] = between.spins(edge.axis);
            moments[k] += moment * a;
            moments[k + 1] += moment * b;
        }
        for ((turn, (r, stretch)), moment) in self.turns.iter().zip(found).zip(moments) {
            let p = turn_stiffness(stretch).inverse() * moment;
            for &(particle, z) in &turn.weights {
                forces[particle as usize] -= r * p.cross(z);
            }
        }
    }

    /// The particles that turn both ends of every edge.
    pub(super) fn couplings(&self) -> impl Iterator<Item = Vec<u32>> {
        let around = |ends: &[TurnWeights]| {
            ends.iter().flat_map(|turn| turn.weights.iter().map(|&(particle, _)| particle)).collect()
        };
        self.turns.windows(2).map(around)
    }

    /// Number of its vertices.
    pub(super) fn len(&self) -> usize {
        self.turns.len()
    }
}
