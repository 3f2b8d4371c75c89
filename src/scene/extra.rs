//! JSON fields that this version does not know.

use serde_json::Value;
use std::collections::BTreeMap;

/// JSON fields that this version does not know; kept through load and save.
pub type Extra = BTreeMap<String, Value>;

/// For members that are left out of a file where they are false.
#[allow(clippy::trivially_copy_pass_by_ref, reason = "serde hands over references")]
pub(super) fn is_false(value: &bool) -> bool {
    !value
}

/// For members that are left out of a file where they are zero.
#[allow(clippy::trivially_copy_pass_by_ref, reason = "serde hands over references")]
pub(super) fn is_zero(value: &f64) -> bool {
    *value == 0.0
}
