//! How particles hold on to what they touch.
//!
//! Where a particle first touches something, a spring along the surface is tied there, without stretch and as stiff as
//! the contact is across it. The spring is dragged along where its pull would pass Coulomb's limit (Cundall and Strack,
//! 1979): what lies on a slope less steep than the angle of friction stays where it is, and what slides is braked by
//! that limit.

use glam::DVec3;

/// What is remembered of each touch that lasts, by ascending keys.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Grip<K> {
    held: Vec<(K, DVec3)>,
}

impl<K> Default for Grip<K> {
    fn default() -> Self {
        Self { held: Vec::new() }
    }
}

impl<K: Copy + Ord> Grip<K> {
    /// What a touch holds on to: a place or a stretch [m], as whoever keeps the grip has it; none of one that is new.
    pub(crate) fn of(&self, touch: K) -> Option<DVec3> {
        let index = self.held.binary_search_by(|(key, _)| key.cmp(&touch)).ok()?;
        Some(self.held[index].1)
    }

    /// Keeps these touches, in any order, and forgets all others.
    pub(crate) fn renew(&mut self, mut held: Vec<(K, DVec3)>) {
        held.sort_by_key(|(key, _)| *key);
        self.held = held;
    }

    /// All that is held, by ascending keys.
    pub(crate) fn all(&self) -> impl Iterator<Item = (K, DVec3)> {
        self.held.iter().copied()
    }

    /// Whether nothing is held.
    pub(crate) fn is_empty(&self) -> bool {
        self.held.is_empty()
    }

    /// Memory that it takes beside itself [bytes].
    pub(crate) fn bytes(&self) -> usize {
        size_of_val(&*self.held)
    }
}
