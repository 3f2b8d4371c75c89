//! Damped springs of no rest length from particles to where a motion made elsewhere leads them:
//! `f = k (target - x) + d (velocity of the target - v)`.
//!
//! What leads does work: the force times the way of its target. Half of a step's is booked at each of its ends.

use super::force::{Force, StepLimit};
use crate::solver::energy::Energies;
use crate::solver::led::Led;
use crate::solver::state::ParticleState;
use glam::DVec3;
use std::sync::Arc;

/// Springs to where particles are led.
#[derive(Clone, Debug)]
pub(crate) struct LedSprings {
    bound: Arc<Bound>,
    /// Work done up to the last booking [J].
    done: f64,
    /// The targets there [m], and the forces that they pull with [N].
    booked: Option<Vec<[DVec3; 2]>>,
}

/// What is pulled, and where.
#[derive(Debug)]
struct Bound {
    /// Identifier of what is followed.
    id: String,
    particles: Vec<u32>,
    /// Stiffness [N/m] and damping [N s/m] of the spring of each.
    constants: Vec<[f64; 2]>,
    led: Arc<Led>,
}

impl LedSprings {
    /// Springs of these particles, each with its stiffness [N/m] and damping [N s/m], to where they are led.
    pub(crate) fn new(id: &str, particles: Vec<u32>, constants: Vec<[f64; 2]>, led: Arc<Led>) -> Self {
        Self { bound: Arc::new(Bound { id: id.to_owned(), particles, constants, led }), done: 0.0, booked: None }
    }

    /// Where each particle is pulled to [m] at a time [s], and with what force [N].
    fn pulls(&self, time: f64, state: &ParticleState) -> Vec<[DVec3; 2]> {
        let Bound { particles, constants, led, .. } = &*self.bound;
        let pull = |((&i, [stiffness, damping]), [target, velocity]): ((&u32, &[f64; 2]), [DVec3; 2])| {
            let i = i as usize;
            let [stretch, rate] = [target - state.positions[i], velocity - state.velocities[i]];
            [target, *stiffness * stretch + *damping * rate]
        };
        particles.iter().zip(constants).zip(led.places(time)).map(pull).collect()
    }
}

impl Force for LedSprings {
    fn add_forces(&mut self, time: f64, state: &ParticleState, forces: &mut [DVec3]) {
        let pulls = self.pulls(time, state);
        for (&i, [_, force]) in self.bound.particles.iter().zip(&pulls) {
            forces[i as usize] += *force;
        }
        if self.booked.is_none() {
            self.booked = Some(pulls);
        }
    }

    fn add_energy(&self, time: f64, state: &ParticleState, energies: &mut Energies) {
        let Bound { particles, constants, led, .. } = &*self.bound;
        for ((&i, [stiffness, _]), [target, _]) in particles.iter().zip(constants).zip(led.places(time)) {
            energies.springs += 0.5 * stiffness * target.distance_squared(state.positions[i as usize]);
        }
    }

    fn step_limit(&self, state: &ParticleState) -> StepLimit {
        let Bound { particles, constants, .. } = &*self.bound;
        let greatest = |which: usize| {
            let of = particles.iter().zip(constants).map(|(&i, of)| of[which] / state.masses[i as usize]);
            of.fold(0.0, f64::max)
        };
        StepLimit { frequency_squared: greatest(0), damping_rate: greatest(1) }
    }

    fn changes_until(&self) -> f64 {
        self.bound.led.end()
    }

    fn driven_until(&self) -> f64 {
        self.bound.led.end()
    }

    fn does_work(&self) -> bool {
        true
    }

    fn outside_work(&self) -> Option<f64> {
        Some(self.done)
    }

    fn end_step(&mut self, time: f64, state: &ParticleState) -> bool {
        let now = self.pulls(time, state);
        if let Some(before) = &self.booked {
            let ways = before.iter().zip(&now).map(|([from, f], [to, g])| 0.5 * (*f + *g).dot(*to - *from));
            self.done += ways.sum::<f64>();
        }
        self.booked = Some(now);
        false
    }

