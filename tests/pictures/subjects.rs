//! What is in a picture of a scene.

use super::{bar, difference, framed, list, offscreen, pixel_of};
use glam::DVec3;
use sinew::draw::{Display, Theme};
use sinew::render::{Camera, Facing, Offscreen, Options};
use sinew::solver::snapshot::{FieldKind, FieldSnapshot};

/// The middle of the bar at its start [m].
const MIDDLE: DVec3 = DVec3::new(0.0, 0.066, 0.0);

#[test]
fn the_bar_is_where_it_should_be_and_casts_a_shadow() {
    let Some(mut offscreen) = offscreen("the bar") else { return };
    let (scene, snapshot) = bar();
    let with = list(&scene, &snapshot, &Display::default());
    let mut without = with.clone();
    without.meshes.clear();
    let camera = framed(Camera::perspective(), &with);
    let with = offscreen.draw(with, &camera).unwrap();
    let without = offscreen.draw(without, &camera).unwrap();
    assert!(difference(&with, &without, pixel_of(&camera, MIDDLE)) > 20);
    // The light comes from the left, the front and above, so the shadow lies right behind.
    let shadow = pixel_of(&camera, DVec3::new(0.035, 0.0, -0.035));
    let (dark, bright) = (with.pixel(shadow).unwrap()[1], without.pixel(shadow).unwrap()[1]);
    assert!(dark + 15 < bright, "{dark} {bright}");
    let lit = pixel_of(&camera, DVec3::new(-0.08, 0.0, 0.05));
    assert!(difference(&with, &without, lit) < 3);
}

#[test]
fn the_same_picture_twice_is_the_same() {
    let Some(mut offscreen) = offscreen("the same picture twice") else { return };
    let (scene, snapshot) = bar();
    for display in [Display::default(), Display::x_ray(), Display::particles()] {
        let list = list(&scene, &snapshot, &display);
        let camera = framed(Camera::perspective(), &list);
        let first = offscreen.draw(list.clone(), &camera).unwrap();
        assert!(first == offscreen.draw(list, &camera).unwrap(), "{display:?}");
    }
}

#[test]
fn only_see_through_skins_show_the_fibres() {
    let Some(mut offscreen) = offscreen("fibres") else { return };
    let (scene, snapshot) = bar();
    let without = Display { fibres: false, ..Display::x_ray() };
    let camera = framed(Camera::facing(Facing::Front), &list(&scene, &snapshot, &without));
    let fibre = pixel_of(&camera, snapshot.bodies[0].fibres[0].vertices[5]);
    let [seen, bare] =
        [Display::x_ray(), without].map(|display| offscreen.draw(list(&scene, &snapshot, &display), &camera).unwrap());
    assert!(difference(&seen, &bare, fibre) > 40);
    assert_eq!(difference(&seen, &bare, pixel_of(&camera, MIDDLE)), 0);
    let [seen, bare] = [true, false].map(|fibres| {
        let display = Display { fibres, ..Display::default() };
        offscreen.draw(list(&scene, &snapshot, &display), &camera).unwrap()
    });
    assert_eq!(difference(&seen, &bare, fibre), 0);
}

#[test]
fn a_dark_theme_is_dark_and_its_subject_is_not() {
    let Some(mut offscreen) = offscreen("themes") else { return };
    let (scene, snapshot) = bar();
    let mut list = list(&scene, &snapshot, &Display::default());
    list.theme = Theme::dark();
    let camera = framed(Camera::perspective(), &list);
    let picture = offscreen.draw(list, &camera).unwrap();
    let (background, body) = (picture.pixel([2, 2]).unwrap(), picture.pixel(pixel_of(&camera, MIDDLE)).unwrap());
    assert!(background[..3].iter().all(|c| *c < 70) && body[2] > 110, "{background:?} {body:?}");
}

