//! Scenes and journals that are taken are put together and moved a little: an answer or a sentence, never a panic.

use crate::files::in_own_folder;
use crate::read::{Verdict, comes_back, refused};
use sinew::bake::{BakeError, bake_with_progress};
use sinew::io::{load_assets, load_scene};
use sinew::scene::{Assets, Scene};
use sinew::sim::{Rerun, Runner};
use sinew::test_support::io::{read_journal, write_journal};
use sinew::test_support::scene::about_particles;
use std::cell::Cell;
use std::ops::ControlFlow;
use std::path::Path;

/// Times that putting a scene together tells how far it has come before it is no longer waited for, and steps of a
/// frame.
const TOLD: u32 = 300;
const STEPS: u32 = 20;

/// More particles than this are not moved: a step would take too long.
const PARTICLES: usize = 500;

/// Scenes of more are not put together: they may hold as many as two million, which takes as long as that takes. What
/// reads them is tried all the same, and `check` tells of them beforehand.
const ABOUT: f64 = 3000.0;

/// A scene of small bodies with everything that changes in time.
pub fn drives(path: &Path) -> Verdict {
    let scene = match load_scene(path) {
        Ok(scene) => scene,
        Err(error) => return refused(&error.to_string()),
    };
    comes_back(&scene);
    match load_assets(&scene, path.parent().expect("a folder"), &mut |_| {}) {
        Ok(assets) => moved(&scene, &assets),
        Err(error) => {
            refused(&error.to_string());
        }
    }
    Verdict::Taken
}

/// The scene after a frame, or as far as it came. True where the frame is whole.
fn try_to_move(scene: &Scene, assets: &Assets) -> bool {
    if about_particles(scene) > ABOUT {
        return false;
    }
    let told = Cell::new(0);
    let mut tell = |_: &str, _| {
        told.set(told.get() + 1);
        if told.get() < TOLD { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    };
    let baked = match bake_with_progress(scene, assets, &mut tell) {
        Ok(baked) => baked,
        Err(BakeError::Cancelled) => return false,
        Err(error) => {
            refused(&error.to_string());
            return false;
        }
    };
    for note in &baked.notes {
        refused(&note.to_string());
    }
    let mut runner = Runner::new(baked);
    if runner.world().bodies().iter().map(|body| body.state().len()).sum::<usize>() > PARTICLES {
        return false;
    }
    let steps = Cell::new(0);
    let is_whole = runner.advance_frame_unless(&|| {
        steps.set(steps.get() + 1);
        steps.get() > STEPS
    });
    let snapshot = runner.snapshot();
    let is_finite = snapshot.bodies.iter().all(|body| body.particles.iter().all(|x| x.is_finite()));
    assert!(is_finite || runner.world().divergence().is_some(), "no numbers, and nothing is said of it");
    is_whole
}

fn moved(scene: &Scene, assets: &Assets) {
    try_to_move(scene, assets);
}

/// A journal: the same when it is written and read again, and made again as far as its scenes are small.
pub fn journal(path: &Path) -> Verdict {
    let mut journal = match read_journal(path) {
        Ok(journal) => journal,
        Err(said) => return refused(&said),
    };
    in_own_folder("copies", |folder| {
        let copy = folder.join("copy.json");
        match write_journal(&copy, &journal) {
            Ok(()) => assert_eq!(read_journal(&copy).as_ref(), Ok(&journal), "written and read again"),
            Err(error) => panic!("read, and then not written: {error}"),
        }
    });
    let mut assets = Assets::default();
    for scene in journal.scenes() {
        match load_assets(scene, path.parent().expect("a folder"), &mut |_| {}) {
            Ok(found) => assets = found,
            Err(error) => return refused(&error.to_string()),
        }
        if !try_to_move(scene, &assets) {
            return Verdict::Taken;
        }
    }
    journal.hashes.truncate(3);
    let mut rerun = match Rerun::new(journal, assets) {
        Ok(rerun) => rerun,
        Err(said) => return refused(&said),
    };
    loop {
        match rerun.advance() {
            Ok(true) => {}
            Ok(false) => return Verdict::Taken,
            Err(said) => return refused(&said),
        }
    }
}
