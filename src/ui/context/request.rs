//! What a panel asks of the window because it concerns other panels.

use crate::ui::action::Action;
use crate::ui::bodies::Incoming;
use crate::ui::dialogs::Dialog;
use glam::DVec3;
use std::path::PathBuf;

/// Something that the window does as soon as the panel has been shown.
pub(crate) enum Request {
    /// Does what an action is for.
    Do(Action),
    /// Opens something over the window.
    Open(Dialog),
    /// Opens a file of those that were used.
    OpenRecent(PathBuf),
    /// Forgets the files that were used.
    ForgetRecent,
    /// Reads what a body from elsewhere names and puts it into the scene.
    Bring(Box<Incoming>),
    /// Selects the body of this identifier as a whole, and draws into it from now on.
    ChooseBody(String),
    /// Shows the layouts of fibres.
    ShowPatterns,
    /// Shows what surrounds the bodies.
    ShowWorld,
    /// Takes the refused strokes by stretching the second onto the first.
    StretchStrokes,
    /// Fills this part of the body with the chosen pattern: least and greatest corner, model frame [m].
    FillRegion([DVec3; 2]),
}
