//! What of editing can be seen from outside: where things lie in the window, and what is selected.

use crate::sketch::View;
use crate::ui::app::App;
use crate::ui::pane::{Frame, PaneKind, view_name};
use egui::Pos2;
use glam::DVec3;

impl App {
    /// What undo would take back.
    pub fn undo_name(&self) -> Option<&str> {
        self.editor.undo_name()
    }

    /// Whether what is shown has taken up every change of the document.
    pub fn is_up_to_date(&self) -> bool {
        self.published.status.edits >= self.sent_edits
    }

    /// Identifiers of the selected fibres.
    pub fn selected_names(&self) -> Vec<String> {
        self.editing.selection.fibres().to_vec()
    }

    /// Where a drawing view shows the middle of what is selected.
    pub fn shown_middle(&self, view: &str) -> Option<Pos2> {
        self.drawing_frame(view)?.screen(self.pivot()?)
    }

    /// Where a drawing view shows the fibre of this name.
    pub fn shown_course(&self, view: &str, name: &str) -> Option<Vec<Pos2>> {
        let id = &self.active_body()?.fibres.iter().find(|fibre| fibre.name == name)?.id;
        let shown = self.model.bodies.first()?.fibres.iter().find(|fibre| fibre.id == *id)?;
        Some(self.points(view, &shown.vertices))
    }

    /// Where a drawing view shows the vertices of the active fibre.
    pub fn shown_vertices(&self, view: &str) -> Vec<Pos2> {
        self.points(view, &self.active_vertices())
    }

    fn points(&self, view: &str, at: &[DVec3]) -> Vec<Pos2> {
        let Some(frame) = self.drawing_frame(view) else { return Vec::new() };
        at.iter().filter_map(|&point| frame.screen(point)).collect()
    }

    fn drawing_frame(&self, name: &str) -> Option<Frame> {
        let named = |view: View| view_name(view) == name;
        self.view_frames().into_iter().find_map(|(kind, frame)| match kind {
            PaneKind::Drawing(view) if named(view) => Some(frame),
            _ => None,
        })
    }
}
