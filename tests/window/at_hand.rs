//! What lies in a view is at hand there: pins, menus, the clipboard; and numbers are taken as people write them.

use super::editing::set;
use super::pulling::{CUBE, move_to, press};
use super::{Window, button, click, click_on, is_settled, open, press_key, scene, still, until, view};
use egui::accesskit::Role;
use egui::{Event, Key, Modifiers, OutputCommand, PointerButton, Pos2, Vec2};
use egui_kittest::kittest::Queryable;
use sinew::ui::Document;

fn key(window: &mut Window, key: Key) {
    press_key(window, Modifiers::NONE, key);
}

fn click_at(window: &mut Window, at: Pos2, of: PointerButton) {
    button(window, at, of, true);
    window.step();
    button(window, at, of, false);
    window.run_steps(3);
}

/// Where a fibre is seen in a drawing view.
fn on_fibre(window: &Window, name: &str) -> Pos2 {
    let seen = window.state().shown_course("Front", name).expect("it is seen");
    seen[seen.len() / 4]
}

#[test]
fn a_regions_pin_is_seen_in_every_view_and_removed_where_it_is() {
    let mut window = still();
    click(&mut window, "World");
    click_on(&mut window, Role::ComboBox, "Pin a region");
    click(&mut window, "top");
    until(&mut window, is_settled);
    window.step();
    let before = window.state().scene().clone();
    let pins: Vec<Pos2> = window.query_all_by_label("Pin of \"top\"").map(|pin| pin.rect().center()).collect();
    assert_eq!(pins.len(), 3, "in each view one");
    let result = view(&window, "Result");
    let at = pins.into_iter().find(|at| result.contains(*at)).expect("one in the result");
    click_at(&mut window, at, PointerButton::Primary);
    key(&mut window, Key::X);
    until(&mut window, is_settled);
    window.step();
    assert!(window.state().scene().bodies[0].pins.is_empty());
    assert!(window.query_by_label("Pin of \"top\"").is_none());
    press_key(&mut window, Modifiers::COMMAND, Key::Z);
    assert!(*window.state().scene() == before);
}

#[test]
fn a_point_that_p_has_pinned_is_seen_and_removed_where_it_is() {
    let mut window = open(scene(CUBE));
    let rect = view(&window, "Result");
    let (from, to) = (rect.center(), rect.center() + Vec2::new(0.0, -80.0));
    press(&mut window, from);
    move_to(&mut window, from, to);
    key(&mut window, Key::P);
    button(&window, to, PointerButton::Primary, false);
    window.step();
    until(&mut window, |app| app.published().pinned.len() == 1);
    super::hold(&mut window);
    window.step();
    let pin = window.get_by_label("Pinned point 1").rect().center();
    click_at(&mut window, pin, PointerButton::Secondary);
    click(&mut window, "Remove pin");
    until(&mut window, |app| app.published().pinned.is_empty());
    window.step();
    assert!(window.query_by_label("Pinned point 1").is_none());
}

#[test]
fn a_right_click_opens_the_menu_of_what_lies_there_and_a_right_drag_does_not() {
    let mut window = still();
    let at = on_fibre(&window, "Helix 1");
    click_at(&mut window, at, PointerButton::Secondary);
    assert_eq!(window.state().selected_names().len(), 1, "what lies there is chosen");
    click(&mut window, "Hide H");
    assert!(window.state().scene().bodies[0].fibres[0].hidden);
    assert!(window.query_by_label("Snap to surface").is_none(), "the menu has closed");
    // A drag pulls, and a click that gives a gesture up opens nothing.
    let (from, to) = (view(&window, "Result").center(), view(&window, "Result").center() + Vec2::new(60.0, 0.0));
    button(&window, from, PointerButton::Secondary, true);
    move_to(&mut window, from, to);
    assert!(window.state().grabbed().is_some());
    button(&window, to, PointerButton::Secondary, false);
    window.run_steps(3);
    assert!(window.query_by_label("Follow the body").is_none() && window.state().grabbed().is_none());
    click(&mut window, "Helix 2");
    let at = view(&window, "Front").center();
    window.event(Event::PointerMoved(at));
    window.step();
    let before = window.state().scene().clone();
    key(&mut window, Key::G);
    window.event(Event::PointerMoved(at + Vec2::splat(20.0)));
    window.run_steps(2);
    click_at(&mut window, at + Vec2::splat(20.0), PointerButton::Secondary);
    assert!(*window.state().scene() == before && window.query_by_label("Snap to surface").is_none());
}

#[test]
fn fibres_are_copied_within_and_between_scenes_as_text() {
    let mut window = still();
    click(&mut window, "Helix 1");
    window.event(Event::Copy);
    window.step();
    let copied = window.output().platform_output.commands.iter().find_map(|command| match command {
        OutputCommand::CopyText(text) => Some(text.clone()),
        _ => None,
    });
    let text = copied.expect("it is on the clipboard");
    window.event(Event::Paste(text.clone()));
    window.run_steps(2);
    let fibres = window.state().scene().bodies[0].fibres.clone();
    assert_eq!(fibres.len(), 5);
    assert_eq!(window.state().selected_names(), [fibres[4].id.clone()]);
    assert_ne!(fibres[4].source, fibres[0].source, "it lies beside what it is a copy of");

    let mut other = open(scene(CUBE));
    other.event(Event::Paste(text));
    other.run_steps(2);
    assert_eq!(other.state().scene().bodies[0].fibres.len(), 1, "{:?}", other.state().message());
    until(&mut other, |app| is_settled(app) && app.published().at_rest.bodies[0].fibres.len() == 1);
    other.event(Event::Paste("no fibres".to_owned()));
    other.run_steps(2);
    assert!(other.state().message().is_some_and(|text| text.contains("holds no fibres")));
    // Ctrl+A and Ctrl+X are for all of them.
    let mut window = open(Document::load(None).expect("the built-in scene"));
    press_key(&mut window, Modifiers::COMMAND, Key::A);
    assert_eq!(window.state().selected_names().len(), 4);
    window.event(Event::Cut);
    window.run_steps(2);
    assert!(window.state().scene().bodies[0].fibres.is_empty());
}

#[test]
fn fields_and_moves_take_arithmetic_and_units() {
    let mut window = still();
    set(&mut window, "Support radius", "2*1cm");
    assert!((window.state().scene().bodies[0].material.support_radius - 0.02).abs() < 1e-15);
    set(&mut window, "Young's modulus", "120 kPa");
    assert_eq!(window.state().scene().bodies[0].material.young_modulus, 1.2e5);
    let before = window.state().scene().clone();
    set(&mut window, "Young's modulus", "3 cm");
    assert_eq!(*window.state().scene(), before, "a length is no modulus");
    // And what is typed belongs to the field.
    click_on(&mut window, Role::SpinButton, "Young's modulus");
    press_key(&mut window, Modifiers::COMMAND, Key::A);
    assert!(window.state().selected_names().is_empty());
}

#[test]
fn a_material_is_chosen_by_its_name() {
    let mut window = still();
    let before = window.state().scene().bodies[0].material.clone();
    click_on(&mut window, Role::ComboBox, "Like");
    click(&mut window, "Jelly");
    let material = window.state().scene().bodies[0].material.clone();
    assert!(material.young_modulus < before.young_modulus && material.spacing() == before.spacing());
    until(&mut window, is_settled);
    assert!(window.state().published().status.failure.is_none());
    press_key(&mut window, Modifiers::COMMAND, Key::Z);
    assert_eq!(window.state().scene().bodies[0].material, before);
}
