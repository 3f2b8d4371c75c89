//! How far fibres contract and bend what they lie in, what that costs, and under which steps it is stable.

use crate::common::*;
use glam::DVec3;
use sinew::bake::Baked;
use sinew::scene::{
    Activation, Body, Drive, DriveKeys, Fibre, Motion, Region, RestShape, Rigidity, Scene, Selector, TimeStep, Wave,
};
use sinew::sim::Runner;
use sinew::solver::{Body as Simulated, Energies, World};
use sinew::test_support::solver::FibreForce;

pub const E: f64 = 2e5;
/// Force unit E D² [N].
pub const F: f64 = E * D * D;

/// A rod of whole layers, at rest along Y.
pub fn rod(layers: [u32; 3]) -> Body {
    block(layers, E)
}

/// A straight fibre along Y beside the axis, from the first layer of particles to the last.
pub fn upright(layers: u32, x: f64, ea: f64, activation: Activation) -> Fibre {
    let vertices = (0..layers).map(|k| [x, D * (f64::from(k) + 0.5), 0.0]).collect();
    fibre("muscle", vertices, rigidity(ea, 0.0), 0.25, RestShape::Straight).with_activation(activation)
}

/// A contraction that comes within 20 ms and stays.
fn coming(contract: f64) -> Activation {
    Activation::contracting(contract, DriveKeys::new([(0.0, 0.0), (0.02, 1.0)]))
}

/// The body at rest under its fibres.
pub fn settled(mut body: Body) -> (Baked, Runner) {
    body.material.damping.air = 60.0;
    let mut scene = in_space(body);
    scene.time.frames_per_second = 100.0;
    let baked = baked(&scene);
    let mut runner = Runner::new(baked.clone());
    (0..35).for_each(|_| runner.advance_frame());
    assert!(runner.world().divergence().is_none(), "{:?}", runner.world().divergence());
    (baked, runner)
}

/// Particles of each layer across Y, first to last.
pub fn sections(body: &Simulated) -> Vec<Vec<usize>> {
    let heights: Vec<f64> = body.parts().model.iter().map(|x| x.y / D).collect();
    let count = heights.iter().fold(0.0, |a: f64, b| a.max(*b)).ceil() as usize;
    (0..count).map(|k| (0..heights.len()).filter(|&i| heights[i].floor() as usize == k).collect()).collect()
}

pub fn center(particles: &[usize], positions: &[DVec3]) -> DVec3 {
    particles.iter().map(|&i| positions[i]).sum::<DVec3>() / particles.len() as f64
}

/// `E_m`, the matrix's axial rigidity over E D², and `EI_m`, over E D⁴, with the offset [D] of its centre along X, of
/// the section in the middle.
pub fn section_of(baked: &Baked) -> [f64; 3] {
    let body = &baked.world.bodies()[0];
    let all = sections(body);
    let middle = &all[all.len() / 2];
    let of = |i: usize| (1.0 - baked.fractions[0][i], body.parts().model[i].x / D);
    let area: f64 = middle.iter().map(|&i| of(i).0).sum();
    let center = middle.iter().map(|&i| of(i).0 * of(i).1).sum::<f64>() / area;
    let inertia = middle.iter().map(|&i| of(i).0 * ((of(i).1 - center).powi(2) + 1.0 / 12.0)).sum();
    [area, inertia, center]
}

