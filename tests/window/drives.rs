//! Drives are seen in lanes below the timeline, and keyed, by pointer and keys.

use super::{Window, advance, button, click, click_on, drag, hold, open, press_key, reset, scene};
use egui::accesskit::Role;
use egui::{Event, Key, Modifiers, OutputCommand, PointerButton, Pos2, Rect, Vec2};
use egui_kittest::kittest::{NodeT, Queryable};
use sinew::scene::{AfterLast, Drivable, Drive, DriveKeys, Interpolation, Scene};

pub(super) const FRAME: f64 = 1.0 / 60.0;

/// A bar with a fibre that follows a shared drive, one with a drive of its own, and a ring with gas.
pub(super) const SCENE: &str = r#"{
    "version": 1, "name": "Keys", "gravity": [0, 0, 0],
    "bodies": [{
        "id": "bar", "name": "Bar", "shape": {"box": {"size": [0.06, 0.02, 0.02]}},
        "material": {"young_modulus": 20000, "mass": {"density": 1000}, "support_radius": 0.0125},
        "drives": [{"id": "pull", "drive": {"keyframes": {
            "keys": [{"time": 0, "value": 0}, {"time": 1, "value": 1}, {"time": 2, "value": 0.5}]}}}],
        "fibres": [
            {"id": "a", "name": "Alpha", "source": {"vertices": [[-0.025, 0, 0], [0, 0, 0], [0.025, 0, 0]]},
             "stiffness": {"rigidity": {"ea": 10, "ei": 0}}, "activation": {"drive": {"shared": "pull"}, "contract": 0.3}},
            {"id": "b", "name": "Beta", "source": {"vertices": [[-0.025, 0.005, 0], [0, 0.005, 0], [0.025, 0.005, 0]]},
             "stiffness": {"rigidity": {"ea": 10, "ei": 0}}, "activation": {"drive": {"wave": {"period": 0.5}}, "contract": 0.2}},
            {"id": "c", "name": "Gamma", "source": {"vertices": [[-0.025, 0, 0.005], [0, 0, 0.005], [0.025, 0, 0.005]]},
             "stiffness": {"rigidity": {"ea": 10, "ei": 0}}}
        ],
        "regions": [{"id": "end", "select": {"layers": {"axis": "x", "side": "min", "count": 1}}}],
        "pins": [{"id": "hold", "region": "end"}]
    }],
    "two_layer": [{"id": "ring", "name": "Ring", "shape": {"ring": {}}, "placement": {"translation": [0, 5, 0]}}]
}"#;

pub(super) fn pull() -> Drivable {
    Drivable::Shared { body: "bar".into(), drive: "pull".into() }
}

pub(super) fn fibre(fibre: &str) -> Drivable {
    Drivable::Fibre { body: "bar".into(), fibre: fibre.into() }
}

/// The scene with its lanes, held at its start.
pub(super) fn lanes() -> Window {
    let mut window = open(scene(SCENE));
    hold(&mut window);
    press_key(&mut window, Modifiers::ALT, Key::D);
    reset(&mut window);
    window.run_steps(2);
    window
}

pub(super) fn lane(window: &Window, name: &str) -> Rect {
    window.get_by_label(&format!("Lane of {name}")).rect()
}

/// Where a lane shows a value at a time, on a scale of five seconds and of values from 0 to 1.
pub(super) fn at(window: &Window, name: &str, time: f64, value: f64) -> Pos2 {
    let lane = lane(window, name);
    let (x, y) = ((time / 5.0) as f32, ((value + 0.16) / 1.32) as f32);
    Pos2::new(lane.left() + x * lane.width(), lane.bottom() - 2.0 - y * (lane.height() - 4.0))
}

pub(super) fn keys_of(scene: &Scene, of: &Drivable) -> DriveKeys {
    match of.drive(scene) {
        Some(Drive::Keyframes(keys)) => keys.clone(),
        other => panic!("{of:?} has {other:?}"),
    }
}

pub(super) fn pairs(window: &Window, of: &Drivable) -> Vec<(f64, f64)> {
    keys_of(window.state().scene(), of).keys.iter().map(|key| (key.time, key.value)).collect()
}

pub(super) fn is_near(pairs: &[(f64, f64)], expected: &[(f64, f64)], within: f64) {
    let near = |(a, b): (&(f64, f64), &(f64, f64))| (a.0 - b.0).abs() < 1e-9 && (a.1 - b.1).abs() <= within;
    assert!(pairs.len() == expected.len() && pairs.iter().zip(expected).all(near), "{pairs:?}, not {expected:?}");
}

