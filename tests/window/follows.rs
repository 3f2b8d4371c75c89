//! What a body follows: chosen, set, and let go of in the body's tab.

#[path = "../alive/rig.rs"]
#[allow(dead_code, reason = "other tests use the rest of it")]
mod rig;

use super::editing::{set, type_path};
use super::{Window, click, click_on, drag, hold, is_settled, open, press_key, until};
use egui::accesskit::Role;
use egui::{Event, Key, Modifiers, OutputCommand, PointerButton, Pos2, Vec2};
use egui_kittest::kittest::Queryable;
use rig::{Rig, write_cache};
use sinew::scene::{Follow, FollowSelect, Hold, Leader};
use sinew::ui::Document;

/// The window on a column that hangs on a skeleton in its own folder, held still.
fn column() -> (Window, Rig) {
    let rig = Rig::column();
    let path = rig.path().join("scene.json");
    let text = r#"{"version": 1, "gravity": [0, 0, 0], "bodies": [{"id": "column",
        "shape": {"mesh": {"path": "rig.gltf"}},
        "material": {"young_modulus": 2e4, "mass": {"density": 1000}, "support_radius": 0.03}}]}"#;
    std::fs::write(&path, text).expect("a file");
    let mut window = open(Document::load(Some(path)).expect("a scene that is there"));
    hold(&mut window);
    (window, rig)
}

fn follows(window: &Window) -> Vec<Follow> {
    window.state().scene().bodies[0].follows.clone()
}

fn settle(window: &mut Window) {
    window.step();
    until(window, is_settled);
    window.run_steps(2);
}

fn follow(window: &mut Window, rig: &Rig, name: &str) {
    find(window, Role::Button, "Follow a motion…");
    click(window, "Follow a motion…");
    type_path(window, &rig.path().join(name));
    until(window, |app| !app.is_loading());
    settle(window);
}

/// Scrolls to where something is.
fn find(window: &mut Window, role: Role, label: &str) {
    window.get_by_role_and_label(role, label).scroll_to_me();
    window.run_steps(20);
}

/// Types a number wherever its field is.
fn write(window: &mut Window, label: &str, value: &str) {
    find(window, Role::SpinButton, label);
    set(window, label, value);
}

/// Chooses in a list.
fn choose(window: &mut Window, list: &str, entry: &str) {
    find(window, Role::ComboBox, list);
    click_on(window, Role::ComboBox, list);
    click(window, entry);
    settle(window);
}

#[test]
fn a_body_is_made_to_follow_a_skeleton_step_by_step() {
    let (mut window, rig) = column();
    follow(&mut window, &rig, "rig.gltf");
    let first = follows(&window);
    let [Follow { leader: Leader::Skeleton(skeleton), hold: Hold::Hard, .. }] = &first[..] else { panic!("{first:?}") };
    assert_eq!(skeleton.path, "rig.gltf");
    let state = &window.state().published();
    assert!(state.status.failure.is_none() && state.held[0].len() == 1 && !state.held[0][0].is_empty());
    let held = state.held[0][0].len();
    choose(&mut window, "What follows", "everything");
    assert_eq!(follows(&window)[0].select, FollowSelect::Everything);
    assert!(window.state().published().held[0][0].len() > held);
    write(&mut window, "Pre-roll", "0.3");
    assert_eq!(follows(&window)[0].pre_roll, 0.3);
    write(&mut window, "From", "0.15");
    assert_eq!(follows(&window)[0].from, 0.15);
    choose(&mut window, "Held", "by springs");
    write(&mut window, "Stiffness", "900");
    let Hold::Springs(springs) = &follows(&window)[0].hold else { panic!("no springs") };
    assert_eq!((springs.stiffness, springs.damping), (900.0, 0.5));
    settle(&mut window);
    assert!(window.state().published().held[0].is_empty() && window.state().published().status.failure.is_none());
    // Step by step back to where nothing is followed, and the last of them again.
    for _ in 0..6 {
        press_key(&mut window, Modifiers::COMMAND, Key::Z);
    }
    assert!(follows(&window).is_empty());
    press_key(&mut window, Modifiers::COMMAND | Modifiers::SHIFT, Key::Z);
    assert_eq!(follows(&window), first);
    find(&mut window, Role::Button, "Stop following");
    click(&mut window, "Stop following");
    assert!(follows(&window).is_empty());
}

