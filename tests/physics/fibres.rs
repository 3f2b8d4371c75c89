//! Fibres: what they weigh in, where they sit, how stiff they are.

use crate::common::*;
use glam::{DQuat, DVec3};
use sinew::geometry::Kernel;
use sinew::scene::{
    Axis, BoxShape, Distance, Falloff, FibreEmbedding, IntegratorKind, MeasureKind, Motion, RestShape, Scene, Side,
};
use sinew::solver::EmbeddingWeights;
use sinew::solver::Energies;
use sinew::solver::Force;
use sinew::solver::ParticleState;
use sinew::test_support::solver::{FibreForce, FibreRest};
use std::sync::Arc;

/// The press of the short bar at 2 %, with the four fibres of the design's figure.
fn pressed(fraction_of_fibre: f64) -> Scene {
    let mut bar = short_bar(5e7);
    bar.material.damping.air = 8000.0;
    for (k, (x, z)) in [(-0.012, -0.012), (-0.012, 0.012), (0.012, -0.012), (0.012, 0.012)].into_iter().enumerate() {
        let vertices = (0..13).map(|i| [x, 0.003 + 0.0055 * f64::from(i), z]).collect();
        bar.fibres.push(fibre(&format!("f{k}"), vertices, paper(5e5, 2.5e5), fraction_of_fibre, RestShape::Straight));
    }
    bar.regions = vec![layers("bottom", Axis::Y, Side::Min, 1), layers("top", Axis::Y, Side::Max, 1)];
    bar.pins = vec![
        pin("bottom", &ALL, Motion::Fixed),
        pin("top", &[Axis::Y], ramp([0.0, -1.0, 0.0], Distance::Fraction(0.02), 0.004)),
    ];
    let mut scene = in_space(bar);
    scene.time.frames_per_second = 2000.0;
    scene.measures = vec![measure("press", MeasureKind::reaction_force("top", [0.0, 1.0, 0.0]))];
    scene
}

#[test]
fn four_fibres_stiffen_the_press_as_computed() {
    let force = scalar(&settle(&pressed(0.25), 200), 0);
    println!("{force} N");
    assert!((force / 11_828.0 - 1.0).abs() < 0.02, "{force} N, not 11 828 N");
}

/// Four fibres in a smaller bar that is pressed, hung on these particles.
fn pressed_by(embedding: FibreEmbedding) -> Scene {
    let mut scene = pressed(0.25);
    let bar = &mut scene.bodies[0];
    bar.shape = BoxShape::new([5.0 * D, 8.0 * D, 5.0 * D]).with_center([0.0, 4.0 * D, 0.0]).into();
    bar.material.fibre_embedding = embedding;
    bar.fibres.clear();
    for (k, [x, z]) in [[-1.3, -1.3], [1.3, -1.3], [-1.3, 1.3], [1.3, 1.3]].into_iter().enumerate() {
        let vertices = (0..9).map(|k| [x * D, (0.5 + 7.0 / 8.0 * f64::from(k)) * D, z * D]).collect();
        bar.fibres.push(fibre(&format!("f{k}"), vertices, paper(5e5, 2.5e5), 0.25, RestShape::Straight));
    }
    scene
}

#[test]
fn fewer_particles_around_a_fibre_shorten_the_step_and_leave_the_stiffness() {
    let [compact, all] = [FibreEmbedding::Compact, FibreEmbedding::All].map(|embedding| {
        let scene = pressed_by(embedding);
        let step = baked(&scene).stable_step(IntegratorKind::LeapFrog);
        (step, scalar(&settle(&scene, 200), 0))
    });
    let (step, force) = (compact.0 / all.0 - 1.0, compact.1 / all.1 - 1.0);
    println!("step {:.3} %, force {:.4} %", 100.0 * step, 100.0 * force);
    // The fastest motion of a fibre against its surroundings is stiffer by twice the share of the step; a press,
    // which moves slowly from one place to the next, is not.
    assert!((-0.035..-0.02).contains(&step), "{step}");
    assert!(force.abs() < 1e-3, "{force}");
}

