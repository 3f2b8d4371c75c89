//! Panels, files and drops change the document as they say.

use super::{Window, advance, click, click_on, hold, is_settled, open, press_key, reset, scene, still, until};
use egui::accesskit::Role;
use egui::{Event, Key, Modifiers};
use egui_kittest::kittest::Queryable;
use glam::DVec3;
use sinew::io::load_scene;
use sinew::scene::{Axis, Fibre, Mass, PanelMotion, PaperStiffness, Scene, Shape, TimeStep};
use sinew::ui::Document;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Types a value into a field.
pub(super) fn set(window: &mut Window, label: &str, value: &str) {
    click_on(window, Role::SpinButton, label);
    press_key(window, Modifiers::COMMAND, Key::A);
    window.event(Event::Text(value.to_owned()));
    window.step();
    press_key(window, Modifiers::NONE, Key::Enter);
    window.step();
}

pub(super) fn type_path(window: &mut Window, path: &Path) {
    window.step();
    window.step();
    press_key(window, Modifiers::COMMAND, Key::A);
    window.event(Event::Text(path.display().to_string()));
    window.step();
    press_key(window, Modifiers::NONE, Key::Enter);
    window.step();
}

#[test]
fn a_material_is_edited_while_it_plays_and_undone_in_one_step() {
    let mut window = still();
    press_key(&mut window, Modifiers::NONE, Key::Space);
    let before = window.state().scene().bodies[0].material.clone();
    set(&mut window, "Young's modulus", "2e5");
    assert_eq!(window.state().scene().bodies[0].material.young_modulus, 2e5);
    until(&mut window, |app| app.published().status.edits == 1 && is_settled(app));
    assert!(window.state().published().status.playing && window.state().published().status.failure.is_none());
    press_key(&mut window, Modifiers::COMMAND, Key::Z);
    assert_eq!(window.state().scene().bodies[0].material, before);
}

/// Mass of the first body at rest [kg], and the rigidities EA [N] and EI [N m²] of its first fibre.
fn of_the_body(scene: &Scene) -> [f64; 3] {
    let baked = sinew::bake::bake(scene, &sinew::scene::Assets::default()).expect("a world");
    let state = baked.world.bodies()[0].state();
    let mass: f64 = state.masses.iter().sum();
    let volume = scene.bodies[0].shape.volume().expect("a box") / state.masses.len() as f64;
    let (ea, ei) = scene.bodies[0].fibres[0].stiffness.rigidity(volume);
    [mass, ea, ei]
}

#[test]
fn a_support_radius_samples_the_shape_anew_and_changes_neither_mass_nor_stiffness() {
    let mut document = Document::load(None).expect("the built-in scene");
    let fibre = Fibre {
        stiffness: PaperStiffness::new(5e5, 2.5e5).into(),
        ..Fibre::through("printed", [[0.0, 0.02, 0.0], [0.0, 0.03, 0.0], [0.0, 0.04, 0.0]])
    };
    document.scene.bodies[0].fibres.insert(0, fibre);
    assert!(matches!(document.scene.bodies[0].material.mass, Mass::PerParticle(_)));
    let before = of_the_body(&document.scene);
    let mut window = open(document);
    hold(&mut window);
    let particles = window.state().published().status.particles;
    for (edits, (field, value)) in [("Support radius", "0.02"), ("Spacing D / h", "0.5")].into_iter().enumerate() {
        set(&mut window, field, value);
        until(&mut window, |app| app.published().status.edits == 1 + edits as u64 && is_settled(app));
        let after = of_the_body(window.state().scene());
        for (after, before) in after.iter().zip(before) {
            assert!((after / before - 1.0).abs() < 0.02, "{field}: {after}, before {before}");
        }
    }
    let fewer = window.state().published().status.particles;
    assert!(fewer < particles && fewer > 20, "{particles} became {fewer}");
    press_key(&mut window, Modifiers::COMMAND, Key::Z);
    press_key(&mut window, Modifiers::COMMAND, Key::Z);
    assert!(matches!(window.state().scene().bodies[0].material.mass, Mass::PerParticle(_)));
}

#[test]
fn a_bad_value_is_held_in_range_and_loses_nothing() {
    let mut window = still();
    set(&mut window, "Poisson's ratio", "7");
    assert_eq!(window.state().scene().bodies[0].material.poisson_ratio, 0.49);
    set(&mut window, "Particle mass", "nonsense");
    assert!(window.state().scene().validate().is_ok());
}

