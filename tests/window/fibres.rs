//! Fibres are chosen, moved, turned, cut and changed by pointer and keys; each is one step that can be taken back.

use super::editing::set;
use super::{Window, button, click, drag, draw, is_settled, press_key, still, until, view};
use egui::{Event, Key, Modifiers, PointerButton, Pos2, Vec2};
use egui_kittest::kittest::{NodeT, Queryable};
use glam::DVec3;
use sinew::edit::fibre_ops::{Sampling, vertices};
use sinew::scene::{Fibre, FibreSource, RestShape};

fn fibre(window: &Window, k: usize) -> Fibre {
    window.state().scene().bodies[0].fibres[k].clone()
}

fn course(fibre: &Fibre) -> Vec<DVec3> {
    let sampling = Sampling { model_diagonal: 0.093_3, spacing: 0.006 };
    vertices(fibre, sampling).expect("a course")
}

fn middle(fibre: &Fibre) -> DVec3 {
    let course = course(fibre);
    course.iter().sum::<DVec3>() / course.len() as f64
}

/// Waits until the simulation has taken up every edit, so that what moves follows the pointer.
fn settle(window: &mut Window) {
    window.step();
    until(window, is_settled);
    window.step();
}

fn choose(window: &mut Window, name: &str) {
    click(window, name);
    settle(window);
}

fn key(window: &mut Window, key: Key) {
    press_key(window, Modifiers::NONE, key);
}

fn type_text(window: &mut Window, text: &str) {
    window.event(Event::Text(text.to_owned()));
    window.step();
}

fn hover(window: &mut Window, at: Pos2) {
    window.event(Event::PointerMoved(at));
    window.step();
}

fn undo(window: &mut Window) {
    press_key(window, Modifiers::COMMAND, Key::Z);
}

fn redo(window: &mut Window) {
    press_key(window, Modifiers::COMMAND.plus(Modifiers::SHIFT), Key::Z);
}

/// A change is one step: undone it is gone, done again it is back, and after another change it cannot be done again.
fn one_step(window: &mut Window, change: impl FnOnce(&mut Window)) {
    let before = window.state().scene().clone();
    change(window);
    settle(window);
    let after = window.state().scene().clone();
    assert!(before != after, "nothing has changed: {:?}", window.state().message());
    undo(window);
    assert!(*window.state().scene() == before, "undo does not give what was there");
    redo(window);
    assert!(*window.state().scene() == after, "redo does not give what was made");
    settle(window);
}

#[test]
fn typed_numbers_move_along_an_axis() {
    let mut window = still();
    choose(&mut window, "Helix 1");
    let before = fibre(&window, 0);
    let at = view(&window, "Front").center();
    hover(&mut window, at);
    one_step(&mut window, |window| {
        key(window, Key::G);
        key(window, Key::Y);
        type_text(window, "-4");
        key(window, Key::Enter);
    });
    let moved = middle(&fibre(&window, 0)) - middle(&before);
    assert!(moved.distance(DVec3::new(0.0, -0.004, 0.0)) < 1e-9, "{moved}");
    assert!(matches!(fibre(&window, 0).source, FibreSource::Strokes(_)), "a move keeps the strokes");
    assert!(window.state().undo_name().is_some_and(|name| name.starts_with("Move")));
}

#[test]
fn escape_puts_everything_back_and_keeps_what_could_be_done_again() {
    let mut window = still();
    choose(&mut window, "Helix 1");
    let at = view(&window, "Front").center();
    hover(&mut window, at);
    key(&mut window, Key::G);
    type_text(&mut window, "3");
    key(&mut window, Key::Enter);
    settle(&mut window);
    let after = window.state().scene().clone();
    undo(&mut window);
    let before = window.state().scene().clone();
    key(&mut window, Key::G);
    hover(&mut window, at + Vec2::new(40.0, 0.0));
    settle(&mut window);
    assert!(*window.state().scene() != before, "the fibre follows the pointer");
    key(&mut window, Key::Escape);
    assert!(*window.state().scene() == before);
    redo(&mut window);
    assert!(*window.state().scene() == after, "a gesture that was given up loses nothing");
}

