//! What clips and stages say beside places: units, times, looks, extents, seams.

use super::export::{PRISM, desk, falling};
use serde_json::{Value, json};
use sinew::io::load_model;
use std::fs;

/// The document and the data of a GLB file.
pub(super) fn glb(bytes: &[u8]) -> (Value, Vec<u8>) {
    let length = u32::from_le_bytes(bytes[12..16].try_into().unwrap()) as usize;
    assert_eq!(u32::from_le_bytes(bytes[8..12].try_into().unwrap()) as usize, bytes.len());
    (serde_json::from_slice(&bytes[20..20 + length]).unwrap(), bytes[28 + length..].to_vec())
}

fn to_glb(document: &Value, data: &[u8]) -> Vec<u8> {
    let mut text = document.to_string().into_bytes();
    text.resize(text.len().next_multiple_of(4), b' ');
    let mut out = [&b"glTF\x02\0\0\0"[..], &(28 + text.len() as u32 + data.len() as u32).to_le_bytes()].concat();
    for (kind, piece) in [(b"JSON", &text[..]), (b"BIN\0", data)] {
        out.extend((piece.len() as u32).to_le_bytes());
        out.extend(kind);
        out.extend(piece);
    }
    out
}

/// The numbers of a text, one after the other.
fn numbers(text: &str) -> Vec<f64> {
    text.split(|c: char| !(c.is_ascii_digit() || "+-.e".contains(c))).filter_map(|word| word.parse().ok()).collect()
}

#[test]
fn a_gltf_clip_is_in_metres_with_y_up_whatever_the_rest_is_in() {
    let desk = desk();
    desk.ran("simulate scene.json --format gltf --frames 2..4 --out here");
    desk.ran("simulate scene.json --format gltf,obj --frames 2..4 --scale 100 --up z --out there");
    let [(here, data), (there, other)] =
        ["here", "there"].map(|folder| glb(&fs::read(desk.path(&format!("{folder}/motion.glb"))).unwrap()));
    assert_eq!(
        (here["accessors"].as_array().unwrap().len(), data.len()),
        (there["accessors"].as_array().unwrap().len(), other.len())
    );
    let boxes = |document: &Value| -> Vec<f64> {
        let accessors = document["accessors"].as_array().unwrap().iter();
        accessors
            .flat_map(|accessor| [&accessor["min"], &accessor["max"]].map(|corner| numbers(&corner.to_string())))
            .flatten()
            .collect()
    };
    let (here, there) = (boxes(&here), boxes(&there));
    assert!(here.len() > 30 && here.iter().zip(&there).all(|(a, b)| (a - b).abs() < 1e-6), "{here:?} {there:?}");
    let [low, high] = [0, 1].map(|corner| here[3 * corner + 1]);
    assert!(low > 0.499 && high < 0.541, "the prism stands half a metre above the floor: {low} {high}");
}

#[test]
fn times_of_a_clip_are_those_of_its_own_start() {
    let desk = desk();
    desk.ran("simulate scene.json --format gltf --seconds 0.42 --frames 20..21 --out out");
    let (document, _) = glb(&fs::read(desk.path("out/motion.glb")).unwrap());
    let input = document["animations"][0]["samplers"][0]["input"].as_u64().unwrap() as usize;
    assert_eq!(document["accessors"][input]["max"][0].as_f64().map(|time| time as f32), Some(0.02));
}

#[test]
fn coordinates_by_themselves_at_every_corner_split_nothing_that_is_the_same() {
    let desk = desk();
    let vertices = || {
        desk.ran("simulate scene.json --format gltf --frames 0..0 --out out");
        let (document, _) = glb(&fs::read(desk.path("out/motion.glb")).unwrap());
        let at = document["meshes"][0]["primitives"][0]["attributes"]["POSITION"].as_u64().unwrap() as usize;
        document["accessors"][at]["count"].clone()
    };
    let shared = vertices();
    // A `vt` of its own for every corner, as many programs write them.
    let values: Vec<&str> = PRISM.lines().filter(|line| line.starts_with("vt ")).collect();
    let (mut written, mut text) = (Vec::new(), String::new());
    for line in PRISM.lines().filter(|line| !line.starts_with("vt ")) {
        let corner = |word: &str| {
            let Some((vertex, texture)) = word.split_once('/') else { return word.to_owned() };
            written.push(values[texture.parse::<usize>().unwrap() - 1]);
            format!("{vertex}/{}", written.len())
        };
        text += &(line.split(' ').map(corner).collect::<Vec<_>>().join(" ") + "\n");
    }
    fs::write(desk.path("prism.obj"), written.join("\n") + "\n" + &text).unwrap();
    assert!(written.len() > 20 && shared.as_u64() > Some(13));
    assert_eq!(vertices(), shared);
}

