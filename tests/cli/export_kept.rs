//! What a file holds beside its shape comes out again: normals, colours, names, materials. And what moves beside the
//! bodies.
#![allow(clippy::format_push_string, clippy::needless_for_each, reason = "files of a few lines, built up as they read")]

use super::export::{PRISM, desk, falling, obj};
use super::export_clip::glb;
use serde_json::{Value, json};
use sinew::geometry::FileMesh;
use sinew::io::load_model;
use std::fs;
use std::path::Path;

/// Directions of length one that are those of no face.
const DIRECTIONS: [[f64; 3]; 8] = [
    [0.6, 0.0, 0.8],
    [0.0, 0.6, 0.8],
    [-0.6, 0.8, 0.0],
    [-0.8, 0.0, 0.6],
    [0.0, -0.8, 0.6],
    [0.8, -0.6, 0.0],
    [0.0, 0.0, 1.0],
    [0.28, 0.96, 0.0],
];

/// The prism with a normal of its own for the corners of every face, and a colour for every vertex.
fn lit_prism() -> String {
    let (mut text, mut vertex, mut face) = (String::new(), 0, 0);
    for line in PRISM.lines() {
        if line.starts_with("v ") {
            text += &format!("{line} 0.25 0.5 {}\n", f64::from(vertex) / 12.0);
            vertex += 1;
        } else if let Some(corners) = line.strip_prefix("f ") {
            face += 1;
            let lit = |word: &str| format!(" {word}{}{face}", if word.contains('/') { "/" } else { "//" });
            text += &format!("f{}\n", corners.split(' ').map(lit).collect::<String>());
        } else {
            if line == "usemtl red paint" {
                DIRECTIONS.iter().for_each(|[x, y, z]| text += &format!("vn {x} {y} {z}\n"));
            }
            text += &format!("{line}\n");
        }
    }
    text
}

fn read(path: &Path) -> FileMesh {
    let model = load_model(path).unwrap_or_else(|error| panic!("{error}"));
    FileMesh::clone(model.file.as_deref().expect("the mesh of the file"))
}

/// Place, normal and colour of every corner.
fn corners(mesh: &FileMesh) -> Vec<[f64; 9]> {
    let normals = mesh.normals.as_ref().expect("normals");
    let at = |(corner, &vertex): (usize, &u32)| {
        let place = mesh.points[vertex as usize].to_array();
        let normal = normals.values[normals.of(corner).expect("a normal") as usize].to_array();
        let [r, g, b, _] = mesh.colours[vertex as usize].map(f64::from);
        let mut all = [0.0; 9];
        [place, normal, [r, g, b]].concat().into_iter().zip(&mut all).for_each(|(value, place)| *place = value);
        all
    };
    mesh.corners.iter().enumerate().map(at).collect()
}

/// Names, materials and base colours of the parts, and how many corners each has.
fn parts(mesh: &FileMesh) -> Vec<(String, String, Option<[f32; 4]>)> {
    mesh.parts.iter().map(|part| (part.name.clone(), part.material.clone(), part.colour)).collect()
}

fn near(a: &[f64; 9], b: &[f64; 9], share: f64) -> bool {
    a.iter().zip(b).all(|(a, b)| (a - b).abs() < share)
}

