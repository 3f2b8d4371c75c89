//! The stable step under elements, and the same bits on any number of threads.

use crate::common::*;
use crate::{E, element, laws};
use sinew::scene::{
    Body, DriveKeys, Element, ElementActivation, ElementLaw, ElementMeasure, IntegratorKind, Manual, Scene, TimeStep,
    Wave,
};
use sinew::sim::{Report, Runner};
use sinew::solver::World;

fn step(mut body: Body) -> f64 {
    body.integrator = IntegratorKind::LeapFrog.into();
    baked(&in_space(body)).world.bodies()[0].parts().stable_dt
}

/// Growth of the energy over two thousand steps of this share of the stable one.
fn growth(body: &Body, share: f64) -> f64 {
    let dt = share * step(body.clone());
    let mut scene = in_space(body.clone());
    scene.bodies[0].integrator = IntegratorKind::LeapFrog.into();
    let extra = std::collections::BTreeMap::new();
    scene.time.step = TimeStep::Manual(Manual { dt, substeps_per_frame: 200, extra });
    let mut runner = Runner::new(baked(&scene));
    let energy = |runner: &Runner| runner.world().bodies()[0].energies(runner.world().time()).total();
    let before = energy(&runner);
    for _ in 0..10 {
        runner.advance_frame();
        if let Some(why) = runner.world().divergence() {
            println!("{why:?}");
            return f64::INFINITY;
        }
    }
    energy(&runner) / before
}

fn rope(law: ElementLaw) -> Element {
    Element::new("rope", ElementMeasure::Length, [[0.5 * D, 1.5 * D, 0.5 * D], [0.5 * D, 3.5 * D, 0.5 * D]], law)
}

/// Stretched along the rope, and with some of every mode.
fn stretched(element: Element, by: f64) -> Body {
    let mut body = block([4, 5, 4], E).with_element(element);
    body.initial.deformation = [[1.0, 1e-4, 0.0], [0.0, by, 1e-4], [1e-4, 0.0, 0.9999]];
    body
}

#[test]
fn the_step_is_the_limit_under_a_stiff_rope() {
    let ea = 200.0 * E * D * D;
    let resting = stretched(rope(ElementLaw::spring(ea)), 1.0002);
    assert!(step(resting.clone()) < 0.7 * step(block([4, 5, 4], E)), "the rope sets it");
    let (below, above) = (growth(&resting, 0.98), growth(&resting, 1.03));
    println!("growth of the energy {below:.3} below the limit, {above:.3e} above");
    assert!(below < 2.0 && above > 10.0, "{below} below, {above} above");
}

#[test]
fn the_step_holds_where_a_table_is_steepest_though_it_begins_soft() {
    let ea = 200.0 * E * D * D;
    // It is drawn into the steep part, and stays there: at the kink any step in proportion to the stiffness pumps.
    let activation = ElementActivation::contracting(0.01, DriveKeys::new([(0.0, 0.0), (0.1, 1.0)]));
    // A hundred times stiffer from 0.1 % on.
    let law = || ElementLaw::Table(vec![[0.5, -0.005 * ea], [1.0, 0.0], [1.001, 1e-5 * ea], [2.0, 0.99901 * ea]]);
    let pulled = stretched(rope(law()).with_activation(activation), 1.0);
    let spring = step(stretched(rope(ElementLaw::spring(ea)), 1.0));
    assert!((step(pulled.clone()) / spring - 1.0).abs() < 0.01, "as if it were as steep everywhere");
    // What it has to do with is the work of the drive.
    let (below, above) = (growth(&pulled, 0.97), growth(&pulled, 1.03));
    println!("growth of the energy {below:.3} below the limit, {above:.3e} above");
    assert!(below.is_finite() && above.is_infinite(), "{below} below, {above} above");
}

