//! Shared drives that a hand leads: the muscle moves at once, and what was played is kept, made again and keyed, bit
//! for bit.

use crate::{Run, advance, all_are_shown_again, ask, same, show, start, until};
use sinew::scene::{Assets, Drive, Scene};
use sinew::sim::{Journal, Rerun, SimCommand};

/// A bar, held at one end, with a fibre and a pin that follow a drive each, and one along which a wave runs.
fn acting() -> String {
    let fibre = |id: &str, y: f64, drive: &str| {
        format!(
            r#"{{"id": "{id}", "source": {{"vertices": [[-0.02, {y}, 0], [0, {y}, 0], [0.02, {y}, 0]]}},
                "stiffness": {{"rigidity": {{"ea": 20, "ei": 0}}}}, "volume_fraction": 0.5,
                "activation": {{"drive": {{"shared": "{drive}"}}, "contract": 0.4}}}}"#
        )
    };
    format!(
        r#"{{"version": 1, "gravity": [0, 0, 0], "bodies": [{{"id": "bar", "shape": {{"box": {{"size": [0.05, 0.02, 0.02]}}}},
        "material": {{"young_modulus": 20000, "mass": {{"density": 1000}}, "support_radius": 0.0125, "damping": {{"pair": 20}}}},
        "drives": [
            {{"id": "pull", "drive": {{"keyframes": {{"keys": [{{"time": 0, "value": 0}}, {{"time": 9, "value": 1}}],
                "between": "linear"}}}}}},
            {{"id": "way", "drive": {{"keyframes": {{"keys": [{{"time": 0, "value": 0}}, {{"time": 9, "value": 1}}],
                "between": "linear"}}}}}},
            {{"id": "wave", "drive": {{"wave": {{"period": 0.2, "wavelength": 0.03}}}}}}],
        "fibres": [{}, {}],
        "regions": [{{"id": "end", "select": {{"layers": {{"axis": "x", "side": "min", "count": 1}}}}}}],
        "pins": [{{"id": "hold", "region": "end",
            "motion": {{"driven": {{"drive": {{"shared": "way"}}, "offset": [0, 0.004, 0]}}}}}}]}}]}}"#,
        fibre("a", 0.004, "pull"),
        fibre("b", -0.004, "wave"),
    )
}

fn lead(worker: &Run, drive: &str, aim: impl Into<Option<f64>>) {
    ask(worker, SimCommand::Lead { body: 0, drive: drive.to_owned(), aim: aim.into() });
}

/// Plays on a muscle, and on where a pin is: to both ends of what they may be, and between.
fn play(worker: &Run, with_pin: bool) -> crate::Shown {
    let mut shown = crate::Shown::new();
    for (pull, way, frames) in [(1.0, 0.25, 3), (0.3, 1.0, 2), (0.8, 0.0, 4)] {
        // Of places between two frames only the last counts.
        lead(worker, "pull", 0.9 * pull);
        lead(worker, "pull", pull);
        if with_pin {
            lead(worker, "way", way);
        }
        shown.extend(advance(worker, frames));
    }
    shown
}

/// How far particles are from where they are in another run [m], at the most over all frames.
fn furthest(one: &crate::Shown, other: &crate::Shown) -> f64 {
    let pairs = one.iter().map(|(time, frame)| (frame, other.get(time).expect("the same frames")));
    let particles = |published: &sinew::sim::Published| published.snapshot.bodies[0].particles.clone();
    let apart = pairs.flat_map(|(one, other)| particles(one).into_iter().zip(particles(other)));
    apart.map(|(a, b)| a.distance(b)).fold(0.0, f64::max)
}

fn rerun(journal: Journal) -> u64 {
    let mut rerun = Rerun::new(journal, Assets::default()).expect("a scene that bakes");
    let mut agreed = 0;
    while rerun.advance().expect("it goes on") {
        agreed += u64::from(rerun.agrees());
    }
    agreed
}

#[test]
fn a_hand_moves_the_muscle_now_and_its_journal_makes_the_motion_again() {
    let [played, free] = [(); 2].map(|()| start(&acting()));
    let value = |worker: &Run, id: &str| {
        ask(worker, SimCommand::Speed(1.0));
        let published = until(worker, |p| !p.status.drives.is_empty());
        let drive = published.status.drives.iter().find(|drive| drive.id == id).cloned();
        drive.expect("it is told of")
    };
    assert_eq!((value(&played, "pull").value, value(&played, "pull").limits), (0.0, [0.0, 1.0]));
    let shown = play(&played, true);
    let left = advance(&free, 9);
    assert!((value(&played, "pull").value - 0.8).abs() < 1e-12 && value(&played, "pull").is_led);
    // Out of its range it stays at the end of that.
    lead(&played, "pull", 7.0);
    advance(&played, 1);
    assert_eq!(value(&played, "pull").value, 1.0);
    let apart = furthest(&shown, &left);
    assert!(apart > 5e-4, "what follows has moved by {apart} m");
    // A wave that runs along a fibre is led, too, and comes back to itself.
    lead(&played, "wave", 0.5);
    advance(&played, 2);
    assert!(value(&played, "wave").is_led);
    lead(&played, "wave", None);
    lead(&played, "pull", None);
    advance(&played, 2);
    let free_again = value(&played, "pull");
    assert!(!free_again.is_led && free_again.value < 0.05, "{free_again:?}");
    let journal = played.journal();
    let text = serde_json::to_string(&journal).expect("JSON");
    let read: Journal = serde_json::from_str(&text).expect("the journal");
    assert_eq!((rerun(read), journal.frames()), (14, 14));
}