/// Between columns of particles and on one; from one end to the other less, since shear brings the pull in there.
#[test]
fn a_fibre_contracts_a_rod_as_far_as_its_stiffness_has_it() {
    for (n, layers, half, ea, contract, ratio) in [
        (4, 13, 2, 30.0, 0.001, 0.9996),
        (4, 13, 2, 30.0, 0.05, 0.9996),
        (4, 13, 2, 30.0, 0.45, 0.9996),
        (5, 21, 4, 20.0, 0.3, 1.0002),
        (5, 21, 4, 100.0, 0.02, 0.9973),
        (5, 21, 4, 100.0, 0.3, 0.9970),
    ] {
        let mut rod = rod([n, layers, n]);
        rod.fibres.push(upright(layers, 0.0, ea * F, coming(contract)));
        let (baked, runner) = settled(rod);
        let [matrix, ..] = section_of(&baked);
        let body = &runner.world().bodies()[0];
        let all = sections(body);
        let strain = |[from, to]: [usize; 2]| {
            let apart = |x: &[DVec3]| center(&all[to], x).distance(center(&all[from], x));
            apart(&body.state().positions) / apart(&body.parts().rest) - 1.0
        };
        let fibre = 0.25 * ea;
        let expected = -contract * fibre / (fibre + matrix);
        let (middle, last) = (layers as usize / 2, layers as usize - 1);
        let (within, ends) = (strain([middle - half, middle + half]) / expected, strain([0, last]) / expected);
        println!("{n} x {n}, {ea}, {contract}: {within:.4}, end to end {ends:.3}");
        assert!((within - ratio).abs() < 5e-4, "{n} x {n}, {ea}, {contract}: {within}, not {ratio}");
        if n == 4 {
            assert!((ends - 0.91).abs() < 0.02, "{ends} end to end");
        }
    }
}

#[test]
fn a_fibre_beside_the_axis_bends_a_rod_as_two_metals_do() {
    for (n, d, ea, contract, [least, most]) in [
        (5, 1.5, 20.0, 0.01, [0.998, 1.008]),
        (5, 1.5, 20.0, 0.1, [1.003, 1.013]),
        (5, 1.5, 20.0, 0.3, [1.015, 1.025]),
        (5, 1.5, 20.0, 0.5, [1.025, 1.035]),
        (5, 1.5, 200.0, 0.01, [0.99, 1.0]),
        (5, 1.5, 200.0, 0.3, [0.999, 1.009]),
        (4, 1.0, 20.0, 0.1, [1.016, 1.043]),
        (4, 1.0, 20.0, 0.3, [1.016, 1.043]),
        (3, 0.5, 20.0, 0.1, [1.03, 1.09]),
        (3, 0.5, 20.0, 0.3, [1.03, 1.09]),
    ] {
        let mut rod = rod([n, 15, n]);
        rod.fibres.push(upright(15, d * D, ea * F, coming(contract)));
        let (baked, runner) = settled(rod);
        let [area, inertia, offset] = section_of(&baked);
        let (fibre, d) = (0.25 * ea, d - offset);
        let tension = contract / (1.0 / fibre + 1.0 / area + d * d / inertia);
        let expected = tension * d / inertia / D;
        let body = &runner.world().bodies()[0];
        let all = sections(body);
        let at = |k: usize| center(&all[k], &body.state().positions);
        // Over the length at rest, which theory goes by.
        let curvature = (at(7) - at(5)).angle_between(at(9) - at(7)) / (2.0 * D);
        // Towards the fibre.
        assert!(at(14).x > at(7).x && at(0).x > at(7).x);
        let ratio = curvature / expected;
        println!("{n} x {n}, {ea}, {contract}: {ratio:.4}");
        assert!((least..=most).contains(&ratio), "{n} x {n}, {ea}, {contract}: {ratio}, not {least} to {most}");
    }
}

/// A rod of 3 x 3 whose fibre contracts by a wave along it, or at once.
fn slender(layers: u32, drive: impl Into<Drive>, ea: f64) -> Body {
    let mut rod = rod([3, layers, 3]);
    rod.fibres.push(upright(layers, 0.5 * D, ea * F, Activation::contracting(0.3, drive)));
    rod
}

