//! The whole window as it is painted: needs a graphics driver, and says so where there is none.

use super::{draw, scene, until, view};
use egui::{Pos2, Rect, Vec2};
use egui_kittest::Harness;
use sinew::test_support::render::open_device;
use sinew::test_support::ui::App;
use sinew::ui::Document;

#[allow(clippy::print_stderr, reason = "what is skipped is said")]
fn has_driver(test: &str) -> bool {
    match open_device() {
        Ok(_) => true,
        Err(missing) => {
            let required = std::env::var("SINEW_REQUIRE_GPU").is_ok_and(|value| value == "1");
            assert!(!required, "a graphics driver is required: {missing}");
            eprintln!("skipped {test}: {missing}");
            false
        }
    }
}

fn painted(document: Document) -> super::Window {
    let mut window = Harness::builder()
        .with_size(Vec2::new(1280.0, 800.0))
        .wgpu()
        .build_eframe(move |creation| App::new(&creation.egui_ctx, creation.wgpu_render_state.clone(), document));
    until(&mut window, |app| !app.published().at_rest.bodies.is_empty());
    window.run_steps(3);
    window
}

/// Share of the pixels in a rectangle that differ plainly between two pictures.
fn changed(a: &image::RgbaImage, b: &image::RgbaImage, rect: Rect) -> f64 {
    let inside = |x: u32, y: u32| rect.contains(Pos2::new(x as f32 + 0.5, y as f32 + 0.5));
    let (mut all, mut differ) = (0.0, 0.0);
    for ((x, y, a), b) in a.enumerate_pixels().zip(b.pixels()) {
        if inside(x, y) {
            all += 1.0;
            differ += f64::from(u8::from(a.0.iter().zip(b.0).any(|(a, b)| a.abs_diff(b) > 24)));
        }
    }
    differ / all
}

#[test]
fn a_fibre_that_is_drawn_is_seen_in_every_view_and_the_solid_is_there_before() {
    if !has_driver("a_fibre_that_is_drawn_is_seen_in_every_view_and_the_solid_is_there_before") {
        return;
    }
    let mut window = painted(scene(
        r#"{"version": 1, "gravity": [0, 0, 0], "bodies": [{"id": "cube",
            "shape": {"box": {"size": [0.06, 0.1, 0.06]}},
            "material": {"young_modulus": 1e5, "mass": {"density": 1000}, "support_radius": 0.02}}]}"#,
    ));
    let rects = ["Front", "Side", "Result"].map(|name| view(&window, name));
    let solid = window.render().expect("a picture");
    for rect in rects {
        // The middle of the solid is unlike the corner beside it.
        let pixel = |at: Pos2| solid.get_pixel(at.x as u32, at.y as u32).0;
        let (middle, beside) = (pixel(rect.center()), pixel(rect.left_center() + Vec2::new(12.0, 40.0)));
        assert!(middle.iter().zip(beside).any(|(a, b)| a.abs_diff(b) > 12), "{middle:?} {beside:?}");
    }
    draw(&mut window, "Front", |s| [0.1 * s, 0.5 * s - 0.25]);
    draw(&mut window, "Side", |s| [0.1 * s, 0.5 * s - 0.25]);
    until(&mut window, |app| app.published().at_rest.bodies[0].fibres.len() == 1);
    window.run_steps(3);
    let fibred = window.render().expect("a picture");
    for rect in rects {
        let share = changed(&solid, &fibred, rect);
        assert!(share > 0.001 && share < 0.2, "{share}");
    }
}
