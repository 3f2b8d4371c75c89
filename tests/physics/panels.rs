//! Panels that fall or are driven onto a bar.

use crate::common::*;
use glam::DVec3;
use sinew::scene::{Axis, HeightKey, Motion, Panel, PanelMotion, Side};

fn panel(motion: PanelMotion, mass: f64, height: f64) -> Panel {
    Panel { motion, mass, ..Panel::falling("panel", height, [0.1, 0.1]) }
}

fn state_of(runner: &sinew::sim::Runner) -> &sinew::solver::ParticleState {
    runner.world().bodies()[0].state()
}

#[test]
fn a_falling_panel_and_the_bar_exchange_momentum_equally() {
    let mut bar = short_bar(2e5);
    bar.initial.velocity = [0.0, 1.0, 0.0];
    let mut scene = in_space(bar);
    scene.panels = vec![panel(PanelMotion::Falls, 0.5, 0.0725)];
    let mut runner = runner(&scene);
    let before = state_of(&runner).linear_momentum();
    for _ in 0..6 {
        runner.advance_frame();
    }
    let panel = &runner.world().panels()[0];
    let after = state_of(&runner).linear_momentum() + DVec3::new(0.0, 0.5 * panel.velocity, 0.0);
    assert!(panel.velocity > 0.1, "the bar pushed it: {}", panel.velocity);
    assert!((after.y - before.y).abs() < 1e-12, "{after} {before}");
}

#[test]
fn a_bar_that_bounces_off_a_panel_and_the_panel_keep_their_energy_together() {
    let mut bar = short_bar(2e5);
    bar.initial.velocity = [0.0, 1.0, 0.0];
    let mut scene = in_space(bar);
    scene.time.frames_per_second = 2000.0;
    scene.panels = vec![Panel { friction: 0.0, ..panel(PanelMotion::Falls, 0.5, 0.0725) }];
    let mut runner = runner(&scene);
    let (mut start, mut greatest) = (None, 0.0_f64);
    for _ in 0..100 {
        runner.advance_frame();
        let energies = runner.world().bodies()[0].energies(runner.world().time());
        let total = energies.total() + 0.25 * runner.world().panels()[0].velocity.powi(2);
        let start = *start.get_or_insert(total);
        assert!((total / start - 1.0).abs() < 0.01, "{total} J of {start} J at {} s", runner.world().time());
        greatest = greatest.max(energies.contact / start);
    }
    println!("contact held up to {greatest} of the energy");
    assert!(greatest > 0.02, "the contact holds enough to be missed: {greatest}");
}

#[test]
fn a_heavy_panel_comes_to_rest_on_the_bar_with_its_weight() {
    let mut bar = short_bar(2e5);
    bar.material.damping.pair = 300.0;
    bar.material.damping.air = 30.0;
    bar.regions = vec![layers("bottom", Axis::Y, Side::Min, 1)];
    bar.pins = vec![pin("bottom", &ALL, Motion::Fixed)];
    let mut scene = in_space(bar);
    scene.gravity = [0.0, -9.81, 0.0];
    scene.measures = vec![measure("carried", sinew::scene::MeasureKind::reaction_force("bottom", [0.0, -1.0, 0.0]))];
    scene.panels = vec![panel(PanelMotion::Falls, 1.0, 0.074)];
    let mut runner = runner(&scene);
    for _ in 0..300 {
        runner.advance_frame();
    }
    let weight = 9.81 * (1.0 + 588.0 * 4e-4);
    let carried = scalar(&runner, 0);
    println!("{carried} N of {weight} N, panel at {} m", runner.world().panels()[0].height);
    assert!((carried / weight - 1.0).abs() < 0.01, "{carried}");
}

#[test]
fn a_driven_panel_presses_to_its_height() {
    let mut bar = short_bar(2e5);
    bar.material.damping.pair = 300.0;
    let mut scene = in_space(bar);
    scene.gravity = [0.0, -9.81, 0.0];
    scene.room.floor = Some(0.0);
    let keys = vec![HeightKey::new(0.0, 0.08), HeightKey::new(0.3, 0.06)];
    scene.panels = vec![panel(PanelMotion::Driven(keys), 1.0, 0.08)];
    let mut runner = runner(&scene);
    for _ in 0..30 {
        runner.advance_frame();
    }
    assert!((runner.world().panels()[0].height - 0.06).abs() < 1e-12);
    let top = state_of(&runner).positions.iter().map(|x| x.y).fold(f64::NEG_INFINITY, f64::max);
    assert!((0.056..0.060).contains(&top), "{top}");
}

#[test]
fn a_bar_under_a_panel_comes_to_rest_and_shows_no_velocity() {
    let mut bar = short_bar(2e5);
    bar.material.damping.pair = 300.0;
    bar.material.damping.air = 40.0;
    bar.regions = vec![layers("bottom", Axis::Y, Side::Min, 1)];
    bar.pins = vec![pin("bottom", &ALL, Motion::Fixed)];
    let mut scene = in_space(bar);
    scene.gravity = [0.0, -9.81, 0.0];
    scene.panels = vec![panel(PanelMotion::Falls, 0.2, 0.0722)];
    let runner = settle(&scene, 600);
    assert!(state_of(&runner).kinetic_energy() < 1e-12, "{}", state_of(&runner).kinetic_energy());
}

#[test]
fn a_panel_that_falls_beside_the_bar_lies_on_the_floor() {
    let mut scene = in_space(short_bar(2e5));
    scene.gravity = [0.0, -9.81, 0.0];
    scene.room.floor = Some(-0.2);
    scene.bodies[0].placement.translation = [1.0, -0.2, 0.0];
    scene.panels = vec![panel(PanelMotion::Falls, 1.0, 0.0)];
    let mut runner = runner(&scene);
    for _ in 0..30 {
        runner.advance_frame();
    }
    assert_eq!(runner.world().panels()[0].height, -0.2);
}
