//! Putting a scene together tells how far it has come, and ends where it is no longer wanted.

use crate::shapes::{sphere, torus};
use sinew::bake::{BakeError, BakeStage, bake_with_progress};
use sinew::geometry::{Model, TriangleMesh};
use sinew::scene::{Assets, Body, Material, MeshShape, Scene};
use std::collections::BTreeMap;
use std::ops::ControlFlow;

/// Three bodies: one that is filled quickly, one that is thin on one side, and a box.
fn scene() -> (Scene, Assets) {
    let mut assets = Assets::default();
    let mesh = |model: Model| TriangleMesh { positions: model.positions, triangles: model.triangles };
    assets.insert_mesh("ball", &mesh(sphere(12, 0.05))).expect("a solid");
    let mut flat = torus(24, 12, 0.05, 0.02);
    flat.positions.iter_mut().for_each(|p| p.z *= if p.x > 0.0 { 0.6 } else { 1.0 });
    assets.insert_mesh("ring", &mesh(flat)).expect("a solid");
    let material = Material::new(1e5, 0.33, 1000.0);
    let body = |name: &str, x: f64| {
        Body::from_mesh(name, MeshShape::new(name).with_particles(300))
            .with_material(material.clone())
            .with_translation([x, 0.0, 0.0])
    };
    let cube = Body::cuboid("cube", [0.03; 3]).with_material(material.clone()).with_translation([1.0, 0.0, 0.0]);
    (Scene::new("three").with_body(body("ball", 0.0)).with_body(body("ring", 0.5)).with_body(cube), assets)
}

/// Which stage it is, and the share of it that is done.
fn place(stage: BakeStage) -> (u32, f64) {
    let share = |done: usize, of: usize| done as f64 / of as f64;
    match stage {
        BakeStage::Sampling { done, of } => (0, share(done, of)),
        BakeStage::Neighbours => (1, 0.0),
        BakeStage::Embedding => (2, 0.0),
        BakeStage::Skin { done, of } => (3, share(done, of)),
        BakeStage::StableStep => (4, 0.0),
    }
}

#[test]
fn progress_rises_to_its_end() {
    let (scene, assets) = scene();
    let mut heard: BTreeMap<String, Vec<(u32, f64)>> = BTreeMap::new();
    let mut tell = |body: &str, stage| {
        heard.entry(body.to_owned()).or_default().push(place(stage));
        ControlFlow::Continue(())
    };
    bake_with_progress(&scene, &assets, &mut tell).expect("a scene that bakes");
    assert_eq!(heard.len(), 3);
    for (body, stages) in heard {
        assert!(stages.windows(2).all(|pair| pair[0] <= pair[1]), "{body}: {stages:?}");
        assert_eq!(stages[0], (0, 0.0), "{body}");
        for whole in [(0, 1.0), (3, 1.0)] {
            assert!(stages.contains(&whole), "{body}: {stages:?}");
        }
        assert!(body == "cube" || stages.iter().filter(|(stage, _)| *stage == 0).count() > 3, "{body}: {stages:?}");
    }
}

#[test]
fn a_long_stage_asks_again_and_again_whether_it_is_wanted() {
    let scene = Scene::new("long").with_body(
        Body::cuboid("bar", [0.246, 0.246, 0.096])
            .with_material(Material::new(1e5, 0.33, 1000.0).with_support_radius(0.015)),
    );
    let mut asked = [0; 5];
    let mut tell = |_: &str, stage| {
        asked[place(stage).0 as usize] += 1;
        // All but the last are done by then.
        if asked[4] < 3 { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    };
    let ended = bake_with_progress(&scene, &Assets::default(), &mut tell).err();
    assert_eq!(ended, Some(BakeError::Cancelled));
    // Of 26,896 particles: once and again for every eight thousand or so.
    assert!(asked[0] >= 4 && asked[1] >= 9 && asked[2] >= 4, "{asked:?}");
}

#[test]
fn it_ends_at_the_first_sign_that_it_is_not_wanted() {
    let (scene, assets) = scene();
    let mut all = 0;
    let mut count = |_: &str, _: BakeStage| {
        all += 1;
        ControlFlow::Continue(())
    };
    let whole = bake_with_progress(&scene, &assets, &mut count).expect("a scene that bakes");
    assert!(all > 20, "{all}");
    // The long stages ask often: at some of all times.
    for last in (1..=all).step_by((all / 40).max(1)).chain([all]) {
        let mut calls = 0;
        let mut stop = |_: &str, _: BakeStage| {
            calls += 1;
            if calls < last { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
        };
        let error = bake_with_progress(&scene, &assets, &mut stop).err();
        assert_eq!((error, calls), (Some(BakeError::Cancelled), last));
    }
    // Nothing of it stays behind.
    let again = bake_with_progress(&scene, &assets, &mut |_, _| ControlFlow::Continue(())).expect("a scene that bakes");
    let state = |baked: &sinew::bake::Baked| -> Vec<_> {
        baked.world.bodies().iter().map(|body| body.state().positions.clone()).collect()
    };
    assert_eq!(state(&whole), state(&again));
}
