//! What is said at the foot of the window, and at bodies.

use glam::DVec3;

/// How serious a message is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Severity {
    /// Something was done.
    Note,
    /// Something should be looked at.
    Warning,
    /// Something was not done.
    Error,
}

/// The last message, and what can be done where the pointer is.
#[derive(Debug, Default)]
pub(crate) struct StatusLine {
    /// What was said last.
    pub message: Option<(Severity, String)>,
    /// Whether that is true of the scene as it is, whatever else is done meanwhile.
    pub of_scene: bool,
    /// How far the drawing of a fibre has come: a number for each of its stages.
    pub strokes: u8,
    /// What can be done now.
    pub hint: &'static str,
    /// What is being done, in place of the hint.
    pub gesture: Option<String>,
    /// Fibre that was drawn last: how its strokes were taken can still be chosen beside the message.
    pub drawn_fibre: Option<String>,
    /// Whether two strokes were refused that make a fibre where the second is stretched onto the first.
    pub offers_stretch: bool,
}

/// Something that is said at a body.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct EffectNote {
    /// What.
    pub text: String,
    /// Above which point [m], world.
    pub at: DVec3,
}