#[test]
fn the_work_of_drives_closes_the_balance_to_second_order() {
    let (period, length) = (20.0 * D / (E / 1852.0_f64).sqrt(), 13.0 * D);
    let mut scene = in_space(slender(13, Wave::new(period).with_wavelength(length), 10.0));
    let stable = baked(&scene).world.bodies()[0].parts().stable_dt;
    let mut off = |halvings: i32| {
        let dt = 0.7 * stable * 0.5_f64.powi(halvings);
        scene.time.step = TimeStep::manual(dt, 10 << halvings);
        let mut runner = runner(&scene);
        for _ in 0..10 {
            runner.advance_frame();
        }
        let energies = runner.world().bodies()[0].energies(runner.world().time());
        (energies.total(), -energies.activation)
    };
    let found = [0, 1, 2].map(&mut off);
    println!("{found:?}");
    let work = found[2].1;
    assert!(work > 0.0 && found[0].0.abs() < 0.02 * work, "{found:?}");
    // Half the step, a quarter of what is missing.
    for pair in found.windows(2) {
        assert!((pair[1].0 / pair[0].0 - 0.25).abs() < 0.05, "{found:?}");
    }
}

/// Whether the energy of a fibre solid stays bounded over thousands of steps of so much of its stable step.
pub fn holds(body: &Body, share: f64) -> bool {
    let mut scene = in_space(body.clone());
    let dt = share * baked(&scene).world.bodies()[0].parts().stable_dt;
    scene.time.step = TimeStep::manual(dt, 100);
    let mut runner = runner(&scene);
    (0..25).for_each(|_| runner.advance_frame());
    let energies = runner.world().bodies()[0].energies(runner.world().time());
    runner.world().divergence().is_none() && energies.kinetic < 2.0 * energies.activation.abs()
}

#[test]
fn the_stable_step_holds_over_every_activation() {
    let passive = |mut body: Body| {
        body.fibres[0].activation = None;
        baked(&in_space(body)).world.bodies()[0].parts().stable_dt
    };
    // The bound costs next to nothing on a straight fibre.
    let bar = slender(7, 1.0, 40.0);
    let ratio = passive(bar.clone()) / baked(&in_space(bar)).world.bodies()[0].parts().stable_dt;
    assert!((1.0..1.02).contains(&ratio), "{ratio}");
    let period = 40.0 * D / (E / 1852.0_f64).sqrt();
    for (k, (ea, contract)) in
        [(40.0, 0.3), (40.0, 0.8), (40.0, -0.5), (120.0, 0.5), (10.0, 0.6), (4.0, 0.8)].into_iter().enumerate()
    {
        for wave in [false, true] {
            let wave_along = Wave::new(period).with_wavelength(9.0 * D);
            let drive: Drive = if wave { wave_along.into() } else { DriveKeys::new([(0.0, 0.0), (0.02, 1.0)]).into() };
            let mut bar = slender(7, drive, ea);
            bar.fibres[0].activation.as_mut().expect("it acts").contract = contract;
            assert!(holds(&bar, 0.98), "{k} {wave}");
            assert!(!holds(&bar, 1.25), "{k} {wave}");
        }
    }
}

#[test]
fn bodies_wait_for_their_drives_and_sleep_without() {
    let world = |drive: Drive| {
        let mut scene = in_space(slender(5, drive, 20.0));
        scene.time.frames_per_second = 50.0;
        runner(&scene)
    };
    // At rest, but about to act; then, while it rests for the same values.
    let mut late = world(DriveKeys::new([(0.1, 0.0), (0.2, 1.0)]).into());
    for _ in 0..4 {
        late.advance_frame();
        assert!(!late.at_rest());
    }
    let steps = late.world().bodies()[0].steps();
    (0..10).for_each(|_| late.advance_frame());
    assert!(late.world().bodies()[0].steps() > steps);
    let body = &late.world().bodies()[0];
    assert!(body.state().positions[0].distance(body.parts().rest[0]) > 0.02 * D);
    let mut still = world(0.0.into());
    (0..3).for_each(|_| still.advance_frame());
    assert!(still.at_rest());
    assert_eq!(still.world().bodies()[0].steps(), world(0.0.into()).world().bodies()[0].steps());
}

