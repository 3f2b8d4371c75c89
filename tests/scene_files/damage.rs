//! Damaged files: whatever they hold, the answer is a valid scene or one line that says why not.

use super::{EVERY_FIELD, is_one_line};
use serde_json::{Value, json};
use sinew::io::{load_scene, scene_from_json, scene_to_json};
use std::fs;
use std::path::Path;

/// Damaged files that are tried.
const FILES: u64 = 1000;

/// Steele, Lea and Flood's `SplitMix64`: the same damage on every run and machine.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A number from 0 to below `end`, which is above 0.
    fn below(&mut self, end: usize) -> usize {
        (self.next() % end as u64) as usize
    }
}

/// Pointers to all values below the root.
fn places(value: &Value, path: &str, out: &mut Vec<String>) {
    let children: Vec<(String, &Value)> = match value {
        Value::Object(members) => members.iter().map(|(name, member)| (name.clone(), member)).collect(),
        Value::Array(items) => items.iter().enumerate().map(|(index, item)| (index.to_string(), item)).collect(),
        _ => Vec::new(),
    };
    for (name, child) in children {
        let path = format!("{path}/{name}");
        places(child, &path, out);
        out.push(path);
    }
}

fn damaged_value(random: &mut Random, valid: &Value, places: &[String]) -> Vec<u8> {
    let mut value = valid.clone();
    let place = &places[random.below(places.len())];
    let (parent, name) = place.rsplit_once('/').expect("places begin with a slash");
    let kind = random.below(4);
    let parent = value.pointer_mut(parent).expect("still there");
    match (kind, parent) {
        (0, Value::Object(members)) => {
            members.remove(name);
        }
        (0, Value::Array(items)) => {
            items.pop();
        }
        (1, Value::Object(members)) => {
            let moved = members.remove(name).unwrap_or_default();
            members.insert(format!("{name}s"), moved);
        }
        (1, Value::Array(items)) => items.push(json!(0)),
        _ => {
            let odd = [
                json!(null),
                json!(true),
                json!(0),
                json!(-1),
                json!(-0.0),
                json!(0.5),
                json!(1e300),
                json!(-1e300),
                json!(5e-324),
                json!(u64::MAX),
                json!(i64::MIN),
                json!(""),
                json!("\u{0}\n\u{2028}~/\u{1F9B4}"),
                json!("x".repeat(5000)),
                json!([]),
                json!({}),
                json!([[[]]]),
                json!({"": {"": null}}),
            ];
            let odd = odd[random.below(odd.len())].clone();
            *value.pointer_mut(place).expect("still there") = odd;
        }
    }
    value.to_string().into_bytes()
}

fn damaged_text(random: &mut Random) -> Vec<u8> {
    let mut bytes = EVERY_FIELD.as_bytes().to_vec();
    let at = random.below(bytes.len());
    match random.below(6) {
        0 => {
            for _ in 0..=random.below(4) {
                let at = random.below(bytes.len());
                bytes[at] ^= 1 << random.below(8);
            }
        }
        1 => bytes.truncate(at),
        2 => {
            bytes.drain(at..(at + 1 + random.below(40)).min(EVERY_FIELD.len()));
        }
        3 => {
            // A line or two once more: members that are there twice, items that are one too many.
            let line = EVERY_FIELD.lines().nth(random.below(EVERY_FIELD.lines().count())).unwrap_or_default();
            let start = EVERY_FIELD.find(line).unwrap_or_default();
            bytes.splice(start..start, line.bytes());
        }
        4 => {
            let odd = ["1e999", "NaN", "-Infinity", "0x10", "01", "\"\\ud800\"", "//", "\u{feff}", "\u{0}", "}]", ","];
            bytes.splice(at..at, odd[random.below(odd.len())].bytes());
        }
        _ => {
            let depth = 1 + random.below(3000);
            let open = if random.below(2) == 0 { "[" } else { "{\"a\":" };
            bytes.splice(at..at, open.repeat(depth).bytes());
        }
    }
    bytes
}

fn check(path: &Path, bytes: &[u8], what: u64) -> bool {
    fs::write(path, bytes).expect("written");
    match load_scene(path) {
        Ok(scene) => {
            assert!(scene.validate().is_ok());
            // What is accepted can be saved and loaded again.
            assert_eq!(scene_from_json(&scene_to_json(&scene)).expect("valid"), scene, "file {what}");
            true
        }
        Err(error) => {
            let message = error.to_string();
            assert!(is_one_line(&message) && message.len() < 2000, "file {what}: {message:?}");
            false
        }
    }
}

#[test]
fn damaged_files_are_refused_in_one_line_or_are_valid() {
    let valid: Value = serde_json::from_str(EVERY_FIELD).expect("JSON");
    let mut all = Vec::new();
    places(&valid, "", &mut all);
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("damaged.json");
    let mut accepted = 0;
    for seed in 0..FILES {
        let mut random = Random(seed);
        let bytes = if seed % 2 == 0 { damaged_value(&mut random, &valid, &all) } else { damaged_text(&mut random) };
        accepted += u64::from(check(&path, &bytes, seed));
    }
    // Damage that is never refused, or always, would test nothing.
    assert!((FILES / 50..FILES * 9 / 10).contains(&accepted), "{accepted} of {FILES} are valid");
}
