//! More than sixty kinds of broken and odd files: each a solid of the right volume or one clear sentence, never a
//! panic.

use crate::cases::{CORNERS, Folder, NEVER, QUADS, triangles};
use crate::gltf_document::Document;
use serde_json::json;
use sinew::geometry::Solid;
use std::path::Path;

/// What is right: a volume [m³], or the words of the sentence that says why there is none.
type Right = Result<f64, &'static [&'static str]>;

/// A kind of file: what it is, its name, its bytes, what is right.
type Kind = (&'static str, &'static str, Vec<u8>, Right);

/// Reads a file and fills it; its volume, or the sentence.
fn outcome(path: &Path) -> Result<f64, String> {
    let model = sinew::io::load_model(path).map_err(|error| error.to_string())?;
    Solid::new(&model).map(|solid| solid.volume).map_err(|refusal| refusal.to_string())
}

fn check(kinds: Vec<Kind>) {
    let folder = Folder::new();
    let mut wrong = Vec::new();
    for (kind, name, bytes, right) in kinds {
        folder.put(name, &bytes);
        let found =
            outcome(&folder.path(name)).map_err(|said| said.replace(&folder.path("").display().to_string(), ""));
        let is_right = match (&found, &right) {
            (Ok(volume), Ok(wanted)) => (volume / wanted - 1.0).abs() < 1e-6,
            (Err(said), Err(words)) => {
                let is_a_sentence = said.lines().count() == 1 && (20..600).contains(&said.len());
                is_a_sentence
                    && words.iter().all(|word| said.contains(word))
                    && NEVER.iter().all(|word| !said.contains(word))
            }
            _ => false,
        };
        if !is_right {
            wrong.push(format!("{kind}: {found:?} where {right:?} is right"));
        }
    }
    assert!(wrong.is_empty(), "\n{}", wrong.join("\n"));
}

fn obj(vertices: &[[f64; 3]], faces: &[[u32; 4]]) -> String {
    let vertices = vertices.iter().map(|[x, y, z]| format!("v {x} {y} {z}\n"));
    let faces = faces.iter().map(|face| format!("f {} {} {} {}\n", face[0] + 1, face[1] + 1, face[2] + 1, face[3] + 1));
    vertices.chain(faces).collect()
}

fn cube() -> String {
    obj(&CORNERS, &QUADS)
}

/// The cube, each coordinate as `f` makes it.
fn cube_of(f: impl Fn(f64) -> f64) -> String {
    obj(&CORNERS.map(|corner| corner.map(&f)), &QUADS)
}