#[test]
fn a_panel_is_added_falls_and_is_removed() {
    let mut window = still();
    click(&mut window, "World");
    click(&mut window, "Add a heavy panel");
    let panels = window.state().scene().panels.clone();
    assert_eq!((panels.len(), &panels[0].motion), (1, &PanelMotion::Falls));
    until(&mut window, |app| app.published().snapshot.panels.len() == 1);
    press_key(&mut window, Modifiers::NONE, Key::Space);
    until(&mut window, |app| app.published().snapshot.panels.first().is_some_and(|at| *at < panels[0].height - 1e-3));
    press_key(&mut window, Modifiers::COMMAND, Key::Z);
    assert!(window.state().scene().panels.is_empty());
}

#[test]
fn a_body_is_told_to_touch_itself_and_goes_on_moving() {
    let mut window = still();
    let (before, time) = (window.state().scene().clone(), window.state().published().status.time);
    click(&mut window, "Touches itself");
    assert!(window.state().scene().bodies[0].self_contact);
    until(&mut window, is_settled);
    assert_eq!(window.state().published().status.time, time);
    press_key(&mut window, Modifiers::COMMAND, Key::Z);
    assert_eq!(*window.state().scene(), before);
}

#[test]
fn a_pin_holds_the_bottom_and_can_be_removed() {
    let mut window = still();
    click(&mut window, "World");
    click_on(&mut window, Role::ComboBox, "Pin a region");
    let pins = window.state().scene().bodies[0].pins.len();
    click(&mut window, "right");
    let body = window.state().scene().bodies[0].clone();
    assert_eq!(body.pins.len(), pins + 1);
    assert_eq!(body.pins[pins].axes, [Axis::X, Axis::Y, Axis::Z]);
    assert!(body.regions.iter().any(|region| region.id == body.pins[pins].region));
    until(&mut window, |app| app.published().status.edits == 1 && is_settled(app));
    assert!(window.state().published().status.failure.is_none());
}

#[test]
fn a_pin_added_on_the_way_holds_what_it_finds_and_not_the_start() {
    let mut window = still();
    for _ in 0..30 {
        advance(&mut window);
    }
    let particles = |window: &Window| window.state().published().snapshot.bodies[0].particles.clone();
    let rest = window.state().published().at_rest.bodies[0].particles.clone();
    let top = rest.iter().map(|x| x.y).fold(f64::NEG_INFINITY, f64::max);
    let held: Vec<usize> = (0..rest.len()).filter(|&i| rest[i].y > top - 1e-6).collect();
    let found = particles(&window);
    let start = window.state().published().placed.expect("a body")[1].y;
    assert!((found[held[0]].y - start).abs() > 5e-3, "it is elsewhere by now: {}", found[held[0]].y - start);
    click(&mut window, "World");
    click_on(&mut window, Role::ComboBox, "Pin a region");
    click(&mut window, "top");
    until(&mut window, |app| app.published().status.edits == 1 && is_settled(app));
    for _ in 0..20 {
        advance(&mut window);
    }
    let now = particles(&window);
    for &i in &held {
        assert!(now[i].distance(found[i]) < 1e-12, "particle {i} went from {} to {}", found[i], now[i]);
    }
    assert!(now.iter().any(|x| x.distance(DVec3::ZERO) > 0.0) && now != found, "the rest still moves");
    assert!(window.state().published().status.divergence.is_none());
    // Another edit, and an earlier frame, leave it where it is held.
    set(&mut window, "Gravity", "-9");
    until(&mut window, |app| app.published().status.edits == 2 && is_settled(app));
    for key in [Key::ArrowLeft, Key::ArrowLeft] {
        press_key(&mut window, Modifiers::NONE, key);
    }
    press_key(&mut window, Modifiers::SHIFT, Key::Enter);
    let time = window.state().published().status.time;
    until(&mut window, |app| app.published().status.time > time + 0.1);
    for &i in &held {
        assert!(particles(&window)[i].distance(found[i]) < 1e-12);
    }
    // From the start on it holds the start.
    hold(&mut window);
    reset(&mut window);
    assert!((particles(&window)[held[0]].y - found[held[0]].y).abs() > 5e-3);
}

