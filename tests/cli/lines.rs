//! Fibres as lines of other programs and back, and scenes that take their models along.

use super::{Desk, names, pressed, program};
use serde_json::{Value, json};
use std::fs;

/// The pressed block turned and moved, with a second fibre, drawn by strokes.
fn turned() -> Value {
    let mut scene = pressed();
    scene["bodies"][0]["placement"] =
        json!({"translation": [0.3, -0.2, 7.0], "rotation": {"axis": [1, 2, 3], "degrees": 77}});
    let stroke =
        |view: &str| json!({"view": view, "points": [[0.001, 0.003], [-0.002, 0.012], [0.002, 0.021], [0.0, 0.033]]});
    let strokes = json!({"first": stroke("front"), "second": stroke("side")});
    scene["bodies"][0]["fibres"].as_array_mut().unwrap().push(
        json!({"id": "drawn", "source": {"strokes": strokes}, "stiffness": {"rigidity": {"ea": 50, "ei": 1e-5}}}),
    );
    scene
}

/// Vertices of the fibres of the first body of a scene file, by their identifiers.
fn vertices(desk: &Desk, scene: &str) -> Vec<(String, Vec<Vec<f64>>)> {
    let fibres = desk.json(scene)["bodies"][0]["fibres"].clone();
    let of = |fibre: &Value| {
        let vertices = serde_json::from_value(fibre["source"]["vertices"].clone()).unwrap_or_default();
        (fibre["id"].as_str().unwrap().to_owned(), vertices)
    };
    fibres.as_array().unwrap().iter().map(of).collect()
}

#[test]
fn fibres_that_go_out_as_lines_come_back_where_they_lay() {
    let desk = Desk::new(&turned());
    desk.done("fibres scene.json --to model.json --in model");
    let given = desk.json("model.json")["fibres"].clone();
    assert_eq!(given[0]["vertices"][3], json!([0.0, 0.024, 0.0]));
    for (file, options) in [
        ("lines.obj", ""),
        ("lines.csv", " --scale 1000 --up z"),
        ("lines.json", " --in model --scale 39.37"),
        ("lines.obj", " --body Block --up z"),
    ] {
        desk.done(&format!("fibres scene.json --to {file}{options}"));
        desk.done(&format!("fibres scene.json --set /bodies/0/fibres=[] --from {file} --out new.json{options}"));
        let found = vertices(&desk, "new.json");
        assert_eq!(found.len(), 2);
        for ((id, found), given) in found.iter().zip(given.as_array().unwrap()) {
            assert_eq!(id, given["fibre"].as_str().unwrap());
            let given: Vec<Vec<f64>> = serde_json::from_value(given["vertices"].clone()).unwrap();
            let pairs = found.iter().flatten().zip(given.iter().flatten());
            let apart = pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(found.len() == given.len() && apart < 1e-9, "{file}{options}: {apart}");
        }
    }
    // Beside those that are there they have names of their own; the scene runs with them.
    desk.done("fibres scene.json --from lines.obj --out new.json --up z");
    let ids: Vec<String> = vertices(&desk, "new.json").into_iter().map(|(id, _)| id).collect();
    assert_eq!(ids, ["axis", "drawn", "axis-2", "drawn-2"]);
    assert_eq!(desk.run("simulate new.json --seconds 0.02").code, Some(0));
}