#[test]
fn an_arrow_of_the_gizmo_moves_along_its_axis_and_the_ring_turns() {
    let mut window = still();
    choose(&mut window, "Helix 1");
    key(&mut window, Key::W);
    let before = fibre(&window, 0);
    let pivot = window.state().shown_middle("Front").expect("the gizmo");
    one_step(&mut window, |window| {
        let from = pivot + Vec2::new(30.0, 0.0);
        let path: Vec<Pos2> = (0..=20).map(|k| from + Vec2::new(k as f32, 0.7 * k as f32)).collect();
        slow_drag(window, &path);
    });
    let moved = middle(&fibre(&window, 0)) - middle(&before);
    assert!(moved.x > 1e-3 && moved.y.abs() < 1e-9 && moved.z.abs() < 1e-9, "{moved}");

    let before = fibre(&window, 0);
    let pivot = window.state().shown_middle("Front").expect("the gizmo");
    one_step(&mut window, |window| {
        // A quarter of the ring, counter-clockwise.
        let at = |k: f32| pivot + 66.0 * Vec2::new((k / 20.0 * 1.57).cos(), -(k / 20.0 * 1.57).sin());
        let path: Vec<Pos2> = (0..=20).map(|k| at(k as f32)).collect();
        slow_drag(window, &path);
    });
    let (old, new) = (course(&before), course(&fibre(&window, 0)));
    let (along_before, along_now) = (old[old.len() - 1] - old[0], new[new.len() - 1] - new[0]);
    let turned = along_before.truncate().angle_to(along_now.truncate()).to_degrees();
    assert!((turned - 90.0).abs() < 6.0, "{turned} degrees");
}

#[test]
fn a_pen_draws_over_the_handles_of_what_is_selected_and_the_select_tool_takes_hold_of_them() {
    let mut window = still();
    choose(&mut window, "Helix 1");
    let tool = |window: &Window, name: &str| {
        let all: Vec<_> = window.query_all_by_label(name).collect();
        assert_eq!(all.len(), 2, "both drawing views show it");
        all.iter().all(|node| node.accesskit_node().toggled() == Some(egui::accesskit::Toggled::True))
    };
    assert!(tool(&window, "Draw") && !tool(&window, "Select"));
    let before = window.state().scene().clone();
    let ring = window.state().shown_middle("Front").expect("it is seen") + Vec2::new(66.0, 0.0);
    let path: Vec<Pos2> = (0..=20).map(|k| ring + Vec2::new(0.0, 3.0 * k as f32)).collect();
    drag(&mut window, &path);
    assert!(*window.state().scene() == before, "nothing is turned");
    assert!(window.state().message().is_some_and(|text| text.contains("other view")), "a stroke was drawn");
    key(&mut window, Key::Escape);

    key(&mut window, Key::W);
    window.step();
    assert!(tool(&window, "Select") && !tool(&window, "Draw"));
    one_step(&mut window, |window| slow_drag(window, &path));
    // Beside the handles it selects by a box, and draws nothing.
    let (count, front) = (window.state().scene().bodies[0].fibres.len(), view(&window, "Front"));
    drag(&mut window, &[front.left_top() + Vec2::splat(40.0), front.center(), front.right_bottom() - Vec2::splat(4.0)]);
    assert_eq!(window.state().selected_names().len(), 4);
    assert_eq!(window.state().scene().bodies[0].fibres.len(), count);
}

/// A drag in which every sample is a frame, so that the simulation can take up what the first ones ask.
fn slow_drag(window: &mut Window, path: &[Pos2]) {
    hover(window, path[0]);
    window.step();
    button(window, path[0], PointerButton::Primary, true);
    window.step();
    for &at in &path[1..] {
        hover(window, at);
        settle(window);
    }
    button(window, path[path.len() - 1], PointerButton::Primary, false);
    window.step();
    window.step();
}

#[test]
fn clicks_and_boxes_choose_fibres_in_a_view() {
    let mut window = still();
    let front = view(&window, "Front");
    for at in [front.center_top() + Vec2::new(0.0, 60.0), front.center()] {
        hover(&mut window, at);
    }
    let seen = window.state().shown_course("Front", "Helix 1").expect("it is seen");
    let at = seen[seen.len() / 4];
    hover(&mut window, at);
    button(&window, at, PointerButton::Primary, true);
    window.step();
    button(&window, at, PointerButton::Primary, false);
    window.step();
    assert_eq!(window.state().selected_names().len(), 1, "{:?}", window.state().selected_names());
    key(&mut window, Key::B);
    drag(&mut window, &[front.left_top() + Vec2::splat(40.0), front.center(), front.right_bottom() - Vec2::splat(4.0)]);
    assert_eq!(window.state().selected_names().len(), 4);
    assert!(window.state().scene().bodies[0].fibres.len() == 4, "a box draws no stroke");
    key(&mut window, Key::A);
    assert_eq!(window.state().selected_names().len(), 4);
}

