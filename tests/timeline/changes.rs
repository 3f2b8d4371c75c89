//! What becomes of the frames when the scene or the motion is changed, and what is beside them.

use super::{
    BREAKING, TWO_LAYER, advance, all_are_shown_again, ask, bits, going_on_gives_the_same, key, same, scene, show,
    start, until,
};
use glam::DVec3;
use sinew::scene::{IntegratorKind, TimeStep};
use sinew::sim::SimCommand;
use sinew::solver::FieldKind;
use std::sync::Arc;

#[test]
fn a_strike_on_an_earlier_frame_goes_on_from_there() {
    let worker = start(BREAKING);
    let first = advance(&worker, 10);
    let times: Vec<f64> = first.values().map(|p| p.status.time).collect();
    show(&worker, times[3]);
    ask(&worker, SimCommand::Strike { body: 0, impulse: DVec3::new(0.0, 0.0, 5e-2) });
    let struck = until(&worker, |p| !p.status.recording.in_replay);
    assert_eq!(struck.status.time, times[3]);
    let timeline = &struck.status.recording;
    assert_eq!(timeline.span, Some([0.0, times[3]]));
    assert_eq!(timeline.continued.0, 1);
    assert!(timeline.continued.1.contains("6 later frames were dropped"), "{:?}", timeline.continued);
    let next = advance(&worker, 1);
    let next = next.values().next().expect("a frame");
    assert_eq!(next.status.time, times[4]);
    assert_ne!(bits(&next.snapshot), bits(&first[&key(next)].snapshot), "it was struck");
}

#[test]
fn an_edit_keeps_earlier_frames_and_drops_later_ones() {
    let worker = start(BREAKING);
    let first = advance(&worker, 10);
    let times: Vec<f64> = first.values().map(|p| p.status.time).collect();
    let mut soft = (*scene(BREAKING)).clone();
    soft.bodies[0].material.young_modulus = 5e4;
    show(&worker, times[5]);
    ask(&worker, SimCommand::Edit(Arc::new(soft)));
    let edited = until(&worker, |p| p.status.edits == 1 && !p.status.recording.in_replay);
    assert_eq!(edited.status.recording.span, Some([0.0, times[5]]));
    assert_eq!(bits(&edited.snapshot), bits(&first[&times[5].to_bits()].snapshot), "it begins where that frame is");
    let second = advance(&worker, 4);
    let marked = second.values().next_back().expect("frames");
    assert_eq!(marked.status.recording.edits, [times[5]]);
    // Frames of before can be looked at, with their fields, and are what they were.
    ask(&worker, SimCommand::Field(Some(FieldKind::Stress)));
    let old = show(&worker, times[2]);
    assert_eq!(bits(&old.snapshot), bits(&first[&times[2].to_bits()].snapshot));
    assert!(old.status.recording.of_another_scene);
    assert!(old.snapshot.field.as_ref().is_some_and(|field| !field.bodies[0].is_empty()));
    ask(&worker, SimCommand::Field(None));
    let new = show(&worker, marked.status.time);
    assert!(!new.status.recording.of_another_scene);
    same(&new, marked);
    // What goes on from one of before is the present scene in that motion.
    show(&worker, times[2]);
    ask(&worker, SimCommand::ContinueHere);
    ask(&worker, SimCommand::Pause);
    let on = until(&worker, |p| !p.status.recording.in_replay && !p.status.playing);
    assert!(on.status.recording.continued.1.contains("with the present scene"), "{:?}", on.status.recording.continued);
    let softer = advance(&worker, 2);
    let moved = softer.values().find(|p| first.contains_key(&key(p)));
    let moved = moved.expect("times go on in whole frames");
    assert_ne!(bits(&moved.snapshot), bits(&first[&key(moved)].snapshot), "the material is another one");
}

#[test]
fn another_look_leaves_the_recording_as_it_is() {
    let worker = start(BREAKING);
    let times: Vec<f64> = advance(&worker, 10).values().map(|p| p.status.time).collect();
    let seen = show(&worker, times[3]);
    let mut hidden = (*scene(BREAKING)).clone();
    hidden.bodies[0].fibres[0].hidden = true;
    hidden.bodies[0].color = Some([9, 9, 9]);
    ask(&worker, SimCommand::Edit(Arc::new(hidden)));
    let after = until(&worker, |p| p.status.edits == 1);
    assert!(after.status.recording.in_replay && after.status.recording.frames == seen.status.recording.frames);
    assert!(Arc::ptr_eq(&after.at_rest, &seen.at_rest), "nothing was put together anew");
    same(&after, &seen);
}

#[test]
fn another_name_keeps_the_readings_and_another_body_is_counted_as_lost() {
    let mut two = (*scene(BREAKING)).clone();
    let mut other = two.bodies[0].clone();
    (other.id, other.name) = ("other".to_owned(), "Other".to_owned());
    other.placement.translation[0] += 0.2;
    two.bodies.push(other);
    let worker = start(&sinew::io::scene_to_json(&two));
    advance(&worker, 5);
    let rows = || worker.time_series(|recorded| (recorded.world.len(), recorded.world.dropped()));
    assert_eq!(rows(), (6, 0));
    two.bodies[1].name = "Renamed".to_owned();
    ask(&worker, SimCommand::Edit(Arc::new(two.clone())));
    until(&worker, |p| p.status.bodies.iter().any(|body| body.name == "Renamed"));
    assert_eq!(rows(), (6, 0));
    let named = |text: &str| {
        worker.time_series(|recorded| recorded.world.columns().iter().any(|column| column.name.starts_with(text)))
    };
    // Columns are named by what does not change.
    assert!(named("other: ") && !named("Renamed: "));
    two.bodies[0].fibres.clear();
    ask(&worker, SimCommand::Edit(Arc::new(two.clone())));
    until(&worker, |p| p.status.edits == 2 && p.status.baking.is_none());
    assert_eq!(rows(), (6, 0), "what is of fibres goes, and nothing else");
    assert!(!named(&format!("{}: breaks", two.bodies[0].id)) && named("other: breaks"));
    two.bodies.pop();
    ask(&worker, SimCommand::Edit(Arc::new(two)));
    until(&worker, |p| p.status.bodies.len() == 1);
    assert_eq!(rows(), (1, 6));
}

