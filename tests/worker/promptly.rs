//! Whatever is asked for is done in the midst of a frame and of putting a scene together: with the step or the stage
//! that goes on when it is to end. For how long what waits lets a frame go on stands in `sim::worker::stop`.

use super::{LONG, endless, renamed, until};
use glam::DVec3;
use sinew::bake::bake;
use sinew::scene::{Assets, Scene, Shape, TimeStep};
use sinew::sim::{Published, Runner, SimCommand, Worker};
use sinew::solver::FieldKind;
use std::cell::Cell;
use std::sync::Arc;
use std::sync::mpsc::{Receiver, Sender, channel};

/// Something that is asked, and what is seen of it.
type Case = (&'static str, Vec<SimCommand>, fn(&Published) -> bool);

/// Ends a worker, which waits for nothing but the step or the stage that it is in.
fn ends(worker: Worker, what: &str) {
    let (done, said) = channel();
    std::thread::spawn(move || {
        drop(worker);
        done.send(()).ok();
    });
    said.recv_timeout(LONG).unwrap_or_else(|_| panic!("{what}: it never ends"));
}

#[test]
fn in_the_midst_of_a_frame() {
    let name = |p: &Published| p.status.bodies.first().map(|body| body.name.clone()).unwrap_or_default();
    let cases: Vec<Case> = vec![
        ("pause", vec![SimCommand::Pause], |p| !p.status.playing),
        ("step and pause", vec![SimCommand::Step, SimCommand::Step, SimCommand::Pause, SimCommand::Play], |p| {
            p.status.playing
        }),
        ("edit behind a step", vec![SimCommand::Step, SimCommand::Edit(renamed("edited", 0.1))], |p| {
            p.status.edits == 1 && p.status.bodies[0].name == "edited"
        }),
        ("open", vec![SimCommand::Open(renamed("opened", 0.1), Arc::default())], |p| {
            p.status.bodies.first().is_some_and(|body| body.name == "opened")
        }),
        ("grab", vec![SimCommand::Grab { body: 0, vertex: 0, target: DVec3::Y }, SimCommand::PinGrab], |p| {
            !p.pinned.is_empty()
        }),
        ("field", vec![SimCommand::Field(Some(FieldKind::Speed))], |p| p.snapshot.field.is_some()),
        ("ghost", vec![SimCommand::Ghost(Some(renamed("ghost", 0.1)))], |p| p.ghost.is_some()),
    ];
    for (what, commands, is_done) in cases {
        let worker = Worker::start(endless(0.1), Arc::default(), true, || {});
        until(&worker, |p| p.status.playing && !p.snapshot.bodies.is_empty());
        // A frame is going on by now, for longer than anything is waited for here: what is done is done within it.
        while worker.take().is_some() {}
        for command in commands {
            assert!(worker.send(command), "{what}");
        }
        until(&worker, is_done);
    }
    let worker = Worker::start(endless(0.1), Arc::default(), true, || {});
    until(&worker, |p| name(p) == "endless");
    assert!(worker.send(SimCommand::Step));
    ends(worker, "a frame without end");
}

#[test]
fn it_is_asked_before_every_step_whether_a_frame_is_to_end_and_it_does_then() {
    let runner = |steps| {
        let mut scene = (*renamed("counted", 0.1)).clone();
        scene.time.step = TimeStep::manual(1e-6, steps);
        Runner::new(bake(&scene, &Assets::default()).expect("a world"))
    };
    let asked = Cell::new(0);
    assert!(runner(20).advance_frame_unless(&|| {
        asked.set(asked.get() + 1);
        false
    }));
    assert_eq!(asked.get(), 20, "no step is taken unasked");
    for last in 1..=20 {
        let (mut runner, asked) = (runner(20), Cell::new(0));
        let before = runner.snapshot();
        let is_whole = runner.advance_frame_unless(&|| {
            asked.set(asked.get() + 1);
            asked.get() >= last
        });
        assert!(!is_whole && asked.get() == last, "it goes on after {last}: {}", asked.get());
        assert_eq!(runner.snapshot(), before, "and all is as it was");
    }
}

#[test]
fn a_frame_that_was_asked_for_and_ended_by_something_else_follows() {
    let worker = Worker::start(endless(0.1), Arc::default(), false, || {});
    until(&worker, |p| !p.snapshot.bodies.is_empty());
    for _ in 0..3 {
        assert!(worker.send(SimCommand::Step));
    }
    // The edit is taken up in the midst of the first frame, and the three are computed in the edited scene.
    assert!(worker.send(SimCommand::Edit(renamed("edited", 0.1))));
    let end = until(&worker, |p| p.status.bodies[0].name == "edited" && p.status.recording.frames == 4);
    assert!(!end.status.playing && worker.journal().frames() == 3);
    assert!((end.status.time - 3.0 / 60.0).abs() < 1e-9, "{}", end.status.time);
    // Held, none follows.
    assert!(worker.send(SimCommand::Edit(endless(0.1))));
    for command in [SimCommand::Step, SimCommand::Pause, SimCommand::Edit(renamed("held", 0.1))] {
        assert!(worker.send(command));
    }
    until(&worker, |p| p.status.bodies[0].name == "held" && p.status.baking.is_none());
    assert!(worker.send(SimCommand::Step));
    until(&worker, |p| p.status.recording.frames == 5);
    assert_eq!(worker.journal().frames(), 4);
}

/// A worker that hands over picture after picture, each only when the last one was looked at.
struct Slowly {
    worker: Worker,
    told: Receiver<()>,
    go: Sender<()>,
}

impl Slowly {
    fn start(scene: Arc<Scene>, playing: bool) -> Self {
        let (tell, told) = channel();
        let (go, wait) = channel();
        let worker = Worker::start(scene, Arc::default(), playing, move || {
            // Once nobody looks any more it goes on by itself.
            if tell.send(()).is_ok() {
                wait.recv().ok();
            }
        });
        Self { worker, told, go }
    }

    /// The first picture from now on that is as wanted.
    fn until(&self, wanted: impl Fn(&Published) -> bool) -> Arc<Published> {
        for _ in 0..10_000 {
            self.told.recv_timeout(LONG).expect("a picture");
            let published = self.worker.take().expect("a picture");
            if wanted(&published) {
                // The worker waits here for what is asked of it.
                return published;
            }
            self.go.send(()).expect("it waits");
        }
        panic!("it never came about");
    }

    fn ask(&self, commands: impl IntoIterator<Item = SimCommand>) {
        for command in commands {
            assert!(self.worker.send(command));
        }
        self.go.send(()).expect("it waits");
    }
}

#[test]
fn what_holds_or_looks_is_done_in_the_midst_of_putting_a_scene_together() {
    let cases: Vec<Case> = vec![
        ("pause", vec![SimCommand::Pause], |p| !p.status.playing),
        ("reset", vec![SimCommand::Pause, SimCommand::Reset], |p| p.status.time == 0.0 && p.snapshot.bodies.len() == 1),
        ("field", vec![SimCommand::Field(Some(FieldKind::Speed))], |p| p.snapshot.field.is_some()),
        ("an earlier frame", vec![SimCommand::Show(0.0)], |p| p.status.recording.in_replay && p.status.time == 0.0),
        (
            "nothing that would turn out otherwise",
            vec![SimCommand::Speed(1.0), SimCommand::Step, SimCommand::Pause],
            |p| p.status.playing,
        ),
    ];
    for (what, commands, is_done) in cases {
        let slowly = Slowly::start(renamed("small", 0.1), true);
        slowly.until(|p| p.status.time > 0.03);
        slowly.ask([SimCommand::Edit(renamed("edited", 0.1))].into_iter().chain(commands));
        let midst = slowly.until(|p| p.status.baking.is_some());
        assert!(midst.status.bodies[0].name == "small" && is_done(&midst), "{what}: {:?}", midst.status);
        // It holds after that, too.
        slowly.go.send(()).expect("it waits");
        let after = slowly.until(|p| p.status.bodies[0].name == "edited" || p.status.recording.of_another_scene);
        let holds = is_done(&after) || what.starts_with("nothing");
        assert!(after.status.baking.is_none() && holds, "{what}: {:?}", after.status);
        drop(slowly.go);
        drop(slowly.told);
    }
}

#[test]
fn a_reset_that_was_heard_early_is_one_to_the_start_of_the_edited_scene() {
    let slowly = Slowly::start(renamed("small", 0.1), true);
    slowly.until(|p| p.status.time > 0.03);
    slowly.ask([SimCommand::Edit(renamed("edited", 0.2)), SimCommand::Pause, SimCommand::Reset]);
    slowly.until(|p| p.status.bodies[0].name == "edited" && p.status.baking.is_none());
    // A journal of the edited scene from its start.
    let journal = slowly.worker.journal();
    assert_eq!((journal.scene.bodies[0].name.as_str(), journal.frames(), journal.asked.len()), ("edited", 0, 0));
    drop(slowly.go);
    drop(slowly.told);
}

/// A bar that takes longer to be put together than a person waits for.
fn large() -> Arc<Scene> {
    let mut large = (*renamed("large", 0.1)).clone();
    large.bodies[0].shape = Shape::Box(serde_json::from_str(r#"{"size": [0.3, 0.2, 0.2]}"#).expect("a box"));
    Arc::new(large)
}

#[test]
fn the_putting_together_of_a_scene_ends_with_the_stage_in_which_it_is_no_longer_wanted() {
    let slowly = Slowly::start(renamed("small", 0.1), true);
    slowly.until(|p| p.status.time > 0.02);
    slowly.ask([SimCommand::Edit(large())]);
    slowly.until(|p| p.status.baking.is_some());
    slowly.worker.stop_building();
    slowly.go.send(()).expect("it waits");
    let stages = Cell::new(0);
    let end = slowly.until(|p| {
        stages.set(stages.get() + usize::from(p.status.baking.is_some()));
        p.status.stopped
    });
    assert_eq!((stages.get(), end.status.bodies[0].name.as_str()), (0, "small"), "none is begun after it");
    slowly.go.send(()).expect("it waits");
    let Slowly { worker, told, go } = slowly;
    drop((told, go));
    assert!(worker.send(SimCommand::Edit(large())));
    until(&worker, |p| p.status.baking.is_some());
    ends(worker, "a large scene");
}
