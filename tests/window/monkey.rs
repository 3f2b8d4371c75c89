//! A monkey at the window: actions of the table, keys, drags, clicks, wheels, storms of undo, examples, in the order
//! of a seed. Whatever it does the window lives on, and the document undone to its start and redone is the same.
//!
//! For any time: `SINEW_MONKEY="SECONDS [SEED]" cargo test --release --test window -- --ignored --nocapture monkey`.

use super::{Window, open_with, view};
use egui::{Event, Key, Modifiers, MouseWheelUnit, PointerButton, Pos2, Vec2};
use egui_kittest::kittest::Queryable;
use sinew::io::{save_scene, scene_from_json, scene_to_json};
use sinew::test_support::ui::{Action, EXAMPLES};
use sinew::ui::Document;
use std::env;
use std::path::Path;
use std::time::{Duration, Instant};

/// Steele, Lea and Flood's `SplitMix64`: the same monkey on every machine.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn below(&mut self, end: usize) -> usize {
        (self.next() % end as u64) as usize
    }

    fn share(&mut self) -> f32 {
        self.below(10_000) as f32 * 1e-4
    }

    fn one_of<T: Copy>(&mut self, of: &[T]) -> T {
        of[self.below(of.len())]
    }
}

/// Keys that act by themselves; what opens, accepts or leaves is asked for as an action.
const KEYS: [Key; 22] = [
    Key::G,
    Key::R,
    Key::S,
    Key::X,
    Key::Y,
    Key::Z,
    Key::D,
    Key::I,
    Key::K,
    Key::P,
    Key::Num1,
    Key::Num3,
    Key::Num5,
    Key::Num7,
    Key::Tab,
    Key::Escape,
    Key::Space,
    Key::Delete,
    Key::ArrowLeft,
    Key::ArrowRight,
    Key::Period,
    Key::Minus,
];

/// Undone and redone in a storm.
const STORM: usize = 20;

struct Monkey {
    window: Window,
    random: Random,
    /// The document as it was opened.
    first: String,
    /// What was done since, to be told.
    done: Vec<String>,
    /// Whether examples are opened too.
    opens: bool,
    /// The longest that a frame took.
    longest: Duration,
}

impl Monkey {
    fn new(seed: u64, folder: &Path, opens: bool) -> Self {
        let file = folder.join("scene.json");
        let mut scene = scene_from_json(include_str!("../../scenes/short_bar_soft.json")).expect("a scene");
        scene.bodies[0].material.support_radius *= 1.6;
        save_scene(&file, &scene).expect("saved");
        let document = Document::load(Some(file)).expect("opened");
        let folder = folder.to_owned();
        let window = open_with(document, move |app| {
            app.with_recovery(folder.join("kept")).with_pattern_folder(folder.join("patterns"))
        });
        let first = scene_to_json(window.state().scene());
        Self { window, random: Random(seed), first, done: Vec::new(), opens, longest: Duration::ZERO }
    }

    fn text(&self) -> String {
        scene_to_json(self.window.state().scene())
    }

    fn step(&mut self) {
        let begun = Instant::now();
        self.window.step();
        self.longest = self.longest.max(begun.elapsed());
    }

    fn perform(&mut self, action: Action) {
        let ctx = self.window.ctx.clone();
        self.window.state_mut().dispatch(&ctx, action);
        self.step();
    }

    fn key(&mut self, key: Key) {
        self.window.key_press_modifiers(Modifiers::NONE, key);
        self.step();
    }

    fn escape(&mut self) {
        self.key(Key::Escape);
        self.key(Key::Escape);
    }

    fn place(&mut self) -> Pos2 {
        let inside = match self.random.below(5) {
            0 => return Pos2::new(1280.0 * self.random.share(), 30.0 + 760.0 * self.random.share()),
            1 => "Front",
            2 => "Side",
            3 => "Top",
            _ => "Result",
        };
        let of = self.window.query_by_label(&format!("{inside} view")).map(|node| node.rect());
        let rect = of.unwrap_or_else(|| view(&self.window, "Front"));
        rect.min + rect.size() * Vec2::new(self.random.share(), self.random.share())
    }

