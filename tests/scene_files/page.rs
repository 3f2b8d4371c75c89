//! The page of figures beside the scenes names what is there, and all of it.

use sinew::scene::IntegratorKind;
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

/// Largest picture on the page [bytes].
const LARGEST: u64 = 60_000;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn page() -> String {
    fs::read_to_string(root().join("scenes/README.md")).expect("the page")
}

fn has_extension(name: &str, extension: &str) -> bool {
    Path::new(name).extension().is_some_and(|own| own == extension)
}

/// Names of files with this extension in a folder.
fn files(folder: &str, extension: &str) -> BTreeSet<String> {
    fs::read_dir(root().join(folder))
        .expect("a folder")
        .map(|entry| entry.expect("a file").file_name().to_string_lossy().into_owned())
        .filter(|name| has_extension(name, extension))
        .collect()
}

#[test]
fn every_scene_on_the_page_exists_and_every_scene_is_on_it() {
    let page = page();
    let named: BTreeSet<String> = page
        .split('`')
        .filter(|word| has_extension(word, "json") && !word.contains(['/', ' ']))
        .map(String::from)
        .collect();
    assert_eq!(named, files("scenes", "json"));
}

/// Names in code at the start of the rows of a table.
fn rows(text: &str) -> impl Iterator<Item = &str> {
    text.lines().filter(|line| line.starts_with("| `")).flat_map(|line| {
        let first = line.split(" | ").next().unwrap_or_default();
        first.split('`').skip(1).step_by(2)
    })
}

#[test]
fn every_scene_is_told_of_in_the_readme() {
    let readme = fs::read_to_string(root().join("README.md")).expect("the readme");
    let scenes = files("scenes", "json");
    let patterns: Vec<&str> = rows(&readme).filter(|name| has_extension(name, "json")).collect();
    let tells_of = |pattern: &str, name: &str| match pattern.split_once('*') {
        Some((begins, ends)) => name.starts_with(begins) && name.ends_with(ends),
        None => name == pattern,
    };
    for name in &scenes {
        assert!(patterns.iter().any(|pattern| tells_of(pattern, name)), "{name}");
    }
    for pattern in &patterns {
        assert!(scenes.iter().any(|name| tells_of(pattern, name)), "{pattern}");
    }
}

#[test]
fn every_integrator_has_its_row_in_the_table_of_schemes() {
    let page = fs::read_to_string(root().join("src/scene/integrators.md")).expect("the page");
    let told: BTreeSet<&str> = rows(&page).filter(|word| !word.contains(' ')).collect();
    let offered: BTreeSet<&str> = IntegratorKind::ALL.iter().map(|kind| kind.word()).collect();
    assert_eq!(told, offered);
}

#[test]
fn every_picture_on_the_page_exists_is_small_and_none_is_left_over() {
    let page = page();
    let shown: BTreeSet<String> = page
        .split("](../assets/figures/")
        .skip(1)
        .map(|rest| rest.split(')').next().unwrap_or_default().to_owned())
        .collect();
    assert_eq!(shown, files("assets/figures", "png"));
    for name in shown {
        let size = fs::metadata(root().join("assets/figures").join(&name)).unwrap().len();
        assert!(size <= LARGEST, "{name}: {size} bytes");
    }
}

#[test]
fn every_scene_says_what_to_look_at() {
    for name in files("scenes", "json") {
        let scene = sinew::io::load_scene(&root().join("scenes").join(&name)).unwrap();
        assert!(!scene.name.is_empty() && !scene.description.is_empty(), "{name}");
    }
}
