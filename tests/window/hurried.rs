//! Hands are quicker than pictures: what was done between two of them is taken up in its order.

use super::{Window, draw, press_key, still, stroke, view};
use egui::{Event, Key, Modifiers, PointerButton, Pos2};
use egui_kittest::kittest::Queryable;

/// Between two pictures [s].
const PICTURE: f64 = 0.5;

fn button(at: Pos2, pressed: bool) -> Event {
    Event::PointerButton { pos: at, button: PointerButton::Primary, pressed, modifiers: Modifiers::NONE }
}

fn key(key: Key) -> Event {
    Event::Key { key, physical_key: None, pressed: true, repeat: false, modifiers: Modifiers::NONE }
}

/// One picture, whose input is all of this.
fn picture(window: &mut Window, events: impl IntoIterator<Item = Event>) {
    window.input_mut().events.extend(events);
    window.step();
}

fn fibres(window: &Window) -> usize {
    window.state().scene().bodies[0].fibres.len()
}

/// A mouse tells of itself 125 times a second, and two pictures are drawn in that time.
#[test]
fn fifty_flicks_at_two_pictures_a_second_are_fifty_strokes() {
    let mut window = still();
    let before = fibres(&window);
    let (every, lasts) = (0.008, 0.15);
    let mut told: Vec<(f64, Event)> = Vec::new();
    for flick in 0..50 {
        let name = ["Front", "Side"][flick % 2];
        let path = stroke(view(&window, name), |s| [0.1 * s - 0.05, 0.5 * s - 0.25]);
        let start = 0.61 * flick as f64;
        told.push((start, Event::PointerMoved(path[0])));
        told.push((start, button(path[0], true)));
        let samples = (lasts / every) as usize;
        for k in 1..=samples {
            let at = path[k * (path.len() - 1) / samples];
            told.push((start + every * k as f64, Event::PointerMoved(at)));
        }
        told.push((start + lasts, button(path[path.len() - 1], false)));
    }
    let pictures = (told[told.len() - 1].0 / PICTURE) as usize + 1;
    let mut inside = 0;
    for k in 0..pictures {
        let within = |time: f64| (time / PICTURE) as usize == k;
        let events: Vec<Event> =
            told.iter().filter(|(time, _)| within(*time)).map(|(_, event)| event.clone()).collect();
        inside += usize::from(events.iter().filter(|event| matches!(event, Event::PointerButton { .. })).count() == 2);
        picture(&mut window, events);
    }
    assert!(inside > 10, "many flicks begin and end between two pictures: {inside}");
    assert_eq!(fibres(&window), before + 25, "{:?}", window.state().message());
}

#[test]
fn a_click_counts_however_short_or_long_the_button_is_held() {
    let mut window = still();
    let time = |window: &Window| window.state().published().status.time;
    for held in [0, 1, 200] {
        let at = window.get_by_label("Step").rect().center();
        let before = time(&window);
        let mut events = vec![Event::PointerMoved(at), button(at, true)];
        if held == 0 {
            events.push(button(at, false));
        }
        picture(&mut window, events);
        window.run_steps(held);
        if held > 0 {
            picture(&mut window, [button(at, false)]);
        }
        super::until(&mut window, |app| app.published().status.time > before);
    }
}

#[test]
fn keys_and_clicks_of_one_picture_mean_what_they_mean_one_by_one() {
    let mut window = still();
    draw(&mut window, "Front", |s| [0.05 * s, 0.5 * s - 0.25]);
    draw(&mut window, "Side", |s| [0.05 * s, 0.5 * s - 0.25]);
    let count = fibres(&window);
    let middle = |window: &Window| window.state().shown_middle("Front").expect("it is seen");
    let before = middle(&window);
    // Move, along X, by 5 mm: an X that came first would delete the fibre.
    let typed = Event::Text("5".to_owned());
    picture(
        &mut window,
        [key(Key::G), key(Key::X), Event::Text("x".to_owned()), key(Key::Num5), typed, key(Key::Enter)],
    );
    assert_eq!(fibres(&window), count);
    let moved = middle(&window) - before;
    assert!(moved.x > 5.0 && moved.y.abs() < 0.5, "{moved:?}");
    press_key(&mut window, Modifiers::COMMAND, Key::Z);
    assert!(middle(&window).distance(before) < 0.5, "it was one step");
}
