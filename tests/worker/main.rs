//! The simulation thread: requests in, pictures out.

#![allow(clippy::print_stdout, reason = "`--nocapture` shows how much was compared")]

mod promptly;
mod replays;

use glam::DVec3;
use sinew::io::scene_from_json;
use sinew::scene::{Assets, Scene, Shape};
use sinew::sim::{Asked, Journal, Published, Rerun, SimCommand, Worker};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

fn scene(extra: &str) -> Arc<Scene> {
    let text = format!(
        r#"{{"version": 1, "gravity": [0, 0, 0], {extra} "bodies": [{{
            "id": "cube", "shape": {{"box": {{"size": [0.03, 0.03, 0.03]}}}},
            "initial": {{"velocity": [0.1, 0, 0]}},
            "material": {{"young_modulus": 1e5, "mass": {{"per_particle": 4e-4}}, "support_radius": 0.015}}
        }}]}}"#
    );
    Arc::new(scene_from_json(&text).expect("a scene"))
}

/// What takes longer never comes.
const LONG: Duration = Duration::from_mins(2);

/// Waits for a picture that satisfies a condition.
#[allow(clippy::disallowed_methods, reason = "here what is waited for is looked at again and again")]
fn until(worker: &Worker, wanted: impl Fn(&Published) -> bool) -> Arc<Published> {
    let start = Instant::now();
    loop {
        if let Some(published) = worker.take()
            && wanted(&published)
        {
            return published;
        }
        assert!(start.elapsed() < LONG, "the picture never came");
        std::thread::sleep(Duration::from_millis(2));
    }
}

fn center(published: &Published) -> DVec3 {
    let particles = &published.snapshot.bodies[0].particles;
    particles.iter().sum::<DVec3>() / particles.len() as f64
}

#[test]
fn plays_pauses_steps_and_resets() {
    let worker = Worker::start(scene(""), Arc::default(), false, || {});
    let first = until(&worker, |p| !p.snapshot.bodies.is_empty());
    assert_eq!(first.status.time, 0.0);
    assert!(worker.send(SimCommand::Step));
    let stepped = until(&worker, |p| p.status.time > 0.0);
    assert!((stepped.status.time - 1.0 / 60.0).abs() < 1e-12 && !stepped.status.playing);
    assert!(worker.send(SimCommand::Play));
    until(&worker, |p| p.status.time > 0.1);
    assert!(worker.send(SimCommand::Pause));
    let paused = until(&worker, |p| !p.status.playing);
    assert!(worker.send(SimCommand::Reset));
    let reset = until(&worker, |p| p.status.time == 0.0);
    assert_eq!(reset.snapshot, first.snapshot);
    assert!((center(&paused).x - 0.1 * paused.status.time).abs() < 1e-9);
}

#[test]
fn an_edit_goes_on_from_the_present_motion_and_a_bad_one_keeps_the_old_world() {
    let worker = Worker::start(scene(""), Arc::default(), true, || {});
    until(&worker, |p| p.status.time > 0.05);
    let mut edited = (*scene("")).clone();
    edited.bodies[0].material.young_modulus = 2e5;
    assert!(worker.send(SimCommand::Edit(Arc::new(edited.clone()))));
    let after = until(&worker, |p| p.status.edits == 1);
    assert!(after.status.time > 0.05 && after.status.failure.is_none());
    assert!((center(&after).x - 0.1 * after.status.time).abs() < 1e-9, "{}", center(&after));
    edited.bodies[0].material.poisson_ratio = 0.7;
    assert!(worker.send(SimCommand::Edit(Arc::new(edited))));
    let refused = until(&worker, |p| p.status.edits == 2);
    assert!(refused.status.failure.as_deref().is_some_and(|text| text.contains("poisson_ratio")));
    until(&worker, |p| p.status.time > refused.status.time);
}

