//! What panels ask of the window because it concerns other panels.

use super::App;
use crate::io::RecentFiles;
use crate::ui::context::Request;
use crate::ui::loading::Source;
use crate::ui::right_panel::PropertyTab;

impl App {
    /// Does what the panel that was just shown asked for.
    pub(super) fn carry_out(&mut self, ctx: &egui::Context) {
        // What is done may leave further requests.
        while let Some(request) = self.cx.next_request() {
            match request {
                Request::Do(action) => self.dispatch(ctx, action),
                Request::Open(dialog) => self.dialog = Some(dialog),
                Request::OpenRecent(path) => self.open_recent(ctx, path),
                Request::ForgetRecent => self.recent = RecentFiles::default(),
                Request::Bring(incoming) => self.load(ctx, Source::Body(incoming)),
                Request::ChooseBody(id) => {
                    let place = self.cx.scene().all_bodies().position(|body| body.id() == id);
                    if let Some(index) = place {
                        self.activate(index);
                        self.cx.selection.choose_body();
                    }
                }
                Request::ShowPatterns => self.right_panel.show_tab(PropertyTab::Patterns),
                Request::ShowWorld => self.right_panel.show_tab(PropertyTab::World),
                Request::StretchStrokes => self.views.sketching().stretch(&mut self.cx),
                Request::FillRegion(corners) => self.patterns.fill_region(corners),
            }
        }
    }

    /// Draws into another body from now on.
    fn activate(&mut self, index: usize) {
        if self.cx.active.index != index {
            self.cx.activate(index);
            self.views.forget_gestures();
            self.patterns.forget_region();
            self.views.reframe(false);
        }
    }
}