#[test]
fn bodies_of_one_title_keep_their_fibres_apart() {
    let mut scene = turned();
    let mut other = scene["bodies"][0].clone();
    scene["bodies"][0]["id"] = json!("a.1");
    scene["bodies"][0]["fibres"][0]["id"] = json!("f.1 left");
    other["id"] = json!("b 2");
    other["placement"] = json!({"translation": [2, 0, 0]});
    other["fibres"][0]["id"] = json!("f.1 left");
    scene["bodies"].as_array_mut().unwrap().push(other);
    scene["measures"] = json!([]);
    let desk = Desk::new(&scene);
    desk.done("fibres scene.json --to given.json");
    let given = desk.json("given.json");
    assert_eq!(given["fibres"].as_array().unwrap().len(), 4);
    for file in ["lines.obj", "lines.csv", "lines.json"] {
        desk.done(&format!("fibres scene.json --to {file}"));
        let clear = "--set /bodies/0/fibres=[] --set /bodies/1/fibres=[]";
        desk.done(&format!("fibres scene.json {clear} --from {file} --out new.json"));
        desk.done("fibres new.json --to again.json");
        let again = desk.json("again.json");
        assert_eq!(again["fibres"].as_array().unwrap().len(), 4, "{file}");
        for (given, again) in given["fibres"].as_array().unwrap().iter().zip(again["fibres"].as_array().unwrap()) {
            assert_eq!(given["body"], again["body"], "{file}");
            assert_eq!(
                given["fibre"].as_str().unwrap().replace(' ', "_"),
                again["fibre"].as_str().unwrap().replace(' ', "_")
            );
            let length = |fibre: &Value| fibre["vertices"].as_array().unwrap().len();
            assert_eq!(length(given), length(again), "{file}");
        }
    }
    for options in ["--to lines.csv --body Block", "--from lines.csv --body Block --out new.json"] {
        let error = desk.refused(&format!("fibres scene.json {options}"));
        assert!(
            error.contains("several fibre solids are called \"Block\"; name one by its identifier: \"a.1\", \"b 2\""),
            "{error}"
        );
    }
    desk.done("fibres scene.json --to one.json --body a.1");
    assert_eq!(desk.json("one.json")["fibres"].as_array().unwrap().len(), 2);
    // A dot in a name of another program is a dot.
    fs::write(desk.path("named.obj"), "o hair.003\nv 2 0.01 0\nv 2 0.02 0\nv 2 0.03 0\nl 1 2 3\n").unwrap();
    let into = program()
        .current_dir(desk.path(""))
        .args(["fibres", "scene.json", "--from", "named.obj"])
        .args(["--out", "new.json", "--body", "b 2"])
        .status()
        .unwrap();
    assert!(into.success());
    assert_eq!(desk.json("new.json")["bodies"][1]["fibres"][2]["id"], "hair.003");
}

#[test]
fn lines_that_cannot_be_fibres_of_the_body_are_refused_with_figures() {
    let desk = Desk::new(&pressed());
    fs::write(desk.path("far.csv"), "x,y,z\n0,6,0\n0,12,0\n0,18,0\n").unwrap();
    fs::write(desk.path("short.obj"), "o a\nv 0 0.01 0\nv 0 0.02 0\nl 1 2\n").unwrap();
    fs::write(desk.path("empty.json"), "{\"fibres\": []}").unwrap();
    for (options, part) in [
        (
            "--from far.csv --out new.json",
            "far.csv: line 2: its vertices lie 5.967 to 17.97 m outside of body \"Block\"",
        ),
        (
            "--from short.obj --out new.json",
            "short.obj: line 4, \"a\": a fibre has 3 vertices at least, and this has 2",
        ),
        ("--from empty.json --out new.json", "empty.json: it holds no lines"),
        ("--from lines.txt --out new.json", "give .obj, .csv or .json"),
        ("--to lines.obj --body Arm", "no fibre solid is called \"Arm\"; name one by --body: the scene has \"Block\""),
    ] {
        let error = desk.refused(&format!("fibres scene.json {options}"));
        assert!(error.contains(part), "{options}: {error}");
    }
    desk.done("fibres scene.json --from far.csv --out new.json --scale 1000");
    assert_eq!(vertices(&desk, "new.json")[1].1, [[0.0, 0.006, 0.0], [0.0, 0.012, 0.0], [0.0, 0.018, 0.0]]);
    assert_eq!(desk.run("fibres scene.json").code, Some(2));
}

/// A cube as OBJ with a material in a folder of its own, and a scene of two bodies of it.
fn with_models() -> Desk {
    let body = |id: &str, x: f64| {
        json!({"id": id, "shape": {"mesh": {"path": "models/a cube.obj", "particles": 100, "scale": 0.01}},
            "placement": {"translation": [x, 0, 0]}, "material": {"young_modulus": 1e4, "mass": {"density": 1000}, "support_radius": 0.01}})
    };
    let desk =
        Desk::new(&json!({"version": 1, "time": {"duration": 0.05}, "bodies": [body("a", 0.0), body("b", 1.0)]}));
    fs::create_dir(desk.path("models")).unwrap();
    fs::write(
        desk.path("models/a cube.obj"),
        "mtllib looks/cube.mtl\nv 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 0 0 2\nv 2 0 2\nv 2 2 2\nv 0 2 2\nusemtl red\n\
         f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n",
    )
    .unwrap();
    fs::create_dir(desk.path("models/looks")).unwrap();
    fs::write(desk.path("models/looks/cube.mtl"), "newmtl red\nKd 1 0 0\nmap_Kd red.png\n").unwrap();
    fs::write(desk.path("models/looks/red.png"), "a picture").unwrap();
    desk
}

