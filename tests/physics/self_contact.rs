//! Bodies that touch themselves: nothing passes through, nothing is gained, and what does not touch moves as ever.

use crate::common::*;
use crate::two_layer::{ring, two_layer, with};
use glam::DVec3;
use serde_json::json;
use sinew::scene::{Impulse, Region, Scene, TimeStep, Void};
use sinew::sim::Runner;

/// Speed of a push along a thin bar [m/s].
fn sound(young_modulus: f64) -> f64 {
    (young_modulus * D.powi(3) / 4e-4).sqrt()
}

/// A U of two arms three layers thick and eight high, which lie `apart` layers from each other, on a base of three;
/// they are thrown together at a share of the speed of sound, and float.
fn clap(young_modulus: f64, apart: u32, share: f64, self_contact: bool) -> Scene {
    let half = 0.5 * f64::from(apart) * D;
    let mut body = block([6 + apart, 11, 3], young_modulus);
    body.voids = vec![Void::in_box("slot", [-half, 3.0 * D, -3.0 * D], [half, 12.0 * D, 3.0 * D])];
    let arm = |id, left: f64, right: f64| Region::in_box(id, [left, 7.0 * D, -9.0 * D], [right, 12.0 * D, 9.0 * D]);
    body.regions = vec![arm("left", -9.0 * D, 0.0), arm("right", 0.0, 9.0 * D)];
    // Four layers of three by three particles.
    let push = 36.0 * 4e-4 * share * sound(young_modulus);
    body.impulses = vec![Impulse::new("left", [push, 0.0, 0.0]), Impulse::new("right", [-push, 0.0, 0.0])];
    body.self_contact = self_contact;
    let mut scene = in_space(body);
    scene.room.contact_damping = 0.0;
    scene.time.frames_per_second = 2000.0;
    scene
}

/// Pairs of particles that lie mirrored about zero along an axis at rest, and further than `beyond` [m] from each
/// other.
fn mirrored(rest: &[DVec3], axis: DVec3, beyond: f64) -> Vec<[usize; 2]> {
    let mirror = |x: DVec3| x - 2.0 * x.dot(axis) * axis;
    let partner = |x: DVec3| rest.iter().position(|y| y.distance(mirror(x)) < 1e-9);
    let pairs = rest.iter().enumerate().filter(|(_, x)| 2.0 * x.dot(axis) > beyond);
    pairs.filter_map(|(i, &x)| Some([partner(x)?, i])).collect()
}

/// Least distance [m] by which the second of each pair is beyond the first along an axis.
fn least_gap(runner: &Runner, pairs: &[[usize; 2]], axis: DVec3) -> f64 {
    let x = &runner.world().bodies()[0].state().positions;
    pairs.iter().map(|&[a, b]| (x[b] - x[a]).dot(axis)).fold(f64::INFINITY, f64::min)
}

/// What is left of a body's energy [J], and its momenta about the origin [N s], [N m s].
fn kept(runner: &Runner) -> (f64, DVec3, DVec3) {
    let body = &runner.world().bodies()[0];
    let energy = body.energies(runner.world().time()).total();
    (energy, body.state().linear_momentum(), body.state().angular_momentum())
}

/// The least gap between the arms of a U while they clap [m], and the energies at the start and at the end [J].
fn clapped(apart: u32, share: f64, self_contact: bool) -> (f64, [f64; 2]) {
    let young_modulus = 1e5;
    let mut runner = runner(&clap(young_modulus, apart, share, self_contact));
    let rest = runner.world().bodies()[0].parts().rest.to_vec();
    let pairs: Vec<_> = mirrored(&rest, DVec3::X, 0.0).into_iter().filter(|&[_, i]| rest[i].y > 3.0 * D).collect();
    assert!(pairs.len() >= 72, "two arms of three by eight by three");
    let start = kept(&runner);
    let mut least = f64::INFINITY;
    for _ in 0..runner.frames_for(60.0 * D / sound(young_modulus)) {
        runner.advance_frame();
        least = least.min(least_gap(&runner, &pairs, DVec3::X));
    }
    assert!(runner.world().divergence().is_none(), "{:?}", runner.world().divergence());
    let end = kept(&runner);
    let moved: f64 = 4e-4 * 72.0 * share * sound(young_modulus);
    assert!((end.1 - start.1).length() < 1e-12 * moved, "momentum {:?}", end.1 - start.1);
    assert!((end.2 - start.2).length() < 1e-11 * moved * D, "angular momentum {:?}", end.2 - start.2);
    (least, [start.0, end.0])
}