#[test]
fn vertices_are_moved_inserted_deleted_and_cut() {
    let mut window = still();
    choose(&mut window, "Helix 2");
    key(&mut window, Key::Tab);
    let before = course(&fibre(&window, 1));
    let marks = window.state().shown_vertices("Front");
    assert_eq!(marks.len(), before.len());
    one_step(&mut window, |window| {
        let from = marks[3];
        let path: Vec<Pos2> = (0..=10).map(|k| from + Vec2::new(2.0 * k as f32, 0.0)).collect();
        slow_drag(window, &path);
    });
    let now = course(&fibre(&window, 1));
    let moved: Vec<f64> = now.iter().zip(&before).map(|(a, b)| a.distance(*b)).collect();
    assert!(moved[3] > 1e-3, "{moved:?}");
    assert!(moved.iter().enumerate().all(|(k, by)| k == 3 || *by < 1e-9), "only that vertex: {moved:?}");

    one_step(&mut window, |window| key(window, Key::X));
    assert_eq!(course(&fibre(&window, 1)).len(), before.len() - 1);

    key(&mut window, Key::A);
    one_step(&mut window, |window| key(window, Key::I));
    assert_eq!(course(&fibre(&window, 1)).len(), 2 * (before.len() - 1) - 1);

    let marks = window.state().shown_vertices("Front");
    let at = marks[marks.len() / 2];
    hover(&mut window, at);
    button(&window, at, PointerButton::Primary, true);
    window.step();
    button(&window, at, PointerButton::Primary, false);
    window.step();
    one_step(&mut window, |window| key(window, Key::K));
    let fibres = &window.state().scene().bodies[0].fibres;
    assert_eq!(fibres.len(), 5);
    let (first, second) = (course(&fibres[1]), course(&fibres[4]));
    assert!(first[first.len() - 1].distance(second[0]) < 1e-12, "they meet where they were cut");
}

#[test]
fn several_fibres_are_changed_at_once() {
    let mut window = still();
    choose(&mut window, "Helix 1");
    key(&mut window, Key::A);
    window.step();
    one_step(&mut window, |window| set(window, "Volume fraction", "0.25"));
    assert!(window.state().scene().bodies[0].fibres.iter().all(|fibre| fibre.volume_fraction == 0.25));
    let stiffness: Vec<_> = window.state().scene().bodies[0].fibres.iter().map(|f| f.stiffness.clone()).collect();
    one_step(&mut window, |window| click(window, "Straight"));
    for (fibre, stiffness) in window.state().scene().bodies[0].fibres.iter().zip(stiffness) {
        assert_eq!(fibre.rest_shape, RestShape::Straight);
        assert_eq!(fibre.stiffness, stiffness, "what was not changed stays");
    }
    one_step(&mut window, |window| {
        click(window, "Fibre");
        click(window, "Mirror along X");
    });
    assert_eq!(window.state().selected_names().len(), 4);
    one_step(&mut window, |window| key(window, Key::H));
    assert!(window.state().scene().bodies[0].fibres.iter().all(|fibre| fibre.hidden));
    one_step(&mut window, |window| press_key(window, Modifiers::ALT, Key::H));
}

#[test]
fn mirrored_copies_are_one_step_and_lie_on_the_other_side() {
    let mut window = still();
    for (axis, entry) in ["Mirrored copy along X", "Mirrored copy along Y", "Mirrored copy along Z"].iter().enumerate()
    {
        choose(&mut window, "Helix 1");
        key(&mut window, Key::A);
        window.step();
        let before: Vec<Vec<DVec3>> = window.state().scene().bodies[0].fibres.iter().map(course).collect();
        one_step(&mut window, |window| {
            click(window, "Fibre");
            click(window, entry);
        });
        let fibres = window.state().scene().bodies[0].fibres.clone();
        assert_eq!(fibres.len(), 8);
        // In the middle of the bar.
        let middle = DVec3::new(0.0, 0.036, 0.0);
        for (of, copy) in before.iter().zip(fibres[4..].iter().map(course)) {
            for (a, b) in of.iter().zip(&copy) {
                let mut mirrored = *a - middle;
                mirrored[axis] = -mirrored[axis];
                assert!(b.distance(middle + mirrored) < 1e-6, "{entry}: {a} became {b}");
            }
        }
        undo(&mut window);
    }
}

