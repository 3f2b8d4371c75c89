//! Forces against the energies they come from, and against what must leave them at zero.

use crate::common::*;
use crate::conservation::weighted;
use glam::{DMat3, DQuat, DVec3};
use sinew::scene::{Fibre, RestShape, Scene};
use sinew::solver::Body;
use sinew::solver::Energies;
use sinew::solver::ParticleState;

fn total_force(body: &Body, state: &ParticleState) -> Vec<DVec3> {
    let mut forces = vec![DVec3::ZERO; state.len()];
    for force in &body.parts().forces {
        force.clone_box().add_forces(0.0, state, &mut forces);
    }
    forces
}

fn potential(body: &Body, state: &ParticleState) -> f64 {
    let mut energies = Energies::default();
    for force in &body.parts().forces {
        force.add_energy(0.0, state, &mut energies);
    }
    energies.potential()
}

/// Largest error of the force along random directions against central differences of the energy, relative.
fn gradient_error(scene: &Scene, gradient: DMat3, noise: f64) -> f64 {
    let baked = baked(scene);
    let body = &baked.world.bodies()[0];
    let mut state = body.state().clone();
    for (i, x) in state.positions.iter_mut().enumerate() {
        *x = gradient * *x + noise * D * wobble(i, 1);
    }
    let forces = total_force(body, &state);
    let mut worst: f64 = 0.0;
    for salt in 2..6 {
        let direction: Vec<DVec3> = (0..state.len()).map(|i| wobble(i, salt)).collect();
        // Fourth-order central difference.
        let at = |step: f64| {
            let mut moved = state.clone();
            for (x, d) in moved.positions.iter_mut().zip(&direction) {
                *x += step * *d;
            }
            potential(body, &moved)
        };
        let e = 1e-4 * D;
        let slope = (8.0 * (at(e) - at(-e)) - (at(2.0 * e) - at(-2.0 * e))) / (12.0 * e);
        let work: f64 = forces.iter().zip(&direction).map(|(f, d)| f.dot(*d)).sum();
        let scale: f64 = forces.iter().zip(&direction).map(|(f, d)| f.dot(*d).abs()).sum::<f64>();
        worst = worst.max((slope + work).abs() / scale);
    }
    worst
}

fn deformation() -> DMat3 {
    DMat3::from_quat(DQuat::from_rotation_x(0.7))
        * DMat3::from_cols_array(&[1.06, 0.02, 0.0, 0.05, 0.93, 0.03, -0.04, 0.0, 1.02])
}

fn curved() -> Vec<[f64; 3]> {
    (0..13)
        .map(|k| {
            let t = 0.45 * f64::from(k);
            [0.011 * t.cos(), 0.003 + 0.0054 * f64::from(k), 0.011 * t.sin()]
        })
        .collect()
}

fn with_fibre(fibre: Fibre) -> Scene {
    let mut bar = block([7, 12, 7], 2e5);
    bar.fibres = vec![fibre];
    in_space(bar)
}

#[test]
fn the_matrix_force_is_the_gradient_of_its_energy() {
    let error = gradient_error(&in_space(short_bar(5e7)), deformation(), 0.1);
    println!("{error:e}");
    assert!(error < 1e-8, "{error:e}");
}

#[test]
fn forces_on_particles_that_stand_for_parts_of_cells_are_the_gradient_of_their_energy() {
    for body in weighted(5e7) {
        for (fast, most) in [(false, 1e-8), (true, 1e-6)] {
            let mut body = body.clone();
            if fast {
                body.material = body.material.in_fast_precision();
            }
            let shape = body.shape.clone();
            let error = gradient_error(&in_space(body), deformation(), 0.1);
            println!("{error:e}");
            assert!(error < most, "{shape:?}, fast {fast}: {error:e}");
        }
    }
}

#[test]
fn the_fast_matrix_force_is_the_gradient_of_the_same_energy() {
    let mut bar = short_bar(5e7);
    bar.material = bar.material.in_fast_precision();
    let error = gradient_error(&in_space(bar), deformation(), 0.1);
    println!("{error:e}");
    assert!(error < 1e-6, "{error:e}");
}

#[test]
fn fibre_forces_are_the_gradients_of_their_energies() {
    for rest in [RestShape::Straight, RestShape::AsDrawn] {
        let scene = with_fibre(fibre("f", curved(), rigidity(3e4, 40.0), 0.6, rest));
        let error = gradient_error(&scene, deformation(), 0.1);
        println!("{rest:?}: {error:e}");
        assert!(error < 1e-8, "{rest:?}: {error:e}");
    }
}

