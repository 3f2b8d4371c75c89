//! What is keyed beside its field, acts at once, and is seen to act.

use super::drive_waves::paths_in;
use super::drives::{FRAME, SCENE, at, fibre, is_near, lane, lanes, one_step, pairs, pull, type_into, undo};
use super::{Window, advance, click, click_on, drag, hold, is_settled, open, press_key, reset, scene, until};
use egui::accesskit::Role;
use egui::{Color32, Event, Key, Modifiers, Rect, Vec2};
use egui_kittest::kittest::Queryable;
use sinew::scene::{Drivable, Drive, Motion};

#[test]
fn a_diamond_sets_and_removes_a_key_at_the_time_that_is_shown() {
    let mut window = lanes();
    for _ in 0..6 {
        advance(&mut window);
    }
    click(&mut window, "World");
    one_step(&mut window, "Set key", |window| click(window, "Set a key of Gravity"));
    is_near(&pairs(&window, &Drivable::Gravity), &[(0.1, 1.0)], 1e-12);
    assert!(window.query_by_label("Lane of Gravity").is_some());
    one_step(&mut window, "Remove key", |window| {
        window.query_all_by_label("Remove the key of Gravity").next().expect("a button").click();
    });
    assert_eq!(Drivable::Gravity.drive(window.state().scene()), Some(&Drive::Constant(1.0)));
    // A pin: it stays where it is, and goes from there.
    one_step(&mut window, "Set key", |window| click(window, "Set a key of Pin hold, Bar"));
    let pin = Drivable::Pin { body: "bar".into(), pin: "hold".into() };
    is_near(&pairs(&window, &pin), &[(0.1, 0.0)], 1e-12);
    let Motion::Driven(driven) = &window.state().scene().bodies[0].pins[0].motion else { panic!("it is driven") };
    assert_eq!(driven.offset, [0.0, 0.01, 0.0]);
    until(&mut window, is_settled);
}

/// What fills the polygons that are drawn in a button.
fn fills(window: &Window, button: Rect) -> Vec<Color32> {
    paths_in(window, button).into_iter().filter(|path| path.closed).map(|path| path.fill).collect()
}

fn is_red(of: Color32) -> bool {
    let [r, g, b, a] = of.to_array();
    a == 255 && r > 150 && u32::from(r) > 3 * u32::from(g.max(b)) / 2
}

/// Clicks the diamond of something that is not keyed yet, and checks that it is red then wherever it is shown.
fn keyed(window: &mut Window, of: &Drivable) {
    let name = format!("Set a key of {}", of.title(window.state().scene()));
    window.run_steps(3);
    let button = window.query_all_by_label(&name).next().unwrap_or_else(|| panic!("{name}")).rect();
    assert!(fills(window, button).iter().all(|fill| !is_red(*fill)), "{of:?} is not keyed yet");
    window.query_all_by_label(&name).next().expect("a button").click();
    window.run_steps(2);
    assert_eq!(window.state().undo_name(), Some("Set key"));
    assert!(matches!(of.drive(window.state().scene()), Some(Drive::Keyframes(_))), "{of:?}");
    window.run_steps(2);
    let name = format!("Remove the key of {}", of.title(window.state().scene()));
    let buttons: Vec<_> = window.query_all_by_label(&name).map(|node| node.rect()).collect();
    assert!(!buttons.is_empty(), "{of:?}");
    for button in buttons {
        // What does not fit into its panel is not drawn.
        assert!(fills(window, button).iter().all(|fill| is_red(*fill)), "{of:?}: {:?}", fills(window, button));
    }
    let first = window.query_all_by_label(&name).next().expect("a button").rect();
    assert!(matches!(fills(window, first)[..], [fill] if is_red(fill)), "{of:?}: {:?}", fills(window, first));
}

