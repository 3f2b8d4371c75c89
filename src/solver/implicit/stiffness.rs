//! How forces change with positions and velocities, found by moving particles.

use super::sparsity::Sparsity;
use crate::solver::forces::Force;
use crate::solver::state::ParticleState;
use glam::{DMat3, DVec3};
use rayon::prelude::*;

/// `K = -df/dx` [N/m] and `D = -df/dv` [N s/m] at one state, symmetrised, in blocks of three by three.
#[derive(Clone, Debug)]
pub(super) struct StiffnessMatrix {
    pub(super) sparsity: Sparsity,
    /// K, block by block in the order of [`Sparsity`].
    pub(super) positions: Vec<DMat3>,
    /// D; empty where no force hangs on a velocity.
    pub(super) velocities: Vec<DMat3>,
    /// Times that the forces were evaluated for it.
    pub(super) evaluations: u64,
}

/// Velocities are changed by this many small lengths over a second: forces are linear in them, and what is small for a
/// position would drown in the round-off of the elastic forces.
const FASTER: f64 = 1e5;

/// Moves that one copy of the forces is asked for, one after the other. Fixed, so that warm starts and with them the
/// bits do not depend on the number of threads.
const MOVES_A_COPY: usize = 24;

impl StiffnessMatrix {
    /// Of `forces` around `state` at `time` [s]; `small` is a small length [m] against which the forces are straight.
    pub(super) fn around(forces: &[Box<dyn Force>], state: &ParticleState, time: f64, small: f64) -> Self {
        let groups: Vec<Vec<u32>> = forces.iter().flat_map(|force| force.couplings()).collect();
        let sparsity = Sparsity::new(state.len(), &groups);
        let moves = Moves::new(&sparsity, forces, state, time, small);
        let positions = moves.columns(false);
        let velocities = if moves.is_damped() { moves.columns(true) } else { Vec::new() };
        // Once unmoved, three times to see whether anything is damped, and every colour along three axes.
        let evaluations = 4 + 3 * moves.colours.len() as u64 * if velocities.is_empty() { 1 } else { 2 };
        Self { sparsity, positions, velocities, evaluations }
    }

    /// `K x` [N] of displacements [m].
    pub(super) fn product(&self, x: &[DVec3]) -> Vec<DVec3> {
        self.times(&self.positions, x)
    }

    fn times(&self, blocks: &[DMat3], x: &[DVec3]) -> Vec<DVec3> {
        let row = |i| self.sparsity.range(i).zip(self.sparsity.row(i)).map(|(place, &j)| blocks[place] * x[j as usize]);
        (0..x.len()).map(|i| row(i).sum()).collect()
    }
}

/// All moves around a state.
struct Moves<'a> {
    sparsity: &'a Sparsity,
    forces: &'a [Box<dyn Force>],
    state: &'a ParticleState,
    time: f64,
    small: f64,
    colours: Vec<Vec<u32>>,
    unmoved: Vec<DVec3>,
}

impl<'a> Moves<'a> {
    fn new(
        sparsity: &'a Sparsity,
        forces: &'a [Box<dyn Force>],
        state: &'a ParticleState,
        time: f64,
        small: f64,
    ) -> Self {
        let unmoved = sum(&mut forces.to_vec(), time, state);
        Self { sparsity, forces, state, time, small, colours: sparsity.colours(), unmoved }
    }

    /// Whether any force hangs on a velocity.
    fn is_damped(&self) -> bool {
        let mut stirred = self.state.clone();
        for (i, v) in stirred.velocities.iter_mut().enumerate() {
            let i = i as f64;
            *v += FASTER * self.small * DVec3::new((1.0 + i).sin(), (2.0 + 3.0 * i).sin(), (3.0 + 7.0 * i).sin());
        }
        let mut forces = self.forces.to_vec();
        // Twice with one copy: the second evaluation starts where the first ended.
        let still = sum(&mut forces, self.time, self.state);
        let before = sum(&mut forces, self.time, self.state);
        let round_off = largest(&still, &before).max(largest(&still, &self.unmoved));
        largest(&sum(&mut forces, self.time, &stirred), &before) > 4.0 * round_off
    }

