//! The models in assets/: what the code makes, closed, and of the sizes of Table 1.

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
}
