//! Every command stands in the palette, the help and the menus, and its key does it.

use super::{Window, click, press_key, still, until};
use egui::{Key, Modifiers};
use egui_kittest::kittest::Queryable;
use sinew::test_support::ui::{Action, Menu};

fn listed(window: &Window, action: Action) -> bool {
    window.query_all_by_label_contains(action.name().trim_end_matches('…')).next().is_some()
}

#[test]
fn the_palette_lists_every_command_and_does_the_one_that_is_typed() {
    let mut window = still();
    press_key(&mut window, Modifiers::COMMAND, Key::P);
    window.step();
    for action in Action::ALL {
        assert!(listed(&window, action), "{action:?}");
    }
    window.event(egui::Event::Text("advance one".to_owned()));
    window.step();
    assert!(!listed(&window, Action::Save), "what does not match goes away");
    let time = window.state().published().status.time;
    press_key(&mut window, Modifiers::NONE, Key::Enter);
    until(&mut window, |app| app.published().status.time > time);
    assert!(!listed(&window, Action::ReleasePins), "the palette has closed");
}

#[test]
fn the_help_lists_every_command_with_its_keys() {
    let mut window = still();
    press_key(&mut window, Modifiers::NONE, Key::F1);
    window.step();
    for action in Action::ALL {
        assert!(listed(&window, action), "{action:?}");
    }
    assert!(window.query_all_by_label_contains("Ctrl+Shift+S").next().is_some());
    press_key(&mut window, Modifiers::NONE, Key::Escape);
    window.step();
    assert!(!listed(&window, Action::ReleasePins));
}

#[test]
fn every_command_stands_in_its_menu() {
    for menu in Menu::ALL {
        let mut window = still();
        click(&mut window, menu.title());
        for action in Action::ALL.into_iter().filter(|action| action.menu() == menu) {
            assert!(listed(&window, action), "{action:?} in {menu:?}");
        }
    }
}

#[test]
fn no_two_commands_share_a_key() {
    let keys: Vec<_> = Action::ALL.iter().flat_map(|action| action.shortcuts()).collect();
    for (k, key) in keys.iter().enumerate() {
        assert!(!keys[..k].contains(key), "{key:?}");
    }
}

#[test]
fn keys_do_nothing_behind_what_stands_in_front() {
    let mut window = still();
    press_key(&mut window, Modifiers::NONE, Key::A);
    let before = window.state().scene().clone();
    for (modifiers, key) in [(Modifiers::NONE, Key::F1), (Modifiers::COMMAND, Key::E)] {
        press_key(&mut window, modifiers, key);
        window.run_steps(5);
        for key in [Key::X, Key::Delete, Key::Space, Key::Tab] {
            press_key(&mut window, Modifiers::NONE, key);
        }
        assert_eq!(*window.state().scene(), before);
        assert!(!window.state().published().status.playing);
        press_key(&mut window, Modifiers::NONE, Key::Escape);
        window.run_steps(3);
    }
    press_key(&mut window, Modifiers::NONE, Key::X);
    assert!(*window.state().scene() != before, "once that is closed, keys act again");
}

#[test]
fn typing_in_the_palette_is_no_shortcut() {
    let mut window = still();
    let fibres = window.state().scene().bodies[0].fibres.len();
    press_key(&mut window, Modifiers::COMMAND, Key::P);
    window.step();
    press_key(&mut window, Modifiers::NONE, Key::X);
    press_key(&mut window, Modifiers::NONE, Key::Space);
    press_key(&mut window, Modifiers::SHIFT, Key::D);
    window.step();
    assert_eq!(window.state().scene().bodies[0].fibres.len(), fibres);
    assert!(!window.state().published().status.playing);
}

#[test]
fn a_key_that_can_do_nothing_says_why() {
    let mut window = still();
    let cases = [
        (Modifiers::NONE, Key::X, "Delete: Select a fibre, a sheet, a pin or a body first"),
        (Modifiers::COMMAND, Key::Z, "Undo: There is nothing to undo"),
        (Modifiers::SHIFT, Key::ArrowRight, "Live: The present is shown already"),
    ];
    for (modifiers, key, expected) in cases {
        press_key(&mut window, modifiers, key);
        assert_eq!(window.state().message(), Some(expected));
    }
}