    /// The negative derivative by positions or by velocities.
    fn columns(&self, by_velocity: bool) -> Vec<DMat3> {
        let moves: Vec<(usize, usize)> = (0..self.colours.len()).flat_map(|c| [(c, 0), (c, 1), (c, 2)]).collect();
        let changes: Vec<Vec<Vec<DVec3>>> = moves
            .par_chunks(MOVES_A_COPY)
            .map(|moves| {
                let (mut forces, mut moved) = (self.forces.to_vec(), self.state.clone());
                moves.iter().map(|&each| self.change(&mut forces, &mut moved, each, by_velocity)).collect()
            })
            .collect();
        let mut blocks = vec![DMat3::ZERO; self.sparsity.blocks()];
        for (&(colour, axis), change) in moves.iter().zip(changes.iter().flatten()) {
            for &j in &self.colours[colour] {
                for &i in self.sparsity.row(j as usize) {
                    *blocks[self.sparsity.place(i as usize, j as usize)].col_mut(axis) = change[i as usize];
                }
            }
        }
        self.symmetrise(&mut blocks);
        blocks
    }

    /// What a move of the particles of a colour along an axis takes from the forces, over the length of the move.
    fn change(
        &self,
        forces: &mut [Box<dyn Force>],
        moved: &mut ParticleState,
        (colour, axis): (usize, usize),
        by_velocity: bool,
    ) -> Vec<DVec3> {
        let step = if by_velocity { FASTER * self.small } else { self.small } * DVec3::AXES[axis];
        let field = |moved: &mut ParticleState, by: DVec3| {
            let field = if by_velocity { &mut moved.velocities } else { &mut moved.positions };
            self.colours[colour].iter().for_each(|&j| field[j as usize] += by);
        };
        field(moved, step);
        let there = sum(forces, self.time, moved);
        let (from, to) = if by_velocity {
            (&self.state.velocities, &mut moved.velocities)
        } else {
            (&self.state.positions, &mut moved.positions)
        };
        // The length that was moved is that of rounded positions.
        let length = self.colours[colour].first().map_or(1.0, |&j| to[j as usize][axis] - from[j as usize][axis]);
        to.clone_from(from);
        self.unmoved.iter().zip(there).map(|(&before, after)| (before - after) / length).collect()
    }

    fn symmetrise(&self, blocks: &mut [DMat3]) {
        for i in 0..self.sparsity.len() {
            for (place, &j) in self.sparsity.range(i).zip(self.sparsity.row(i)) {
                let j = j as usize;
                if j <= i {
                    let other = self.sparsity.place(j, i);
                    let mean = 0.5 * (blocks[place] + blocks[other].transpose());
                    blocks[place] = mean;
                    blocks[other] = mean.transpose();
                }
            }
        }
    }
}

fn sum(forces: &mut [Box<dyn Force>], time: f64, state: &ParticleState) -> Vec<DVec3> {
    let mut sum = vec![DVec3::ZERO; state.len()];
    for force in forces {
        force.add_forces(time, state, &mut sum);
    }
    sum
}

