//! The window: what it is made of, and one frame of it.

mod answers;
mod dispatch;
mod files;
mod leaving;
mod listening;
mod memory;
mod preferences;
mod probe;
mod requests;

use super::autosave::{Autosave, Question};
use super::breaks::BreakWatch;
use super::comparison::Comparison;
use super::context::{Context, OpenDocument, Severity, Simulation};
use super::dialogs::Dialog;
use super::document::Document;
use super::effect::EffectShow;
use super::ended::before_the_end;
use super::gallery::Gallery;
use super::input_order::InputOrder;
use super::opening::Opening;
use super::patterns::Patterns;
use super::remedy::Remedy;
use super::right_panel::{PropertyTab, RightPanel};
use super::said::Said;
use super::theme::Tone;
use super::time_series::TimeSeriesPanel;
use super::timeline::Timeline;
use super::top_bar::TopBar;
use super::transfer::Transfer;
use super::views::{Painter, Views};
use super::{outliner, status_bar};
use crate::io::RecentFiles;
use std::path::PathBuf;

/// The window: the document with its simulation, and the panels that show and change them.
pub struct App {
    cx: Context,
    views: Views,
    top_bar: TopBar,
    right_panel: RightPanel,
    timeline: Timeline,
    time_series: TimeSeriesPanel,
    comparison: Comparison,
    patterns: Patterns,
    gallery: Gallery,
    transfer: Transfer,
    autosave: Autosave,
    breaks: BreakWatch,
    remedy: Remedy,
    opening: Opening,
    effect: EffectShow,
    said: Said,
    recent: RecentFiles,
    /// Scenes that may read models wherever they lie: the person let them, or they were saved here.
    trusted: Vec<PathBuf>,
    /// What is open over the window.
    dialog: Option<Dialog>,
    title: String,
    /// Whether the size of the interface has been chosen, or fitted to the screen.
    suits_the_screen: bool,
}

impl App {
    /// A window on a document. Without a render state nothing is painted into the views, but
    /// everything else works.
    pub fn new(ctx: &egui::Context, render: Option<egui_wgpu::RenderState>, document: Document) -> Self {
        let (note, asks) = (document.note.clone(), document.asks.clone());
        let tone = Tone::Dark;
        tone.apply(ctx);
        ctx.add_plugin(InputOrder::default());
        let document = OpenDocument::new(document);
        let autosave = Autosave::start(ctx, &document);
        let mut recent = RecentFiles::default();
        if let Some(path) = &document.path {
            recent.add(path);
        }
        let repaint = ctx.clone();
        let simulation = Simulation::start(&document, move || repaint.request_repaint());
        autosave.record(simulation.journal_tail(), &document);
        let mut cx = Context::new(document, simulation, tone);
        cx.status.message = note.map(|note| (Severity::Note, note));
        Self {
            cx,
            views: Views::new(render.map(Painter::new)),
            top_bar: TopBar::default(),
            right_panel: RightPanel::default(),
            timeline: Timeline::default(),
            time_series: TimeSeriesPanel::default(),
            comparison: Comparison::default(),
            patterns: Patterns::default(),
            gallery: Gallery::default(),
            transfer: Transfer::default(),
            autosave,
            breaks: BreakWatch::default(),
            remedy: Remedy::default(),
            opening: Opening::default(),
            effect: EffectShow::default(),
            said: Said::default(),
            recent,
            trusted: Vec::new(),
            dialog: asks.map(|(path, files)| Dialog::Question(Question::Outside { path, files })),
            title: String::new(),
            suits_the_screen: false,
        }
    }

    /// Keeps a person's own patterns in this folder; nowhere unless one is given.
    #[must_use]
    pub fn with_pattern_folder(self, folder: PathBuf) -> Self {
        Self { patterns: self.patterns.with_folder(folder), ..self }
    }

    /// Keeps changed documents in a folder, from which they are recovered when the program ended without asking;
    /// without one nothing is kept.
    #[must_use]
    pub fn with_recovery(self, folder: impl Into<PathBuf>) -> Self {
        self.autosave.keep_in(folder.into());
        self
    }

    /// Keeps changes before the program is ended from outside: by Ctrl-C in its terminal, by the end of that terminal
    /// or of the session, by whoever wants it to end. It ends as it would have, then.
    #[must_use]
    pub fn with_ends_from_outside(self) -> Self {
        before_the_end(self.autosave.keeping());
        self
    }

    /// Plays the scene in slow motion beside itself without fibres, over and over until something is touched.
    pub fn welcome(&mut self) {
        self.opening.begin(&mut self.cx, &mut self.top_bar);
    }

    /// One frame of the window.
    pub fn show(&mut self, ui: &mut egui::Ui) {
        let ctx = ui.ctx().clone();
        self.listen(&ctx);
        self.suit_the_screen(&ctx);
        self.top_bar.count_frame(&ctx);
        self.prepare();
        let in_software = self.views.draws_in_software();
        self.top_bar.show(ui, &mut self.cx, self.recent.paths(), in_software == Some(true));
        self.carry_out(&ctx);
        // The bar shows what the views found under the pointer one frame ago.
        status_bar::status_bar(ui, &mut self.cx, &mut self.said, &mut self.remedy);
        self.carry_out(&ctx);
        self.transfer.show(ui, &mut self.cx);
        self.cx.status.hint = "Draw a stroke in a drawing view to begin a fibre";
        self.timeline.show(ui, &mut self.cx);
        self.carry_out(&ctx);
        outliner::left_panel(ui, &mut self.cx, self.views.editing_mut());
        self.carry_out(&ctx);
        // Strips play by themselves where a graphics card draws; where that is work, only the one under the pointer
        // does.
        let (comparison, patterns) = (&mut self.comparison, &mut self.patterns);
        self.right_panel.show(ui, &mut self.cx, comparison, patterns, in_software == Some(false));
        self.carry_out(&ctx);
        if self.cx.simulation.is_comparing() {
            self.comparison.plots(ui, &self.cx);
        } else {
            self.time_series.show(ui, &mut self.cx);
        }
        self.carry_out(&ctx);
        self.prepare_pattern();
        self.views.show(ui, &mut self.cx);
        self.carry_out(&ctx);
        self.show_dialog(&ctx);
        self.views.editing_mut().keep_keys(&ctx);
        self.show_title(&ctx);
    }

    /// Works out what the panels are told of each other in this frame.
    fn prepare(&mut self) {
        self.cx.has_dialog = self.dialog.is_some();
        self.cx.actions = self.action_states();
    }

    fn prepare_pattern(&mut self) {
        let is_shown = self.right_panel.tab() == PropertyTab::Patterns;
        self.cx.pattern = self.patterns.preview(is_shown, &self.cx);
    }

    fn show_title(&mut self, ctx: &egui::Context) {
        let mark = if self.cx.document.is_changed() { " •" } else { "" };
        let title = format!("{}{mark} — sinew", self.cx.document.name());
        if title != self.title {
            ctx.send_viewport_cmd(egui::ViewportCommand::Title(title.clone()));
            self.title = title;
        }
    }
}

impl eframe::App for App {
    fn logic(&mut self, ctx: &egui::Context, _frame: &mut eframe::Frame) {
        self.look_after(ctx);
    }

    fn ui(&mut self, ui: &mut egui::Ui, _frame: &mut eframe::Frame) {
        self.show(ui);
    }

    fn clear_color(&self, visuals: &egui::Visuals) -> [f32; 4] {
        visuals.panel_fill.to_normalized_gamma_f32()
    }

    fn save(&mut self, storage: &mut dyn eframe::Storage) {
        self.remember(storage);
    }
}