#[test]
fn a_strike_gives_the_impulse_at_once_and_changes_no_scene() {
    let mut window = open(scene(
        r#"{"version": 1, "gravity": [0, 0, 0], "bodies": [{"id": "cube", "shape": {"box": {"size": [0.04, 0.04, 0.04]}},
            "material": {"young_modulus": 1e5, "mass": {"per_particle": 4e-4}, "support_radius": 0.02}}]}"#,
    ));
    let before = window.state().scene().clone();
    let x = |app: &sinew::test_support::ui::App| {
        app.published().snapshot.bodies[0].particles.iter().map(|x| x.x).sum::<f64>()
    };
    let start = x(window.state());
    click(&mut window, "World");
    let field =
        window.get_all_by_role(Role::SpinButton).find(|node| node.value().is_some_and(|text| text.contains("X 0.1")));
    field.expect("the impulse along X").click();
    window.step();
    press_key(&mut window, Modifiers::COMMAND, Key::A);
    window.event(Event::Text("0.01".to_owned()));
    window.step();
    press_key(&mut window, Modifiers::NONE, Key::Enter);
    click(&mut window, "Strike");
    until(&mut window, |app| x(app) > start + 1e-3);
    assert_eq!(window.state().scene(), &before);
}

#[test]
fn the_time_step_can_be_given_by_hand_and_its_limit_is_told() {
    let mut window = still();
    click(&mut window, "World");
    click(&mut window, "By hand");
    assert!(matches!(window.state().scene().time.step, TimeStep::Manual(_)));
    window.get_by_role_and_label(Role::SpinButton, "DT").scroll_to_me();
    window.run_steps(20);
    set(&mut window, "DT", "0.01");
    until(&mut window, |app| app.published().status.bodies.iter().any(|body| (body.dt - 0.01).abs() < 1e-9));
    window.step();
    assert!(window.query_all_by_label_contains("is beyond its limit").next().is_some());
}

#[test]
fn a_scene_is_saved_and_opened_by_typed_paths() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("mine.json");
    let mut window = still();
    set(&mut window, "Particle mass", "5e-4");
    press_key(&mut window, Modifiers::COMMAND | Modifiers::SHIFT, Key::S);
    type_path(&mut window, &path);
    assert_eq!(&load_scene(&path).expect("it was written"), &**window.state().scene());
    press_key(&mut window, Modifiers::COMMAND, Key::N);
    assert_ne!(&load_scene(&path).expect("it is still there"), &**window.state().scene());
    press_key(&mut window, Modifiers::COMMAND, Key::O);
    type_path(&mut window, &path);
    assert_eq!(&load_scene(&path).expect("it is still there"), &**window.state().scene());
}

#[test]
fn what_cannot_be_opened_is_said_and_loses_nothing() {
    let mut window = still();
    let before = window.state().scene().clone();
    press_key(&mut window, Modifiers::COMMAND, Key::O);
    type_path(&mut window, Path::new("/nowhere/at/all.json"));
    assert!(window.state().message().is_some_and(|text| text.contains("all.json")), "{:?}", window.state().message());
    assert_eq!(window.state().scene(), &before);
}

#[test]
fn a_model_that_is_dropped_becomes_a_soft_solid() {
    let mut window = still();
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/leaf.glb");
    drop_file(&mut window, path);
    window.step();
    let body = &window.state().scene().bodies[0];
    assert!(matches!(&body.shape, Shape::Mesh(_)), "{:?}", window.state().message());
    // While it is put together there is no body.
    until(&mut window, |app| app.published().at_rest.bodies.first().is_some_and(|body| body.skin.len() > 1000));
    assert!(window.state().published().status.failure.is_none());
}

#[derive(Debug)]
struct Dropped(PathBuf);

impl egui::DroppedFile for Dropped {
    fn path(&self) -> &Path {
        &self.0
    }

    fn bytes(&self) -> Result<Vec<u8>, String> {
        std::fs::read(&self.0).map_err(|error| error.to_string())
    }
}

pub(super) fn dropped(path: PathBuf) -> Arc<dyn egui::DroppedFile + Send + Sync> {
    Arc::new(Dropped(path))
}

pub(super) fn drop_file(window: &mut Window, path: PathBuf) {
    window.input_mut().dropped_files.push(dropped(path));
    window.step();
    until(window, |app| !app.is_loading());
}
