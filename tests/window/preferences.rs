//! What is chosen once for every scene: whose gestures move the cameras, colours, size, memory.

use super::autosave::Memory;
use super::{Window, button, click, press_key, still, until, view};
use egui::{Event, Key, Modifiers, MouseWheelUnit, PointerButton, Pos2, Vec2};
use egui_kittest::kittest::Queryable;

/// Where the result view shows two particles that lie apart.
fn seen(window: &Window) -> [Pos2; 2] {
    let app = window.state();
    let particles = &app.published().snapshot.bodies[0].particles;
    let [first, last] = [particles[0], particles[particles.len() - 1]];
    [first, last].map(|at| app.shown_at(at).expect("it is seen"))
}

/// What became of the picture between two looks at it.
#[derive(Debug, PartialEq)]
enum Came {
    Nothing,
    Moved,
    Turned,
    /// Nearer, or further.
    Nearer(bool),
}

/// What `gesture` does to the camera of the result view.
fn what_comes(window: &mut Window, gesture: impl FnOnce(&mut Window)) -> Came {
    window.run_steps(30);
    let before = seen(window);
    gesture(window);
    window.run_steps(30);
    let after = seen(window);
    assert!(window.state().grabbed().is_none(), "nothing is pulled");
    let [was, is] = [before, after].map(|[a, b]| b - a);
    let moved = after[0].distance(before[0]).max(after[1].distance(before[1]));
    let [turn, growth] = [(is.angle() - was.angle()).abs(), is.length() / was.length()];
    match () {
        () if moved < 0.5 => Came::Nothing,
        () if (growth - 1.0).abs() < 1e-3 && turn < 1e-3 => Came::Moved,
        () if turn < 1e-3 => Came::Nearer(growth > 1.0),
        () => Came::Turned,
    }
}

/// A drag from a place in the result view where no body is.
fn dragged(of: PointerButton, modifiers: Modifiers) -> impl FnOnce(&mut Window) {
    move |window| {
        let from = view(window, "Result").left_bottom() + Vec2::new(30.0, -30.0);
        let to = from + Vec2::new(60.0, -25.0);
        window.event(Event::ModifiersChanged(modifiers));
        button(window, from, of, true);
        window.step();
        window.event(Event::PointerMoved(from.lerp(to, 0.5)));
        window.step();
        button(window, to, of, false);
        window.event(Event::ModifiersChanged(Modifiers::NONE));
        window.run_steps(2);
    }
}

fn point_at_result(window: &mut Window) {
    let at = view(window, "Result").center();
    window.event(Event::PointerMoved(at));
    window.step();
}

/// Two fingers that move over a touchpad.
fn fingers(modifiers: Modifiers) -> impl FnOnce(&mut Window) {
    move |window| {
        point_at_result(window);
        window.event(Event::ModifiersChanged(modifiers));
        for _ in 0..4 {
            let (phase, source) = (egui::TouchPhase::Move, egui::MouseWheelSource::Unknown);
            let delta = Vec2::new(12.0, 5.0);
            window.event(Event::MouseWheel { unit: MouseWheelUnit::Point, delta, phase, source, modifiers });
            window.step();
        }
        window.event(Event::ModifiersChanged(Modifiers::NONE));
        window.step();
    }
}

fn pinch(window: &mut Window) {
    point_at_result(window);
    window.event(Event::Zoom(1.3));
    window.step();
}

/// Chooses whose gestures move the cameras.
fn choose(window: &mut Window, name: &str) {
    press_key(window, Modifiers::COMMAND, Key::Comma);
    click(window, name);
    click(window, "Close");
    assert!(window.query_by_label("Cameras move as in").is_none(), "it is closed");
}

#[test]
fn cameras_move_by_the_gestures_that_were_chosen() {
    use PointerButton::{Middle, Primary, Secondary};
    let mut window = still();
    let window = &mut window;
    // Along parallel lines, where what is moved stays as it is.
    point_at_result(window);
    press_key(window, Modifiers::NONE, Key::Num5);
    let (alt, shift, none) = (Modifiers::ALT, Modifiers::SHIFT, Modifiers::NONE);
    for (name, middle, shift_middle) in [
        ("Blender", Came::Turned, Came::Moved),
        ("Maya", Came::Nothing, Came::Nothing),
        ("Houdini", Came::Moved, Came::Moved),
        ("Laptop", Came::Turned, Came::Moved),
    ] {
        choose(window, name);
        assert_eq!(what_comes(window, dragged(Middle, none)), middle, "{name}");
        assert_eq!(what_comes(window, dragged(Middle, shift)), shift_middle, "{name}");
        assert_eq!(what_comes(window, dragged(Primary, alt)), Came::Turned, "{name}");
        assert_eq!(what_comes(window, dragged(Primary, alt | shift)), Came::Moved, "{name}");
        assert_eq!(what_comes(window, dragged(Middle, alt)), Came::Moved, "{name}");
        assert_eq!(what_comes(window, dragged(Secondary, alt)), Came::Nearer(true), "{name}");
        let by_fingers = if name == "Laptop" { Came::Turned } else { Came::Nearer(true) };
        assert_eq!(what_comes(window, fingers(none)), by_fingers, "{name}");
        let with_shift = what_comes(window, fingers(shift));
        assert!(name != "Laptop" || with_shift == Came::Moved, "{with_shift:?}");
        assert_eq!(what_comes(window, pinch), Came::Nearer(true), "{name}");
        assert_eq!(what_comes(window, fingers(Modifiers::COMMAND)), Came::Nearer(true), "{name}");
        press_key(window, Modifiers::NONE, Key::Home);
        press_key(window, Modifiers::NONE, Key::Num1);
    }
    // The list of keys tells those that were chosen last.
    press_key(window, Modifiers::NONE, Key::F1);
    assert!(window.query_by_label("Two fingers, Alt + left drag").is_some());
}

#[test]
fn size_colours_and_memory_are_chosen_and_hold_at_once() {
    let mut window = still();
    let size = view(&window, "Result").width();
    press_key(&mut window, Modifiers::COMMAND, Key::Comma);
    let dark = window.ctx.global_style().visuals.dark_mode;
    click(&mut window, "Light");
    assert!(dark && !window.ctx.global_style().visuals.dark_mode);
    for (list, chosen) in [("100 %", "125 %"), ("512 MiB", "256 MiB")] {
        click(&mut window, list);
        click(&mut window, chosen);
    }
    assert!((window.ctx.zoom_factor() - 1.25).abs() < 1e-6);
    until(&mut window, |app| app.published().status.recording.limit == 256 << 20);
    click(&mut window, "Close");
    window.step();
    assert!(view(&window, "Result").width() < 0.9 * size, "all is larger, so that less fits");
    // The next start.
    choose(&mut window, "Maya");
    let mut memory = Memory::default();
    eframe::App::save(window.state_mut(), &mut memory);
    let mut window = still();
    let ctx = window.ctx.clone();
    window.state_mut().recall(&ctx, &memory);
    assert!(!window.ctx.global_style().visuals.dark_mode);
    assert_eq!(what_comes(&mut window, dragged(PointerButton::Middle, Modifiers::NONE)), Came::Nothing);
}
