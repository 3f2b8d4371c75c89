//! The top-level modules, here called areas: who may import whom, how long a file may be, and that no files go round in
//! a circle.

mod circles;
mod door;
mod imports;
mod licences;
mod notices;
mod outside;
mod tokens;
mod words;

use circles::{Circle, circles, module_of};
use imports::{Import, imports};
use std::fs;
use std::path::{Path, PathBuf};

/// What each area may import: whole areas, or one module of an area.
const TABLE: &[(&str, &[&str])] = &[
    ("text", &[]),
    ("geometry", &[]),
    ("sketch", &["geometry", "text"]),
    ("scene", &["geometry", "sketch", "text"]),
    ("solver", &["geometry"]),
    ("edit", &["scene", "sketch", "geometry", "text"]),
    ("bake", &["scene", "sketch", "geometry", "solver", "text"]),
    ("export", &["scene", "geometry", "solver"]),
    ("io", &["scene", "geometry", "solver::snapshot", "export", "text"]),
    ("sim", &["scene", "bake", "solver", "text"]),
    ("draw", &["scene", "geometry", "solver::snapshot", "text"]),
    ("render", &["draw", "geometry", "text"]),
    ("transfer", &["geometry", "scene", "edit", "io", "export", "solver", "sim", "draw", "render", "text"]),
    (
        "cli",
        &[
            "geometry", "sketch", "scene", "edit", "bake", "io", "export", "solver", "sim", "draw", "render", "text",
            "transfer",
        ],
    ),
    (
        "ui",
        &[
            "geometry", "sketch", "scene", "edit", "bake", "io", "export", "solver", "sim", "draw", "render", "text",
            "transfer",
        ],
    ),
    ("test_support", &["geometry", "sketch", "scene", "io", "solver", "sim", "render", "cli", "ui"]),
    ("main", &["cli", "ui"]),
];

/// A source file may have fewer lines than this.
const LONGEST: usize = 400;

/// The widest that a line of a comment may be, as lines of code are.
const WIDEST: usize = 120;

/// Areas with files that still import each other in a circle. It only ever gets shorter: an area without a circle may
/// not stand here.
const KNOWN: &[&str] = &[];

/// Why an area may not import something; none if it may.
fn violation(area: &str, import: &Import) -> Option<String> {
    let target = import.path.first()?;
    // What is no area lies in the file itself: `super::` in a test module leads out of that module only.
    if target == area || !is_area(target) {
        return None;
    }
    let Some((_, allowed)) = TABLE.iter().find(|(name, _)| *name == area) else {
        return Some(format!("area {area} is not in the table"));
    };
    let within = |allowed: &str| allowed.split("::").zip(&import.path).filter(|(a, b)| a == b).count();
    let may = allowed.iter().any(|allowed| within(allowed) == allowed.split("::").count());
    (!may).then(|| format!("line {}: {area} may not import {}", import.line, import.path.join("::")))
}

fn is_area(name: &str) -> bool {
    TABLE.iter().any(|(area, _)| *area == name)
}

/// Every violation in a file, of which `path` is its place under `src`.
fn violations(path: &Path, text: &str) -> Vec<String> {
    let module = module_of(path);
    let Some(area) = module.first() else { return Vec::new() };
    rooted(text, &module).iter().filter_map(|import| violation(area, import)).collect()
}

/// The paths of a source that say where in the crate they start.
fn rooted(text: &str, module: &[String]) -> Vec<Import> {
    imports(text, module, true).into_iter().filter(|import| import.rooted).collect()
}

/// Folders of the source that are crates of their own, with their own manifest and no part in this one's build.
const OTHER_CRATES: &[&str] = &["python"];

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
    let is_another = |path: &PathBuf| OTHER_CRATES.iter().any(|name| path.starts_with(src.join(name)));
    sources(&src).into_iter().filter(|path| !is_another(path)).map(read).collect()
}

