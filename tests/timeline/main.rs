//! What the simulation thread keeps of a motion: frames are shown again, replayed and gone on from, bit for bit.

mod ahead;
mod changes;
mod leading;

use glam::DVec3;
use sinew::io::scene_from_json;
use sinew::scene::Scene;
use sinew::sim::{Published, SimCommand, Worker};
use sinew::solver::Snapshot;
use sinew::test_support::sim::DEFAULT_MEMORY;
use std::cell::Cell;
use std::collections::BTreeMap;
use std::ops::Deref;
use std::sync::Arc;
use std::time::{Duration, Instant};

/// A bar with a curved and a straight fibre that break as it lands, under a panel that falls on it.
const BREAKING: &str = r#"{"version": 1, "room": {"floor": 0, "friction": 0.4},
    "panels": [{"id": "lid", "height": 0.08, "size": [1, 1], "mass": 0.5, "motion": "falls"}],
    "bodies": [{"id": "bar", "shape": {"box": {"center": [0, 0.03, 0], "size": [0.03, 0.06, 0.03]}},
        "placement": {"translation": [0, 0.02, 0]},
        "initial": {"velocity": [0.05, 0, 0], "deformation": [[1, 0.1, 0], [0, 1.05, 0], [0, 0, 1]]},
        "material": {"young_modulus": 1e5, "mass": {"per_particle": 4e-4}, "support_radius": 0.015,
            "damping": {"pair": 20, "air": 0.5}},
        "fibres": [
            {"id": "bent", "source": {"vertices": [[0.006, 0.005, 0], [0.01, 0.03, 0.003], [0.006, 0.055, 0]]},
                "stiffness": {"rigidity": {"ea": 10, "ei": 1e-4}}, "volume_fraction": 0.5, "rest_shape": "as_drawn",
                "break_past": {"angle": 8}},
            {"id": "straight", "source": {"vertices": [[-0.006, 0.005, 0], [-0.006, 0.03, 0], [-0.006, 0.055, 0]]},
                "stiffness": {"rigidity": {"ea": 10, "ei": 1e-4}}, "volume_fraction": 0.5, "break_past": {"angle": 8}}
        ]}],
    "measures": [{"name": "height", "body": "bar", "kind": {"size": {"axis": "y"}}}]}"#;

/// A ball and a ring of two layers, which meet.
const TWO_LAYER: &str = r#"{"version": 1, "room": {"floor": 0}, "two_layer": [
    {"id": "ball", "shape": {"ball": {"subdivisions": 1}}, "placement": {"translation": [0, 1.05, 0]}},
    {"id": "ring", "shape": {"ring": {}}, "placement": {"translation": [0.3, 2.9, 0]}}]}"#;

fn scene(text: &str) -> Arc<Scene> {
    Arc::new(scene_from_json(text).expect("a scene"))
}

/// A worker, and the time of the picture that was seen last [s].
struct Run {
    worker: Worker,
    seen: Cell<f64>,
}

impl Deref for Run {
    type Target = Worker;

    fn deref(&self) -> &Worker {
        &self.worker
    }
}

fn start(text: &str) -> Run {
    let worker = Worker::start(scene(text), Arc::default(), false, || {});
    let worker = Run { worker, seen: Cell::new(0.0) };
    until(&worker, |p| p.status.recording.frames == 1);
    worker
}

/// Waits for a picture that satisfies a condition.
#[allow(clippy::disallowed_methods, reason = "here what is waited for is looked at again and again")]
fn until(worker: &Run, wanted: impl Fn(&Published) -> bool) -> Arc<Published> {
    let start = Instant::now();
    loop {
        if let Some(published) = worker.take() {
            worker.seen.set(published.status.time);
            if wanted(&published) {
                return published;
            }
        }
        assert!(start.elapsed() < Duration::from_mins(2), "the picture never came");
        std::thread::sleep(Duration::from_millis(1));
    }
}

fn ask(worker: &Run, command: SimCommand) {
    assert!(worker.send(command), "it is heard");
}

/// What was published of each frame, by its time.
type Shown = BTreeMap<u64, Arc<Published>>;

fn key(published: &Published) -> u64 {
    published.status.time.to_bits()
}

/// So many frames, one by one; every one is published.
fn advance(worker: &Run, frames: usize) -> Shown {
    let mut shown = Shown::new();
    for _ in 0..frames {
        // What was asked for before may still come as a picture of its own, of the frame that was seen last.
        let before = worker.seen.get();
        ask(worker, SimCommand::Step);
        let next = until(worker, |p| p.status.time > before && p.status.baking.is_none());
        shown.insert(key(&next), next);
    }
    shown
}

fn show(worker: &Run, time: f64) -> Arc<Published> {
    ask(worker, SimCommand::Show(time));
    until(worker, |p| p.status.time == time && p.status.recording.in_replay)
}

fn same(shown: &Published, first: &Published) {
    assert_eq!(bits(&shown.snapshot), bits(&first.snapshot), "at {} s", first.status.time);
    assert_eq!(shown.snapshot, first.snapshot);
    assert_eq!(shown.status.measures, first.status.measures);
    assert_eq!(shown.ghost, first.ghost);
}

