//! The simulation runs beside the window and never holds it up.

use super::{Window, click, open, press_key, scene, still, until};
use egui::{Key, Modifiers};
use egui_kittest::kittest::Queryable;
use sinew::scene::TimeStep;
use sinew::test_support::ui::App;

fn time(app: &App) -> f64 {
    app.published().status.time
}

#[test]
fn buttons_play_hold_step_and_reset() {
    let mut window = still();
    click(&mut window, "Reset");
    until(&mut window, |app| time(app) == 0.0);
    click(&mut window, "Step");
    until(&mut window, |app| time(app) > 0.0);
    assert!((time(window.state()) - 1.0 / 60.0).abs() < 1e-9, "one frame");
    click(&mut window, "Play");
    until(&mut window, |app| time(app) > 0.1);
    click(&mut window, "Pause");
    until(&mut window, |app| !app.published().status.playing);
}

/// A frame of this takes a good part of a second: hundreds of steps of some thousand particles.
const SLOW: &str = r#"{"version": 1, "time": {"step": {"manual": {"dt": 1e-6, "substeps_per_frame": 400}}},
    "bodies": [{"id": "block", "shape": {"box": {"size": [0.2, 0.2, 0.2]}},
        "material": {"young_modulus": 1e5, "mass": {"density": 1000}, "support_radius": 0.025}}]}"#;

#[test]
fn frames_keep_coming_while_a_step_takes_long() {
    let mut window = open(scene(SLOW));
    until(&mut window, |app| time(app) > 0.0);
    // From one simulated frame to the next; once more where a busy machine did not let the window have its turn.
    let (mut from, mut frames) = (time(window.state()), 0);
    until(&mut window, |app| {
        if time(app) == from {
            frames += 1;
            return false;
        }
        let kept_coming = frames > 5;
        (from, frames) = (time(app), 0);
        kept_coming
    });
}

#[test]
fn divergence_names_the_parameter_and_the_fix_goes_on() {
    let mut window = open(scene(
        r#"{"version": 1, "time": {"step": {"manual": {"dt": 1e-2, "substeps_per_frame": 2}}}, "bodies": [{
            "id": "cube", "shape": {"box": {"size": [0.04, 0.04, 0.04]}}, "initial": {"velocity": [0, 0, 0],
            "deformation": [[1.1, 0, 0], [0, 1, 0], [0, 0, 1]]},
            "material": {"young_modulus": 1e6, "mass": {"per_particle": 4e-4}, "support_radius": 0.02}}]}"#,
    ));
    until(&mut window, |app| app.published().status.divergence.is_some());
    let said = window.state().published().status.divergence.clone().unwrap_or_default();
    assert!(said.contains("cube") && said.contains("lower /time/step/manual/dt"), "{said}");
    window.step();
    // The last good state is shown.
    assert!(window.state().published().snapshot.bodies[0].particles.iter().all(|x| x.is_finite()));
    click(&mut window, "Step automatically and restart");
    assert!(matches!(window.state().scene().time.step, TimeStep::Automatic(_)));
    until(&mut window, |app| app.published().status.divergence.is_none() && time(app) > 0.05);
}

fn read_out(window: &Window) -> bool {
    window.query_all_by_label_contains("× real time").next().is_some()
}

#[test]
fn the_read_out_tells_the_pace() {
    let mut window = still();
    assert!(!read_out(&window));
    press_key(&mut window, Modifiers::NONE, Key::Space);
    until(&mut window, |app| app.published().status.playing && app.published().status.real_time_factor > 0.0);
    window.step();
    assert!(read_out(&window));
    // What the screen shows, not what the solver does.
    assert!(window.query_all_by_label_contains("pictures/s").next().is_some());
    assert!(window.query_all_by_label_contains("frames/s").next().is_none());
}

#[test]
fn a_scene_without_bodies_says_what_to_do() {
    let mut window = egui_kittest::Harness::builder()
        .with_size(egui::Vec2::new(1280.0, 800.0))
        .build_eframe(|creation| App::new(&creation.egui_ctx, None, scene(r#"{"version": 1}"#)));
    window.run_steps(5);
    assert!(window.query_all_by_label_contains("The scene has no body").next().is_some());
}

#[test]
fn the_result_is_fitted_to_the_whole_fall_whenever_in_it_that_is_done() {
    let mut window = still();
    let [low, high] = window.state().published().placed.expect("a body");
    press_key(&mut window, Modifiers::NONE, Key::Space);
    // On the floor by now, and pressed together.
    until(&mut window, |app| time(app) > 0.2);
    press_key(&mut window, Modifiers::NONE, Key::Home);
    window.run_steps(40);
    let view = super::view(&window, "Result");
    for corner in [low, high, low.with_y(high.y), high.with_y(0.0)] {
        let at = window.state().shown_at(corner).expect("before the eye");
        assert!(view.contains(at), "{corner} is shown at {at:?}, beside {view:?}");
    }
}
