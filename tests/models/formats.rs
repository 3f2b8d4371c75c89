//! Files of every format come in as they were meant.

use glam::{DVec3, Vec3};
use sinew::geometry::Solid;
use sinew::geometry::UpAxis;
use sinew::io::{IoError, load_model, write_glb};
use std::fmt::Write;
use std::fs;
use std::path::Path;

/// A cube of side 2 with a corner at the origin, as quads.
pub const CUBE: &str = "mtllib cube.mtl\no cube\n\
    v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 0 0 2\nv 2 0 2\nv 2 2 2\nv 0 2 2\n\
    vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nusemtl red\n\
    f 4/1 3/2 2/3 1/4\nf 5/1 6/2 7/3 8/4\nf 1/1 2/2 6/3 5/4\nf 2/1 3/2 7/3 6/4\nf 3/1 4/2 8/3 7/4\nf 4/1 1/2 5/3 8/4\n";

/// Volume of a sound model, without what is round-off.
fn volume(path: &Path) -> f64 {
    let model = load_model(path).unwrap_or_else(|error| panic!("{error}"));
    let solid = Solid::new(&model).expect("an inside");
    assert!(solid.report.closed && solid.report.findings().is_empty(), "{:?}", solid.report);
    (1e9 * solid.volume).round() * 1e-9
}

#[test]
fn obj_welds_its_seams_and_takes_colours_from_its_materials() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("cube.obj");
    fs::write(&path, CUBE).unwrap();
    fs::write(folder.path().join("cube.mtl"), "newmtl red\nKd 1 0 0\n").unwrap();
    assert_eq!(volume(&path), 8.0);
    let model = load_model(&path).unwrap();
    assert_eq!(model.parts[0].name, "cube");
    assert!(model.colours.iter().all(|c| *c == [1.0, 0.0, 0.0, 1.0]));
    // Split where texture coordinates differ, for the picture.
    assert!(model.positions.len() > 8);
    assert_eq!(Solid::new(&model).unwrap().surface.points.len(), 8);
    // Without its materials it is the same shape.
    fs::remove_file(folder.path().join("cube.mtl")).unwrap();
    assert_eq!(volume(&path), 8.0);
}

#[test]
fn stl_comes_as_text_and_binary_whatever_its_first_word() {
    let folder = tempfile::tempdir().unwrap();
    let obj = folder.path().join("cube.obj");
    fs::write(&obj, CUBE).unwrap();
    let cube = load_model(&obj).unwrap();
    let corner = |i: u32| cube.positions[i as usize].as_vec3();

    let mut text = "solid\n".to_owned();
    let mut binary = b"solid is no sign of text".to_vec();
    binary.resize(80, b' ');
    binary.extend((cube.triangles.len() as u32).to_le_bytes());
    for t in &cube.triangles {
        text += "facet normal 0 0 0\nouter loop\n";
        binary.extend([0; 12]);
        for p in t.map(corner) {
            writeln!(text, "vertex {} {} {}", p.x, p.y, p.z).unwrap();
            binary.extend(p.to_array().iter().flat_map(|c| c.to_le_bytes()));
        }
        text += "endloop\nendfacet\n";
        binary.extend([0; 2]);
    }
    text += "endsolid\n";
    for (name, bytes) in [("text.stl", text.into_bytes()), ("binary.STL", binary)] {
        let path = folder.path().join(name);
        fs::write(&path, bytes).unwrap();
        assert_eq!(volume(&path), 8.0, "{name}");
    }
}

#[test]
fn ply_reads_quads_normals_and_colours() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("cube.ply");
    let mut text = "ply\nformat ascii 1.0\nelement vertex 8\nproperty double x\nproperty float y\nproperty float z\n\
        property float nx\nproperty float ny\nproperty float nz\n\
        property uchar red\nproperty uchar green\nproperty uchar blue\nelement face 6\n\
        property list uchar int vertex_indices\nend_header\n"
        .to_owned();
    for k in 0..8 {
        writeln!(text, "{} {} {} 0 0 2 255 0 0", 2 * (k & 1), k & 2, (k & 4) / 2).unwrap();
    }
    text += "4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 1 3 7 5\n4 3 2 6 7\n4 2 0 4 6\n";
    fs::write(&path, text).unwrap();
    assert_eq!(volume(&path), 8.0);
    let model = load_model(&path).unwrap();
    assert_eq!(model.normals[0], Vec3::Z);
    assert_eq!(model.colours[0], [1.0, 0.0, 0.0, 1.0]);
}

