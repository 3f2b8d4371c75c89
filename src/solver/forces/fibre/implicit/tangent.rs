//! Forces of fibres on their vertices, and how these change with the vertices.
//!
//! The Hessian is kept positive semi-definite: of edges all but what presses them sideways, of bends `2 S J^T J` (Gauss
//! and Newton), J the derivative of the curvature binormal by the edges.

use crate::solver::forces::fibre::breaking::Breakage;
use crate::solver::forces::fibre::corner::{Corner, FOLD};
use crate::solver::forces::fibre::rest::FibreRest;
use crate::solver::neighbourhood::outer;
use glam::{DMat3, DVec3};

/// Blocks of a vertex's row: with itself and two to either side on its fibre.
pub(super) const BAND: usize = 2 * BEND_REACH + 1;

/// A bend couples a vertex with this many to either side of it on its fibre.
pub(super) const BEND_REACH: usize = 2;

/// Forces of all fibres on their vertices and minus their derivatives, vertices fibre after fibre.
#[derive(Debug, Default)]
pub(super) struct Tangent {
    /// Forces [N].
    pub(super) forces: Vec<DVec3>,
    /// Rows of the Hessian [N/m], by the vertices two before to two after on the same fibre.
    pub(super) hessian: Vec<[DMat3; BAND]>,
    /// Gradient of each curved bend's energy by its binormal [N m], in the order of the curved bends.
    pub(super) moments: Vec<DVec3>,
}

impl Tangent {
    /// Of fibres with vertices at `x` [m] whose curved rest binormals are turned to `binormals`.
    pub(super) fn evaluate(&mut self, fibres: &[FibreRest], broken: &Breakage, x: &[DVec3], binormals: &[DVec3]) {
        self.forces.clear();
        self.forces.resize(x.len(), DVec3::ZERO);
        self.hessian.clear();
        self.hessian.resize(x.len(), [DMat3::ZERO; BAND]);
        self.moments.clear();
        let (mut first, mut first_bend, mut first_edge) = (0, 0, 0);
        for fibre in fibres {
            let x = &x[first..first + fibre.vertices.len()];
            for (k, &(stiffness, length)) in fibre.edges.iter().enumerate() {
                if !broken.edges[first_edge + k] {
                    self.stretch(first + k, x[k + 1] - x[k], stiffness, length);
                }
            }
            for (k, bend) in fibre.bends.iter().enumerate() {
                let whole = !broken.bends[first_bend + k];
                let corner = if whole { Corner::at(x, k) } else { None };
                if bend.curved.is_some() {
                    let rest = binormals[self.moments.len()];
                    let moment = corner.as_ref().map(|corner| 2.0 * bend.stiffness * (corner.binormal() - rest));
                    self.moments.push(moment.unwrap_or(DVec3::ZERO));
                    if let (Some(corner), Some(moment)) = (corner, moment) {
                        self.pull(first + k, corner.curved_gradients(moment));
                        self.bend(first + k, &corner, bend.stiffness);
                    }
                } else if let Some(corner) = corner {
                    self.pull(first + k, straight_gradients(&corner, bend.stiffness));
                    self.bend(first + k, &corner, bend.stiffness);
                }
            }
            first += fibre.vertices.len();
            first_bend += fibre.bends.len();
            first_edge += fibre.edges.len();
        }
    }

    /// The edge that begins with a vertex.
    fn stretch(&mut self, vertex: usize, edge: DVec3, stiffness: f64, rest_length: f64) {
        let length = edge.length();
        if length == 0.0 {
            return;
        }
        let tangent = edge / length;
        let tension = stiffness * (length - rest_length);
        self.forces[vertex] += tension * tangent;
        self.forces[vertex + 1] -= tension * tangent;
        let sideways = tension.max(0.0) / length;
        let block = outer(tangent, tangent) * (stiffness - sideways) + DMat3::from_diagonal(DVec3::splat(sideways));
        self.couple([vertex, vertex], block);
        self.couple([vertex + 1, vertex + 1], block);
        self.couple([vertex, vertex + 1], -block);
        self.couple([vertex + 1, vertex], -block);
    }

    /// Gradients [N] by the two edges of the corner whose first vertex this is.
    fn pull(&mut self, vertex: usize, (before, after): (DVec3, DVec3)) {
        self.forces[vertex] += before;
        self.forces[vertex + 1] += after - before;
        self.forces[vertex + 2] -= after;
    }

    /// The corner's part of the Hessian.
    fn bend(&mut self, vertex: usize, corner: &Corner, stiffness: f64) {
        let [by_before, by_after] = corner.binormal_derivatives();
        let by_vertex = [-by_before, by_before - by_after, by_after];
        for (a, left) in by_vertex.iter().enumerate() {
            let left = left.transpose() * (2.0 * stiffness);
            for (b, right) in by_vertex.iter().enumerate() {
                self.couple([vertex + a, vertex + b], left * *right);
            }
        }
    }

    fn couple(&mut self, [a, b]: [usize; 2], block: DMat3) {
        self.hessian[a][BEND_REACH + b - a] += block;
    }

    /// `H d` of each vertex: adds minus it to `y`, both by vertex.
    pub(super) fn subtract_product(&self, d: &[DVec3], y: &mut [DVec3]) {
        for (vertex, (row, y)) in self.hessian.iter().zip(y).enumerate() {
            for (k, block) in row.iter().enumerate() {
                // Blocks beyond a fibre's ends are zero, and those beyond all have no vertex.
                if let Some(d) = (vertex + k).checked_sub(BEND_REACH).and_then(|other| d.get(other)) {
                    *y -= *block * *d;
                }
            }
        }
    }
}

/// Gradients by the edges of `4 S (1 - c) / (1 + c)`, continued linearly in c where the fibre folds.
fn straight_gradients(corner: &Corner, stiffness: f64) -> (DVec3, DVec3) {
    let c = corner.cosine;
    let steepness = if c < FOLD { 4.0 } else { (1.0 + c).powi(-2) };
    let slope = -8.0 * stiffness * steepness;
    let (before, after) = (corner.before.tangent, corner.after.tangent);
    ((after - before * c) * (slope / corner.before.length), (before - after * c) * (slope / corner.after.length))
}
