//! The matrix of the chord steps: which one is in use, and the step by it.

use super::cholesky::{Elimination, Factor, Matrix};
use super::stiffness::StiffnessMatrix;
use crate::solver::dynamics::Dynamics;
use crate::solver::forces::{ColliderContact, Contact, Force, MatrixForce, Pressure};
use crate::solver::state::ParticleState;
use glam::{DMat3, DVec3};
use std::sync::Arc;

/// Share of the body's reach by which particles are moved to ask for its stiffness.
const SMALL: f64 = 4e-8;

/// Factors that are kept: of a step and of its halves, with and without what is touched.
const KEPT: usize = 6;

/// What the stiffness was asked of: what breaks, and forces that are added, make it another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Origin {
    breaks: usize,
    forces: usize,
}

/// The stiffness of a body in one state, and all that is the same for every step.
struct Basis {
    origin: Origin,
    stiffness: StiffnessMatrix,
    elimination: Arc<Elimination>,
    /// How every particle's matrix was turned there; none of a body without a matrix.
    turns: Option<Vec<DMat3>>,
}

/// A particle, and the plane of the room or the collider that it touches, by their numbers.
type Touch = (u32, u32);

/// A factor and what it is of.
#[derive(Clone)]
struct KeptFactor {
    h: f64,
    touching: Arc<[Touch]>,
    factor: Arc<Factor>,
}

/// The chord matrix of one body. A copy shares what was computed.
#[derive(Clone, Default)]
pub(super) struct Chord {
    basis: Option<Arc<Basis>>,
    /// Factors of the basis, the last used last.
    kept: Vec<KeptFactor>,
    /// The contact with the room and with colliders that is in the matrix.
    touching: Arc<[Touch]>,
    /// How the particles are turned against the basis.
    turns: Vec<DMat3>,
}

impl Chord {
    /// Makes the matrix for steps of `h` [s] ready; `state` is where the body is at `time` [s]. False where there is
    /// none.
    pub(super) fn prepare(&mut self, dynamics: &mut Dynamics<'_>, state: &ParticleState, time: f64, h: f64) -> bool {
        let origin = Origin {
            breaks: dynamics.forces.iter().map(|force| force.breaks().len()).sum(),
            forces: dynamics.forces.len(),
        };
        if self.basis.as_ref().is_none_or(|basis| basis.origin != origin) && !self.probe(dynamics, state, time, origin)
        {
            return false;
        }
        self.use_factor(dynamics, state, time, h)
    }

    /// Makes the matrix anew because it did not serve in `state`: with what the body touches there, and of a body
    /// without a matrix that turns from its present stiffness. False where that would be the same matrix.
    pub(super) fn renew(&mut self, dynamics: &mut Dynamics<'_>, state: &ParticleState, time: f64, h: f64) -> bool {
        let Some(basis) = self.basis.clone() else { return false };
        if basis.turns.is_none() {
            return self.probe(dynamics, state, time, basis.origin) && self.use_factor(dynamics, state, time, h);
        }
        let touching = touching(dynamics, state, time);
        if *touching == *self.touching {
            return false;
        }
        self.touching = touching;
        self.use_factor(dynamics, state, time, h)
    }

    /// Asks the forces for the stiffness.
    fn probe(&mut self, dynamics: &mut Dynamics<'_>, state: &ParticleState, time: f64, origin: Origin) -> bool {
        self.kept.clear();
        self.basis = None;
        let (mut forces, mut at) = (dynamics.forces.to_vec(), state.clone());
        let turns_with_it = dynamics.matrix().is_some();
        if turns_with_it {
            // At rest, where it is positive; touching comes and goes and is added by itself.
            forces.retain(|force| {
                force.downcast_ref::<Contact>().is_none() && force.downcast_ref::<ColliderContact>().is_none()
            });
            at.positions.copy_from_slice(dynamics.rest);
            at.velocities.fill(DVec3::ZERO);
        } else {
            let grabs = dynamics.grabs.iter().map(|grab| Box::new(grab.clone()) as Box<dyn Force>);
            forces.extend(grabs);
        }
        for force in &mut forces {
            // Gas ties every particle of its surface to every other: what its pressure gains is left to the iteration.
            if let Some(gas) = force.downcast_mut::<Pressure>() {
                gas.freeze(time, &at.positions);
            }
        }
        let stiffness = StiffnessMatrix::around(&forces, &at, time, SMALL * dynamics.reach);
        *dynamics.evaluations += stiffness.evaluations;
        let Some(elimination) = Elimination::new(&stiffness) else { return false };
        let turns = turns_with_it.then(|| {
            let mut unmoved = vec![DVec3::ZERO; at.len()];
            for force in &mut forces {
                force.add_forces(time, &at, &mut unmoved);
            }
            *dynamics.evaluations += 1;
            let matrix = forces.iter().find_map(|force| force.downcast_ref::<MatrixForce>());
            matrix.map_or_else(Vec::new, |matrix| turns_of(matrix, at.len()))
        });
        self.basis = Some(Arc::new(Basis { origin, stiffness, elimination: Arc::new(elimination), turns }));
        true
    }