#[test]
fn a_grab_pulls_the_body_to_the_pointer_and_a_pin_keeps_it() {
    let worker = Worker::start(scene(r#""description": "","#), Arc::default(), true, || {});
    until(&worker, |p| p.status.time > 0.0);
    let target = DVec3::new(0.0, 0.1, 0.0);
    assert!(worker.send(SimCommand::Grab { body: 0, vertex: 0, target }));
    let vertex = |p: &Published| p.snapshot.bodies[0].surface()[0];
    until(&worker, |p| vertex(p).distance(target) < 2e-3 && p.status.time > 0.5);
    let moved = DVec3::new(0.05, 0.1, 0.0);
    assert!(worker.send(SimCommand::MoveGrab(moved)));
    assert!(worker.send(SimCommand::PinGrab));
    until(&worker, |p| vertex(p).distance(moved) < 2e-3 && p.status.time > 1.0);
    assert!(worker.send(SimCommand::ReleaseAll));
}

#[test]
fn runs_in_real_time_when_it_can() {
    let worker = Worker::start(scene(""), Arc::default(), true, || {});
    let published = until(&worker, |p| p.status.real_time_factor > 0.0 && p.status.time > 0.8);
    assert!(published.status.real_time_factor < 1.3, "{}", published.status.real_time_factor);
}

const FIBRED: &str = r#"{"version": 1, "bodies": [{"id": "bar",
    "shape": {"box": {"center": [0, 0.03, 0], "size": [0.03, 0.06, 0.03]}},
    "initial": {"velocity": [0.05, 0, 0], "deformation": [[1, 0.1, 0], [0, 1.05, 0], [0, 0, 1]]},
    "material": {"young_modulus": 1e5, "mass": {"per_particle": 4e-4}, "support_radius": 0.015},
    "fibres": [{"id": "f", "source": {"vertices": [[0.006, 0.005, 0], [0.006, 0.03, 0], [0.006, 0.055, 0]]},
        "stiffness": {"rigidity": {"ea": 10, "ei": 1e-5}}, "volume_fraction": 0.5}]}]}"#;

#[test]
fn a_ghost_without_fibres_is_that_scene_alone_bit_for_bit() {
    let scene = scene_from_json(FIBRED).expect("a scene");
    let mut bare = scene.clone();
    bare.bodies[0].fibres.clear();
    let bare = Arc::new(bare);
    let worker = Worker::start(Arc::new(scene), Arc::default(), false, || {});
    until(&worker, |p| !p.snapshot.bodies.is_empty());
    assert!(worker.send(SimCommand::Ghost(Some(Arc::clone(&bare)))));
    until(&worker, |p| p.ghost.is_some());
    let baked = sinew::bake::bake(&bare, &Assets::default()).expect("a scene that bakes");
    let start = sinew::sim::Runner::new(baked);
    let strike = |body| SimCommand::Strike { body, impulse: DVec3::new(1e-3, 0.0, 0.0) };
    for round in 0..2 {
        let mut alone = start.clone();
        for frame in 1..=12 {
            if frame == 5 && round == 1 {
                assert!(worker.send(strike(0)));
                alone.body_mut(0).expect("a body").strike(DVec3::new(1e-3, 0.0, 0.0));
            }
            assert!(worker.send(SimCommand::Step));
            alone.advance_frame();
            let time = alone.world().time();
            let seen = until(&worker, |p| (p.status.time - time).abs() < 1e-9);
            assert_eq!(seen.ghost.as_ref(), Some(&alone.particles()), "round {round}, frame {frame}");
            let far = |(a, b): (&DVec3, &DVec3)| a.distance(*b) > 1e-6;
            let differs = seen.snapshot.bodies[0].particles.iter().zip(&alone.particles().bodies[0].particles).any(far);
            assert!(differs, "the fibre does nothing");
        }
        assert!(worker.send(SimCommand::Reset));
        until(&worker, |p| p.status.time == 0.0);
    }
}

#[test]
fn a_ghost_starts_from_where_the_world_is() {
    let worker = Worker::start(scene(""), Arc::default(), true, || {});
    until(&worker, |p| p.status.time > 0.1);
    let mut soft = (*scene("")).clone();
    soft.bodies[0].material.young_modulus = 1e4;
    assert!(worker.send(SimCommand::Ghost(Some(Arc::new(soft)))));
    let seen = until(&worker, |p| p.ghost.is_some() && p.status.time > 0.2);
    let ghost = seen.ghost.as_ref().expect("a ghost");
    assert!((ghost.time - seen.status.time).abs() < 1e-9);
    let middle = ghost.bodies[0].particles.iter().sum::<DVec3>() / ghost.bodies[0].particles.len() as f64;
    assert!(middle.distance(center(&seen)) < 1e-9);
    assert!(worker.send(SimCommand::Ghost(None)));
    until(&worker, |p| p.ghost.is_none());
}

