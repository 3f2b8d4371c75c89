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
    let Ok(solid) = Solid::new(&model) else { return };
    assert!(solid.volume > 0.0 && solid.volume.is_finite());
    if let Ok(filling) = fill(&solid, FillResolution::Particles(60), 2.5, 2000) {
        assert!(filling.sample.points.iter().all(|point| point.is_finite()));
    }
}

#[test]
fn a_thousand_damaged_files_do_no_harm() {
    let folder = tempfile::tempdir().unwrap();
    let ball = {
        let mut ball = sphere(4, 0.05);
        ball.normals = ball.positions.iter().map(|p| p.as_vec3().normalize_or_zero()).collect();
        ball
    };
    let glb_path = folder.path().join("sound.glb");
    write_glb(&glb_path, &ball, "ball").unwrap();
    let glb = fs::read(&glb_path).unwrap();
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
    let cases = (0..files.len(), vec(damage(), 1..4));
    let config = Config { cases: 1000, failure_persistence: None, ..Config::default() };
    TestRunner::new_with_rng(config, TestRng::deterministic_rng(RngAlgorithm::default()))
        .run(&cases, |(file, damages)| {
            let (name, sound) = &files[file];
            let mut bytes = sound.clone();
            for damage in &damages {
                damage.apply(&mut bytes);
            }
            let path = folder.path().join(name);
            fs::write(&path, bytes).unwrap();
            survive(&path);
            Ok(())
        })
        .unwrap();
}