#[test]
fn a_picture_becomes_a_png_and_is_the_same_again() {
    let Some(mut offscreen) = offscreen("PNG") else { return };
    let (scene, snapshot) = bar();
    let list = list(&scene, &snapshot, &Display::default());
    let camera = framed(Camera::perspective(), &list);
    let picture = offscreen.draw(list, &camera).unwrap();
    let bytes = picture.to_png().unwrap();
    let mut reader = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut pixels).unwrap();
    assert_eq!([info.width, info.height], picture.size);
    let rgb: Vec<u8> = picture.rgba.chunks(4).flat_map(|pixel| &pixel[..3]).copied().collect();
    assert!(pixels == rgb);
    assert!(picture.rgba.chunks(4).all(|pixel| pixel[3] == 255), "opaque");
}

#[test]
fn skins_look_alike_whoever_moves_them() {
    let Some(_) = offscreen("skins look alike") else { return };
    let (scene, mut snapshot) = bar();
    // Askew, so that every vertex has moved and every normal has turned.
    for particle in &mut snapshot.bodies[0].particles {
        *particle =
            DVec3::new(particle.x + 0.4 * (particle.y - 0.03), particle.y, particle.z * (1.0 + 3.0 * particle.y));
    }
    let list = list(&scene, &snapshot, &Display { fibres: false, ..Display::x_ray() });
    let camera = framed(Camera::perspective(), &list);
    let mut pictures = [true, false].map(|gpu_skinning| {
        let options = |adapter: &_| Options { gpu_skinning, ..Options::for_adapter(adapter) };
        let mut offscreen = Offscreen::with(super::SIZE, options).expect("a driver");
        if gpu_skinning && !offscreen.renderer().skins_on_gpu() {
            return None;
        }
        assert_eq!(offscreen.renderer().skins_on_gpu(), gpu_skinning);
        Some(offscreen.draw(list.clone(), &camera).expect("a picture"))
    });
    // A driver without storage buffers has one way only.
    let (Some(there), Some(here)) = (pictures[0].take(), pictures[1].take()) else { return };
    let [width, height] = super::SIZE;
    let mut apart = 0;
    for y in 0..height {
        for x in 0..width {
            apart += u32::from(difference(&there, &here, [x, y]) > 6);
        }
    }
    // Rounding moves an outline by less than a pixel here and there.
    assert!(apart < width * height / 1000, "{apart} pixels differ");
}

#[test]
fn a_field_colours_the_skin_by_value_and_nothing_shines_through() {
    let Some(mut offscreen) = offscreen("fields") else { return };
    let (scene, mut snapshot) = bar();
    let plain = list(&scene, &snapshot, &Display::default());
    let camera = framed(Camera::facing(Facing::Front), &plain);
    let plain = offscreen.draw(plain, &camera).unwrap();
    // From nothing at the lower end to one at the upper end, whatever it is.
    let values = snapshot.bodies[0].particles.iter().map(|point| point.y).collect();
    snapshot.field = Some(FieldSnapshot { kind: FieldKind::Strain, range: [0.05, 0.122], bodies: vec![values] });
    let [solid, clear] = [Display::default(), Display::x_ray()]
        .map(|display| offscreen.draw(list(&scene, &snapshot, &display), &camera).unwrap());
    let seen = |height: f64| {
        let pixel = solid.pixel(pixel_of(&camera, DVec3::new(0.002, height, 0.021))).unwrap();
        pixel.map(i32::from)
    };
    let [low, middle, high] = [0.055, 0.086, 0.117].map(seen);
    // Violet, green-blue, pale yellow.
    assert!(low[2] > low[1] + 20 && low[2] > low[0], "{low:?}");
    assert!(middle[1] > middle[0] + 20 && middle[2] > middle[0] + 20, "{middle:?}");
    assert!(high[0] > high[2] + 30 && high[1] > high[2] + 30, "{high:?}");
    let fibre = pixel_of(&camera, snapshot.bodies[0].fibres[0].vertices[5]);
    assert_eq!(difference(&solid, &clear, fibre), 0);
    // Without the field the skin is as it was before.
    snapshot.field = None;
    let again = offscreen.draw(list(&scene, &snapshot, &Display::default()), &camera).unwrap();
    assert!(again == plain);
}