#[test]
fn odd_obj_files() {
    let with = |text: &str| format!("{}{text}\n", cube()).into_bytes();
    let inside_out = QUADS.map(|[a, b, c, d]| [d, c, b, a]);
    let mut zeros = cube().into_bytes();
    zeros.splice(20..20, [0; 30]);
    let far = cube().replacen("v ", "v 1e9 1e9 1e9\nv ", 1);
    let far = far.lines().map(|line| match line.strip_prefix("f ") {
        Some(corners) => {
            let next = |word: &str| (word.parse::<u32>().expect("an index") + 1).to_string();
            format!("f {}\n", corners.split(' ').map(next).collect::<Vec<_>>().join(" "))
        }
        None => format!("{line}\n"),
    });
    check(vec![
        ("inside out", "a.obj", obj(&CORNERS, &inside_out).into_bytes(), Ok(8.0)),
        ("one face twice", "a.obj", with("f 4 3 2 1"), Ok(8.0)),
        ("one face open", "a.obj", obj(&CORNERS, &QUADS[..5]).into_bytes(), Err(&["too open", "1 hole"])),
        ("as small as dust", "a.obj", cube_of(|c| 1e-4 * c).into_bytes(), Ok(8e-12)),
        ("as large as a planet", "a.obj", cube_of(|c| 1e6 * c).into_bytes(), Ok(8e18)),
        ("far from its origin", "a.obj", cube_of(|c| c + 1e4).into_bytes(), Ok(8.0)),
        ("a stray vertex far away", "a.obj", far.collect::<Vec<_>>().concat().into_bytes(), Ok(8.0)),
        ("a comment of a megabyte", "a.obj", with(&format!("#{}", "x".repeat(1 << 20))), Ok(8.0)),
        ("statements of nobody", "a.obj", with("shadow_obj a\nlod 3\nzzz 1 2 3"), Ok(8.0)),
        ("two at one place", "a.obj", with(&cube()), Ok(8.0)),
        ("points alone", "a.obj", obj(&CORNERS, &[]).into_bytes(), Err(&["no faces"])),
        ("a sheet", "a.obj", obj(&CORNERS, &QUADS[..1]).into_bytes(), Err(&["encloses nothing"])),
        ("all at one point", "a.obj", cube_of(|_| 1.0).into_bytes(), Err(&["encloses nothing"])),
        ("larger than numbers go", "a.obj", cube_of(|c| 1e300 * c).into_bytes(), Err(&["no numbers"])),
        ("smaller than numbers go", "a.obj", cube_of(|c| 1e-300 * c).into_bytes(), Err(&["encloses nothing"])),
        ("corner zero", "a.obj", with("f 0 1 2"), Err(&["line 15", "0"])),
        ("a corner that is not there", "a.obj", with("f 1 2 99"), Err(&["line 15", "99"])),
        ("a corner beyond all numbers", "a.obj", with("f 1 2 99999999999999999999"), Err(&["line 15"])),
        ("a face of two corners", "a.obj", with("f 1 2\nf 3"), Ok(8.0)),
        ("a half of a coordinate", "a.obj", with("v 1 2"), Err(&["line 15", "three coordinates"])),
        ("zeros within", "a.obj", zeros, Err(&["line"])),
    ]);
}

fn stl_text() -> String {
    let facet = |triangle: [u32; 3]| {
        let corner = |c: u32| format!("vertex {:?}\n", CORNERS[c as usize]).replace(['[', ']', ','], "");
        format!("facet normal 0 0 0\nouter loop\n{}endloop\nendfacet\n", triangle.map(corner).concat())
    };
    format!("solid a\n{}endsolid a\n", triangles().into_iter().map(facet).collect::<String>())
}

fn stl(head: &str, count: u32, attribute: u16) -> Vec<u8> {
    let mut bytes = head.as_bytes().to_vec();
    bytes.resize(80, 0);
    bytes.extend(count.to_le_bytes());
    for triangle in triangles() {
        bytes.extend([0xff; 12]);
        let corners = triangle.map(|corner| CORNERS[corner as usize]);
        bytes.extend(corners.iter().flatten().flat_map(|c| (*c as f32).to_le_bytes()));
        bytes.extend(attribute.to_le_bytes());
    }
    bytes
}

