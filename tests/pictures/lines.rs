//! Lines and points keep their size in pixels.

use super::{SIZE, blank, offscreen};
use glam::Vec3;
use sinew::draw::{Colour, Line, Points, Size};
use sinew::render::{Camera, Facing, Offscreen, Picture};

const BLACK: Colour = Colour::hex(0x00_0000);

/// How many pixels of a column, or of the whole picture, something covers: each counts as far as it is darkened.
fn covered(picture: &Picture, bare: &Picture, column: Option<u32>) -> f64 {
    let mut sum = 0.0;
    for y in 0..SIZE[1] {
        for x in 0..SIZE[0] {
            if column.is_none_or(|column| column == x) {
                let share = |picture: &Picture| f64::from(picture.pixel([x, y]).expect("in the picture")[1]);
                sum += 1.0 - share(picture) / share(bare);
            }
        }
    }
    sum
}

fn line(points: Vec<Vec3>, width: f32) -> Line {
    Line { points, width, colour: BLACK, through: 0.0, pick: 0 }
}

fn at_height(offscreen: &mut Offscreen, camera: Camera, height: f64, lines: Vec<Line>) -> [Picture; 2] {
    let camera = Camera { height, ..camera };
    let mut list = blank();
    list.lines = lines;
    [list, blank()].map(|list| offscreen.draw(list, &camera).expect("a picture"))
}

#[test]
fn a_line_keeps_its_width_at_any_zoom_and_distance() {
    let Some(mut offscreen) = offscreen("line widths") else { return };
    let level = vec![Vec3::new(-1e3, 0.0, 0.0), Vec3::new(1e3, 0.0, 0.0)];
    for camera in [Camera::facing(Facing::Front), Camera { yaw: 0.0, pitch: 0.0, ..Camera::perspective() }] {
        for width in [1.0, 2.5, 6.0] {
            for height in [0.01, 1.0, 100.0] {
                let [picture, bare] = at_height(&mut offscreen, camera, height, vec![line(level.clone(), width)]);
                let found = covered(&picture, &bare, Some(137));
                assert!((found - f64::from(width)).abs() < 0.15, "{found} for {width} at {height}");
            }
        }
    }
}

#[test]
fn a_faint_line_is_not_darker_at_its_joints() {
    let Some(mut offscreen) = offscreen("joints") else { return };
    let zigzag: Vec<Vec3> =
        (0..40).map(|k| Vec3::new(k as f32 * 0.02 - 0.4, f32::from(k % 2 == 0) * 0.02, 0.0)).collect();
    let faint = Line { colour: BLACK.with_alpha(0.3), ..line(zigzag, 8.0) };
    let [picture, bare] = at_height(&mut offscreen, Camera::facing(Facing::Front), 1.0, vec![faint]);
    let darkest = (0..SIZE[1])
        .flat_map(|y| (0..SIZE[0]).map(move |x| [x, y]))
        .map(|at| f64::from(picture.pixel(at).unwrap()[1]) / f64::from(bare.pixel(at).unwrap()[1]))
        .fold(1.0, f64::min);
    assert!((darkest - 0.7).abs() < 0.02, "{darkest}");
}

#[test]
fn a_line_through_the_eye_is_drawn_as_far_as_it_is_seen() {
    let Some(mut offscreen) = offscreen("lines behind the eye") else { return };
    let camera = Camera { yaw: 0.0, pitch: 0.0, ..Camera::perspective() };
    let through = line(vec![Vec3::new(0.0, -0.2, -5.0), Vec3::new(0.0, -0.2, 50.0)], 3.0);
    let [picture, bare] = at_height(&mut offscreen, camera, 1.0, vec![through]);
    // Below the middle it runs out of the picture, above there is nothing of it.
    let column = |rows: std::ops::Range<u32>| {
        rows.filter(|&y| picture.pixel([SIZE[0] / 2, y]) != bare.pixel([SIZE[0] / 2, y])).count()
    };
    assert!(column(200..300) > 95 && column(0..140) == 0, "{} {}", column(200..300), column(0..140));
}

#[test]
fn a_dot_is_round_and_keeps_its_size_and_a_ball_does_not() {
    let Some(mut offscreen) = offscreen("dots") else { return };
    let area = |offscreen: &mut Offscreen, size: Size, height: f64| {
        let camera = Camera { height, ..Camera::facing(Facing::Front) };
        let bare = offscreen.draw(blank(), &camera).unwrap();
        let mut list = blank();
        list.points.push(Points {
            centres: vec![Vec3::ZERO],
            size,
            colour: BLACK,
            tints: Vec::new(),
            through: 0.0,
            pick: 0,
        });
        covered(&offscreen.draw(list, &camera).unwrap(), &bare, None)
    };
    let disc = std::f64::consts::PI * 100.0;
    for height in [0.1, 10.0] {
        let found = area(&mut offscreen, Size::Pixels(10.0), height);
        assert!((found / disc - 1.0).abs() < 0.05, "{found}");
    }
    let [near, far] = [1.0, 2.0].map(|height| area(&mut offscreen, Size::Metres(0.1), height));
    assert!((near / far - 4.0).abs() < 0.4, "{near} {far}");
}

#[test]
fn what_shows_through_does_so_by_its_share() {
    let Some(mut offscreen) = offscreen("through") else { return };
    let camera = Camera::facing(Facing::Front);
    let wall = |list: &mut sinew::draw::DrawList| {
        let vertex = |x: f32, y: f32| sinew::draw::Vertex { position: Vec3::new(x, y, 0.1), normal: Vec3::Z };
        list.meshes.push(sinew::draw::Mesh {
            faces: sinew::draw::Faces::Free(
                vec![vertex(-1.0, -1.0), vertex(1.0, -1.0), vertex(0.0, 1.5)],
                vec![0, 1, 2],
            ),
            colour: Colour::hex(0xff_ffff),
            tints: Vec::new(),
            surface: sinew::draw::SurfaceStyle::Solid,
            casts_shadow: false,
            pick: 0,
        });
    };
    let mut list = blank();
    wall(&mut list);
    let bare = offscreen.draw(list, &camera).unwrap();
    let shown = [0.0, 0.5, 1.0].map(|through| {
        let mut list = blank();
        wall(&mut list);
        list.lines.push(Line { through, ..line(vec![-Vec3::X, Vec3::X], 5.0) });
        covered(&offscreen.draw(list, &camera).unwrap(), &bare, Some(200))
    });
    for (found, expected) in shown.into_iter().zip([0.0, 2.5, 5.0]) {
        assert!((found - expected).abs() < 0.2, "{found} {expected}");
    }
}