#[test]
fn folded_fibres_keep_the_gradient() {
    // A hairpin: turns of more than 120 degrees, where the energy continues linearly.
    let hairpin =
        vec![[0.0, 0.01, 0.0], [0.0, 0.022, 0.0], [0.003, 0.034, 0.0], [0.006, 0.022, 0.002], [0.006, 0.01, 0.0]];
    for rest in [RestShape::Straight, RestShape::AsDrawn] {
        let scene = with_fibre(fibre("f", hairpin.clone(), rigidity(3e4, 40.0), 0.6, rest));
        let error = gradient_error(&scene, DMat3::IDENTITY, 0.02);
        println!("{rest:?}: {error:e}");
        assert!(error < 1e-8, "{rest:?}: {error:e}");
    }
}

#[test]
fn rigid_motion_makes_no_force() {
    let scene = with_fibre(fibre("f", curved(), rigidity(3e4, 0.1), 0.6, RestShape::AsDrawn));
    let baked = baked(&scene);
    let body = &baked.world.bodies()[0];
    let mut state = body.state().clone();
    let turn = DQuat::from_axis_angle(DVec3::new(1.0, 2.0, -0.5).normalize_or_zero(), 2.5);
    for x in &mut state.positions {
        *x = turn * *x + DVec3::new(0.4, -0.3, 0.2);
    }
    let largest = total_force(body, &state).iter().map(|f| f.length()).fold(0.0, f64::max);
    println!("{:e} of E D²", largest / (2e5 * D * D));
    assert!(largest < 1e-10 * 2e5 * D * D, "{largest:e}");
}

#[test]
fn linear_deformation_gives_the_exact_energy_everywhere() {
    // Patch test: small strain, energy density e : sigma / 2 times the sampled volume, surfaces and corners included.
    let scene = in_space(short_bar(5e7));
    let baked = baked(&scene);
    let body = &baked.world.bodies()[0];
    let (e, nu) = (5e7, 0.33);
    let (mu, lambda) = (e / (2.0 * (1.0 + nu)), e * nu / ((1.0 + nu) * (1.0 - 2.0 * nu)));
    let strain = DMat3::from_cols_array(&[0.01, 0.004, 0.0, 0.004, -0.02, 0.003, 0.0, 0.003, 0.005]);
    let mut state = body.state().clone();
    let turn = DMat3::from_rotation_z(0.4);
    for x in &mut state.positions {
        *x = turn * (DMat3::IDENTITY + strain) * *x;
    }
    let trace: f64 = strain.x_axis.x + strain.y_axis.y + strain.z_axis.z;
    let square: f64 = strain.to_cols_array().iter().map(|e| e * e).sum();
    let expected = 588.0 * D.powi(3) * (mu * square + 0.5 * lambda * trace * trace);
    let mut energies = Energies::default();
    body.parts().forces[0].add_energy(0.0, &state, &mut energies);
    assert!((energies.matrix / expected - 1.0).abs() < 1e-12, "{} {expected}", energies.matrix);
    assert!(energies.zero_energy < 1e-12 * expected);
    // Inner particles are in equilibrium.
    let forces = total_force(body, &state);
    let center = DVec3::new(0.0, 0.036, 0.0);
    let inner =
        (0..588).filter(|&i| (body.parts().rest[i] - center).abs().cmplt(DVec3::new(0.004, 0.004, 0.004)).all());
    let mut seen = 0;
    for i in inner {
        assert!(forces[i].length() < 1e-9 * e * D * D, "{}", forces[i]);
        seen += 1;
    }
    assert!(seen > 0);
}

#[test]
fn no_volume_fraction_gives_the_bits_of_no_fibre() {
    let hash = |with: bool| {
        let mut bar = short_bar(2e5);
        bar.placement.translation = [0.0, 0.01, 0.0];
        if with {
            bar.fibres = vec![fibre("f", curved(), rigidity(3e4, 40.0), 0.0, RestShape::Straight)];
        }
        let mut scene = in_space(bar);
        scene.gravity = [0.0, -9.81, 0.0];
        scene.room.floor = Some(0.0);
        let mut runner = runner(&scene);
        for _ in 0..6 {
            runner.advance_frame();
        }
        sinew::sim::Report::new(&scene, &runner, 1.0, Vec::new()).bodies[0].state_hash.clone()
    };
    assert_eq!(hash(true), hash(false));
}
