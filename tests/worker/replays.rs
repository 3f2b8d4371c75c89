//! Random scenes to which random things are done, and whose journals make the same motion again, bit for bit, on any
//! number of threads.

use crate::until;
use glam::DVec3;
use sinew::scene::{
    Activation, Assets, Body, Drive, DriveKeys, Fibre, Material, Rigidity, Scene, SharedDrive, TwoLayer,
};
use sinew::sim::{Journal, Rerun, SimCommand, Worker};
use std::sync::Arc;

/// Numbers that follow from a seed alone (xorshift).
struct Random(u64);

impl Random {
    fn below(&mut self, count: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as usize % count
    }

    /// Evenly between two numbers.
    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.below(1 << 20) as f64 / f64::from(1 << 20)
    }

    fn vector(&mut self, size: f64) -> DVec3 {
        DVec3::from_array([0; 3].map(|_| self.between(-size, size)))
    }
}

fn block(id: &str, random: &mut Random) -> Body {
    let size = [0; 3].map(|_| 0.01 * (3 + random.below(3)) as f64);
    let material = Material::new(random.between(2e4, 2e5), 0.3, 1000.0);
    let mut body = Body::cuboid(id, size).with_material(material);
    body.material.support_radius = 0.015;
    if random.below(2) == 0 {
        let vertices: Vec<[f64; 3]> = (0..4).map(|k| [0.0, size[1] * (0.15 + 0.2 * f64::from(k)), 0.0]).collect();
        let acts = Activation::contracting(random.between(0.1, 0.4), Drive::Shared("beat".to_owned()));
        let mut fibre = Fibre::through("fibre", vertices).with_activation(acts);
        fibre.stiffness = Rigidity::new(20.0, 1e-4).into();
        body.fibres.push(fibre);
        let keys = DriveKeys::new([(0.0, 0.0), (0.05, 1.0)]);
        body.drives.push(SharedDrive::new("beat", keys));
    }
    body
}

fn scene(random: &mut Random) -> Scene {
    let mut scene = Scene::new("random").with_floor(0.0).with_body(block("first", random));
    scene.bodies[0].placement.translation = [0.0, 0.02, 0.0];
    match random.below(3) {
        0 => {
            let mut second = block("second", random);
            second.placement.translation = [0.02, 0.09, 0.0];
            scene = scene.with_body(second);
        }
        1 => {
            let mut ball = TwoLayer::ball("ball");
            ball.placement.translation = [0.0, 0.4, 0.0];
            scene = scene.with_two_layer(ball);
        }
        _ => {}
    }
    scene
}

/// Something that a person could do now.
fn command(random: &mut Random, scene: &mut Scene, time: f64) -> SimCommand {
    let body = random.below(scene.all_bodies().count());
    match random.below(18) {
        0 => SimCommand::Grab { body, vertex: random.below(30), target: random.vector(0.1) },
        1 | 2 => SimCommand::MoveGrab(random.vector(0.1)),
        3 => SimCommand::Release,
        4 => SimCommand::PinGrab,
        5 => SimCommand::Unpin { body, grab: 0 },
        6 => SimCommand::ReleaseAll,
        7 => SimCommand::Strike { body, impulse: random.vector(5e-3) },
        8 => {
            scene.bodies[0].material.young_modulus *= random.between(0.7, 1.4);
            SimCommand::Edit(Arc::new(scene.clone()))
        }
        9 => SimCommand::Speed(random.between(0.2, 2.0)),
        10 => {
            let aim = (random.below(3) > 0).then(|| random.between(0.0, 1.0));
            SimCommand::Lead { body: 0, drive: "beat".to_owned(), aim }
        }
        11 => SimCommand::Show(random.between(0.5 * time, time)),
        12 => SimCommand::ContinueHere,
        13 => SimCommand::Live,
        14 | 15 => SimCommand::MoveGrab(random.vector(0.05)),
        _ => SimCommand::Grab { body, vertex: random.below(30), target: random.vector(0.05) },
    }
}

/// What was done to a random scene, as it is kept.
fn recorded(seed: u64) -> Journal {
    let mut random = Random(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1);
    let mut scene = scene(&mut random);
    scene.validate().expect("a scene");
    let worker = Worker::start(Arc::new(scene.clone()), Arc::default(), false, || {});
    until(&worker, |p| !p.snapshot.bodies.is_empty());
    let mut time = 0.0;
    for _ in 0..30 {
        if random.below(3) == 0 {
            assert!(worker.send(command(&mut random, &mut scene, time)));
        } else {
            // A step that is waited for, and now and then a while of playing, whose frames fall as they may.
            let frames = worker.journal().hashes.len();
            assert!(worker.send(SimCommand::Live));
            if random.below(6) == 0 {
                assert!(worker.send(SimCommand::Play));
            } else {
                assert!(worker.send(SimCommand::Step));
            }
            until(&worker, |_| worker.journal().hashes.len() != frames);
            assert!(worker.send(SimCommand::Pause));
        }
        if let Some(published) = worker.take() {
            time = published.status.time;
        }
    }
    assert!(worker.send(SimCommand::Live));
    let frames = worker.journal().hashes.len();
    assert!(worker.send(SimCommand::Step));
    let end = until(&worker, |_| worker.journal().hashes.len() != frames);
    time = time.max(end.status.time);
    assert!(time > 0.0);
    worker.journal()
}

fn replayed(seeds: std::ops::Range<u64>) {
    let (mut frames, mut asked, mut recordings) = (0, 0, 0);
    for seed in seeds {
        let journal = recorded(seed);
        for threads in [1, 2, 5] {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
            let agreed = pool.install(|| {
                let mut rerun = Rerun::new(journal.clone(), Assets::default()).expect("a scene that bakes");
                let mut agreed = 0;
                while rerun.advance().expect("it goes on") {
                    agreed += u64::from(rerun.agrees());
                }
                agreed
            });
            assert_eq!(agreed, journal.frames(), "seed {seed}, {threads} threads: {:?}", journal.asked);
        }
        frames += journal.frames();
        asked += journal.asked.len();
        recordings += 1;
    }
    println!("{recordings} recordings, {frames} frames, {asked} things that were asked: alike on 1, 2 and 5 threads");
    assert!(frames > 0 && asked > 0);
}

#[test]
fn random_journals_make_the_same_motion_again_on_any_number_of_threads() {
    replayed(0..4);
}

/// `cargo test --release --test worker a_hundred -- --ignored --nocapture`
#[test]
#[ignore = "takes minutes"]
fn a_hundred_random_journals_make_the_same_motion_again() {
    replayed(100..200);
}
