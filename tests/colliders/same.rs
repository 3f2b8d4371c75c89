//! The same bits whatever runs them, and none of another scene's.

use crate::common::*;
use sinew::scene::{Collider, Ramp};
use sinew::sim::{Report, Runner};

fn scene() -> sinew::scene::Scene {
    let body = block([4, 5, 4], 1e5).with_velocity([0.2, -1.0, 0.0]);
    let step = Collider::cuboid("step", [0.05, 0.02, 0.08])
        .with_translation([0.02, -0.011, 0.0])
        .with_motion(Ramp::new([-1.0, 0.4, 0.0], sinew::scene::Distance::Metres(0.01), 0.05));
    in_space(body)
        .with_collider(step)
        .with_collider(Collider::sphere("ball", 0.01).with_translation([-0.02, -0.012, 0.0]))
}

fn hash(runner: &Runner) -> String {
    let report = Report::new(&scene(), runner, 0.0, Vec::new());
    format!("{} {:?}", report.bodies[0].state_hash, report.colliders)
}

#[test]
fn one_thread_and_four_give_the_same_bits() {
    let hashes = [1, 4].map(|threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
        pool.install(|| {
            let mut runner = runner(&scene());
            (0..3).for_each(|_| runner.advance_frame());
            assert!(runner.world().work_of_collider(0).abs() > 1e-6, "they touched");
            hash(&runner)
        })
    });
    assert_eq!(hashes[0], hashes[1]);
}

#[test]
fn a_checkpoint_takes_along_what_is_held() {
    let mut runner = runner(&scene());
    (0..2).for_each(|_| runner.advance_frame());
    let kept = runner.world().checkpoint();
    (0..2).for_each(|_| runner.advance_frame());
    let expected = hash(&runner);
    let mut world = baked(&scene()).world;
    world.go_back(&kept);
    (0..2).for_each(|_| world.advance_frame());
    let bits = |world: &sinew::solver::World| {
        let state = world.bodies()[0].state();
        (state.positions.clone(), state.velocities.clone(), world.force_on_collider(0), world.work_of_collider(0))
    };
    assert_eq!(bits(&world), bits(runner.world()), "{expected}");
}
