//! The rigid turn that a body is taken against.

use glam::DQuat;

/// Mean of rotations that lie near each other; the identity if there is none.
pub(super) fn mean_rotation(rotations: impl IntoIterator<Item = DQuat>) -> DQuat {
    let mut rotations = rotations.into_iter();
    let Some(first) = rotations.next() else { return DQuat::IDENTITY };
    let sum = rotations.fold(first, |sum, q| if q.dot(first) < 0.0 { sum - q } else { sum + q });
    if sum.length_squared() > 0.0 { sum.normalize() } else { first }
}