#[test]
fn what_cannot_be_followed_is_said_and_nothing_changes() {
    let (mut window, rig) = column();
    for (name, said) in [("scene.json", "glTF or GLB file with a skin"), ("none.pc2", "no such file")] {
        follow(&mut window, &rig, name);
        let message = window.state().message().unwrap_or_default().to_owned();
        assert!(message.contains(said) && message.contains(name), "{message}");
        assert!(follows(&window).is_empty());
    }
    // A cache of the body's own vertices is followed as a whole.
    write_cache(rig.path(), "still.pc2", &[0.0], |at, _| at);
    follow(&mut window, &rig, "still.pc2");
    assert!(matches!(&follows(&window)[..], [Follow { select: FollowSelect::Everything, .. }]));
    assert!(window.state().published().status.failure.is_none());
}

#[test]
fn how_much_follows_is_painted_with_the_brush() {
    let (mut window, rig) = column();
    follow(&mut window, &rig, "rig.gltf");
    press_key(&mut window, Modifiers::NONE, Key::Home);
    window.run_steps(40);
    press_key(&mut window, Modifiers::NONE, Key::V);
    window.run_steps(3);
    choose_label(&mut window, "Volume fraction", "What follows \"motion-1\"");
    set(&mut window, "Painted share", "0.25");
    let particles = &window.state().published().snapshot.bodies[0].particles;
    let middle = particles.iter().sum::<glam::DVec3>() / particles.len() as f64;
    let middle = window.state().shown_at(middle).expect("the body is in sight");
    let path: Vec<Pos2> = (0..=20).map(|k| middle + Vec2::new(0.0, k as f32 - 10.0)).collect();
    drag(&mut window, &path);
    settle(&mut window);
    let painted = follows(&window)[0].paint.clone();
    assert!(!painted.is_empty() && painted.iter().all(|dab| dab.value == 0.25), "{painted:?}");
    assert!(window.state().scene().bodies[0].paint.is_empty(), "the volume fraction is not painted");
    click(&mut window, "Clear paint");
    assert!(follows(&window)[0].paint.is_empty());
    press_key(&mut window, Modifiers::COMMAND, Key::Z);
    assert_eq!(follows(&window)[0].paint, painted);
    press_key(&mut window, Modifiers::COMMAND, Key::Z);
    assert!(follows(&window)[0].paint.is_empty(), "a stroke is one step");
}

#[test]
fn a_copy_follows_as_well_in_the_same_scene_and_in_another() {
    let (mut window, rig) = column();
    follow(&mut window, &rig, "rig.gltf");
    click(&mut window, "column");
    window.event(Event::Copy);
    window.step();
    let text = window.output().platform_output.commands.iter().find_map(|command| match command {
        OutputCommand::CopyText(text) => Some(text.clone()),
        _ => None,
    });
    let text = text.expect("it is on the clipboard");
    let mut other = open(super::scene(
        r#"{"version": 1, "gravity": [0, 0, 0], "bodies": [{"id": "cube", "shape": {"box": {"size": [0.05, 0.05, 0.05]}},
            "placement": {"translation": [0.5, 0, 0]},
            "material": {"young_modulus": 2e4, "mass": {"density": 1000}, "support_radius": 0.03}}]}"#,
    ));
    hold(&mut other);
    for window in [&mut window, &mut other] {
        let bodies = window.state().scene().bodies.len();
        window.event(Event::Paste(text.clone()));
        window.run_steps(2);
        until(window, |app| is_settled(app) && app.published().at_rest.bodies.len() == bodies + 1);
        let said = window.state().message().unwrap_or_default().to_owned();
        assert_eq!(window.state().published().status.failure, None, "{said}");
        assert_eq!(window.state().scene().bodies[bodies].follows.len(), 1);
    }
    // In the same folder the files have the names that they had.
    let paths = window.state().scene().bodies.iter().map(|body| body.follows[0].leader.path().to_owned());
    assert_eq!(paths.collect::<Vec<_>>(), ["rig.gltf", "rig.gltf"]);
}

/// Chooses in the list that shows something.
fn choose_label(window: &mut Window, shown: &str, entry: &str) {
    let list = window.get_all_by_role(Role::ComboBox).find(|list| list.value().as_deref() == Some(shown));
    let at = list.expect("a list that shows it").rect().center();
    super::button(window, at, PointerButton::Primary, true);
    window.step();
    super::button(window, at, PointerButton::Primary, false);
    window.run_steps(5);
    click_on(window, Role::Button, entry);
    window.run_steps(2);
}
