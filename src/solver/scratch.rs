//! Buffers that live between evaluations to spare allocations, and carry nothing from one to the next.

use std::ops::{Deref, DerefMut};

/// A buffer that a copy of its owner does not take along: a copy's is empty, and whoever uses it first makes it fit. So
/// a copy of a force is as large as what its next evaluation depends on.
#[derive(Debug, Default)]
pub(crate) struct Scratch<T>(T);

impl<T: Default> Clone for Scratch<T> {
    fn clone(&self) -> Self {
        Self::default()
    }

    fn clone_from(&mut self, _: &Self) {}
}

impl<T> Deref for Scratch<T> {
    type Target = T;

    fn deref(&self) -> &T {
        &self.0
    }
}

impl<T> DerefMut for Scratch<T> {
    fn deref_mut(&mut self) -> &mut T {
        &mut self.0
    }
}