    /// Brings the factor for `h` and for what is touched to the end of the list.
    fn use_factor(&mut self, dynamics: &Dynamics<'_>, state: &ParticleState, time: f64, h: f64) -> bool {
        let Some(basis) = self.basis.clone() else { return false };
        let known = self.kept.iter().position(|kept| kept.h == h && *kept.touching == *self.touching);
        if let Some(known) = known {
            self.kept[known..].rotate_left(1);
            return true;
        }
        let mut diagonal: Vec<DMat3> =
            state.masses.iter().map(|&mass| DMat3::from_diagonal(DVec3::splat(mass / (h * h)))).collect();
        self.turn(dynamics, state.len());
        self.add_contact(dynamics, state, time, h, &mut diagonal);
        let held = dynamics.held(state.len());
        let matrix = Matrix { stiffness: &basis.stiffness, h, diagonal: &diagonal, held: &held };
        let Some(factor) = Factor::new(&basis.elimination, &matrix) else { return false };
        if self.kept.len() == KEPT {
            self.kept.remove(0);
        }
        self.kept.push(KeptFactor { h, touching: Arc::clone(&self.touching), factor: Arc::new(factor) });
        true
    }

    /// Adds how the room and colliders resist the particles that touch them.
    fn add_contact(&self, dynamics: &Dynamics<'_>, state: &ParticleState, time: f64, h: f64, diagonal: &mut [DMat3]) {
        for &(i, what) in &*self.touching {
            let moving = [state.positions[i as usize], state.velocities[i as usize]];
            let resistance = dynamics.resistance(what, time, i, moving, h);
            let turn = self.turns.get(i as usize).copied().unwrap_or(DMat3::IDENTITY);
            diagonal[i as usize] += turn.transpose() * resistance * turn;
        }
    }

    /// Turns the matrix with the particles, by the last evaluation.
    pub(super) fn turn(&mut self, dynamics: &Dynamics<'_>, n: usize) {
        let at_rest = self.basis.as_ref().and_then(|basis| basis.turns.as_ref());
        let (Some(at_rest), Some(matrix)) = (at_rest, dynamics.matrix()) else { return };
        self.turns = turns_of(matrix, n).into_iter().zip(at_rest).map(|(r, at_rest)| r * at_rest.transpose()).collect();
    }

    /// `-T A^-1 T^T g`, with nothing along held axes, into `field`, which holds g [N] before.
    pub(super) fn step(&self, dynamics: &Dynamics<'_>, field: &mut [DVec3]) {
        let Some(KeptFactor { factor, .. }) = self.kept.last() else { return };
        field.iter_mut().zip(&self.turns).for_each(|(x, turn)| *x = turn.transpose() * *x);
        dynamics.mask(field);
        factor.solve(field);
        field.iter_mut().zip(&self.turns).for_each(|(x, turn)| *x = *turn * *x);
        for x in field.iter_mut() {
            *x = -*x;
        }
        dynamics.mask(field);
    }
}

fn turns_of(matrix: &MatrixForce, n: usize) -> Vec<DMat3> {
    (0..n).map(|i| DMat3::from_quat(matrix.rotation(i))).collect()
}

/// The particles that touch the room or colliders, with what they touch.
fn touching(dynamics: &Dynamics<'_>, state: &ParticleState, time: f64) -> Arc<[Touch]> {
    dynamics.touching(time, &state.positions).into()
}