#[test]
fn every_frame_is_recorded_though_its_picture_is_missed() {
    let worker = Worker::start(scene(""), Arc::default(), true, || {});
    until(&worker, |_| worker.time_series(|recorded| recorded.world.len()) >= 30);
    worker.time_series(|recorded| {
        assert!(recorded.ghost.is_none() && recorded.world.dropped() == 0);
        for (number, row) in recorded.world.rows() {
            assert!((row[0] - number as f64 / 60.0).abs() < 1e-9, "frame {number} at {} s", row[0]);
        }
    });
    // An edit that leaves the columns as they are goes on, one that does not begins anew.
    let rows = |worker: &Worker| worker.time_series(|recorded| (recorded.world.len(), recorded.world.columns().len()));
    assert!(worker.send(SimCommand::Pause));
    until(&worker, |p| !p.status.playing);
    let (before, columns) = rows(&worker);
    let mut edited = (*scene("")).clone();
    edited.bodies[0].material.young_modulus = 2e5;
    assert!(worker.send(SimCommand::Edit(Arc::new(edited))));
    until(&worker, |p| p.status.edits == 1 && p.status.baking.is_none());
    assert_eq!(rows(&worker), (before, columns));
    let size = r#""measures": [{"name": "size", "body": "cube", "kind": {"size": {"axis": "y"}}}],"#;
    assert!(worker.send(SimCommand::Edit(scene(size))));
    until(&worker, |p| p.status.edits == 2 && p.status.baking.is_none());
    assert_eq!(rows(&worker), (1, columns + 1));
}

#[test]
fn of_more_rows_than_are_kept_the_oldest_go() {
    let baked = sinew::bake::bake(&scene(""), &Assets::default()).expect("it bakes");
    let mut runner = sinew::sim::Runner::new(baked);
    let mut series = sinew::sim::TimeSeries::new(runner.world(), 5);
    for _ in 0..8 {
        series.push(runner.world());
        series.push(runner.world());
        runner.advance_frame();
    }
    assert_eq!((series.len(), series.dropped()), (5, 3));
    assert_eq!(series.rows().map(|(number, _)| number).collect::<Vec<_>>(), [3, 4, 5, 6, 7]);
}

/// A worker that waits whenever it hands a picture over until the gate is open, as if a frame took that long. It has
/// handed over the first one.
fn behind(gate: &Arc<Mutex<()>>, scene: Arc<Scene>, playing: bool) -> Worker {
    let gate = Arc::clone(gate);
    let worker = Worker::start(scene, Arc::default(), playing, move || drop(gate.lock()));
    until(&worker, |_| true);
    worker
}

/// The cube under another name, with another start.
fn renamed(name: &str, velocity: f64) -> Arc<Scene> {
    let mut scene = (*scene("")).clone();
    name.clone_into(&mut scene.bodies[0].name);
    scene.bodies[0].initial.velocity = [velocity, 0.0, 0.0];
    Arc::new(scene)
}

#[test]
fn of_many_edits_to_a_busy_worker_the_last_arrives_and_all_are_counted() {
    let gate = Arc::default();
    let shut = Mutex::lock(&gate).expect("a gate");
    let worker = behind(&gate, scene(""), false);
    for k in 1..=400 {
        assert!(worker.send(SimCommand::Edit(renamed(&k.to_string(), 0.1))));
        assert!(worker.send(SimCommand::Ghost(Some(renamed("ghost", 0.1)))));
    }
    let early = worker.take();
    drop(shut);
    assert!(early.is_none(), "it was busy");
    let edited = until(&worker, |p| p.status.edits >= 400 && p.status.baking.is_none());
    assert_eq!((edited.status.edits, edited.status.bodies[0].name.as_str()), (400, "400"));
    assert!(edited.ghost.is_some());
}

