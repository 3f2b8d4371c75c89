//! The request for a path: typed, chosen among recent files, or in the desktop's own dialog.

use super::answer::Answer;
use super::dialog::PathPurpose;
use crate::ui::bodies::Layers;
use crate::ui::recent_menu::choose_recent;
use egui::{Context, Key, RichText, TextEdit, Ui};
use std::path::PathBuf;
use std::sync::mpsc::{Receiver, channel};

/// How names of models end.
const MODELS: [&str; 5] = ["obj", "stl", "ply", "gltf", "glb"];
/// How names of motions end.
const MOTIONS: [&str; 4] = ["gltf", "glb", "pc2", "mdd"];
const MODEL_HINT: &str = "Path of an .obj, .stl, .ply, .gltf or .glb model";

/// Asks for a path.
pub(super) fn ask_path(
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
        PathPurpose::Add(Layers::Filled) => ("Add a model as a soft solid", "Add", MODEL_HINT),
        PathPurpose::Add(Layers::Two) => ("Add a closed model as two layers", "Add", MODEL_HINT),
        PathPurpose::Save => ("Save the scene", "Save", scene_hint),
        PathPurpose::Collider => {
            ("Add a model that bodies touch", "Add", "Path of an .obj, .stl, .ply, .gltf or .glb model")
        }
        PathPurpose::Follow => {
            ("Follow a motion", "Follow", "Path of a .gltf or .glb with a skin, or of a .pc2 or .mdd cache")
        }
        PathPurpose::Export => ("Export readings of every frame", "Export", "Path of a .csv table"),
        PathPurpose::Recording(_) => ("Save the recording", "Save", "Path of a .json journal, best beside its scene"),
        PathPurpose::Report => ("Save a report of a fault", "Save", "Path of a .zip archive"),
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
            PathPurpose::Open => scenes().add_filter("model", &MODELS).pick_file(),
            PathPurpose::Collider | PathPurpose::Add(_) => {
                rfd::FileDialog::new().add_filter("model", &MODELS).pick_file()
            }
            PathPurpose::Follow => rfd::FileDialog::new().add_filter("motion", &MOTIONS).pick_file(),
            PathPurpose::Save => scenes().set_file_name("scene.json").save_file(),
            PathPurpose::Export => {
                rfd::FileDialog::new().add_filter("table", &["csv"]).set_file_name("readings.csv").save_file()
            }
            PathPurpose::Recording(_) => {
                let journals = rfd::FileDialog::new().add_filter("journal", &["json"]);
                journals.set_file_name("recovered.journal.json").save_file()
            }
            PathPurpose::Report => {
                let archives = rfd::FileDialog::new().add_filter("archive", &["zip"]);
                archives.set_file_name("sinew-report.zip").save_file()
            }
        };
        // The window may be gone by now.
        let _ = sender.send(picked);
        ctx.request_repaint();
    });
    receiver
}