#[test]
fn arms_that_are_thrown_together_stay_apart_and_gain_nothing() {
    for (apart, share) in [(3, 0.15), (3, 0.4), (5, 0.3)] {
        let (least, [before, after]) = clapped(apart, share, true);
        println!("{apart} layers apart at {share} c: {} D, energy {before} to {after} J", least / D);
        assert!(least > 0.1 * D, "{apart} layers apart at {share} c: {} D", least / D);
        // Leap-frog's own energy swings by as much at this step.
        assert!((after / before - 1.0).abs() < 0.005, "{apart} at {share}: {before} to {after} J");
    }
    let (through, _) = clapped(3, 0.4, false);
    assert!(through < -D, "without contact they pass through each other: {} D", through / D);
}

#[test]
fn a_slot_of_two_layers_does_not_touch_at_rest() {
    let mut scene = clap(1e5, 2, 0.0, true);
    scene.bodies[0].impulses.clear();
    let mut still = runner(&scene);
    for _ in 0..20 {
        still.advance_frame();
    }
    let body = &still.world().bodies()[0];
    assert_eq!(body.energies(still.world().time()).contact, 0.0);
    let speeds = body.state().velocities.iter().map(|v| v.length()).fold(0.0, f64::max);
    assert!(speeds < 1e-9, "{speeds} m/s");
}

#[test]
fn what_never_meets_moves_as_without_it_at_the_same_step() {
    let moved = |self_contact| {
        let mut scene = clap(1e5, 5, 0.02, self_contact);
        scene.time.step = TimeStep::manual(1e-5, 50);
        let mut runner = runner(&scene);
        for _ in 0..15 {
            runner.advance_frame();
        }
        runner.world().bodies()[0].state().positions.clone()
    };
    assert_eq!(moved(true), moved(false), "bit for bit");
}

/// A ring whose upper and lower half are thrown at each other.
fn squeezed(self_contact: bool) -> f64 {
    let halves = json!([
        {"id": "above", "select": {"box": {"min": [-3, 0, -1], "max": [3, 3, 1]}}},
        {"id": "below", "select": {"box": {"min": [-3, -3, -1], "max": [3, 0, 1]}}}]);
    let fields = json!({"shape": {"ring": {"sides": 20}}, "pressure": 0, "regions": halves, "self_contact": self_contact,
        "impulses": [{"region": "above", "impulse": [0, -200, 0]}, {"region": "below", "impulse": [0, 200, 0]}]});
    let room = json!({"gravity": [0, 0, 0], "room": {"floor": null}, "time": {"frames_per_second": 500}});
    let mut runner = runner(&two_layer(&[with(ring(), fields)], room));
    let rest = runner.world().bodies()[0].parts().rest.to_vec();
    let pairs = mirrored(&rest, DVec3::Y, 0.5);
    assert!(pairs.len() > 12, "of forty particles: {}", pairs.len());
    let mut least = f64::INFINITY;
    for _ in 0..500 {
        runner.advance_frame();
        least = least.min(least_gap(&runner, &pairs, DVec3::Y));
    }
    assert!(runner.world().divergence().is_none(), "{:?}", runner.world().divergence());
    println!("least gap of the ring {least} m");
    least
}

#[test]
fn a_ring_that_is_squeezed_flat_keeps_its_layers() {
    assert!(squeezed(false) < -0.05, "without contact its halves pass through each other");
    assert!(squeezed(true) > 0.05);
}