#[test]
fn a_document_that_is_opened_and_a_pause_are_heard_behind_many_edits() {
    let gate = Arc::default();
    let shut = Mutex::lock(&gate).expect("a gate");
    let worker = behind(&gate, scene(""), true);
    for k in 1..=400 {
        assert!(worker.send(SimCommand::Edit(renamed(&k.to_string(), 0.1))));
    }
    assert!(worker.send(SimCommand::Open(renamed("opened", 0.1), Arc::default())));
    assert!(worker.send(SimCommand::Pause));
    drop(shut);
    let opened = until(&worker, |p| p.status.edits >= 401 && p.status.baking.is_none());
    assert_eq!((opened.status.edits, opened.status.bodies[0].name.as_str()), (401, "opened"));
    assert!(!opened.status.playing && opened.status.time == 0.0 && opened.status.recording.frames == 1);
    assert!(worker.send(SimCommand::Edit(renamed("after", 0.1))));
    let after = until(&worker, |p| p.status.edits == 402 && p.status.baking.is_none());
    assert_eq!(after.status.bodies[0].name, "after");
}

#[test]
fn a_reset_behind_an_edit_is_one_to_the_start_of_the_edited_scene() {
    let gate = Arc::default();
    let shut = Mutex::lock(&gate).expect("a gate");
    let worker = behind(&gate, scene(""), false);
    for command in [SimCommand::Edit(renamed("faster", 0.2)), SimCommand::Reset, SimCommand::Play] {
        assert!(worker.send(command));
    }
    drop(shut);
    let played = until(&worker, |p| p.status.time > 0.1);
    assert!(played.status.playing && played.status.edits == 1);
    assert!((center(&played).x - 0.2 * played.status.time).abs() < 1e-9, "{}", center(&played));
}

#[test]
fn a_grab_behind_an_edit_takes_hold_of_a_body_of_the_edited_scene() {
    let mut two = (*renamed("left", 0.0)).clone();
    let mut right = two.bodies[0].clone();
    (right.id, right.placement.translation) = ("right".to_owned(), [0.2, 0.0, 0.0]);
    two.bodies.push(right);
    let mut one = two.clone();
    one.bodies.remove(0);
    let gate = Arc::default();
    let shut = Mutex::lock(&gate).expect("a gate");
    let worker = behind(&gate, Arc::new(two), true);
    let target = DVec3::new(0.2, 0.1, 0.0);
    assert!(worker.send(SimCommand::Edit(Arc::new(one))));
    assert!(worker.send(SimCommand::Grab { body: 0, vertex: 0, target }));
    drop(shut);
    let is_there = |p: &Published| p.snapshot.bodies.first().is_some_and(|b| b.surface()[0].distance(target) < 2e-3);
    until(&worker, |p| p.status.edits == 1 && is_there(p));
}

