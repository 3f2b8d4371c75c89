//! Shared drives in hand: what is played moves now, is recorded, and comes again to the bit.

use super::drives::{SCENE, keys_of, lanes, pull, undo};
use super::{Window, advance, click, drag, hold, is_settled, open, press_key, reset, scene, until};
use egui::accesskit::Role;
use egui::{Key, Modifiers, Rect, Vec2};
use egui_kittest::kittest::Queryable;
use sinew::scene::{Drive, Interpolation};
use sinew::test_support::ui::App;

fn is_led(app: &App) -> bool {
    app.published().status.drives.iter().any(|drive| drive.is_led)
}

/// Where the slider of the shared drive is, in a window that is high enough.
fn slider(window: &mut Window) -> Rect {
    press_key(window, Modifiers::ALT, Key::D);
    click(window, "World");
    window.set_size(Vec2::new(1280.0, 1600.0));
    window.run_steps(3);
    window.get_by_role_and_label(Role::Slider, "pull, Bar").rect()
}

/// Where everything is, to the bit, and when.
fn bits(window: &Window) -> (u64, Vec<u64>) {
    let published = window.state().published();
    let places = published.snapshot.bodies.iter().flat_map(|body| &body.particles).flat_map(glam::DVec3::to_array);
    (published.status.time.to_bits(), places.map(f64::to_bits).collect())
}

#[test]
fn a_slider_leads_a_shared_drive_and_what_was_played_is_recorded() {
    let mut window = lanes();
    let slider = slider(&mut window);
    assert!(!is_led(window.state()));
    // To the right end of its rail.
    drag(&mut window, &[slider.left_center() + Vec2::new(6.0, 0.0), slider.center(), slider.right_center()]);
    until(&mut window, is_led);
    let before = window.state().scene().clone();
    for _ in 0..5 {
        advance(&mut window);
    }
    let value = window.state().published().status.drives[0].value;
    assert!(value > 0.9, "{value}: much more than {} by itself", 0.02);
    assert_eq!(*window.state().scene(), before, "nothing of the scene has changed");
    click(&mut window, "Record");
    window.run_steps(2);
    assert_eq!(window.state().undo_name(), Some("Record performance"));
    let keys = keys_of(window.state().scene(), &pull());
    assert_eq!(keys.between, Interpolation::Linear);
    assert_eq!(keys.keys.last().map(|key| key.value), Some(value));
    until(&mut window, |app| is_settled(app) && !is_led(app));
    let now = window.state().published().status.drives[0].value;
    assert!((now - value).abs() < 1e-9, "it goes on where it was: {now}");
    undo(&mut window);
    assert_eq!(*window.state().scene(), before);
}

/// Plays on the slider, frame by frame: up, down, half-way; gives what each frame came to.
fn play(window: &mut Window) -> Vec<(u64, Vec<u64>)> {
    let slider = slider(window);
    let place = |share: f32| slider.left_center() + Vec2::new(share * slider.width(), 0.0);
    let mut came = Vec::new();
    let mut from = 0.1;
    for share in [0.9, 0.2, 0.6] {
        drag(window, &[place(from), place(0.5 * (from + share)), place(share)]);
        until(window, is_led);
        for _ in 0..3 {
            advance(window);
            came.push(bits(window));
        }
        from = share;
    }
    came
}

/// Records what was played, and checks that every frame comes again as it was.
fn comes_again(window: &mut Window, played: &[(u64, Vec<u64>)]) {
    click(window, "Record");
    window.run_steps(2);
    assert!(keys_of(window.state().scene(), &pull()).keys.len() > 3);
    until(window, |app| is_settled(app) && !is_led(app));
    reset(window);
    for frame in played {
        advance(window);
        assert_eq!(bits(window).0, frame.0);
        assert!(bits(window).1 == frame.1, "at {} s it is elsewhere", f64::from_bits(frame.0));
    }
}

#[test]
fn what_was_recorded_comes_again_to_the_bit() {
    let mut window = lanes();
    let free: Vec<_> = (0..3)
        .map(|_| {
            advance(&mut window);
            bits(&window)
        })
        .collect();
    reset(&mut window);
    let played = play(&mut window);
    assert_eq!(played[2].0, free[2].0);
    assert!(played[2].1 != free[2].1, "the slider moves it");
    comes_again(&mut window, &played);
}

#[test]
fn a_drive_that_stays_the_same_is_played_from_nothing_to_what_it_is() {
    let keys = r#"{"keyframes": {
            "keys": [{"time": 0, "value": 0}, {"time": 1, "value": 1}, {"time": 2, "value": 0.5}]}}"#;
    assert!(SCENE.contains(keys));
    let mut window = open(scene(&SCENE.replace(keys, r#"{"constant": 0.8}"#)));
    hold(&mut window);
    reset(&mut window);
    let before = window.state().scene().clone();
    let limits = |window: &Window| window.state().published().status.drives[0].limits;
    assert_eq!(limits(&window), [0.0, 0.8]);
    let played = play(&mut window);
    assert_eq!(*window.state().scene(), before, "nothing of the scene has changed");
    let value = window.state().published().status.drives[0].value;
    assert!((0.3..0.6).contains(&value), "{value}");
    comes_again(&mut window, &played);
    undo(&mut window);
    assert_eq!(pull().drive(window.state().scene()), Some(&Drive::Constant(0.8)));
}