#[test]
fn a_world_goes_back_and_on_to_the_same_bits() {
    let bits = |world: &World| {
        let body = &world.bodies()[0];
        let mut all: Vec<u64> = body.state().positions.iter().flat_map(DVec3::to_array).map(f64::to_bits).collect();
        all.extend(body.energies(world.time()).values().map(f64::to_bits));
        all.extend(body.tensions().concat().into_iter().map(f64::to_bits));
        all
    };
    let mut world = baked(&in_space(slender(9, Wave::new(0.05).with_wavelength(0.03), 20.0))).world;
    (0..3).for_each(|_| world.advance_frame());
    let kept = world.checkpoint();
    (0..4).for_each(|_| world.advance_frame());
    let first = bits(&world);
    world.go_back(&kept);
    (0..4).for_each(|_| world.advance_frame());
    assert_eq!(bits(&world), first);
}

/// What the fibre carries is what its present rest length has it, not the drawn one.
#[test]
fn tensions_are_those_of_the_contraction() {
    let mut scene = in_space(slender(7, 1.0, 40.0));
    scene.bodies[0].regions = vec![Region::new("all", Selector::Everything)];
    scene.bodies[0].pins = vec![pin("all", &ALL, Motion::Fixed)];
    let mut runner = runner(&scene);
    runner.advance_frame();
    for tension in &runner.world().bodies()[0].tensions()[0] {
        assert!((tension / (0.25 * 40.0 * F * 0.3) - 1.0).abs() < 1e-9, "{tension} N");
    }
}

/// Scenes are taken along with everything that they hold.
#[test]
fn sets_reach_the_values_of_what_acts() {
    let scene: Scene = in_space(slender(5, Wave::new(0.4).with_wavelength(0.05), 20.0));
    let sets = [
        ("/bodies/0/fibres/0/activation/drive/wave/wavelength", "-0.05"),
        ("/bodies/0/fibres/0/activation/drive/wave/period", "0.2"),
        ("/bodies/0/fibres/0/activation/contract", "0.1"),
    ];
    let changed = sinew::io::apply_sets(&scene, sets).expect("places that are there");
    let activation = changed.bodies[0].fibres[0].activation.clone().expect("it acts");
    let expected = Activation::contracting(0.1, Wave::new(0.2).with_wavelength(-0.05));
    assert_eq!(activation, expected);
}

/// A slender rod whose one fibre curls, pulls, contracts and twists at once, by a wave along it.
pub fn all_at_once() -> Body {
    let mut rod = slender(9, Wave::new(0.03).with_wavelength(0.03), 20.0);
    rod.fibres[0].stiffness = Rigidity::new(20.0 * F, 2.0 * F * D * D).with_twisting(5.0 * F * D * D).into();
    let drive = Wave::new(0.03).with_wavelength(0.03);
    rod.fibres[0].activation = Some(Activation {
        contract: 0.2,
        twist: Activation::twisting(3000.0, 0.0).twist,
        muscle: Activation::pulling(10.0 * F, 0.0).muscle,
        ..Activation::curling(2000.0, [0.3, 0.1, 1.0], drive)
    });
    rod
}

#[test]
fn forces_of_all_that_acts_are_the_slopes_of_their_energy_and_turn_nothing() {
    for shape in [RestShape::Straight, RestShape::AsDrawn] {
        let mut rod = all_at_once();
        rod.fibres[0].rest_shape = shape;
        let world = baked(&in_space(rod)).world;
        let parts = world.bodies()[0].parts();
        let mut fibres =
            parts.forces.iter().find(|force| force.downcast_ref::<FibreForce>().is_some()).expect("fibres").clone();
        let mut state = parts.state.clone();
        for (i, x) in state.positions.iter_mut().enumerate() {
            *x += 0.1 * D * wobble(i, 3);
        }
        let time = 0.047;
        let mut forces = vec![DVec3::ZERO; state.len()];
        fibres.add_forces(time, &state, &mut forces);
        let greatest = forces.iter().map(|force| force.length()).fold(0.0, f64::max);
        let (sum, turn) = forces
            .iter()
            .zip(&state.positions)
            .fold((DVec3::ZERO, DVec3::ZERO), |(sum, turn), (f, x)| (sum + *f, turn + x.cross(*f)));
        assert!(
            greatest > 0.1 * F && sum.length() < 1e-12 * greatest && turn.length() < 1e-12 * greatest,
            "{sum}, {turn}"
        );
        let moved: Vec<DVec3> = (0..state.len()).map(|i| wobble(i, 9)).collect();
        let mut energy = |by: f64| {
            let mut state = state.clone();
            state.positions.iter_mut().zip(&moved).for_each(|(x, moved)| *x += by * D * *moved);
            fibres.add_forces(time, &state, &mut vec![DVec3::ZERO; state.len()]);
            let mut energies = Energies::default();
            fibres.add_energy(time, &state, &mut energies);
            energies.stretching + energies.bending + energies.twisting
        };
        let difference =
            |step: f64, energy: &mut dyn FnMut(f64) -> f64| (energy(step) - energy(-step)) / (2.0 * step * D);
        // Of fourth order.
        let slope = (4.0 * difference(1e-3, &mut energy) - difference(2e-3, &mut energy)) / 3.0;
        let force: f64 = forces.iter().zip(&moved).map(|(force, moved)| force.dot(*moved)).sum();
        let off = (slope + force).abs() / force.abs();
        println!("{shape:?}: {off:.1e}");
        assert!(off < 1e-10, "{shape:?}: {force} N, not {} N", -slope);
    }
}