pub(super) fn undo(window: &mut Window) {
    press_key(window, Modifiers::COMMAND, Key::Z);
    window.step();
}

/// What is done is one step of undo of this name: undone it is gone, and done again it is there.
pub(super) fn one_step(window: &mut Window, name: &str, change: impl FnOnce(&mut Window)) {
    let before = window.state().scene().clone();
    change(window);
    window.run_steps(2);
    let after = window.state().scene().clone();
    assert_ne!(before, after, "it changes something; {:?}", window.state().message());
    assert_eq!(window.state().undo_name(), Some(name));
    undo(window);
    assert_eq!(*window.state().scene(), before);
    press_key(window, Modifiers::COMMAND.plus(Modifiers::SHIFT), Key::Z);
    window.step();
    assert_eq!(*window.state().scene(), after);
}

pub(super) fn click_at(window: &mut Window, at: Pos2) {
    button(window, at, PointerButton::Primary, true);
    window.step();
    button(window, at, PointerButton::Primary, false);
    window.run_steps(2);
}

fn double_click(window: &mut Window, at: Pos2) {
    // What was clicked before belongs to no double click.
    window.run_steps(40);
    click_at(window, at);
    click_at(window, at);
    window.run_steps(2);
}

/// A drag with Shift held.
fn shift_drag(window: &mut Window, from: Pos2, to: Pos2) {
    window.event(Event::PointerMoved(from));
    window.event(Event::ModifiersChanged(Modifiers::SHIFT));
    button(window, from, PointerButton::Primary, true);
    for share in [0.3, 0.6, 1.0] {
        window.event(Event::PointerMoved(from.lerp(to, share)));
    }
    button(window, to, PointerButton::Primary, false);
    window.event(Event::ModifiersChanged(Modifiers::NONE));
    window.run_steps(14);
}

pub(super) fn chosen(window: &Window, keys: &[(&str, usize)]) {
    let keys: Vec<(String, usize)> = keys.iter().map(|(name, index)| ((*name).to_owned(), *index)).collect();
    assert_eq!(window.state().selected_keys(), keys);
}

/// Types into the number field whose text begins so.
pub(super) fn type_into(window: &mut Window, begin: &str, text: &str) {
    let is_it = |node: &egui_kittest::Node<'_>| node.value().is_some_and(|value| value.starts_with(begin));
    let field = window.get_all_by_role(Role::SpinButton).find(is_it).map(|node| node.rect().center());
    let field = field.unwrap_or_else(|| panic!("there is no field {begin}"));
    click_at(window, field);
    window.run_steps(2);
    press_key(window, Modifiers::COMMAND, Key::A);
    window.event(Event::Text(text.to_owned()));
    window.step();
    press_key(window, Modifiers::NONE, Key::Enter);
    window.step();
}

/// Chooses in a menu of a lane: the menu that shows `now` at the height of the lane.
pub(super) fn choose(window: &mut Window, name: &str, now: &str, then: &str) {
    let place = lane(window, name);
    let beside = |node: &egui_kittest::Node<'_>| place.y_range().contains(node.rect().center().y);
    let menus = window.query_all_by_role(Role::ComboBox).filter(|node| node.value().as_deref() == Some(now));
    let menus: Vec<_> = menus.filter(beside).collect();
    assert_eq!(menus.len(), 1, "one menu of {name} shows {now}");
    let menu = menus[0].rect().center();
    drop(menus);
    click_at(window, menu);
    window.run_steps(3);
    click_on(window, Role::Button, then);
    window.run_steps(2);
}

#[test]
fn every_drive_has_a_lane_and_lanes_fold_away() {
    let mut window = lanes();
    let names = |window: &Window| {
        let lanes = window.query_all_by_label_contains("Lane of ");
        lanes.map(|node| node.accesskit_node().value().unwrap_or_default()).collect::<Vec<_>>()
    };
    let expected = ["Lane of pull, Bar", "Lane of Alpha, Bar", "Lane of Beta, Bar"];
    assert_eq!(names(&window), expected);
    assert!(lane(&window, "Alpha, Bar").height() < lane(&window, "pull, Bar").height(), "what follows is lower");
    // They stand below the timeline, over the same times.
    let bar = window.get_by_label_contains("Timeline from").rect();
    assert!(lane(&window, "pull, Bar").top() > bar.center().y);
    assert_eq!(lane(&window, "pull, Bar").x_range(), bar.shrink2(Vec2::new(8.0, 0.0)).x_range());
    click(&mut window, "Drives 3");
    assert!(names(&window).is_empty());
    click(&mut window, "View");
    window.get_by_label_contains("Show drives").click();
    window.run_steps(2);
    assert_eq!(names(&window), expected);
}

