//! Under which steps what is driven holds, and which steps are taken.

use crate::common::*;
use crate::fibres::{E, F, rod, upright};
use sinew::scene::{
    Activation, Body, Drive, DriveKeys, DrivenMotion, Fibre, IntegratorChoice, IntegratorKind, Motion, Rigidity, Scene,
    Side, Stiffness, TimeStep, TwoLayer, Wave, Wind,
};
use sinew::sim::Runner;
use sinew::solver::BodyParts;

fn held(mut body: Body) -> Body {
    body.regions = vec![layers("foot", sinew::scene::Axis::Y, Side::Min, 1)];
    body.pins = vec![pin("foot", &ALL, Motion::Fixed)];
    body
}

fn parts(scene: &Scene) -> BodyParts {
    baked(scene).world.bodies()[0].parts().clone()
}

/// Implicit steps that were halved or handed over in so many frames.
fn given_up(scene: &Scene, frames: usize) -> u64 {
    let mut runner = runner(scene);
    (0..frames).for_each(|_| runner.advance_frame());
    let fallbacks = runner.world().bodies()[0].fallbacks();
    fallbacks.halved + fallbacks.handed_over
}

#[test]
fn implicit_steps_bear_a_steady_wind() {
    let mut body = held(block([3, 9, 3], 1e4));
    body.integrator = IntegratorChoice::Given(IntegratorKind::TrBdf2);
    assert_eq!(given_up(&in_space(body).with_wind(Wind::new([6.0, 0.0, 0.0])), 8), 0);
}

#[test]
fn implicit_steps_bear_what_a_drive_has_done() {
    let drive = DriveKeys::new([(0.0, 0.0), (0.01, 1.0)]);
    let mut body = held(rod([3, 7, 3]));
    body.fibres.push(upright(7, 0.5 * D, 20.0 * F, Activation::contracting(0.3, drive)));
    body.integrator = IntegratorChoice::Given(IntegratorKind::Newmark);
    let mut scene = in_space(body);
    scene.time.step = TimeStep::manual(4.0 * parts(&scene).explicit_dt, 20);
    assert_eq!(given_up(&scene, 12), 0);
}

#[test]
fn the_step_of_a_two_layer_body_holds_in_water() {
    let mut ball = TwoLayer::ball("ball");
    ball.initial.velocity = [0.8, 0.0, 0.0];
    let still = Scene::new("ball").with_gravity([0.0; 3]).with_two_layer(ball);
    let scene = still.clone().with_wind(Wind { density: 2e5, ..Wind::water() });
    let (dry, wet) = (parts(&still), parts(&scene));
    assert!(wet.stable_dt < 0.5 * dry.stable_dt, "{} s, dry {} s", wet.stable_dt, dry.stable_dt);
    assert_eq!(wet.limited_by.as_deref(), Some("/wind/density"));
    let mut runner = runner(&scene);
    (0..3).for_each(|_| runner.advance_frame());
    let energies = runner.world().bodies()[0].energies(runner.world().time());
    let first = dry.state.kinetic_energy();
    assert!(runner.world().divergence().is_none() && energies.kinetic < 0.5 * first, "{} J", energies.kinetic);
}

#[test]
fn the_step_of_a_ball_holds_while_its_springs_squeeze_the_gas() {
    let [still, small] = [0.0, 0.6].map(|contract| parts(&squeezed(contract)).stable_dt);
    let ratio = still / small;
    println!("{still} s, squeezed {small} s");
    assert!(ratio > 1.1, "{ratio}");
    let run = |share: f64| {
        let mut scene = squeezed(0.6);
        scene.time.step = TimeStep::manual(share * small, 60);
        let mut runner = runner(&scene);
        (0..40).for_each(|_| runner.advance_frame());
        runner.world().divergence().is_none() && runner.world().unbalanced().is_empty()
    };
    assert!(run(0.99), "it does not hold");
}

#[test]
fn the_step_looks_at_the_strongest_wind_either_way_and_names_it() {
    let step = |last: f64| {
        let wind = Wind { density: 2e4, ..Wind::new([3.0, 0.0, 0.0]) };
        parts(&in_space(block([3, 5, 3], 1e5)).with_wind(wind.with_drive(DriveKeys::new([(0.0, 0.0), (1.0, last)]))))
    };
    let (ahead, back, calm) = (step(10.0), step(-10.0), step(0.0));
    assert_eq!(ahead.stable_dt, back.stable_dt);
    assert!(back.stable_dt < 0.5 * calm.stable_dt);
    assert_eq!(back.limited_by.as_deref(), Some("/wind/density"));
}

