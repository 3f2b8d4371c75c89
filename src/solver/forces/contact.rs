//! Contact of particles with planes: penalty that only pushes, with Coulomb friction.

use super::force::{Force, StepLimit};
use crate::solver::easing::Easing;
use crate::solver::energy::Energies;
use crate::solver::neighbourhood::outer;
use crate::solver::state::ParticleState;
use glam::{DMat3, DVec3};

/// How a particle, a ball of the law's radius, is pushed out of what it touches.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ContactLaw {
    /// Radius of a particle [m]; half the spacing, so that the skin rests on the surface.
    pub radius: f64,
    /// Stiffness kc [N/m].
    pub stiffness: f64,
    /// Normal damping cc [N s/m].
    pub damping: f64,
    /// Coulomb friction coefficient.
    pub friction: f64,
    /// Slope of the friction force below its Coulomb limit [N s/m].
    pub sticking: f64,
}

impl ContactLaw {
    /// Force [N] on a particle at signed distance `gap` [m] from a surface with outward `normal`, moving at `velocity`
    /// [m/s] relative to it: `N = max(0, kc d - cc vn)` and `|Ft| = min(friction N, ct |vt|)`.
    pub(crate) fn force(&self, gap: f64, normal: DVec3, velocity: DVec3) -> DVec3 {
        let depth = self.radius - gap;
        if depth <= 0.0 {
            return DVec3::ZERO;
        }
        let normal_speed = velocity.dot(normal);
        let push = (self.stiffness * depth - self.damping * normal_speed).max(0.0);
        let slip = velocity - normal_speed * normal;
        let speed = slip.length();
        let drag = (self.friction * push).min(self.sticking * speed);
        let tangential = if speed > 0.0 { slip * (-drag / speed) } else { DVec3::ZERO };
        push * normal + tangential
    }

    /// [`Self::force`] where an allowance of `left` [m], which changes at `rate` [m/s], is granted.
    pub(crate) fn eased_force(&self, gap: f64, normal: DVec3, velocity: DVec3, [left, rate]: [f64; 2]) -> DVec3 {
        self.force(gap + left, normal, velocity + rate * normal)
    }

    /// Elastic energy [J] at signed distance `gap` [m].
    pub(crate) fn energy(&self, gap: f64) -> f64 {
        let depth = (self.radius - gap).max(0.0);
        0.5 * self.stiffness * depth * depth
    }
}

/// A plane; bodies stay on the side its normal points to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    /// A point on it [m].
    pub point: DVec3,
    /// Unit normal into the free side.
    pub normal: DVec3,
}

/// Contact with fixed planes.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Contact {
    /// The planes.
    pub planes: Vec<Plane>,
    /// How they push.
    pub law: ContactLaw,
    /// Planes, by their index, that the body is eased out of.
    pub(crate) eased: Vec<(usize, Easing)>,
}

impl Contact {
    /// Contact that eases the body out of none of the planes.
    pub(crate) fn new(planes: Vec<Plane>, law: ContactLaw) -> Self {
        Self { planes, law, eased: Vec::new() }
    }

    /// How the body is eased out of a plane, if it is.
    pub(crate) fn easing(&self, plane: usize) -> Option<&Easing> {
        self.eased.iter().find(|(index, _)| *index == plane).map(|(_, easing)| easing)
    }

    /// How far plane `index` is granted to be crossed at `time`: the depth [m] and its rate [m/s].
    fn allowance(&self, index: usize, time: f64) -> Option<[f64; 2]> {
        self.easing(index).map(|easing| <[f64; 2]>::from(easing.at(time)))
    }

    /// How deep [m] a particle at `x` is in plane `index` at `time` [s]; negative where it does not touch it.
    fn depth(&self, index: usize, time: f64, x: DVec3) -> f64 {
        let plane = &self.planes[index];
        let left = self.allowance(index, time).map_or(0.0, |[left, _]| left);
        self.law.radius - ((x - plane.point).dot(plane.normal) + left)
    }

    /// Particles that touch a plane at `time` [s], with the planes.
    pub(crate) fn touching(&self, time: f64, positions: &[DVec3]) -> Vec<(u32, u32)> {
        let pairs = (0..self.planes.len()).flat_map(|plane| (0..positions.len()).map(move |i| (i, plane)));
        let touching = pairs.filter(|&(i, plane)| self.depth(plane, time, positions[i]) > 0.0);
        touching.map(|(i, plane)| (i as u32, plane as u32)).collect()
    }

    /// Whether any particle touches a plane at `time` [s].
    pub(crate) fn is_touched(&self, time: f64, positions: &[DVec3]) -> bool {
        (0..self.planes.len()).any(|plane| positions.iter().any(|&x| self.depth(plane, time, x) > 0.0))
    }

    /// How plane `index` resists a particle that touches it [N/m], where velocities change by `1/h` of positions: by its
    /// stiffness and damping along the normal, and across it as far as the particle sticks.
    pub(crate) fn resistance(&self, index: usize, time: f64, x: DVec3, velocity: DVec3, h: f64) -> DMat3 {
        let ContactLaw { stiffness, damping, friction, sticking, .. } = self.law;
        let normal = self.planes[index].normal;
        let velocity = velocity + self.allowance(index, time).map_or(0.0, |[_, rate]| rate) * normal;
        let along = outer(normal, normal);
        let push = (stiffness * self.depth(index, time, x) - damping * velocity.dot(normal)).max(0.0);
        let slip = (velocity - velocity.dot(normal) * normal).length();
        let across = if sticking * slip <= friction * push { sticking } else { friction * push / slip };
        along * (stiffness + damping / h) + (DMat3::IDENTITY - along) * (across / h)
    }

    /// When the body has been eased out of everything [s].
    pub(crate) fn end(&self) -> f64 {
        self.eased.iter().map(|(_, easing)| easing.end()).fold(f64::NEG_INFINITY, f64::max)
    }
}

impl Force for Contact {
    fn add_forces(&mut self, time: f64, state: &ParticleState, forces: &mut [DVec3]) {
        for (index, plane) in self.planes.iter().enumerate() {
            let allowance = self.allowance(index, time);
            for (i, force) in forces.iter_mut().enumerate() {
                let gap = (state.positions[i] - plane.point).dot(plane.normal);
                let velocity = state.velocities[i];
                *force += match allowance {
                    None => self.law.force(gap, plane.normal, velocity),
                    Some(allowance) => self.law.eased_force(gap, plane.normal, velocity, allowance),
                };
            }
        }
    }

    fn add_energy(&self, time: f64, state: &ParticleState, energies: &mut Energies) {
        for (index, plane) in self.planes.iter().enumerate() {
            let (left, kept) =
                self.easing(index).map_or((0.0, 0.0), |easing| (easing.at(time).0, easing.energy_at(time)));
            for x in &state.positions {
                energies.contact += self.law.energy((*x - plane.point).dot(plane.normal) + left);
            }
            energies.contact += kept;
        }
    }

    fn step_limit(&self, state: &ParticleState) -> StepLimit {
        let lightest = state.masses.iter().copied().fold(f64::INFINITY, f64::min);
        StepLimit {
            frequency_squared: self.law.stiffness / lightest,
            damping_rate: self.law.damping.max(self.law.sticking) / lightest,
        }
    }

    fn bytes(&self) -> usize {
        size_of_val(self) + size_of_val(&*self.planes) + size_of_val(&*self.eased)
    }

    fn changes_until(&self) -> f64 {
        self.end().max(0.0)
    }

    fn clone_box(&self) -> Box<dyn Force> {
        Box::new(self.clone())
    }
}
