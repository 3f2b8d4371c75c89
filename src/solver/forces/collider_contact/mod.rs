//! Contact of a body's particles with colliders: the law of [`super::contact`], in the frame of what is touched.
//!
//! Forces see how far a particle is from each collider where it is; what is too fast for them is caught at the end of a
//! step ([`put_back`]).

mod put_back;

use super::contact::ContactLaw;
use super::force::{Force, StepLimit};
use super::grip::Grip;
use crate::geometry::obstacle_mesh::Foot;
use crate::solver::collider::{Collider, Pose};
use crate::solver::eased_overlap::EasedOverlap;
use crate::solver::energy::Energies;
use crate::solver::scratch::Scratch;
use crate::solver::state::ParticleState;
use glam::{DMat3, DVec3};
use std::sync::Arc;

/// How far from a shell its points are pushed off, in distances between them: they have a side of it, and keep it.
const OFF_A_SHELL: f64 = 0.1;

/// A force [N] and its torque about a collider's origin [N m], or an impulse and its moment.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Wrench {
    force: DVec3,
    torque: DVec3,
}

impl Wrench {
    fn add(&mut self, force: DVec3, arm: DVec3) {
        self.force += force;
        self.torque += arm.cross(force);
    }
}

/// What goes on between a body and one collider.
#[derive(Clone, Debug, Default)]
struct Touched {
    /// Where particles hold on to it [m], in its own frame.
    grip: Grip<u32>,
    /// How the body is eased out of it, if it is.
    easing: Option<EasedOverlap>,
    /// What it pushes the body with at the end of the last step; not known before the first.
    pushes: Option<Wrench>,
    /// By what it struck the body in the present step [N s].
    struck: Wrench,
    /// Mean force of that over the last step [N].
    blow: DVec3,
    /// Work that it has done on the body so far [J].
    work: f64,
}

/// Where a particle touches a collider.
struct Touch {
    gap: f64,
    normal: DVec3,
    velocity: DVec3,
    stretch: DVec3,
}

/// Contact with colliders.
#[derive(Clone, Debug)]
pub(crate) struct ColliderContact {
    colliders: Arc<[Collider]>,
    /// How a particle pushes, but for the friction, which is the collider's.
    law: ContactLaw,
    /// Distance between particles [m].
    spacing: f64,
    touched: Vec<Touched>,
    /// When the present step began [s].
    began: f64,
    /// Where the particles were then [m].
    before: Scratch<Vec<DVec3>>,
}

impl ColliderContact {
    /// Contact of particles that lie `spacing` [m] apart.
    pub(crate) fn new(colliders: Arc<[Collider]>, law: ContactLaw, spacing: f64) -> Self {
        let touched = vec![Touched::default(); colliders.len()];
        Self { colliders, law, spacing, touched, began: 0.0, before: Scratch::default() }
    }

    /// What may be touched.
    pub(crate) fn colliders(&self) -> &[Collider] {
        &self.colliders
    }

    /// How a particle pushes on one of them.
    pub(crate) fn law(&self, index: usize) -> ContactLaw {
        let collider = &self.colliders[index];
        let off = if collider.obstacle.is_shell() { OFF_A_SHELL * self.spacing } else { 0.0 };
        ContactLaw { friction: collider.friction, radius: self.law.radius.max(off), ..self.law }
    }

    /// How the body is eased out of one of them, if it is.
    pub(crate) fn easing(&self, index: usize) -> Option<&EasedOverlap> {
        self.touched[index].easing.as_ref()
    }

    /// Eases the body out of them, one of each or none.
    pub(crate) fn ease_out(&mut self, eased: Vec<Option<EasedOverlap>>) -> bool {
        let changed = self.touched.iter().zip(&eased).any(|(touched, easing)| touched.easing != *easing);
        for (touched, easing) in self.touched.iter_mut().zip(eased) {
            touched.easing = easing;
        }
        changed
    }

    /// Force of the body on one of them at the end of the last step, blows by their mean over it [N].
    pub(crate) fn force_on(&self, index: usize) -> DVec3 {
        let touched = &self.touched[index];
        -(touched.pushes.unwrap_or_default().force + touched.blow)
    }

    /// Work that one of them has done on the body so far [J].
    pub(crate) fn work_of(&self, index: usize) -> f64 {
        self.touched[index].work
    }