#[test]
fn what_is_driven_or_blown_at_is_not_stepped_in_long_steps() {
    let word = |change: fn(&mut Scene)| {
        let mut scene = in_space(held(block([2, 5, 2], 4e9))).with_gravity([0.0, -9.81, 0.0]);
        change(&mut scene);
        parts(&scene).integrator_word
    };
    assert_eq!(word(|_| ()), IntegratorKind::TrBdf2.word());
    let changes: [fn(&mut Scene); 3] = [
        |scene| scene.gravity_drive = Some(Wave::new(0.1).into()),
        |scene| scene.wind = Some(Wind::new([1.0, 0.0, 0.0])),
        |scene| {
            scene.bodies[0].regions.push(layers("head", sinew::scene::Axis::Y, Side::Max, 1));
            let motion = DrivenMotion::new(Wave::new(0.1), [0.001, 0.0, 0.0]);
            scene.bodies[0].pins.push(pin("head", &ALL, motion.into()));
        },
    ];
    for change in changes {
        assert_eq!(word(change), IntegratorKind::LeapFrog.word());
    }
}

/// The greatest kinetic energy over the work of the drive while a rod whose fibre resists bending shortens on a floor,
/// in steps of so much of the stable one.
fn liveliest(contract: f64, bending: f64, drive: Drive, share: f64) -> f64 {
    let mut rod = rod([3, 7, 3]);
    let mut fibre = upright(7, 0.5 * D, 40.0 * F, Activation::contracting(contract, drive));
    fibre.stiffness = rigidity(40.0 * F, bending * F * D * D);
    rod.fibres.push(fibre);
    let mut scene = in_space(rod).with_gravity([0.0, -9.81, 0.0]).with_floor(0.0);
    scene.time.step = TimeStep::manual(share * parts(&scene).stable_dt, 100);
    let mut runner = runner(&scene);
    (0..25).for_each(|_| runner.advance_frame());
    let energies = runner.world().bodies()[0].energies(runner.world().time());
    let diverged = runner.world().divergence().is_some();
    if diverged { f64::INFINITY } else { energies.kinetic / energies.activation.abs() }
}

#[test]
fn the_stable_step_holds_where_a_fibre_that_resists_bending_shortens_on_a_floor() {
    let period = 40.0 * D / (E / 1852.0_f64).sqrt();
    for (contract, bending) in [(0.8, 2.0), (0.8, 20.0), (0.5, 20.0), (-0.5, 20.0), (0.8, 80.0)] {
        let drives: [Drive; 2] =
            [Wave::new(period).with_wavelength(9.0 * D).into(), DriveKeys::new([(0.0, 0.0), (0.02, 1.0)]).into()];
        for drive in drives {
            let found = liveliest(contract, bending, drive, 0.98);
            println!("{contract} {bending}: {found:.3}");
            assert!(found < 2.0, "{contract} {bending}: {found}");
        }
    }
}

#[test]
fn what_acts_moves_to_the_same_bits_on_any_number_of_threads() {
    let run = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
        pool.install(|| {
            let mut body = rod([7, 13, 7]);
            let wave = || Wave::new(0.03).with_wavelength(0.05);
            let activation = Activation { contract: 0.2, ..Activation::curling(900.0, [0.0, 0.3, 1.0], wave()) };
            body.fibres.push(upright(13, 1.5 * D, 20.0 * F, activation));
            body.fibres.push(upright(13, -1.5 * D, 0.0, Activation::pulling(20.0 * F, wave())));
            body.fibres[1].id = "other".to_owned();
            let mut runner: Runner = runner(&in_space(body).with_wind(Wind::water()));
            (0..2).for_each(|_| runner.advance_frame());
            let body = &runner.world().bodies()[0];
            let mut bits: Vec<u64> =
                body.state().positions.iter().flat_map(glam::DVec3::to_array).map(f64::to_bits).collect();
            bits.extend(body.energies(runner.world().time()).values().map(f64::to_bits));
            bits
        })
    };
    let one = run(1);
    assert!(run(2) == one && run(5) == one);
}

/// The greatest kinetic energy [J] that a scene comes to in so many steps of a share of its stable one, all driven up
/// to 1 within the first of them.
fn greatest_energy(mut scene: Scene, share: f64) -> f64 {
    scene.time.step = TimeStep::manual(share * parts(&scene).stable_dt, 50);
    let mut runner = runner(&scene);
    let mut greatest = 0.0_f64;
    for _ in 0..16 {
        runner.advance_frame();
        if runner.world().divergence().is_some() {
            return f64::INFINITY;
        }
        greatest = greatest.max(runner.world().bodies()[0].state().kinetic_energy());
    }
    greatest
}

#[test]
fn a_ball_that_its_gas_bursts_open_holds_at_the_automatic_step() {
    for pressure in [2e4, 5e5, 1e6, 5e6] {
        let ball = TwoLayer { pressure, ..TwoLayer::ball("ball") };
        let mut scene = Scene::new("ball").with_gravity([0.0; 3]).with_two_layer(ball);
        let of = parts(&scene);
        if pressure > 1e5 {
            assert_eq!(of.limited_by.as_deref(), Some("/two_layer/0/pressure"));
        }
        scene.time.step = TimeStep::manual(0.98 * of.stable_dt, 10);
        let mut runner = runner(&scene);
        (0..30).for_each(|_| runner.advance_frame());
        let world = runner.world();
        assert!(world.divergence().is_none(), "{pressure}: {:?}", world.divergence().map(ToString::to_string));
        assert!(world.unbalanced().is_empty(), "{pressure}: {:?}", world.unbalanced());
    }
}

