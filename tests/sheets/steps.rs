//! The stable step under sheets, and the same bits whatever runs beside.

use crate::common::*;
use sinew::scene::{
    Activation, Body, GrainAlong, IntegratorKind, Manual, RestShape, Scene, Sheet, SheetActivation, SheetStiffness,
    TimeStep, Wave,
};
use sinew::sim::{Report, Runner};

const E: f64 = 1e5;

/// A sheet in the plane x = 0 of a block, as wide as the particles.
fn middle(layers: [u32; 3], stiffness: SheetStiffness) -> Sheet {
    let [_, along, across] = layers.map(f64::from);
    let rows = (0..layers[1]).map(|k| {
        let row = (0..layers[2]).map(|i| [0.0, D * (f64::from(k) + 0.5), D * (f64::from(i) - 0.5 * (across - 1.0))]);
        row.collect()
    });
    assert!(along > 1.0);
    Sheet::grid("s", rows.collect()).with_stiffness(stiffness).with_volume_fraction(0.25)
}

fn step(body: Body) -> f64 {
    let mut body = body;
    body.integrator = IntegratorKind::LeapFrog.into();
    baked(&in_space(body)).world.bodies()[0].parts().stable_dt
}

#[test]
fn stiffer_sheets_shorten_the_step_as_measured() {
    let layers = [5, 7, 5];
    let matrix = step(block(layers, E));
    let of = |stiffness: SheetStiffness| matrix / step(block(layers, E).with_sheet(middle(layers, stiffness)));
    let (et, db) = (4.0 * E * D, 4.0 * E * D.powi(3));
    for (what, found, expected) in [
        ("l_s Et = 2.5", of(SheetStiffness::new(2.5 * et, 0.0)), 1.03),
        ("l_s Et = 25", of(SheetStiffness::new(25.0 * et, 0.0)), 1.71),
        ("l_s Db = 2.5", of(SheetStiffness::new(0.0, 2.5 * db)), 1.05),
        ("l_s Db = 25", of(SheetStiffness::new(0.0, 25.0 * db)), 2.25),
    ] {
        println!("{what}: {found:.3} times the frequency");
        assert!((found / expected - 1.0).abs() < 0.1, "{what}: {found}, not {expected}");
    }
}

/// Growth of the energy over some hundred steps of this share of the stable one, from random speeds.
fn growth(body: &Body, share: f64) -> f64 {
    let dt = share * step(body.clone());
    let mut scene = in_space(body.clone());
    scene.bodies[0].integrator = IntegratorKind::LeapFrog.into();
    scene.time.step =
        TimeStep::Manual(Manual { dt, substeps_per_frame: 200, extra: std::collections::BTreeMap::new() });
    let mut runner = Runner::new(baked(&scene));
    let energy = |runner: &Runner| {
        let energies = runner.world().bodies()[0].energies(runner.world().time());
        energies.total()
    };
    let before = energy(&runner);
    for _ in 0..10 {
        runner.advance_frame();
        if runner.world().divergence().is_some() {
            return f64::INFINITY;
        }
    }
    energy(&runner) / before
}

#[test]
fn the_step_is_the_limit_also_where_a_sheet_acts() {
    let layers = [4, 5, 4];
    let stiff = SheetStiffness::new(100.0 * E * D, 20.0 * E * D.powi(3)).with_grain(GrainAlong::First, 50.0 * E * D);
    let mut resting = block(layers, E).with_sheet(middle(layers, stiff.clone()));
    // Every mode has some of it.
    resting.initial.deformation = [[1.0, 1e-4, 0.0], [0.0, 1.0002, 1e-4], [1e-4, 0.0, 0.9999]];
    let (below, above) = (growth(&resting, 0.97), growth(&resting, 1.05));
    println!("growth of the energy {below:.3} below the limit, {above:.3e} above");
    assert!(below < 2.0 && above > 10.0, "{below} below, {above} above");
    let acting = |greatest: f64| {
        let activation = SheetActivation::contracting([0.3, 0.3], greatest);
        step(block(layers, E).with_sheet(middle(layers, stiff.clone()).with_activation(activation)))
    };
    assert!(acting(1.0) < acting(0.0), "a sheet that wants to be smaller is stiffer");
}

#[test]
fn a_step_that_sheets_set_is_said_to_be_theirs() {
    let layers = [4, 5, 4];
    let mut body = block(layers, E).with_sheet(middle(layers, SheetStiffness::new(1e6 * E * D, 0.0)));
    body.sheets.insert(0, Sheet { id: "soft".into(), ..middle(layers, SheetStiffness::new(E * D, 0.0)) });
    let baked = baked(&in_space(body));
    assert_eq!(baked.world.bodies()[0].parts().limited_by.as_deref(), Some("/bodies/0/sheets/1/stiffness"));
}

/// A block with a sheet that acts, a fibre, and a speed.
fn lively() -> Scene {
    let layers = [5, 6, 5];
    let stiff = SheetStiffness::new(20.0 * E * D, E * D.powi(3)).with_grain(GrainAlong::Second, 10.0 * E * D);
    let activation = SheetActivation::contracting([0.2, 0.0], Wave { mean: 0.5, amplitude: 0.5, ..Wave::new(0.05) });
    let mut body = block(layers, E).with_sheet(middle(layers, stiff).with_activation(activation));
    let line = (0..6).map(|k| [D, D * (f64::from(k) + 0.5), 0.0]).collect();
    let pull = Activation::contracting(0.1, 1.0);
    body.fibres = vec![fibre("f", line, rigidity(20.0, 1e-5), 0.3, RestShape::Straight).with_activation(pull)];
    body.initial.angular_velocity = [0.0, 0.0, 400.0];
    in_space(body)
}

fn hash(scene: &Scene, frames: u32) -> String {
    let mut runner = Runner::new(baked(scene));
    (0..frames).for_each(|_| runner.advance_frame());
    Report::new(scene, &runner, 1.0, Vec::new()).bodies[0].state_hash.clone()
}

#[test]
fn threads_change_no_bit_and_neither_does_a_sheet_of_no_share() {
    let hashes = [1, 3].map(|threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
        pool.install(|| hash(&lively(), 3))
    });
    assert_eq!(hashes[0], hashes[1]);
    let mut without = lively();
    without.bodies[0].sheets.clear();
    let mut shareless = lively();
    shareless.bodies[0].sheets[0].volume_fraction = 0.0;
    assert_eq!(hash(&without, 2), hash(&shareless, 2));
    assert_ne!(hash(&without, 2), hash(&lively(), 2));
}
