//! Scenes with meshes: loaded from beside the scene, filled, run; errors that name the place, the file and the remedy.

use crate::formats::CUBE;
use sinew::bake::{BakeError, bake};
use sinew::io::{load_assets, load_scene, scene_from_json};
use sinew::scene::{Assets, Scene};
use sinew::sim::Runner;
use std::fs;
use std::path::Path;

fn scene(shape: &str, radius: f64) -> Scene {
    let text = format!(
        r#"{{"version": 1, "gravity": [0, 0, 0], "bodies": [{{"id": "a", "shape": {{"mesh": {shape}}},
        "material": {{"young_modulus": 1e5, "mass": {{"density": 1000}}, "support_radius": {radius}}}}}]}}"#
    );
    scene_from_json(&text).unwrap_or_else(|error| panic!("{error}"))
}

fn assets(scene: &Scene, folder: &Path) -> Result<Assets, String> {
    load_assets(scene, folder, &mut |_| {}).map_err(|error| error.to_string())
}

#[test]
fn every_shipped_scene_with_a_mesh_runs() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes");
    for (name, particles) in [("short_bar_mesh", 588), ("long_bar", 375), ("plant", 2723), ("leaf", 1159)] {
        let mut scene = load_scene(&folder.join(format!("{name}.json"))).unwrap_or_else(|error| panic!("{error}"));
        // A frame of a few steps only.
        scene.time.frames_per_second = 40_000.0;
        let baked = bake(&scene, &assets(&scene, &folder).unwrap()).unwrap();
        assert!(baked.notes.iter().all(|note| !note.warning), "{name}: {:?}", baked.notes);
        let mut runner = Runner::new(baked);
        runner.advance_frame();
        assert!(runner.world().divergence().is_none());
        let snapshot = runner.snapshot();
        let body = &snapshot.bodies[0];
        let share = body.particles.len() as f64 / f64::from(particles);
        assert!((share - 1.0).abs() < 0.02, "{name}: {}", body.particles.len());
        assert_eq!(body.skin.len(), body.normals.len());
        assert_eq!(body.skin.len(), body.colours.len());
        assert!(!body.triangles.is_empty());
    }
}

#[test]
fn wanted_particles_decide_the_spacing_and_the_mass_is_the_meshs() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("cube.obj"), CUBE).unwrap();
    let scene = scene(r#"{"path": "cube.obj", "scale": 0.05, "particles": 512}"#, 1.0);
    let baked = bake(&scene, &assets(&scene, folder.path()).unwrap()).unwrap();
    let body = &baked.world.bodies()[0];
    assert_eq!(body.state().len(), 512);
    assert!((body.state().mass() - 1.0).abs() < 1e-9);
    assert!(baked.notes.iter().any(|note| note.text == "512 particles at a support radius of 0.031250 m"));
}

#[test]
fn missing_and_unusable_models_are_named() {
    let folder = tempfile::tempdir().unwrap();
    let error = assets(&scene(r#"{"path": "none.obj"}"#, 0.01), folder.path()).unwrap_err();
    assert!(error.starts_with("/bodies/0/shape/mesh/path: ") && error.contains("none.obj"), "{error}");
    assert!(error.ends_with("there is no such file; check the path"), "{error}");

    fs::write(folder.path().join("sheet.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").unwrap();
    let error = assets(&scene(r#"{"path": "sheet.obj"}"#, 0.01), folder.path()).unwrap_err();
    assert!(error.contains("sheet.obj: the surface encloses nothing"), "{error}");

    let error = bake(&scene(r#"{"path": "none.obj"}"#, 0.01), &Assets::default()).err();
    assert!(matches!(error, Some(BakeError::NotLoaded { .. })));
}

#[test]
fn too_many_particles_and_too_thin_shapes_name_what_to_give() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("cube.obj"), CUBE).unwrap();
    let baked = |shape: &str, radius: f64| {
        let scene = scene(shape, radius);
        bake(&scene, &assets(&scene, folder.path()).unwrap()).err().map(|error| error.to_string())
    };
    let error = baked(r#"{"path": "cube.obj"}"#, 0.01).unwrap();
    assert!(error.starts_with("/bodies/0/material/support_radius: about 1.2e8 lattice points"), "{error}");
    assert!(error.contains("give 4.01e-2 m or more"), "{error}");

    let slab = CUBE.replace(" 2\n", " 0.05\n");
    fs::write(folder.path().join("slab.obj"), slab).unwrap();
    let error = baked(r#"{"path": "slab.obj"}"#, 0.1).unwrap();
    assert!(error.contains("too thin for its particles") && error.contains("gives two layers"), "{error}");
}
