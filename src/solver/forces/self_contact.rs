//! Contact of a body with itself: particles that were far apart at rest and come near push each other away.
//!
//! Particles are balls that touch their neighbours. Two of them that lay at least twice as far apart at rest push each
//! other along the line through their centres, so that both momenta are kept; neighbours, which the matrix or the
//! springs hold, never do. There is no friction: balls are bumpy, and faces of them hold each other as by a friction of
//! some 0.8.

use super::force::{Force, StepLimit};
use crate::geometry::neighbours::PointGrid;
use crate::solver::energy::Energies;
use crate::solver::scratch::Scratch;
use crate::solver::state::ParticleState;
use glam::DVec3;
use std::sync::Arc;

/// Two particles can touch where they were at least this many times as far apart at rest as when they touch.
const FAR_AT_REST: f64 = 2.0;

/// How far particles move, in diameters of the largest, before those that are near are looked for anew.
const SLACK: f64 = 0.25;

/// A particle that can touch others of its body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct SelfTouching {
    /// Its index.
    pub(crate) particle: u32,
    /// Its radius [m].
    pub(crate) radius: f64,
    /// Where it lies at rest [m].
    pub(crate) rest: DVec3,
}

/// Pairs that are near enough to come to touch before they are looked for anew.
#[derive(Debug, Default)]
struct Near {
    /// Where the particles were when they were looked for [m].
    places: Vec<DVec3>,
    /// The pairs, each once, ascending.
    pairs: Vec<Pair>,
}

/// Two particles that can touch.
#[derive(Clone, Copy, Debug)]
struct Pair {
    ends: [u32; 2],
    /// Distance of the centres at which they touch [m].
    touching: f64,
}

/// Contact of a body with itself.
#[derive(Clone, Debug)]
pub(crate) struct SelfContact {
    /// Stiffness [N/m].
    stiffness: f64,
    /// Damping along the line of the centres [N s/m].
    damping: f64,
    /// Those that can touch, by ascending indices.
    particles: Arc<[SelfTouching]>,
    /// Diameter of the largest of them [m].
    largest: f64,
    near: Scratch<Near>,
}

impl SelfContact {
    /// Contact between these particles of a body, as stiff [N/m] and as damped [N s/m] as this.
    pub(crate) fn new([stiffness, damping]: [f64; 2], particles: Vec<SelfTouching>) -> Self {
        let largest = particles.iter().map(|of| 2.0 * of.radius).fold(0.0, f64::max);
        Self { stiffness, damping, particles: particles.into(), largest, near: Scratch::default() }
    }

    fn places(&self, positions: &[DVec3]) -> Vec<DVec3> {
        self.particles.iter().map(|of| positions[of.particle as usize]).collect()
    }

    /// Looks for pairs that are near, where too much has moved since that was last done. What the body moves as a whole
    /// does not count.
    fn look_around(&mut self, positions: &[DVec3]) {
        let Self { particles, near, .. } = self;
        let slack = SLACK * self.largest;
        let moves = || particles.iter().zip(&near.places).map(|(of, &was)| positions[of.particle as usize] - was);
        let mean = moves().sum::<DVec3>() / particles.len() as f64;
        let is_fresh = near.places.len() == particles.len()
            && moves().all(|moved| (moved - mean).length_squared() <= slack * slack);
        if is_fresh {
            return;
        }
        let places = self.places(positions);
        let pairs = self.pairs_within(&places, 2.0 * slack);
        *self.near = Near { places, pairs };
    }

    /// Pairs that can touch and at `places` [m] are less than `margin` [m] from doing so, ascending.
    fn pairs_within(&self, places: &[DVec3], margin: f64) -> Vec<Pair> {
        if !places.iter().all(|place| place.is_finite()) {
            return Vec::new();
        }
        let grid = PointGrid::new(places, self.largest + margin);
        let mut found = Vec::new();
        for (i, (one, &place)) in self.particles.iter().zip(places).enumerate() {
            for j in grid.within(place).into_iter().map(|j| j as usize).filter(|&j| j > i) {
                let other = &self.particles[j];
                let touching = one.radius + other.radius;
                let apart = FAR_AT_REST * touching * (1.0 - 1e-9);
                let is_near = place.distance_squared(places[j]) < (touching + margin) * (touching + margin);
                if is_near && one.rest.distance_squared(other.rest) >= apart * apart {
                    found.push(Pair { ends: [one.particle, other.particle], touching });
                }
            }
        }
        found
    }
}

impl Force for SelfContact {
    fn add_forces(&mut self, _time: f64, state: &ParticleState, forces: &mut [DVec3]) {
        self.look_around(&state.positions);
        for pair in &self.near.pairs {
            let [i, j] = pair.ends.map(|end| end as usize);
            let line = state.positions[i] - state.positions[j];
            let depth = pair.touching - line.length();
            if depth <= 0.0 {
                continue;
            }
            let Some(normal) = line.try_normalize() else { continue };
            let speed = (state.velocities[i] - state.velocities[j]).dot(normal);
            let push = (self.stiffness * depth - self.damping * speed).max(0.0);
            forces[i] += push * normal;
            forces[j] -= push * normal;
        }
    }

    fn add_energy(&self, _time: f64, state: &ParticleState, energies: &mut Energies) {
        let energy = |pair: Pair| {
            let [a, b] = pair.ends.map(|end| state.positions[end as usize]);
            let depth = pair.touching - a.distance(b);
            0.5 * self.stiffness * depth * depth
        };
        let touching = self.pairs_within(&self.places(&state.positions), 0.0);
        energies.contact += touching.into_iter().map(energy).sum::<f64>();
    }

    fn is_internal(&self) -> bool {
        true
    }

    fn step_limit(&self, state: &ParticleState) -> StepLimit {
        let lightest = state.masses.iter().copied().fold(f64::INFINITY, f64::min);
        // Two of the lightest, each of which gives way.
        let by_mass = 2.0 / lightest;
        StepLimit { frequency_squared: self.stiffness * by_mass, damping_rate: self.damping * by_mass }
    }

    fn changes_until(&self) -> f64 {
        0.0
    }

    fn name(&self) -> &'static str {
        "self_contact"
    }

    fn bytes(&self) -> usize {
        size_of_val(self)
    }

    fn clone_box(&self) -> Box<dyn Force> {
        Box::new(self.clone())
    }
}

/// Particles that lie at the surface of a heap of balls `spacing` [m] apart: there are more on one side of them than on
/// the other, by a fifth of their number times the spacing.
pub(crate) fn surface_particles(points: &[DVec3], spacing: f64) -> Vec<u32> {
    const ONE_SIDED: f64 = 0.2;
    let grid = PointGrid::new(points, 1.6 * spacing);
    let is_surface = |&i: &u32| {
        let place = points[i as usize];
        let around = grid.within(place);
        let sum: DVec3 = around.iter().map(|&j| points[j as usize] - place).sum();
        let others = around.len() - 1;
        others == 0 || sum.length() > ONE_SIDED * spacing * others as f64
    };
    (0..points.len() as u32).filter(is_surface).collect()
}