#[test]
fn a_file_that_changes_its_material_at_every_face_has_as_many_parts_as_materials() {
    let desk = desk();
    let mut text = String::new();
    for (k, line) in PRISM.lines().filter(|line| !line.starts_with("usemtl") && !line.starts_with("o ")).enumerate() {
        if line.starts_with("f ") {
            text += ["usemtl red paint\n", "usemtl other\n"][k % 2];
        }
        text.push_str(line);
        text.push('\n');
    }
    fs::write(desk.path("prism.obj"), text).unwrap();
    desk.ran("simulate scene.json --format usd,gltf --frames 0..0 --out out");
    let (document, _) = glb(&fs::read(desk.path("out/motion.glb")).unwrap());
    assert_eq!(document["meshes"][0]["primitives"].as_array().unwrap().len(), 2);
    assert_eq!(document["materials"].as_array().unwrap().len(), 2);
    let shape = desk.text("out/motion_layers/shape.usda");
    let faces: Vec<Vec<f64>> = shape
        .split("def GeomSubset")
        .skip(1)
        .map(|part| numbers(part.split("int[] indices = [").nth(1).unwrap().split(']').next().unwrap()))
        .collect();
    assert_eq!(faces, [[0.0, 2.0, 4.0, 6.0], [1.0, 3.0, 5.0, 7.0]]);
}

#[test]
fn what_can_be_seen_through_is_said_to_be() {
    let desk = desk();
    desk.ran("simulate scene.json --format gltf --frames 0..0 --out out");
    let (mut document, data) = glb(&fs::read(desk.path("out/motion.glb")).unwrap());
    assert!(document["materials"].as_array().unwrap().iter().all(|material| material.get("alphaMode").is_none()));
    document["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"] = json!([1.0, 0.0, 0.0, 0.25]);
    document["scenes"][0]["nodes"] = json!([0]);
    fs::write(desk.path("glass.glb"), to_glb(&document, &data)).unwrap();
    let mut scene = falling();
    scene["two_layer"] = json!([]);
    scene["bodies"][0]["shape"]["mesh"] = json!({"path": "glass.glb", "particles": 200});
    scene["bodies"][0]["fibres"] = json!([]);
    fs::write(desk.path("scene.json"), scene.to_string()).unwrap();
    assert!(load_model(&desk.path("glass.glb")).is_ok());
    assert_eq!(desk.run("simulate scene.json --format gltf --frames 0..0 --out glass").code, Some(0));
    let (document, _) = glb(&fs::read(desk.path("glass/motion.glb")).unwrap());
    let modes: Vec<_> =
        document["materials"].as_array().unwrap().iter().map(|material| &material["alphaMode"]).collect();
    assert_eq!(modes, [&json!("BLEND"), &Value::Null]);
}

#[test]
fn extents_hold_what_is_drawn_and_not_the_middle_of_it() {
    let desk = desk();
    desk.ran("simulate scene.json --format usd --frames 1..1 --out out");
    let (clip, shape) = (desk.text("out/motion_layers/frame.000001.usda"), desk.text("out/motion_layers/shape.usda"));
    let behind = |text: &str, name: &str, attribute: &str| -> Vec<f64> {
        let of = text.split_once(&format!("\"{name}\"")).unwrap().1.split_once(attribute).unwrap().1;
        numbers(of.split_once('[').unwrap().1.split_once(']').unwrap().0)
    };
    for name in ["Red_prism_1_fibres", "red_Prism_1_springs_2", "red_Prism_1_2", "Red_prism_1"] {
        let half = if name == "Red_prism_1" { 0.0 } else { 0.5 * behind(&shape, name, "float[] widths")[0] };
        assert!(half > 1e-5 || name == "Red_prism_1", "{name}");
        let (points, extent) = (behind(&clip, name, "points.timeSamples"), behind(&clip, name, "extent.timeSamples"));
        for axis in 0..3 {
            let along = || points.iter().skip(axis).step_by(3).copied();
            let (low, high) = (along().fold(f64::INFINITY, f64::min), along().fold(f64::NEG_INFINITY, f64::max));
            assert!(
                (extent[axis] - low + half).abs() < 1e-6 && (extent[3 + axis] - high - half).abs() < 1e-6,
                "{name}"
            );
        }
    }
}