    fn button(&mut self, pos: Pos2, button: PointerButton, pressed: bool, modifiers: Modifiers) {
        self.window.event(Event::PointerMoved(pos));
        self.window.event(Event::PointerButton { pos, button, pressed, modifiers });
        self.step();
    }

    fn drag(&mut self) {
        let button = self.random.one_of(&[
            PointerButton::Primary,
            PointerButton::Primary,
            PointerButton::Secondary,
            PointerButton::Middle,
        ]);
        let modifiers = self.random.one_of(&[Modifiers::NONE, Modifiers::NONE, Modifiers::SHIFT, Modifiers::ALT]);
        let mut at = self.place();
        self.button(at, button, true, modifiers);
        let step = 90.0 * Vec2::new(self.random.share() - 0.5, self.random.share() - 0.5);
        for _ in 0..=self.random.below(12) {
            at += step + 30.0 * Vec2::new(self.random.share() - 0.5, self.random.share() - 0.5);
            self.window.input_mut().events.push(Event::PointerMoved(at));
            self.step();
        }
        self.button(at, button, false, modifiers);
    }

    /// What was opened is the document now, unless it was thought better of.
    fn opened(&mut self) {
        self.step();
        if let Some(discard) = self.window.query_by_label("Discard") {
            discard.click();
            (0..3).for_each(|_| self.step());
        }
        self.escape();
        if self.window.state().undo_name().is_none() {
            self.first = self.text();
        }
    }

    fn example(&mut self) {
        let example = &EXAMPLES[self.random.below(EXAMPLES.len())];
        self.escape();
        self.perform(Action::Examples);
        self.window.event(Event::Text(example.title.to_owned()));
        (0..4).for_each(|_| self.step());
        let found = self.window.query_all_by_label(example.title).next().inspect(egui_kittest::Node::click).is_some();
        (0..if found { 3 } else { 0 }).for_each(|_| self.step());
        self.opened();
    }

    fn act(&mut self) {
        let what = self.random.below(20);
        let told = match what {
            0..8 => {
                let action = Action::ALL[self.random.below(Action::ALL.len())];
                // A dialog of the desktop would wait for a person.
                if action == Action::Quit {
                    return;
                }
                let dialog = action.name().ends_with('…') || matches!(action, Action::Save | Action::Help);
                if !matches!(action, Action::New | Action::NewEmpty | Action::Reload) || self.opens {
                    self.perform(action);
                }
                match action {
                    Action::New | Action::NewEmpty | Action::Reload => self.opened(),
                    _ if dialog => self.escape(),
                    _ => {}
                }
                format!("{action:?}")
            }
            8..10 => {
                let key = self.random.one_of(&KEYS);
                self.key(key);
                format!("{key:?}")
            }
            10..14 => {
                self.drag();
                "drag".to_owned()
            }
            14 | 15 => {
                let at = self.place();
                self.button(at, PointerButton::Primary, true, Modifiers::NONE);
                self.button(at, PointerButton::Primary, false, Modifiers::NONE);
                format!("click {at:?}")
            }
            16 => {
                let delta = Vec2::new(0.0, 200.0 * (self.random.share() - 0.5));
                let at = self.place();
                self.window.event(Event::PointerMoved(at));
                self.window.event(Event::MouseWheel {
                    unit: MouseWheelUnit::Point,
                    delta,
                    phase: egui::TouchPhase::Move,
                    source: egui::MouseWheelSource::Unknown,
                    modifiers: Modifiers::NONE,
                });
                self.step();
                "wheel".to_owned()
            }
            17 => {
                let text = self.random.one_of(&["1.5", "-2", "0", "1e9", "3 cm", "nonsense", "", "90 g"]);
                self.window.event(Event::Text(text.to_owned()));
                self.step();
                format!("text {text:?}")
            }
            18 if self.opens && self.random.below(6) == 0 => {
                self.example();
                "example".to_owned()
            }
            _ => {
                for _ in 0..self.random.below(STORM) {
                    let action = self.random.one_of(&[Action::Undo, Action::Undo, Action::Redo]);
                    self.perform(action);
                }
                "storm".to_owned()
            }
        };
        self.done.push(told);
    }

