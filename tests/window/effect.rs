//! What the last change does is shown beside the scene as it was, and told.

use super::{Window, click, press_key, still, until};
use egui::{Key, Modifiers};
use egui_kittest::kittest::{NodeT, Queryable};

fn show(window: &mut Window) {
    click(window, "View");
    click(window, "Show the last change");
    until(window, |app| app.published().ghost.is_some() && app.effect().is_some());
}

#[test]
fn a_bar_without_its_fibres_lacks_their_twist_and_that_is_told_at_it() {
    let mut window = still();
    click(&mut window, "View");
    assert!(window.get_by_label("Show the last change").accesskit_node().is_disabled(), "nothing was changed yet");
    press_key(&mut window, Modifiers::NONE, Key::Escape);
    press_key(&mut window, Modifiers::NONE, Key::A);
    press_key(&mut window, Modifiers::NONE, Key::Delete);
    assert!(window.state().scene().bodies[0].fibres.is_empty());
    let scene = window.state().scene().clone();
    show(&mut window);
    until(&mut window, |app| app.effect().is_some_and(|told| told.contains("° of twist")));
    let far = window.state().published().ghost.as_ref().is_some_and(|ghost| !ghost.bodies[0].particles.is_empty());
    assert!(far && *window.state().scene() == scene, "only what is shown is another");
    press_key(&mut window, Modifiers::NONE, Key::Escape);
    until(&mut window, |app| app.effect().is_none() && app.published().ghost.is_none());
    // Another change ends it, too.
    show(&mut window);
    press_key(&mut window, Modifiers::COMMAND, Key::Z);
    assert!(!window.state().scene().bodies[0].fibres.is_empty());
    until(&mut window, |app| app.effect().is_none() && app.published().ghost.is_none());
}
