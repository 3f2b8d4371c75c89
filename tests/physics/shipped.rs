//! The scenes that are shipped show what they say.

use crate::common::*;
use crate::ship::{folder, scene};
use sinew::bake::bake;
use sinew::io::{apply_sets, load_assets, load_scene, unknown_fields};
use sinew::scene::{FibreSource, Scene};

#[test]
fn every_scene_bakes_without_a_warning() {
    let mut seen = 0;
    for entry in std::fs::read_dir(folder()).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|extension| extension != "json") {
            continue;
        }
        let scene = load_scene(&path).unwrap();
        assert_eq!(unknown_fields(&scene), Vec::<String>::new(), "{}", path.display());
        let assets = load_assets(&scene, &folder(), &mut |_| {}).unwrap();
        let baked = bake(&scene, &assets).unwrap();
        let warnings: Vec<String> = baked.notes.iter().filter(|note| note.warning).map(ToString::to_string).collect();
        // Two figures are there to show bodies that blow up.
        let blows_up = ["two_layer_figure_13.json", "two_layer_figure_14.json"].iter().any(|name| path.ends_with(name));
        assert_eq!(!warnings.is_empty(), blows_up, "{}: {warnings:?}", path.display());
        seen += 1;
    }
    assert!(seen >= 5, "{seen} scenes");
}

#[test]
fn the_short_bar_has_table_1s_counts_from_strokes() {
    let scene = scene("short_bar.json");
    assert!(scene.bodies[0].fibres.iter().all(|fibre| matches!(fibre.source, FibreSource::Strokes(_))));
    let baked = baked(&scene);
    let parts = baked.world.bodies()[0].parts();
    let vertices: usize = parts.fibres.iter().map(|fibre| fibre.vertices.len()).sum();
    assert_eq!((parts.state.len(), parts.fibres.len(), vertices), (588, 4, 52));
    // Every structure particle lies on its vertical line, from the lower to the upper face.
    for fibre in &parts.fibres {
        for (k, vertex) in fibre.vertices.iter().enumerate() {
            let x = vertex.gather(&parts.rest) - glam::DVec3::new(0.0, 0.001, 0.0);
            assert!((x.x.abs() - 0.012).abs() < 1e-9 && (x.z.abs() - 0.012).abs() < 1e-9, "{x}");
            assert!((x.y - 0.006 * k as f64).abs() < 1e-9, "{x}");
        }
    }
}

#[test]
fn the_press_scene_gives_the_force_for_the_fraction_that_is_set() {
    let press = scene("press_short_bar.json");
    for (fraction, expected) in [("0.02", 1950.0), ("0.05", 4872.0), ("0.1", 9735.0)] {
        let set = ("/bodies/0/pins/1/motion/ramp/distance/fraction", fraction);
        let scene = apply_sets(&press, [set]).unwrap();
        // At the end of its own duration, not only once at rest.
        let mut runner = runner(&scene);
        for _ in 0..runner.frames_for(scene.time.duration) {
            runner.advance_frame();
        }
        let force = scalar(&runner, 0);
        assert_eq!(runner.world().probes()[0].name, "press");
        assert!((force / expected - 1.0).abs() < 0.01, "{fraction}: {force} N, not {expected} N");
    }
}

#[test]
fn the_soft_bar_twists_by_its_fibres_alone() {
    let twist = |scene: &Scene| {
        let mut runner = runner(scene);
        for _ in 0..30 {
            runner.advance_frame();
        }
        let index = runner.world().probes().iter().position(|probe| probe.name == "twist").unwrap();
        runner.reported_measures()[index].magnitude()
    };
    let with = scene("short_bar_soft.json");
    let without = apply_sets(&with, [("/bodies/0/fibres", "[]")]).unwrap();
    let (with, without) = (twist(&with), twist(&without));
    assert!(with > 15.0 && without < 1e-3, "{with} degrees with, {without} without");
}