    /// Work that they have done on the body so far [J].
    pub(crate) fn work(&self) -> f64 {
        self.touched.iter().map(|touched| touched.work).sum()
    }

    /// When the body has been eased out of all of them [s].
    pub(crate) fn end(&self) -> f64 {
        let easings = self.touched.iter().filter_map(|touched| touched.easing.as_ref());
        easings.map(EasedOverlap::end).fold(f64::NEG_INFINITY, f64::max)
    }

    /// When the last of them stands still [s].
    fn motion_end(&self) -> f64 {
        self.colliders.iter().map(|collider| collider.motion.end()).fold(0.0, f64::max)
    }

    fn allowance(&self, index: usize, time: f64) -> (f64, f64) {
        self.touched[index].easing.map_or((0.0, 0.0), |easing| easing.at(time))
    }

    /// Where a particle at `x` [m] touches one of them, granted depth included, and the unit vector out of it there, in
    /// the world.
    fn foot(&self, index: usize, pose: &Pose, left: f64, law: &ContactLaw, x: DVec3) -> Option<Foot> {
        let deep = left + self.spacing;
        let foot = self.colliders[index].obstacle.foot(pose.to_local(x), law.radius - left, deep)?;
        Some(Foot { gap: foot.gap + left, normal: pose.rotation * foot.normal })
    }

    /// Calls `found` with every particle that touches one of them, in order.
    fn each_touch(
        &self,
        index: usize,
        time: f64,
        state: &ParticleState,
        mut found: impl FnMut(usize, &ContactLaw, &Pose, Touch),
    ) {
        let collider = &self.colliders[index];
        let law = self.law(index);
        let pose = collider.pose(time);
        let (left, rate) = self.allowance(index, time);
        let [min, max] = collider.bounds(&pose, law.radius);
        for (i, &x) in state.positions.iter().enumerate() {
            if !(x.cmpge(min).all() && x.cmple(max).all()) {
                continue;
            }
            let Some(Foot { gap, normal }) = self.foot(index, &pose, left, &law, x) else { continue };
            let velocity = state.velocities[i] - pose.velocity_at(x) + rate * normal;
            let held = self.touched[index].grip.of(i as u32);
            let stretch = held.map_or(DVec3::ZERO, |place| (x - pose.to_world(place)).reject_from_normalized(normal));
            found(i, &law, &pose, Touch { gap, normal, velocity, stretch });
        }
    }

    /// Particles that touch any at a time [s], with the indices of what they touch.
    pub(crate) fn touching(&self, time: f64, positions: &[DVec3]) -> Vec<(u32, u32)> {
        let touching = |index: usize| {
            let collider = &self.colliders[index];
            let (law, pose, left) = (self.law(index), collider.pose(time), self.allowance(index, time).0);
            let [min, max] = collider.bounds(&pose, law.radius);
            let near = move |x: DVec3| x.cmpge(min).all() && x.cmple(max).all();
            let found = positions
                .iter()
                .enumerate()
                .filter(move |&(_, &x)| near(x) && self.foot(index, &pose, left, &law, x).is_some());
            found.map(move |(i, _)| (i as u32, index as u32))
        };
        (0..self.colliders.len()).flat_map(touching).collect()
    }

    /// Unit vector out of one of them where a particle at `x` [m] touches it at a time [s].
    pub(crate) fn normal(&self, index: usize, time: f64, x: DVec3) -> Option<DVec3> {
        let pose = self.colliders[index].pose(time);
        Some(self.foot(index, &pose, self.allowance(index, time).0, &self.law(index), x)?.normal)
    }

    /// How one of them resists a particle that touches it [N/m], as [`super::Contact::resistance`] has it for a plane.
    pub(crate) fn resistance(&self, index: usize, time: f64, particle: u32, moving: [DVec3; 2], h: f64) -> DMat3 {
        let pose = self.colliders[index].pose(time);
        let law = self.law(index);
        let (left, rate) = self.allowance(index, time);
        let [x, velocity] = moving;
        let Some(Foot { gap, normal }) = self.foot(index, &pose, left, &law, x) else { return DMat3::ZERO };
        let velocity = velocity - pose.velocity_at(x) + rate * normal;
        let held = self.touched[index].grip.of(particle);
        let stretch = held.map_or(DVec3::ZERO, |place| (x - pose.to_world(place)).reject_from_normalized(normal));
        law.resistance([gap, h], normal, velocity, stretch)
    }