#[test]
fn every_area_imports_what_it_may() {
    let sources = every_source();
    let imports: usize = sources.iter().map(|(path, text)| rooted(text, &module_of(path)).len()).sum();
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
fn every_folder_of_the_source_is_an_area() {
    for (path, _) in every_source() {
        if let Some(area) = module_of(&path).first() {
            assert!(is_area(area), "{area} is not in the table");
        }
    }
}

#[test]
fn other_crates_are_crates_and_their_files_go_round_in_no_circle() {
    let src = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    for name in OTHER_CRATES {
        assert!(src.join(name).join("Cargo.toml").is_file(), "{name} has no manifest");
        // A crate of files side by side is one area.
        let own = src.join(name).join("src");
        let read = |path: PathBuf| {
            let text = fs::read_to_string(&path).expect("the file can be read");
            let path = path.strip_prefix(&own).expect("a path under it");
            let path = if path == Path::new("lib.rs") { Path::new("mod.rs") } else { path };
            (Path::new(name).join(path), text.replace("crate::", &format!("crate::{name}::")))
        };
        let sources: Vec<(PathBuf, String)> = sources(&own).into_iter().map(read).collect();
        assert!(sources.len() > 2, "{name} has no files");
        let circles = circles(&sources);
        assert!(circles.is_empty(), "{circles:?}");
    }
}

#[test]
fn the_table_has_no_circle() {
    // The areas stand in an order in which each imports earlier ones only.
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
fn no_comment_is_wide() {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    for path in ["src", "tests"].into_iter().flat_map(|folder| sources(&here.join(folder))) {
        let text = fs::read_to_string(&path).expect("the file can be read");
        for (number, line) in (1..).zip(text.lines()) {
            let comment = line.trim_start().trim_start_matches(['/', '!']);
            // Rows of tables cannot be broken.
            let is_one = line.trim_start().starts_with("//") && !comment.trim_start().starts_with('|');
            let width = line.chars().count();
            assert!(!is_one || width <= WIDEST, "{}, line {number}: {width} characters", path.display());
        }
    }
}

#[test]
fn no_file_is_long() {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    for path in ["src", "tests"].into_iter().flat_map(|folder| sources(&here.join(folder))) {
        let lines = fs::read_to_string(&path).expect("the file can be read").lines().count();
        assert!(lines < LONGEST, "{} has {lines} lines", path.display());
    }
}

#[test]
fn no_files_of_an_area_import_each_other_in_a_circle() {
    let circles = circles(&every_source());
    let (known, new): (Vec<_>, Vec<_>) = circles.iter().partition(|circle| KNOWN.contains(&&*circle.area));
    let told = |circles: &[&Circle]| {
        let told = circles
            .iter()
            .map(|circle| format!("{}, {} files:\n  {}\n", circle.area, circle.files.len(), circle.ties.join("\n  ")));
        told.collect::<Vec<_>>().join("\n")
    };
    eprintln!("{}", told(&known));
    assert!(new.is_empty(), "files import each other in a circle (a <- b: what a imports from b)\n{}", told(&new));
    for area in KNOWN {
        assert!(circles.iter().any(|circle| circle.area == *area), "{area} has no circle any more: take it off KNOWN");
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

#[test]
fn circles_are_found_however_they_are_written() {
    /// Files with their text, and the files of each circle among them.
    type Case = (&'static [(&'static str, &'static str)], &'static [&'static [&'static str]]);
    let cases: &[Case] = &[
        // Siblings, by `super::`, by `crate::` and in code.
        (&[("io/a.rs", "use super::b::B;"), ("io/b.rs", "use crate::io::a::A;")], &[&["io/a.rs", "io/b.rs"]]),
        (&[("io/a.rs", "fn f() { super::b::g() }"), ("io/b.rs", "type A = super::a::A;")], &[&["io/a.rs", "io/b.rs"]]),
        (&[("io/a.rs", "use super::b::B;"), ("io/b.rs", "use std::fs;")], &[]),
        (&[("io/a.rs", "use super::{b, c};"), ("io/b.rs", "use super::a;"), ("io/c.rs", "")], &[]),
        (
            &[("io/a.rs", "use super::b; fn f() { b::g() }"), ("io/b.rs", "use super::a::A;")],
            &[&["io/a.rs", "io/b.rs"]],
        ),
        // Three in a row go round; a fourth that only looks on does not.
        (
            &[
                ("io/a.rs", "use super::{b::B, d::D};"),
                ("io/b.rs", "use super::c::{C as Other, self};"),
                ("io/c.rs", "use self::super::a::A;"),
                ("io/d.rs", ""),
            ],
            &[&["io/a.rs", "io/b.rs", "io/c.rs"]],
        ),
        // A parent that defines what its child uses, and uses its child: by a bare path, by `self::`, by a re-export.
        (&[("io/mod.rs", "mod a; use a::A; struct M;"), ("io/a.rs", "use super::M;")], &[&["io/a.rs", "io/mod.rs"]]),
        (
            &[("io/mod.rs", "mod a; fn f() { self::a::f() }"), ("io/a.rs", "use super::M;")],
            &[&["io/a.rs", "io/mod.rs"]],
        ),
        (&[("io/mod.rs", "mod a; fn f() { a::f() }"), ("io/a.rs", "use super::*;")], &[&["io/a.rs", "io/mod.rs"]]),
        (&[("io/mod.rs", "pub use a::A; struct M(A);"), ("io/a.rs", "use super::M;")], &[&["io/a.rs", "io/mod.rs"]]),
        (&[("io/mod.rs", "pub mod a; pub use a::{A, f}; struct M;"), ("io/a.rs", "use super::M;")], &[]),
        (&[("io/a.rs", "mod b; use b::B;"), ("io/a/b.rs", "use super::A;")], &[&["io/a/b.rs", "io/a.rs"]]),
        (&[("io/a.rs", "mod b; pub struct A;"), ("io/a/b.rs", "impl super::A {}")], &[]),
        // What a parent re-exports is the sibling's that defines it, also through two parents and under a new name.
        (&[("io/mod.rs", "pub use b::B;"), ("io/a.rs", "use super::B;"), ("io/b.rs", "")], &[]),
        (
            &[("io/mod.rs", "pub use b::B as C;"), ("io/a.rs", "use super::C;"), ("io/b.rs", "use super::a::A;")],
            &[&["io/a.rs", "io/b.rs"]],
        ),
        (
            &[
                ("io/mod.rs", "pub use b::B;"),
                ("io/a.rs", "use super::B;"),
                ("io/b/mod.rs", "pub use c::B;"),
                ("io/b/c.rs", "use crate::io::a;  type T = a::A;"),
            ],
            &[&["io/a.rs", "io/b/c.rs"]],
        ),
        // Two circles are two.
        (
            &[
                ("io/a.rs", "use super::b::B;"),
                ("io/b.rs", "use super::a::A; use super::c::C;"),
                ("io/c.rs", "use super::d::D;"),
                ("io/d.rs", "use super::c::C;"),
            ],
            &[&["io/a.rs", "io/b.rs"], &["io/c.rs", "io/d.rs"]],
        ),
        // What only tests use, comments, visibilities and variables tie nothing; a module written inside a file is the
        // file.
        (&[("io/a.rs", "use super::b::B;"), ("io/b.rs", "#[cfg(test)] mod tests { use super::super::a::A; }")], &[]),
        (&[("io/a.rs", "use super::b::B;"), ("io/b.rs", "#[cfg(test)]\nuse super::a::{A, C};\nfn f() {}")], &[]),
        (
            &[("io/a.rs", "use super::b::B;"), ("io/b.rs", "#[cfg(test)] fn g() {} use super::a::A;")],
            &[&["io/a.rs", "io/b.rs"]],
        ),
        (&[("io/a.rs", "mod tests;"), ("io/a/tests.rs", "use super::A;")], &[]),
        (&[("io/a.rs", "use super::b::B;"), ("io/b.rs", "// super::a::A\nconst T: &str = \"super::a::A\";")], &[]),
        (&[("io/mod.rs", "mod a; use a::A;"), ("io/a.rs", "pub(in crate::io) fn f() {}")], &[]),
        (&[("io/mod.rs", "pub use a::a; fn f(a: u8) -> u8 { a }"), ("io/a.rs", "use super::M;")], &[]),
        (&[("io/mod.rs", "pub use a::a; fn f() { a() }"), ("io/a.rs", "use super::M;")], &[&["io/a.rs", "io/mod.rs"]]),
        (
            &[("io/a.rs", "mod inner { use super::super::b::B; }"), ("io/b.rs", "use super::a::inner::I;")],
            &[&["io/a.rs", "io/b.rs"]],
        ),
    ];
    let house = |files: &[(&str, &str)]| {
        let parent = (!files.iter().any(|(path, _)| *path == "io/mod.rs")).then_some(&("io/mod.rs", "mod a; mod b;"));
        let sources = files.iter().chain(parent).map(|(path, text)| (PathBuf::from(path), (*text).to_owned()));
        circles(&sources.collect::<Vec<_>>())
    };
    for (files, expected) in cases {
        let found = house(files);
        let found: Vec<Vec<&str>> = found
            .iter()
            .map(|circle| circle.files.iter().map(|file| file.to_str().expect("a path of letters")).collect())
            .collect();
        assert_eq!(found, *expected, "{files:?}");
    }
    let found = house(&[("io/a.rs", "use super::{b, c::C};\nfn f() { b::g(b::G) }"), ("io/b.rs", "use super::a::A;")]);
    assert_eq!(found[0].ties, ["io/a.rs <- io/b.rs: G, g", "io/b.rs <- io/a.rs: A"]);
}
