//! Contact of particles with planes: penalty that only pushes, with Coulomb friction (see [`super::grip`] for what
//! holds).

use super::force::{Force, StepLimit};
use super::grip::Grip;
use crate::solver::eased_overlap::EasedOverlap;
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
    /// Damping of what acts along the surface below Coulomb's limit [N s/m].
    pub sticking: f64,
    /// Stiffness of what holds there [N/m]; none where it only brakes.
    pub holding: f64,
}

impl ContactLaw {
    /// Normal force [N] at signed distance `gap` [m]: `N = max(0, kc d - cc vn)`.
    fn push(&self, gap: f64, normal_speed: f64) -> f64 {
        (self.stiffness * (self.radius - gap) - self.damping * normal_speed).max(0.0)
    }

    /// Force [N] on a particle at signed distance `gap` [m] from a surface with outward `normal`, moving at `velocity`
    /// [m/s] relative to it, with what holds it stretched by `stretch` [m], of which the part along the surface counts:
    /// `N` and `Ft = -(kt st + ct vt)`, which is cut to `friction N`.
    pub(crate) fn force(&self, gap: f64, normal: DVec3, velocity: DVec3, stretch: DVec3) -> DVec3 {
        if gap >= self.radius {
            return DVec3::ZERO;
        }
        let push = self.push(gap, velocity.dot(normal));
        let (pull, each) = self.pull(normal, velocity, stretch);
        let size = pull.length();
        let drag = (self.friction * push).min(each * size);
        push * normal - if size > 0.0 { pull * (drag / size) } else { DVec3::ZERO }
    }

    /// What acts against a motion along the surface, were there no limit to it: a vector and what it is multiplied by
    /// to be a force [N].
    fn pull(&self, normal: DVec3, velocity: DVec3, stretch: DVec3) -> (DVec3, f64) {
        let slip = velocity.reject_from_normalized(normal);
        if self.holding == 0.0 {
            return (slip, self.sticking);
        }
        (self.holding * stretch.reject_from_normalized(normal) + self.sticking * slip, 1.0)
    }

    /// What is left of a stretch [m] once what holds has been dragged along as far as it must; none of what does not
    /// touch.
    pub(crate) fn dragged(&self, gap: f64, normal: DVec3, velocity: DVec3, stretch: DVec3) -> Option<DVec3> {
        if gap >= self.radius || self.friction <= 0.0 || self.holding <= 0.0 {
            return None;
        }
        let longest = self.friction * self.push(gap, velocity.dot(normal)) / self.holding;
        Some(stretch.reject_from_normalized(normal).clamp_length_max(longest))
    }

    /// How a touch at signed distance `gap` [m] resists [N/m], where velocities change by `1/h` of positions: by
    /// stiffness and damping along the normal, and across it as far as it sticks.
    pub(super) fn resistance(&self, [gap, h]: [f64; 2], normal: DVec3, velocity: DVec3, stretch: DVec3) -> DMat3 {
        let Self { stiffness, damping, friction, sticking, holding, .. } = *self;
        let along = outer(normal, normal);
        let push = self.push(gap, velocity.dot(normal));
        let (pull, each) = self.pull(normal, velocity, stretch);
        let pull = each * pull.length();
        let held = if pull <= friction * push { 1.0 } else { friction * push / pull };
        along * (stiffness + damping / h) + (DMat3::IDENTITY - along) * (held * (holding + sticking / h))
    }

    /// What it asks of the time step.
    pub(super) fn step_limit(&self, state: &ParticleState) -> StepLimit {
        let lightest = state.masses.iter().copied().fold(f64::INFINITY, f64::min);
        StepLimit {
            frequency_squared: self.stiffness.max(self.holding) / lightest,
            damping_rate: self.damping.max(self.sticking) / lightest,
        }
    }

    /// Elastic energy [J] at signed distance `gap` [m], with what holds stretched by `stretch` [m] along the surface.
    pub(crate) fn energy(&self, gap: f64, stretch: DVec3) -> f64 {
        let depth = self.radius - gap;
        if depth <= 0.0 {
            return 0.0;
        }
        0.5 * self.stiffness * depth * depth + 0.5 * self.holding * stretch.length_squared()
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
    pub(crate) eased: Vec<(usize, EasedOverlap)>,
    /// Where particles hold on to each plane [m].
    grips: Vec<Grip<u32>>,
}

impl Contact {
    /// Contact that eases the body out of none of the planes.
    pub(crate) fn new(planes: Vec<Plane>, law: ContactLaw) -> Self {
        Self { grips: vec![Grip::default(); planes.len()], planes, law, eased: Vec::new() }
    }

