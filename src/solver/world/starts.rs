//! What a world does about what overlaps when its motion begins.

use super::World;
use super::eased::Eased;
use crate::solver::overlap::{EasedPair, of_bodies, with_collider, with_panel, with_plane};
use crate::solver::panel::Panel;

impl World {
    /// Finds what overlaps and eases it apart from now on. After an edit what is known of before goes on: of bodies
    /// that go on themselves (by the index of each in the world before) a touch is the motion's own.
    pub(super) fn ease_apart(&mut self, before: Option<(&Self, &[Option<usize>])>) {
        let time = self.time();
        let gravity = self.gravity.at(self.time());
        let old = |body: usize| before.and_then(|(world, goes_on)| Some((world, goes_on[body]?)));
        let mut overlaps = Vec::new();
        let mut eased = Eased::default();
        for index in 0..self.bodies.len() {
            let body = &self.bodies[index];
            let mut out_of = Vec::new();
            for (k, plane) in body.planes().iter().enumerate() {
                let known = old(index).map(|(world, was)| &world.bodies[was]).and_then(|was| {
                    let same = was.planes().iter().position(|known| known == plane)?;
                    Some(was.easing(same).copied())
                });
                let easing = known.unwrap_or_else(|| {
                    let found = with_plane(index, body, plane, gravity, time)?;
                    overlaps.push(found);
                    found.easing
                });
                out_of.extend(easing.map(|easing| (k, easing)));
            }
            for (number, panel) in self.panels.iter().enumerate() {
                let known = old(index).and_then(|(world, was)| {
                    // One that an edit has put elsewhere may have been put into the body.
                    let is_same = |known: &Panel| known.id == panel.id && known.height == panel.height;
                    let same = world.panels.iter().position(is_same)?;
                    Some(world.eased.panel(was, same).copied())
                });
                let easing = known.unwrap_or_else(|| {
                    let found = with_panel(index, body, (number, panel), gravity, time)?;
                    overlaps.push(found);
                    found.easing
                });
                eased.panels.extend(easing.map(|easing| (index, number, easing)));
            }
            for first in 0..index {
                if let (Some((world, was)), Some((_, other))) = (old(first), old(index)) {
                    let pair = world.eased.pair(was.min(other), was.max(other)).filter(|_| was < other);
                    eased.pairs.extend(pair.map(|&pair| EasedPair { first, second: index, ..pair }));
                } else if let Some((found, pair)) = of_bodies([first, index], &self.bodies, gravity, time) {
                    overlaps.push(found);
                    eased.pairs.extend(pair);
                }
            }
            self.bodies[index].ease_out(&out_of, time);
            let mut out_of = Vec::new();
            for (number, collider) in self.colliders.iter().enumerate() {
                let known = old(index).and_then(|(world, was)| {
                    let same = world.colliders.iter().position(|known| known == collider)?;
                    Some(world.bodies[was].collider_contact()?.easing(same).copied())
                });
                out_of.push(known.unwrap_or_else(|| {
                    let found = with_collider(index, &self.bodies[index], number, gravity, time)?;
                    overlaps.push(found);
                    found.easing
                }));
            }
            if !out_of.is_empty() {
                self.bodies[index].ease_out_of_colliders(out_of, time);
            }
        }
        self.overlaps = overlaps;
        self.eased = eased;
        if self.eased.end() > time {
            self.evaluate_contact(time, 0.0);
        }
    }
}