#[test]
fn a_copy_follows_the_pointer_and_names_can_be_changed() {
    let mut window = still();
    choose(&mut window, "Helix 3");
    let at = view(&window, "Front").center();
    hover(&mut window, at);
    press_key(&mut window, Modifiers::SHIFT, Key::D);
    assert_eq!(window.state().scene().bodies[0].fibres.len(), 5);
    type_text(&mut window, "2");
    key(&mut window, Key::X);
    key(&mut window, Key::Enter);
    settle(&mut window);
    let moved = middle(&fibre(&window, 4)) - middle(&fibre(&window, 2));
    assert!(moved.distance(DVec3::new(0.002, 0.0, 0.0)) < 1e-9, "{moved}");
    undo(&mut window);
    assert_eq!(window.state().scene().bodies[0].fibres.len(), 4, "to copy and to move is one step");
    redo(&mut window);
    settle(&mut window);
    assert!((middle(&fibre(&window, 4)) - middle(&fibre(&window, 2))).distance(moved) < 1e-12);

    // Given up, it goes again; kept where it is, it is put beside what it is a copy of.
    choose(&mut window, "Helix 3");
    press_key(&mut window, Modifiers::SHIFT, Key::D);
    key(&mut window, Key::Escape);
    assert_eq!(window.state().scene().bodies[0].fibres.len(), 5);
    one_step(&mut window, |window| {
        press_key(window, Modifiers::SHIFT, Key::D);
        key(window, Key::Enter);
    });
    let apart = middle(&fibre(&window, 5)) - middle(&fibre(&window, 2));
    assert!(apart.length() > 1e-3, "{apart}");

    let label = window.get_by_label("Helix 1").rect().center();
    for _ in 0..2 {
        button(&window, label, PointerButton::Primary, true);
        window.step();
        button(&window, label, PointerButton::Primary, false);
        window.step();
    }
    window.step();
    press_key(&mut window, Modifiers::COMMAND, Key::A);
    one_step(&mut window, |window| {
        type_text(window, "Left helix");
        key(window, Key::Enter);
    });
    assert_eq!(fibre(&window, 0).name, "Left helix");
}

#[test]
fn one_stroke_is_drawn_again_and_the_other_kept() {
    let mut window = still();
    draw(&mut window, "Front", |t| [0.0, 0.8 * t - 0.4]);
    draw(&mut window, "Side", |t| [0.0, 0.8 * t - 0.4]);
    settle(&mut window);
    let FibreSource::Strokes(before) = fibre(&window, 4).source else { panic!("strokes") };
    one_step(&mut window, |window| {
        key(window, Key::D);
        draw(window, "Side", |t| [0.1 * (6.0 * t).sin(), 0.8 * t - 0.4]);
    });
    let FibreSource::Strokes(after) = fibre(&window, 4).source else { panic!("strokes") };
    assert_eq!(after.first.points, before.first.points);
    assert!(after.second.points != before.second.points);
    assert_eq!(window.state().scene().bodies[0].fibres.len(), 5, "no fibre is added");
}

#[test]
fn a_brush_paints_the_body_where_it_is_dragged_and_the_paint_can_be_cleared() {
    let mut window = still();
    key(&mut window, Key::V);
    window.step();
    // The body may have left the view since that was fitted; and the views come to rest first.
    key(&mut window, Key::Home);
    window.run_steps(40);
    let particles = &window.state().published().snapshot.bodies[0].particles;
    let middle = particles.iter().sum::<DVec3>() / particles.len() as f64;
    let middle = window.state().shown_at(middle).expect("the body is in sight");
    let before = window.state().scene().clone();
    let path: Vec<Pos2> = (0..=30).map(|k| middle + Vec2::new(0.0, k as f32 - 15.0)).collect();
    one_step(&mut window, |window| drag(window, &path));
    let paint = &window.state().scene().bodies[0].paint;
    assert!(!paint.is_empty() && paint.iter().all(|dab| dab.value == 1.0), "{paint:?}");
    let skin = &window.state().published().at_rest.bodies[0].skin;
    let (low, high) = (skin.iter().copied().reduce(DVec3::min), skin.iter().copied().reduce(DVec3::max));
    let (low, high) = (low.expect("a skin"), high.expect("a skin"));
    for dab in paint {
        let at = DVec3::from_array(dab.center);
        let beyond = (low - at).max(at - high).max_element();
        assert!(beyond.abs() < 2e-3, "the dab at {at} lies {beyond} m off the surface");
    }
    assert!(before.bodies[0].fibres == window.state().scene().bodies[0].fibres);
    one_step(&mut window, |window| click(window, "Clear paint"));
    assert!(window.state().scene().bodies[0].paint.is_empty());
    key(&mut window, Key::Escape);
    window.step();
    let start = window.state().scene().clone();
    drag(&mut window, &path);
    assert!(*window.state().scene() == start, "without the brush a drag pulls");
}
