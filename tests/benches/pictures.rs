//! What pictures cost: `cargo bench --bench pictures`.

use divan::Bencher;
use glam::DVec3;
use sinew::bake::bake;
use sinew::draw::{Display, DrawList, Subject, Theme, draw};
use sinew::geometry::Cuboid;
use sinew::geometry::Kernel;
use sinew::geometry::box_surface;
use sinew::io::load_scene;
use sinew::render::{Camera, Content, Offscreen, Options};
use sinew::scene::Scene;
use sinew::sim::Runner;
use sinew::solver::Snapshot;
use sinew::test_support::solver::{Skin, SkinShape};
use std::path::Path;

const SIZE: [u32; 2] = [1280, 800];

fn main() {
    divan::main();
}

fn bar() -> (Scene, Snapshot) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes/short_bar_soft.json");
    let scene = load_scene(&path).expect("the scene is there");
    let baked = bake(&scene, &sinew::scene::Assets::default()).expect("the scene bakes");
    let snapshot = Runner::new(baked).snapshot();
    (scene, snapshot)
}

/// The bar with a skin of 50,000 triangles.
fn fine_bar() -> (Scene, Snapshot) {
    let (scene, mut snapshot) = bar();
    let shape = Cuboid { center: DVec3::new(0.0, 0.066, 0.0), size: DVec3::new(0.042, 0.072, 0.042) };
    let surface = box_surface(&shape, 0.000_79);
    let point_of: Vec<u32> = (0..surface.positions.len() as u32).collect();
    let shape = SkinShape {
        points: &surface.positions,
        point_of: &point_of,
        normals: &[],
        colours: &[],
        triangles: &surface.triangles,
    };
    let kernel = Kernel::new(scene.bodies[0].material.support_radius);
    let body = &mut snapshot.bodies[0];
    let skin = Skin::embed(&shape, &body.particles, kernel, &mut |_, _| {}).expect("a skin");
    body.embedding = std::sync::Arc::new(skin).into();
    (scene, snapshot)
}

fn list((scene, snapshot): &(Scene, Snapshot), display: &Display) -> DrawList {
    draw(&Subject { scene, snapshot, ghost: None }, display, &Theme::light())
}

fn camera(list: &DrawList) -> Camera {
    let mut camera = Camera::perspective();
    camera.frame(&list.bounds.expect("something to see"), 1.6);
    camera
}

/// From a snapshot to a draw list.
#[divan::bench(args = ["bar, shaded", "bar, x-ray", "bar, particles", "50k triangles, x-ray"])]
fn draw_list(bencher: Bencher<'_, '_>, what: &str) {
    let subject = if what.starts_with("bar") { bar() } else { fine_bar() };
    let display = match what.rsplit(", ").next() {
        Some("x-ray") => Display::x_ray(),
        Some("particles") => Display::particles(),
        _ => Display::default(),
    };
    bencher.bench_local(|| list(&subject, &display));
}

/// From a draw list to a picture in memory, best and as in a window on a software driver.
#[divan::bench(args = ["best, bar", "best, bar, x-ray", "quick, bar", "quick, bar, x-ray", "quick, 50k triangles"])]
fn picture(bencher: Bencher<'_, '_>, what: &str) {
    let options = if what.starts_with("best") { Options::best_for_adapter } else { Options::for_adapter };
    let Ok(mut offscreen) = Offscreen::with(SIZE, options) else { return };
    let subject = if what.contains("bar") { bar() } else { fine_bar() };
    let list = list(&subject, &if what.contains("x-ray") { Display::x_ray() } else { Display::default() });
    let camera = camera(&list);
    bencher.with_inputs(|| list.clone()).bench_local_values(|list| offscreen.draw(list, &camera));
}

/// Sending a list and drawing its shadow.
#[divan::bench(args = ["bar", "50k triangles"])]
fn send(bencher: Bencher<'_, '_>, what: &str) {
    let Ok(offscreen) = Offscreen::with([64, 64], Options::for_adapter) else { return };
    let subject = if what == "bar" { bar() } else { fine_bar() };
    let list = list(&subject, &Display::default());
    let mut content = Content::new(offscreen.renderer());
    bencher.with_inputs(|| list.clone()).bench_local_values(|list| content.send(offscreen.renderer(), list));
}

/// A picture as a PNG file.
#[divan::bench]
fn png(bencher: Bencher<'_, '_>) {
    let Ok(mut offscreen) = Offscreen::new(SIZE) else { return };
    let list = list(&bar(), &Display::default());
    let camera = camera(&list);
    let picture = offscreen.draw(list, &camera).expect("a picture");
    bencher.bench_local(|| picture.to_png());
}
