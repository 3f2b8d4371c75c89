//! Pictures and picks, compared within one run. Where there is no graphics driver they say so and pass, unless
//! SINEW_REQUIRE_GPU is set to 1.
#![cfg(feature = "render")]

mod lines;
mod picks;
mod subjects;

use glam::{DVec2, DVec3};
use sinew::bake::bake;
use sinew::draw::{Display, DrawList, Ground, Subject, Theme, draw};
use sinew::io::load_scene;
use sinew::render::{Camera, NoDriver, Offscreen, Picture, RenderError};
use sinew::scene::Scene;
use sinew::sim::Runner;
use sinew::solver::Snapshot;
use std::path::Path;

const SIZE: [u32; 2] = [400, 300];

/// A place to draw in; none, and a word about it, where there is no driver.
#[allow(clippy::print_stderr, reason = "what is skipped is said")]
fn offscreen(test: &str) -> Option<Offscreen> {
    match Offscreen::new(SIZE) {
        Ok(offscreen) => Some(offscreen),
        Err(RenderError::NoDriver(NoDriver { reason })) => {
            let required = std::env::var("SINEW_REQUIRE_GPU").is_ok_and(|value| value == "1");
            assert!(!required, "a graphics driver is required: {reason}");
            eprintln!("skipped {test}: there is no graphics driver ({reason})");
            None
        }
        Err(error) => panic!("{error}"),
    }
}

/// The built-in scene and its start.
fn bar() -> (Scene, Snapshot) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes/short_bar_soft.json");
    let scene = load_scene(&path).expect("the scene is there");
    let baked = bake(&scene, &sinew::scene::Assets::default()).expect("the scene bakes");
    let snapshot = Runner::new(baked).snapshot();
    (scene, snapshot)
}

fn list(scene: &Scene, snapshot: &Snapshot, display: &Display) -> DrawList {
    draw(&Subject { scene, snapshot, ghost: None }, display, &Theme::light())
}

/// Nothing but a background.
fn blank() -> DrawList {
    DrawList::new(DVec3::ZERO, Ground { height: 0.0, solid: false, grid: false, axes: false }, Theme::light())
}

fn framed(mut camera: Camera, list: &DrawList) -> Camera {
    camera.frame(&list.bounds.expect("something to see"), f64::from(SIZE[0]) / f64::from(SIZE[1]));
    camera
}

fn size() -> DVec2 {
    DVec2::from_array(SIZE.map(f64::from))
}

/// The pixel in which a point is seen.
fn pixel_of(camera: &Camera, point: DVec3) -> [u32; 2] {
    let seen = camera.project(point, size()).expect("before the eye").pixel;
    [seen.x as u32, seen.y as u32]
}

/// How much two pixels differ, in steps of the channel that differs most.
fn difference(a: &Picture, b: &Picture, at: [u32; 2]) -> u8 {
    let (a, b) = (a.pixel(at).expect("in the picture"), b.pixel(at).expect("in the picture"));
    a.iter().zip(b).map(|(x, y)| x.abs_diff(y)).max().unwrap_or(0)
}
