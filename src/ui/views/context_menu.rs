//! The menu of a right click in a view: what can be done to what lies there.

use super::kind::PaneKind;
use crate::ui::action::Action;
use crate::ui::context::Context;
use crate::ui::controls::menu_entry;
use egui::{Popup, Response, SetOpenCommand};

/// What can be done to chosen fibres, where nothing is chosen, and in a view of either kind.
const CHOSEN: [Action; 9] = [
    Action::Vertices,
    Action::Duplicate,
    Action::Copy,
    Action::Cut,
    Action::Paste,
    Action::Delete,
    Action::Smooth,
    Action::SnapToSurface,
    Action::Hide,
];
/// What can be done to a chosen body or sheet.
const BODY: [Action; 8] = [
    Action::Move,
    Action::Turn,
    Action::Scale,
    Action::Duplicate,
    Action::Copy,
    Action::Cut,
    Action::Delete,
    Action::Hide,
];
const NONE_CHOSEN: [Action; 3] = [Action::Paste, Action::SelectAll, Action::ShowAll];
const DRAWING: [Action; 5] = [Action::DrawTool, Action::SheetTool, Action::SelectTool, Action::Frame, Action::FrameAll];
const RESULT: [Action; 6] =
    [Action::Frame, Action::FrameAll, Action::Follow, Action::XRay, Action::PlayPause, Action::Reset];

/// Opens the menu where the right button is clicked (`opens`), and shows it while it is open.
pub(super) fn context_menu(response: &Response, kind: PaneKind, opens: bool, cx: &mut Context) {
    let command = if opens {
        Some(SetOpenCommand::Bool(true))
    } else {
        response.clicked().then_some(SetOpenCommand::Bool(false))
    };
    Popup::menu(response).open_memory(command).at_pointer_fixed().show(|ui| {
        let of_chosen: &[Action] = match (cx.selection.active(), cx.selection.is_body()) {
            (Some(_), _) => &CHOSEN,
            (None, true) => &BODY,
            (None, false) if cx.selection.sheet().is_some() => &BODY,
            (None, false) => &NONE_CHOSEN,
        };
        for &action in of_chosen {
            menu_entry(ui, cx, action);
        }
        ui.separator();
        let of_view: &[Action] = if kind == PaneKind::Result { &RESULT } else { &DRAWING };
        for &action in of_view {
            menu_entry(ui, cx, action);
        }
    });
}
