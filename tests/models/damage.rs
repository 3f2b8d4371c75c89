//! A thousand damaged files over all formats: an error or a model, never a panic, and never a hang.

use crate::formats::CUBE;
use crate::shapes::sphere;
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};
use sinew::geometry::Model;
use sinew::geometry::Solid;
use sinew::geometry::{FillResolution, fill};
use sinew::io::{load_model, write_glb};
use std::fs;
use std::path::Path;

/// What happens to a file.
#[derive(Clone, Debug)]
enum Damage {
    Overwrite(f64, Vec<u8>),
    Insert(f64, Vec<u8>),
    Remove(f64, usize),
    CutOff(f64),
    Repeat(f64, usize),
}

impl Damage {
    fn apply(&self, bytes: &mut Vec<u8>) {
        let place = |share: f64| (share * bytes.len() as f64) as usize;
        match self {
            Self::Overwrite(share, new) => {
                let at = place(*share);
                for (old, new) in bytes.iter_mut().skip(at).zip(new) {
                    *old = *new;
                }
            }
            Self::Insert(share, new) => {
                let at = place(*share);
                bytes.splice(at..at, new.iter().copied());
            }
            Self::Remove(share, count) => {
                let at = place(*share);
                bytes.drain(at..(at + count).min(bytes.len()));
            }
            Self::CutOff(share) => bytes.truncate(place(*share)),
            Self::Repeat(share, count) => {
                let at = place(*share);
                let piece = bytes[at..(at + count).min(bytes.len())].to_vec();
                bytes.splice(at..at, piece);
            }
        }
    }
}

fn damage() -> impl Strategy<Value = Damage> {
    let share = 0.0..1.0_f64;
    let text = prop::sample::select(vec!["nan", "-1", "1e308", "4294967295", "f 1 2 99", "\n", "0", "inf", "[", "}"]);
    let bytes = prop_oneof![vec(any::<u8>(), 1..9), text.prop_map(|text| text.as_bytes().to_vec())];
    prop_oneof![
        (share.clone(), bytes.clone()).prop_map(|(at, new)| Damage::Overwrite(at, new)),
        (share.clone(), bytes).prop_map(|(at, new)| Damage::Insert(at, new)),
        (share.clone(), 1..60_usize).prop_map(|(at, count)| Damage::Remove(at, count)),
        share.clone().prop_map(Damage::CutOff),
        (share, 1..200_usize).prop_map(|(at, count)| Damage::Repeat(at, count)),
    ]
}

fn ply(model: &Model, binary: bool) -> Vec<u8> {
    let format = if binary { "binary_big_endian" } else { "ascii" };
    let mut bytes = format!(
        "ply\nformat {format} 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\n\
         element face {}\nproperty list uchar int vertex_indices\nend_header\n",
        model.positions.len(),
        model.triangles.len()
    )
    .into_bytes();
    for p in &model.positions {
        let p = p.as_vec3();
        if binary {
            bytes.extend(p.to_array().iter().flat_map(|c| c.to_be_bytes()));
        } else {
            bytes.extend(format!("{} {} {}\n", p.x, p.y, p.z).bytes());
        }
    }
    for [a, b, c] in &model.triangles {
        if binary {
            bytes.push(3);
            bytes.extend([a, b, c].iter().flat_map(|i| i.to_be_bytes()));
        } else {
            bytes.extend(format!("3 {a} {b} {c}\n").bytes());
        }
    }
    bytes
}

fn stl(model: &Model) -> Vec<u8> {
    let mut bytes = vec![0; 80];
    bytes.extend((model.triangles.len() as u32).to_le_bytes());
    for t in &model.triangles {
        bytes.extend([0; 12]);
        for i in t {
            bytes.extend(model.positions[*i as usize].as_vec3().to_array().iter().flat_map(|c| c.to_le_bytes()));
        }
        bytes.extend([0; 2]);
    }
    bytes
}

fn gltf(glb: &[u8]) -> Vec<u8> {
    // The document of a GLB without its binary part, which is then missing: all that is left is the text to damage.
    let length = u32::from_le_bytes([glb[12], glb[13], glb[14], glb[15]]) as usize;
    glb[20..20 + length].to_vec()
}

fn survive(path: &Path) {
    let Ok(model) = load_model(path) else { return };
    assert!(model.positions.iter().all(|position| position.is_finite()), "{}", path.display());
    let Ok(solid) = Solid::new(&model) else { return };
    assert!(solid.volume > 0.0 && solid.volume.is_finite());
    if let Ok(filling) = fill(&solid, FillResolution::Particles(60), 2.5, 2000) {
        assert!(filling.sample.points.iter().all(|point| point.is_finite()));
    }
}

#[test]
fn a_thousand_damaged_files_do_no_harm() {
    damaged_files_do_no_harm(1000, &TestRng::deterministic_rng(RngAlgorithm::default()));
}

#[test]
#[ignore = "hours: cargo test --release --test models -- --ignored a_million_damaged"]
fn a_million_damaged_files_do_no_harm() {
    for part in 0..1000_u64 {
        let seed: Vec<u8> = part.to_le_bytes().iter().copied().cycle().take(32).collect();
        damaged_files_do_no_harm(1000, &TestRng::from_seed(RngAlgorithm::ChaCha, &seed));
    }
}

