//! What a reader left out or took another way, for people.

use crate::geometry::model_report::Finding;

/// Something that is good to know.
pub(super) fn note(text: String) -> Finding {
    Finding { text, warning: false }
}

/// Something that a person should look at.
pub(super) fn warning(text: String) -> Finding {
    Finding { text, warning: true }
}
