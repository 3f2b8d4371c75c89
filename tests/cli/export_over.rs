//! Motion that goes where something is already: what is read stays, what is old goes, what is there of a run that fails
//! is whole.

use super::Desk;
use super::export::{PRISM, desk, falling, mdd};
use super::export_clip::glb;
use serde_json::json;
use sinew::io::load_model;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

/// The falling prism alone, with its model under another name.
fn prism_from(path: &str, name: &str) -> serde_json::Value {
    let mut scene = falling();
    scene["two_layer"] = json!([]);
    scene["bodies"][0]["name"] = json!(name);
    scene["bodies"][0]["shape"]["mesh"]["path"] = json!(path);
    scene
}

#[test]
fn nothing_is_written_over_what_is_read() {
    let desk = desk();
    for name in ["frame_000001.obj", "block_rest.obj", "my model.ply.obj"] {
        fs::write(desk.path(name), PRISM).unwrap();
    }
    for (scene, model, body) in [
        ("of_frame.json", "frame_000001.obj", "block"),
        ("of_rest.json", "block_rest.obj", "block"),
        ("of_link.json", "prism.obj", "block"),
    ] {
        fs::write(desk.path(scene), prism_from(model, body).to_string()).unwrap();
    }
    let mut with_collider = falling();
    with_collider["colliders"] = json!([{"id": "slab", "shape": {"mesh": {"path": "slab.obj"}}}]);
    fs::write(desk.path("slab.obj"), PRISM).unwrap();
    fs::write(desk.path("on_slab.json"), with_collider.to_string()).unwrap();
    fs::write(desk.path("lines.csv"), "x,y,z\n0,0,0\n0,0.01,0\n0,0.02,0\n").unwrap();
    let mut cases = vec![
        ("simulate frame_000001.obj --out .", "the scene and --out"),
        ("simulate of_frame.json --format usd,obj --out .", "frame_000001.obj: a model of the scene and --out"),
        ("simulate of_frame.json --frames 1..1 --out ./", "frame_000001.obj: a model of the scene and --out"),
        ("simulate of_rest.json --format pc2 --out .", "block_rest.obj: a model of the scene and --out"),
        ("simulate of_rest.json --format csv,mdd --out .", "block_rest.obj: a model of the scene and --out"),
        ("simulate scene.json --report prism.obj", "a model of the scene and --report"),
        ("simulate on_slab.json --report slab.obj", "a model of the scene and --report"),
        ("fibres scene.json --to prism.obj", "a model of the scene and --to"),
        ("fibres scene.json --from lines.csv --out scene.json", "the scene and --out"),
        ("fibres scene.json --from lines.csv --out lines.csv", "--from and --out"),
    ];
    #[cfg(unix)]
    {
        fs::create_dir(desk.path("links")).unwrap();
        std::os::unix::fs::symlink("../prism.obj", desk.path("links/frame_000000.obj")).unwrap();
        cases.push(("simulate of_link.json --out links", "frame_000000.obj: a model of the scene and --out"));
    }
    let all = |desk: &Desk| -> Vec<(String, Option<Vec<u8>>)> {
        desk.files().into_iter().map(|name| (name.clone(), fs::read(desk.path(&name)).ok())).collect()
    };
    let before = all(&desk);
    for (command, part) in cases {
        let said = desk.run(command);
        assert_eq!(said.code, Some(2), "{command}: {said:?}");
        assert!(said.err.lines().last().unwrap().contains(part), "{command}: {}", said.err);
        assert!(said.err.contains("are the same file"), "{command}: {}", said.err);
        assert!(all(&desk) == before, "{command}");
    }
    // Beside what is read there is room: a body is called like its model.
    for command in ["simulate prism.obj --format pc2,mdd", "simulate of_frame.json --frames 2..3"] {
        assert_eq!(desk.run(&format!("{command} --seconds 0.06 --out .")).code, Some(0), "{command}");
    }
    assert!(fs::read_to_string(desk.path("prism.obj")).unwrap() == PRISM && desk.path("prism_rest.obj").is_file());
}

