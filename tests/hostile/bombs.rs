//! Small files that ask for the whole machine: each is read or refused within ten times its size and 64 MiB, and within
//! two seconds of a processor.

use crate::files::in_new_folder;
use crate::peak;
use crate::read::refused;
use serde_json::{Value, json};
use sinew::geometry::{Solid, TriangleMesh};
use sinew::io::{load_assets, load_model, load_scene, scene_to_json};
use sinew::scene::{Assets, Body, Material, MeshShape, Scene};
use sinew::test_support::io::{points_of_lines, read_journal};
use std::f64::consts::TAU;
use std::fmt::Write;
use std::fs;
use std::path::Path;

/// How long the threads may run for one of them [s]; libraries are not optimised but in a release.
const SECONDS: f64 = if cfg!(debug_assertions) { 20.0 } else { 2.0 };

/// What the test of a bomb does with its file: by its ending, and in a program of its own.
#[test]
#[ignore = "done by those below, in a program of its own"]
fn goes_off() {
    peak::told(|path| -> Result<String, String> {
        let name = path.file_name().and_then(|name| name.to_str()).expect("a name");
        let follows = name.starts_with("skeleton");
        if path.extension().is_some_and(|ending| ending == "json")
            && !name.starts_with("lines")
            && !name.starts_with("journal")
        {
            let scene = load_scene(path).map_err(|error| error.to_string())?;
            load_assets(&scene, path.parent().expect("a folder"), &mut |_| {}).map_err(|error| error.to_string())?;
            return Ok("a scene".to_owned());
        }
        if name.starts_with("journal") {
            return read_journal(path).map(|journal| format!("{} frames", journal.frames()));
        }
        if name.starts_with("lines") {
            return points_of_lines(path).map(|points| format!("{} points", points.len()));
        }
        if follows {
            let body = json!({"id": "cube", "shape": {"box": {"size": [0.03, 0.03, 0.03]}},
                "material": {"young_modulus": 1e5, "mass": {"density": 1000}, "support_radius": 0.015}, "follows": [
                {"id": "all", "leader": {"skeleton": {"path": name}}}]});
            let scene: Scene = serde_json::from_value(json!({"version": 1, "bodies": [body]})).expect("a scene");
            let folder = path.parent().expect("a folder");
            return load_assets(&scene, folder, &mut |_| {}).map(|_| String::new()).map_err(|error| error.to_string());
        }
        let model = load_model(path).map_err(|error| error.to_string())?;
        Ok(format!("{} faces, {} notes", model.triangles.len(), model.notes.len()))
    });
}

/// What is said of a bomb of these files, of which the first is opened; it may take as much memory as all of them ask
/// for together.
fn said(files: &[(&str, &[u8])]) -> String {
    in_new_folder(|folder| {
        for (name, bytes) in files {
            fs::write(folder.join(name), bytes).expect("written");
        }
        let size: u64 = files.iter().map(|(_, bytes)| bytes.len() as u64).sum();
        let peak = peak::of("bombs::goes_off", &folder.join(files[0].0));
        let most = 10 * size + (64 << 20);
        if let Some(bytes) = peak.bytes {
            assert!(bytes <= most, "{}: {bytes} bytes of memory for {size}: {}", files[0].0, peak.said);
        }
        if let Some(seconds) = peak.seconds {
            println!("{}: {seconds} s, {} MiB for {size} bytes", files[0].0, peak.bytes.unwrap_or_default() >> 20);
            assert!(seconds <= SECONDS, "{}: {seconds} s: {}", files[0].0, peak.said);
        }
        peak.said
    })
}

/// A bomb that is refused: what is said has these words.
fn is_refused(files: &[(&str, &[u8])], words: &[&str]) {
    let said = said(files);
    let why = said.strip_prefix("refused: ").unwrap_or_else(|| panic!("{}: {said}", files[0].0));
    refused(why);
    assert!(words.iter().all(|word| why.contains(word)), "{}: {why}", files[0].0);
}

/// A bomb that is read, as what.
fn is_read(files: &[(&str, &[u8])], found: &str) {
    assert_eq!(said(files), format!("read: {found}"), "{}", files[0].0);
}

