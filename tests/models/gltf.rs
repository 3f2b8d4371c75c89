//! glTF and GLB as programs write them, and as they are damaged.

use crate::cases::Right::{Noted, Refused, Volume};
use crate::cases::{CORNERS, Folder, Right, triangles};
use crate::gltf_document::{Document, data_uri, floats};
use serde_json::{Value, json};

fn check(folder: &Folder, case: &str, document: &Document, right: &Right) {
    folder.check(case, "a.gltf", &document.text(), right);
    folder.check(case, "a.glb", &document.glb(), right);
}

#[test]
fn nodes_place_their_meshes() {
    let folder = Folder::new();
    let node = |value: Value| Document::cube().set("/nodes/0", value);
    let scaled = [2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 10, 20, 30, 1];
    let cases = [
        ("as it is", node(json!({"mesh": 0})), 8.0),
        ("a matrix", node(json!({"mesh": 0, "matrix": scaled})), 64.0),
        ("a mirror", node(json!({"mesh": 0, "scale": [-1, 1, 1]})), 8.0),
        ("three mirrors", node(json!({"mesh": 0, "scale": [-1, -1, -1]})), 8.0),
        ("a turn", node(json!({"mesh": 0, "rotation": [0.0, 0.0, 0.6, 0.8], "translation": [5, 0, 0]})), 8.0),
        ("a turn of another length", node(json!({"mesh": 0, "rotation": [0, 0, 2, 2]})), 8.0),
        ("numbers with points", node(json!({"mesh": 0.0, "scale": [2.0, 2.0, 2.0]})), 64.0),
        (
            "within another",
            Document::cube().set(
                "/nodes",
                json!([{"scale": [2, 1, 1], "children": [1]}, {"scale": [1, 2, 1], "children": [2]}, {"mesh": 0}]),
            ),
            32.0,
        ),
        (
            "two instances",
            Document::cube()
                .set("/nodes", json!([{"children": [1, 2]}, {"mesh": 0}, {"mesh": 0, "translation": [5, 0, 0]}])),
            16.0,
        ),
        (
            "a node outside of the scene",
            Document::cube().set("/nodes", json!([{"mesh": 0}, {"mesh": 0, "translation": [9, 9, 9]}])),
            8.0,
        ),
        (
            "another scene",
            Document::cube()
                .set("/scene", json!(1))
                .set("/scenes", json!([{"nodes": [0]}, {"nodes": [1]}]))
                .set("/nodes", json!([{"mesh": 0}, {"mesh": 0, "scale": [2, 2, 2]}])),
            64.0,
        ),
        ("no scene", Document::cube().set("/scene", Value::Null).set("/scenes", json!([])), 8.0),
        ("a scene that names no nodes", Document::cube().set("/scenes", json!([{"nodes": [0]}, {}])), 8.0),
        (
            "members without a value",
            Document::cube().set("/extras", Value::Null).set("/nodes/0/skin", Value::Null),
            8.0,
        ),
        ("a later version", Document::cube().set("/asset/version", json!("2.1")), 8.0),
        ("a broken animation", Document::cube().set("/animations", json!([{"channels": "none"}])), 8.0),
        (
            "lines and points beside",
            Document::cube().set(
                "/meshes/0/primitives",
                json!([
            {"attributes": {"POSITION": 0}, "mode": 1}, {"attributes": {"POSITION": 0}, "mode": 0},
            {"attributes": {"POSITION": 0}, "indices": 1, "mode": 4}]),
            ),
            8.0,
        ),
    ];
    for (case, document, volume) in cases {
        check(&folder, case, &document, &Volume(volume));
    }
    let mut instanced = Document::cube();
    let shifts = instanced.accessor(5126, "VEC3", 2, floats(&[0.0, 0.0, 0.0, 5.0, 0.0, 0.0]));
    let scales = instanced.accessor(5126, "VEC3", 2, floats(&[1.0, 1.0, 1.0, 2.0, 2.0, 2.0]));
    let attributes = json!({"TRANSLATION": shifts, "SCALE": scales});
    let instanced = instanced
        .set("/nodes/0/extensions", json!({"EXT_mesh_gpu_instancing": {"attributes": attributes}}))
        .set("/extensionsRequired", json!(["EXT_mesh_gpu_instancing"]));
    check(&folder, "listed instances", &instanced, &Volume(72.0));
}