#[test]
fn frames_that_were_played_are_shown_again_and_gone_on_from() {
    let worker = start(&acting());
    let shown = play(&worker, true);
    all_are_shown_again(&worker, &shown);
    let frames: Vec<_> = shown.values().cloned().collect();
    // From the fourth frame on without what came after it: the first values are held.
    show(&worker, frames[3].status.time);
    ask(&worker, SimCommand::ContinueHere);
    ask(&worker, SimCommand::Pause);
    until(&worker, |p| !p.status.recording.in_replay && !p.status.playing);
    let other = start(&acting());
    lead(&other, "pull", 1.0);
    lead(&other, "way", 0.25);
    advance(&other, 3);
    lead(&other, "pull", 0.3);
    lead(&other, "way", 1.0);
    let expected = advance(&other, 8);
    let reached = worker.journal().frames();
    let more = advance(&worker, 2);
    for (time, frame) in &more {
        same(frame, expected.get(time).unwrap_or_else(|| panic!("frame {reached} was computed")));
    }
}

/// The scene of a journal with what was played in it as keys.
fn keyed(journal: &Journal, ids: &[&str]) -> Scene {
    let mut scene: Scene = (*journal.scene).clone();
    for shared in scene.bodies[0].drives.iter_mut().filter(|shared| ids.contains(&shared.id.as_str())) {
        shared.drive = journal.performed(0, &shared.id, &shared.drive).expect("it was played");
    }
    scene
}

/// A motion's hashes, and those of its scene with what was played in it as keys, from the start.
fn played_again(worker: &Run, ids: &[&str]) -> [Vec<String>; 2] {
    let journal = worker.journal();
    let again = start(&sinew::io::scene_to_json(&keyed(&journal, ids)));
    advance(&again, journal.frames() as usize);
    [again.journal().hashes, journal.hashes]
}

#[test]
fn what_was_played_becomes_keys_with_the_same_bits() {
    let worker = start(&acting());
    play(&worker, true);
    assert!(worker.journal().performed(0, "wave", &Drive::Constant(0.5)).is_none(), "no hand led it");
    let scene = keyed(&worker.journal(), &["pull", "way"]);
    for shared in &scene.bodies[0].drives[..2] {
        let Drive::Keyframes(keys) = &shared.drive else { panic!("{shared:?}") };
        let times: Vec<f64> = keys.keys.iter().map(|key| key.time).collect();
        assert!(times.len() == 6 && times.windows(2).all(|pair| pair[0] < pair[1]), "{times:?}");
    }
    let [again, played] = played_again(&worker, &["pull", "way"]);
    assert_eq!(again, played);
}

#[test]
fn what_drives_are_by_themselves_stays_before_between_and_after() {
    let smooth = acting().replacen(r#""between": "linear""#, r#""between": "smooth""#, 1);
    let worker = start(&smooth);
    // Taken in mid-motion, led on, let go, left alone, taken again; along a fibre, too.
    advance(&worker, 2);
    for (pull, wave, frames) in
        [(Some(0.9), Some(0.2), 2), (Some(0.4), Some(0.8), 1), (None, None, 3), (Some(0.7), Some(1.0), 2)]
    {
        lead(&worker, "pull", pull);
        lead(&worker, "wave", wave);
        advance(&worker, frames);
    }
    lead(&worker, "wave", None);
    advance(&worker, 3);
    let [again, played] = played_again(&worker, &["pull", "wave"]);
    let first = again.iter().zip(&played).position(|(one, other)| one != other);
    assert_eq!((first, again.len()), (None, 13));
    // It does make a difference.
    let other = start(&smooth);
    advance(&other, 13);
    assert!(other.journal().hashes[2..].iter().zip(&played[2..]).all(|(one, other)| one != other));
    assert_eq!(other.journal().hashes[..2], played[..2]);
    // Played on top of what was recorded, from before it on, it takes its place.
    let scene = keyed(&worker.journal(), &["pull"]);
    let over = start(&sinew::io::scene_to_json(&scene));
    advance(&over, 1);
    lead(&over, "pull", 0.5);
    advance(&over, 4);
    let [again, played] = played_again(&over, &["pull"]);
    assert_eq!(again, played);
    let Drive::Keyframes(keys) = &keyed(&over.journal(), &["pull"]).bodies[0].drives[0].drive else { panic!("keys") };
    let otherwise = keys.otherwise.as_ref().expect("what it was");
    assert!(matches!(&*otherwise.drive, Drive::Keyframes(own) if own.otherwise.is_none()), "{otherwise:?}");
}