#[test]
fn what_a_file_holds_goes_out_in_again_and_out_once_more() {
    let desk = desk();
    fs::write(desk.path("prism.obj"), lit_prism()).unwrap();
    let mut scene = falling();
    scene["two_layer"] = json!([]);
    fs::write(desk.path("scene.json"), scene.to_string()).unwrap();
    desk.ran("simulate scene.json --format obj,gltf,usd,ply,pc2 --frames 0..5 --out out");
    let given = read(&desk.path("prism.obj"));
    let wanted = [("sides", "red paint", Some([1.0, 0.0, 0.0, 1.0])), ("caps", "none", None)];
    let wanted = wanted.map(|(name, material, colour)| (name.to_owned(), material.to_owned(), colour));
    assert_eq!(parts(&given), wanted);
    // As the scene has put it; it falls and does not turn.
    let fallen = |frame: u32| {
        let down = 0.5 * 9.81 * (0.02 * f64::from(frame)).powi(2);
        let put = move |[x, y, z, nx, ny, nz, r, g, b]: [f64; 9]| {
            [0.1 - 1e-3 * y, 0.5 + 1e-3 * z - down, -0.2 - 1e-3 * x, -ny, nz, -nx, r, g, b]
        };
        corners(&given).into_iter().map(put).collect::<Vec<_>>()
    };
    for (name, frame) in [("Red_prism_1_rest", 0), ("frame_000000", 0), ("frame_000005", 5)] {
        let mesh = read(&desk.path(&format!("out/{name}.obj")));
        assert_eq!((&mesh.counts, &mesh.corners), (&given.counts, &given.corners), "{name}");
        for (a, b) in corners(&mesh).iter().zip(fallen(frame)) {
            assert!(near(a, &b, if frame == 0 { 2e-6 } else { 2e-5 }), "{name}: {a:?} {b:?}");
        }
    }

    let clip = read(&desk.path("out/motion.glb"));
    // The format has a base colour for every material: white is what says nothing.
    let white = Some([1.0; 4]);
    let in_clip: Vec<_> =
        wanted.iter().map(|(name, material, colour)| (name.clone(), material.clone(), colour.or(white))).collect();
    assert_eq!(parts(&clip), in_clip);
    let found = corners(&clip);
    assert!(fallen(0).iter().all(|wanted| found.iter().any(|found| near(found, wanted, 1e-6))));
    let (document, _) = glb(&fs::read(desk.path("out/motion.glb")).unwrap());
    let primitive = &document["meshes"][0]["primitives"][0];
    assert!(primitive["targets"][5]["NORMAL"].is_u64() && primitive["attributes"]["COLOR_0"].is_u64(), "{primitive}");

    let (shape, frame) = (desk.text("out/motion_layers/shape.usda"), desk.text("out/motion_layers/frame.000005.usda"));
    for part in [
        "def GeomSubset \"sides\"",
        "def GeomSubset \"caps\"",
        "displayName = \"red paint\"",
        "inputs:diffuseColor = (1, 0, 0)",
        "color3f[] primvars:displayColor = [(0.05087",
        "interpolation = \"faceVarying\"",
    ] {
        assert!(shape.contains(part), "{part}: {shape}");
    }
    let normals = frame.split_once("normals.timeSamples").unwrap().1.split_once(']').unwrap().0;
    assert_eq!(normals.matches('(').count(), given.corners.len());

    // A PLY has no place for several normals of a vertex, and colours of eight bits.
    let ply = read(&desk.path("out/frame_000000.ply"));
    let off = ply.colours.iter().flatten().zip(given.colours.iter().flatten()).map(|(a, b)| (a - b).abs());
    assert!(ply.normals.is_none() && ply.colours.len() == 13 && off.fold(0.0, f32::max) < 0.01);

    // The clip, and what comes of it.
    scene["bodies"][0]["shape"]["mesh"] = json!({"path": "out/motion.glb", "particles": 200});
    scene["bodies"][0]["placement"] = json!({});
    scene["bodies"][0]["fibres"] = json!([]);
    fs::write(desk.path("again.json"), scene.to_string()).unwrap();
    desk.ran("simulate again.json --format gltf,usd --frames 0..0 --out again");
    let again = read(&desk.path("again/motion.glb"));
    assert_eq!(parts(&again), in_clip);
    let found = corners(&again);
    assert!(found.len() == corners(&clip).len());
    assert!(corners(&clip).iter().all(|wanted| found.iter().any(|found| near(found, wanted, 1e-6))));
    let shape = desk.text("again/motion_layers/shape.usda");
    assert!(shape.contains("def GeomSubset \"caps\"") && shape.contains("displayName = \"red paint\""), "{shape}");
}