#[test]
fn odd_stl_files() {
    let text = stl_text();
    let mut nan = stl("", 12, 0);
    nan[96..100].copy_from_slice(&f32::NAN.to_le_bytes());
    let mut more = stl("", 12, 0);
    more.extend([7; 20]);
    check(vec![
        ("binary that begins as text does", "a.stl", stl("solid a", 12, 0), Ok(8.0)),
        ("normals that are no numbers, colours", "a.stl", stl("COLOR=rgba", 12, 0xffff), Ok(8.0)),
        ("no end", "a.stl", text.replace("endsolid a\n", "").into_bytes(), Ok(8.0)),
        (
            "a flat facet more",
            "a.stl",
            {
                let flat =
                    "facet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 2 0 0\nvertex 2 0 0\nendloop\nendfacet\n";
                text.replace("endsolid", &format!("{flat}endsolid")).into_bytes()
            },
            Ok(8.0),
        ),
        ("bytes behind the last facet", "a.stl", more, Ok(8.0)),
        ("fewer facets than announced", "a.stl", stl("", 13, 0), Err(&["13"])),
        ("more than any disk holds announced", "a.stl", stl("", u32::MAX, 0), Ok(8.0)),
        ("no facets", "a.stl", stl("", 0, 0)[..84].to_vec(), Err(&["no faces"])),
        ("cut off within a facet", "a.stl", stl("", 12, 0)[..300].to_vec(), Err(&["missing"])),
        ("a corner at no place", "a.stl", nan, Err(&["no place"])),
        (
            "a facet of four corners",
            "a.stl",
            text.replacen("endloop", "vertex 0 0 0\nendloop", 1).into_bytes(),
            Err(&["line 9", "4 corners"]),
        ),
        ("text cut off within a facet", "a.stl", text.as_bytes()[..200].to_vec(), Err(&["line"])),
        (
            "a word for a coordinate",
            "a.stl",
            text.replacen("vertex 0.0", "vertex zero", 1).into_bytes(),
            Err(&["line", "zero"]),
        ),
    ]);
}

const XYZ: &str = "property float x\nproperty float y\nproperty float z\n";

fn ply(vertex: &str, faces: &str, list: &str) -> String {
    let vertices = CORNERS.map(|[x, y, z]| format!("{x} {y} {z}\n")).concat();
    format!("ply\nformat ascii 1.0\nelement vertex 8\n{vertex}element face {faces}\n{list}end_header\n{vertices}")
}

fn ply_cube(last: &str) -> String {
    let faces = QUADS.map(|[a, b, c, d]| format!("4 {a} {b} {c} {d}\n")).concat();
    let (count, list) = (6 + last.lines().count(), "property list uchar int vertex_indices\n");
    ply(XYZ, &count.to_string(), list) + &faces + last
}

#[test]
fn odd_ply_files() {
    let text = |text: String| text.into_bytes();
    check(vec![
        ("doubles", "a.ply", text(ply_cube("").replace("float", "double")), Ok(8.0)),
        (
            "old names of types",
            "a.ply",
            text(ply_cube("").replace("float", "float32").replace("uchar int", "uint8 int32")),
            Ok(8.0),
        ),
        ("a face of two corners", "a.ply", text(ply_cube("2 0 1\n")), Ok(8.0)),
        ("a corner that is not there", "a.ply", text(ply_cube("3 0 1 8\n")), Err(&["8"])),
        ("a corner before the first", "a.ply", text(ply_cube("3 0 1 -1\n")), Err(&["-1"])),
        ("a corner and a half", "a.ply", text(ply_cube("3 0 1 1.5\n")), Err(&["1.5"])),
        ("a list of less than none", "a.ply", text(ply_cube("-3 0 1 2\n")), Err(&["-3"])),
        ("no faces", "a.ply", text(ply(XYZ, "0", "property list uchar int vertex_indices\n")), Err(&["no faces"])),
        ("no z", "a.ply", text(ply_cube("").replace("property float z\n", "property float w\n")), Err(&["`z`"])),
        ("a type of nobody", "a.ply", text(ply_cube("").replace("float x", "half x")), Err(&["half"])),
        ("less than no vertices", "a.ply", text(ply_cube("").replace("vertex 8", "vertex -8")), Err(&["-8"])),
        (
            "more vertices than there can be",
            "a.ply",
            text(ply_cube("").replace("vertex 8", "vertex 999999999999999999")),
            Err(&["announces more"]),
        ),
        (
            "text that says it is binary",
            "a.ply",
            text(ply_cube("").replace("ascii", "binary_little_endian")),
            Err(&["cut off"]),
        ),
        ("a header without end", "a.ply", text(ply_cube("").replace("end_header\n", "")), Err(&["line"])),
        ("cut off", "a.ply", text(ply_cube("")[..230].to_owned()), Err(&["missing"])),
    ]);
}

