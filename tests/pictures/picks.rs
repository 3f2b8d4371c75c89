//! What is picked is what is seen.

use super::{SIZE, bar, blank, framed, list, offscreen, pixel_of};
use glam::{DVec3, Vec3};
use sinew::draw::{Colour, Display, DrawList, PickId, PickKind, Points, Size, SkinStyle, Slice};
use sinew::render::{Camera, Facing, Offscreen};
use sinew::scene::Axis;
use sinew::test_support::render::Pick;
use std::task::Poll;

fn pick(offscreen: &Offscreen, camera: &Camera, pixel: [u32; 2], reach: u32) -> Option<Pick> {
    offscreen.renderer().pick(offscreen.content(), offscreen.viewport(), camera, pixel, reach).wait()
}

fn ball(list: &mut DrawList, at: Vec3, radius: f32, index: u32) {
    let pick = list.register(PickId { body: 0, kind: PickKind::Particle, index }, 1);
    let (colour, size) = (Colour::hex(0x80_8080), Size::Metres(radius));
    list.points.push(Points { centres: vec![at], size, colour, tints: Vec::new(), through: 0.0, pick });
}

#[test]
fn the_front_most_ball_is_picked_where_it_is_seen() {
    let Some(mut offscreen) = offscreen("picks") else { return };
    for camera in [Camera::facing(Facing::Front), Camera { yaw: 0.0, pitch: 0.0, ..Camera::perspective() }] {
        let mut list = blank();
        ball(&mut list, Vec3::new(0.0, 0.0, -0.2), 0.2, 1);
        ball(&mut list, Vec3::new(0.1, 0.0, 0.2), 0.1, 2);
        offscreen.draw(list, &camera).unwrap();
        let at = |x: f64, y: f64, z: f64| pick(&offscreen, &camera, pixel_of(&camera, DVec3::new(x, y, z)), 0);
        let front = at(0.1, 0.0, 0.2).unwrap();
        assert_eq!(front.id.index, 2);
        // The point picked lies on the ball, towards the eye.
        assert!(front.point.distance(DVec3::new(0.1, 0.0, 0.3)) < 0.02, "{}", front.point);
        assert_eq!(at(-0.1, 0.0, -0.1).unwrap().id.index, 1);
        assert_eq!(at(0.4, 0.3, 0.0), None);
    }
}

#[test]
fn balls_that_cut_each_other_are_picked_on_their_own_sides() {
    let Some(mut offscreen) = offscreen("cutting balls") else { return };
    let camera = Camera { yaw: 0.5, pitch: 0.3, ..Camera::perspective() };
    let mut list = blank();
    ball(&mut list, Vec3::new(-0.05, 0.0, 0.0), 0.2, 1);
    ball(&mut list, Vec3::new(0.05, 0.0, 0.0), 0.2, 2);
    offscreen.draw(list, &camera).unwrap();
    for (x, index) in [(-0.02, 1), (0.02, 2)] {
        let found = pick(&offscreen, &camera, pixel_of(&camera, DVec3::new(x, 0.0, 0.19)), 0).unwrap();
        assert_eq!(found.id.index, index);
    }
}

#[test]
fn within_reach_the_nearest_is_picked_and_beyond_nothing() {
    let Some(mut offscreen) = offscreen("reach") else { return };
    let camera = Camera::facing(Facing::Front);
    let mut list = blank();
    ball(&mut list, Vec3::ZERO, 0.02, 7);
    offscreen.draw(list, &camera).unwrap();
    let [x, y] = pixel_of(&camera, DVec3::new(0.02, 0.0, 0.0));
    assert_eq!(pick(&offscreen, &camera, [x + 4, y], 0), None);
    assert_eq!(pick(&offscreen, &camera, [x + 4, y], 6).map(|pick| pick.id.index), Some(7));
    assert_eq!(pick(&offscreen, &camera, [x + 12, y], 6), None);
}