    fn adopt(&mut self, before: &[Box<dyn Force>]) {
        self.booked = None;
        let mut before = before.iter().filter_map(|force| force.downcast_ref::<Self>());
        self.done = before.find(|of| of.bound.id == self.bound.id).map_or(0.0, |of| of.done);
    }

    fn name(&self) -> &'static str {
        "led springs"
    }

    fn bytes(&self) -> usize {
        size_of_val(self) + self.booked.as_ref().map_or(0, |booked| size_of_val(&**booked))
    }

    fn clone_box(&self) -> Box<dyn Force> {
        Box::new(self.clone())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::point_cache::PointCache;
    use crate::solver::drive::After;
    use crate::solver::led::{BoundToFace, Leader, Playing};
    use glam::{DMat4, Vec3};

    fn springs(damping: f64) -> LedSprings {
        let corners = [Vec3::ZERO, Vec3::X, Vec3::Y];
        let values = [0.0, 1.0, 4.0].into_iter().flat_map(|z| corners.map(|at| at + z * Vec3::Z)).collect();
        let cache = Arc::new(PointCache::new(vec![0.0, 1.0, 2.0], false, 3, values));
        let bound = |x: f64| {
            let rest = DVec3::new(x, 0.2, 0.1);
            BoundToFace { corners: [0, 1, 2], shares: [0.8 - x, x, 0.2], height: 0.1, rest }
        };
        let led = Led {
            leader: Leader::Cache { cache, seconds: 1.0, bound: vec![bound(0.1), bound(0.3)] },
            playing: Playing { start: 0.0, pre_roll: 0.0, speed: 1.0, from: 0.0, length: 2.0, after: After::Hold },
            frame: DMat4::IDENTITY,
        };
        LedSprings::new("led", vec![0, 2], vec![[3.0, damping], [5.0, damping]], Arc::new(led))
    }

    fn state() -> ParticleState {
        let positions = vec![DVec3::new(0.3, 0.1, 0.7), DVec3::ONE, DVec3::new(-0.2, 0.5, 1.1)];
        ParticleState { velocities: vec![DVec3::X, DVec3::Y, DVec3::ZERO], positions, masses: vec![2.0, 1.0, 1.0] }
    }

    #[test]
    fn the_force_is_the_negative_gradient_of_the_energy() {
        let mut springs = springs(0.0);
        let mut forces = vec![DVec3::ZERO; 3];
        springs.add_forces(0.7, &state(), &mut forces);
        let energy = |i: usize, axis: usize, by: f64| {
            let mut state = state();
            state.positions[i][axis] += by;
            let mut energies = Energies::default();
            springs.add_energy(0.7, &state, &mut energies);
            energies.springs
        };
        for (i, force) in forces.iter().enumerate() {
            for axis in 0..3 {
                let slope = (energy(i, axis, 1e-5) - energy(i, axis, -1e-5)) / 2e-5;
                assert!((slope + force[axis]).abs() < 1e-9, "{i} {axis}: {slope}, not {}", -force[axis]);
            }
        }
    }

    #[test]
    fn damping_acts_on_the_velocity_against_the_motion() {
        let mut pulled = [DVec3::ZERO; 3];
        let mut state = state();
        springs(0.0).add_forces(1.0, &state, &mut pulled);
        let mut damped = [DVec3::ZERO; 3];
        springs(0.5).add_forces(1.0, &state, &mut damped);
        // At its second sample the cache goes up by 2 m/s, the mean of the ways before and behind.
        assert!((damped[0] - pulled[0]).distance(0.5 * (2.0 * DVec3::Z - DVec3::X)) < 1e-12);
        assert!((damped[2] - pulled[2]).distance(0.5 * 2.0 * DVec3::Z) < 1e-12);
        assert_eq!(damped[1], DVec3::ZERO);
        let limit = springs(0.5).step_limit(&state);
        assert_eq!((limit.frequency_squared, limit.damping_rate), (5.0, 0.5));
        state.masses[2] = 10.0;
        assert_eq!(springs(0.5).step_limit(&state).frequency_squared, 1.5);
    }
}