#[test]
fn a_vertex_keeps_its_normal_and_its_colour_in_ply() {
    let desk = desk();
    let corners = [[0.0, 0.0, 0.0], [0.06, 0.0, 0.0], [0.0, 0.06, 0.0], [0.0, 0.0, 0.06]];
    let mut text = "ply\nformat ascii 1.0\nelement vertex 4\n".to_owned();
    for name in ["x", "y", "z", "nx", "ny", "nz"] {
        text += &format!("property float {name}\n");
    }
    for name in ["red", "green", "blue"] {
        text += &format!("property uchar {name}\n");
    }
    text += "element face 4\nproperty list uchar int vertex_indices\nend_header\n";
    for (k, ([x, y, z], [nx, ny, nz])) in corners.iter().zip(DIRECTIONS).enumerate() {
        text += &format!("{x} {y} {z} {nx} {ny} {nz} {} 7 255\n", 80 * k);
    }
    text += "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
    fs::write(desk.path("tetrahedron.ply"), text).unwrap();
    let mut scene = falling();
    scene["two_layer"] = json!([]);
    scene["bodies"][0]["shape"]["mesh"] = json!({"path": "tetrahedron.ply", "particles": 200});
    scene["bodies"][0]["placement"] = json!({});
    scene["bodies"][0]["fibres"] = json!([]);
    fs::write(desk.path("scene.json"), scene.to_string()).unwrap();
    desk.ran("simulate scene.json --format ply --frames 0..3 --out out");
    let given = read(&desk.path("tetrahedron.ply"));
    for frame in [0, 3] {
        let mesh = read(&desk.path(&format!("out/frame_{frame:06}.ply")));
        assert_eq!((&mesh.corners, &mesh.colours), (&given.corners, &given.colours));
        let pairs = mesh.normals.unwrap().values.into_iter().zip(given.normals.clone().unwrap().values);
        assert!(pairs.into_iter().all(|(a, b)| (a - b).length() < 1e-5));
    }
    let file = fs::read(desk.path("out/frame_000003.ply")).unwrap();
    assert!(String::from_utf8_lossy(&file[..400]).contains("property float vx\n"));
}

#[test]
fn panels_are_meshes_that_move() {
    let desk = desk();
    let mut scene = falling();
    scene["panels"] = json!([{"id": "lid", "name": "My lid", "height": 3, "size": [0.1, 0.2], "motion": "falls"}]);
    fs::write(desk.path("scene.json"), scene.to_string()).unwrap();
    desk.ran("simulate scene.json --format obj,gltf,usd,pc2,csv,ply --frames 0..5 --up z --out out");
    let text = desk.text("out/frame_000005.obj");
    let (_, own) = text.split_once("o My_lid\n").expect("the panel is an object");
    let (vertices, lines) = obj(own);
    assert_eq!((vertices.len(), lines["f"].len()), (8, 6));
    let lowest = vertices.iter().map(|vertex| vertex[2]).fold(f64::INFINITY, f64::min);
    assert!((lowest - 3.0 + 0.5 * 9.81 * 0.01).abs() < 3e-3, "{lowest}");
    let (document, _) = glb(&fs::read(desk.path("out/motion.glb")).unwrap());
    let nodes: Vec<&Value> = document["nodes"].as_array().unwrap().iter().map(|node| &node["name"]).collect();
    assert!(nodes.contains(&&json!("My lid")), "{nodes:?}");
    let shape = desk.text("out/motion_layers/shape.usda");
    assert!(shape.contains("def Mesh \"My_lid\"") && desk.path("out/My_lid.pc2").is_file(), "{shape}");
    let clip = desk.text("out/motion_layers/frame.000005.usda");
    let velocity = clip.split_once("\"My_lid\"").unwrap().1.split_once("velocities").unwrap().1;
    let velocity: Vec<f64> = velocity.split(['(', ')', ',']).filter_map(|word| word.trim().parse().ok()).collect();
    assert!((velocity[2] + 9.81 * 0.1).abs() < 0.02 && velocity[0] == 0.0, "{velocity:?}");
}
