//! The models in assets/: what the code makes, closed, and of the sizes of Table 1.

use crate::greeting::Greeting;
use serde_json::Value;
use sinew::cli::{Cli, Console, run};
use sinew::geometry::Solid;
use sinew::geometry::{FillResolution, fill};
use sinew::io::load_model;
use std::fs;
use std::io::sink;
use std::path::{Path, PathBuf};

/// Vertices and particles of Table 1.
const TABLE_1: [(&str, f64, f64); 4] = [
    ("short_bar", 24_600.0, 588.0),
    ("long_bar", 5_800.0, 375.0),
    ("plant", 31_400.0, 2723.0),
    ("leaf", 3_900.0, 1159.0),
];

fn assets() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("assets")
}

#[test]
fn sizes_are_those_of_table_1() {
    for (name, vertices, particles) in TABLE_1 {
        let model = load_model(&assets().join(format!("{name}.glb"))).unwrap();
        let solid = Solid::new(&model).unwrap();
        assert!(solid.report.closed && solid.report.findings().is_empty(), "{name}: {:?}", solid.report);
        assert_eq!(solid.report.pieces, 1);
        assert_eq!(model.normals.len(), model.positions.len());
        assert!((model.positions.len() as f64 / vertices - 1.0).abs() < 0.02, "{name}: {}", model.positions.len());

        let filling = fill(&solid, FillResolution::Spacing(0.4 * 0.015), 2.5, 100_000).unwrap();
        let count = filling.sample.points.len() as f64;
        let exact = name.ends_with("bar");
        assert!((count / particles - 1.0).abs() <= if exact { 0.0 } else { 0.02 }, "{name}: {count}");
        assert!(filling.volume_error.abs() < 0.02, "{name}: {}", filling.volume_error);
        assert!(filling.sample.points.iter().all(|&point| solid.contains(point)));
        assert_eq!(filling.sample.pieces().1, 1, "{name}");
        let asked = fill(&solid, FillResolution::Particles(particles as u32), 2.5, 100_000).unwrap();
        let count = asked.sample.points.len() as f64;
        assert!((count / particles - 1.0).abs() <= if exact { 0.0 } else { 0.02 }, "{name}: {count}");
    }
}

#[test]
fn the_code_makes_them_anew() {
    let folder = tempfile::tempdir().unwrap();
    let cli: Cli = clap::Parser::parse_from(["sinew".as_ref(), "make-models".as_ref(), folder.path().as_os_str()]);
    let mut console = Console::new(Box::new(sink()), Box::new(sink()), false);
    run(&cli.command.expect("a command"), &mut console);
    let mut total = 0;
    for name in TABLE_1.map(|(name, ..)| name).into_iter().chain(["tube", "thick_plant", "thick_leaf", "character"]) {
        let file = format!("{name}.glb");
        let made = load_model(&folder.path().join(&file)).unwrap();
        let kept = load_model(&assets().join(&file)).unwrap();
        assert_eq!(made.positions.len(), kept.positions.len(), "{name}");
        assert_eq!(made.triangles.len(), kept.triangles.len(), "{name}");
        let [made, kept] = [made, kept].map(|model| Solid::new(&model).unwrap().volume);
        assert!((made / kept - 1.0).abs() < 1e-4, "{name}");
        total += fs::metadata(assets().join(&file)).unwrap().len();
    }
    assert!(total < 4 << 20, "{total} bytes");
    the_same_skeleton(&folder.path().join("character.glb"), &assets().join("character.glb"));
}

/// Checks that two files have the same joints, the same skin on them, and the same clip.
fn the_same_skeleton(made: &Path, kept: &Path) {
    let [made, kept] = [made, kept].map(Greeting::read);
    // Places and turns of nodes are numbers, all else are names and indices.
    let near = |a: &Value, b: &Value| match (a.as_f64(), b.as_f64()) {
        (Some(a), Some(b)) => (a - b).abs() < 1e-6,
        _ => a == b,
    };
    let [nodes, others] = [&made, &kept].map(|of| of.json["nodes"].as_array().expect("nodes"));
    assert!(nodes.len() == others.len() && nodes.len() > 7);
    for (node, other) in nodes.iter().zip(others) {
        assert_eq!((&node["name"], &node["children"]), (&other["name"], &other["children"]));
        for part in ["translation", "rotation", "scale"] {
            let [a, b] = [node, other].map(|node| node[part].as_array().cloned().unwrap_or_default());
            assert!(a.len() == b.len() && a.iter().zip(&b).all(|(a, b)| near(a, b)), "{node} {other}");
        }
    }
    let of = |of: &Greeting, path: &str| of.json.pointer(path).cloned().unwrap_or_else(|| panic!("no {path}"));
    for path in ["/skins/0/joints", "/animations/0/name", "/animations/0/channels"] {
        assert_eq!(of(&made, path), of(&kept, path));
    }
    let alike = |path: &str| {
        let [a, b] = [&made, &kept].map(|file| file.floats(&of(file, path)));
        let far = a.iter().zip(&b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(!a.is_empty() && a.len() == b.len() && far < 1e-6, "{path}: {far}");
    };
    alike("/skins/0/inverseBindMatrices");
    for k in 0..of(&made, "/animations/0/samplers").as_array().expect("samplers").len() {
        for end in ["input", "output"] {
            alike(&format!("/animations/0/samplers/{k}/{end}"));
        }
        let between = |file| of(file, &format!("/animations/0/samplers/{k}/interpolation"));
        assert_eq!(between(&made), between(&kept));
    }
    assert!(made.held.len() == kept.held.len() && !made.held.is_empty());
    for (made, kept) in made.held.iter().zip(&kept.held) {
        for ((joint, share), (other, others)) in made.iter().zip(kept) {
            // By so small a share it is no matter which joint holds it.
            assert!(
                (share - others).abs() < 1e-4 && (joint == other || share.max(*others) < 1e-4),
                "{made:?} {kept:?}"
            );
        }
    }
}
