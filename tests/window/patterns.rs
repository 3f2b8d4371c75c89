//! Patterns are chosen, fitted, added in one step, and kept by a person.

use super::editing::set;
use super::{Window, click, drag, press_key, still, until, view};
use egui::{Event, Key, Modifiers, Pos2, Vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use glam::DVec3;
use sinew::scene::{Drive, Fibre, FibreSource};
use sinew::sketch::pattern::PATTERNS;
use sinew::test_support::geometry::distance_to_polyline;
use sinew::test_support::ui::App;
use sinew::ui::Document;
use std::fs;
use std::path::Path;

fn fibres(window: &Window) -> Vec<Fibre> {
    window.state().scene().bodies[0].fibres.clone()
}

/// Least and greatest corner of the fibres that are shown before they are there.
fn extent(window: &Window) -> [DVec3; 2] {
    let points: Vec<DVec3> = window.state().pattern_preview().into_iter().flatten().collect();
    assert!(!points.is_empty(), "nothing is shown");
    let least = points.iter().copied().fold(DVec3::INFINITY, DVec3::min);
    [least, points.iter().copied().fold(DVec3::NEG_INFINITY, DVec3::max)]
}

/// Opens the tab and chooses a pattern, wherever its tile lies.
fn choose(window: &mut Window, title: &str) {
    click(window, "Patterns");
    pick(window, title);
}

fn pick(window: &mut Window, title: &str) {
    window.get_by_label(title).scroll_to_me();
    // Scrolling takes a moment.
    window.run_steps(40);
    click(window, title);
}

/// The window on the built-in scene, held still, with patterns kept in a folder.
fn with_folder(folder: &Path) -> Window {
    let folder = folder.to_owned();
    let document = Document::load(None).expect("the built-in scene");
    let mut window = Harness::builder()
        .with_size(Vec2::new(1280.0, 800.0))
        .with_step_dt(1.0 / 60.0)
        .build_eframe(move |creation| App::new(&creation.egui_ctx, None, document).with_pattern_folder(folder));
    until(&mut window, |app| !app.published().at_rest.bodies.is_empty());
    press_key(&mut window, Modifiers::NONE, Key::Space);
    until(&mut window, |app| !app.published().status.playing);
    window
}

fn type_text(window: &mut Window, text: &str) {
    window.event(Event::Text(text.to_owned()));
    window.step();
    window.step();
}

fn said(window: &Window) -> String {
    window.state().message().unwrap_or_default().to_owned()
}

#[test]
fn every_pattern_is_added_in_one_step_and_taken_back() {
    let mut window = still();
    let before = fibres(&window);
    click(&mut window, "Patterns");
    for pattern in &PATTERNS {
        pick(&mut window, pattern.title);
        let shown = window.state().pattern_preview();
        assert!(!shown.is_empty(), "{} is shown before it is there", pattern.title);
        assert_eq!(fibres(&window), before, "nothing is added yet");
        click(&mut window, "Add fibres");
        let after = fibres(&window);
        assert_eq!(after.len(), before.len() + shown.len(), "{}", pattern.title);
        assert_eq!(window.state().undo_name(), Some(format!("Add pattern {}", pattern.title).as_str()));
        for (fibre, line) in after[before.len()..].iter().zip(&shown) {
            assert!(fibre.name.starts_with(pattern.title), "{}", fibre.name);
            let FibreSource::Vertices(vertices) = &fibre.source else { panic!("{} has strokes", fibre.id) };
            let off = |vertex: &[f64; 3]| distance_to_polyline(DVec3::from_array(*vertex), line);
            assert!(vertices.len() <= line.len() && vertices.iter().all(|vertex| off(vertex) < 1e-9), "{}", fibre.name);
        }
        let drives = window.state().scene().bodies[0].drives.clone();
        let follow = |fibre: &Fibre| {
            let drive = fibre.activation.as_ref().map(|of| &of.drive);
            matches!(drive, Some(Drive::Shared(id)) if drives.iter().any(|one| one.id == *id))
        };
        assert_eq!(after[before.len()..].iter().all(follow), pattern.is_acting(), "{}", pattern.title);
        assert_eq!(drives.is_empty(), !pattern.is_acting(), "{}", pattern.title);
        assert_eq!(window.state().selected_names().len(), shown.len(), "they are selected");
        assert!(window.state().pattern_preview().is_empty(), "the gallery is back");
        press_key(&mut window, Modifiers::COMMAND, Key::Z);
        assert_eq!(fibres(&window), before, "{}", pattern.title);
        assert!(window.state().scene().bodies[0].drives.is_empty(), "{}", pattern.title);
    }
}

#[test]
fn added_fibres_are_in_the_solid() {
    let mut window = still();
    choose(&mut window, "Helix, left-handed");
    click(&mut window, "Add fibres");
    let count = fibres(&window).len();
    until(&mut window, |app| app.published().at_rest.bodies[0].fibres.len() == count);
}

#[test]
fn numbers_change_what_is_shown_and_can_be_reset() {
    let mut window = still();
    choose(&mut window, "Upright");
    assert_eq!(window.state().pattern_preview().len(), 4);
    set(&mut window, "Fibres along X", "3");
    assert_eq!(window.state().pattern_preview().len(), 6);
    let [least, _] = extent(&window);
    set(&mut window, "Margin", "0.3");
    assert!(extent(&window)[0].cmpgt(least).all(), "a wider margin keeps further inside");
    set(&mut window, "Vertices", "900");
    assert_eq!(window.state().pattern_preview()[0].len(), 64, "numbers are held in their range");
    // They are there when it is chosen again.
    click(&mut window, "Back to all patterns");
    assert!(window.state().pattern_preview().is_empty());
    pick(&mut window, "Upright");
    assert_eq!(window.state().pattern_preview().len(), 6);
    click(&mut window, "Reset all");
    assert_eq!(window.state().pattern_preview().len(), 4);
    assert_eq!(extent(&window)[0], least);
}

#[test]
fn a_pattern_fills_the_region_that_is_dragged() {
    let mut window = still();
    let before = fibres(&window);
    choose(&mut window, "Upright");
    let whole = extent(&window);
    click(&mut window, "Region");
    let front = view(&window, "Front");
    let at = |x: f32, y: f32| front.center() + Vec2::new(x, -y) * front.height();
    let path: Vec<Pos2> = (0..=8).map(|k| at(-0.1 + 0.025 * k as f32, -0.15 + 0.0375 * k as f32)).collect();
    drag(&mut window, &path);
    assert_eq!(fibres(&window), before, "no stroke was drawn and no fibre chosen");
    let region = extent(&window);
    for axis in 0..2 {
        assert!(region[0][axis] > whole[0][axis] + 1e-3 && region[1][axis] < whole[1][axis] - 1e-3, "{region:?}");
    }
    // The third axis is the model's, but for the margin, which is a share of the box's least extent.
    assert!(region[0].z <= whole[0].z && (region[0].z + region[1].z).abs() < 1e-9, "{region:?}");
    // A box in the other view sets the third axis too, and its height anew.
    let side = view(&window, "Side");
    let at = |x: f32, y: f32| side.center() + Vec2::new(x, -y) * side.height();
    let path: Vec<Pos2> = (0..=8).map(|k| at(0.02 * k as f32, 0.05 * k as f32 - 0.2)).collect();
    drag(&mut window, &path);
    let both = extent(&window);
    assert!(both[0].z > whole[0].z + 1e-3, "{both:?} of {whole:?}");
    assert!((both[0].x + both[1].x - region[0].x - region[1].x).abs() < 1e-9, "X stays where it was");
    click(&mut window, "Add fibres");
    assert_eq!(fibres(&window).len(), before.len() + 4);
    press_key(&mut window, Modifiers::COMMAND, Key::Z);
    pick(&mut window, "Upright");
    press_key(&mut window, Modifiers::NONE, Key::Escape);
    window.step();
    assert_eq!(extent(&window), whole, "Escape fills the whole body again");
}

#[test]
fn a_box_beside_the_body_is_refused() {
    let mut window = still();
    choose(&mut window, "Upright");
    let whole = extent(&window);
    click(&mut window, "Region");
    let front = view(&window, "Front");
    let corner = front.left_bottom() + Vec2::new(8.0, -8.0);
    drag(&mut window, &[corner, corner + Vec2::new(6.0, -6.0), corner + Vec2::new(14.0, -14.0)]);
    assert!(said(&window).contains("hardly anything of the body"), "{}", said(&window));
    assert_eq!(extent(&window), whole);
}

#[test]
fn fibres_can_be_replaced_in_the_same_step() {
    let mut window = still();
    let before = fibres(&window);
    choose(&mut window, "Cross");
    click(&mut window, "Replace the body's fibres");
    click(&mut window, "Replace fibres");
    let after = fibres(&window);
    assert_eq!(after.len(), 4);
    assert!(after.iter().all(|fibre| fibre.name.starts_with("Cross")));
    press_key(&mut window, Modifiers::COMMAND, Key::Z);
    assert_eq!(fibres(&window), before);
}

#[test]
fn what_fibres_do_is_kept_with_a_pattern_and_comes_back() {
    let folder = tempfile::tempdir().expect("a folder");
    let place = folder.path().join("patterns");
    let mut window = with_folder(&place);
    let before = fibres(&window).len();
    choose(&mut window, "Worm");
    set(&mut window, "Contraction", "0.3");
    set(&mut window, "Period", "2");
    click(&mut window, "Add fibres");
    pick(&mut window, "Save selection as pattern…");
    type_text(&mut window, "Slow worm");
    click(&mut window, "Save pattern");
    pick(&mut window, "Slow worm");
    click(&mut window, "Add fibres");
    let all = fibres(&window);
    assert_eq!(all.len(), before + 8);
    let drives = window.state().scene().bodies[0].drives.clone();
    for (drawn, again) in all[before..before + 4].iter().zip(&all[before + 4..]) {
        let activations = [drawn, again].map(|fibre| fibre.activation.clone().expect("a fibre that acts"));
        assert_eq!(activations[0].contract, 0.3);
        assert_eq!(activations[1].contract, 0.3);
        let [one, other] = activations.map(|of| of.drive.resolved(&drives).cloned().expect("a drive that is there"));
        let (Drive::Wave(one), Drive::Wave(other)) = (one, other) else { panic!("waves") };
        let [length, like] = [one.wavelength, other.wavelength].map(|length| length.expect("one along the fibre"));
        assert!((length - like).abs() < 1e-12 && one.period == 2.0 && other.period == 2.0, "{length} and {like} m");
        assert_eq!(one.phase_degrees, other.phase_degrees);
    }
}

#[test]
fn a_pattern_of_ones_own_is_kept_found_again_renamed_and_deleted() {
    let folder = tempfile::tempdir().expect("a folder");
    let place = folder.path().join("patterns");
    let mut window = with_folder(&place);
    let before = fibres(&window);
    press_key(&mut window, Modifiers::NONE, Key::A);
    click(&mut window, "Fibre");
    click(&mut window, "Save selection as pattern…");
    type_text(&mut window, "My helices");
    click(&mut window, "Save pattern");
    assert!(said(&window).contains("My helices is kept"), "{}", said(&window));
    assert!(place.join("my-helices.json").is_file());

    // After a restart it is there, and gives back what it was made of.
    let mut window = with_folder(&place);
    choose(&mut window, "My helices");
    assert_eq!(window.state().pattern_preview().len(), before.len());
    click(&mut window, "Add fibres");
    let added = fibres(&window);
    assert_eq!(added.len(), 2 * before.len());
    assert_eq!(window.state().undo_name(), Some("Add pattern My helices"));

    pick(&mut window, "My helices");
    click(&mut window, "Rename…");
    press_key(&mut window, Modifiers::COMMAND, Key::A);
    type_text(&mut window, "Twist");
    click(&mut window, "Rename");
    assert!(window.query_by_label("Twist").is_some(), "{}", said(&window));
    assert!(fs::read_to_string(place.join("my-helices.json")).expect("the file").contains("\"Twist\""));

    click(&mut window, "Delete…");
    click(&mut window, "Cancel");
    assert!(place.join("my-helices.json").is_file(), "it was only asked");
    click(&mut window, "Delete…");
    click(&mut window, "Delete pattern");
    assert!(!place.join("my-helices.json").exists(), "{}", said(&window));
    assert!(window.query_by_label("Twist").is_none());
    assert_eq!(fibres(&window), added, "fibres that it made stay");
}

#[test]
fn a_damaged_file_is_named_with_what_is_wrong_and_left_as_it_is() {
    let folder = tempfile::tempdir().expect("a folder");
    let damaged = r#"{"title": "Broken", "fibres": [[[0, 0, 0]]]}"#;
    fs::write(folder.path().join("broken.json"), damaged).expect("written");
    fs::write(folder.path().join("torn.json"), r#"{"title": "To"#).expect("written");
    let whole = r#"{"title": "Whole", "fibres": [[[0, 0, 0], [1, 1, 1]]], "made_by": "hand"}"#;
    fs::write(folder.path().join("whole.json"), whole).expect("written");
    let mut window = with_folder(folder.path());
    click(&mut window, "Patterns");
    let listed = |window: &Window, text: &str| window.query_all_by_label_contains(text).next().is_some();
    assert!(listed(&window, "fibre 0 of the pattern has 1 vertices"));
    assert!(listed(&window, "torn.json"));
    pick(&mut window, "Whole");
    click(&mut window, "Rename…");
    press_key(&mut window, Modifiers::COMMAND, Key::A);
    type_text(&mut window, "Still whole");
    press_key(&mut window, Modifiers::NONE, Key::Enter);
    let read = |name: &str| fs::read_to_string(folder.path().join(name)).expect("the file");
    assert_eq!(read("broken.json"), damaged);
    assert!(read("whole.json").contains("Still whole") && read("whole.json").contains("made_by"), "nothing is lost");
}

#[test]
fn without_a_folder_nothing_is_kept_and_that_is_said() {
    let mut window = still();
    click(&mut window, "Fibre");
    click(&mut window, "Save selection as pattern…");
    assert!(said(&window).contains("no folder to keep patterns in"), "{}", said(&window));
    assert!(window.query_by_label("Save pattern").is_none());
}
