//! What is in a picture of a scene.

use super::{bar, difference, framed, list, offscreen, pixel_of};
use glam::DVec3;
use sinew::draw::{Display, Slice, Theme};
use sinew::render::{Camera, Facing, Offscreen, Options};
use sinew::scene::Axis;
use sinew::solver::{BreakPlace, FibreBreak, FieldKind, FieldSnapshot, TensionSnapshot};

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

#[test]
fn a_cut_takes_one_side_away_and_shows_the_inside() {
    let Some(mut offscreen) = offscreen("cuts") else { return };
    let (scene, mut snapshot) = bar();
    let slice = |axis, at, flipped| Some(Slice { axis, at, flipped });
    let camera = framed(Camera::facing(Facing::Front), &list(&scene, &snapshot, &Display::default()));
    let mut shown =
        |snapshot: &_, display: &Display| offscreen.draw(list(&scene, snapshot, display), &camera).expect("a picture");
    let whole = shown(&snapshot, &Display::default());
    let bare = shown(&snapshot, &Display { skin: sinew::draw::SkinStyle::Hidden, fibres: false, ..Display::default() });
    // Across what is seen: one half is as it was, the other is gone.
    let half = shown(&snapshot, &Display { fibres: false, slice: slice(Axis::X, 0.0, false), ..Display::default() });
    let [left, right] = [-0.01, 0.01].map(|x| pixel_of(&camera, DVec3::new(x, 0.066, 0.0)));
    assert_eq!((difference(&half, &whole, left), difference(&half, &bare, right)), (0, 0));
    assert!(difference(&half, &whole, right) > 20);
    let other = shown(&snapshot, &Display { fibres: false, slice: slice(Axis::X, 0.0, true), ..Display::default() });
    assert_eq!((difference(&other, &bare, left), difference(&other, &whole, right)), (0, 0));
    // Along the line of sight: the inside is darker than the skin, and fibres stand in it.
    let open = |fibres| Display { fibres, slice: slice(Axis::Z, 0.0, false), ..Display::default() };
    let (inside, with) = (shown(&snapshot, &open(false)), shown(&snapshot, &open(true)));
    let middle = pixel_of(&camera, MIDDLE);
    let [dark, bright] = [&inside, &whole].map(|picture| picture.pixel(middle).unwrap()[1]);
    assert!(dark + 40 < bright, "{dark} {bright}");
    let fibre = pixel_of(&camera, snapshot.bodies[0].fibres[0].vertices[5]);
    assert!(difference(&with, &inside, fibre) > 40);
    // With a field, what lies at the cut has its colours: violet below, pale yellow above.
    let values = snapshot.bodies[0].particles.iter().map(|point| point.y).collect();
    snapshot.field = Some(FieldSnapshot { kind: FieldKind::Strain, range: [0.05, 0.122], bodies: vec![values] });
    let cut = shown(&snapshot, &Display { slice: slice(Axis::Z, 1e-3, false), ..open(false) });
    let particle = |wanted: f64| {
        let far = |point: &&DVec3| point.distance(DVec3::Y * wanted);
        let particles = snapshot.bodies[0].particles.iter().filter(|point| point.z < 1e-3);
        *particles.min_by(|a, b| far(a).total_cmp(&far(b))).expect("a particle")
    };
    let [low, high] = [0.055, 0.117].map(|y| cut.pixel(pixel_of(&camera, particle(y))).unwrap().map(i32::from));
    assert!(low[2] > low[1] + 20, "{low:?}");
    assert!(high[0] > high[2] + 30 && high[1] > high[2] + 30, "{high:?}");
}

#[test]
fn fibres_show_what_they_carry_and_where_they_are_broken() {
    let Some(mut offscreen) = offscreen("tension and breaks") else { return };
    let (scene, mut snapshot) = bar();
    let camera = framed(Camera::facing(Facing::Front), &list(&scene, &snapshot, &Display::x_ray()));
    let fibres = &snapshot.bodies[0].fibres;
    // The fibre in front, so that nothing stands before it.
    let depth = |fibre: usize| fibres[fibre].vertices[5].z;
    let front = (0..fibres.len()).max_by(|a, b| depth(*a).total_cmp(&depth(*b))).expect("a fibre");
    let [middle, further] = [5, 8].map(|k| pixel_of(&camera, fibres[front].vertices[k]));
    let forces = |force: f64| fibres.iter().map(|fibre| vec![force; fibre.vertices.len() - 1]).collect();
    let tensions = [2.0, -2.0, 0.0].map(|force| Some(TensionSnapshot { range: 2.0, bodies: vec![forces(force)] }));
    let [warm, cool, slack] = tensions.map(|tension| {
        snapshot.tension = tension;
        let picture = offscreen.draw(list(&scene, &snapshot, &Display::x_ray()), &camera).expect("a picture");
        picture.pixel(middle).unwrap().map(i32::from)
    });
    assert!(warm[0] > warm[2] + 40, "{warm:?}");
    assert!(cool[2] > cool[0] + 40, "{cool:?}");
    assert!((slack[0] - slack[2]).abs() < 45 && slack[1] > warm[1] && slack[1] > cool[1], "{slack:?}");
    snapshot.tension = None;
    let whole = offscreen.draw(list(&scene, &snapshot, &Display::x_ray()), &camera).expect("a picture");
    snapshot.bodies[0].breaks.push(FibreBreak { fibre: front as u32, place: BreakPlace::Vertex(5), time: 0.1 });
    for theme in [Theme::light(), Theme::dark()] {
        let mut list = list(&scene, &snapshot, &Display::x_ray());
        list.theme = Theme { broken: theme.broken, ..list.theme };
        let broken = offscreen.draw(list, &camera).expect("a picture");
        let red = broken.pixel(middle).unwrap().map(i32::from);
        assert!(red[0] > red[1] + 60 && red[0] > red[2] + 60, "{red:?}");
        assert_eq!(difference(&whole, &broken, further), 0);
    }
}