fn cube() -> String {
    let corners = (0..8).map(|k| format!("v {} {} {}\n", k & 1, k >> 1 & 1, k >> 2));
    let faces = ["1 3 4 2", "5 6 8 7", "1 2 6 5", "3 7 8 4", "1 5 7 3", "2 4 8 6"].map(|face| format!("f {face}\n"));
    corners.chain(faces).collect()
}

/// A GLB of a document and its binary part.
fn glb(json: &Value, bin: &[u8]) -> Vec<u8> {
    let mut text = json.to_string().into_bytes();
    text.resize(text.len().next_multiple_of(4), b' ');
    let word = |value: usize| (value as u32).to_le_bytes();
    let length = 28 + text.len() + bin.len();
    [&b"glTF"[..], &word(2), &word(length), &word(text.len()), b"JSON", &text, &word(bin.len()), b"BIN\0", bin].concat()
}

/// A document of one node that shows these primitives.
fn document(primitives: &[Value], accessors: &Value, views: &Value, buffers: &Value) -> Value {
    json!({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": primitives}], "accessors": accessors, "bufferViews": views, "buffers": buffers})
}

/// Numbers of so many vertices, all different.
fn floats(vertices: usize) -> Vec<u8> {
    (0..3 * vertices).flat_map(|k| (k as f32 * 1e-3 % 7.0).to_le_bytes()).collect()
}

fn positions(count: usize) -> Value {
    json!([{"bufferView": 0, "componentType": 5126, "count": count, "type": "VEC3"}])
}

#[test]
fn a_gltf_that_shows_the_same_again_and_again() {
    const MANY: usize = 10_000;
    let bin = floats(MANY);
    let views = || json!([{"buffer": 0, "byteLength": bin.len()}]);
    let buffers = || json!([{"byteLength": bin.len()}]);
    let one = json!({"attributes": {"POSITION": 0}});
    let words = ["again and again", "vertices"];
    let many = document(&vec![one.clone(); MANY], &positions(MANY), &views(), &buffers());
    is_refused(&[("primitives.glb", &glb(&many, &bin))], &words);
    // Nodes that show one mesh, and nodes that contain one another so that their number doubles with every level.
    let mut nodes = document(std::slice::from_ref(&one), &positions(MANY), &views(), &buffers());
    nodes["nodes"] = json!(vec![json!({"mesh": 0}); MANY]);
    nodes["scenes"] = json!([{"nodes": (0..MANY).collect::<Vec<_>>()}]);
    is_refused(&[("nodes.glb", &glb(&nodes, &bin))], &words);
    for (end, words) in [(json!({"mesh": 0}), &words[..]), (json!({}), &["contain each other"])] {
        nodes["nodes"] = (0..64).map(|k| json!({"children": [k + 1, k + 1]})).chain([end]).collect();
        nodes["scenes"] = json!([{"nodes": [0]}]);
        is_refused(&[("doubled.glb", &glb(&nodes, &bin))], words);
    }
    // Faces, sets of coordinates, morph targets, weights.
    let indices: Vec<u8> = (0..300_000_u32).flat_map(|k| (k % 99) as u8..=(k % 99) as u8).collect();
    let mut faces = document(
        &vec![json!({"attributes": {"POSITION": 0}, "indices": 1}); 500],
        &json!([{"bufferView": 0, "componentType": 5126, "count": 99, "type": "VEC3"},
            {"bufferView": 1, "componentType": 5121, "count": 300_000, "type": "SCALAR"}]),
        &json!([{"buffer": 0, "byteLength": 1188}, {"buffer": 0, "byteOffset": 1188, "byteLength": 300_000}]),
        &json!([{"byteLength": 301_188}]),
    );
    is_refused(&[("faces.glb", &glb(&faces, &[&bin[..1188], &indices].concat()))], &words);
    let targets = vec![json!({"POSITION": 0}); 20_000];
    faces =
        document(&[json!({"attributes": {"POSITION": 0}, "targets": targets})], &positions(MANY), &views(), &buffers());
    faces["meshes"][0]["weights"] = json!(vec![1e-6; 20_000]);
    is_refused(&[("targets.glb", &glb(&faces, &bin))], &["again and again", "million numbers"]);
    let sets: serde_json::Map<String, Value> = (0..3000).map(|k| (format!("TEXCOORD_{k}"), json!(1))).collect();
    let mut piece = json!({"attributes": sets});
    piece["attributes"]["POSITION"] = json!(0);
    let accessors = json!([{"bufferView": 0, "componentType": 5126, "count": MANY, "type": "VEC3"},
        {"bufferView": 0, "componentType": 5126, "count": MANY, "type": "VEC2"}]);
    let coordinates = document(&[piece], &accessors, &views(), &buffers());
    is_read(&[("coordinates.glb", &glb(&coordinates, &bin))], "3333 faces, 0 notes");
    // Zeros that the file has no byte of.
    let zeros = json!([{"componentType": 5126, "count": 19_999_999, "type": "VEC3",
        "sparse": {"count": 1, "indices": {"bufferView": 0, "componentType": 5121}, "values": {"bufferView": 0}}}]);
    let zeros = document(&[one], &zeros, &views(), &buffers());
    is_refused(&[("zeros.glb", &glb(&zeros, &bin))], &words);
    let name = "n".repeat(1_000_000);
    let mut named = document(&vec![json!({"attributes": {"POSITION": 0}}); 2000], &positions(3), &views(), &buffers());
    named["meshes"][0]["name"] = json!(name);
    is_read(&[("names.glb", &glb(&named, &bin))], "2000 faces, 0 notes");
}

#[test]
fn a_gltf_of_thousands_of_buffers() {
    const MANY: usize = 4000;
    let pieces = |count: usize| (0..count).map(|k| json!({"attributes": {"POSITION": k}})).collect::<Vec<_>>();
    let accessors: Value =
        (0..MANY).map(|k| json!({"bufferView": k, "componentType": 5126, "count": 3, "type": "VEC3"})).collect();
    let views: Value = (0..MANY).map(|k| json!({"buffer": k, "byteOffset": 12 * k, "byteLength": 36})).collect();
    let bin = floats(100_000);
    let buffers = |uri: &str| {
        let slow = |k: usize| format!("{}{uri}", "./".repeat(k % 50));
        (0..MANY).map(|k| json!({"byteLength": bin.len(), "uri": slow(k)})).collect::<Value>()
    };
    // Each of the binary part.
    let mut same = document(&pieces(MANY), &accessors, &views, &json!([]));
    same["buffers"] = json!(vec![json!({"byteLength": bin.len()}); MANY]);
    is_read(&[("blob.glb", &glb(&same, &bin))], "4000 faces, 0 notes");
    // Each of one file, by many names.
    same["buffers"] = buffers("b.bin");
    is_read(&[("file.gltf", same.to_string().as_bytes()), ("b.bin", &bin)], "4000 faces, 0 notes");
}

#[test]
fn an_animation_of_thousands_of_channels() {
    let mut bin = floats(8);
    let begin = bin.len();
    bin.extend((0..20_000).flat_map(|k| (k as f32).to_le_bytes()));
    bin.extend(floats(20_000));
    let keys = 20_000;
    let accessors = json!([{"bufferView": 0, "componentType": 5126, "count": 8, "type": "VEC3"},
        {"bufferView": 1, "componentType": 5126, "count": keys, "type": "SCALAR"},
        {"bufferView": 2, "componentType": 5126, "count": keys, "type": "VEC3"}]);
    let views = json!([{"buffer": 0, "byteLength": begin}, {"buffer": 0, "byteOffset": begin, "byteLength": 4 * keys},
        {"buffer": 0, "byteOffset": begin + 4 * keys, "byteLength": 12 * keys}]);
    let mut moving =
        document(&[json!({"attributes": {"POSITION": 0}})], &accessors, &views, &json!([{"byteLength": bin.len()}]));
    moving["nodes"] = json!([{"mesh": 0, "skin": 0}]);
    moving["skins"] = json!([{"joints": [0]}]);
    let channel = json!({"sampler": 0, "target": {"node": 0, "path": "translation"}});
    moving["animations"] = json!([{"samplers": [{"input": 1, "output": 2}], "channels": vec![channel; 5000]}]);
    is_refused(&[("skeleton.glb", &glb(&moving, &bin))], &["again and again"]);
}

#[test]
fn an_obj_that_names_libraries_again_and_again() {
    let itself = format!("{}{}", "mtllib bomb.obj\n".repeat(10_000), cube());
    is_read(&[("bomb.obj", itself.as_bytes())], "12 faces, 0 notes");
    let library = "newmtl a\nKd 1 0 0\nKd x\n".repeat(50_000);
    let names: Vec<String> = (0..2000).map(|k| format!("mtllib {}a.mtl\n", "./".repeat(k))).collect();
    let named = format!("{}{}", names.concat(), cube());
    // Twenty faults are told one by one, then how many more, and that not every name was looked for.
    is_read(&[("named.obj", named.as_bytes()), ("a.mtl", library.as_bytes())], "12 faces, 22 notes");
}

#[test]
fn names_that_go_to_every_part() {
    let long = "n".repeat(300_000);
    let parts = "usemtl a\nf 1 2 3\nusemtl b\nf 1 3 4\n".repeat(10_000);
    let named = format!("o {long}\n{}{parts}", cube());
    is_read(&[("long.obj", named.as_bytes())], "20012 faces, 0 notes");
    let parts = format!("{}{}", cube(), "g a\nf 1 2 3\n".repeat(200_001));
    is_refused(&[("parts.obj", parts.as_bytes())], &["200000 parts", "line"]);
}

fn ring(corners: usize, turns: f64) -> String {
    let mut text = String::new();
    for k in 0..corners {
        let angle = TAU * turns * k as f64 / corners as f64;
        writeln!(text, "v {} {} 0", angle.cos(), angle.sin()).expect("written");
    }
    text
}

fn face(corners: impl Iterator<Item = usize>) -> String {
    corners.fold("f".to_owned(), |mut text, corner| {
        write!(text, " {corner}").expect("written");
        text
    })
}

#[test]
fn faces_of_thousands_of_corners() {
    const MANY: usize = 20_000;
    let round = format!("{}{}\n", ring(MANY, 1.0), face(1..=MANY));
    is_read(&[("round.obj", round.as_bytes())], &format!("{} faces, 0 notes", MANY - 2));
    let repeated = format!("{}{}\n", ring(5, 1.0), face((0..MANY).map(|k| 1 + k * k % 5)));
    is_read(&[("repeated.obj", repeated.as_bytes())], &format!("{} faces, 0 notes", MANY - 2));
    // From anywhere to anywhere: hardly a corner is an ear.
    let mut random = crate::mutate::Random(1);
    let tangle = format!("{}{}\n", ring(MANY, 1.0), face((0..MANY).map(|_| 1 + random.below(MANY))));
    is_refused(&[("tangle.obj", tangle.as_bytes())], &["100 million looks", "20000 corners"]);
}

#[test]
fn a_ply_whose_list_is_of_a_million() {
    const MANY: usize = 1_000_000;
    let mut bytes = format!(
        "ply\nformat binary_little_endian 1.0\nelement vertex {MANY}\nproperty float x\nproperty float y\nproperty float \
         z\nelement face 1\nproperty list int int vertex_indices\nend_header\n"
    )
    .into_bytes();
    for k in 0..MANY {
        let angle = (TAU * k as f64 / MANY as f64) as f32;
        bytes.extend([angle.cos(), angle.sin(), 0.0].into_iter().flat_map(f32::to_le_bytes));
    }
    bytes.extend((MANY as u32).to_le_bytes());
    bytes.extend((0..MANY as u32).flat_map(u32::to_le_bytes));
    // In single precision its corners are no longer round.
    is_refused(&[("million.ply", &bytes)], &["100 million looks", "1000000 corners"]);
}

#[test]
fn json_of_millions_of_small_values() {
    let zeros = format!("[{}0]", "0,".repeat(30_000_000));
    for name in ["scene.json", "journal.json", "lines.json"] {
        is_refused(&[(name, zeros.as_bytes())], &["MB of memory", "60000003 bytes"]);
    }
    let objects = format!("{{\"version\": 1, \"bodies\": [{}0]}}", "{\"\":0},".repeat(2_000_000));
    is_refused(&[("objects.json", objects.as_bytes())], &["MB of memory"]);
    let gltf = format!("{{\"asset\": {{\"version\": \"2.0\"}}, \"x\": {zeros}}}");
    is_refused(&[("values.gltf", gltf.as_bytes())], &["MB of memory"]);
}

/// Triangles here and there in a cube, none of which touches another.
fn soup(count: usize) -> String {
    let mut random = crate::mutate::Random(3);
    let mut number = || random.below(1_000_000) as f64 * 1e-6;
    let mut text = String::new();
    for k in 0..count {
        let at = [number(), number(), number()];
        for _ in 0..3 {
            let [x, y, z] = at.map(|c| c + 0.1 * number());
            writeln!(text, "v {x} {y} {z}").expect("written");
        }
        writeln!(text, "f {} {} {}", 3 * k + 1, 3 * k + 2, 3 * k + 3).expect("written");
    }
    text
}

#[test]
fn an_open_soup_is_told_from_a_solid() {
    in_new_folder(|folder| {
        let path = folder.join("soup.obj");
        fs::write(&path, soup(800)).expect("written");
        let model = load_model(&path).expect("faces");
        match Solid::new(&model) {
            Ok(solid) => assert!(solid.volume > 0.0),
            Err(refusal) => {
                refused(&refusal.to_string());
            }
        }
    });
}

fn scene_file(folder: &Path, scene: &Scene) -> std::path::PathBuf {
    let path = folder.join("scene.json");
    fs::write(&path, scene_to_json(scene)).expect("written");
    path
}

fn meshes(count: usize, particles: Option<u32>, support_radius: f64) -> Scene {
    (0..count).fold(Scene::new("Meshes"), |scene, k| {
        let mut shape = MeshShape::new("cube.obj");
        shape.particles = particles;
        let material = Material::new(1e5, 0.3, 1000.0).with_support_radius(support_radius);
        scene.with_body(Body::from_mesh(format!("mesh {k}"), shape).with_material(material))
    })
}

#[test]
fn a_dozen_meshes_of_too_many_particles_together() {
    in_new_folder(|folder| {
        fs::write(folder.join("cube.obj"), cube()).expect("written");
        let loaded = |scene: &Scene| {
            let scene = load_scene(&scene_file(folder, scene))?;
            load_assets(&scene, folder, &mut |_| {})
        };
        // By their number, which the scene gives: refused before a file is opened.
        let error = loaded(&meshes(12, Some(200_000), 0.1)).expect_err("refused").to_string();
        assert!(error.contains("/bodies/10/shape/mesh/particles") && error.contains("2.2 million"), "{error}");
        assert!(loaded(&meshes(10, Some(200_000), 0.1)).is_ok());
        // By their size, which the file gives: a metre in spacings of 1/58.5, twelve times.
        let error = loaded(&meshes(12, None, 2.5 / 58.5)).expect_err("refused").to_string();
        assert!(error.contains("/bodies/9/material/support_radius") && error.contains("2.0e6 particles"), "{error}");
        assert!(loaded(&meshes(9, None, 2.5 / 58.5)).is_ok());
    });
}

#[test]
fn rings_and_balls_of_too_many_particles_together() {
    let refused_as = |bodies: Vec<Value>, words: [&str; 2]| {
        let text = json!({"version": 1, "two_layer": bodies}).to_string();
        let error = sinew::io::scene_from_json(&text).expect_err("refused").to_string();
        refused(&error);
        assert!(words.iter().all(|word| error.contains(word)), "{error}");
    };
    let ring = |k: usize, sides: u32| json!({"id": format!("ring {k}"), "shape": {"ring": {"sides": sides}}});
    refused_as(vec![ring(0, 1_000_000)], ["/two_layer/0/shape/ring/sides", "20000"]);
    refused_as((0..51).map(|k| ring(k, 20_000)).collect(), ["/two_layer/50/shape", "2.0 million particles"]);
    let ball = |k: usize| json!({"id": format!("ball {k}"), "shape": {"ball": {"subdivisions": 5}}});
    refused_as((0..500).map(ball).collect(), ["/two_layer/244/shape", "2.0 million particles"]);
}

#[test]
fn lines_and_points_in_thousands() {
    let lines: Vec<String> = (0..20_000).map(|k| format!("l {} 8\n", 1 + k % 7)).collect();
    let text = format!("{}o {}\n{}", cube(), "n".repeat(100_000), lines.concat());
    is_read(&[("lines.obj", text.as_bytes())], "40000 points");
}

#[test]
fn solids_of_memory_are_as_sound_as_those_of_files() {
    let mesh = TriangleMesh { positions: vec![[0.0; 3].into(); 3], triangles: vec![[0, 1, 9]] };
    let error = Assets::default().insert_mesh("none", &mesh).expect_err("no solid").to_string();
    refused(&error);
}
