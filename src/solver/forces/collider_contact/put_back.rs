//! What is too fast for forces: the way of every particle over a step, in the collider's frame, must not go through the
//! collider, and none may come to lie deeper than a share of the particles' distance. One that would is left at the
//! surface and loses its speed into it, as by a blow without a rebound; the collider takes up the momentum.

use super::{ColliderContact, ContactLaw, Wrench};
use crate::solver::state::ParticleState;
use glam::{BVec3, DVec3};

/// Depth up to which a particle is pushed out, in distances between particles; deeper ones are put back.
const DEEPEST: f64 = 0.15;

/// Share of the particles' distance by which a place may be off.
const ROUND_OFF: f64 = 1e-6;

/// Share of the distance at which points are kept off a shell that is always left of it.
const LEFT_OF_A_SHELL: f64 = 0.2;

impl ColliderContact {
    /// The least distance [m] from one of them that a particle is left at.
    fn least_gap(&self, index: usize, law: &ContactLaw) -> f64 {
        let least = law.radius - DEEPEST * self.spacing;
        if self.colliders[index].obstacle.is_shell() { least.max(LEFT_OF_A_SHELL * law.radius) } else { least }
    }

    /// Puts back what went through a collider, or too deep into one, in the step that ends at a time [s]; `held` are
    /// the axes along which each particle is held. Whether there was any.
    pub(crate) fn put_back(&mut self, time: f64, state: &mut ParticleState, held: impl Fn() -> Vec<BVec3>) -> bool {
        if self.before.len() != state.len() || time <= self.began {
            return false;
        }
        let mut known = None;
        let mut any = false;
        for index in 0..self.colliders.len() {
            let collider = &self.colliders[index];
            let law = self.law(index);
            let (start, end) = (collider.pose(self.began), collider.pose(time));
            let left = self.allowance(index, time).0;
            let least = self.least_gap(index, &law) - left;
            let [a, b] = [&start, &end].map(|pose| collider.bounds(pose, law.radius));
            let (min, max) = (a[0].min(b[0]), a[1].max(b[1]));
            let mut struck = Wrench::default();
            let mut work = 0.0;
            for i in 0..state.len() {
                let (from, x) = (self.before[i], state.positions[i]);
                if from.max(x).cmplt(min).any() || from.min(x).cmpgt(max).any() {
                    continue;
                }
                let way = [start.to_local(from), end.to_local(x)];
                let Some((place, normal)) = self.caught(index, way, &law, least) else { continue };
                let held = known.get_or_insert_with(&held)[i];
                if held.all() {
                    continue;
                }
                let normal = end.rotation * normal;
                state.positions[i] = DVec3::select(held, x, end.to_world(place));
                let carried = end.velocity_at(state.positions[i]);
                let velocity = state.velocities[i] - carried;
                let into = velocity.dot(normal);
                if into < 0.0 {
                    // What a blow takes along the surface is bounded as friction is.
                    let along = velocity.reject_from_normalized(normal);
                    let taken = along.clamp_length_max(law.friction * -into);
                    let change = DVec3::select(held, DVec3::ZERO, -into * normal - taken);
                    state.velocities[i] += change;
                    let impulse = state.masses[i] * change;
                    struck.add(impulse, state.positions[i] - end.translation);
                    work += impulse.dot(carried);
                }
                any = true;
            }
            let touched = &mut self.touched[index];
            touched.struck = struck;
            touched.work += work;
        }
        any
    }

    /// Where a particle belongs that moved so in a collider's own frame, and the unit vector out of the collider there;
    /// none if it may stay.
    fn caught(&self, index: usize, [from, to]: [DVec3; 2], law: &ContactLaw, least: f64) -> Option<(DVec3, DVec3)> {
        let obstacle = &self.colliders[index].obstacle;
        let deep = self.spacing - least.min(0.0);
        let foot = obstacle.foot(to, law.radius, deep);
        // What lies in it and not too deep is pushed out; what has come out of a thing on its other side went through
        // it.
        let lies_in = foot.is_some_and(|foot| foot.gap < 0.0 && foot.gap >= least);
        if !lies_in && let Some(entry) = obstacle.entry(from, to) {
            let at = from.lerp(to, entry.share);
            let place = at + (to - at).reject_from_normalized(entry.normal) + least * entry.normal;
            // Along a surface that bends the other way it would be in it again, or through it.
            let free = obstacle
                .foot(place, f64::INFINITY, deep)
                .is_some_and(|foot| foot.gap >= least - ROUND_OFF * self.spacing);
            let clear = obstacle.entry(from, place).is_none() || least < 0.0;
            return Some((if free && clear { place } else { at + least * entry.normal }, entry.normal));
        }
        let foot = foot.filter(|foot| foot.gap < least)?;
        // One that was deeper before is on its way out.
        let before = obstacle.foot(from, f64::INFINITY, f64::INFINITY).map_or(least, |foot| foot.gap);
        let wanted = before.min(least);
        (foot.gap < wanted).then(|| (to + (wanted - foot.gap) * foot.normal, foot.normal))
    }
}