    /// The document undone to its start is the one that was opened, and redone it is what it was.
    fn check(&mut self) {
        self.escape();
        let end = self.text();
        assert!(self.window.state().scene().validate().is_ok(), "{:?}", self.done);
        let mut undone = 0;
        while self.window.state().undo_name().is_some() {
            self.perform(Action::Undo);
            undone += 1;
            assert!(undone <= 600, "undo never ends");
        }
        // Of very many steps the first are forgotten.
        assert!(undone >= 500 || self.text() == self.first, "undone it is another document: {:?}", self.done);
        for _ in 0..undone {
            self.perform(Action::Redo);
        }
        assert!(self.text() == end, "redone it is another document: {:?}", self.done);
        let failure = self.window.state().published().status.failure.clone().unwrap_or_default();
        assert!(!failure.contains("panicked"), "{failure}: {:?}", self.done);
        self.done.clear();
    }
}

#[test]
fn a_monkey_of_a_hundred_steps_leaves_a_document_that_is_its_replay() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut monkey = Monkey::new(3, folder.path(), false);
    let before = monkey.text();
    let mut changed = false;
    for step in 1..=100 {
        monkey.act();
        changed |= monkey.text() != before;
        if step % 50 == 0 {
            monkey.check();
        }
    }
    assert!(changed, "it never met anything that changes the document");
}

#[test]
#[ignore = "for any time: SINEW_MONKEY=\"SECONDS [SEED]\" cargo test --release --test window -- --ignored --nocapture monkey"]
fn a_monkey_for_any_time() {
    let asked = env::var("SINEW_MONKEY").unwrap_or_else(|_| "60".to_owned());
    let mut words = asked.split_whitespace().map(|word| word.parse().expect("a number"));
    let (seconds, seed) = (words.next().unwrap_or(60), words.next().unwrap_or(1));
    let folder = tempfile::tempdir().expect("a folder");
    let mut monkey = Monkey::new(seed, folder.path(), true);
    let (begun, mut steps, mut checks) = (Instant::now(), 0_u64, 0);
    let mut warm = None;
    while begun.elapsed() < Duration::from_secs(seconds) {
        for _ in 0..40 {
            monkey.act();
            steps += 1;
        }
        monkey.check();
        checks += 1;
        if begun.elapsed() > Duration::from_secs(seconds / 10) {
            warm.get_or_insert_with(held);
        }
    }
    let took = begun.elapsed().as_secs_f64();
    println!("seed {seed}: {steps} steps, {checks} times undone and redone, {took:.0} s");
    println!("the longest frame: {:.3} s", monkey.longest.as_secs_f64());
    if let (Some(Some(before)), Some(after)) = (warm, held()) {
        println!(
            "memory {:?} MiB and {:?} files open after a tenth, {:?} and {:?} at the end",
            before.0, before.1, after.0, after.1
        );
        // What the timeline keeps of a motion is bounded; nothing else grows.
        assert!(after.0 < before.0 + before.0 / 2 + 200, "memory grows: {before:?} to {after:?} MiB");
        assert!(after.1 < before.1 + 20, "open files grow: {before:?} to {after:?}");
    }
    assert!(
        cfg!(debug_assertions) || monkey.longest < Duration::from_millis(500),
        "{:?} without a frame",
        monkey.longest
    );
}

/// Memory of this program [MiB] and the number of files that it has open, as Linux tells them.
fn held() -> Option<(u64, usize)> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmRSS:"))?;
    let memory = line.split_whitespace().next()?.parse::<u64>().ok()? / 1024;
    Some((memory, std::fs::read_dir("/proc/self/fd").ok()?.count()))
}
