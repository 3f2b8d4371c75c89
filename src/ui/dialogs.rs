//! What opens over the window: the palette, the help, the request for a path.

use super::action::{Action, GESTURES, Menu};
use super::app::App;
use super::gallery::{Choice, Example};
use super::patterns;
use super::theme::GRID;
use super::trust::{About, Next, Question, Reply, ask, choose_recent};
use egui::{Context, Id, Key, Modal, RichText, ScrollArea, TextEdit, Ui};
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, channel};

/// What a path is asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PathPurpose {
    /// To open a scene.
    Open,
    /// To save the scene.
    Save,
    /// To write readings as a table.
    Export,
}

/// What is open over the window.
pub enum Dialog {
    /// Finds an action by its name.
    Palette {
        /// What has been typed.
        text: String,
        /// Which of the matches would be taken.
        chosen: usize,
    },
    /// Lists keys and gestures.
    Help,
    /// Asks for a path.
    Path {
        /// What for.
        purpose: PathPurpose,
        /// What has been typed.
        text: String,
        /// The desktop's own dialog, when it is open.
        browsing: Option<Receiver<Option<PathBuf>>>,
        /// What is gone on to after saving.
        next: Option<Next>,
    },
    /// Asks what is to become of the document or its file.
    Question(Question),
    /// Shows the scenes that ship.
    Examples,
    /// Asks about a person's own patterns.
    Pattern(patterns::Question),
}

impl Dialog {
    pub(super) fn palette() -> Self {
        Self::Palette { text: String::new(), chosen: 0 }
    }

    pub(super) fn path(purpose: PathPurpose, present: Option<&Path>) -> Self {
        let text = present.map_or_else(|| "scene.json".to_owned(), |path| path.display().to_string());
        Self::Path { purpose, text, browsing: None, next: None }
    }

    /// A request for a path after which is gone on to something else.
    pub(super) fn then(self, next: Option<Next>) -> Self {
        match self {
            Self::Path { purpose, text, browsing, .. } => Self::Path { purpose, text, browsing, next },
            other => other,
        }
    }
}

/// What a dialog came to in a frame.
enum Answer {
    /// It stays open.
    None,
    /// It is closed.
    Closed,
    /// An action was chosen.
    Do(Action),
    /// A path was given.
    Path(PathBuf),
    /// A path was chosen in the desktop's dialog, which asks before a file is replaced.
    Picked(PathBuf),
    /// A file was chosen among those that were used.
    Recent(PathBuf),
    /// A question was answered.
    Reply(Reply),
    /// An example was chosen.
    Example(&'static Example),
    /// What was asked about a pattern is to be done.
    Pattern,
}

impl App {
    pub(super) fn dialogs(&mut self, ctx: &Context) {
        let Some(mut dialog) = self.dialog.take() else { return };
        let frame = egui::Frame::popup(&ctx.global_style()).inner_margin(4.0 * GRID);
        let mut gallery = std::mem::take(&mut self.gallery);
        let modal = Modal::new(Id::unique("dialog")).frame(frame).show(ctx, |ui| match &mut dialog {
            Dialog::Palette { text, chosen } => palette(ui, text, chosen, |action| self.obstacle(action)),
            Dialog::Help => help(ui),
            Dialog::Path { purpose, text, browsing, .. } => ask_path(ui, *purpose, text, browsing, self.trust.recent()),
            Dialog::Question(question) => ask(ui, question, &self.about()).map_or(Answer::None, Answer::Reply),
            Dialog::Examples => gallery.show(ui).map_or(Answer::None, |choice| match choice {
                Choice::Draw => Answer::Closed,
                Choice::Open(example) => Answer::Example(example),
            }),
            Dialog::Pattern(question) => match patterns::ask(ui, question) {
                None => Answer::None,
                Some(true) => Answer::Pattern,
                Some(false) => Answer::Closed,
            },
        });
        self.gallery = gallery;
        let answer = match modal.inner {
            Answer::None if modal.should_close() => Answer::Closed,
            answer => answer,
        };
        match (answer, dialog) {
            (Answer::None, dialog) => self.dialog = Some(dialog),
            (Answer::Do(action), _) => self.perform(ctx, action),
            (Answer::Path(path) | Answer::Picked(path), Dialog::Path { purpose: PathPurpose::Open, .. }) => {
                self.leave(ctx, Next::Open(path));
            }
            (Answer::Path(path), Dialog::Path { purpose: PathPurpose::Export, .. }) => self.export_to(path),
            (Answer::Picked(path), Dialog::Path { purpose: PathPurpose::Export, .. }) => self.export(&path),
            (Answer::Closed, Dialog::Examples) => self.welcomed(),
            (Answer::Example(example), _) => self.leave(ctx, Next::Example(example)),
            (Answer::Pattern, Dialog::Pattern(question)) => self.pattern_answered(&question),
            (Answer::Recent(path), _) => self.open_recent(ctx, path),
            (Answer::Path(path), Dialog::Path { next, .. }) => self.save_to(ctx, path, next),
            (Answer::Picked(path), Dialog::Path { next, .. }) => self.write_then(ctx, &path, next),
            (Answer::Reply(reply), Dialog::Question(question)) => self.replied(ctx, question, reply),
            _ => {}
        }
    }

    fn about(&self) -> About<'_> {
        About { name: self.document_name(), path: self.path.as_deref(), left: self.trust.left(), tone: self.tone }
    }
}

