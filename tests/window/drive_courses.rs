//! Courses are bent by the handles of their keys, made of numbers, and worked at quickly.

use super::drives::{
    SCENE, at, choose, chosen, click_at, is_near, keys_of, lane, lanes, one_step, pairs, pull, type_into, undo,
};
use super::{Window, click, drag, hold, open, press_key, reset, scene};
use egui::{Event, Key, Modifiers, PointerButton, Pos2, Vec2};
use egui_kittest::kittest::Queryable;
use sinew::scene::{Drivable, HeightKey, Panel, PanelMotion};

#[test]
fn a_handle_sets_how_steeply_the_course_goes_through_a_key() {
    let mut window = lanes();
    let name = "pull, Bar";
    let key = at(&window, name, 1.0, 1.0);
    let slope = |window: &Window| keys_of(window.state().scene(), &pull()).keys[1].slope;
    let end = key + Vec2::new(26.0, 0.0);
    // Where no key is selected, no handle is: a box is drawn.
    drag(&mut window, &[end, end + Vec2::new(0.0, 20.0)]);
    assert_eq!((slope(&window), window.state().undo_name()), (0.0, None));
    click_at(&mut window, key);
    let down = end + Vec2::new(0.0, 20.0);
    one_step(&mut window, "Turn handle", |window| drag(window, &[end, end.lerp(down, 0.5), down]));
    let lane = lane(&window, name);
    let expected = -(20.0 * 1.32 / f64::from(lane.height() - 4.0)) / (26.0 * 5.0 / f64::from(lane.width()));
    let found = slope(&window);
    assert!((found / expected - 1.0).abs() < 0.06, "{found}, not {expected} a second");
    assert_eq!(pairs(&window, &pull()), [(0.0, 0.0), (1.0, 1.0), (2.0, 0.5)], "the key stays");
    chosen(&window, &[(name, 1)]);
    // Nearly level is level. The lane has room for what the course overshoots now.
    let steep = keys_of(window.state().scene(), &pull());
    let most = steep.range()[1];
    let up = ((1.0 + 0.16 * most) / (1.32 * most)) as f32;
    let key_now = Pos2::new(key.x, lane.bottom() - 2.0 - up * (lane.height() - 4.0));
    let rise = -slope(&window) / (1.32 * most) * f64::from(lane.height() - 4.0);
    let way = Vec2::new(lane.width() / 5.0, rise as f32).normalized() * 26.0;
    drag(&mut window, &[key_now + way, key_now + Vec2::new(30.0, 2.0)]);
    assert_eq!(slope(&window), 0.0);
    // The other end turns it as well.
    let left = key - Vec2::new(26.0, 0.0);
    drag(&mut window, &[left, left + Vec2::new(0.0, 20.0)]);
    assert!((slope(&window) / -expected - 1.0).abs() < 0.06, "{}", slope(&window));
    undo(&mut window);
    one_step(&mut window, "Change drive", |window| type_into(window, "slope 0", "-0.5"));
    assert_eq!(slope(&window), -0.5);
    // A steady course has none.
    choose(&mut window, name, "Smooth", "Linear");
    drag(&mut window, &[end, down]);
    assert_eq!(slope(&window), -0.5);
}

#[test]
fn heights_of_a_panel_become_keys_in_a_lane() {
    let mut document = scene(SCENE);
    let heights = [(0.0, 0.2), (1.0, 0.15)].map(|(time, height)| HeightKey::new(time, height)).to_vec();
    let lid = Panel { motion: PanelMotion::Driven(heights), ..Panel::falling("lid", 0.2, [0.1, 0.1]) };
    document.scene.panels.push(lid);
    let mut window = open(document);
    hold(&mut window);
    press_key(&mut window, Modifiers::ALT, Key::D);
    reset(&mut window);
    window.run_steps(2);
    one_step(&mut window, "Make keys of its course", |window| click(window, "lid as keys"));
    let of = Drivable::Panel("lid".into());
    is_near(&pairs(&window, &of), &[(0.0, 0.0), (1.0, 1.0)], 1e-12);
    assert_eq!(of.at_one(window.state().scene()).map(|(metres, _)| (1e3 * metres).round()), Some(-50.0));
    assert!(window.query_by_label("lid as keys").is_none());
}

#[test]
fn keys_are_clicked_and_dragged_between_two_pictures() {
    let mut window = lanes();
    let name = "pull, Bar";
    let (first, last) = (at(&window, name, 1.0, 1.0), at(&window, name, 2.0, 0.5));
    let press = |at: Pos2, pressed: bool| Event::PointerButton {
        pos: at,
        button: PointerButton::Primary,
        pressed,
        modifiers: Modifiers::NONE,
    };
    for (key, index) in [(first, 1), (last, 2), (first, 1)] {
        window.input_mut().events.extend([Event::PointerMoved(key), press(key, true), press(key, false)]);
        window.step();
        chosen(&window, &[(name, index)]);
        window.run_steps(40);
    }
    let to = at(&window, name, 1.5, 1.0);
    let ways = (0..=8).map(|k| Event::PointerMoved(first.lerp(to, 0.125 * k as f32)));
    window.input_mut().events.extend([press(first, true)].into_iter().chain(ways).chain([press(to, false)]));
    window.run_steps(2);
    is_near(&pairs(&window, &pull()), &[(0.0, 0.0), (1.5, 1.0), (2.0, 0.5)], 1e-12);
}
