//! The window's state and what becomes of every action.

use super::action::Action;
use super::dialogs::Dialog;
use super::document::Document;
use super::pane::{Pane, PaneKind};
use super::picture::Painter;
use super::sketch_tool::{Outcome, SketchTool};
use super::theme::Tone;
use crate::draw::Display;
use crate::edit::{Command, Editor};
use crate::io::save_scene;
use crate::render::Camera;
use crate::scene::{Body, Extra, Fibre, FibreSource, RestShape, Rigidity, Scene, Stiffness, StrokePair};
use crate::sim::{Published, SimCommand, Worker};
use crate::sketch::View;
use glam::DVec3;
use std::f64::consts::PI;
use std::path::{Path, PathBuf};
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
    worker: Worker,
    pub(super) published: Arc<Published>,
    /// Edits sent to the simulation, to know whether what is shown is up to date.
    pub(super) sent_edits: u64,
    pub(super) tool: SketchTool,
    pub(super) panes: egui_tiles::Tree<Pane>,
    pub(super) painter: Option<Painter>,
    pub(super) display: Display,
    pub(super) tone: Tone,
    pub(super) selected: Option<String>,
    pub(super) pull: Option<Pull>,
    /// A drawing view whose camera was moved in this frame.
    pub(super) moved: Option<(View, Camera)>,
    pub(super) speed: f64,
    pub(super) message: Option<(Gravity, String)>,
    pub(super) hint: &'static str,
    pub(super) dialog: Option<Dialog>,
    /// Changes of one drag are one step of undo.
    pub(super) gesture: u64,
    /// Whether the coach still explains the first fibre.
    pub(super) coach: bool,
    title: String,
}

