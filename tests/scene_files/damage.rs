//! Damaged files: whatever they hold, the answer is a valid scene or one line that says why not.

use super::{EVERY_FIELD, is_one_line};
use serde_json::{Value, json};
use sinew::io::{load_scene, scene_from_json, scene_to_json};
use sinew::scene::{Body, Scene};
use sinew::sim::Journal;
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

fn damaged_text(random: &mut Random, sound: &str) -> Vec<u8> {
    let mut bytes = sound.as_bytes().to_vec();
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
            bytes.drain(at..(at + 1 + random.below(40)).min(sound.len()));
        }
        3 => {
            // A line or two once more: members that are there twice, items that are one too many.
            let line = sound.lines().nth(random.below(sound.lines().count())).unwrap_or_default();
            let start = sound.find(line).unwrap_or_default();
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

/// How many of the damaged scenes of these seeds are valid; the others are refused in one line.
fn valid_among(seeds: std::ops::Range<u64>) -> u64 {
    let valid: Value = serde_json::from_str(EVERY_FIELD).expect("JSON");
    let mut all = Vec::new();
    places(&valid, "", &mut all);
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("damaged.json");
    let damaged = |seed: u64| {
        let mut random = Random(seed);
        if seed.is_multiple_of(2) {
            damaged_value(&mut random, &valid, &all)
        } else {
            damaged_text(&mut random, EVERY_FIELD)
        }
    };
    seeds.map(|seed| u64::from(check(&path, &damaged(seed), seed))).sum()
}

#[test]
fn damaged_files_are_refused_in_one_line_or_are_valid() {
    let accepted = valid_among(0..FILES);
    // Damage that is never refused, or always, would test nothing.
    assert!((FILES / 50..FILES * 9 / 10).contains(&accepted), "{accepted} of {FILES} are valid");
}

#[test]
#[ignore = "hours: cargo test --release --test scene_files -- --ignored a_million"]
fn a_million_damaged_scenes_are_refused_in_one_line_or_are_valid() {
    println!("{} of a million are valid", valid_among(0..1_000_000));
}

const CSV: &str = "body,fibre,x,y,z\nbar,a,0,0.1,2e-3\nbar,a,0,0.2,2e-3\nbar,b,1,0,0\nbar,b,1,1,0\n";
const JSON: &str = r#"{"fibres": [{"body": "bar", "name": "a", "vertices": [[0, 0, 0], [0, 0.1, 0.5], [1e-3, 2, -1]]},
    {"vertices": [[0, 1, 0], [0, 2, 0]]}]}"#;
const OBJ: &str = "o bar.a\nv 0 0 0\nv 0 1 0\nv 0 2 0.5\nl 1 2 3\no b\nv 1 0 0\nv 1 1 0\nl -2 -1\n";

/// A journal of everything that can be asked of a motion.
fn journal() -> String {
    let scene = Scene::new("Cube").with_body(Body::cuboid("cube", [0.03; 3]));
    let asked = [
        json!("play"),
        json!({"speed": 0.5}),
        json!({"grab": {"body": 0, "vertex": 3, "target": [0, 1, 0]}}),
        json!({"move_grab": [0, 1.5, 0]}),
        json!("release"),
        json!({"strike": {"body": 0, "impulse": [0, 0.1, 0]}}),
        json!({"edit": scene}),
    ];
    let asked: Vec<Value> =
        asked.iter().enumerate().map(|(frame, what)| json!({"frame": frame, "what": what})).collect();
    json!({"program": "1.0.0", "scene": scene, "asked": asked, "hashes": ["0", "1", "2"]}).to_string()
}

/// Damaged lines and journals of these seeds give what is sound, or are refused in one line.
fn lines_and_journals(seeds: std::ops::Range<u64>) -> [u64; 2] {
    let folder = tempfile::tempdir().expect("a folder");
    let journal = journal();
    assert!(serde_json::from_str::<Journal>(&journal).is_ok(), "undamaged it is one");
    let (mut read, mut refused) = (0, 0);
    for seed in seeds {
        let mut random = Random(seed);
        let (name, sound) =
            [("a.csv", CSV), ("a.json", JSON), ("a.obj", OBJ), ("journal", &journal)][(seed % 4) as usize];
        let bytes = damaged_text(&mut random, sound);
        if name == "journal" {
            match serde_json::from_slice::<Journal>(&bytes) {
                Ok(journal) => {
                    read += 1;
                    journal.scenes().for_each(|scene| drop(scene.validate()));
                }
                Err(_) => refused += 1,
            }
            continue;
        }
        let path = folder.path().join(name);
        fs::write(&path, bytes).expect("written");
        match sinew::test_support::io::points_of_lines(&path) {
            Ok(points) => {
                read += 1;
                assert!(points.iter().all(|point| point.is_finite()), "{name} of seed {seed}");
            }
            Err(said) => {
                refused += 1;
                assert!(is_one_line(&said) && said.len() < 2000, "{name} of seed {seed}: {said:?}");
            }
        }
    }
    [read, refused]
}

#[test]
fn damaged_lines_and_journals_are_refused_in_one_line_or_are_sound() {
    let [read, refused] = lines_and_journals(0..4000);
    assert!(read > 200 && refused > 1000, "{read} read, {refused} refused");
}

#[test]
#[ignore = "an hour: cargo test --release --test scene_files -- --ignored a_million"]
fn a_million_damaged_lines_and_journals_are_refused_in_one_line_or_are_sound() {
    println!("{:?} read and refused", lines_and_journals(0..1_000_000));
}
