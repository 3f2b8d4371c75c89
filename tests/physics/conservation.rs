//! Momenta and energy of bodies in free flight.

use crate::common::*;
use glam::DVec3;
use sinew::scene::{Body, BoxShape, CapsuleShape, IntegratorKind, Material, RestShape, Rotation, Scene, Shape};

/// The short bar stretched by 10 % and sheared, flying and spinning.
fn deformed() -> Scene {
    let mut bar = short_bar(5e7);
    bar.initial.deformation = [[0.97, 0.05, 0.0], [0.0, 1.1, 0.02], [0.03, 0.0, 0.96]];
    bar.initial.velocity = [1.0, 2.0, -0.5];
    bar.initial.angular_velocity = [300.0, 500.0, -200.0];
    in_space(bar)
}

/// Bodies of which particles at the surface stand for parts of cells: a box askew to its lattice, and a capsule.
pub fn weighted(young_modulus: f64) -> [Body; 2] {
    let askew = BoxShape {
        lattice_rotation: Rotation::about([1.0, 2.0, 0.5], 28.0),
        ..BoxShape::new([4.3 * D, 6.6 * D, 3.6 * D])
    };
    let shapes: [Shape; 2] = [askew.into(), CapsuleShape::new(2.1 * D, 4.0 * D).into()];
    shapes.map(|shape| {
        let material = Material::new(young_modulus, 0.33, 1000.0).with_support_radius(H);
        Body::new("block", shape).with_name("Block").with_material(material)
    })
}

fn drift(scene: &Scene, seconds: f64) -> (f64, f64) {
    let mut runner = runner(scene);
    let state = runner.world().bodies()[0].state();
    let (p0, l0) = (state.linear_momentum(), state.angular_momentum());
    let frames = runner.frames_for(seconds);
    let (mut p_sum, mut l_sum): (f64, f64) = (0.0, 0.0);
    for _ in 0..frames {
        runner.advance_frame();
        let state = runner.world().bodies()[0].state();
        let each = |f: &dyn Fn(usize) -> DVec3| (0..state.len()).map(|i| f(i).length()).sum::<f64>();
        p_sum = p_sum.max(each(&|i| state.masses[i] * state.velocities[i]));
        l_sum = l_sum.max(each(&|i| state.masses[i] * state.positions[i].cross(state.velocities[i])));
    }
    let state = runner.world().bodies()[0].state();
    ((state.linear_momentum() - p0).length() / p_sum, (state.angular_momentum() - l0).length() / l_sum)
}

#[test]
fn free_flight_keeps_momenta() {
    let (linear, angular) = drift(&deformed(), 0.1);
    println!("linear {linear:e}, angular {angular:e}");
    assert!(linear < 1e-13, "{linear:e}");
    assert!(angular < 1e-12, "{angular:e}");
}

#[test]
fn particles_that_stand_for_parts_of_cells_keep_momenta() {
    for mut body in weighted(5e7) {
        body.material.damping.pair = 500.0;
        body.initial = deformed().bodies[0].initial.clone();
        let shape = body.shape.clone();
        let scene = in_space(body);
        let masses = &runner(&scene).world().bodies()[0].state().masses.clone();
        let least_and_most = [f64::min, f64::max].map(|of| masses.iter().copied().reduce(of).expect("particles"));
        assert!(least_and_most[1] > 1.2 * least_and_most[0], "{shape:?}: {least_and_most:?}");
        let (linear, angular) = drift(&scene, 0.05);
        println!("{} particles, linear {linear:e}, angular {angular:e}", masses.len());
        assert!(linear < 1e-13, "{shape:?}: {linear:e}");
        assert!(angular < 1e-12, "{shape:?}: {angular:e}");
    }
}

#[test]
fn fibres_and_pair_damping_keep_momenta() {
    let mut scene = deformed();
    let bar = &mut scene.bodies[0];
    bar.material.damping.pair = 500.0;
    let helix = |k: u32| {
        let t = f64::from(k) * 0.5;
        [0.01 * t.cos(), 0.003 + 0.0055 * f64::from(k), 0.01 * t.sin()]
    };
    bar.fibres = vec![
        fibre("drawn", (0..13).map(helix).collect(), rigidity(5e5, 0.5), 0.5, RestShape::AsDrawn),
        fibre("straight", (0..13).map(helix).collect(), rigidity(5e5, 0.5), 0.5, RestShape::Straight),
    ];
    let (linear, angular) = drift(&scene, 0.1);
    println!("linear {linear:e}, angular {angular:e}");
    assert!(linear < 1e-13, "{linear:e}");
    assert!(angular < 1e-12, "{angular:e}");
}

fn energies(scene: &Scene, seconds: f64) -> Vec<f64> {
    let mut runner = runner(scene);
    let frames = runner.frames_for(seconds);
    (0..frames)
        .map(|_| {
            runner.advance_frame();
            runner.world().bodies()[0].energies(runner.world().time()).total()
        })
        .collect()
}

#[test]
fn undamped_energy_has_no_trend() {
    for (safety, tolerance) in [(0.7, 0.03), (0.35, 0.01)] {
        let mut bar = short_bar(5e7);
        bar.initial.deformation = [[0.96, 0.0, 0.0], [0.0, 1.1, 0.0], [0.0, 0.0, 0.96]];
        let mut scene = in_space(bar);
        scene.time.step = sinew::scene::TimeStep::Automatic(sinew::scene::Automatic { safety, ..Default::default() });
        scene.time.frames_per_second = 5000.0;
        let start = baked(&scene).world.bodies()[0].energies(0.0).total();
        let series = energies(&scene, 0.2);
        let window = series.len() / 10;
        let means: Vec<f64> =
            series.chunks(window).map(|chunk| chunk.iter().sum::<f64>() / chunk.len() as f64 / start).collect();
        println!("{safety}: {means:?}");
        for mean in &means {
            assert!((mean - 1.0).abs() < tolerance, "{safety}: {means:?}");
        }
        let trend = means[means.len() - 1] - means[0];
        assert!(trend.abs() < 0.001, "{safety}: the energy moves by {trend}: {means:?}");
    }
}

#[test]
fn every_integrator_agrees_with_runge_kutta_at_small_steps() {
    let at = |integrator: IntegratorKind, substeps: u32| {
        let mut scene = deformed();
        scene.bodies[0].integrator = integrator.into();
        scene.time.step = sinew::scene::TimeStep::manual(1e-4 / f64::from(substeps), substeps);
        let mut runner = runner(&scene);
        runner.advance_frame();
        runner.world().bodies()[0].state().positions.clone()
    };
    let reference = at(IntegratorKind::Rk4, 80);
    let error = |integrator, substeps| {
        let found = at(integrator, substeps);
        found.iter().zip(&reference).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max)
    };
    for (integrator, order) in [
        (IntegratorKind::ExplicitEuler, 1.0),
        (IntegratorKind::Midpoint, 2.0),
        (IntegratorKind::LeapFrog, 2.0),
        (IntegratorKind::Rk4, 4.0),
    ] {
        let (coarse, fine) = (error(integrator, 10), error(integrator, 20));
        let found = (coarse / fine).log2();
        println!("{integrator:?}: order {found:.2}, error {fine:e}");
        assert!((found - order).abs() < 0.2, "{integrator:?}: order {found:.2}, not {order}");
    }
}