#[test]
fn glb_keeps_positions_normals_and_colour() {
    let folder = tempfile::tempdir().unwrap();
    let model = {
        let mut model = crate::shapes::sphere(12, 0.5);
        model.normals = model.positions.iter().map(|p| (2.0 * p).as_vec3()).collect();
        model.colours = vec![[0.25, 0.5, 0.75, 1.0]; model.positions.len()];
        model
    };
    let path = folder.path().join("ball.glb");
    write_glb(&path, &model, "ball").unwrap();
    let read = load_model(&path).unwrap();
    assert_eq!(read.triangles, model.triangles);
    assert_eq!(read.colours, model.colours);
    let apart = |a: &[Vec3], b: &[Vec3]| a.iter().zip(b).map(|(a, b)| a.distance(*b)).fold(0.0, f32::max);
    assert!(apart(&read.normals, &model.normals) < 1e-6);
    let single = |p: &[DVec3]| p.iter().map(|p| p.as_vec3()).collect::<Vec<_>>();
    assert_eq!(single(&read.positions), single(&model.positions));
}

#[test]
fn gltf_places_its_meshes_and_reads_its_buffer_beside_it() {
    let folder = tempfile::tempdir().unwrap();
    let corners: [[f32; 3]; 4] = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let faces: [u8; 12] = [0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2];
    let mut buffer: Vec<u8> = corners.iter().flatten().flat_map(|c| c.to_le_bytes()).collect();
    buffer.extend(faces);
    fs::write(folder.path().join("my data.bin"), &buffer).unwrap();
    let document = serde_json::json!({
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        // A mirror, a scale of two, and a child: volume 8 x 1/6, the right way out.
        "nodes": [{"scale": [-2, 2, 2], "children": [1]}, {"mesh": 0, "translation": [5, 0, 0]}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 1]},
            {"bufferView": 1, "componentType": 5121, "count": 12, "type": "SCALAR"}
        ],
        "bufferViews": [
            {"buffer": 0, "byteOffset": 0, "byteLength": 48},
            {"buffer": 0, "byteOffset": 48, "byteLength": 12}
        ],
        "buffers": [{"byteLength": 60, "uri": "my%20data.bin"}]
    });
    let path = folder.path().join("part.gltf");
    fs::write(&path, document.to_string()).unwrap();
    assert!((volume(&path) - 8.0 / 6.0).abs() < 1e-9);
    let model = load_model(&path).unwrap();
    assert_eq!(model.positions[0], DVec3::new(-10.0, 0.0, 0.0));

    fs::remove_file(folder.path().join("my data.bin")).unwrap();
    let error = load_model(&path).unwrap_err().to_string();
    assert!(error.contains("my data.bin") && error.contains("no such file"), "{error}");
}

#[test]
fn units_and_up_axis_follow_the_scene() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("cube.obj");
    fs::write(&path, CUBE).unwrap();
    let mut model = load_model(&path).unwrap();
    model.stand_up(UpAxis::Z, 0.001);
    let solid = Solid::new(&model).unwrap();
    assert!((solid.volume - 8e-9).abs() < 1e-20);
    assert_eq!((solid.min, solid.max), (DVec3::new(0.0, 0.0, -0.002), DVec3::new(0.002, 0.002, 0.0)));
}

#[test]
fn files_that_are_no_models_are_refused_in_plain_words() {
    let folder = tempfile::tempdir().unwrap();
    let message = |name: &str, bytes: &[u8]| {
        let path = folder.path().join(name);
        fs::write(&path, bytes).unwrap();
        load_model(&path).unwrap_err().to_string()
    };
    assert!(message("shape.blend", b"").contains("give an OBJ, STL, PLY, glTF or GLB file"));
    assert!(
        message("shape.ply", b"ply\nformat ascii 1.0\nelement vertex 4000000000\n").contains("PLY file cannot be read")
    );
    let huge = b"ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\nproperty float x\nend_header\n";
    assert!(message("huge.ply", huge).contains("announces more than the file holds"));
    assert!(message("shape.glb", b"glTF nonsense").contains("glTF file cannot be read"));
    assert!(message("shape.stl", b"short").contains("STL file cannot be read"));
    let error = load_model(folder.path()).unwrap_err();
    assert!(matches!(error.bare(), IoError::UnknownModel));
    let folder_named_like_one = folder.path().join("folder.obj");
    fs::create_dir(&folder_named_like_one).unwrap();
    assert!(matches!(load_model(&folder_named_like_one).unwrap_err().bare(), IoError::NotAFile(_)));
    assert!(matches!(load_model(&folder.path().join("none.obj")).unwrap_err().bare(), IoError::Missing));
}
