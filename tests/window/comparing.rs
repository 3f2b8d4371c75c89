//! The same scene under several integrators, side by side.

use super::{Window, click, open, scene, until, until_seen};
use egui_kittest::kittest::Queryable;
use sinew::scene::IntegratorKind;

/// A ring that falls onto a floor with the paper's defaults.
const RING: &str = r#"{"version": 1, "room": {"floor": 0}, "two_layer": [{"id": "ring", "shape": {"ring": {}},
    "placement": {"translation": [0, 4, 0]}}]}"#;

fn compare(step: &str) -> Window {
    let mut window = open(scene(RING));
    click(&mut window, "Compare");
    click(&mut window, "Explicit Euler");
    click(&mut window, "Runge-Kutta 4");
    super::editing::set(&mut window, "Step", step);
    click(&mut window, "Start comparison");
    until(&mut window, |app| app.published().compared.len() == 2);
    window
}

#[test]
fn integrators_run_side_by_side_in_step_and_the_scene_comes_back() {
    let mut window = compare("0.001");
    until(&mut window, |app| app.published().compared[0].sample.time > 0.3);
    window.step();
    let published = window.state().published();
    let kinds: Vec<IntegratorKind> = published.compared.iter().map(|run| run.integrator).collect();
    assert_eq!(kinds, [IntegratorKind::ExplicitEuler, IntegratorKind::Rk4]);
    let [euler, rk4] = [&published.compared[0].sample, &published.compared[1].sample];
    assert!((euler.time - rk4.time).abs() < 1e-9);
    assert!(euler.volume.is_some() && rk4.pressure.is_some_and(|pressure| pressure > 0.0));
    // Side by side: further apart than the ring is wide.
    let x = |body: usize| published.snapshot.bodies[body].particles.iter().map(|p| p.x).sum::<f64>() / 20.0;
    assert!(published.snapshot.bodies.len() == 2 && x(1) - x(0) > 4.0);
    for title in ["Energy [J]", "Momentum [kg m/s]", "Volume [m³], area [m²]", "Pressure [Pa]"] {
        assert!(window.query_by_label(title).is_some(), "{title}");
    }
    click(&mut window, "End");
    until(&mut window, |app| app.published().compared.is_empty());
    assert_eq!(window.state().published().snapshot.bodies.len(), 1);
}

#[test]
fn a_step_beyond_the_limit_is_red_with_its_parameter_and_blows_up() {
    let mut window = compare("0.05");
    until(&mut window, |app| app.published().compared.iter().any(|run| run.blew_up_at.is_some()));
    window.step();
    assert!(window.query_all_by_label_contains("is beyond its limit").next().is_some());
    assert!(window.query_all_by_label_contains(" of ring").next().is_some());
    assert!(window.query_all_by_label_contains("Blew up at").next().is_some());
    assert!(window.state().published().snapshot.bodies.iter().flat_map(|b| &b.particles).all(|x| x.is_finite()));
}

#[test]
fn runs_that_all_blew_up_are_not_said_to_lack_gas() {
    let mut window = compare("1");
    until(&mut window, |app| app.published().compared.iter().all(|run| run.blew_up_at.is_some()));
    window.run_steps(3);
    assert!(window.query_all_by_label_contains("encloses gas").next().is_none());
}

#[test]
fn orders_are_measured_and_plotted() {
    let mut window = open(scene(RING));
    click(&mut window, "Compare");
    click(&mut window, "Explicit Euler");
    click(&mut window, "Midpoint");
    click(&mut window, "Measure the orders");
    until_seen(&mut window, |window| window.query_all_by_label_contains("Midpoint: order 2.").next().is_some());
    let euler = window.query_all_by_label_contains("Explicit Euler: order 1.").next().is_some()
        || window.query_all_by_label_contains("Explicit Euler: order 0.9").next().is_some();
    assert!(euler);
}