#[test]
fn a_material_or_group_of_one_body_is_not_that_of_the_next() {
    let desk = desk();
    let red = PRISM.replace("usemtl none\n", "");
    fs::write(desk.path("prism.obj"), &red).unwrap();
    let plain: Vec<&str> = PRISM.lines().filter(|line| !line.starts_with(['o', 'u', 'm'])).collect();
    fs::write(desk.path("plain.obj"), plain.join("\n")).unwrap();
    let mut scene = prism_from("prism.obj", "first");
    let mut second = scene["bodies"][0].clone();
    (second["id"], second["name"], second["fibres"]) = (json!("plain"), json!("second"), json!([]));
    (second["shape"]["mesh"]["path"], second["placement"]["translation"]) = (json!("plain.obj"), json!([1, 1, 1]));
    scene["bodies"].as_array_mut().unwrap().push(second);
    fs::write(desk.path("scene.json"), scene.to_string()).unwrap();
    desk.ran("simulate scene.json --frames 0..0 --out out");
    let model = load_model(&desk.path("out/frame_000000.obj")).unwrap();
    let parts = &model.file.as_ref().unwrap().parts;
    let found: Vec<_> = parts.iter().map(|part| (&*part.name, &*part.material, part.faces.clone())).collect();
    assert_eq!(found, [("sides", "red_paint", 0..6), ("caps", "red_paint", 6..8), ("second", "none", 8..16)]);
    // The fibre between them is of neither.
    desk.ran("fibres scene.json --from out/frame_000000.obj --out new.json");
    assert_eq!(desk.json("new.json")["bodies"][0]["fibres"][1]["id"], "axis-2");
}

/// The files of a folder, by their names.
fn contents(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let each =
        super::names(folder).into_iter().filter_map(|name| Some((name.clone(), fs::read(folder.join(name)).ok()?)));
    each.collect()
}

#[test]
fn an_earlier_run_stays_whole_until_a_later_one_has_a_frame() {
    let desk = desk();
    desk.ran("simulate scene.json --format usd,pc2,mdd --frames 0..4 --out out");
    let folders = ["out", "out/motion_layers"].map(|folder| desk.path(folder));
    let before = folders.clone().map(|folder| contents(&folder));
    assert_eq!(before[0].len(), 7, "{:?}", before[0].keys());
    for stray in ["out/.sinew-dead.tmp", "out/motion_layers/.sinew-dead.tmp"] {
        fs::write(desk.path(stray), "left by a run that was killed").unwrap();
    }
    // A folder is where the first frame's file goes.
    fs::create_dir(desk.path("out/frame_000000.obj")).unwrap();
    let said = desk.run("simulate scene.json --format obj,usd,pc2,mdd --frames 0..4 --out out");
    assert_eq!(said.code, Some(2), "{said:?}");
    assert!(said.err.contains("frame_000000.obj: the file cannot be written"), "{}", said.err);
    assert!(contents(&folders[0]) == before[0], "{:?}", super::names(&folders[0]));
    let layers = contents(&folders[1]);
    assert!(before[1].iter().all(|(name, bytes)| layers.get(name) == Some(bytes)), "{:?}", layers.keys());
    assert!(layers.keys().all(|name| Path::new(name).extension().is_some_and(|ending| ending == "usda")));
    // With a frame it takes the place of the earlier one, whose layers nothing names any more.
    fs::remove_dir(desk.path("out/frame_000000.obj")).unwrap();
    for turn in ["-2", ""] {
        desk.ran("simulate scene.json --format usd,pc2,mdd --frames 0..1 --out out");
        let named = ["frame#.000000.usda", "frame#.000001.usda", "manifest#.usda", "shape#.usda"];
        assert_eq!(super::names(&folders[1]), named.map(|name| name.replace('#', turn)));
        let stage = desk.text("out/motion.usda");
        assert!(stage.contains(&format!("@./motion_layers/shape{turn}.usda@")), "{stage}");
        assert!(stage.contains(&format!("\"./motion_layers/frame{turn}.######.usda\"")), "{stage}");
        assert_eq!(mdd(&fs::read(desk.path("out/Red_prism_1.mdd")).unwrap()).0.len(), 2);
    }
    // What was not written is not said to be.
    let mut still = falling();
    still["gravity"] = json!([0, 0, 0]);
    still["two_layer"] = json!([]);
    fs::write(desk.path("still.json"), still.to_string()).unwrap();
    let run = "simulate still.json --until-rest --seconds 20 --frames 900..910 --format usd,pc2,mdd,gltf,obj,ply,csv --out none";
    let said = desk.run(run);
    assert_eq!(said.code, Some(0), "{said:?}");
    assert!(!said.out.contains("written to"), "{}", said.out);
}

#[test]
fn a_run_that_fails_leaves_all_of_its_frames() {
    let desk = desk();
    fs::create_dir_all(desk.path("out/frame_000009.obj")).unwrap();
    let said = desk.run("simulate scene.json --format mdd,gltf,obj --frames 0..10 --out out");
    assert_eq!(said.code, Some(2), "{said:?}");
    assert_eq!(mdd(&fs::read(desk.path("out/Red_prism_1.mdd")).unwrap()).0.len(), 10);
    let (document, _) = glb(&fs::read(desk.path("out/motion.glb")).unwrap());
    assert_eq!(document["meshes"][0]["primitives"][0]["targets"].as_array().unwrap().len(), 10);
}