fn largest(a: &[DVec3], b: &[DVec3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::kernel::Kernel;
    use crate::geometry::lattice::{Cuboid, fill_box};
    use crate::solver::embedding::Embedder;
    use crate::solver::forces::fibre::FibreRest;
    use crate::solver::forces::{AirDrag, Elasticity, FibreForce, MatrixForce, PairDamping};
    use crate::solver::neighbourhood::Neighbourhood;
    use glam::DQuat;
    use std::sync::Arc;

    const D: f64 = 0.006;

    /// A small bar with a stiff fibre along it and both kinds of damping, at rest.
    fn bar() -> (Vec<Box<dyn Force>>, ParticleState) {
        let shape = Cuboid { center: DVec3::ZERO, size: D * DVec3::new(4.0, 9.0, 3.0) };
        let sample = fill_box(&shape, D, DMat3::IDENTITY);
        let kernel = Kernel::new(2.5 * D);
        let neighbourhood = Arc::new(Neighbourhood::on_lattice(&sample, kernel, D.powi(3)).expect("no thin part"));
        let embedder = Embedder::new(&sample.points, kernel);
        let at: Vec<DVec3> = (0..5).map(|k| D * DVec3::new(0.3, f64::from(k) - 2.0, 0.2)).collect();
        let vertices = at.iter().map(|&x| embedder.vertex_weights(x).expect("a point inside")).collect();
        let fibre = FibreRest::new(vertices, &at, 40.0, 1e-4, 0.5, vec![None; 3]);
        let n = sample.points.len();
        let state =
            ParticleState { positions: sample.points.clone(), velocities: vec![DVec3::ZERO; n], masses: vec![4e-4; n] };
        let matrix = MatrixForce::new(
            Arc::clone(&neighbourhood),
            sample.points.into(),
            Elasticity::new(1e5, 0.33, D),
            D.powi(3),
            vec![1.0; n].into(),
            DQuat::IDENTITY,
        );
        let forces: Vec<Box<dyn Force>> = vec![
            Box::new(matrix),
            Box::new(FibreForce::new([fibre].into(), DQuat::IDENTITY)),
            Box::new(PairDamping::new(30.0, &neighbourhood)),
            Box::new(AirDrag { rate: 2.0 }),
        ];
        (forces, state)
    }

    fn any_field(n: usize) -> Vec<DVec3> {
        (0..n).map(|i| i as f64).map(|i| DVec3::new((1.7 * i).sin(), (2.9 * i).cos(), (0.3 * i * i).sin())).collect()
    }

    #[test]
    fn a_small_move_changes_the_forces_by_the_stiffness() {
        let (mut forces, state) = bar();
        let stiffness = StiffnessMatrix::around(&forces, &state, 0.0, 1e-7 * D);
        let direction = any_field(state.len());
        for by_velocity in [false, true] {
            // Damping is weak beside the elastic forces, whose rounding stands beside it.
            let step = if by_velocity { FASTER } else { 1.0 } * 1e-6 * D;
            let mut at = |sign: f64| {
                let mut moved = state.clone();
                let field = if by_velocity { &mut moved.velocities } else { &mut moved.positions };
                field.iter_mut().zip(&direction).for_each(|(x, &d)| *x += sign * step * d);
                sum(&mut forces, 0.0, &moved)
            };
            let (ahead, behind) = (at(1.0), at(-1.0));
            let expected: Vec<DVec3> =
                ahead.iter().zip(behind).map(|(&ahead, behind)| (behind - ahead) / (2.0 * step)).collect();
            let blocks = if by_velocity { &stiffness.velocities } else { &stiffness.positions };
            let found = stiffness.times(blocks, &direction);
            let size = expected.iter().map(|f| f.length_squared()).sum::<f64>().sqrt();
            let error = expected.iter().zip(found).map(|(a, b)| a.distance_squared(b)).sum::<f64>().sqrt();
            assert!(error < 1e-6 * size, "{by_velocity}: {}", error / size);
        }
    }

    #[test]
    fn a_factor_solves_and_holds_what_is_held() {
        use crate::solver::implicit::cholesky::{Elimination, Factor, Matrix};
        use glam::BVec3;
        let (forces, state) = bar();
        let stiffness = StiffnessMatrix::around(&forces, &state, 0.0, 1e-7 * D);
        let n = state.len();
        let diagonal: Vec<DMat3> = state.masses.iter().map(|m| DMat3::from_diagonal(DVec3::splat(m * 1e4))).collect();
        let mut held = vec![BVec3::FALSE; n];
        held[3] = BVec3::new(true, false, true);
        let matrix = Matrix { stiffness: &stiffness, h: 0.01, diagonal: &diagonal, held: &held };
        let elimination = Arc::new(Elimination::new(&stiffness).expect("a small body"));
        let factor = Factor::new(&elimination, &matrix).expect("a positive matrix");
        let mut expected = any_field(n);
        expected[3] *= DVec3::new(0.0, 1.0, 0.0);
        let mut field = stiffness.product(&expected);
        let damped = stiffness.times(&stiffness.velocities, &expected);
        for i in 0..n {
            field[i] += 100.0 * damped[i] + diagonal[i] * expected[i];
        }
        field[3] *= DVec3::new(0.0, 1.0, 0.0);
        factor.solve(&mut field);
        let error = expected.iter().zip(&field).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max);
        assert!(error < 1e-3, "{error}");
        assert_eq!((field[3].x, field[3].z), (0.0, 0.0));
    }
}