#[test]
fn skins_go_by_their_bind_matrices() {
    let folder = Folder::new();
    // A joint's scale, the scale in the bind matrix, that of the mesh's own node, and the volume.
    for (joint, bind, node, volume) in [
        (1.0, 1.0, 1.0, 8.0),
        (1.0, 1.0, 100.0, 8.0),
        (0.01, 100.0, 100.0, 8.0),
        (1.0, 0.01, 1.0, 8e-6),
        (0.5, 1.0, 1.0, 1.0),
        (1.0, -1.0, 1.0, 8.0),
    ] {
        for (component, full) in [(5126, 1.0_f32.to_le_bytes().to_vec()), (5121, vec![255]), (5123, vec![255, 255])] {
            let mut document = Document::cube();
            let joints = document.accessor(5121, "VEC4", 8, [1, 0, 0, 0].repeat(8));
            let zero = vec![0; 3 * full.len()];
            let weights = document.accessor(component, "VEC4", 8, [full, zero].concat().repeat(8));
            let mut matrices = vec![0.0; 32];
            for k in 0..4 {
                matrices[5 * k] = 7.0;
                matrices[16 + 5 * k] = if k == 3 { 1.0 } else { bind };
            }
            let binds = document.accessor(5126, "MAT4", 2, floats(&matrices));
            let document = document
                .set(
                    "/nodes",
                    json!([
                    {"children": [1, 2]},
                    {"mesh": 0, "skin": 0, "scale": [node, node, node], "translation": [9, 9, 9]},
                    {"children": [3]}, {"scale": [joint, joint, joint]}]),
                )
                .set("/skins", json!([{"joints": [2, 3], "inverseBindMatrices": binds}]))
                .set(
                    "/meshes/0/primitives/0/attributes",
                    json!({"POSITION": 0, "JOINTS_0": joints, "WEIGHTS_0": weights}),
                );
            check(&folder, &format!("{joint} {bind} {node} {component}"), &document, &Volume(volume));
        }
    }
}

#[test]
fn morph_targets_count_by_their_weights() {
    let folder = Folder::new();
    for (own, of_mesh, volume) in [
        (None, None, 8.0),
        (None, Some(1.0), 16.0),
        (None, Some(0.5), 12.0),
        (Some(0.0), Some(1.0), 8.0),
        (Some(1.0), None, 16.0),
    ] {
        let mut document = Document::cube();
        let higher: Vec<f64> = CORNERS.iter().flat_map(|[_, _, z]| [0.0, 0.0, *z]).collect();
        let target = document.accessor(5126, "VEC3", 8, floats(&higher));
        let mut document = document.set("/meshes/0/primitives/0/targets", json!([{"POSITION": target}]));
        if let Some(weight) = own {
            document = document.set("/nodes/0/weights", json!([weight]));
        }
        if let Some(weight) = of_mesh {
            document = document.set("/meshes/0/weights", json!([weight]));
        }
        check(&folder, &format!("{own:?} {of_mesh:?}"), &document, &Volume(volume));
    }
}

