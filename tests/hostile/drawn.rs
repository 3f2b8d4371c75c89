//! What a hand gives: pairs of strokes, and sequences of commands with undo and redo among them.

use crate::any_commands::any_command;
use crate::every_field;
use crate::mutate::Random;
use crate::read::{Verdict, comes_back, refused};
use glam::DVec2;
use proptest::strategy::{BoxedStrategy, Strategy, ValueTree};
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};
use serde_json::Value;
use sinew::edit::{Command, Editor};
use sinew::io::scene_to_json;
use sinew::scene::Scene;
use sinew::sketch::{LiftOptions, Stroke, View, lift, structure_particles, sweep};
use sinew::test_support::sketch::{guides, partial_lift};
use std::fs;
use std::path::Path;

fn stroke(of: &Value) -> Stroke {
    let view = match of["view"].as_str() {
        Some("side") => View::Side,
        Some("top") => View::Top,
        _ => View::Front,
    };
    // What is no number is one that is none.
    let number = |value: &Value| value.as_f64().unwrap_or(f64::NAN);
    let points = of["points"].as_array().into_iter().flatten();
    Stroke { view, points: points.map(|point| DVec2::new(number(&point[0]), number(&point[1]))).collect() }
}

/// A pair of strokes: a curve of finite points, or a sentence.
pub fn strokes(path: &Path) -> Verdict {
    let bytes = fs::read(path).expect("a file");
    let Ok(value) = serde_json::from_slice::<Value>(&bytes) else { return Verdict::Refused };
    let (first, second) = (stroke(&value["first"]), stroke(&value["second"]));
    let model_diagonal = value["diagonal"].as_f64().unwrap_or(f64::NAN);
    let options = LiftOptions {
        flip_second: value["flip"].as_bool().unwrap_or_default(),
        stretch: value["stretch"].as_bool().unwrap_or_default(),
        model_diagonal,
    };
    if let Ok(preview) = partial_lift(&first, &second, model_diagonal) {
        assert!(preview.curve.iter().all(|point| point.is_finite()), "a preview at no place");
    }
    drop(guides(&first, second.view, model_diagonal));
    if let Err(error) = sweep(&first, &second, model_diagonal, 0.05 * model_diagonal) {
        refused(&error.to_string());
    }
    match lift(&first, &second, &options) {
        Ok(lifted) => {
            assert!(lifted.curve.iter().all(|point| point.is_finite()), "a curve at no place");
            if let Err(error) = structure_particles(&lifted.curve, 0.05 * model_diagonal) {
                refused(&error.to_string());
            }
            Verdict::Taken
        }
        Err(error) => refused(&error.to_string()),
    }
}

thread_local! {
    /// Making it takes longer than drawing from it.
    static ANY: BoxedStrategy<Command> = any_command().boxed();
    static FIRST: Scene = every_field();
}

/// Commands, undo and redo in an order that the bytes choose: the document is valid throughout, and undone to its start
/// and redone it is the same.
pub fn commands(path: &Path) -> Verdict {
    let bytes = fs::read(path).expect("a file");
    let seed = bytes
        .iter()
        .fold(0xcbf2_9ce4_8422_2325_u64, |hash, &byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3));
    let mut random = Random(seed);
    let rng: Vec<u8> = std::iter::repeat_with(|| random.next().to_le_bytes()).take(4).flatten().collect();
    let mut runner = TestRunner::new_with_rng(Config::default(), TestRng::from_seed(RngAlgorithm::ChaCha, &rng));
    let first = FIRST.with(Scene::clone);
    let mut editor = Editor::new(first.clone());
    let (any, mut taken) = (ANY.with(BoxedStrategy::clone), 0);
    for _ in 0..=random.below(12) {
        match random.below(8) {
            0 => drop(editor.undo()),
            1 => drop(editor.redo()),
            _ => {
                let command = any.new_tree(&mut runner).expect("a command").current();
                let gesture = (random.below(3) == 0).then_some(7);
                match editor.apply_in(&command, gesture) {
                    Ok(()) => taken += 1,
                    Err(error) => {
                        refused(&error.to_string());
                    }
                }
            }
        }
    }
    comes_back(editor.scene());
    let end = editor.scene().clone();
    let mut undone = 0;
    while editor.undo() {
        undone += 1;
    }
    assert_eq!(**editor.scene(), first, "undone to the start");
    for _ in 0..undone {
        assert!(editor.redo());
    }
    assert_eq!(scene_to_json(editor.scene()), scene_to_json(&end), "and redone");
    if taken > 0 { Verdict::Taken } else { Verdict::Refused }
}
