//! The window's state and what becomes of every action.

use super::comparison::Comparison;
use super::dialogs::Dialog;
use super::document::Document;
use super::editing::Editing;
use super::gallery::Gallery;
use super::pane::Pane;
use super::patterns::Patterns;
use super::picture::Painter;
use super::readings::Readings;
use super::seeing::Seeing;
use super::sketch_tool::SketchTool;
use super::theme::Tone;
use super::timeline::Timeline;
use super::trust::{Next, Trust};
use crate::draw::Display;
use crate::edit::{Command, Editor};
use crate::render::Camera;
use crate::scene::{Assets, Body, Pin, Region, Scene, TwoLayer};
use crate::sim::{Published, SimCommand, Worker};
use crate::sketch::View;
use crate::solver::snapshot::Snapshot;
use glam::DVec3;
use std::path::PathBuf;
use std::sync::Arc;

/// How serious a message is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Gravity {
    /// Something was done.
    Note,
    /// Something should be looked at.
    Warning,
    /// Something was not done.
    Error,
}

/// Tabs of the right panel.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum PropertyTab {
    /// What the active body is made of.
    #[default]
    Body,
    /// What surrounds the bodies.
    World,
    /// The scene under several integrators.
    Comparison,
    /// Layouts of fibres.
    Patterns,
}

/// A point of a body that is being pulled.
#[derive(Clone, Copy, Debug)]
pub struct Pull {
    /// Index of the body.
    pub body: usize,
    /// Vertex of its skin.
    pub vertex: usize,
    /// Depth of the plane in which it is pulled, as the camera counts it [m].
    pub depth: f64,
    /// Where to [m].
    pub target: DVec3,
}

/// The window.
pub struct App {
    pub(super) editor: Editor,
    pub(super) path: Option<PathBuf>,
    /// Folder from which the scene names its models.
    pub(super) folder: PathBuf,
    pub(super) worker: Worker,
    pub(super) published: Arc<Published>,
    /// Edits sent to the simulation, to know whether what is shown is up to date.
    pub(super) sent_edits: u64,
    pub(super) tool: SketchTool,
    pub(super) panes: egui_tiles::Tree<Pane>,
    pub(super) painter: Option<Painter>,
    pub(super) display: Display,
    pub(super) tone: Tone,
    /// The active body at rest in its model frame.
    pub(super) model: Arc<Snapshot>,
    /// Body that is drawn into and whose properties are shown, in the order of the snapshot.
    pub(super) active: usize,
    pub(super) editing: Editing,
    /// Fibre that was drawn last: how its strokes were taken can still be chosen beside the message.
    pub(super) drawn_last: Option<String>,
    pub(super) tab: PropertyTab,
    pub(super) comparison: Comparison,
    pub(super) seeing: Seeing,
    pub(super) timeline: Timeline,
    pub(super) readings: Readings,
    pub(super) trust: Trust,
    pub(super) patterns: Patterns,
    pub(super) gallery: Gallery,
    pub(super) assets: Arc<Assets>,
    /// Impulse that the strike button gives [N s].
    pub(super) impulse: [f64; 3],
    pub(super) pull: Option<Pull>,
    /// The drawing views, and where they lay in the last frame.
    pub(super) drawing: Vec<(View, egui::Rect)>,
    /// A drawing view whose camera was moved in this frame.
    pub(super) moved: Option<(View, Camera)>,
    /// A drawing view that is to show another side.
    pub(super) turned: Option<(View, View)>,
    /// Whether views are fitted to the selected fibre rather than to everything.
    pub(super) fit_selected: bool,
    pub(super) speed: f64,
    pub(super) message: Option<(Gravity, String)>,
    pub(super) hint: &'static str,
    pub(super) dialog: Option<Dialog>,
    /// Changes of one drag are one step of undo.
    pub(super) gesture: u64,
    /// When the last frames were shown [s].
    pub(super) frame_times: std::collections::VecDeque<f64>,
    /// Whether the coach still explains the first fibre.
    pub(super) coach: bool,
    title: String,
}

