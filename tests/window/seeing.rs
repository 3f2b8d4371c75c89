//! Colours that stand for values, and what runs in step beside the document.

use super::{Window, click, press_key, scene, still, until};
use egui::{Key, Modifiers};
use egui_kittest::kittest::Queryable;
use sinew::sim::Published;
use sinew::solver::FieldKind;
use sinew::test_support::ui::App;

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
    let is_speed =
        |app: &App| app.published().snapshot.field.as_ref().is_some_and(|field| field.kind == FieldKind::Speed);
    until(&mut window, |app| app.published().status.time > 0.3 && is_speed(app));
    let field = window.state().published().snapshot.field.clone().expect("a field");
    let speed = 9.81 * window.state().published().status.time;
    assert!((field.range[1] / speed - 1.0).abs() < 0.01, "{:?} {speed}", field.range);
}

#[test]
fn fibres_are_coloured_by_tension_with_a_legend_in_newtons() {
    let mut window = still();
    press_key(&mut window, Modifiers::ALT, Key::Z);
    assert!(!legend(&window, "Tension of fibres"));
    press_key(&mut window, Modifiers::ALT, Key::F);
    until(&mut window, |app| app.published().snapshot.tension.is_some());
    window.step();
    let range = window.state().published().snapshot.tension.as_ref().map(|tension| tension.range);
    assert!(range.is_some_and(|range| range > 0.0));
    assert!(legend(&window, "Tension of fibres [N] from -"));
    // Under a field's legend, where there is one.
    press_key(&mut window, Modifiers::ALT, Key::C);
    until(&mut window, |app| app.published().snapshot.field.is_some());
    window.step();
    let top = |text: &str| window.get_by_label_contains(text).rect().top();
    assert!(top("Tension of fibres [N] from") > top("Strain from"));
    press_key(&mut window, Modifiers::ALT, Key::F);
    until(&mut window, |app| app.published().snapshot.tension.is_none());
}

#[test]
fn the_solid_is_cut_open_and_what_is_gone_is_not_pulled() {
    let mut window = still();
    let bodies = &window.state().published().snapshot.bodies;
    let middle = bodies[0].particles.iter().sum::<glam::DVec3>() / bodies[0].particles.len() as f64;
    let pulled = |window: &mut Window| {
        let at = window.state().shown_at(middle).expect("before the eye");
        super::pulling::press(window, at);
        super::pulling::move_to(window, at, at + egui::vec2(12.0, 0.0));
        let pulled = window.state().grabbed();
        super::button(window, at, egui::PointerButton::Primary, false);
        window.step();
        window.step();
        pulled.map(|(_, vertex, _)| window.state().published().snapshot.bodies[0].surface()[vertex])
    };
    let before = pulled(&mut window).expect("the skin before the eye");
    assert!(before.z > middle.z + 0.01, "{before} {middle}");
    click(&mut window, "No cut");
    click(&mut window, "Cut across Z");
    let behind = pulled(&mut window).expect("the far side from within");
    assert!(behind.z < middle.z - 0.01, "{behind} {middle}");
    click(&mut window, "Flip");
    assert!(pulled(&mut window).is_some_and(|point| point.z > middle.z + 0.01), "the front is what is left");
    press_key(&mut window, Modifiers::ALT, Key::X);
    assert!(pulled(&mut window).is_some_and(|point| point.z > middle.z + 0.01));
}

#[test]
fn a_break_is_said_with_its_time_and_a_reset_takes_it_back() {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes/figure_10_soft.json");
    let mut window = super::open(sinew::ui::Document::load(Some(path)).expect("the scene"));
    let breaks = |app: &App| -> Vec<f64> {
        app.published().snapshot.bodies.iter().flat_map(|body| body.breaks.iter().map(|at| at.time)).collect()
    };
    until(&mut window, |app| !breaks(app).is_empty());
    let said = window.state().message().unwrap_or_default().to_owned();
    let last = breaks(window.state()).into_iter().fold(0.0, f64::max);
    assert!(said.starts_with("Fibre ") && said.contains(&format!(" broke at {last:.3} s")), "{said}");
    press_key(&mut window, Modifiers::NONE, Key::Space);
    press_key(&mut window, Modifiers::COMMAND, Key::R);
    until(&mut window, |app| breaks(app).is_empty());
    assert!(window.state().message().is_none_or(|text| !text.contains("broke")), "{:?}", window.state().message());
}

#[test]
fn a_tear_is_said_with_its_time_and_marked_on_the_timeline() {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes/seam_tear.json");
    let mut window = super::open(sinew::ui::Document::load(Some(path)).expect("the scene"));
    let first = |app: &App| app.published().snapshot.bodies.iter().filter_map(|body| body.first_tear).reduce(f64::min);
    until(&mut window, |app| first(app).is_some());
    let app = window.state();
    let (time, said) = (first(app).expect("a tear"), app.message().unwrap_or_default().to_owned());
    assert!(said.ends_with(&format!(" began to tear at {time:.3} s")), "{said}");
    let marks = app.published().status.recording.breaks.clone();
    assert!(marks.first().is_some_and(|mark| *mark >= time && mark - time < 0.05), "{marks:?}, torn at {time} s");
    press_key(&mut window, Modifiers::NONE, Key::Space);
    press_key(&mut window, Modifiers::COMMAND, Key::R);
    until(&mut window, |app| first(app).is_none());
    assert!(window.state().message().is_none_or(|text| !text.contains("tear")), "{:?}", window.state().message());
}
