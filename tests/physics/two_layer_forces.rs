//! Forces of two-layer bodies against finite differences of their energies.

use crate::common::baked;
use crate::two_layer::{ball, ring, two_layer, with};
use glam::DVec3;
use serde_json::json;
use sinew::solver::EmbeddingWeights;
use sinew::solver::Energies;
use sinew::solver::ParticleState;
use sinew::solver::{Force, Grab};

fn wobble(k: usize, scale: f64) -> DVec3 {
    let k = k as f64;
    scale * DVec3::new((1.3 * k).sin(), (2.1 * k + 0.4).cos(), (0.7 * k + 1.0).sin())
}

/// A body's springs and gas, and its state out of shape, at rest or moving.
fn body(index: usize, speed: f64) -> (Vec<Box<dyn Force>>, ParticleState) {
    let bodies = [
        ring(),
        ball(1),
        with(ring(), json!({"pressure_in": "annulus"})),
        with(ball(1), json!({"pressure_in": "both"})),
    ];
    let baked = baked(&two_layer(&[bodies[index].clone()], json!({})));
    let parts = baked.world.bodies()[0].parts();
    let mut state = parts.state.clone();
    let flat = if index.is_multiple_of(2) { DVec3::new(1.0, 1.0, 0.0) } else { DVec3::ONE };
    for i in 0..state.len() {
        // Larger than at rest, so that every spring is stretched.
        state.positions[i] = 1.2 * state.positions[i] + flat * wobble(i, 0.05);
        state.velocities[i] = flat * wobble(i + 100, speed);
    }
    let mut forces = parts.forces.clone();
    let target = DVec3::new(3.0, 1.0, 0.0);
    let point = EmbeddingWeights::of_particle(1);
    forces.push(Box::new(Grab { point, target, stiffness: 150.0, damping: 25.0, until: 1.0 }));
    (forces, state)
}

fn total(forces: &mut [Box<dyn Force>], state: &ParticleState) -> Vec<DVec3> {
    let mut sum = vec![DVec3::ZERO; state.len()];
    for force in forces.iter_mut() {
        force.add_forces(0.0, state, &mut sum);
    }
    sum
}

fn energy(forces: &[Box<dyn Force>], state: &ParticleState) -> f64 {
    let mut energies = Energies::default();
    for force in forces {
        force.add_energy(0.0, state, &mut energies);
    }
    energies.potential()
}

#[test]
fn spring_and_gas_forces_are_the_gradient_of_their_energy() {
    for index in 0..4 {
        let (mut forces, mut state) = body(index, 0.0);
        let exact = total(&mut forces, &state);
        let scale = exact.iter().map(|f| f.length()).fold(0.0, f64::max);
        let h = 1e-4;
        for i in 0..state.len() {
            for axis in 0..3 {
                let at = state.positions[i];
                let mut moved = |share: f64| {
                    state.positions[i][axis] = at[axis] + share * h;
                    let energy = energy(&forces, &state);
                    state.positions[i] = at;
                    energy
                };
                // Fourth-order differences.
                let slope = (8.0 * (moved(1.0) - moved(-1.0)) - (moved(2.0) - moved(-2.0))) / (12.0 * h);
                assert!((exact[i][axis] + slope).abs() < 1e-8 * scale, "body {index}, particle {i}, axis {axis}");
            }
        }
    }
}

#[test]
fn springs_and_gas_keep_both_momenta() {
    for index in 0..4 {
        let (mut forces, state) = body(index, 2.0);
        forces.pop();
        let sum = total(&mut forces, &state);
        let scale: f64 = sum.iter().map(|f| f.length()).sum();
        let force: DVec3 = sum.iter().sum();
        let torque: DVec3 = sum.iter().zip(&state.positions).map(|(f, x)| x.cross(*f)).sum();
        assert!(force.length() < 1e-13 * scale && torque.length() < 1e-12 * scale, "{force} {torque}");
    }
}

#[test]
fn forces_are_the_same_on_any_number_of_threads() {
    let run = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| {
            let scene = two_layer(
                &[ball(2), with(ball(2), json!({"placement": {"translation": [0, 3.9, 0.2]}}))],
                json!({
                "gravity": [0, -9.81, 0], "room": {"floor": -2.5}}),
            );
            let runner = crate::two_layer::after(&scene, 0.5);
            runner.world().bodies().iter().flat_map(|body| body.state().positions.clone()).collect::<Vec<_>>()
        })
    };
    let (one, two) = (run(1), run(2));
    let bits = |x: &DVec3| x.to_array().map(f64::to_bits);
    assert!(one.iter().map(bits).eq(two.iter().map(bits)));
}