impl App {
    /// A window on a document. Without a render state nothing is painted into the views, but
    /// everything else works.
    pub fn new(ctx: &egui::Context, render: Option<egui_wgpu::RenderState>, document: Document) -> Self {
        let Document { scene, assets, path, folder, note } = document;
        let tone = Tone::Dark;
        tone.apply(ctx);
        let editor = Editor::new(scene);
        let trust = Trust::start(ctx, path.as_deref(), editor.scene());
        let repaint = ctx.clone();
        let worker =
            Worker::start(Arc::clone(editor.scene()), Arc::clone(&assets), true, move || repaint.request_repaint());
        Self {
            editor,
            path,
            folder,
            worker,
            published: Arc::default(),
            sent_edits: 0,
            tool: SketchTool::default(),
            panes: super::views::usual_layout(),
            painter: render.map(Painter::new),
            display: Display { skin: crate::draw::SkinStyle::XRay, axes: false, ..Display::default() },
            tone,
            model: Arc::default(),
            active: 0,
            editing: Editing::default(),
            drawn_last: None,
            tab: PropertyTab::default(),
            comparison: Comparison::default(),
            seeing: Seeing::default(),
            timeline: Timeline::default(),
            readings: Readings::default(),
            trust,
            patterns: Patterns::default(),
            gallery: Gallery::default(),
            assets,
            impulse: [0.1, 0.0, 0.0],
            pull: None,
            drawing: Vec::new(),
            moved: None,
            turned: None,
            fit_selected: false,
            speed: 1.0,
            message: note.map(|note| (Gravity::Note, note)),
            hint: "",
            dialog: None,
            gesture: 0,
            frame_times: std::collections::VecDeque::new(),
            coach: true,
            title: String::new(),
        }
    }

    /// The document.
    pub fn scene(&self) -> &Arc<Scene> {
        self.editor.scene()
    }

    /// The newest state of the simulation.
    pub fn published(&self) -> &Published {
        &self.published
    }

    /// What was said last.
    pub fn message(&self) -> Option<&str> {
        self.message.as_ref().map(|(_, text)| text.as_str())
    }

    /// Body, vertex and target [m] of what is being pulled.
    pub fn pulled(&self) -> Option<(usize, usize, DVec3)> {
        self.pull.map(|pull| (pull.body, pull.vertex, pull.target))
    }

    /// The fibre solid that is drawn into.
    pub(super) fn active_body(&self) -> Option<&Body> {
        self.editor.scene().bodies.get(self.active)
    }

    /// The two-layer body whose properties are shown.
    pub(super) fn active_two_layer(&self) -> Option<&TwoLayer> {
        let scene = self.editor.scene();
        scene.two_layer.get(self.active.checked_sub(scene.bodies.len())?)
    }

    /// Identifier, regions and pins of the active body of either kind.
    pub(super) fn active_supports(&self) -> Option<(String, Vec<Region>, Vec<Pin>)> {
        if let Some(body) = self.active_body() {
            return Some((body.id.clone(), body.regions.clone(), body.pins.clone()));
        }
        self.active_two_layer().map(|body| (body.id.clone(), body.regions.clone(), body.pins.clone()))
    }

    /// Takes over what is drawn into.
    fn take_model(&mut self) {
        let bodies = self.published.at_rest.bodies.get(self.active).cloned().into_iter().collect();
        self.model = Arc::new(Snapshot { bodies, ..Snapshot::default() });
    }

    /// Draws into another body from now on.
    pub(super) fn activate(&mut self, index: usize) {
        if self.active != index {
            self.active = index;
            self.take_model();
            self.editing = Editing::default();
            self.tool = SketchTool::default();
            self.patterns.forget_region();
            self.reframe(false);
        }
    }

    /// Diagonal of the active body's box [m], by its skin at rest.
    pub(super) fn model_diagonal(&self) -> f64 {
        let body = self.model.bodies.first();
        let points = body.into_iter().flat_map(|body| if body.skin.is_empty() { &body.particles } else { &body.skin });
        crate::draw::Bounds::of(points.copied()).map_or(0.1, |bounds| 2.0 * bounds.radius())
    }