#[test]
fn odd_gltf_files() {
    let cube = Document::cube;
    let mut wrong_length = cube().glb();
    let more = wrong_length.len() as u32 + 64;
    wrong_length[8..12].copy_from_slice(&more.to_le_bytes());
    let glb = cube().glb();
    check(vec![
        (
            "a node of no size",
            "a.glb",
            cube().set("/nodes/0/scale", json!([0, 0, 0])).glb(),
            Err(&["encloses nothing"]),
        ),
        ("a mirrored node", "a.glb", cube().set("/nodes/0/scale", json!([-1, 1, 1])).glb(), Ok(8.0)),
        (
            "nodes within themselves",
            "a.glb",
            cube().set("/nodes/0/children", json!([0])).glb(),
            Err(&["contain each other"]),
        ),
        ("no scene", "a.glb", cube().set("/scenes", json!([])).set("/scene", json!(null)).glb(), Ok(8.0)),
        ("a scene that is not there", "a.glb", cube().set("/scene", json!(7)).glb(), Err(&["/scene"])),
        ("no nodes", "a.glb", cube().set("/scenes/0/nodes", json!([])).glb(), Err(&["no faces"])),
        ("points", "a.glb", cube().set("/meshes/0/primitives/0/mode", json!(0)).glb(), Err(&["no faces"])),
        ("a version to come", "a.glb", cube().set("/asset/version", json!("3.0")).glb(), Err(&["3.0"])),
        (
            "an extension that must be known",
            "a.glb",
            cube().set("/extensionsRequired", json!(["ACME_new"])).glb(),
            Err(&["ACME_new"]),
        ),
        (
            "a view beyond its buffer",
            "a.glb",
            cube().set("/bufferViews/0/byteLength", json!(99999)).glb(),
            Err(&["missing"]),
        ),
        (
            "more vertices than its view has",
            "a.glb",
            cube().set("/accessors/0/count", json!(9)).glb(),
            Err(&["missing"]),
        ),
        ("fewer vertices than are referred to", "a.glb", cube().set("/accessors/0/count", json!(7)).glb(), Err(&["7"])),
        ("numbers of no type", "a.glb", cube().set("/accessors/0/componentType", json!(5130)).glb(), Err(&["5130"])),
        (
            "a buffer that is not there",
            "a.gltf",
            cube().set("/buffers", json!([{"byteLength": 168, "uri": "gone.bin"}])).text(),
            Err(&["gone.bin"]),
        ),
        (
            "base64 that is none",
            "a.gltf",
            cube().set("/buffers", json!([{"byteLength": 9, "uri": "data:;base64,!!!!"}])).text(),
            Err(&["base64"]),
        ),
        ("a length beyond the file's", "a.glb", wrong_length, Err(&["announced"])),
        ("cut off", "a.glb", glb[..glb.len() - 40].to_vec(), Err(&["missing"])),
    ]);
}

#[test]
fn files_that_are_something_else() {
    let page = "<!DOCTYPE html>\n<html><body>404 Not Found</body></html>\n";
    let pointer = "version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\nsize 12345\n";
    let mut kinds = Vec::new();
    for name in ["a.obj", "a.stl", "a.ply", "a.gltf", "a.glb"] {
        for (kind, bytes) in [
            ("empty", Vec::new()),
            ("blank", b" \n\n\t\n".to_vec()),
            ("a page of the web", page.as_bytes().to_vec()),
            ("a pointer to a file elsewhere", pointer.as_bytes().to_vec()),
            ("an archive", b"PK\x03\x04\x14\0\0\0\x08\0abcdefghijklmnopqrstuvwxyz".to_vec()),
            ("a picture", b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\x01\0\0\0\x01\x08\x02\0\0\0".to_vec()),
            ("zeros", vec![0; 4096]),
        ] {
            kinds.push((kind, name, bytes, Err(&[][..])));
        }
    }
    check(kinds);
}