#[test]
fn numbers_come_in_any_type() {
    let folder = Folder::new();
    // Whole numbers, as themselves and as shares; with the scale that makes a cube of 8 m³ of them.
    let types: [(u32, usize, f64); 5] =
        [(5120, 1, 127.0), (5121, 1, 255.0), (5122, 2, 32767.0), (5123, 2, 65535.0), (5126, 4, 1.0)];
    for (component, size, greatest) in types {
        for normalized in [false, true] {
            for required in [false, true] {
                let shares = normalized && component != 5126;
                let value = |c: f64| if shares { c / 2.0 * greatest } else { c };
                let bytes = CORNERS.iter().flat_map(|corner| {
                    // Rows begin at multiples of four bytes.
                    let mut row: Vec<u8> = corner
                        .iter()
                        .flat_map(|&c| match component {
                            5126 => (value(c) as f32).to_le_bytes().to_vec(),
                            _ => (value(c) as i64).to_le_bytes()[..size].to_vec(),
                        })
                        .collect();
                    row.resize(row.len().next_multiple_of(4), 0);
                    row
                });
                let mut document = Document::cube();
                let index = document.accessor(component, "VEC3", 8, bytes.collect());
                let scale = if shares { 2.0 } else { 1.0 };
                let mut document = document
                    .set(&format!("/accessors/{index}/normalized"), json!(normalized))
                    .set(&format!("/bufferViews/{index}/byteStride"), json!((3 * size).next_multiple_of(4)))
                    .set("/nodes/0/scale", json!([scale, scale, scale]))
                    .set("/meshes/0/primitives/0/attributes/POSITION", json!(index));
                if required {
                    document = document.set("/extensionsRequired", json!(["KHR_mesh_quantization"]));
                }
                check(&folder, &format!("{component} {normalized}"), &document, &Volume(8.0));
            }
        }
    }
    for (component, size) in [(5121, 1), (5123, 2), (5125, 4)] {
        let mut document = Document::cube();
        let bytes = triangles().into_iter().flatten().flat_map(|i| i.to_le_bytes()[..size].to_vec());
        let index = document.accessor(component, "SCALAR", 36, bytes.collect());
        let document = document.set("/meshes/0/primitives/0/indices", json!(index));
        check(&folder, &format!("indices {component}"), &document, &Volume(8.0));
    }
    // Corners that differ from zero, and nothing else.
    let mut sparse = Document::cube();
    let places = sparse.accessor(5121, "SCALAR", 7, (1..8).collect());
    let values = sparse.accessor(5126, "VEC3", 7, floats(&CORNERS.as_flattened()[3..]));
    let sparse = sparse.set(
        "/accessors/0",
        json!({"componentType": 5126, "count": 8, "type": "VEC3", "sparse": {
        "count": 7, "indices": {"bufferView": places, "componentType": 5121}, "values": {"bufferView": values}}}),
    );
    check(&folder, "sparse", &sparse, &Volume(8.0));
}

#[test]
fn what_an_extension_leaves_out_is_said_and_what_it_hides_refused() {
    let folder = Folder::new();
    let with = |name: &str| Document::cube().set("/extensionsRequired", json!([name]));
    for name in [
        "KHR_texture_transform",
        "KHR_materials_unlit",
        "KHR_texture_basisu",
        "KHR_materials_clearcoat",
        "EXT_texture_webp",
    ] {
        check(&folder, name, &with(name), &Noted(8.0, &["is left out", "not its shape"]));
    }
    check(&folder, "draco", &with("KHR_draco_mesh_compression"), &Refused(&["Draco", "export it without compression"]));
    check(
        &folder,
        "meshopt",
        &with("EXT_meshopt_compression"),
        &Refused(&["meshopt", "export it without compression"]),
    );
    check(&folder, "another", &with("EXT_curved"), &Refused(&["the extension EXT_curved", "without that"]));
    let draco = json!({"KHR_draco_mesh_compression": {"bufferView": 0, "attributes": {"POSITION": 0}}});
    let hidden = Document::cube()
        .set("/meshes/0/primitives/0/extensions", draco.clone())
        .set("/accessors/0", json!({"componentType": 5126, "count": 8, "type": "VEC3"}));
    check(&folder, "only compressed", &hidden, &Refused(&["Draco"]));
    let beside = Document::cube().set("/meshes/0/primitives/0/extensions", draco);
    check(&folder, "compressed too", &beside, &Volume(8.0));
    let lights = Document::cube().set("/extensions", json!({"KHR_lights_punctual": {"lights": []}}));
    check(&folder, "lights", &lights, &Volume(8.0));
}

