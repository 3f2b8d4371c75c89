//! How pictures of a run look.

use crate::draw::{Display, Theme};
use crate::solver::snapshot::FieldKind;

/// What pictures show, from where, how large.
#[derive(Clone, Debug)]
#[cfg_attr(not(feature = "render"), allow(dead_code, reason = "without pictures nothing looks at it"))]
pub(crate) struct Look {
    /// From where.
    pub(crate) view: Viewpoint,
    /// Width and height [pixels].
    pub(crate) size: [u32; 2],
    /// What is shown.
    pub(crate) display: Display,
    /// In which colours.
    pub(crate) theme: Theme,
    /// By which field solids are coloured.
    pub(crate) field: Option<FieldKind>,
    /// Whether fibres are coloured by what they carry.
    pub(crate) tension: bool,
    /// Whether fibres are coloured, and bulge, by what they do by themselves.
    pub(crate) activation: bool,
}

/// Points of view.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Viewpoint {
    /// From the front, parallel.
    Front,
    /// From the side, parallel.
    Side,
    /// From above, parallel.
    Top,
    /// In perspective.
    Persp,
    /// As a camera sees it that a person has placed.
    #[cfg(feature = "gui")]
    Placed(crate::render::Camera),
}