    /// How the body is eased out of a plane, if it is.
    pub(crate) fn easing(&self, plane: usize) -> Option<&EasedOverlap> {
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

    /// How far [m] what holds a particle at `x` to plane `index` is stretched along it.
    fn stretch(&self, index: usize, particle: u32, x: DVec3) -> DVec3 {
        let held = self.grips[index].of(particle);
        held.map_or(DVec3::ZERO, |place| (x - place).reject_from_normalized(self.planes[index].normal))
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

    /// How plane `index` resists a particle that touches it [N/m], where velocities change by `1/h` of positions: by
    /// its stiffness and damping along the normal, and across it as far as the particle sticks.
    pub(crate) fn resistance(
        &self,
        index: usize,
        time: f64,
        particle: u32,
        [x, velocity]: [DVec3; 2],
        h: f64,
    ) -> DMat3 {
        let normal = self.planes[index].normal;
        let velocity = velocity + self.allowance(index, time).map_or(0.0, |[_, rate]| rate) * normal;
        let gap = self.law.radius - self.depth(index, time, x);
        self.law.resistance([gap, h], normal, velocity, self.stretch(index, particle, x))
    }

    /// Force [N] of all planes on a particle at `time` [s].
    pub(crate) fn force_on(&self, time: f64, state: &ParticleState, i: usize) -> DVec3 {
        let (x, v) = (state.positions[i], state.velocities[i]);
        let force = |(index, plane): (usize, &Plane)| {
            let [left, rate] = self.allowance(index, time).unwrap_or_default();
            let gap = (x - plane.point).dot(plane.normal) + left;
            self.law.force(gap, plane.normal, v + rate * plane.normal, self.stretch(index, i as u32, x))
        };
        self.planes.iter().enumerate().map(force).sum()
    }

    /// When the body has been eased out of everything [s].
    pub(crate) fn end(&self) -> f64 {
        self.eased.iter().map(|(_, easing)| easing.end()).fold(f64::NEG_INFINITY, f64::max)
    }
}

impl Force for Contact {
    fn add_forces(&mut self, time: f64, state: &ParticleState, forces: &mut [DVec3]) {
        for (index, plane) in self.planes.iter().enumerate() {
            let [left, rate] = self.allowance(index, time).unwrap_or_default();
            for (i, force) in forces.iter_mut().enumerate() {
                let x = state.positions[i];
                let gap = (x - plane.point).dot(plane.normal) + left;
                if gap < self.law.radius {
                    let velocity = state.velocities[i] + rate * plane.normal;
                    *force += self.law.force(gap, plane.normal, velocity, self.stretch(index, i as u32, x));
                }
            }
        }
    }

    fn add_energy(&self, time: f64, state: &ParticleState, energies: &mut Energies) {
        for (index, plane) in self.planes.iter().enumerate() {
            let (left, kept) =
                self.easing(index).map_or((0.0, 0.0), |easing| (easing.at(time).0, easing.energy_at(time)));
            for (i, &x) in state.positions.iter().enumerate() {
                let gap = (x - plane.point).dot(plane.normal) + left;
                if gap < self.law.radius {
                    energies.contact += self.law.energy(gap, self.stretch(index, i as u32, x));
                }
            }
            energies.contact += kept;
        }
    }

    fn step_limit(&self, state: &ParticleState) -> StepLimit {
        self.law.step_limit(state)
    }

    fn bytes(&self) -> usize {
        let grips: usize = self.grips.iter().map(|grip| size_of_val(grip) + grip.bytes()).sum();
        size_of_val(self) + size_of_val(&*self.planes) + size_of_val(&*self.eased) + grips
    }

    fn end_step(&mut self, time: f64, state: &ParticleState) -> bool {
        if self.law.holding == 0.0 || self.law.friction == 0.0 {
            return false;
        }
        for index in 0..self.planes.len() {
            let plane = self.planes[index];
            let [left, rate] = self.allowance(index, time).unwrap_or_default();
            let mut held = Vec::new();
            for (i, &x) in state.positions.iter().enumerate() {
                let gap = (x - plane.point).dot(plane.normal) + left;
                if gap < self.law.radius {
                    let velocity = state.velocities[i] + rate * plane.normal;
                    let stretch = self.stretch(index, i as u32, x);
                    let kept = self.law.dragged(gap, plane.normal, velocity, stretch);
                    held.extend(kept.map(|stretch| (i as u32, x - stretch)));
                }
            }
            self.grips[index].renew(held);
        }
        // The force is what it was but where it slides, and there it keeps its size.
        false
    }

    fn adopt(&mut self, before: &[Box<dyn Force>]) {
        let Some(before) = before.iter().find_map(|force| force.downcast_ref::<Self>()) else { return };
        if self.law.holding == 0.0 {
            return;
        }
        for (plane, grip) in self.planes.iter().zip(&mut self.grips) {
            if let Some(index) = before.planes.iter().position(|known| known == plane) {
                grip.clone_from(&before.grips[index]);
            }
        }
    }

    fn changes_until(&self) -> f64 {
        self.end().max(0.0)
    }

    fn name(&self) -> &'static str {
        "room"
    }

    fn clone_box(&self) -> Box<dyn Force> {
        Box::new(self.clone())
    }
}