fn bits(snapshot: &Snapshot) -> Vec<u64> {
    let fibres = snapshot.bodies.iter().flat_map(|body| &body.fibres).flat_map(|fibre| &fibre.vertices);
    let points = snapshot.bodies.iter().flat_map(|body| &body.particles).chain(fibres);
    let panels = snapshot.panels.iter().copied();
    points.flat_map(DVec3::to_array).chain(panels).map(f64::to_bits).collect()
}

/// Every frame is shown again with the same bits, in any order; the live end is where it was.
fn all_are_shown_again(worker: &Run, first: &Shown) {
    let frames: Vec<&Arc<Published>> = first.values().collect();
    let count = frames.len();
    for k in 0..count {
        // Back and forth.
        let frame = frames[(7 * k + 3) % count];
        same(&show(worker, frame.status.time), frame);
    }
    ask(worker, SimCommand::Live);
    same(&until(worker, |p| !p.status.recording.in_replay), frames[count - 1]);
}

/// Goes on from several frames and gets the same ones again as the first time.
fn going_on_gives_the_same(worker: &Run, first: &Shown) {
    let frames: Vec<&Arc<Published>> = first.values().collect();
    let last = frames[frames.len() - 1].status.time;
    for from in [frames.len() / 2, frames.len() - 2, 0] {
        show(worker, frames[from].status.time);
        ask(worker, SimCommand::ContinueHere);
        until(worker, |p| {
            p.status.time >= last && p.status.recording.span.is_some_and(|span| span[1] == p.status.time)
        });
        ask(worker, SimCommand::Pause);
        until(worker, |p| !p.status.playing);
        // What was computed again is what is kept now.
        for frame in &frames {
            same(&show(worker, frame.status.time), frame);
        }
    }
}

#[test]
fn a_bar_whose_fibres_break_is_shown_and_gone_on_from_bit_for_bit() {
    let worker = start(BREAKING);
    let first = advance(&worker, 24);
    let breaks = |p: &Published| p.snapshot.bodies[0].breaks.len();
    let last = first.values().next_back().expect("frames");
    assert!(breaks(first.values().next().expect("frames")) == 0 && breaks(last) > 0, "a fibre breaks on the way");
    let pairs = first.values().zip(first.values().skip(1));
    let marked: Vec<f64> = pairs.filter(|(a, b)| breaks(b) > breaks(a)).map(|(_, b)| b.status.time).collect();
    assert_eq!(last.status.recording.breaks, marked);
    all_are_shown_again(&worker, &first);
    going_on_gives_the_same(&worker, &first);
}

#[test]
fn two_layer_bodies_are_shown_and_gone_on_from_bit_for_bit() {
    let worker = start(TWO_LAYER);
    let first = advance(&worker, 20);
    all_are_shown_again(&worker, &first);
    going_on_gives_the_same(&worker, &first);
}

#[test]
fn what_is_pinned_stays_and_what_the_pointer_held_is_let_go() {
    let worker = start(BREAKING);
    advance(&worker, 3);
    ask(&worker, SimCommand::Grab { body: 0, vertex: 0, target: DVec3::new(0.05, 0.1, 0.0) });
    ask(&worker, SimCommand::PinGrab);
    advance(&worker, 3);
    ask(&worker, SimCommand::Grab { body: 0, vertex: 5, target: DVec3::new(-0.1, 0.1, 0.0) });
    let held = advance(&worker, 4);
    ask(&worker, SimCommand::Release);
    let mut first: Shown = held.last_key_value().map(|(key, p)| (*key, Arc::clone(p))).into_iter().collect();
    first.extend(advance(&worker, 8));
    all_are_shown_again(&worker, &first);
    // The first of these frames was the last in which the pointer held the body.
    going_on_gives_the_same(&worker, &first);
}

#[test]
fn the_oldest_frames_make_room_and_the_bound_holds() {
    let worker = start(BREAKING);
    advance(&worker, 2);
    let before = until_timeline(&worker);
    assert_eq!(before.limit, DEFAULT_MEMORY);
    // The start that the frames share, and about eight of them.
    let each = (before.bytes - first_bytes(&worker)) / (before.frames - 1);
    let limit = before.bytes + 6 * each;
    ask(&worker, SimCommand::Memory(limit));
    let mut newest = 0.0;
    for _ in 0..20 {
        let shown = advance(&worker, 1);
        let p = shown.values().next().expect("a frame");
        let timeline = &p.status.recording;
        assert!(timeline.bytes <= limit && timeline.limit == limit, "{timeline:?}");
        assert_eq!(timeline.span.map(|span| span[1]), Some(p.status.time), "the newest is kept");
        newest = p.status.time;
    }
    let full = until_timeline(&worker);
    assert!(full.frames > 4 && full.frames < 16, "{full:?}");
    let expected = newest - (full.frames as f64 - 1.0) / 60.0;
    assert!(full.span.is_some_and(|span| (span[0] - expected).abs() < 1e-9), "the oldest went first: {full:?}");
    // What is dropped cannot be shown: the nearest that is left is.
    let oldest = full.span.expect("frames")[0];
    ask(&worker, SimCommand::Show(0.0));
    until(&worker, |p| p.status.recording.in_replay && p.status.time == oldest);
    // Less memory drops more, also of what is being looked at.
    ask(&worker, SimCommand::Memory(before.bytes + each));
    let less = until(&worker, |p| p.status.recording.limit == before.bytes + each);
    assert!(less.status.recording.frames < full.frames && less.status.recording.bytes <= before.bytes + each);
    assert_eq!(less.status.recording.span.map(|span| span[0]), Some(less.status.time));
    // None at all is a bound, too.
    ask(&worker, SimCommand::Memory(0));
    until(&worker, |p| p.status.recording.frames == 0 && p.status.recording.bytes == 0);
}

