//! A motion is computed ahead, and then shown as fast as it was meant to be.

use super::{BREAKING, advance, ask, bits, key, same, show, start, until, until_timeline};
use sinew::sim::SimCommand;

#[test]
fn what_is_computed_ahead_is_what_would_have_been_and_is_shown_from_where_it_began() {
    let stepped = start(BREAKING);
    let first = advance(&stepped, 12);
    let times: Vec<f64> = first.values().map(|frame| frame.status.time).collect();
    let worker = start(BREAKING);
    advance(&worker, 3);
    // So slow by the clock that nine frames would take minutes.
    ask(&worker, SimCommand::Speed(0.001));
    ask(&worker, SimCommand::Compute(times[11] - times[2]));
    let ahead = until(&worker, |p| p.status.ahead.is_some());
    let [from, to] = ahead.status.ahead.expect("it is computed");
    assert!(from == times[2] && (to - times[11]).abs() < 1e-12, "{from} to {to}");
    ask(&worker, SimCommand::Speed(0.2));
    let shown = until(&worker, |p| p.status.recording.in_replay);
    assert!(shown.status.ahead.is_none() && shown.status.playing, "it plays by itself");
    assert!(shown.status.time < times[6], "from where it began: {}", shown.status.time);
    let end = until(&worker, |p| !p.status.recording.in_replay);
    assert!(!end.status.playing && end.status.time == times[11], "and holds at the end of what was asked for");
    for frame in first.values() {
        let again = show(&worker, frame.status.time);
        assert_eq!(key(&again), key(frame));
        same(&again, frame);
    }
}

#[test]
fn a_pause_ends_computing_ahead_and_keeps_what_is_there() {
    let worker = start(BREAKING);
    ask(&worker, SimCommand::Compute(1e4));
    until(&worker, |p| p.status.ahead.is_some() && p.status.recording.frames > 4);
    ask(&worker, SimCommand::Pause);
    let held = until(&worker, |p| !p.status.playing);
    assert!(held.status.ahead.is_none() && !held.status.recording.in_replay);
    let kept = until_timeline(&worker);
    assert!(kept.frames > 4);
    // What follows goes by the clock again, from there.
    let next = advance(&worker, 1);
    let next = next.values().next().expect("a frame");
    assert!(next.status.time > held.status.time);
    assert_ne!(bits(&next.snapshot), bits(&held.snapshot));
}

#[test]
fn an_edit_a_reset_and_a_look_back_end_computing_ahead() {
    let changed = super::scene(&BREAKING.replace("\"friction\": 0.4", "\"friction\": 0.3"));
    for command in [SimCommand::Reset, SimCommand::Show(0.0), SimCommand::Edit(changed)] {
        let worker = start(BREAKING);
        ask(&worker, SimCommand::Compute(1e4));
        until(&worker, |p| p.status.ahead.is_some() && p.status.recording.frames > 2);
        ask(&worker, command.clone());
        let p = until(&worker, |p| p.status.ahead.is_none());
        assert!(p.status.failure.is_none(), "{command:?}");
    }
}

#[test]
fn where_nothing_moves_any_more_nothing_is_computed_ahead() {
    // So long a step that the body is stopped at once.
    let step =
        r#""room": {"floor": 0, "friction": 0.4}, "time": {"step": {"manual": {"dt": 0.02, "substeps_per_frame": 1}}}"#;
    let worker = start(&BREAKING.replace(r#""room": {"floor": 0, "friction": 0.4}"#, step));
    ask(&worker, SimCommand::Compute(1e4));
    let stopped = until(&worker, |p| p.status.divergence.is_some() && p.status.ahead.is_none());
    assert!(stopped.status.recording.frames > 1, "{:?}", stopped.status.divergence);
    // Asked for once more it comes to nothing, and that is shown at once.
    ask(&worker, SimCommand::Live);
    until(&worker, |p| !p.status.recording.in_replay && !p.status.playing);
    ask(&worker, SimCommand::Compute(1e4));
    let p = until(&worker, |_| true);
    assert!(p.status.ahead.is_none(), "{:?}", p.status.ahead);
}
