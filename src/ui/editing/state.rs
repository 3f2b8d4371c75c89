//! What is being done to what is selected.

use super::handle::Handle;
use super::moving::{Change, Moving};
use crate::scene::Dab;
use crate::ui::views::PaneKind;
use egui::Pos2;
use glam::DVec3;

/// What is being done to what is selected.
#[derive(Clone, Debug, Default)]
pub(crate) struct Editing {
    /// A move or turn under way, and the view in which it goes on.
    pub(super) moving: Option<(Moving, PaneKind)>,
    /// What the last move asked for and is not in the document yet.
    pub(super) pending: Option<Change>,
    /// A box that is to be drawn around what is to be selected.
    pub(super) boxed: Option<BoxDrag>,
    /// The handle under the pointer.
    pub(super) hovered: Option<Handle>,
    /// The brush, while it is in use.
    pub(super) brush: Option<Brush>,
    /// The right button has just given a gesture up: its click is no call for a menu.
    pub(super) given_up: bool,
    /// Tab was pressed for a command.
    tabbed: bool,
}

/// A box around what is to be selected.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct BoxDrag {
    /// Where it began; none before the button is pressed.
    pub from: Option<Pos2>,
}

/// What a brush paints.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Paints {
    /// The volume fraction of a fibre solid.
    Fraction,
    /// How much follows a motion, by its identifier.
    Follow(String),
}

/// The brush, while it is in use.
#[derive(Clone, Debug)]
pub(super) struct Brush {
    /// What it paints of the active body.
    pub paints: Paints,
    /// Beyond it the brush does nothing [m].
    pub radius: f64,
    /// The fraction, or the share, that is painted.
    pub value: f64,
    /// How much of the way to that value one stroke goes.
    pub strength: f64,
    /// Where the last dab of this stroke lies [m].
    pub last: Option<DVec3>,
    /// Changes of one stroke are one step of undo.
    pub gesture: u64,
    /// Dabs that are not in the document yet.
    pub waiting: Vec<Dab>,
}

impl Editing {
    /// What goes on, for the status bar; none while nothing does.
    pub(crate) fn hint(&self) -> Option<String> {
        self.moving.as_ref().map(|(moving, _)| moving.hint())
    }

    /// Whether the brush is in use.
    pub(crate) fn paints(&self) -> bool {
        self.brush.is_some()
    }

    /// Draws a box around what is to be selected.
    pub(crate) fn begin_box(&mut self) {
        self.boxed = Some(BoxDrag::default());
    }

    /// Tab was pressed for a command: it must not leave the keys with some button.
    pub(crate) fn note_tab(&mut self) {
        self.tabbed = true;
    }

    /// Keeps the keys with the views after Tab.
    pub(crate) fn keep_keys(&mut self, ctx: &egui::Context) {
        if std::mem::take(&mut self.tabbed) {
            ctx.memory_mut(egui::Memory::stop_text_input);
        }
    }

    /// Whether a right click asks for a menu.
    pub(crate) fn opens_menu(&self) -> bool {
        !self.given_up && !self.has_gesture()
    }

    /// The right button was let go: its next click asks for a menu again.
    pub(crate) fn note_release(&mut self) {
        self.given_up = false;
    }

    /// Whether a move, a turn or a box is under way.
    pub(crate) fn has_gesture(&self) -> bool {
        self.moving.is_some() || self.boxed.is_some()
    }

    /// Whether the pointer belongs to a gesture of editing, so that it neither draws nor grabs.
    pub(crate) fn has_pointer(&self, view: PaneKind) -> bool {
        let paints = self.brush.is_some() && view == PaneKind::Result;
        self.moving.is_some() || self.boxed.is_some() || self.hovered.is_some() || paints
    }
}