#[test]
fn the_skin_hides_what_it_holds_unless_it_is_see_through() {
    let Some(mut offscreen) = offscreen("picks through skins") else { return };
    let (scene, snapshot) = bar();
    let vertex = snapshot.bodies[0].fibres[2].vertices[5];
    let camera = framed(Camera::facing(Facing::Front), &list(&scene, &snapshot, &Display::default()));
    let mut found = |display: &Display, pixel| {
        offscreen.draw(list(&scene, &snapshot, display), &camera).unwrap();
        pick(&offscreen, &camera, pixel, 0)
    };
    let (fibre, beside) = (pixel_of(&camera, vertex), pixel_of(&camera, DVec3::new(0.0, 0.066, 0.0)));
    let skin = found(&Display::default(), fibre).unwrap();
    assert_eq!(skin.id, PickId { body: 0, kind: PickKind::Skin, index: 0 });
    assert!((skin.point.z - 0.021).abs() < 1e-3, "{}", skin.point);
    // The third and fourth fibres stand in front of the second and first.
    let inside = found(&Display::x_ray(), fibre).unwrap();
    assert_eq!(inside.id, PickId { body: 0, kind: PickKind::Fibre, index: 2 });
    assert!(inside.point.distance(vertex) < 2e-3, "{} {vertex}", inside.point);
    assert_eq!(found(&Display::x_ray(), beside).unwrap().id.kind, PickKind::Skin);
    assert_eq!(found(&Display::x_ray(), [1, 1]), None);
}

#[test]
fn an_answer_comes_without_waiting_and_the_last_pixel_has_one_too() {
    let Some(mut offscreen) = offscreen("picks that nobody waits for") else { return };
    let (scene, snapshot) = bar();
    let list = list(&scene, &snapshot, &Display::default());
    let camera = Camera { height: 0.01, ..framed(Camera::facing(Facing::Front), &list) };
    offscreen.draw(list, &camera).unwrap();
    for pixel in [[0, 0], [SIZE[0] - 1, SIZE[1] - 1], [SIZE[0] / 2, 0]] {
        let picking = offscreen.renderer().pick(offscreen.content(), offscreen.viewport(), &camera, pixel, 3);
        let pick = loop {
            if let Poll::Ready(pick) = picking.poll() {
                break pick;
            }
            std::thread::yield_now();
        };
        assert_eq!(pick.expect("the bar is everywhere").id.kind, PickKind::Skin);
    }
}

#[test]
fn what_is_cut_away_is_not_picked_and_the_inside_is() {
    let Some(mut offscreen) = offscreen("picks through a cut") else { return };
    let (scene, snapshot) = bar();
    let camera = framed(Camera::facing(Facing::Front), &list(&scene, &snapshot, &Display::default()));
    let slice = |at, flipped| Some(Slice { axis: Axis::Z, at, flipped });
    // Between the fibres, where nothing but the skin is.
    let pixel = pixel_of(&camera, DVec3::new(0.0, 0.066, 0.0));
    for (style, name) in [(SkinStyle::Shaded, "shaded"), (SkinStyle::XRay, "see-through")] {
        let mut at = |slice| {
            let display = Display { skin: style, fibres: false, slice, ..Display::default() };
            offscreen.draw(list(&scene, &snapshot, &display), &camera).unwrap();
            pick(&offscreen, &camera, pixel, 0).map(|pick| (pick.id.kind, pick.point.z))
        };
        let (kind, whole) = at(None).expect("the front");
        assert!(kind == PickKind::Skin && (whole - 0.021).abs() < 1e-3, "{name}: {whole}");
        let (kind, inner) = at(slice(0.0, false)).expect("the back from within");
        assert!(kind == PickKind::Skin && (inner + 0.021).abs() < 1e-3, "{name}: {inner}");
        let (_, left) = at(slice(0.0, true)).expect("the front is left");
        assert!((left - 0.021).abs() < 1e-3, "{name}: {left}");
        assert_eq!(at(slice(-0.1, false)), None, "{name}: nothing is left");
    }
}
