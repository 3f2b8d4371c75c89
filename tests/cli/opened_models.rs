//! Models in the place of scenes.

use super::{Desk, pressed};
use std::fs;

/// A box of 0.2 x 0.3 x 0.1 units times `scale`, its lower corner at the origin.
fn block(scale: f64) -> String {
    let corner = |k: u32| {
        let at = |bit: u32, size: f64| scale * size * f64::from(bit & 1);
        format!("v {} {} {}\n", at(k, 0.2), at(k >> 1, 0.3), at(k >> 2, 0.1))
    };
    (0..8).map(corner).collect::<String>() + "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n"
}

fn desk() -> Desk {
    let desk = Desk::new(&pressed());
    fs::write(desk.path("block.obj"), block(1.0)).expect("the model is written");
    desk
}

#[test]
fn a_model_runs_as_a_soft_solid_above_a_floor() {
    let desk = desk();
    let said = desk.run("simulate block.obj --seconds 0.05 --report r.json --out frames");
    assert_eq!(said.code, Some(0), "{said:?}");
    assert!(
        said.err.contains("note: /bodies/0: the model is made a soft solid of about 800 particles"),
        "{}",
        said.err
    );
    assert!(!said.err.contains("scaled") && !said.err.contains("warning"), "{}", said.err);
    assert!(said.out.starts_with("block: 0.05000 s in 3 frames"), "{}", said.out);
    let report = desk.json("r.json");
    assert_eq!((&report["scene"], &report["bodies"][0]["name"]), (&"block".into(), &"block".into()));
    assert!((600..1000).contains(&report["bodies"][0]["particles"].as_u64().expect("a number")), "{report}");
    // The corners of the file, lifted above the floor.
    let lowest = |name: &str| {
        let text = desk.text(name);
        let heights = text.lines().filter(|line| line.starts_with("v ")).map(|line| line.split(' ').nth(2).unwrap());
        heights.map(|y| y.parse::<f64>().unwrap()).fold(f64::INFINITY, f64::min)
    };
    assert!((lowest("frames/frame_000000.obj") - 0.15 * 0.3).abs() < 1e-9);
    assert!(lowest("frames/frame_000003.obj") < 0.15 * 0.3);
    // What it is made of can be set as in a scene.
    let said = desk.run("simulate block.obj --seconds 0 --set /bodies/0/shape/mesh/particles=100 --report r.json");
    assert_eq!(said.code, Some(0), "{said:?}");
    assert!(desk.json("r.json")["bodies"][0]["particles"].as_u64() < Some(150));
}

#[test]
fn a_model_in_other_units_is_brought_to_a_hands_size_and_that_is_said() {
    let desk = desk();
    fs::write(desk.path("large.obj"), block(1000.0)).expect("the model is written");
    let said = desk.run("simulate large.obj --seconds 0");
    assert!(said.err.contains("scaled by 4.000e-4 to 0.12 m: the file measures 3.000e2 units"), "{}", said.err);
}

#[test]
fn what_check_says_of_a_model_by_itself_is_what_running_it_comes_to() {
    let desk = desk();
    // One plate of which a layer holds together with more particles than are opened, and one for which they do.
    for (thickness, is_refused) in [(2e-5, true), (2e-3, false)] {
        let plate = block(1.0).replace("0.1\n", &format!("{thickness}\n"));
        fs::write(desk.path("plate.obj"), plate).expect("the model is written");
        let run = desk.run("simulate plate.obj --seconds 0");
        assert_eq!(run.code, Some(if is_refused { 2 } else { 0 }), "{run:?}");
        let checked = desk.run("check plate.obj");
        assert_eq!(checked.code, Some(0), "{checked:?}");
        assert_eq!(checked.err.contains("it is refused"), is_refused, "{}", checked.err);
        assert!(is_refused || checked.err.contains("opened by itself it gets"), "{}", checked.err);
    }
}

#[test]
fn every_command_that_takes_a_scene_takes_a_model() {
    let desk = desk();
    for command in [
        "sweep block.obj --seconds 0.02 --vary /bodies/0/material/young_modulus=1e4,2e4",
        "compare block.obj --seconds 0.001 --dt 0.0005 --integrators rk4 --set /bodies/0/shape/mesh/particles=100",
    ] {
        let said = desk.run(command);
        assert_eq!(said.code, Some(0), "{command}: {said:?}");
        let told = said.err.lines().filter(|line| line.contains("the model is made a soft solid"));
        assert_eq!(told.count(), 1, "{}", said.err);
    }
    if cfg!(not(feature = "render")) {
        let said = desk.run("render block.obj --out picture.png");
        assert_eq!(said.code, Some(2), "{said:?}");
        assert!(said.err.lines().last().is_some_and(|line| line.contains("built without pictures")), "{}", said.err);
    }
}

#[test]
fn what_is_wrong_with_a_model_is_said_of_the_model() {
    let desk = desk();
    fs::write(desk.path("sheet.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").expect("the model is written");
    for (command, expected) in [
        ("simulate none.obj", "error: none.obj: there is no such file; check the path"),
        ("simulate sheet.obj", "error: sheet.obj: the surface encloses nothing"),
        ("sweep none.stl --vary /time/duration=1", "error: none.stl: there is no such file"),
        ("compare none.glb", "error: none.glb: there is no such file"),
        ("simulate block.obj --report block.obj", "error: block.obj: the scene and --report are the same file"),
    ] {
        let said = desk.run(command);
        assert_eq!(said.code, Some(2), "{command}: {said:?}");
        assert!(said.err.lines().last().is_some_and(|line| line.starts_with(expected)), "{command}: {}", said.err);
    }
    assert_eq!(desk.text("block.obj"), block(1.0));
}

#[test]
fn corners_far_from_all_particles_are_written_where_the_file_put_them() {
    let desk = desk();
    let corner = "v 0 0 0\nv 3 0 0\nv 0 3 0\nv 0 0 3\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
    fs::write(desk.path("corner.obj"), corner).expect("the model is written");
    for particles in [100, 455, 2000] {
        let set = format!("/bodies/0/shape/mesh/particles={particles}");
        let said = desk.run(&format!("simulate corner.obj --seconds 0.1 --fps 20 --set {set} --out frames"));
        assert_eq!(said.code, Some(0), "{said:?}");
        let vertices = |frame: u32| -> Vec<[f64; 3]> {
            let text = desk.text(&format!("frames/frame_{frame:06}.obj"));
            let point = |line: &str| {
                let mut parts = line.split(' ').skip(1).map(|part| part.parse::<f64>().expect("a number"));
                std::array::from_fn(|_| parts.next().expect("three numbers"))
            };
            text.lines().filter(|line| line.starts_with("v ")).map(point).collect()
        };
        let start = vertices(0);
        for [x, y, z] in [[0.0; 3], [3.0, 0.0, 0.0], [0.0, 3.0, 0.0], [0.0, 0.0, 3.0]] {
            let is_there = |found: &[f64; 3]| {
                [found[0] - x, found[1] - y - 0.45, found[2] - z].iter().all(|part| part.abs() < 1e-8)
            };
            assert!(start.len() == 4 && start.iter().any(is_there), "{particles}: {start:?}");
        }
        for frame in 0..=2 {
            let all = vertices(frame);
            assert!(all.iter().flatten().all(|part| part.abs() < 10.0), "{particles}, frame {frame}: {all:?}");
        }
    }
}