/// The window on the scene with a sheet, with the inspector of what has a name.
fn inspected(name: &str, of: &Drivable) -> Window {
    let more = SCENE.replacen(
        r#""regions": [{"id": "end""#,
        r#""sheets": [{"id": "s", "name": "Skin", "source": {"strokes": {
               "first": {"view": "front", "points": [[-0.025, 0.004], [0.025, 0.004]]},
               "second": {"view": "side", "points": [[-0.006, 0.004], [0.006, 0.004]]}}},
               "stiffness": {"et": 900}}],
           "regions": [{"id": "end""#,
        1,
    );
    let mut window = open(scene(&more));
    hold(&mut window);
    reset(&mut window);
    click(&mut window, name);
    click(&mut window, "Activation");
    window.run_steps(20);
    let button = format!("Set a key of {}", of.title(window.state().scene()));
    assert!(window.query_all_by_label(&button).next().is_some(), "{button}");
    window
}

#[test]
fn a_fibre_has_its_diamond() {
    let of = fibre("c");
    keyed(&mut inspected("Gamma", &of), &of);
}

#[test]
fn a_sheet_has_its_diamond() {
    let of = Drivable::Sheet { body: "bar".to_owned(), sheet: "s".into() };
    keyed(&mut inspected("Skin", &of), &of);
}

#[test]
fn whatever_else_a_drive_can_move_has_its_diamond() {
    let more = SCENE.replacen(
        r#""bodies":"#,
        r#""wind": {"velocity": [1, 0, 0]},
           "panels": [{"id": "lid", "height": 0.3, "size": [0.1, 0.1], "motion": "falls"},
                      {"id": "press", "height": 0.5, "size": [0.1, 0.1],
                       "motion": {"driven": [{"time": 0, "height": 0.5}, {"time": 1, "height": 0.4}]}}],
           "colliders": [{"id": "head", "shape": {"sphere": {"radius": 0.01}}, "placement": {"translation": [2, 0, 0]}}],
           "bodies":"#,
        1,
    );
    let more = more.replacen(
        r#""shape": {"ring": {}}"#,
        r#""shape": {"ring": {}},
           "active_springs": [{"id": "across", "region": "everything", "contract": 0.2, "drive": {"constant": 1}}]"#,
        1,
    );
    let mut window = open(scene(&more));
    hold(&mut window);
    reset(&mut window);
    window.set_size(Vec2::new(1280.0, 3000.0));
    click(&mut window, "World");
    for of in [
        Drivable::Wind,
        Drivable::Panel("lid".into()),
        Drivable::Panel("press".into()),
        Drivable::Collider("head".into()),
    ] {
        keyed(&mut window, &of);
    }
    click(&mut window, "Ring");
    click(&mut window, "Material");
    window.run_steps(3);
    let springs = Drivable::Springs { body: "ring".into(), springs: "across".into() };
    for of in [Drivable::Pressure("ring".into()), springs] {
        keyed(&mut window, &of);
    }
    // Over the numbers of a velocity, too, I keys it.
    click(&mut window, "World");
    undo(&mut window);
    window.run_steps(3);
    for _ in 0..2 {
        advance(&mut window);
    }
    let text = |node: &egui_kittest::Node<'_>| node.value().is_some_and(|value| value.starts_with("X 1 m/s"));
    let at = window.get_all_by_role(Role::SpinButton).find(text).expect("the wind's velocity").rect().center();
    window.event(Event::PointerMoved(at));
    window.run_steps(2);
    press_key(&mut window, Modifiers::NONE, Key::I);
    window.step();
    assert_eq!(pairs(&window, &Drivable::Wind).len(), 2);
}

#[test]
fn a_wave_that_is_changed_while_it_moves_acts_at_once_and_is_undone() {
    let mut window = lanes();
    for _ in 0..8 {
        advance(&mut window);
    }
    let length = |window: &Window| {
        let points = &window.state().published().snapshot.bodies[0].particles;
        points.iter().map(|x| x.x).fold(f64::NEG_INFINITY, f64::max)
            - points.iter().map(|x| x.x).fold(f64::INFINITY, f64::min)
    };
    let time = window.state().published().status.time;
    one_step(&mut window, "Change drive", |window| type_into(window, "every 0.5", "0.15"));
    let Some(Drive::Wave(wave)) = fibre("b").drive(window.state().scene()).cloned() else { panic!("a wave") };
    assert_eq!(wave.period, 0.15);
    until(&mut window, is_settled);
    assert!((window.state().published().status.time - time).abs() < 1e-9, "the motion goes on from where it was");
    for _ in 0..5 {
        advance(&mut window);
    }
    let quick = length(&window);
    let mut other = lanes();
    for _ in 0..13 {
        advance(&mut other);
    }
    assert!((quick - length(&other)).abs() > 1e-5, "{quick} {}", length(&other));
}

