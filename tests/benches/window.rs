//! What the window costs and how fast it answers: `cargo bench --bench window`. What draws needs a graphics driver.

use divan::Bencher;
use egui_kittest::Harness;
use sinew::geometry::Cuboid;
use sinew::geometry::Model;
use sinew::geometry::box_surface;
use sinew::io::write_glb;
use sinew::scene::{MeshShape, Scene};
use sinew::sim::{SimCommand, Worker};
use sinew::test_support::ui::App;
use sinew::ui::Document;
use std::path::Path;
use std::sync::Arc;
use std::time::Duration;

type Window = Harness<'static, App>;

fn main() {
    divan::main();
}

fn built_in() -> Document {
    Document::load(None).expect("the built-in scene")
}

/// The built-in scene with a skin of 50 000 triangles, from a file in `folder`.
fn fine(folder: &Path) -> Document {
    let surface =
        box_surface(&Cuboid { center: glam::DVec3::ZERO, size: glam::DVec3::new(0.042, 0.072, 0.042) }, 0.000_79);
    let model = Model { positions: surface.positions, triangles: surface.triangles, ..Model::default() };
    assert!((45_000..60_000).contains(&model.triangles.len()), "{}", model.triangles.len());
    write_glb(&folder.join("fine.glb"), &model, "fine").expect("a file");
    let mut scene: Scene = built_in().scene;
    scene.bodies[0].shape = MeshShape::new("fine.glb").with_particles(588).into();
    let path = folder.join("fine.json");
    sinew::io::save_scene(&path, &scene).expect("a scene");
    Document::load(Some(path)).expect("it is opened")
}

fn open(document: Document) -> Window {
    let mut window = Harness::builder()
        .with_size(egui::Vec2::new(1280.0, 800.0))
        .with_step_dt(1.0 / 60.0)
        .wgpu()
        .build_eframe(move |creation| App::new(&creation.egui_ctx, creation.wgpu_render_state.clone(), document));
    until(&mut window, |app| !app.published().at_rest.bodies.is_empty());
    window.run_steps(3);
    window
}

#[allow(clippy::disallowed_methods, reason = "here what is waited for is looked at again and again")]
fn until(window: &mut Window, wanted: impl Fn(&App) -> bool) {
    while !wanted(window.state()) {
        std::thread::sleep(Duration::from_micros(200));
        window.step();
    }
}

fn hold(window: &mut Window) {
    window.key_press_modifiers(egui::Modifiers::NONE, egui::Key::Space);
    window.step();
    until(window, |app| !app.published().status.playing);
    window.run_steps(20);
}

/// A frame of the window, 50 000 triangles in the skin, four fibres, the solver held: with nothing changed, and with
/// every view drawn anew because the pointer moves its camera.
#[divan::bench(args = ["still", "camera moves"], sample_count = 200)]
fn ui_and_prepare(bencher: Bencher<'_, '_>, what: &str) {
    let folder = tempfile::tempdir().expect("a folder");
    let mut window = open(fine(folder.path()));
    hold(&mut window);
    let mut side = 1.0;
    bencher.bench_local(|| {
        if what == "camera moves" {
            side = -side;
            let at = egui::pos2(800.0 + side, 400.0);
            let event = egui::Event::MouseWheel {
                unit: egui::MouseWheelUnit::Point,
                delta: egui::vec2(0.0, side),
                phase: egui::TouchPhase::Move,
                source: egui::MouseWheelSource::Unknown,
                modifiers: egui::Modifiers::NONE,
            };
            window.input_mut().events.extend([egui::Event::PointerMoved(at), event]);
        }
        window.step();
    });
}

/// A frame of the window while the built-in scene plays, every one with a new state of the solver.
#[divan::bench(sample_count = 200)]
fn frame_while_playing(bencher: Bencher<'_, '_>) {
    let mut window = open(built_in());
    bencher.bench_local(|| {
        let time = window.state().published().status.time;
        window.step();
        window.state().published().status.time > time
    });
}

/// From the start to the first frame that shows the solid, the driver's own start included.
#[divan::bench(sample_count = 5)]
fn start_to_first_frame() -> Window {
    open(built_in())
}

/// From an edit, as the release of a second stroke makes one, to the state of the solid that has taken it up, while the
/// built-in scene plays.
#[divan::bench(sample_count = 50)]
#[allow(clippy::disallowed_methods, reason = "here what is waited for is looked at again and again")]
fn answer(bencher: Bencher<'_, '_>) {
    let document = built_in();
    let without = {
        let mut scene = document.scene.clone();
        scene.bodies[0].fibres.pop();
        Arc::new(scene)
    };
    let with = Arc::new(document.scene);
    let worker = Worker::start(Arc::clone(&with), document.assets, true, || {});
    let mut edits = 0;
    bencher.bench_local(|| {
        edits += 1;
        let scene = if edits % 2 == 0 { &with } else { &without };
        assert!(worker.send(SimCommand::Edit(Arc::clone(scene))));
        while worker.take().is_none_or(|published| published.status.edits < edits) {
            std::thread::sleep(Duration::from_micros(100));
        }
    });
}