/// Pressed onto a floor by its weight.
fn standing(scene: Scene) -> Scene {
    scene.with_gravity([0.0, -9.81, 0.0]).with_floor(0.0)
}

/// A ball full of gas whose springs all shorten by this share.
fn squeezed(contract: f64) -> Scene {
    let mut ball = TwoLayer { pressure: 2e4, kd: 1.0, rkd: 1.0, air_drag: 0.5, ..TwoLayer::ball("ball") };
    let come = DriveKeys::new([(0.0, 0.0), (0.05, 1.0)]);
    ball.active_springs = vec![sinew::scene::ActiveSprings::new("all", "everything", contract, come)];
    Scene::new("ball").with_gravity([0.0; 3]).with_two_layer(ball)
}

/// A ball that stands at the height of the floor.
fn on_its_foot(mut scene: Scene) -> Scene {
    scene.two_layer[0].placement.translation = [0.0, 2.0, 0.0];
    scene
}

/// Ways to act, each in a body of its own, some of them on a floor.
fn that_act() -> Vec<(&'static str, Scene)> {
    let drive = || Drive::from(DriveKeys::new([(0.0, 0.0), (0.01, 1.0)]));
    let fibre = |x: f64, ea: f64, activation: Activation| upright(7, x, ea * F, activation);
    let bending = |ei: f64, gj: f64, activation: Activation| {
        let mut fibre = fibre(0.5 * D, 20.0, activation);
        let mut stiffness = Rigidity::new(20.0 * F, ei * F * D * D);
        stiffness.gj = gj * F * D * D;
        fibre.stiffness = Stiffness::Rigidity(stiffness);
        fibre
    };
    let scene = |layers: [u32; 3], fibres: Vec<Fibre>| {
        let mut body = rod(layers);
        body.fibres = fibres;
        in_space(body)
    };
    let contract = |share: f64| Activation::contracting(share, drive());
    let wave = Activation::contracting(0.6, Wave::new(0.01).with_wavelength(4.0 * D));
    let named = |id: &str, fibre: Fibre| Fibre { id: id.to_owned(), ..fibre };
    let zigzag: Vec<[f64; 3]> =
        (0..7).map(|k| [if k % 2 == 0 { 0.4 * D } else { -0.4 * D }, (f64::from(k) - 3.0) * 0.95 * D, 0.0]).collect();
    vec![
        ("shorter", scene([3, 7, 3], vec![fibre(0.5 * D, 40.0, contract(0.5))])),
        ("much shorter", scene([3, 7, 3], vec![fibre(0.0, 120.0, contract(0.8))])),
        ("longer", scene([3, 7, 3], vec![fibre(0.5 * D, 40.0, contract(-0.5))])),
        ("a wave", scene([3, 7, 3], vec![fibre(0.5 * D, 60.0, wave)])),
        (
            "two that cross the section",
            scene(
                [4, 7, 3],
                vec![fibre(0.9 * D, 40.0, contract(0.3)), named("other", fibre(-0.9 * D, 80.0, contract(0.6)))],
            ),
        ),
        ("a muscle", scene([3, 7, 3], vec![fibre(0.5 * D, 60.0, Activation::pulling(6.0 * F, drive()))])),
        ("a curl", scene([3, 7, 3], vec![bending(20.0, 0.0, Activation::curling(600.0, [0.0, 0.0, 1.0], drive()))])),
        ("a twist", scene([3, 7, 3], vec![bending(1.0, 100.0, Activation::twisting(900.0, drive()))])),
        (
            "a zigzag",
            scene(
                [3, 7, 3],
                vec![Fibre { source: sinew::scene::FibreSource::Vertices(zigzag), ..fibre(0.0, 60.0, contract(0.4)) }],
            ),
        ),
        ("a thick rod", scene([5, 7, 5], vec![fibre(1.5 * D, 300.0, contract(0.5))])),
        ("on a floor", standing(scene([3, 7, 3], vec![fibre(0.5 * D, 60.0, contract(0.5))]))),
        ("a thick rod on a floor", standing(scene([5, 7, 5], vec![fibre(1.5 * D, 300.0, contract(0.3))]))),
        ("springs", squeezed(0.6)),
        ("springs on a floor", standing(on_its_foot(squeezed(0.6)))),
    ]
}

#[test]
fn the_stable_step_is_no_longer_than_the_true_limit_and_no_shorter_than_four_fifths_of_it() {
    for (name, scene) in that_act() {
        let [bounded, beyond] = [1.0, 1.25].map(|share| greatest_energy(scene.clone(), share));
        let small = greatest_energy(scene.clone(), 0.3);
        println!("{name}: {small:.3e} J in small steps, {bounded:.3e} J at the bound, {beyond:.3e} J beyond");
        assert!(bounded < 3.0 * small, "{name}: {bounded} J at the bound, {small} J in small steps");
        assert!(beyond > 30.0 * small, "{name}: {beyond} J beyond the limit, {small} J in small steps");
    }
}
