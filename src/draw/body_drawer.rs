//! Who draws one body: build.rs its skin, fibre.rs its fibres, particles.rs what it is made of.

use super::list::{DrawList, PickId, PickKind};
use super::options::Display;
use super::{Colour, Theme};

/// Share of a fibre's mark that shows through the skin.
pub(super) const THROUGH: f32 = 0.35;

/// Draws one body.
pub(super) struct BodyDrawer<'a> {
    pub(super) index: u32,
    pub(super) spacing: f64,
    pub(super) display: &'a Display,
    pub(super) theme: &'a Theme,
}

impl BodyDrawer<'_> {
    pub(super) fn tint(&self) -> Option<Colour> {
        self.display.tints.get(self.index as usize).copied()
    }

    pub(super) fn number(&self, kind: PickKind, count: usize, list: &mut DrawList) -> u32 {
        list.register(PickId { body: self.index, kind, index: 0 }, count)
    }
}