#[test]
fn no_drive_of_a_rope_changes_its_step() {
    let ea = 200.0 * E * D * D;
    let acting = |contract: f64| {
        let activation = ElementActivation::contracting(contract, 1.0);
        step(block([4, 5, 4], E).with_element(rope(ElementLaw::spring(ea)).with_activation(activation)))
    };
    let steps = [0.0, 0.4, 0.8, -0.5].map(acting);
    assert!(steps.iter().all(|&of| (of / steps[0] - 1.0).abs() < 1e-6), "{steps:?}");
    let shortened = {
        let activation = ElementActivation::contracting(0.3, Wave { mean: 0.5, amplitude: 0.5, ..Wave::new(0.01) });
        stretched(rope(ElementLaw::spring(ea)).with_activation(activation), 1.0002)
    };
    let energy = growth(&shortened, 0.98);
    assert!(energy.is_finite(), "{energy}");
}

#[test]
fn a_step_that_elements_set_is_said_to_be_theirs() {
    for measure in ElementMeasure::ALL {
        let stiff = match measure {
            ElementMeasure::Length => 1e5 * E * D * D,
            ElementMeasure::Area => 1e5 * E * D,
            ElementMeasure::Volume => 1e5 * E,
            _ => 1e5 * E * D.powi(3),
        };
        let scene = in_space(block([4, 5, 4], E).with_element(element(measure, ElementLaw::spring(stiff))));
        let baked = baked(&scene);
        let set_by = baked.world.bodies()[0].parts().limited_by.as_deref();
        assert_eq!(set_by, Some("/bodies/0/elements"), "{measure:?}");
    }
}

/// A block with elements of every kind, some that act, and a speed.
fn lively() -> Scene {
    let mut body = block([5, 6, 5], E);
    for measure in ElementMeasure::ALL {
        for (what, law) in laws(measure) {
            let mut one = element(measure, law);
            one.id = format!("{measure:?} {what}");
            body = body.with_element(one);
        }
    }
    let wave = Wave { mean: 0.5, amplitude: 0.5, ..Wave::new(0.05) };
    body.elements[0].activation = Some(ElementActivation::contracting(0.2, wave));
    body.initial.angular_velocity = [0.0, 0.0, 400.0];
    in_space(body)
}

fn hash(scene: &Scene, frames: u32) -> String {
    let mut runner = Runner::new(baked(scene));
    (0..frames).for_each(|_| runner.advance_frame());
    Report::new(scene, &runner, 1.0, Vec::new()).bodies[0].state_hash.clone()
}

#[test]
fn threads_change_no_bit_and_neither_does_an_element_that_does_nothing() {
    let hashes = [1, 2, 5].map(|threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
        pool.install(|| hash(&lively(), 2))
    });
    assert!(hashes[0] == hashes[1] && hashes[1] == hashes[2]);
    let mut without = lively();
    without.bodies[0].elements.clear();
    let (bare, with) = (hash(&without, 1), hash(&lively(), 1));
    assert_ne!(bare, with);
    without.bodies[0].elements = vec![element(ElementMeasure::Length, ElementLaw::spring(0.0))];
    assert_eq!(bare, hash(&without, 1));
}

#[test]
fn implicit_integrators_step_elements_too() {
    let mut scene = lively();
    scene.bodies[0].integrator = IntegratorKind::ImplicitMidpoint.into();
    let mut runner = Runner::new(baked(&scene));
    runner.advance_frame();
    let body = &runner.world().bodies()[0];
    assert!(body.divergence().is_none() && body.energies(runner.world().time()).elements != 0.0);
}

#[test]
fn a_checkpoint_has_all_that_elements_go_on_from() {
    let mut world = baked(&lively()).world;
    world.advance_frame();
    let at = world.checkpoint();
    let on = |world: &mut World| {
        world.advance_frame();
        let body = &world.bodies()[0];
        (body.state().positions.clone(), body.energies(world.time()))
    };
    let once = on(&mut world);
    world.advance_frame();
    world.go_back(&at);
    assert_eq!(on(&mut world), once);
}