impl App {
    /// A window on a document. Without a render state nothing is painted into the views, but
    /// everything else works.
    pub fn new(ctx: &egui::Context, render: Option<egui_wgpu::RenderState>, document: Document) -> Self {
        let Document { scene, assets, path } = document;
        let tone = Tone::Dark;
        tone.apply(ctx);
        let editor = Editor::new(scene);
        let repaint = ctx.clone();
        let worker = Worker::start(Arc::clone(editor.scene()), assets, true, move || repaint.request_repaint());
        Self {
            editor,
            path,
            worker,
            published: Arc::default(),
            sent_edits: 0,
            tool: SketchTool::default(),
            panes: Pane::layout(),
            painter: render.map(Painter::new),
            display: Display { skin: crate::draw::SkinStyle::XRay, ..Display::default() },
            tone,
            selected: None,
            pull: None,
            moved: None,
            speed: 1.0,
            message: None,
            hint: "",
            dialog: None,
            gesture: 0,
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

    /// The body that is drawn into.
    pub(super) fn active_body(&self) -> Option<&Body> {
        self.editor.scene().bodies.first()
    }

    /// Diagonal of the active body's box [m], by its particles at rest.
    pub(super) fn model_diagonal(&self) -> f64 {
        let points = self.published.at_rest.bodies.first().into_iter().flat_map(|body| body.skin.iter().copied());
        crate::draw::Bounds::of(points).map_or(0.1, |bounds| 2.0 * bounds.radius())
    }

    pub(super) fn say(&mut self, gravity: Gravity, text: impl Into<String>) {
        self.message = Some((gravity, text.into()));
    }

    pub(super) fn ask(&self, command: SimCommand) {
        self.worker.send(command);
    }

    /// Changes the document; changes of one gesture are one step.
    pub(super) fn apply(&mut self, command: &Command) {
        match self.editor.apply_in(command, Some(self.gesture)) {
            Ok(()) => self.hand_over(),
            Err(error) => self.say(Gravity::Error, error.to_string()),
        }
    }

    /// Gives the present document to the simulation, which goes on from its present motion.
    pub(super) fn hand_over(&mut self) {
        if self.worker.send(SimCommand::Edit(Arc::clone(self.editor.scene()))) {
            self.sent_edits += 1;
        }
    }

    /// Opens a file, or the built-in scene.
    pub(super) fn open_document(&mut self, path: Option<PathBuf>) {
        match Document::load(path) {
            Ok(Document { scene, assets, path }) => {
                self.editor = Editor::new(scene);
                self.path = path;
                self.selected = None;
                self.tool = SketchTool::default();
                self.pull = None;
                if self.worker.send(SimCommand::Open(Arc::clone(self.editor.scene()), assets)) {
                    self.sent_edits += 1;
                }
                self.reframe();
                let name =
                    self.path.as_ref().map_or_else(|| "the soft bar".to_owned(), |path| path.display().to_string());
                self.say(Gravity::Note, format!("Opened {name}"));
            }
            Err(error) => self.say(Gravity::Error, error.to_string()),
        }
    }

    /// Fits every view again as soon as there is something to fit.
    pub(super) fn reframe(&mut self) {
        for (_, tile) in self.panes.tiles.iter_mut() {
            if let egui_tiles::Tile::Pane(pane) = tile {
                pane.framed = false;
            }
        }
    }

    /// Opens a file.
    pub fn open(&mut self, path: &Path) {
        self.open_document(Some(path.to_owned()));
    }

    /// Saves to a file.
    pub fn save(&mut self, path: &Path) {
        match save_scene(path, self.editor.scene()) {
            Ok(()) => {
                self.editor.mark_saved();
                self.path = Some(path.to_owned());
                self.say(Gravity::Note, format!("Saved {}", path.display()));
            }
            Err(error) => self.say(Gravity::Error, error.to_string()),
        }
    }

    /// What a released stroke leads to.
    pub(super) fn sketched(&mut self, outcome: Outcome) {
        match outcome {
            Outcome::Slip(length) => self.say(
                Gravity::Warning,
                format!(
                    "That stroke was only {length:.0} pixels long; draw at least {:.0}",
                    super::sketch_tool::SHORTEST_STROKE
                ),
            ),
            Outcome::First => self.say(Gravity::Note, "Now draw the same fibre as the other view sees it"),
            Outcome::Refused(error) => self.say(Gravity::Error, error.to_string()),
            Outcome::Pair { strokes, lifted } => {
                let notes: Vec<String> = lifted.notes.iter().map(ToString::to_string).collect();
                self.add_fibre(strokes);
                if !notes.is_empty() {
                    self.say(Gravity::Warning, notes.join(". "));
                }
            }
        }
    }

    /// Adds a fibre ten times as stiff as the material that it displaces, so that its effect is plain.
    fn add_fibre(&mut self, strokes: StrokePair) {
        let Some(body) = self.active_body() else { return };
        let material = &body.material;
        let displaced = material.young_modulus * 0.2 * PI * material.support_radius.powi(2);
        let ea = round_to_two_figures(10.0 * displaced);
        let ei = round_to_two_figures(0.02 * ea * material.spacing().powi(2));
        let taken = |n: &usize| body.fibres.iter().any(|fibre| fibre.id == format!("fibre-{n}"));
        let number = (1..=body.fibres.len() + 1).find(|n| !taken(n)).unwrap_or(1);
        let fibre = Fibre {
            id: format!("fibre-{number}"),
            name: format!("Fibre {number}"),
            source: FibreSource::Strokes(strokes),
            stiffness: Stiffness::Rigidity(Rigidity { ea, ei, extra: Extra::new() }),
            volume_fraction: 0.5,
            rest_shape: RestShape::AsDrawn,
            extra: Extra::new(),
        };
        let body = body.id.clone();
        self.selected = Some(fibre.id.clone());
        self.coach = false;
        self.say(Gravity::Note, format!("{} is in the solid", fibre.name));
        self.gesture += 1;
        self.apply(&Command::AddFibre { body, fibre });
    }

    /// Takes the newest picture of the simulation and what the person asks for by keys and drops.
    fn listen(&mut self, ctx: &egui::Context) {
        if let Some(published) = self.worker.take() {
            let notes = (published.status.notes != self.published.status.notes).then(|| published.status.notes.clone());
            self.published = published;
            if let Some(text) = notes.and_then(|notes| notes.into_iter().next_back()) {
                self.say(Gravity::Warning, text);
            }
        }
        if ctx.input(|input| input.pointer.any_released()) {
            self.gesture += 1;
        }
        let dropped = ctx.input(|input| input.raw.dropped_files.iter().map(|file| file.path().to_owned()).next());
        if let Some(path) = dropped {
            self.open(&path);
        }
        if ctx.input(|input| input.key_pressed(egui::Key::Escape)) && self.dialog.take().is_none() {
            self.tool.cancel();
        }
        // While something is typed, plain keys belong to the text.
        let typing = ctx.egui_wants_keyboard_input();
        let mut asked = Vec::new();
        ctx.input_mut(|input| {
            // Longest shortcuts first: Ctrl+Shift+Z must not be taken for Ctrl+Z.
            for shifted in [true, false] {
                for action in Action::ALL {
                    for shortcut in action.shortcuts().iter().filter(|s| s.modifiers.shift == shifted) {
                        if !(typing && shortcut.modifiers.is_none()) && input.consume_shortcut(shortcut) {
                            asked.push(action);
                        }
                    }
                }
            }
        });
        for action in asked {
            if self.can(action) {
                self.perform(ctx, action);
            }
        }
    }

    /// One frame of the window.
    pub fn show(&mut self, ui: &mut egui::Ui) {
        let ctx = ui.ctx().clone();
        self.listen(&ctx);
        self.top_bar(ui);
        // The bar shows what the views found under the pointer one frame ago.
        self.status_bar(ui);
        self.hint = "Draw a stroke in the front or the side view to begin a fibre";
        self.left_panel(ui);
        self.right_panel(ui);
        self.views(ui);
        self.dialogs(&ctx);
        self.show_title(&ctx);
    }

    fn views(&mut self, ui: &mut egui::Ui) {
        egui::CentralPanel::default().frame(egui::Frame::NONE).show(ui, |ui| {
            let mut panes = std::mem::replace(&mut self.panes, egui_tiles::Tree::empty(egui::Id::unique("no panes")));
            panes.ui(&mut super::pane::Layout { app: self }, ui);
            self.panes = panes;
        });
        self.link_views();
        if self.published.status.playing {
            // Should a notification be missed, the next picture still comes.
            ui.ctx().request_repaint_after_secs(0.1);
        }
    }

    fn show_title(&mut self, ctx: &egui::Context) {
        let name = if self.scene().name.is_empty() { "Untitled" } else { &self.scene().name };
        let mark = if self.editor.is_changed() { " •" } else { "" };
        let title = format!("{name}{mark} — sinew");
        if title != self.title {
            ctx.send_viewport_cmd(egui::ViewportCommand::Title(title.clone()));
            self.title = title;
        }
    }

    /// The drawing views are linked along the axis that they share: what one has moved, the other follows.
    fn link_views(&mut self) {
        let Some((view, from)) = self.moved.take() else { return };
        for (_, tile) in self.panes.tiles.iter_mut() {
            if let egui_tiles::Tile::Pane(pane) = tile
                && let PaneKind::Drawing(other) = pane.kind
                && let Some(axis) = view.shared_axis(other)
            {
                pane.camera.height = from.height;
                pane.camera.target[axis] = from.target[axis];
            }
        }
    }
}

impl eframe::App for App {
    fn ui(&mut self, ui: &mut egui::Ui, _frame: &mut eframe::Frame) {
        self.show(ui);
    }
}

fn round_to_two_figures(value: f64) -> f64 {
    let scale = 10_f64.powf(value.log10().floor() - 1.0);
    (value / scale).round() * scale
}
