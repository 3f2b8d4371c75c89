//! The fibres of a pattern where they would be, before they are there.

use crate::sketch::pattern::Polyline;
use glam::DVec3;

/// What the views show of the pattern that is chosen.
#[derive(Clone, Debug, Default)]
pub(crate) struct PatternPreview {
    /// Its fibres where they would be, model frame [m].
    pub lines: Vec<Polyline>,
    /// Least and greatest corner of what it fills, model frame [m]; none before the body is there.
    pub bounds: Option<[DVec3; 2]>,
    /// Whether a pattern is chosen and shown.
    pub is_shown: bool,
    /// Whether boxes are dragged around the part that it fills rather than strokes drawn.
    pub takes_region: bool,
}