fn palette(
    ui: &mut Ui,
    text: &mut String,
    chosen: &mut usize,
    obstacle: impl Fn(Action) -> Option<&'static str>,
) -> Answer {
    ui.set_width(360.0);
    let typed = ui.add(TextEdit::singleline(text).hint_text("Type a command").desired_width(f32::INFINITY));
    typed.request_focus();
    if typed.changed() {
        *chosen = 0;
    }
    let wanted = text.to_lowercase();
    let matches: Vec<Action> =
        Action::ALL.into_iter().filter(|action| action.name().to_lowercase().contains(&wanted)).collect();
    let (up, down, enter) = ui.input(|input| {
        (input.key_pressed(Key::ArrowUp), input.key_pressed(Key::ArrowDown), input.key_pressed(Key::Enter))
    });
    if down {
        *chosen += 1;
    }
    if up {
        *chosen = chosen.saturating_sub(1);
    }
    *chosen = (*chosen).min(matches.len().saturating_sub(1));
    let mut answer = Answer::None;
    ScrollArea::vertical().max_height(320.0).show(ui, |ui| {
        if matches.is_empty() {
            ui.label("No command of that name");
        }
        for (k, &action) in matches.iter().enumerate() {
            let key =
                action.shortcuts().first().map_or_else(String::new, |shortcut| ui.ctx().format_shortcut(shortcut));
            let button = egui::Button::selectable(k == *chosen, action.name())
                .shortcut_text(key)
                .min_size(egui::vec2(340.0, 0.0));
            let why = obstacle(action);
            let response = ui.add_enabled(why.is_none(), button).on_hover_text(action.tooltip());
            let clicked = response.on_disabled_hover_text(why.unwrap_or_default()).clicked();
            if clicked || (enter && k == *chosen && why.is_none()) {
                answer = Answer::Do(action);
            }
        }
    });
    answer
}

fn help(ui: &mut Ui) -> Answer {
    ui.set_width(520.0);
    ui.heading("Keys and gestures");
    ScrollArea::vertical().max_height(0.7 * ui.ctx().content_rect().height()).show(ui, |ui| {
        egui::Grid::new("gestures").num_columns(2).spacing([6.0 * GRID, GRID]).show(ui, |ui| {
            for (gesture, effect) in GESTURES {
                ui.label(gesture);
                ui.label(RichText::new(effect).weak());
                ui.end_row();
            }
            for menu in Menu::ALL {
                ui.label(RichText::new(menu.title()).strong());
                ui.end_row();
                for action in Action::ALL.into_iter().filter(|action| action.menu() == menu) {
                    let keys: Vec<String> = action.shortcuts().iter().map(|s| ui.ctx().format_shortcut(s)).collect();
                    ui.label(format!("{}  {}", action.name(), keys.join(", ")));
                    ui.label(RichText::new(action.tooltip()).weak());
                    ui.end_row();
                }
            }
        });
    });
    if ui.button("Close").clicked() { Answer::Closed } else { Answer::None }
}

fn ask_path(
    ui: &mut Ui,
    purpose: PathPurpose,
    text: &mut String,
    browsing: &mut Option<Receiver<Option<PathBuf>>>,
    recent: &[PathBuf],
) -> Answer {
    ui.set_width(460.0);
    let scene_hint = "Path of a .json scene, or of an .obj, .stl, .ply, .gltf or .glb model";
    let (title, verb, hint) = match purpose {
        PathPurpose::Open => ("Open a scene or a model", "Open", scene_hint),
        PathPurpose::Save => ("Save the scene", "Save", scene_hint),
        PathPurpose::Export => ("Export readings of every frame", "Export", "Path of a .csv table"),
    };
    ui.heading(title);
    let typed = ui.add(TextEdit::singleline(text).hint_text(hint).desired_width(f32::INFINITY));
    // Before the focus is given back to the line: that would hide that Enter took it away.
    let entered = typed.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
    if browsing.is_none() && ui.memory(|memory| memory.focused().is_none()) {
        typed.request_focus();
    }
    // Without a desktop's portal there is no dialog: the typed path always works.
    if let Some(Ok(picked)) = browsing.as_ref().map(Receiver::try_recv) {
        *browsing = None;
        if let Some(path) = picked {
            return Answer::Picked(path);
        }
    }
    let mut answer = Answer::None;
    ui.horizontal(|ui| {
        if (ui.button(verb).clicked() || entered) && !text.trim().is_empty() {
            answer = Answer::Path(PathBuf::from(text.trim()));
        }
        if ui.add_enabled(browsing.is_none(), egui::Button::new("Browse…")).clicked() {
            *browsing = Some(browse(purpose, ui.ctx().clone()));
        }
        if ui.button("Cancel").clicked() {
            answer = Answer::Closed;
        }
    });
    if purpose == PathPurpose::Open {
        ui.separator();
        ui.label(RichText::new("Recent").weak());
        if let Some(path) = choose_recent(ui, recent) {
            answer = Answer::Recent(path);
        }
    }
    answer
}

/// Opens the desktop's file dialog without holding the window up.
fn browse(purpose: PathPurpose, ctx: Context) -> Receiver<Option<PathBuf>> {
    let (sender, receiver) = channel();
    std::thread::spawn(move || {
        let scenes = || rfd::FileDialog::new().add_filter("sinew scene", &["json"]);
        let picked = match purpose {
            PathPurpose::Open => scenes().add_filter("model", &["obj", "stl", "ply", "gltf", "glb"]).pick_file(),
            PathPurpose::Save => scenes().set_file_name("scene.json").save_file(),
            PathPurpose::Export => {
                rfd::FileDialog::new().add_filter("table", &["csv"]).set_file_name("readings.csv").save_file()
            }
        };
        // The window may be gone by now.
        let _ = sender.send(picked);
        ctx.request_repaint();
    });
    receiver
}