/// Presses I over a number.
fn i_over(window: &mut Window, label: &str) {
    let field = window.get_by_role_and_label(Role::SpinButton, label);
    window.event(Event::PointerMoved(field.rect().center()));
    window.run_steps(2);
    press_key(window, Modifiers::NONE, Key::I);
    window.step();
}

#[test]
fn i_over_a_field_sets_a_key_of_what_it_is_part_of() {
    let mut window = lanes();
    for _ in 0..3 {
        advance(&mut window);
    }
    // The inspector is seen to its end without the lanes.
    press_key(&mut window, Modifiers::ALT, Key::D);
    click(&mut window, "Gamma");
    click(&mut window, "Activation");
    window.run_steps(20);
    i_over(&mut window, "Contracts by");
    is_near(&pairs(&window, &fibre("c")), &[(0.05, 1.0)], 1e-12);
    // What follows a shared drive keys that, with the value of then; elsewhere I is what it was.
    click(&mut window, "Alpha");
    window.run_steps(20);
    i_over(&mut window, "Contracts by");
    let smooth = |s: f64| s * s * (3.0 - 2.0 * s);
    is_near(&pairs(&window, &pull())[1..2], &[(0.05, smooth(0.05))], 1e-12);
    press_key(&mut window, Modifiers::NONE, Key::I);
    window.step();
    assert_eq!(pairs(&window, &pull()).len(), 3);
    // A wave has no keys, and is said so.
    click(&mut window, "Beta");
    let before = window.state().scene().clone();
    window.run_steps(20);
    let field = window.get_by_role_and_label(Role::SpinButton, "Contracts by");
    window.event(Event::PointerMoved(field.rect().center()));
    window.run_steps(2);
    press_key(&mut window, Modifiers::NONE, Key::I);
    window.step();
    assert_eq!(*window.state().scene(), before);
    assert!(
        window.state().message().is_some_and(|said| said.contains("follows a wave")),
        "{:?}",
        window.state().message()
    );
}

#[test]
fn what_a_fibre_does_is_typed_and_undone() {
    let mut window = lanes();
    // The inspector is seen to its end without the lanes.
    press_key(&mut window, Modifiers::ALT, Key::D);
    click(&mut window, "Gamma");
    click(&mut window, "Activation");
    window.run_steps(20);
    let type_in = |window: &mut Window, label: &str, text: &str| {
        window.get_by_role_and_label(Role::SpinButton, label).click();
        window.run_steps(2);
        press_key(window, Modifiers::COMMAND, Key::A);
        window.event(Event::Text(text.to_owned()));
        window.step();
        press_key(window, Modifiers::NONE, Key::Enter);
        window.run_steps(2);
    };
    one_step(&mut window, "Change Gamma", |window| type_in(window, "Contracts by", "0.25"));
    type_in(&mut window, "Curls by", "400");
    type_in(&mut window, "Muscle pulls", "2");
    window.set_size(Vec2::new(1280.0, 1000.0));
    window.run_steps(3);
    type_in(&mut window, "Volume fraction at 1", "0.75");
    let acts = |window: &Window| window.state().scene().bodies[0].fibres[2].activation.clone().expect("it acts");
    let now = acts(&window);
    assert_eq!((now.contract, now.drive), (0.25, Drive::Constant(1.0)));
    assert_eq!(now.curl.map(|curl| (curl.degrees_per_metre, curl.axis)), Some((400.0, [0.0, 0.0, 1.0])));
    assert_eq!(now.muscle.map(|muscle| (muscle.force, muscle.width)), Some((2.0, 0.5)));
    assert_eq!(now.volume_fraction, Some(0.75));
    click(&mut window, "Acts no more");
    assert_eq!(window.state().scene().bodies[0].fibres[2].activation, None);
}

