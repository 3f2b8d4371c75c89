//! Colours that stand for values, and what runs in step beside the document.

use super::{Window, click, press_key, scene, still, until};
use egui::{Key, Modifiers};
use egui_kittest::kittest::Queryable;
use sinew::sim::Published;
use sinew::solver::snapshot::FieldKind;

fn legend(window: &Window, text: &str) -> bool {
    window.query_all_by_label_contains(text).next().is_some()
}

#[test]
fn a_colour_map_has_a_legend_with_its_range() {
    let mut window = still();
    assert!(!legend(&window, " from 0 to "));
    assert!(window.state().published().snapshot.field.is_none(), "nothing is worked out that nobody asked for");
    click(&mut window, "No colours");
    click(&mut window, "Stress");
    until(&mut window, |app| app.published().snapshot.field.is_some());
    window.step();
    assert!(legend(&window, "Stress [Pa] from 0 to "));
    // The key goes on from there.
    for (kind, text) in
        [(FieldKind::VolumeFraction, "Volume fraction from 0 to 0."), (FieldKind::Speed, "Speed [m/s] from 0")]
    {
        press_key(&mut window, Modifiers::ALT, Key::C);
        until(&mut window, |app| app.published().snapshot.field.as_ref().is_some_and(|field| field.kind == kind));
        window.step();
        assert!(legend(&window, text), "{text}");
    }
    press_key(&mut window, Modifiers::ALT, Key::C);
    until(&mut window, |app| app.published().snapshot.field.is_none());
    window.step();
    assert!(!legend(&window, " from 0 to "));
}

fn ghost(published: &Published) -> Option<usize> {
    published.ghost.as_ref().map(|ghost| ghost.bodies[0].fibres.len())
}

#[test]
fn the_ghost_has_no_fibres_or_those_of_before() {
    let mut window = still();
    let count = window.state().scene().bodies[0].fibres.len();
    assert!(count > 0);
    press_key(&mut window, Modifiers::ALT, Key::O);
    until(&mut window, |app| ghost(app.published()) == Some(0));
    click(&mut window, "Without fibres");
    click(&mut window, "Before the last edit");
    until(&mut window, |app| ghost(app.published()).is_none());
    // With the first edit there is something that was before it.
    press_key(&mut window, Modifiers::NONE, Key::A);
    press_key(&mut window, Modifiers::NONE, Key::Delete);
    let left = window.state().scene().bodies[0].fibres.len();
    assert!(left < count, "something was deleted");
    until(&mut window, |app| {
        ghost(app.published()) == Some(count) && app.published().snapshot.bodies[0].fibres.len() == left
    });
}

#[test]
fn what_moves_faster_widens_the_range() {
    let mut window = super::open(scene(
        r#"{"version": 1, "room": {"floor": null}, "bodies": [{"id": "cube", "shape": {"box": {"size": [0.04, 0.04, 0.04]}},
            "material": {"young_modulus": 1e5, "mass": {"density": 1000}, "support_radius": 0.02}}]}"#,
    ));
    for _ in 0..4 {
        press_key(&mut window, Modifiers::ALT, Key::C);
    }
    until(&mut window, |app| app.published().status.time > 0.3 && app.published().snapshot.field.is_some());
    let field = window.state().published().snapshot.field.clone().expect("a field");
    let speed = 9.81 * window.state().published().status.time;
    assert!((field.range[1] / speed - 1.0).abs() < 0.01, "{:?} {speed}", field.range);
}
