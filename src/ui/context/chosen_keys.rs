//! Which keys of drives are selected.

use crate::scene::Drivable;

/// Keys by the drive that they belong to and their number in it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct ChosenKeys(Vec<(Drivable, usize)>);

impl ChosenKeys {
    /// Whether none is selected.
    pub(crate) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// How many are selected.
    pub(crate) fn len(&self) -> usize {
        self.0.len()
    }

    /// Whether a key is selected.
    pub(crate) fn contains(&self, of: &Drivable, index: usize) -> bool {
        self.0.iter().any(|(known, k)| known == of && *k == index)
    }

    /// Numbers of the selected keys of a drive.
    pub(crate) fn of(&self, of: &Drivable) -> Vec<usize> {
        self.0.iter().filter(|(known, _)| known == of).map(|(_, index)| *index).collect()
    }

    /// The drives that have selected keys, each once.
    pub(crate) fn drives(&self) -> Vec<Drivable> {
        let mut drives: Vec<Drivable> = self.0.iter().map(|(of, _)| of.clone()).collect();
        drives.sort();
        drives.dedup();
        drives
    }

    /// Selects these keys and no others.
    pub(crate) fn set(&mut self, keys: Vec<(Drivable, usize)>) {
        self.0 = keys;
    }

    /// Selects these keys, too.
    pub(crate) fn add(&mut self, keys: impl IntoIterator<Item = (Drivable, usize)>) {
        for (of, index) in keys {
            if !self.contains(&of, index) {
                self.0.push((of, index));
            }
        }
    }

    /// Selects a key, or no longer.
    pub(crate) fn toggle(&mut self, of: &Drivable, index: usize) {
        let before = self.0.len();
        self.0.retain(|(known, k)| known != of || *k != index);
        if self.0.len() == before {
            self.0.push((of.clone(), index));
        }
    }

    /// Selects these keys of a drive in place of its others.
    pub(crate) fn set_of(&mut self, of: &Drivable, which: &[usize]) {
        self.0.retain(|(known, _)| known != of);
        self.0.extend(which.iter().map(|index| (of.clone(), *index)));
    }

    /// Selects none.
    pub(crate) fn clear(&mut self) {
        self.0.clear();
    }

    /// Forgets those that are not there any more; `count` is how many keys a drive has.
    pub(crate) fn keep(&mut self, count: impl Fn(&Drivable) -> usize) {
        self.0.retain(|(of, index)| *index < count(of));
    }
}