#[test]
fn a_key_is_dragged_onto_frames_and_freely_with_shift() {
    let mut window = lanes();
    let name = "pull, Bar";
    let grabbed = at(&window, name, 1.0, 1.0);
    let aim = at(&window, name, 1.5, 0.5);
    one_step(&mut window, "Move key", |window| drag(window, &[grabbed, grabbed.lerp(aim, 0.5), aim]));
    chosen(&window, &[(name, 1)]);
    is_near(&pairs(&window, &pull()), &[(0.0, 0.0), (1.5, 0.5), (2.0, 0.5)], 0.03);
    let value = pairs(&window, &pull())[1].1;
    assert_eq!(value, (100.0 * value).round() / 100.0, "it is a round one");
    undo(&mut window);
    // Straight along, its value stays; past others, it is one of the later.
    let past = at(&window, name, 2.5, 1.0) + Vec2::new(0.0, 2.0);
    drag(&mut window, &[grabbed, past]);
    is_near(&pairs(&window, &pull()), &[(0.0, 0.0), (2.0, 0.5), (2.5, 1.0)], 0.0);
    chosen(&window, &[(name, 2)]);
    undo(&mut window);
    let off = at(&window, name, 1.5 + 0.3 * FRAME, 0.5);
    one_step(&mut window, "Move key", |window| shift_drag(window, grabbed, off));
    let (time, _) = pairs(&window, &pull())[1];
    assert!((time / FRAME - (time / FRAME).round()).abs() > 0.05 && (time - 1.5).abs() < 2.0 * FRAME, "{time}");
    // Neither before the start nor out of the lane.
    undo(&mut window);
    let nowhere = lane(&window, name).left_top() - Vec2::new(300.0, 300.0);
    drag(&mut window, &[grabbed, nowhere]);
    let moved = pairs(&window, &pull());
    assert!(moved.len() == 2 && moved[0].0 == 0.0 && (1.0..1.17).contains(&moved[0].1), "{moved:?}");
}

#[test]
fn escape_puts_dragged_keys_back() {
    let mut window = lanes();
    let before = window.state().scene().clone();
    let name = "pull, Bar";
    let (from, to) = (at(&window, name, 1.0, 1.0), at(&window, name, 1.6, 0.4));
    window.event(Event::PointerMoved(from));
    button(&window, from, PointerButton::Primary, true);
    window.event(Event::PointerMoved(from.lerp(to, 0.5)));
    window.event(Event::PointerMoved(to));
    window.run_steps(5);
    assert_ne!(*window.state().scene(), before);
    press_key(&mut window, Modifiers::NONE, Key::Escape);
    assert_eq!((window.state().scene().clone(), window.state().undo_name()), (before.clone(), None));
    window.event(Event::PointerMoved(to + Vec2::splat(9.0)));
    button(&window, to, PointerButton::Primary, false);
    window.run_steps(3);
    assert_eq!(*window.state().scene(), before);
}

#[test]
fn a_double_click_adds_a_key_and_delete_removes_it() {
    let mut window = lanes();
    let name = "pull, Bar";
    let place = at(&window, name, 3.0, 0.25);
    one_step(&mut window, "Add key", |window| double_click(window, place));
    is_near(&pairs(&window, &pull()), &[(0.0, 0.0), (1.0, 1.0), (2.0, 0.5), (3.0, 0.25)], 0.03);
    chosen(&window, &[]);
    click_at(&mut window, place);
    chosen(&window, &[(name, 3)]);
    one_step(&mut window, "Delete key", |window| press_key(window, Modifiers::NONE, Key::Delete));
    assert_eq!(pairs(&window, &pull()).len(), 3);
    assert_eq!(window.state().scene().bodies[0].fibres.len(), 3, "no fibre is deleted");
    // The fibre is what Delete takes once it was clicked.
    let key = at(&window, name, 1.0, 1.0);
    click_at(&mut window, key);
    click(&mut window, "Gamma");
    press_key(&mut window, Modifiers::NONE, Key::Delete);
    assert_eq!((window.state().scene().bodies[0].fibres.len(), pairs(&window, &pull()).len()), (2, 3));
}

