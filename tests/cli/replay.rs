//! A journal's motion is made again, to the same bits or to a sentence that says where it parts.

use super::Desk;
use super::balance::gaining;
use serde_json::{Value, json};
use sinew::io::scene_from_json;
use sinew::sim::{SimCommand, Worker};
use std::fs;
use std::sync::Arc;
use std::time::{Duration, Instant};

/// A cube in mid air that was struck after its first frame and grabbed after its second, for four frames.
fn desk() -> Desk {
    let scene = json!({"version": 1, "bodies": [{"id": "cube", "name": "Cube",
        "shape": {"box": {"size": [0.03, 0.03, 0.03]}},
        "material": {"young_modulus": 1e5, "mass": {"per_particle": 4e-4}, "support_radius": 0.015}}]});
    let asked = [
        SimCommand::Step,
        SimCommand::Strike { body: 0, impulse: [1e-3, 0.0, 0.0].into() },
        SimCommand::Step,
        SimCommand::Grab { body: 0, vertex: 0, target: [0.0, 0.1, 0.0].into() },
        SimCommand::Step,
        SimCommand::Step,
    ];
    recorded(&scene, asked, 4)
}

/// The journal of a scene to which this was done, for so many frames.
fn recorded(scene: &Value, asked: impl IntoIterator<Item = SimCommand>, frames: u64) -> Desk {
    let desk = Desk::new(scene);
    let scene = scene_from_json(&scene.to_string()).expect("a scene");
    let worker = Worker::start(Arc::new(scene), Arc::default(), false, || {});
    let begun = Instant::now();
    let until = |frames: u64| {
        while worker.journal().frames() < frames {
            assert!(begun.elapsed() < Duration::from_mins(2), "the frames never came");
            std::thread::yield_now();
        }
    };
    let mut stepped = 0;
    for command in asked {
        let is_step = matches!(command, SimCommand::Step);
        assert!(worker.send(command));
        // What comes behind a frame that takes long is done before it.
        stepped += u64::from(is_step);
        until(stepped);
    }
    until(frames);
    let journal = serde_json::to_string(&worker.journal()).expect("JSON");
    fs::write(desk.path("journal.json"), journal).expect("it is written");
    desk
}

#[test]
fn a_journal_comes_to_the_same_bits_on_any_number_of_threads_and_a_changed_one_is_told() {
    let desk = desk();
    let said = desk.done("replay journal.json --report report.json");
    assert!(said.contains("4 frames, each to the same bits"), "{said}");
    let report = desk.json("report.json");
    assert_eq!((&report["frames"], &report["bodies"][0]["id"]), (&json!(4), &json!("cube")));
    let said = desk.done("replay journal.json --threads 1,2,5");
    assert!(said.contains("4 frames, the same bits on 1, 2, 5 threads"), "{said}");
    // Struck harder than it was: all is the same before that.
    let mut changed: Value = desk.json("journal.json");
    changed["asked"][1]["what"]["strike"]["impulse"] = json!([2e-3, 0, 0]);
    assert_eq!(changed["asked"][1]["frame"], 1, "{}", changed["asked"]);
    fs::write(desk.path("changed.json"), changed.to_string()).expect("it is written");
    let said = desk.run("replay changed.json");
    assert!(said.code == Some(1) && said.out.contains("other bits from frame 2 on"), "{said:?}");
}

#[test]
fn what_gained_energy_is_told_again() {
    let desk = recorded(&gaining(), std::iter::repeat_n(SimCommand::Step, 3), 3);
    let said = desk.run("replay journal.json");
    assert_eq!(said.code, Some(0), "{said:?}");
    let warnings: Vec<&str> = said.err.lines().filter(|line| line.contains("that nothing gave")).collect();
    assert!(warnings.len() == 1 && warnings[0].contains("body \"Block\" gained"), "{said:?}");
}

#[test]
fn what_is_no_journal_is_refused() {
    let desk = desk();
    let line = desk.refused("replay scene.json");
    assert!(line.contains("scene.json: it is no journal of the window"), "{line}");
    let mut journal: Value = desk.json("journal.json");
    journal["scene"]["bodies"][0]["material"]["young_modulus"] = json!(-1);
    fs::write(desk.path("journal.json"), journal.to_string()).expect("it is written");
    let line = desk.refused("replay journal.json");
    assert!(line.contains("a scene in it cannot be used") && line.contains("young_modulus"), "{line}");
    desk.refused("replay nowhere.json");
}