#[test]
fn anything_else_is_given_its_first_key_by_the_menu() {
    let mut window = lanes();
    click(&mut window, "Add a drive");
    click_on(&mut window, Role::Button, "Gas in Ring");
    window.run_steps(3);
    is_near(&pairs(&window, &Drivable::Pressure("ring".into())), &[(0.0, 1.0)], 0.0);
    assert!(window.query_by_label("Lane of Gas in Ring").is_some());
    // It does not fall below 0.
    let lane = lane(&window, "Gas in Ring");
    let key = at(&window, "Gas in Ring", 0.0, 1.0);
    drag(&mut window, &[key, key.lerp(lane.left_bottom(), 0.5), lane.left_bottom() + Vec2::new(0.0, 40.0)]);
    is_near(&pairs(&window, &Drivable::Pressure("ring".into())), &[(0.0, 0.0)], 0.0);
}

#[test]
fn a_drive_that_is_changed_on_the_way_acts_at_once_and_nothing_jumps() {
    let mut window = lanes();
    for _ in 0..12 {
        advance(&mut window);
    }
    let shape = |window: &Window| window.state().published().snapshot.bodies[0].particles.clone();
    let (time, before) = (window.state().published().status.time, shape(&window));
    // Much steeper from here on: the key at 1 s goes to 0.5 s.
    let grabbed = at(&window, "pull, Bar", 1.0, 1.0);
    let aim = at(&window, "pull, Bar", 0.5, 1.0);
    drag(&mut window, &[grabbed, grabbed.lerp(aim, 0.5), aim]);
    until(&mut window, is_settled);
    assert_eq!(window.state().published().status.time, time, "it goes on from the time that it was");
    let most = |a: &[glam::DVec3], b: &[glam::DVec3]| a.iter().zip(b).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max);
    assert_eq!(most(&shape(&window), &before), 0.0, "and from where it was");
    advance(&mut window);
    let step = most(&shape(&window), &before);
    assert!(step < 2e-3, "{step} m in a frame");
    // And it is the new drive that acts: what it comes to differs from what the old one comes to.
    for _ in 0..10 {
        advance(&mut window);
    }
    let length = |points: &[glam::DVec3]| {
        points.iter().map(|x| x.x).fold(f64::NEG_INFINITY, f64::max)
            - points.iter().map(|x| x.x).fold(f64::INFINITY, f64::min)
    };
    let steep = length(&shape(&window));
    let mut other = lanes();
    let frames = (window.state().published().status.time / FRAME).round() as usize;
    for _ in 0..frames {
        advance(&mut other);
    }
    assert!(steep < length(&shape(&other)) - 1e-4, "{steep} {}", length(&shape(&other)));
}

#[test]
fn fibres_show_that_they_act() {
    let mut window = lanes();
    assert!(window.state().published().snapshot.activation.is_none());
    press_key(&mut window, Modifiers::ALT, Key::A);
    for _ in 0..6 {
        advance(&mut window);
    }
    window.step();
    let shown = window.state().published().snapshot.activation.clone().expect("it was asked for");
    // At 0.1 s, smoothly on the way to 1 at 1 s; contract is 0.3.
    let value = 0.1 * 0.1 * (3.0 - 2.0 * 0.1);
    let [alpha, beta, gamma] = [0, 1, 2].map(|fibre| shown.bodies[0][fibre].clone());
    assert!(alpha.iter().all(|[drive, shorter]| (drive - value).abs() < 1e-9 && (shorter - 0.3 * value).abs() < 1e-9));
    assert!(beta.iter().all(|[drive, shorter]| *drive > 0.0 && (shorter - 0.2 * drive).abs() < 1e-12));
    assert!(gamma.iter().all(|edge| *edge == [0.0, 0.0]));
    assert!(window.query_all_by_label_contains("Activation of fibres from 0").next().is_some());
    // Tension takes its place.
    press_key(&mut window, Modifiers::ALT, Key::F);
    advance(&mut window);
    let snapshot = &window.state().published().snapshot;
    assert!(snapshot.activation.is_none() && snapshot.tension.is_some());
}