/// A million steps to a frame of some hundreds of particles, which takes longer than any test waits.
fn endless(speed: f64) -> Arc<Scene> {
    let mut scene = (*renamed("endless", speed)).clone();
    scene.bodies[0].shape = Shape::Box(serde_json::from_str(r#"{"size": [0.09, 0.06, 0.06]}"#).expect("a box"));
    scene.time.step = sinew::scene::TimeStep::manual(1e-9, 1_000_000);
    Arc::new(scene)
}

#[test]
fn what_is_asked_for_in_the_midst_of_a_frame_without_end_is_done() {
    let worker = Worker::start(endless(0.1), Arc::default(), true, || {});
    let first = until(&worker, |p| p.status.playing && !p.snapshot.bodies.is_empty());
    // A pause leaves all as it was before the frame.
    assert!(worker.send(SimCommand::Pause));
    let paused = until(&worker, |p| !p.status.playing);
    assert_eq!((paused.status.time, &paused.snapshot), (0.0, &first.snapshot));
    // A step that was asked for is ended by a pause, too.
    assert!(worker.send(SimCommand::Step));
    assert!(worker.send(SimCommand::Field(None)));
    assert!(worker.send(SimCommand::Pause));
    assert!(worker.send(SimCommand::Play));
    until(&worker, |p| p.status.playing);
    // An edit, and a drag.
    assert!(worker.send(SimCommand::Edit(renamed("edited", 0.1))));
    let edited = until(&worker, |p| p.status.bodies[0].name == "edited" && p.status.time > 0.0);
    assert!((center(&edited).x - 0.1 * edited.status.time).abs() < 1e-9, "{}", center(&edited));
    assert!(worker.send(SimCommand::Edit(endless(0.1))));
    until(&worker, |p| p.status.edits == 2);
    assert!(worker.send(SimCommand::Grab { body: 0, vertex: 0, target: DVec3::Y }));
    assert!(worker.send(SimCommand::PinGrab));
    until(&worker, |p| !p.pinned.is_empty());
    // Another document, and the end.
    assert!(worker.send(SimCommand::Open(renamed("opened", 0.1), Arc::default())));
    until(&worker, |p| p.status.bodies.first().is_some_and(|body| body.name == "opened") && p.status.time > 0.0);
    assert!(worker.send(SimCommand::Open(endless(0.1), Arc::default())));
    until(&worker, |p| p.status.bodies.first().is_some_and(|body| body.name == "endless"));
    drop(worker);
}

#[test]
fn a_journal_makes_a_motion_again_bit_for_bit() {
    let worker = Worker::start(scene(""), Arc::default(), false, || {});
    until(&worker, |p| !p.snapshot.bodies.is_empty());
    let ask = |command: SimCommand| assert!(worker.send(command));
    let frames = |count: usize| {
        let mut end = 0.0;
        for _ in 0..count {
            let before = worker.journal().hashes.len();
            ask(SimCommand::Step);
            end = until(&worker, |_| worker.journal().hashes.len() > before).status.time;
        }
        end
    };
    frames(2);
    ask(SimCommand::Strike { body: 0, impulse: DVec3::new(0.0, 1e-3, 0.0) });
    frames(2);
    ask(SimCommand::Grab { body: 0, vertex: 3, target: DVec3::new(0.0, 0.04, 0.0) });
    frames(1);
    ask(SimCommand::MoveGrab(DVec3::new(0.01, 0.05, 0.0)));
    ask(SimCommand::MoveGrab(DVec3::new(0.02, 0.06, 0.01)));
    frames(2);
    ask(SimCommand::PinGrab);
    ask(SimCommand::Speed(0.5));
    let mut stiff = (*scene("")).clone();
    stiff.bodies[0].material.young_modulus = 2e5;
    ask(SimCommand::Edit(Arc::new(stiff)));
    let end = frames(3);
    // What came after the frame that is gone on from was never there; the edit is, from then on.
    ask(SimCommand::Show(0.5 * end));
    ask(SimCommand::Strike { body: 0, impulse: DVec3::new(1e-3, 0.0, 0.0) });
    until(&worker, |_| worker.journal().frames() < 10);
    frames(2);
    ask(SimCommand::ReleaseAll);
    frames(1);
    let journal = worker.journal();
    assert!((7..10).contains(&journal.frames()), "{}", journal.frames());
    let text = serde_json::to_string(&journal).expect("JSON");
    let read: Journal = serde_json::from_str(&text).expect("the journal");
    assert_eq!(read, journal);
    let rerun = |journal: Journal| {
        let mut rerun = Rerun::new(journal, Assets::default()).expect("a scene that bakes");
        let mut agreed = 0;
        while rerun.advance().expect("it goes on") {
            agreed += u64::from(rerun.agrees());
        }
        agreed
    };
    assert_eq!(rerun(read.clone()), journal.frames());
    // Anything else that is asked is another motion from there on.
    let mut other = read;
    let struck = other.asked.iter_mut().find(|entry| matches!(entry.what, Asked::Strike { .. }));
    struck.expect("a strike").what = Asked::Strike { body: 0, impulse: [0.0, 2e-3, 0.0] };
    assert_eq!(rerun(other), 2);
}

#[test]
fn a_motion_that_gains_energy_says_so_until_it_is_reset() {
    let mut gaining = (*scene(r#""time": {"step": {"manual": {"dt": 2e-5, "substeps_per_frame": 20}}},"#)).clone();
    gaining.bodies[0].integrator = sinew::scene::IntegratorKind::ExplicitEuler.into();
    gaining.bodies[0].material.damping.pair = 0.0;
    gaining.bodies[0].initial.deformation = [[1.1, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let worker = Worker::start(Arc::new(gaining), Arc::default(), true, || {});
    let stopped = until(&worker, |p| p.status.divergence.is_some());
    let text = stopped.status.unbalanced.as_deref().expect("words");
    assert!(text.contains("\"cube\"") && text.contains("explicit_euler"), "{text}");
    assert!(stopped.status.divergence.as_deref().is_some_and(|text| text.contains("that nothing gave")));
    assert!(worker.send(SimCommand::Pause));
    assert!(worker.send(SimCommand::Reset));
    until(&worker, |p| p.status.time == 0.0 && p.status.unbalanced.is_none() && p.status.divergence.is_none());
}