#[test]
fn versions_before_the_second_are_named() {
    let folder = Folder::new();
    let first = json!({"asset": {"version": "1.0"}, "scene": "s", "scenes": {"s": {"nodes": ["n"]}}});
    folder.check("1.0", "a.gltf", first.to_string().as_bytes(), &Refused(&["glTF 1.0", "as glTF 2.0"]));
    let mut glb = Document::cube().glb();
    glb[4] = 1;
    folder.check("1.0", "a.glb", &glb, &Refused(&["glTF 1.0", "as glTF 2.0"]));
}

#[test]
fn a_refusal_names_the_place_and_what_is_missing() {
    let folder = Folder::new();
    let set = |pointer: &str, value: Value| Document::cube().set(pointer, value);
    let cases = [
        (
            "view",
            set("/bufferViews/0/byteLength", json!(95)),
            Refused(&["accessors[0]", "POSITION of meshes[0].primitives[0]", "bufferViews[0]", "1 byte is missing"]),
        ),
        (
            "view over",
            set("/bufferViews/1/byteLength", json!(80)),
            Refused(&["bufferViews[1]", "buffers[0]", "8 bytes are missing"]),
        ),
        ("count", set("/accessors/0/count", json!(9)), Refused(&["accessors[0]", "9 rows", "12 bytes are missing"])),
        (
            "indices",
            set("/accessors/1/count", json!(360_000)),
            Refused(&["accessors[1]", "indices of", "bytes are missing"]),
        ),
        ("huge", set("/accessors/1/count", json!(1_u64 << 60)), Refused(&["accessors[1]"])),
        ("offset", set("/accessors/0/byteOffset", json!(1_u64 << 62)), Refused(&["accessors[0]", "are missing"])),
        ("no view", set("/accessors/0/bufferView", json!(7)), Refused(&["bufferViews[7]"])),
        ("no buffer", set("/bufferViews/0/buffer", json!(7)), Refused(&["buffers[7]"])),
        ("no data", set("/accessors/0/bufferView", Value::Null), Refused(&["accessors[0]", "no bufferView"])),
        (
            "no accessor",
            set("/meshes/0/primitives/0/attributes/POSITION", json!(9)),
            Refused(&["accessors[9]", "POSITION"]),
        ),
        ("no indices", set("/meshes/0/primitives/0/indices", json!(9)), Refused(&["accessors[9]", "indices"])),
        (
            "no positions",
            set("/meshes/0/primitives/0/attributes", json!({})),
            Refused(&["meshes[0].primitives[0]", "POSITION"]),
        ),
        ("no mesh", set("/nodes/0/mesh", json!(9)), Refused(&["meshes[9]"])),
        ("no node", set("/scenes/0/nodes", json!([9])), Refused(&["nodes[9]"])),
        ("no scene", set("/scene", json!(9)), Refused(&["/scene"])),
        ("no skin", set("/nodes/0/skin", json!(9)), Refused(&["skins[9]"])),
        ("a loop", set("/nodes/0/children", json!([0])), Refused(&["nodes[0]", "contain each other"])),
        ("kind", set("/accessors/0/type", json!("VEC2")), Refused(&["accessors[0]", "VEC2", "VEC3"])),
        ("type", set("/accessors/0/componentType", json!(5130)), Refused(&["accessors[0]", "5130"])),
        ("shape", set("/nodes/0/mesh", json!("cube")), Refused(&["/nodes/0/mesh", "\"cube\""])),
        ("less than none", set("/accessors/0/count", json!(-1)), Refused(&["/accessors/0/count", "-1"])),
        ("no version", set("/asset", json!({})), Refused(&["/asset/version"])),
        ("far", set("/nodes/0/scale", json!([1e308, 1e308, 1e308])), Refused(&["meshes[0].primitives[0]", "no place"])),
    ];
    for (case, document, right) in cases {
        check(&folder, case, &document, &right);
    }
    let mut lost = Document::cube();
    lost.bin[4..8].copy_from_slice(&f32::NAN.to_le_bytes());
    check(&folder, "no place", &lost, &Refused(&["meshes[0].primitives[0]", "vertex 0", "POSITION"]));
    let mut beyond = Document::cube();
    beyond.bin[96] = 200;
    check(&folder, "no such vertex", &beyond, &Refused(&["1 of 12 faces", "200 of 8"]));

    let glb = Document::cube().glb();
    for length in [5, 11, 15, 40, glb.len() - 40] {
        folder.check("cut", "a.glb", &glb[..length], &Refused(&["cut off", "missing"]));
    }
    let mut json = Document::cube().text();
    json.truncate(100);
    folder.check("cut", "a.gltf", &json, &Refused(&["line 1, column 100"]));
    folder.check("no JSON", "a.gltf", b"nonsense", &Refused(&["line 1, column 2", "JSON"]));
}

