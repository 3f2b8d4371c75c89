//! From an empty window to a saved scene of one's own: the steps of the page "First scene", gesture by gesture.

use super::editing::drop_file;
use super::{Window, click, click_on, drag, is_settled, open, press_key, scene, stroke, until, view};
use egui::accesskit::Role;
use egui::{Event, Key, Modifiers};
use sinew::io::{load_assets, load_scene};
use sinew::scene::Shape;

/// The most that a hand is to do.
const MOST: usize = 60;

/// A block of 4 by 7 by 4 cm, standing.
const BLOCK: &str = "v -0.02 0 -0.02\nv 0.02 0 -0.02\nv 0.02 0.07 -0.02\nv -0.02 0.07 -0.02\nv -0.02 0 0.02
v 0.02 0 0.02\nv 0.02 0.07 0.02\nv -0.02 0.07 0.02
f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 3 4 8 7\nf 2 3 7 6\nf 1 5 8 4\n";

/// A window, and how often something was done to it: a click, a key, a drag, a word that is typed, a file that is
/// dropped.
struct Hand {
    window: Window,
    gestures: usize,
}

impl Hand {
    fn done(&mut self) {
        self.gestures += 1;
        self.window.run_steps(2);
    }

    fn click(&mut self, label: &str) {
        click(&mut self.window, label);
        self.done();
    }

    fn choose(&mut self, list: &str, entry: &str) {
        click_on(&mut self.window, Role::ComboBox, list);
        self.done();
        self.click(entry);
    }

    fn press(&mut self, modifiers: Modifiers, key: Key) {
        press_key(&mut self.window, modifiers, key);
        self.done();
    }

    fn draw(&mut self, name: &str, curve: impl Fn(f32) -> [f32; 2]) {
        let path = stroke(view(&self.window, name), curve);
        drag(&mut self.window, &path);
        self.done();
    }

    /// What takes no hand: the bodies are put together.
    fn wait(&mut self, bodies: usize) {
        until(&mut self.window, |app| is_settled(app) && app.published().at_rest.bodies.len() == bodies);
        // The views come to rest where they show what is there.
        self.window.run_steps(30);
    }
}

#[test]
fn a_first_scene_takes_few_gestures() {
    let mut hand = Hand { window: open(scene(super::pulling::CUBE)), gestures: 0 };
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("first.json");

    hand.press(Modifiers::COMMAND.plus(Modifiers::SHIFT), Key::N);
    let model = folder.path().join("block.obj");
    std::fs::write(&model, BLOCK).expect("a model");
    drop_file(&mut hand.window, model);
    hand.done();
    hand.wait(1);
    hand.click("Body");
    hand.click("Add a ball");
    hand.wait(2);
    hand.choose("Like", "Jelly");
    hand.click("block");
    hand.wait(2);
    for lean in [0.05, -0.05] {
        hand.draw("Front", |s| [lean * (2.0 * s - 1.0), 0.5 * s - 0.25]);
        hand.draw("Side", |s| [lean * (1.0 - 2.0 * s), 0.5 * s - 0.25]);
        hand.wait(2);
    }
    hand.click("World");
    hand.choose("Pin a region", "top");
    hand.wait(2);
    hand.press(Modifiers::COMMAND, Key::S);
    press_key(&mut hand.window, Modifiers::COMMAND, Key::A);
    hand.done();
    hand.window.event(Event::Text(file.display().to_string()));
    hand.done();
    hand.press(Modifiers::NONE, Key::Enter);

    let said = format!("{:?}", hand.window.state().message());
    assert_eq!(hand.window.state().published().status.failure, None, "{said}");
    let saved = load_scene(&file).unwrap_or_else(|error| panic!("{error}; {said}"));
    load_assets(&saved, folder.path(), &mut |_| {}).expect("the model is found from there");
    let [model, ball] = &saved.bodies[..] else { panic!("two bodies: {said}") };
    assert!(matches!(model.shape, Shape::Mesh(_)) && matches!(ball.shape, Shape::Ball(_)));
    assert_eq!(ball.material.young_modulus, 1e4, "jelly");
    assert_eq!((model.fibres.len(), model.pins.len()), (2, 1), "{said}");
    assert!(hand.gestures < MOST, "{} gestures", hand.gestures);
    assert!(hand.gestures < 25, "and much fewer: {}", hand.gestures);
}