fn hash(desk: &Desk, scene: &str) -> Value {
    assert_eq!(desk.run(&format!("simulate {scene} --report r.json")).code, Some(0));
    desk.json("r.json")["bodies"][1]["state_hash"].clone()
}

#[test]
fn a_collected_scene_opens_wherever_its_folder_goes() {
    let desk = with_models();
    let before = hash(&desk, "scene.json");
    assert!(
        desk.done("collect scene.json --out away/kit")
            .contains("the scene with 1 models written to away/kit/scene.json")
    );
    assert_eq!(names(&desk.path("away/kit")), ["a cube", "scene.json"]);
    assert_eq!(names(&desk.path("away/kit/a cube")), ["a cube.obj", "looks"]);
    assert_eq!(names(&desk.path("away/kit/a cube/looks")), ["cube.mtl", "red.png"]);
    fs::rename(desk.path("away/kit"), desk.path("moved")).unwrap();
    fs::remove_dir_all(desk.path("models")).unwrap();
    assert_eq!(desk.json("moved/scene.json")["bodies"][1]["shape"]["mesh"]["path"], "a cube/a cube.obj");
    assert_eq!(hash(&desk, "moved/scene.json"), before);
    // What is there is not written over; the same is left as it is.
    desk.done("collect moved/scene.json --out again");
    fs::write(desk.path("again/a cube/looks/cube.mtl"), "another").unwrap();
    assert!(desk.done("collect moved/scene.json --out again").contains("again/scene-2.json"));
    assert_eq!(names(&desk.path("again")), ["a cube", "a cube-2", "scene-2.json", "scene.json"]);
    fs::remove_dir_all(desk.path("moved/a cube")).unwrap();
    assert!(desk.refused("collect moved/scene.json --out nowhere").contains("a cube.obj: there is no such file"));
}

#[test]
fn textures_go_along_under_any_name_and_those_that_are_missing_are_told() {
    let desk = with_models();
    let looks = "newmtl red\nmap_Kd -s 1 1 1 my leaf.png\nmap_Bump -bm 0.5 tex\\bump.png\nmap_d C:\\old\\alpha.png\n\
        refl -type sphere red.png\nmap_Ks gone away.png\n";
    fs::write(desk.path("models/looks/cube.mtl"), looks).unwrap();
    fs::create_dir(desk.path("models/looks/tex")).unwrap();
    for name in ["my leaf.png", "tex/bump.png", "alpha.png"] {
        fs::write(desk.path(&format!("models/looks/{name}")), name).unwrap();
    }
    let said = desk.run("collect scene.json --out kit");
    assert_eq!(said.code, Some(0), "{said:?}");
    assert_eq!(names(&desk.path("kit/a cube/looks")), ["alpha.png", "cube.mtl", "my leaf.png", "red.png", "tex"]);
    assert_eq!(desk.text("kit/a cube/looks/tex/bump.png"), "tex/bump.png");
    let told: Vec<&str> = said.err.lines().filter(|line| line.contains("not there")).collect();
    assert!(
        told.len() == 1 && told[0].contains("models/a cube.obj") && told[0].contains("\"gone away.png\""),
        "{}",
        said.err
    );
    // Again the same, and another file of the same length is another.
    assert!(desk.run("collect scene.json --out kit").out.contains("kit/scene.json"));
    fs::write(desk.path("kit/a cube/looks/alpha.png"), "alphb.png").unwrap();
    desk.run("collect scene.json --out kit");
    assert_eq!(names(&desk.path("kit")), ["a cube", "a cube-2", "scene-2.json", "scene.json"]);
    assert_eq!(desk.text("kit/a cube/looks/alpha.png"), "alphb.png");
}

#[test]
fn a_scene_written_elsewhere_still_finds_its_models() {
    let desk = with_models();
    fs::write(desk.path("axis.csv"), "x,y,z\n0.01,0.004,0.01\n0.01,0.01,0.01\n0.01,0.016,0.01\n").unwrap();
    fs::create_dir(desk.path("other")).unwrap();
    let said = desk.run("fibres scene.json --from axis.csv --body a --out other/new.json");
    assert_eq!(said.code, Some(0), "{said:?}");
    assert_eq!(desk.json("other/new.json")["bodies"][0]["shape"]["mesh"]["path"], "../models/a cube.obj");
    assert_eq!(desk.run("check other/new.json --outside").code, Some(0));
}
