//! What of the system an area may know: files, clocks and threads are each the business of a few areas only.

use super::circles::module_of;
use super::every_source;
use crate::imports::{Import, imports};
use crate::tokens::{Token, tokens};
use std::path::Path;

/// Parts of the standard library, and the areas that may know of them.
const TABLE: &[(&str, &[&str])] = &[
    ("std::fs", &["io"]),
    ("std::net", &[]),
    ("std::env", &[]),
    ("std::process", &["cli", "main"]),
    ("std::time", &["io", "sim", "cli", "ui"]),
    ("std::thread", &["sim", "transfer", "cli", "ui"]),
    // What a trace calls its threads.
    ("std::thread::current", &["io"]),
];

/// Whether a file is a module of tests.
pub fn is_of_tests(path: &Path) -> bool {
    path.file_name().is_some_and(|name| name == "tests.rs")
}

/// Every path of a file into the system that its area may not know, tests left out.
fn violations(path: &Path, text: &str) -> Vec<String> {
    let module = module_of(path);
    let Some(area) = module.first().filter(|_| !is_of_tests(path)) else { return Vec::new() };
    let found = imports(text, &module, false);
    let brought: Vec<&Import> = found.iter().filter(|import| import.name.is_some() && !import.rooted).collect();
    let mut told = Vec::new();
    for import in found.iter().filter(|import| !import.rooted) {
        // What a `use` brings in by the name of a module is told by the paths through it: `use std::fs`, `fs::write`.
        let mut path = import.path[import.module.len()..].to_vec();
        if let Some(whole) = brought.iter().find(|whole| whole.name.as_ref() == path.first()) {
            path.splice(..1, whole.path[whole.module.len()..].iter().cloned());
        }
        let path = path.join("::");
        let is_within = |part: &str| path == part || path.starts_with(&format!("{part}::"));
        let Some((part, _)) = TABLE.iter().find(|(part, _)| is_within(part)) else { continue };
        let is_whole = import.name.is_some() && path == *part;
        let may = TABLE.iter().any(|(part, areas)| is_within(part) && areas.contains(&area.as_str()));
        if !may && !is_whole {
            told.push(format!("{} line {}: {area} may not know {path}", import.module.join("::"), import.line));
        }
    }
    told
}

/// Methods of paths that ask the file system.
const ASKING: &[&str] =
    &["canonicalize", "exists", "is_dir", "is_file", "is_symlink", "metadata", "read_dir", "read_link"];

/// Every question of a file to the file system that stands in another area than `io`, tests left out.
fn questions(path: &Path, text: &str) -> Vec<String> {
    let module = module_of(path);
    if module.first().is_none_or(|area| area == "io") {
        return Vec::new();
    }
    let code = text.split("#[cfg(test)]\nmod tests").next().unwrap_or_default();
    let asks = |marks: &[(Token, usize)]| match marks {
        [(Token::Other('.'), _), (Token::Word(method), line), (Token::Other('('), _)]
            if ASKING.contains(&method.as_str()) =>
        {
            Some(format!("{} line {line}: only io may ask for {method}", module.join("::")))
        }
        _ => None,
    };
    tokens(code).windows(3).filter_map(asks).collect()
}

#[test]
fn only_one_area_asks_the_file_system() {
    let found: Vec<String> = every_source().iter().flat_map(|(path, text)| questions(path, text)).collect();
    assert!(found.is_empty(), "\n{}", found.join("\n"));
    let asking = "fn f(p: &Path) { p.exists(); }\n#[cfg(test)]\nmod tests { fn g() { a.is_file(); } }";
    assert_eq!(questions(Path::new("ui/a.rs"), asking), ["ui::a line 1: only io may ask for exists"]);
    assert!(questions(Path::new("io/a.rs"), asking).is_empty());
}

#[test]
fn only_areas_that_may_know_files_clocks_and_threads() {
    let sources = every_source();
    let found: Vec<String> = sources.iter().flat_map(|(path, text)| violations(path, text)).collect();
    assert!(found.is_empty(), "\n{}", found.join("\n"));
    // What is allowed is made use of: a row for an area that has no need of it goes.
    for (part, areas) in TABLE {
        for area in *areas {
            let uses = |(path, text): &(std::path::PathBuf, String)| {
                module_of(path).first().is_some_and(|first| first == area) && {
                    let module = module_of(path);
                    let last = part.rsplit("::").next().unwrap_or_default();
                    imports(text, &module, false).iter().any(|import| import.path.iter().any(|segment| segment == last))
                }
            };
            assert!(sources.iter().any(uses), "{area} makes no use of {part}");
        }
    }
}

#[test]
fn ways_to_the_system_are_found_however_they_are_written() {
    let cases: &[(&str, &str, usize)] = &[
        ("solver/a.rs", "use std::time::Instant;", 1),
        ("solver/a.rs", "fn f() { std::time::Instant::now(); }", 1),
        ("solver/a.rs", "use std::time; fn f() { time::Instant::now(); }", 1),
        ("solver/a.rs", "use std::{fmt, fs::{self, File}}; fn f() { fs::write(); }", 2),
        ("solver/a.rs", "use std::fs as files; fn f() { files::write(); }", 1),
        ("solver/a.rs", "use std::{fmt, ops::Range};", 0),
        ("solver/a.rs", "#[cfg(test)] mod tests { use std::time::Instant; }", 0),
        ("solver/a.rs", "fn time(time: f64) -> f64 { self.fs(time) }", 0),
        ("io/a.rs", "use std::thread; fn f() { thread::current(); }", 0),
        ("io/a.rs", "use std::thread; fn f() { thread::current(); thread::spawn(); }", 1),
        ("io/a.rs", "use std::fs::File; fn f() { std::fs::write(); }", 0),
        ("solver/a/tests.rs", "use std::fs; fn f() { fs::read(); }", 0),
    ];
    for (path, text, expected) in cases {
        let found = violations(Path::new(path), text);
        assert_eq!(found.len(), *expected, "{path}: {text}: {found:?}");
    }
}