/// A fibre whose vertices are particles of their own, so that only its own energy is seen.
fn bare_fibre(at: &[DVec3], ea: f64, ei: f64, fraction: f64) -> (FibreForce, ParticleState) {
    let vertices = (0..at.len() as u32).map(|k| EmbeddingWeights { weights: vec![(k, 1.0)] }).collect();
    let rest = FibreRest::new(vertices, at, ea, ei, fraction, vec![None; at.len() - 2]);
    let state =
        ParticleState { positions: at.to_vec(), velocities: vec![DVec3::ZERO; at.len()], masses: vec![1.0; at.len()] };
    (FibreForce::new(Arc::new([rest]), DQuat::IDENTITY), state)
}

fn energies(force: &FibreForce, state: &ParticleState) -> Energies {
    let mut energies = Energies::default();
    force.add_energy(0.0, state, &mut energies);
    energies
}

#[test]
fn a_fibre_bent_to_a_circle_stores_what_a_rod_does() {
    // EI kappa² L / 2 over the whole length, end edges included, times the volume fraction.
    let (ei, fraction, edge, radius, count) = (0.3, 0.4, 0.005, 0.5, 14);
    let turn = 2.0 * (0.5_f64 * edge / radius).asin();
    let circle: Vec<DVec3> = (0..count)
        .map(|k| {
            let angle = turn * f64::from(k);
            radius * DVec3::new(angle.sin(), 1.0 - angle.cos(), 0.0)
        })
        .collect();
    let (force, state) = bare_fibre(&circle, 1e5, ei, fraction);
    let length = edge * f64::from(count - 1);
    let expected = fraction * 0.5 * ei * length / (radius * radius);
    let found = energies(&force, &state);
    assert!((found.bending / expected - 1.0).abs() < 1e-4, "{} J, not {expected} J", found.bending);
    assert_eq!(found.stretching, 0.0);
}

#[test]
fn a_stretched_fibre_stores_what_hooke_says() {
    let line: Vec<DVec3> = (0..9).map(|k| DVec3::X * 0.006 * f64::from(k)).collect();
    let (force, mut state) = bare_fibre(&line, 2e4, 0.1, 0.25);
    for x in &mut state.positions {
        x.x *= 1.03;
    }
    let expected = 0.25 * 0.5 * 2e4 * 0.03 * 0.03 * 0.048;
    let found = energies(&force, &state);
    assert!((found.stretching / expected - 1.0).abs() < 1e-12, "{} J, not {expected} J", found.stretching);
    assert!(found.bending < 1e-18);
}

#[test]
fn the_energy_of_a_fold_continues_without_a_jump() {
    let bent = |degrees: f64| {
        let angle: f64 = degrees.to_radians();
        let at = [DVec3::NEG_X * 0.006, DVec3::ZERO, 0.006 * DVec3::new(angle.cos(), angle.sin(), 0.0)];
        let (force, state) = bare_fibre(&at, 1e4, 0.1, 0.5);
        energies(&force, &state).bending
    };
    // Continuous and rising through 120 degrees, finite at a full fold.
    assert!((bent(120.001) / bent(119.999) - 1.0).abs() < 1e-4);
    assert!(bent(119.0) < bent(121.0) && bent(121.0) < bent(179.0) && bent(180.0).is_finite());
}

#[test]
fn volume_fractions_fall_off_as_chosen_and_the_largest_counts() {
    let energy_share = |falloff: Falloff, fibres: &[f64]| {
        let mut bar = short_bar(2e5);
        bar.material.volume_fraction_falloff = falloff;
        let vertices: Vec<[f64; 3]> = (0..13).map(|k| [0.0, 0.003 + 0.0055 * f64::from(k), 0.0]).collect();
        for (k, &fraction) in fibres.iter().enumerate() {
            bar.fibres.push(fibre(
                &format!("f{k}"),
                vertices.clone(),
                rigidity(100.0, 1e-6),
                fraction,
                RestShape::Straight,
            ));
        }
        bar.initial.deformation[1][1] = 1.01;
        baked(&in_space(bar)).world.bodies()[0].energies(0.0).matrix
    };
    let none = energy_share(Falloff::Kernel, &[]);
    let kernel = energy_share(Falloff::Kernel, &[0.8]);
    let linear = energy_share(Falloff::Linear, &[0.8]);
    let constant = energy_share(Falloff::Constant, &[0.8]);
    assert!(none > kernel && kernel > linear && linear > constant, "{none} {kernel} {linear} {constant}");
    // Two fibres in one place take no more than the larger one.
    assert_eq!(energy_share(Falloff::Kernel, &[0.8, 0.3]), kernel);
    // The kernel at every particle, by the definition.
    let share: f64 = baked(&in_space(short_bar(2e5))).world.bodies()[0]
        .parts()
        .rest
        .iter()
        .map(|x| {
            let nearest = (0..13)
                .map(|k| x.distance(DVec3::new(0.0, 0.003 + 0.0055 * f64::from(k), 0.0)))
                .fold(f64::INFINITY, f64::min);
            1.0 - 0.8 * Kernel::new(H).relative(nearest)
        })
        .sum();
    assert!((kernel / none - share / 588.0).abs() < 1e-12, "{} {}", kernel / none, share / 588.0);
}

