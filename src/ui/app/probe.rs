//! What of the window can be seen from outside: the document, the newest state, and where things lie.

use super::App;
use crate::scene::Scene;
use crate::sim::{Published, TimeSeriesSet};
use crate::sketch::pattern::Polyline;
use crate::ui::dialogs::Dialog;
use crate::ui::export;
use crate::ui::gallery::EXAMPLES;
use crate::ui::right_panel::PropertyTab;
use crate::ui::views::{PaneKind, ViewFrame};
use egui::Pos2;
use glam::DVec3;
use std::path::Path;
use std::sync::Arc;

impl App {
    /// The document.
    pub fn scene(&self) -> &Arc<Scene> {
        self.cx.scene()
    }

    /// The newest state of the simulation.
    pub fn published(&self) -> &Published {
        self.cx.simulation.published()
    }

    /// What was said last.
    pub fn message(&self) -> Option<&str> {
        self.cx.status.message.as_ref().map(|(_, text)| text.as_str())
    }

    /// What is said at a body about what the last change does.
    pub fn effect(&self) -> Option<&str> {
        self.cx.effect.as_ref().map(|effect| effect.text.as_str())
    }

    /// Body, vertex and target [m] of what is grabbed.
    pub fn grabbed(&self) -> Option<(usize, usize, DVec3)> {
        self.cx.simulation.grabbed().map(|grabbed| (grabbed.body, grabbed.vertex, grabbed.target))
    }

    /// What undo would take back.
    pub fn undo_name(&self) -> Option<&str> {
        self.cx.document.undo_name()
    }

    /// Whether what is shown has taken up every change of the document.
    pub fn is_up_to_date(&self) -> bool {
        self.cx.simulation.is_up_to_date()
    }

    /// Looks at the numbers of every frame since the start.
    pub fn time_series<T>(&self, read: impl FnOnce(&TimeSeriesSet) -> T) -> T {
        self.cx.simulation.time_series(read)
    }

    /// Writes every number that is kept as a table.
    pub fn export(&mut self, path: &Path) {
        export::export(&mut self.cx, path);
    }

    /// What is told of what was written last, beside the window.
    pub fn written(&self) -> Option<&str> {
        self.transfer.told()
    }

    /// Whether a document is being read.
    pub fn is_loading(&self) -> bool {
        matches!(self.dialog, Some(Dialog::Loading(_)))
    }

    /// Whether the examples are shown.
    pub fn shows_examples(&self) -> bool {
        matches!(self.dialog, Some(Dialog::Examples))
    }

    /// How many of the examples' pictures have been decoded.
    pub fn decoded_examples(&self) -> usize {
        EXAMPLES.iter().filter(|example| self.gallery.has_decoded(example.name)).count()
    }

    /// The chosen pattern's fibres where they would be, model frame [m]; none while no pattern is shown.
    pub fn pattern_preview(&self) -> Vec<Polyline> {
        let is_shown = self.right_panel.tab() == PropertyTab::Patterns;
        self.patterns.preview(is_shown, &self.cx).lines
    }

    /// Identifiers of the selected fibres.
    pub fn selected_names(&self) -> Vec<String> {
        self.cx.selection.fibres().to_vec()
    }

    /// Identifier of the selected sheet.
    pub fn selected_sheet(&self) -> Option<String> {
        self.cx.selection.sheet().cloned()
    }

    /// Vertices of the surface that strokes sweep so far, model frame [m]; none unless a sheet is being drawn.
    pub fn swept_preview(&self) -> Vec<DVec3> {
        self.views.swept_preview(&self.cx)
    }

    /// The selected keys of drives: what people call the drive, and which of its keys.
    pub fn selected_keys(&self) -> Vec<(String, usize)> {
        let drives = self.cx.keys.drives().into_iter();
        let keys = drives.flat_map(|of| self.cx.keys.of(&of).into_iter().map(move |index| (of.clone(), index)));
        keys.map(|(of, index)| (of.title(self.scene()), index)).collect()
    }

    /// Identifier of the body that is selected as a whole.
    pub fn selected_body(&self) -> Option<String> {
        self.cx.chosen_body().map(|body| body.id().to_owned())
    }

    /// Where the result view shows a point of the world [m]; none behind its eye.
    pub fn shown_at(&self, point: DVec3) -> Option<Pos2> {
        self.views.shown_at(point)
    }

    /// Where a drawing view shows the middle of what is selected.
    pub fn shown_middle(&self, view: &str) -> Option<Pos2> {
        self.drawing_frame(view)?.screen(self.cx.pivot()?)
    }

    /// Where a drawing view shows the fibre of this name.
    pub fn shown_course(&self, view: &str, name: &str) -> Option<Vec<Pos2>> {
        let id = &self.cx.active_body()?.fibres.iter().find(|fibre| fibre.name == name)?.id;
        let shown = self.cx.active.model.bodies.first()?.fibres.iter().find(|fibre| fibre.id == *id)?;
        Some(self.points(view, &shown.vertices))
    }

    /// Where a drawing view shows the vertices of the active fibre.
    pub fn shown_vertices(&self, view: &str) -> Vec<Pos2> {
        self.points(view, &self.cx.active_vertices())
    }

    fn points(&self, view: &str, at: &[DVec3]) -> Vec<Pos2> {
        let Some(frame) = self.drawing_frame(view) else { return Vec::new() };
        at.iter().filter_map(|&point| frame.screen(point)).collect()
    }

    fn drawing_frame(&self, name: &str) -> Option<ViewFrame> {
        let is_named = |frame: &ViewFrame| frame.kind != PaneKind::Result && frame.kind.title() == name;
        self.views.frames().into_iter().find(is_named)
    }
}
