//! Rigid horizontal panels that move up and down and press on bodies below them.

use super::body::Body;
use super::drive::Drive;
use super::eased_overlap::EasedOverlap;
use super::forces::{ContactLaw, Grip};
use glam::{DVec2, DVec3};

/// A rigid horizontal panel with one degree of freedom, its height.
#[derive(Clone, Debug, PartialEq)]
pub struct Panel {
    /// Stable identifier of the scene.
    pub id: String,
    /// Height of the underside [m].
    pub height: f64,
    /// Vertical velocity [m/s].
    pub velocity: f64,
    /// Centre in X and Z [m].
    pub center: DVec2,
    /// Half extents along X and Z [m].
    pub half_size: DVec2,
    /// Mass [kg].
    pub mass: f64,
    /// Coulomb friction coefficient of the underside.
    pub friction: f64,
    /// Height of the floor [m], below which it does not go.
    pub floor: Option<f64>,
    /// What its height follows; nothing for a panel that falls.
    pub(crate) driven: Option<DrivenHeight>,
}

/// A height that follows a drive.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct DrivenHeight {
    /// What it follows.
    pub(crate) drive: Drive,
    /// Where it is when the drive is 0 [m].
    pub(crate) height: f64,
    /// How far above that it is when the drive is 1 [m].
    pub(crate) travel: f64,
}

impl Panel {
    /// Whether it does not move at `time` [s], nor will by itself.
    pub(super) fn is_still(&self, time: f64) -> bool {
        self.end() <= time && self.velocity.abs() < 1e-6
    }

    /// Whether a point lies on a vertical line through the panel.
    pub(super) fn is_below_or_above(&self, x: DVec3) -> bool {
        !(DVec2::new(x.x, x.z) - self.center).abs().cmpgt(self.half_size).any()
    }

    /// Adds the panel's push at `time` [s] to the external forces of a body; returns the vertical force on the panel
    /// [N]. Where the body is eased out of it, the underside counts as that much higher. Where its particles hold on to
    /// the panel is kept as places.
    pub(super) fn add_contact(
        &self,
        body: &mut Body,
        eased: Option<&EasedOverlap>,
        grip: &mut Grip<u32>,
        time: f64,
    ) -> f64 {
        let law = ContactLaw { friction: self.friction, ..body.parts().contact };
        let reach = body.parts().reach;
        let (left, rate) = eased.map_or((0.0, 0.0), |easing| easing.at(time));
        if let Some(easing) = eased {
            body.add_contact_energy(easing.energy_at(time));
        }
        let (mut push, mut held) = (0.0, Vec::new());
        for i in 0..body.state().len() {
            let x = body.state().positions[i];
            let gap = self.height - x.y + left;
            // What lies further above the underside than a particle's reach is not pressed, it lies on top.
            if gap > law.radius || gap < -reach || !self.is_below_or_above(x) {
                continue;
            }
            let velocity = body.state().velocities[i] - DVec3::new(0.0, self.velocity + rate, 0.0);
            let stretch = grip.of(i as u32).map_or(DVec3::ZERO, |place| (x - place).reject_from_normalized(DVec3::Y));
            let force = law.force(gap, DVec3::NEG_Y, velocity, stretch);
            body.add_external_force(i, force);
            body.add_contact_energy(law.energy(gap, stretch));
            let kept = law.dragged(gap, DVec3::NEG_Y, velocity, stretch);
            held.extend(kept.map(|stretch| (i as u32, x - stretch)));
            push -= force.y;
        }
        grip.renew(held);
        push
    }

    /// Takes up an impulse of `dt` [s] of `push` [N] from below and of gravity [m/s²]; a driven panel does not yield.
    pub(super) fn kick(&mut self, dt: f64, push: f64, gravity: f64) {
        if self.driven.is_none() && !(self.rests() && push + self.mass * gravity < 0.0) {
            self.velocity += dt * (gravity + push / self.mass);
        }
    }

    /// Moves over one outer step from `time` to `time + dt` [s]. Nothing moves it into the floor.
    pub(super) fn drift(&mut self, time: f64, dt: f64) {
        if self.driven.is_none() {
            self.height += dt * self.velocity;
            self.stop_at_floor();
        }
        self.follow(time + dt);
    }

    /// Puts one that is driven where it has to be at `time` [s], but not into the floor.
    pub(crate) fn follow(&mut self, time: f64) {
        if let Some(DrivenHeight { drive, height, travel }) = &self.driven {
            let (value, rate) = drive.at(time);
            (self.height, self.velocity) = (height + travel * value, travel * rate);
            self.stop_at_floor();
        }
    }

    fn stop_at_floor(&mut self) {
        if let Some(floor) = self.floor
            && self.height < floor
        {
            self.height = floor;
            self.velocity = 0.0;
        }
    }

    /// Whether a falling panel lies on the floor.
    fn rests(&self) -> bool {
        self.velocity == 0.0 && self.floor.is_some_and(|floor| self.height <= floor)
    }

    /// When a driven panel has come to rest [s]; zero for one that falls.
    pub fn end(&self) -> f64 {
        self.driven.as_ref().map_or(0.0, |driven| driven.drive.until())
    }
}