    /// Told where a step begins.
    pub(crate) fn begin_step(&mut self, time: f64, state: &ParticleState) {
        self.began = time;
        (*self.before).clone_from(&state.positions);
        for index in 0..self.colliders.len() {
            if self.touched[index].pushes.is_none() {
                self.touched[index].pushes = Some(self.pushes(index, time, state));
            }
        }
    }

    /// What one of them pushes the body with.
    fn pushes(&self, index: usize, time: f64, state: &ParticleState) -> Wrench {
        let mut sum = Wrench::default();
        self.each_touch(index, time, state, |i, law, pose, touch| {
            let Touch { gap, normal, velocity, stretch } = touch;
            sum.add(law.force(gap, normal, velocity, stretch), state.positions[i] - pose.translation);
        });
        sum
    }
}

impl Force for ColliderContact {
    fn add_forces(&mut self, time: f64, state: &ParticleState, forces: &mut [DVec3]) {
        for index in 0..self.colliders.len() {
            self.each_touch(index, time, state, |i, law, _, touch| {
                forces[i] += law.force(touch.gap, touch.normal, touch.velocity, touch.stretch);
            });
        }
    }

    fn add_energy(&self, time: f64, state: &ParticleState, energies: &mut Energies) {
        for index in 0..self.colliders.len() {
            self.each_touch(index, time, state, |_, law, _, touch| {
                energies.contact += law.energy(touch.gap, touch.stretch);
            });
            energies.contact += self.touched[index].easing.map_or(0.0, |easing| easing.energy_at(time));
        }
    }

    fn step_limit(&self, state: &ParticleState) -> StepLimit {
        self.law.step_limit(state)
    }

    fn bytes(&self) -> usize {
        let grips: usize = self.touched.iter().map(|touched| touched.grip.bytes()).sum();
        size_of_val(self) + size_of_val(&*self.touched) + grips
    }

    fn end_step(&mut self, time: f64, state: &ParticleState) -> bool {
        for index in 0..self.colliders.len() {
            let mut held = Vec::new();
            let mut pushes = Wrench::default();
            self.each_touch(index, time, state, |i, law, pose, touch| {
                let Touch { gap, normal, velocity, stretch } = touch;
                let x = state.positions[i];
                pushes.add(law.force(gap, normal, velocity, stretch), x - pose.translation);
                let kept = law.dragged(gap, normal, velocity, stretch);
                held.extend(kept.map(|stretch| (i as u32, pose.to_local(x - stretch))));
            });
            let collider = &self.colliders[index];
            let (start, end) = (collider.pose(self.began), collider.pose(time));
            let touched = &mut self.touched[index];
            touched.grip.renew(held);
            // By the mean of the forces at both ends.
            let before = touched.pushes.unwrap_or_default();
            let turned = (end.rotation * start.rotation.inverse()).to_scaled_axis();
            touched.work += 0.5 * (before.force + pushes.force).dot(end.translation - start.translation)
                + 0.5 * (before.torque + pushes.torque).dot(turned);
            touched.pushes = Some(pushes);
            let dt = time - self.began;
            let struck = std::mem::take(&mut touched.struck);
            touched.blow = if dt > 0.0 { struck.force / dt } else { DVec3::ZERO };
        }
        false
    }

    fn adopt(&mut self, before: &[Box<dyn Force>]) {
        let Some(before) = before.iter().find_map(|force| force.downcast_ref::<Self>()) else { return };
        for (collider, touched) in self.colliders.iter().zip(&mut self.touched) {
            if let Some(index) = before.colliders.iter().position(|known| known.id == collider.id) {
                let known = &before.touched[index];
                touched.work = known.work;
                if before.colliders[index] == *collider {
                    touched.grip.clone_from(&known.grip);
                }
            }
        }
    }

    fn remembered(&self, number: &mut dyn FnMut(f64)) {
        for (index, touched) in self.touched.iter().enumerate() {
            for (particle, place) in touched.grip.all() {
                [index as f64, f64::from(particle)].into_iter().chain(place.to_array()).for_each(&mut *number);
            }
        }
    }

    fn changes_until(&self) -> f64 {
        self.end().max(self.motion_end())
    }

    fn driven_until(&self) -> f64 {
        self.end().max(self.motion_end())
    }

    fn name(&self) -> &'static str {
        "colliders"
    }

    fn clone_box(&self) -> Box<dyn Force> {
        Box::new(self.clone())
    }
}