fn until_timeline(worker: &Run) -> sinew::sim::RecordingStatus {
    ask(worker, SimCommand::Speed(1.0));
    until(worker, |_| true).status.recording.clone()
}

/// Memory of the first frame alone, with what it goes with.
fn first_bytes(worker: &Run) -> usize {
    let span = until_timeline(worker).span.expect("frames");
    ask(worker, SimCommand::Reset);
    let one = until(worker, |p| p.status.recording.frames == 1).status.recording.bytes;
    while until_timeline(worker).span.is_some_and(|now| now[1] < span[1]) {
        advance(worker, 1);
    }
    one
}

#[test]
fn a_replay_shows_what_was_kept_and_computes_nothing() {
    let worker = start(BREAKING);
    let first = advance(&worker, 12);
    let last = *first.keys().next_back().expect("frames");
    let kept = until_timeline(&worker);
    // Slowly, so that a busy machine sees something of it.
    ask(&worker, SimCommand::Speed(0.2));
    ask(&worker, SimCommand::Replay);
    until(&worker, |p| p.status.recording.in_replay);
    let mut seen = 0;
    loop {
        let p = until(&worker, |_| true);
        assert_eq!(p.status.recording.span, kept.span, "nothing is added");
        assert_eq!(p.status.recording.bytes, kept.bytes);
        if let Some(frame) = first.get(&key(&p)) {
            same(&p, frame);
            seen += 1;
        }
        if !p.status.recording.in_replay {
            assert!(key(&p) == last && !p.status.playing, "it holds at the end");
            break;
        }
        assert!(p.status.playing);
    }
    assert!(seen >= 2, "{seen} of {} frames were seen", first.len());
    ask(&worker, SimCommand::Speed(1.0));
    // Played from an earlier frame it goes on where the recording ends.
    show(&worker, f64::from_bits(*first.keys().next().expect("frames")));
    ask(&worker, SimCommand::Play);
    let on = until(&worker, |p| key(p) > last && !p.status.recording.in_replay);
    assert!(on.status.playing);
    ask(&worker, SimCommand::Pause);
    until(&worker, |p| !p.status.playing);
    // Nothing was dropped, and the frames are those of the first time.
    for frame in first.values() {
        same(&show(&worker, frame.status.time), frame);
    }
}

#[test]
fn frames_are_stepped_through_one_by_one() {
    let worker = start(BREAKING);
    let first = advance(&worker, 5);
    let times: Vec<f64> = std::iter::once(0.0).chain(first.values().map(|p| p.status.time)).collect();
    for time in times[..5].iter().rev() {
        ask(&worker, SimCommand::StepBack);
        until(&worker, |p| p.status.time == *time && p.status.recording.in_replay && !p.status.playing);
    }
    // There is none before the first.
    ask(&worker, SimCommand::StepBack);
    assert_eq!(until(&worker, |_| true).status.time, 0.0);
    for (k, time) in times.iter().enumerate().skip(1) {
        ask(&worker, SimCommand::Step);
        until(&worker, |p| p.status.time == *time && p.status.recording.in_replay == (k < 5));
    }
    // Beyond the last one it is computed.
    ask(&worker, SimCommand::Step);
    let next = until(&worker, |p| p.status.time > times[5]);
    assert_eq!(next.status.recording.frames, 7);
}

#[test]
fn the_newest_of_many_wishes_is_shown_and_looking_changes_nothing() {
    let worker = start(BREAKING);
    let first = advance(&worker, 10);
    ask(&worker, SimCommand::Strike { body: 0, impulse: DVec3::new(1e-2, 0.0, 0.0) });
    let times: Vec<f64> = first.values().map(|p| p.status.time).collect();
    for k in 0..100 {
        ask(&worker, SimCommand::Show(times[k % 10]));
    }
    ask(&worker, SimCommand::Show(times[4] + 1e-3));
    until(&worker, |p| p.status.time == times[4]);
    ask(&worker, SimCommand::Live);
    until(&worker, |p| !p.status.recording.in_replay);
    // The strike after the last frame is not lost.
    let struck = advance(&worker, 1);
    let worker = start(BREAKING);
    advance(&worker, 10);
    ask(&worker, SimCommand::Strike { body: 0, impulse: DVec3::new(1e-2, 0.0, 0.0) });
    let expected = advance(&worker, 1);
    same(struck.values().next().expect("a frame"), expected.values().next().expect("a frame"));
}
