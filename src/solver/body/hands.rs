//! Hands that lead the drives that parts of a body share.

use super::Body;
use crate::solver::hand::Hand;
use crate::solver::shared_drive::SharedDrive;

impl Body {
    /// The drives that its parts share.
    pub(crate) fn shared_drives(&self) -> &[SharedDrive] {
        &self.shared
    }

    /// Tells it of the drives that its parts share.
    pub(crate) fn share(&mut self, drives: Vec<SharedDrive>) {
        self.shared = drives;
    }

    /// Has a hand lead a shared drive, within two times [s], to a value, or let go of it. False where there is no such
    /// drive.
    pub(in crate::solver) fn lead(&mut self, id: &str, times: [f64; 2], aim: Option<f64>) -> bool {
        let Some(shared) = self.shared.iter().find(|shared| *shared.id == *id) else { return false };
        if let Some(hand) = shared.drive.led(times, aim) {
            self.give(id, Some(hand));
        }
        true
    }

    fn give(&mut self, to: &str, led: Option<Hand>) {
        self.shared.iter_mut().for_each(|shared| shared.drive.give(to, led));
        self.parts.forces.iter_mut().for_each(|force| force.give(to, led));
        self.parts.constraints.iter_mut().for_each(|constraint| constraint.motion.give(to, led));
    }

    /// What leads each of its shared drives.
    pub(super) fn hands(&self) -> Vec<Option<Hand>> {
        self.shared.iter().map(|shared| shared.drive.hand()).collect()
    }

    /// Has these lead its shared drives; its forces are led by them already.
    pub(super) fn take_hands(&mut self, hands: &[Option<Hand>]) {
        for (shared, &hand) in self.shared.iter_mut().zip(hands) {
            if shared.drive.hand() != hand {
                shared.drive.give(&shared.id, hand);
                self.parts.constraints.iter_mut().for_each(|constraint| constraint.motion.give(&shared.id, hand));
            }
        }
    }

    /// Goes on in the hands in which another body was, the same before an edit.
    pub(super) fn adopt_hands(&mut self, other: &Self) {
        for shared in &other.shared {
            if let Some(hand) = shared.drive.hand() {
                self.give(&shared.id, Some(hand));
            }
        }
    }
}
