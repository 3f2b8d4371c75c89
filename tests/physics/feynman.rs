//! The Feynman Lectures' scheme makes the steps that the Lectures print, and leap-frog's.

use crate::common::*;
use glam::DVec3;
use sinew::scene::{Body, IntegratorKind, TimeStep};
use sinew::sim::Runner;
use sinew::solver::{Energies, Force, ParticleState};

/// Pulls a body as a whole towards the origin along X, as a weight on a spring is.
#[derive(Clone)]
struct Spring {
    omega: f64,
}

impl Force for Spring {
    fn add_forces(&mut self, _time: f64, state: &ParticleState, forces: &mut [DVec3]) {
        let pull = -self.omega * self.omega * state.center().x;
        for (force, mass) in forces.iter_mut().zip(&state.masses) {
            force.x += mass * pull;
        }
    }

    fn add_energy(&self, _time: f64, _state: &ParticleState, _energies: &mut Energies) {}

    fn clone_box(&self) -> Box<dyn Force> {
        Box::new(self.clone())
    }
}

fn under(body: Body, integrator: IntegratorKind, dt: f64, substeps: u32) -> Runner {
    let mut scene = in_space(Body { integrator: integrator.into(), ..body });
    scene.time.step = TimeStep::manual(dt, substeps);
    runner(&scene)
}

#[test]
fn a_weight_on_a_spring_moves_as_the_lectures_print_it() {
    // Vol. I, table 9-1: x'' = -x from x = 1 at rest in steps of 0.1; velocities at 0.05, 0.15, ...
    const PLACES: [f64; 16] = [
        0.995, 0.980, 0.955, 0.921, 0.877, 0.825, 0.764, 0.696, 0.621, 0.540, 0.453, 0.362, 0.267, 0.169, 0.070, -0.030,
    ];
    const VELOCITIES: [f64; 16] = [
        -0.050, -0.150, -0.248, -0.343, -0.435, -0.523, -0.605, -0.682, -0.751, -0.814, -0.868, -0.913, -0.949, -0.976,
        -0.993, -1.000,
    ];
    // In their units of time a step is 0.1; the body is soft enough for that.
    let (omega, dt) = (100.0, 1e-3);
    let body = block([3, 3, 3], 1e4).with_translation([1.0, 0.0, 0.0]);
    let mut runner = under(body, IntegratorKind::Feynman, dt, 1);
    runner.body_mut(0).unwrap().add_force(Box::new(Spring { omega }));
    let center = |runner: &Runner| runner.world().bodies()[0].state().center().x;
    let mut before = center(&runner);
    for (place, velocity) in PLACES.into_iter().zip(VELOCITIES) {
        runner.advance_frame();
        let now = center(&runner);
        assert!((now - place).abs() < 1.5e-3, "{now}, not {place}");
        let half = (now - before) / (dt * omega);
        assert!((half - velocity).abs() < 1.5e-3, "{half}, not {velocity}");
        before = now;
    }
    // What is shown of the velocity belongs to the whole step.
    let shown = runner.world().bodies()[0].state().velocities[0].x / omega;
    assert!((shown + 1.6_f64.sin()).abs() < 5e-3, "{shown}");
}

#[test]
fn it_goes_where_leap_frog_goes_damping_blows_and_all() {
    let mut body = block([3, 4, 3], 1e5);
    body.material.damping.pair = 300.0;
    body.initial.deformation = [[1.1, 0.05, 0.0], [0.0, 0.95, 0.0], [0.0, 0.0, 1.0]];
    body.initial.velocity = [0.5, 0.0, 0.0];
    let run = |integrator| {
        let mut runner = under(body.clone(), integrator, 1e-4, 20);
        for frame in 0..30 {
            if frame == 10 {
                runner.body_mut(0).unwrap().strike(DVec3::new(0.0, 0.02, 0.0));
            }
            runner.advance_frame();
        }
        runner.world().bodies()[0].state().clone()
    };
    let (one, other) = (run(IntegratorKind::Feynman), run(IntegratorKind::LeapFrog));
    let farthest = |a: &[DVec3], b: &[DVec3]| a.iter().zip(b).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max);
    let (apart, faster) = (farthest(&one.positions, &other.positions), farthest(&one.velocities, &other.velocities));
    println!("apart {apart:e} m, {faster:e} m/s");
    assert!(apart < 1e-11 && faster < 1e-9, "{apart:e} m, {faster:e} m/s");
    assert!(one.center().y > 0.01, "struck upwards: {}", one.center());
}