#[test]
fn a_document_that_cannot_be_put_together_leaves_nothing_of_the_last_one() {
    let worker = start(BREAKING);
    advance(&worker, 3);
    let mut thin = (*scene(BREAKING)).clone();
    thin.bodies[0].material.support_radius = 1e-9;
    ask(&worker, SimCommand::Open(Arc::new(thin), Arc::default()));
    let opened = until(&worker, |p| p.status.failure.is_some());
    assert!(opened.snapshot.bodies.is_empty() && opened.at_rest.bodies.is_empty());
    assert_eq!(opened.status.recording.span, None);
    assert!(worker.time_series(|recorded| recorded.world.is_empty()));
}

#[test]
fn a_reset_and_another_document_empty_the_recording() {
    let worker = start(BREAKING);
    advance(&worker, 6);
    show(&worker, 0.05);
    ask(&worker, SimCommand::Reset);
    let reset = until(&worker, |p| p.status.recording.frames == 1);
    assert!(reset.status.time == 0.0 && !reset.status.recording.in_replay);
    advance(&worker, 6);
    show(&worker, 0.05);
    ask(&worker, SimCommand::Open(scene(TWO_LAYER), Arc::default()));
    let opened = until(&worker, |p| p.snapshot.bodies.len() == 2);
    assert!(opened.status.recording.frames == 1 && !opened.status.recording.in_replay);
}

#[test]
fn the_ghost_is_kept_in_step() {
    let worker = start(BREAKING);
    advance(&worker, 4);
    let mut bare = (*scene(BREAKING)).clone();
    bare.bodies[0].fibres.clear();
    ask(&worker, SimCommand::Ghost(Some(Arc::new(bare))));
    until(&worker, |p| p.ghost.is_some());
    let first = advance(&worker, 10);
    assert!(first.values().all(|p| p.ghost.as_ref().is_some_and(|ghost| (ghost.time - p.status.time).abs() < 1e-9)));
    // Before it came there is none to be seen.
    assert!(show(&worker, 1.0 / 60.0).ghost.is_none());
    all_are_shown_again(&worker, &first);
    going_on_gives_the_same(&worker, &first);
    // Where there was none yet, it joins.
    show(&worker, 1.0 / 60.0);
    ask(&worker, SimCommand::ContinueHere);
    until(&worker, |p| {
        let ghost = p.ghost.as_ref().map_or(0.0, |ghost| ghost.time);
        !p.status.recording.in_replay && p.status.time > 0.1 && (ghost - p.status.time).abs() < 1e-9
    });
}

#[test]
fn comparing_records_nothing() {
    let worker = start(TWO_LAYER);
    let first = advance(&worker, 4);
    let frame = first.values().next().expect("a frame");
    show(&worker, frame.status.time);
    let integrators = vec![IntegratorKind::LeapFrog, IntegratorKind::Rk4];
    ask(&worker, SimCommand::Compare { integrators, dt: 1e-3 });
    ask(&worker, SimCommand::Play);
    let compared = until(&worker, |p| p.compared.len() == 2 && p.status.time > 0.1);
    assert!(compared.status.recording.frames == 5 && !compared.status.recording.in_replay);
    for command in [SimCommand::Show(0.0), SimCommand::StepBack, SimCommand::Replay] {
        ask(&worker, command);
    }
    ask(&worker, SimCommand::Compare { integrators: Vec::new(), dt: 1e-3 });
    ask(&worker, SimCommand::Pause);
    let ended = until(&worker, |p| p.compared.is_empty());
    assert!(!ended.status.recording.in_replay);
    same(&show(&worker, frame.status.time), frame);
}

#[test]
fn a_body_that_diverged_is_taken_up_before_that() {
    let worker = start(BREAKING);
    let first = advance(&worker, 6);
    let mut rough = (*scene(BREAKING)).clone();
    rough.time.step = TimeStep::manual(1e-2, 2);
    ask(&worker, SimCommand::Edit(Arc::new(rough)));
    ask(&worker, SimCommand::Play);
    let stopped = until(&worker, |p| p.status.divergence.is_some());
    ask(&worker, SimCommand::Pause);
    let good = first.values().next_back().expect("frames");
    assert!(stopped.status.time > good.status.time);
    let before = show(&worker, good.status.time);
    assert!(before.status.divergence.is_none());
    same(&before, good);
    // What was wrong is mended, and the motion goes on from where it was sound.
    ask(&worker, SimCommand::Edit(scene(BREAKING)));
    until(&worker, |p| p.status.edits == 2 && p.status.time == good.status.time);
    let on = advance(&worker, 3);
    assert!(on.values().all(|p| p.status.divergence.is_none() && p.status.time > good.status.time));
}
