//! Arms: what particles leave of the way to a point of a skin far outside of them, turned as they turn.
//!
//! A rotation is no linear function of the particles; its three axes are. So every arm gives three *directions*, the
//! model frame's axes turned, behind the particles, and a point sums over both: `x = sum w_k x_k + sum o_j R e_j`.
//! Whoever sums needs to know nothing of rotations. Directions have no place: what moves the list of particles
//! elsewhere leaves them alone.

use super::rotation::rotation_of;
use super::skin_weights::Arm;
use glam::{DMat3, DQuat, DVec3};
use rayon::prelude::*;

/// Directions of an arm.
pub(super) const DIRECTIONS: usize = 3;

/// By how much the whole body's turn counts beside that of the particles around an arm. Where these hardly say how they
/// are turned about some axis, it has the say, and that changes by and by; where all turn alike, it changes nothing.
const WHOLE_SHARE: f64 = 0.05;

/// The turns of all arms of a skin.
#[derive(Clone, Debug, Default)]
pub(super) struct Arms {
    /// Particles and offsets of every arm: those of arm `a` are `starts[a]..starts[a + 1]`; empty without arms.
    starts: Vec<u32>,
    terms: Vec<(u32, DVec3)>,
    /// Those of the whole body.
    whole: Vec<(u32, DVec3)>,
}

impl Arms {
    /// None yet, of a body with this turn.
    pub(super) fn new(whole: Vec<(u32, DVec3)>) -> Self {
        Self { starts: vec![0], terms: Vec::new(), whole }
    }

    /// These arms, and those of another skin over the same particles behind them.
    pub(super) fn with(&self, others: &Self) -> Self {
        let mut all = self.clone();
        let behind = all.terms.len() as u32;
        all.terms.extend(&others.terms);
        all.starts.extend(others.starts.iter().skip(1).map(|start| start + behind));
        all
    }

    /// Number of arms.
    pub(super) fn len(&self) -> usize {
        self.starts.len().saturating_sub(1)
    }

    /// Adds an arm; gives its number.
    pub(super) fn push(&mut self, arm: &Arm) -> usize {
        self.terms.extend(&arm.turn);
        self.starts.push(self.terms.len() as u32);
        self.len() - 1
    }

    /// The directions of every arm over particles at `positions` [m].
    pub(super) fn directions(&self, positions: &[DVec3]) -> Vec<DVec3> {
        if self.len() == 0 {
            return Vec::new();
        }
        let whole = self.whole_turn(positions);
        let axes = |arm| self.axes_near(arm, positions, whole);
        let axes: Vec<[DVec3; DIRECTIONS]> = (0..self.len()).into_par_iter().with_min_len(64).map(axes).collect();
        axes.into_flattened()
    }

    /// Those of one arm.
    pub(super) fn axes(&self, arm: usize, positions: &[DVec3]) -> [DVec3; DIRECTIONS] {
        self.axes_near(arm, positions, self.whole_turn(positions))
    }

    /// Where those around an arm lie on a line, the whole body says how they are turned about it.
    fn whole_turn(&self, positions: &[DVec3]) -> DQuat {
        rotation_of(gradient(&self.whole, positions), DQuat::IDENTITY)
    }

    fn axes_near(&self, arm: usize, positions: &[DVec3], whole: DQuat) -> [DVec3; DIRECTIONS] {
        let terms = &self.terms[self.starts[arm] as usize..self.starts[arm + 1] as usize];
        let own = gradient(terms, positions);
        let size = own.to_cols_array().iter().map(|e| e * e).sum::<f64>().sqrt();
        let turn = DMat3::from_quat(rotation_of(own + DMat3::from_quat(whole) * (WHOLE_SHARE * size), whole));
        [turn.x_axis, turn.y_axis, turn.z_axis]
    }

    /// Memory that they take [bytes].
    pub(super) fn bytes(&self) -> usize {
        size_of_val(&*self.starts) + size_of_val(&*self.terms) + size_of_val(&*self.whole)
    }
}

/// `sum x_k (x) Z_k`.
fn gradient(terms: &[(u32, DVec3)], positions: &[DVec3]) -> DMat3 {
    // Offsets sum to nothing; about one of the particles that holds to round-off however far away they are.
    let about = terms.first().map_or(DVec3::ZERO, |&(k, _)| positions[k as usize]);
    let mut sum = DMat3::ZERO;
    for &(k, z) in terms {
        let x = positions[k as usize] - about;
        sum += DMat3::from_cols(x * z.x, x * z.y, x * z.z);
    }
    sum
}
