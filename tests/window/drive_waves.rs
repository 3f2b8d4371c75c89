//! Waves in their lanes: drawn as they run, and dragged by their crest.

use super::drives::{at, fibre, lane, lanes, one_step, undo};
use super::{Window, button, drag, press_key};
use egui::epaint::PathShape;
use egui::{Event, Key, Modifiers, PointerButton, Rect, Shape, Vec2};
use sinew::scene::{Drive, Wave};

const NAME: &str = "Beta, Bar";

/// What was drawn last of lines and polygons that lie in a place.
pub(super) fn paths_in(window: &Window, place: Rect) -> Vec<PathShape> {
    fn gather(shape: &Shape, place: Rect, found: &mut Vec<PathShape>) {
        match shape {
            Shape::Vec(shapes) => shapes.iter().for_each(|shape| gather(shape, place, found)),
            Shape::Path(path) if path.points.iter().all(|at| place.expand(0.5).contains(*at)) => {
                found.push(path.clone());
            }
            _ => {}
        }
    }
    let mut found = Vec::new();
    window.output().shapes.iter().for_each(|clipped| gather(&clipped.shape, place, &mut found));
    found
}

fn wave(window: &Window) -> Wave {
    match fibre("b").drive(window.state().scene()) {
        Some(Drive::Wave(wave)) => wave.clone(),
        other => panic!("{other:?} is no wave"),
    }
}

/// Zero at its start, from which it rises within the first period.
fn value(wave: &Wave, time: f64) -> f64 {
    let s = (time - wave.start) / wave.period;
    let rise = if s < 1.0 { s.max(0.0).powi(2) * (3.0 - 2.0 * s.max(0.0)) } else { 1.0 };
    let angle = wave.phase_degrees.to_radians() - std::f64::consts::TAU * s;
    rise * (wave.mean - wave.amplitude * angle.cos())
}

#[test]
fn the_course_of_a_wave_is_drawn_as_it_runs() {
    let mut window = lanes();
    for wanted in [None, Some(Wave { mean: 0.4, amplitude: 0.3, start: 0.5, ..Wave::new(0.8).with_phase(70.0) })] {
        if let Some(wanted) = wanted {
            let mut scene = window.state().scene().as_ref().clone();
            fibre("b").set(&mut scene, Some(wanted.into())).expect("it is there");
            let text = serde_json::to_string(&scene).expect("JSON");
            window = super::open(super::scene(&text));
            super::hold(&mut window);
            press_key(&mut window, Modifiers::ALT, Key::D);
            super::reset(&mut window);
            window.run_steps(2);
        }
        let (wave, place) = (wave(&window), lane(&window, NAME));
        let course = paths_in(&window, place).into_iter().filter(|path| !path.closed);
        let course = course.max_by_key(|path| path.points.len()).expect("a course");
        assert!(course.points.len() as f32 > 0.9 * place.width(), "{} points", course.points.len());
        let (first, last) = (course.points[0], course.points[course.points.len() - 1]);
        assert!((first.x - place.left()).abs() < 1.0 && (last.x - place.right()).abs() < 1.0);
        let mut highest = 0.0_f64;
        for point in &course.points {
            let time = 5.0 * f64::from((point.x - place.left()) / place.width());
            let drawn = at(&window, NAME, time, value(&wave, time));
            assert!((drawn.y - point.y).abs() < 0.35, "{time} s: drawn at {}, not {}", point.y, drawn.y);
            highest = highest.max(value(&wave, time));
        }
        assert!((highest - wave.mean - wave.amplitude).abs() < 0.01, "{highest}");
    }
}

#[test]
fn the_crest_of_a_wave_is_dragged_for_its_amplitude_and_its_period() {
    let mut window = lanes();
    // Half a second a swing: after the rise its first crest comes at three quarters of one.
    let crest = at(&window, NAME, 0.75, 1.0);
    let aim = at(&window, NAME, 1.5, 0.8);
    one_step(&mut window, "Change wave", |window| drag(window, &[crest, crest.lerp(aim, 0.5), aim]));
    let changed = wave(&window);
    assert!((changed.period - 1.0).abs() < 1e-9, "{changed:?}: a whole number of frames");
    assert!((changed.amplitude - 0.3).abs() < 0.02 && changed.mean == 0.5, "{changed:?}");
    assert_eq!(changed.amplitude, (100.0 * changed.amplitude).round() / 100.0, "it is a round one");
    // And by the crest where it is now: straight up only its height changes, straight along only its period.
    let crest = at(&window, NAME, 1.5, 0.5 + changed.amplitude);
    one_step(&mut window, "Change wave", |window| {
        drag(window, &[crest, crest + Vec2::new(1.0, 5.0), crest + Vec2::new(2.0, 9.0)]);
    });
    assert!(wave(&window).period == changed.period && wave(&window).amplitude < changed.amplitude);
    undo(&mut window);
    one_step(&mut window, "Change wave", |window| drag(window, &[crest, crest - Vec2::new(60.0, 1.0)]));
    let quicker = wave(&window);
    assert!(quicker.amplitude == changed.amplitude && quicker.period < 0.8, "{quicker:?}");
    // Neither upside down nor out of the lane, nor faster than frames show.
    let crest = at(&window, NAME, 1.5 * quicker.period, 0.5 + quicker.amplitude);
    let nowhere = lane(&window, NAME).left_bottom() + Vec2::new(-200.0, 300.0);
    drag(&mut window, &[crest, crest.lerp(nowhere, 0.5), nowhere]);
    let least = wave(&window);
    assert!(least.amplitude == 0.0 && (least.period - 2.0 / 60.0).abs() < 1e-9, "{least:?}");
    undo(&mut window);
    drag(&mut window, &[crest, crest - Vec2::new(0.0, 20.0), crest - Vec2::new(0.0, 400.0)]);
    let most = wave(&window);
    assert!(most.amplitude <= 0.67 && most.amplitude > quicker.amplitude, "{most:?}");
}

#[test]
fn shift_drags_a_crest_off_the_frames_and_escape_puts_it_back() {
    let mut window = lanes();
    let before = window.state().scene().clone();
    let (crest, aim) = (at(&window, NAME, 0.75, 1.0), at(&window, NAME, 1.013, 0.777));
    window.event(Event::PointerMoved(crest));
    window.event(Event::ModifiersChanged(Modifiers::SHIFT));
    button(&window, crest, PointerButton::Primary, true);
    window.event(Event::PointerMoved(crest.lerp(aim, 0.5)));
    window.event(Event::PointerMoved(aim));
    window.run_steps(8);
    let dragged = wave(&window);
    assert!((dragged.period - 1.013 / 1.5).abs() < 1e-3 && (dragged.amplitude - 0.277).abs() < 2e-3, "{dragged:?}");
    let frames = 60.0 * dragged.period;
    assert!((frames - frames.round()).abs() > 0.05, "{frames} frames");
    window.event(Event::ModifiersChanged(Modifiers::NONE));
    press_key(&mut window, Modifiers::NONE, Key::Escape);
    assert_eq!((window.state().scene().clone(), window.state().undo_name()), (before, None));
    button(&window, aim, PointerButton::Primary, false);
    window.run_steps(3);
    assert_eq!(window.state().undo_name(), None);
}