fn damaged_files_do_no_harm(cases: u32, random: &TestRng) {
    let folder = tempfile::tempdir().expect("a folder");
    let ball = {
        let mut ball = sphere(4, 0.05);
        ball.normals = ball.positions.iter().map(|p| p.as_vec3().normalize_or_zero()).collect();
        ball
    };
    let glb_path = folder.path().join("sound.glb");
    write_glb(&glb_path, &ball, "ball").expect("written");
    let glb = fs::read(&glb_path).expect("the model");
    let stl_text =
        b"solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n\
        endsolid x\n";
    let files: Vec<(&str, Vec<u8>)> = vec![
        ("a.obj", CUBE.into()),
        ("b.stl", stl(&ball)),
        ("c.stl", stl_text.to_vec()),
        ("d.ply", ply(&ball, false)),
        ("e.ply", ply(&ball, true)),
        ("f.gltf", gltf(&glb)),
        ("g.glb", glb),
    ];
    let config = Config { cases, failure_persistence: None, ..Config::default() };
    let strategy = (0..files.len(), vec(damage(), 1..4));
    TestRunner::new_with_rng(config, random.clone())
        .run(&strategy, |(file, damages)| {
            let (name, sound) = &files[file];
            let mut bytes = sound.clone();
            for damage in &damages {
                damage.apply(&mut bytes);
            }
            let path = folder.path().join(name);
            fs::write(&path, bytes).expect("written");
            survive(&path);
            Ok(())
        })
        .unwrap_or_else(|failure| panic!("{failure}"));
}

/// Sound files of every format, by their names.
fn sound_files() -> Vec<(&'static str, Vec<u8>)> {
    let folder = tempfile::tempdir().expect("a folder");
    let ball = sphere(3, 0.05);
    let path = folder.path().join("sound.glb");
    write_glb(&path, &ball, "ball").expect("written");
    let glb = fs::read(&path).expect("read");
    let stl_text = "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n\
        endsolid x\nsolid y\nfacet\nouter loop\nvertex 0 0 1\nvertex 1 0 1\nvertex 0 1 1\nend loop\nend facet\nendsolid y\n";
    vec![
        ("a.obj", CUBE.into()),
        ("b.stl", stl(&ball)),
        ("c.stl", stl_text.into()),
        ("d.ply", ply(&ball, false)),
        ("e.ply", ply(&ball, true)),
        ("f.gltf", gltf(&glb)),
        ("g.glb", glb),
    ]
}

/// A file is refused in one line, or gives a model whose every number is one and whose every face has its corners.
fn is_sound_or_refused(folder: &Path, name: &str, bytes: &[u8]) {
    let path = folder.join(name);
    fs::write(&path, bytes).expect("written");
    match load_model(&path) {
        Ok(model) => {
            let count = model.positions.len() as u32;
            assert!(model.positions.iter().all(|position| position.is_finite()), "{name}");
            assert!(model.normals.iter().all(|normal| normal.is_finite()), "{name}");
            assert!(model.triangles.iter().flatten().all(|&corner| corner < count), "{name}");
        }
        Err(error) => {
            let said = error.to_string();
            // What a panic in a reader comes out as: none may.
            assert!(said.lines().count() == 1 && !said.contains("it is damaged"), "{name}: {said}");
        }
    }
}

#[test]
fn a_file_cut_off_anywhere_is_refused_or_read() {
    let folder = tempfile::tempdir().expect("a folder");
    for (name, sound) in sound_files() {
        for length in 0..sound.len() {
            is_sound_or_refused(folder.path(), name, &sound[..length]);
        }
    }
}

#[test]
fn any_bytes_at_all_are_refused_or_read() {
    let folder = tempfile::tempdir().expect("a folder");
    let begins = sound_files();
    let bytes = prop_oneof![
        vec(any::<u8>(), 0..400),
        // Words of all the formats in any order.
        vec(prop::sample::select(WORDS.to_vec()), 0..120).prop_map(|words| words.concat().into_bytes()),
    ];
    let cases = (0..begins.len(), 0.0..1.0_f64, bytes, vec(damage(), 0..3));
    let config = Config { cases: 4000, failure_persistence: None, ..Config::default() };
    TestRunner::new_with_rng(config, TestRng::deterministic_rng(RngAlgorithm::default()))
        .run(&cases, |(file, share, garbage, damages)| {
            let (name, sound) = &begins[file];
            is_sound_or_refused(folder.path(), name, &garbage);
            // Behind a sound beginning, and in place of what was damaged.
            let mut bytes = sound[..(share * sound.len() as f64) as usize].to_vec();
            bytes.extend(&garbage);
            is_sound_or_refused(folder.path(), name, &bytes);
            let mut bytes = sound.clone();
            for damage in &damages {
                damage.apply(&mut bytes);
            }
            is_sound_or_refused(folder.path(), name, &bytes);
            Ok(())
        })
        .unwrap();
}

/// What the formats are written in.
const WORDS: [&str; 40] = [
    "\n",
    "\r",
    " ",
    "\t",
    "v ",
    "f ",
    "vn ",
    "1 ",
    "-1 ",
    "2/3/4 ",
    "1//1 ",
    "nan ",
    "inf ",
    "1e400 ",
    "0.5 ",
    "#",
    "\\\n",
    "solid ",
    "endsolid\n",
    "facet ",
    "normal ",
    "outer loop\n",
    "vertex ",
    "endloop\n",
    "endfacet\n",
    "end ",
    "ply\n",
    "format ascii 1.0\n",
    "element vertex 3\n",
    "element face 1\n",
    "property float x\n",
    "property list uchar int ",
    "vertex_indices\n",
    "end_header\n",
    "{\"asset\":{\"version\":\"2.0\"}}",
    "[",
    "}",
    "\u{feff}",
    "\u{fffd}",
    "mtllib .\n",
];