#[test]
fn a_box_chooses_keys_of_lanes_that_are_moved_copied_and_pasted() {
    let mut window = lanes();
    choose(&mut window, "Beta, Bar", "Wave", "Keys");
    is_near(&pairs(&window, &fibre("b")), &[(0.0, 0.0), (0.25, 1.0), (0.5, 0.0)], 1e-12);
    let all = at(&window, "pull, Bar", -0.02, 1.1);
    let last = at(&window, "Beta, Bar", 1.3, -0.1);
    drag(&mut window, &[all + Vec2::new(6.0, 0.0), last]);
    chosen(&window, &[("pull, Bar", 1), ("Beta, Bar", 1), ("Beta, Bar", 2)]);
    let grabbed = at(&window, "pull, Bar", 1.0, 1.0);
    one_step(&mut window, "Move 3 keys", |window| drag(window, &[grabbed, grabbed + Vec2::new(40.0, 0.0)]));
    let later = pairs(&window, &pull())[1].0 - 1.0;
    assert!(later > 0.1 && ((later / FRAME).round() - later / FRAME).abs() < 1e-9, "{later}");
    is_near(&pairs(&window, &fibre("b")), &[(0.0, 0.0), (0.25 + later, 1.0), (0.5 + later, 0.0)], 1e-12);
    window.event(Event::Copy);
    window.step();
    let copied = window.output().platform_output.commands.iter().find_map(|command| match command {
        OutputCommand::CopyText(text) => Some(text.clone()),
        _ => None,
    });
    let text = copied.expect("it is on the clipboard");
    // From the first of them on, at the time that is shown.
    for _ in 0..6 {
        advance(&mut window);
    }
    one_step(&mut window, "Paste 3 keys", |window| {
        window.event(Event::Paste(text));
        window.run_steps(2);
    });
    is_near(&pairs(&window, &pull())[1..2], &[(0.1 + 0.75, 1.0)], 1e-9);
    is_near(&pairs(&window, &fibre("b"))[1..3], &[(0.1, 1.0), (0.35, 0.0)], 1e-9);
}

#[test]
fn another_kind_of_drive_is_chosen_and_its_numbers_typed() {
    let mut window = lanes();
    let name = "pull, Bar";
    one_step(&mut window, "Change drive", |window| choose(window, name, "Smooth", "Stepped"));
    choose(&mut window, name, "Hold", "Mirror");
    let keys = keys_of(window.state().scene(), &pull());
    assert_eq!((keys.between, keys.after), (Interpolation::Stepped, AfterLast::Mirror));
    choose(&mut window, name, "Keys", "Wave");
    type_into(&mut window, "every 2", "0.8");
    type_into(&mut window, "phase 0", "90");
    type_into(&mut window, "length none", "30 mm");
    let Some(Drive::Wave(wave)) = pull().drive(window.state().scene()).cloned() else { panic!("it is a wave") };
    assert_eq!((wave.mean, wave.amplitude, wave.period, wave.phase_degrees), (0.5, 0.5, 0.8, 90.0));
    assert_eq!(wave.wavelength, Some(0.03));
    type_into(&mut window, "length 0.03", "0");
    choose(&mut window, name, "Wave", "Constant");
    type_into(&mut window, "value ", "0.4");
    assert_eq!(pull().drive(window.state().scene()), Some(&Drive::Constant(0.4)));
    // What follows has one of its own where the shared one goes.
    choose(&mut window, name, "Constant", "Remove");
    assert_eq!(pull().drive(window.state().scene()), None);
    assert_eq!(fibre("a").drive(window.state().scene()), Some(&Drive::Constant(0.4)));
    choose(&mut window, "Alpha, Bar", "Constant", "Share it");
    assert_eq!(fibre("a").drive(window.state().scene()), Some(&Drive::Shared("drive-1".into())));
    choose(&mut window, "Beta, Bar", "Wave", "Shared: drive-1");
    assert_eq!(fibre("b").resolved(window.state().scene()), Some(&Drive::Constant(0.4)));
}

#[test]
fn the_selected_key_is_typed_as_numbers() {
    let mut window = lanes();
    let key = at(&window, "pull, Bar", 1.0, 1.0);
    click_at(&mut window, key);
    one_step(&mut window, "Change drive", |window| type_into(window, "key at 1", "1.25"));
    chosen(&window, &[("pull, Bar", 1)]);
    type_into(&mut window, "is 1", "3/4");
    is_near(&pairs(&window, &pull()), &[(0.0, 0.0), (1.25, 0.75), (2.0, 0.5)], 1e-12);
}
