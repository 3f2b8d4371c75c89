//! The rooms of the house: who may import whom, and how long a file may be.

mod imports;

use imports::{Import, imports};
use std::fs;
use std::path::{Path, PathBuf};

/// What each room may import: whole rooms, or one module of a room.
const TABLE: &[(&str, &[&str])] = &[
    ("geometry", &[]),
    ("sketch", &["geometry"]),
    ("scene", &["geometry", "sketch"]),
    ("solver", &["geometry"]),
    ("edit", &["scene", "sketch", "geometry"]),
    ("bake", &["scene", "sketch", "geometry", "solver"]),
    ("io", &["scene", "geometry", "solver::snapshot"]),
    ("sim", &["scene", "bake", "solver"]),
    ("draw", &["scene", "geometry", "solver::snapshot"]),
    ("render", &["draw", "geometry"]),
    ("cli", &["geometry", "sketch", "scene", "edit", "bake", "io", "solver", "sim", "draw", "render"]),
    ("ui", &["geometry", "sketch", "scene", "edit", "bake", "io", "solver", "sim", "draw", "render"]),
    ("main", &["cli", "ui"]),
];

/// A source file may have fewer lines than this.
const LONGEST: usize = 400;

/// Why a room may not import something; none if it may.
fn violation(room: &str, import: &Import) -> Option<String> {
    let target = import.path.first()?;
    // What is no room lies in the file itself: `super::` in a test module leads out of that module only.
    if target == room || !is_room(target) {
        return None;
    }
    let Some((_, allowed)) = TABLE.iter().find(|(name, _)| *name == room) else {
        return Some(format!("room {room} is not in the table"));
    };
    let within = |allowed: &str| allowed.split("::").zip(&import.path).filter(|(a, b)| a == b).count();
    let may = allowed.iter().any(|allowed| within(allowed) == allowed.split("::").count());
    (!may).then(|| format!("line {}: {room} may not import {}", import.line, import.path.join("::")))
}

fn is_room(name: &str) -> bool {
    TABLE.iter().any(|(room, _)| *room == name)
}

/// Every violation in a file, of which `path` is its place under `src`.
fn violations(path: &Path, text: &str) -> Vec<String> {
    let module = module_of(path);
    let Some(room) = module.first() else { return Vec::new() };
    imports(text, &module).iter().filter_map(|import| violation(room, import)).collect()
}

/// The path of a file's module: `io/scene.rs` is io::scene, `io/mod.rs` io, `main.rs` main, `lib.rs` the crate itself.
fn module_of(path: &Path) -> Vec<String> {
    let mut parts: Vec<String> =
        path.with_extension("").iter().map(|part| part.to_string_lossy().into_owned()).collect();
    if parts.last().is_some_and(|last| last == "mod" || last == "lib") {
        parts.pop();
    }
    parts
}

fn sources(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).expect("the folder can be read") {
        let path = entry.expect("the entry can be read").path();
        if path.is_dir() {
            found.extend(sources(&path));
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            found.push(path);
        }
    }
    found.sort();
    found
}

fn every_source() -> Vec<(PathBuf, String)> {
    let src = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let read = |path: PathBuf| {
        let text = fs::read_to_string(&path).expect("the file can be read");
        (path.strip_prefix(&src).expect("a path under src").to_owned(), text)
    };
    sources(&src).into_iter().map(read).collect()
}

#[test]
fn every_room_imports_what_it_may() {
    let sources = every_source();
    let imports: usize = sources.iter().map(|(path, text)| imports(text, &module_of(path)).len()).sum();
    assert!(imports > 100, "only {imports} imports were found");
    let found: Vec<String> = sources
        .iter()
        .flat_map(|(path, text)| {
            violations(path, text).into_iter().map(move |text| format!("{}: {text}", path.display()))
        })
        .collect();
    assert!(found.is_empty(), "\n{}", found.join("\n"));
}

#[test]
fn every_folder_of_the_source_is_a_room() {
    for (path, _) in every_source() {
        if let Some(room) = module_of(&path).first() {
            assert!(is_room(room), "{room} is not in the table");
        }
    }
}

#[test]
fn the_table_has_no_circle() {
    // The rooms stand in an order in which each imports earlier ones only.
    let mut before = Vec::new();
    let mut left: Vec<_> = TABLE.to_vec();
    while !left.is_empty() {
        let ready = |(_, allowed): &(&str, &[&str])| {
            allowed.iter().all(|name| before.contains(&name.split("::").next().unwrap_or_default()))
        };
        let (now, later): (Vec<_>, Vec<_>) = left.into_iter().partition(ready);
        assert!(!now.is_empty(), "a circle among {later:?}");
        before.extend(now.iter().map(|(name, _)| *name));
        left = later;
    }
}

#[test]
fn no_file_is_long() {
    for (path, text) in every_source() {
        let lines = text.lines().count();
        assert!(lines < LONGEST, "{} has {lines} lines", path.display());
    }
}

#[test]
fn violations_are_found_however_they_are_written() {
    let cases: &[(&str, &str, usize)] = &[
        ("solver/body.rs", "use crate::scene::Scene;", 1),
        ("solver/body.rs", "use crate::{geometry::kernel, scene::{Body, Scene}, sim};", 3),
        ("solver/body.rs", "use crate::{geometry, solver::state};", 0),
        ("solver/body.rs", "fn f() -> crate::io::IoError { crate::bake::bake() }", 2),
        ("solver/body.rs", "pub(crate) use crate :: ui :: {self, App as Window};", 2),
        ("solver/forces/contact.rs", "use super::super::super::bake::bake;", 1),
        ("solver/forces/contact.rs", "use super::super::scene::bake;", 0),
        ("io/mod.rs", "use super::sim::Runner;", 1),
        ("io/mod.rs", "mod tests { use super::*; use super::{IoError, load_scene}; }", 0),
        ("io/obj.rs", "use crate::solver::snapshot::Snapshot;", 0),
        ("io/obj.rs", "use crate::solver::{snapshot::Snapshot, world::World};", 1),
        ("io/obj.rs", "use crate::solver::world::World;", 1),
        ("cli/check.rs", "use crate::ui::App;", 1),
        ("main.rs", "use sinew::cli::run; use sinew::solver::world::World;", 1),
        ("geometry/mesh.rs", "// use crate::scene::Scene;\n/* crate::scene */ /// crate::sim::Runner\n", 0),
        ("geometry/mesh.rs", r##"const A: &str = "crate::sim"; const B: &str = r#"a" crate::sim"#;"##, 0),
        ("geometry/mesh.rs", r#"fn f<'a>(x: &'a str) { let c = '"'; let d = '\''; crate::sim::run() }"#, 1),
        ("attic/mod.rs", "use crate::geometry::mesh;", 1),
    ];
    for (path, text, expected) in cases {
        let found = violations(Path::new(path), text);
        assert_eq!(found.len(), *expected, "{path}: {text}: {found:?}");
    }
    let found = violations(Path::new("sim/runner.rs"), "\n\nuse crate::{\n    bake::bake,\n    ui::App,\n};\n");
    assert_eq!(found, ["line 5: sim may not import ui::App"]);
}
