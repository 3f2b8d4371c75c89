//! Elements that act.

use crate::common::*;
use crate::{E, element, points};
use glam::DVec3;
use sinew::scene::{Body, DriveKeys, Element, ElementActivation, ElementLaw, ElementMeasure, SharedDrive, Wave};
use sinew::sim::Runner;

fn run(body: Body, frames: u32) -> Runner {
    let mut runner = Runner::new(baked(&in_space(body)));
    for _ in 0..frames {
        runner.advance_frame();
        assert!(runner.world().divergence().is_none(), "{:?}", runner.world().divergence());
    }
    runner
}

#[test]
fn the_work_of_what_drives_elements_closes_the_balance() {
    let wave = || Wave { mean: 0.5, amplitude: 0.5, ..Wave::new(0.05) };
    let ea = 20.0 * E * D * D;
    let cases = [
        (ElementMeasure::Length, ElementLaw::spring(ea), ElementActivation::contracting(0.3, wave())),
        (ElementMeasure::Length, ElementLaw::muscle(0.5 * ea), ElementActivation::contracting(0.0, wave())),
        (ElementMeasure::Area, ElementLaw::spring(ea / D), ElementActivation::contracting(0.3, wave())),
        (ElementMeasure::Volume, ElementLaw::spring(20.0 * E), ElementActivation::contracting(0.4, wave())),
        (ElementMeasure::Turn, ElementLaw::spring(0.2 * ea * D), ElementActivation::turning(40.0, wave())),
        (ElementMeasure::Dihedral, ElementLaw::spring(0.2 * ea * D), ElementActivation::turning(40.0, wave())),
        (ElementMeasure::Twist, ElementLaw::spring(ea * D), ElementActivation::turning(40.0, wave())),
    ];
    for (measure, law, activation) in cases {
        let runner = run(block([4, 5, 4], E).with_element(element(measure, law).with_activation(activation)), 5);
        let energies = runner.world().bodies()[0].energies(runner.world().time());
        let done = -energies.activation;
        println!("{measure:?}: {done:.3e} J of the drive, {:.1e} J of them unaccounted for", energies.total());
        // A muscle that is excited while it is short has an energy below zero.
        assert!(done.abs() > 1e-6 && energies.elements != 0.0, "{measure:?}: {energies:?}");
        assert!(energies.total().abs() < 0.02 * done.abs(), "{measure:?}: {energies:?}");
        let state = runner.world().bodies()[0].state();
        let speeds: f64 = state.velocities.iter().zip(&state.masses).map(|(v, m)| v.length() * m).sum();
        assert!(state.linear_momentum().length() < 1e-12 * speeds, "{measure:?}");
    }
}

/// A measure of the body's points now.
fn distance(runner: &Runner) -> f64 {
    let of = &runner.world().bodies()[0];
    let points = &of.parts().elements[0].points;
    let [a, b] = [0, 1].map(|k: usize| points[k].gather(&of.state().positions));
    a.distance(b)
}

#[test]
fn a_rope_that_wants_to_be_shorter_draws_its_ends_together() {
    let slender = || {
        let mut body = block([4, 9, 4], E);
        body.material.damping.pair = 400.0;
        body
    };
    let ends = [[0.0, 1.5 * D, 0.0], [0.0, 7.5 * D, 0.0]];
    let keys = || DriveKeys::new([(0.0, 0.0), (0.05, 1.0)]);
    let rope = |ea: f64, shared: bool| {
        let drive: sinew::scene::Drive =
            if shared { sinew::scene::Drive::Shared("pull".into()) } else { keys().into() };
        Element::new("rope", ElementMeasure::Length, ends, ElementLaw::spring(ea))
            .with_activation(ElementActivation::contracting(0.3, drive))
    };
    let stiff = run(slender().with_element(rope(1000.0 * E * D * D, false)), 20);
    let soft = run(slender().with_element(rope(2.0 * E * D * D, false)), 20);
    let (stiff, soft) = (distance(&stiff) / (6.0 * D), distance(&soft) / (6.0 * D));
    println!("{stiff:.4} and {soft:.4} of the drawn length");
    assert!((stiff - 0.7).abs() < 0.01, "{stiff}");
    assert!((0.72..0.99).contains(&soft), "{soft}");
    let shared = slender().with_drive(SharedDrive::new("pull", keys())).with_element(rope(2.0 * E * D * D, true));
    assert_eq!(distance(&run(shared, 20)) / (6.0 * D), soft, "a shared drive is the same");
}

#[test]
fn a_twist_that_is_driven_turns_one_end_against_the_other() {
    let turned = |degrees: f64| {
        let ends = [[0.0, 1.5 * D, 0.0], [0.0, 7.5 * D, 0.0]];
        let drive = DriveKeys::new([(0.0, 0.0), (0.05, 1.0)]);
        let mut body = block([4, 9, 4], E).with_element(
            Element::new("t", ElementMeasure::Twist, ends, ElementLaw::spring(0.5 * E * D.powi(3)))
                .with_activation(ElementActivation::turning(degrees, drive)),
        );
        body.material.damping.pair = 400.0;
        let runner = run(body, 15);
        let of = &runner.world().bodies()[0];
        let angle = |layer: f64| {
            let here = (0..of.state().len()).filter(|&k| (of.parts().model[k].y / D - layer).abs() < 0.1);
            let turns = here.map(|k| {
                let (x, y) = (of.parts().model[k], of.state().positions[k]);
                (y.x * x.z - y.z * x.x) / (x.x * x.x + x.z * x.z)
            });
            let turns: Vec<f64> = turns.collect();
            turns.iter().sum::<f64>() / turns.len() as f64
        };
        (angle(7.5) - angle(1.5)).to_degrees()
    };
    let (left, right) = (turned(60.0), turned(-60.0));
    println!("{left:.3} and {right:.3} degrees");
    assert!(left > 2.0 && (left + right).abs() < 0.02 * left, "{left} and {right}");
}

#[test]
fn points_and_lines_of_elements_are_in_the_snapshot() {
    use sinew::solver::Snapshot;
    let body = block([4, 5, 4], E).with_element(element(ElementMeasure::Volume, ElementLaw::spring(1.0)));
    let runner = run(body, 0);
    let snapshot = Snapshot::of(runner.world());
    let [of] = snapshot.bodies[0].elements.as_slice() else { panic!("one element") };
    assert_eq!((of.id.as_str(), of.lines.len()), ("e", 6));
    for (found, drawn) in of.points.iter().zip(points(ElementMeasure::Volume)) {
        assert!(found.distance(DVec3::from_array(drawn)) < 1e-15);
    }
    let moved = snapshot.bodies[0].moved(DVec3::X);
    assert_eq!(moved.elements[0].points[0], of.points[0] + DVec3::X);
}
