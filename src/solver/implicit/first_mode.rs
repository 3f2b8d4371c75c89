//! The slowest mode of a body that is held.

use super::cholesky::{Elimination, Factor, Matrix};
use super::stiffness::StiffnessMatrix;
use crate::solver::body::BodyParts;
use crate::solver::constraint::{Constraint, held};
use crate::solver::forces::{ColliderContact, Contact};
use crate::solver::linear_algebra::vectors::{axpy, divide, dot};
use crate::solver::state::ParticleState;
use glam::{DMat3, DVec3};
use std::sync::Arc;

/// Passes after which the mode is taken as it is.
const MOST_PASSES: usize = 60;
/// A pass that changes the squared frequency by less than this share is the last.
const SETTLED: f64 = 1e-9;
/// Share of the reach by which particles are moved to ask for the stiffness.
const SMALL: f64 = 4e-8;

/// Angular frequency [rad/s] of the slowest swing of a body around its rest, without damping, gravity and what it
/// touches. None of one that nothing holds, or that is too large to be factored.
pub(crate) fn first_mode(parts: &BodyParts) -> Option<f64> {
    let n = parts.rest.len();
    if parts.constraints.is_empty() {
        return None;
    }
    let at = ParticleState {
        positions: parts.rest.to_vec(),
        velocities: vec![DVec3::ZERO; n],
        masses: parts.state.masses.clone(),
    };
    let mut forces = parts.forces.clone();
    forces
        .retain(|force| force.downcast_ref::<Contact>().is_none() && force.downcast_ref::<ColliderContact>().is_none());
    let stiffness = StiffnessMatrix::around(&forces, &at, 0.0, SMALL * parts.reach);
    let elimination = Arc::new(Elimination::new(&stiffness)?);
    let held = held(&parts.constraints, n);
    let diagonal = vec![DMat3::ZERO; n];
    let matrix = Matrix { stiffness: &stiffness, h: f64::INFINITY, diagonal: &diagonal, held: &held };
    let factor = Factor::new(&elimination, &matrix)?;
    let inner = Inner { stiffness: &stiffness, constraints: &parts.constraints, masses: &at.masses };

    // Any field that is at right angles to no mode but by chance.
    let mut x: Vec<DVec3> =
        (0..n).map(|i| i as f64).map(|i| DVec3::new((1.7 * i).sin(), (2.9 * i).cos(), 1.0)).collect();
    inner.free(&mut x);
    factor.solve(&mut x);
    let mut before = f64::INFINITY;
    for _ in 0..MOST_PASSES {
        let (stiff, heavy) = (inner.stiff(&x), inner.heavy(&x));
        let size = dot(&x, &heavy);
        let squared = dot(&x, &stiff) / size;
        if squared.is_nan() || squared <= 0.0 {
            return None;
        }
        if (before - squared).abs() <= SETTLED * squared {
            return Some(squared.sqrt());
        }
        before = squared;
        let mut change = stiff;
        axpy(-squared, &heavy, &mut change);
        factor.solve(&mut change);
        axpy(-1.0, &change, &mut x);
        inner.free(&mut x);
        let size = inner.size(&x);
        divide(&mut x, size);
    }
    Some(before.sqrt())
}

/// The body's stiffness and mass along its free axes.
struct Inner<'a> {
    stiffness: &'a StiffnessMatrix,
    constraints: &'a [Constraint],
    masses: &'a [f64],
}

impl Inner<'_> {
    fn free(&self, x: &mut [DVec3]) {
        self.constraints.iter().for_each(|constraint| constraint.mask(x));
    }

    fn stiff(&self, x: &[DVec3]) -> Vec<DVec3> {
        let mut product = self.stiffness.product(x);
        self.free(&mut product);
        product
    }

    fn heavy(&self, x: &[DVec3]) -> Vec<DVec3> {
        x.iter().zip(self.masses).map(|(&x, &mass)| mass * x).collect()
    }

    fn size(&self, x: &[DVec3]) -> f64 {
        dot(x, &self.heavy(x)).sqrt()
    }
}