#[test]
fn drawn_fibres_rest_where_they_are_and_straight_ones_pull() {
    let curve: Vec<[f64; 3]> = (0..13)
        .map(|k| {
            let t = 0.25 * f64::from(k);
            [0.012 * t.sin(), 0.003 + 0.0055 * f64::from(k), 0.008 * t.cos()]
        })
        .collect();
    let moved = |rest: RestShape| {
        let mut bar = short_bar(2e5);
        bar.fibres = vec![fibre("f", curve.clone(), rigidity(3000.0, 0.05), 0.5, rest)];
        let mut runner = runner(&in_space(bar));
        for _ in 0..3 {
            runner.advance_frame();
        }
        let body = &runner.world().bodies()[0];
        body.state()
            .positions
            .iter()
            .zip(body.parts().rest.iter())
            .map(|(x, rest)| x.distance(*rest))
            .fold(0.0, f64::max)
    };
    let (drawn, straight) = (moved(RestShape::AsDrawn), moved(RestShape::Straight));
    assert!(drawn < 1e-12, "{drawn} m");
    assert!(straight > 1e-4, "{straight} m");
}

#[test]
fn fibres_are_trimmed_moved_and_warned_of_with_figures() {
    let notes = |vertices: Vec<[f64; 3]>, ea: f64| {
        let mut bar = short_bar(2e5);
        bar.fibres = vec![fibre("f", vertices, rigidity(ea, 0.01), 0.5, RestShape::Straight)];
        let baked = baked(&in_space(bar));
        let said: Vec<String> = baked.notes.iter().map(ToString::to_string).collect();
        let active = baked.world.bodies()[0].parts().fibres.len();
        (said.join("\n"), active)
    };
    let upright = |x: f64, z: f64, from: i32, to: i32| (from..to).map(|k| [x, 0.006 * f64::from(k), z]).collect();
    let (said, _) = notes(upright(0.0, 0.0, -6, 12), 2000.0);
    assert!(said.contains("points outside the solid were trimmed"), "{said}");
    let (said, fibres) = notes(upright(0.1, 0.0, 0, 12), 2000.0);
    assert!(said.contains("Fibre discarded: nearest material 5.5 h away") && fibres == 0, "{said}");
    let (said, _) = notes(upright(0.0205, 0.0205, 0, 13), 2000.0);
    assert!(said.contains("were moved into it"), "{said}");
    let (said, _) = notes(upright(0.0, 0.0, 1, 12), 10.0);
    assert!(said.contains("weakens the solid"), "{said}");
    let (said, _) = notes((0..20).map(|k| [0.0, 0.01 + 0.002 * f64::from(k), 0.0]).collect(), 2000.0);
    assert!(said.contains("shrinks the time step"), "{said}");
    let (said, _) = notes(upright(0.0, 0.0, 1, 12), 2000.0);
    assert!(said.is_empty(), "{said}");
}

#[test]
fn what_is_hidden_moves_all_the_same() {
    let ends = |hidden: bool| {
        let mut bar = short_bar(2e5);
        let vertices = (0..12).map(|k| [0.01, 0.003 + 0.006 * f64::from(k), 0.0]).collect();
        bar.fibres = vec![fibre("f", vertices, rigidity(3000.0, 0.05), 0.5, RestShape::Straight)];
        bar.initial.deformation[0][1] = 0.1;
        (bar.hidden, bar.fibres[0].hidden, bar.fibres[0].color) = (hidden, hidden, hidden.then_some([1, 2, 3]));
        let mut runner = runner(&in_space(bar));
        runner.advance_frame();
        runner.world().bodies()[0].state().positions.iter().map(|x| x.to_array().map(f64::to_bits)).collect::<Vec<_>>()
    };
    assert_eq!(ends(true), ends(false));
}