#[test]
fn buffers_are_found_or_named() {
    let folder = Folder::new();
    let bin = Document::cube().bin;
    folder.put("größe.bin", &bin);
    folder.put("short.bin", &bin[..100]);
    std::fs::create_dir(folder.path("sub")).unwrap();
    folder.put("sub/a.bin", &bin);
    let with = |uri: &str| Document::cube().set("/buffers", json!([{"byteLength": bin.len(), "uri": uri}])).text();
    for uri in ["gr%C3%B6%C3%9Fe.bin", "größe.bin", "./sub/a.bin", "sub\\a.bin", "sub/../größe.bin"] {
        folder.check(uri, "a.gltf", &with(uri), &Volume(8.0));
    }
    let refused = [
        ("short.bin", Refused(&["buffers[0]", "short.bin", "100 bytes", "68 bytes are missing"])),
        ("none.bin", Refused(&["none.bin", "no such file"])),
        ("https://example.org/a.bin", Refused(&["buffers[0]", "on the web", "beside"])),
        ("data:application/octet-stream,AAAA", Refused(&["buffers[0]", "not base64"])),
        ("data:application/octet-stream;base64,A*", Refused(&["buffers[0]", "damaged"])),
        ("data:;base64,AAAA", Refused(&["buffers[0]", "3 bytes", "165 bytes are missing"])),
    ];
    for (uri, right) in refused {
        let mut text = with(uri);
        if uri == "none.bin" {
            // Said of the file that is missing.
            folder.put("a.gltf", &text);
            let error = folder.load("a.gltf").unwrap_err().to_string();
            assert!(error.contains("none.bin: there is no such file"), "{error}");
            continue;
        }
        folder.check(uri, "a.gltf", &text, &right);
        text.splice(..0, *b"\xef\xbb\xbf");
        folder.check(uri, "a.gltf", &text, &right);
    }
    let unnamed = Document::cube().set("/buffers", json!([{"byteLength": bin.len()}])).text();
    folder.check("no file", "a.gltf", &unnamed, &Refused(&["buffers[0]", "names no file"]));
    // What nothing draws need not be there.
    let mut spare = Document::cube();
    spare.json["buffers"] =
        json!([{"byteLength": bin.len(), "uri": data_uri(&bin)}, {"byteLength": 9, "uri": "none.bin"}]);
    folder.check("spare", "a.gltf", &spare.text(), &Volume(8.0));
    let glb = Document::cube().glb();
    folder.check("bytes behind", "a.glb", &[glb, vec![0; 7]].concat(), &Volume(8.0));
}