    pub(super) fn say(&mut self, gravity: Gravity, text: impl Into<String>) {
        self.message = Some((gravity, text.into()));
    }

    pub(super) fn ask(&self, command: SimCommand) {
        self.worker.send(command);
    }

    /// Changes the document; changes of one gesture are one step.
    pub(super) fn apply(&mut self, command: &Command) {
        self.apply_in(command, self.gesture);
    }

    /// Changes the document as part of a gesture.
    pub(super) fn apply_in(&mut self, command: &Command, gesture: u64) {
        let before = Arc::clone(self.editor.scene());
        match self.editor.apply_in(command, Some(gesture)) {
            Ok(()) if Arc::ptr_eq(&before, self.editor.scene()) => {}
            Ok(()) => self.hand_over(),
            Err(error) => self.say(Gravity::Error, error.to_string()),
        }
    }

    /// Gives the present document to the simulation, which goes on from its present motion.
    pub(super) fn hand_over(&mut self) {
        self.keep_selection_true();
        if self.worker.send(SimCommand::Edit(Arc::clone(self.editor.scene()))) {
            self.sent_edits += 1;
        }
        self.ask_for_ghost();
    }

    /// Takes the newest picture of the simulation and what the person asks for by keys and drops.
    fn listen(&mut self, ctx: &egui::Context) {
        if let Some(published) = self.worker.take() {
            // What was noticed before the motion began is said before what happened in it.
            if published.status.notes != self.published.status.notes
                && let Some(text) = published.status.notes.last()
            {
                let more = match published.status.notes.len() - 1 {
                    0 => String::new(),
                    more => format!(" (and {more} more: `sinew check` lists them)"),
                };
                self.say(Gravity::Warning, self.scene().with_names(text) + &more);
            }
            let fresh = !Arc::ptr_eq(&published.at_rest, &self.published.at_rest);
            let other_runs = published.compared.len() != self.published.compared.len();
            self.watch_breaks(&published);
            self.published = published;
            if other_runs {
                self.reframe(false);
            }
            self.comparison.record(&self.published.compared);
            if fresh {
                self.active = self.active.min(self.published.at_rest.bodies.len().saturating_sub(1));
                self.take_model();
            }
        }
        if ctx.input(|input| input.pointer.any_released()) {
            self.gesture += 1;
        }
        let dropped = ctx.input(|input| input.raw.dropped_files.iter().map(|file| file.path().to_owned()).next());
        if let Some(path) = dropped {
            self.leave(ctx, Next::Open(path));
        }
        // Keys belong to what stands in front of everything.
        if self.dialog.is_some() || self.editing_keys(ctx) {
            return;
        }
        if ctx.input(|input| input.key_pressed(egui::Key::Escape)) {
            self.tool.cancel();
            self.leave_region();
            self.editing.redraws = false;
        }
        self.perform_keys(ctx);
    }

    /// One frame of the window.
    pub fn show(&mut self, ui: &mut egui::Ui) {
        let ctx = ui.ctx().clone();
        self.listen(&ctx);
        self.count_frame(&ctx);
        self.top_bar(ui);
        // The bar shows what the views found under the pointer one frame ago.
        self.status_bar(ui);
        self.hint = "Draw a stroke in a drawing view to begin a fibre";
        self.timeline(ui);
        self.left_panel(ui);
        self.right_panel(ui);
        self.plots(ui);
        self.views(ui);
        self.dialogs(&ctx);
        self.editing.keep_keys(&ctx);
        self.show_title(&ctx);
    }

    /// Keeps the times of the last second's frames.
    fn count_frame(&mut self, ctx: &egui::Context) {
        let now = ctx.input(|input| input.time);
        self.frame_times.push_back(now);
        while self.frame_times.front().is_some_and(|time| *time < now - 1.0) {
            self.frame_times.pop_front();
        }
    }

    fn show_title(&mut self, ctx: &egui::Context) {
        let name = self.document_name();
        let mark = if self.editor.is_changed() { " •" } else { "" };
        let title = format!("{name}{mark} — sinew");
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