#[test]
fn the_balance_closes_whatever_acts() {
    let scene = in_space(all_at_once());
    let stable = baked(&scene).world.bodies()[0].parts().stable_dt;
    let off = |halvings: i32| {
        let mut scene = scene.clone();
        scene.time.step = TimeStep::manual(0.4 * stable * 0.5_f64.powi(halvings), 50 << halvings);
        let mut runner = runner(&scene);
        let start = runner.world().bodies()[0].energies(0.0).total();
        (0..6).for_each(|_| runner.advance_frame());
        let energies = runner.world().bodies()[0].energies(runner.world().time());
        (energies.total() - start, energies.activation)
    };
    let found = [0, 1].map(off);
    println!("{found:?}");
    assert!(found[0].0.abs() < 0.02 * found[0].1.abs(), "{found:?}");
    assert!((found[1].0 / found[0].0 - 0.25).abs() < 0.08, "{found:?}");
}

#[test]
fn a_muscle_pulls_as_far_as_its_length_lets_it() {
    for excited in [0.05, 0.25, 0.5, 1.0] {
        let mut rod = rod([4, 13, 4]);
        let drive = DriveKeys::new([(0.0, 0.0), (0.02, excited)]);
        rod.fibres.push(upright(13, 0.0, 0.0, Activation::pulling(40.0 * F, drive)));
        let (baked, runner) = settled(rod);
        let [matrix, ..] = section_of(&baked);
        let body = &runner.world().bodies()[0];
        let all = sections(body);
        let apart = |x: &[DVec3]| center(&all[9], x).distance(center(&all[3], x));
        let strain = apart(&body.state().positions) / apart(&body.parts().rest) - 1.0;
        // E A e + l_f T0 a f(1 + e) = 0, f(s) = 1 - (2 (s - 1))²: a quadratic.
        let pull = 0.25 * 40.0 * excited;
        let expected = (matrix - (matrix * matrix + 16.0 * pull * pull).sqrt()) / (8.0 * pull);
        println!("{excited}: {:.4}", strain / expected);
        assert!((strain / expected - 1.0).abs() < 0.01, "{strain}, not {expected}");
    }
}

#[test]
fn a_muscle_that_loses_more_than_the_rest_gains_is_told_of() {
    let told = |force: f64, ea: f64| {
        let mut rod = rod([4, 7, 4]);
        rod.fibres.push(upright(7, 0.0, ea * F, Activation::pulling(force * F, 1.0)));
        baked(&in_space(rod)).notes.iter().any(|note| note.warning && note.path.ends_with("/activation/muscle"))
    };
    // E pi h² is 19.6 E D² where the support radius h is 2.5 D; 2 l_f T0 / w is T0.
    assert!(told(25.0, 0.0) && !told(15.0, 0.0) && !told(25.0, 40.0));
}
