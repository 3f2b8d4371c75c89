//! Files are changed through one door, `io::door`, in which tests let every step fail.

use crate::every_source;
use crate::outside::is_of_tests;
use crate::tokens::{Token, tokens};
use std::path::Path;

/// Functions of `std::fs` that change files or folders.
const CHANGING: &[&str] = &[
    "copy",
    "create_dir",
    "create_dir_all",
    "hard_link",
    "remove_dir",
    "remove_dir_all",
    "remove_file",
    "rename",
    "set_permissions",
    "soft_link",
    "write",
];

/// Ways to open a file to be written, and files that are made by their name.
const OPENING: &[&str] = &["DirBuilder", "NamedTempFile", "OpenOptions", "TempDir", "tempdir", "tempfile"];

/// Methods of `File` that make one, or change it.
const MAKING: &[&str] = &["create", "create_new", "options", "set_len"];

/// Where the door is, and files that have a reason of their own.
const ALLOWED: &[(&str, &[&str])] = &[
    ("io/door.rs", &["create_dir_all", "remove_file", "NamedTempFile", "set_permissions", "tempfile"]),
    // Opens what a killed writer left only to try its lock; nothing is written through it, and it goes by the door.
    ("io/atomic.rs", &["OpenOptions"]),
];

/// Every word of a file that changes files, tests left out.
fn changes(path: &Path, text: &str) -> Vec<(String, usize)> {
    if is_of_tests(path) {
        return Vec::new();
    }
    let code = text.split("#[cfg(test)]\nmod tests").next().unwrap_or_default();
    let marks = tokens(code);
    let word = |at: usize| match marks.get(at) {
        Some((Token::Word(word), _)) => word.as_str(),
        _ => "",
    };
    let is_path = |at: usize| matches!(marks.get(at), Some((Token::PathSeparator, _)));
    let mut found = Vec::new();
    for (at, (_, line)) in marks.iter().enumerate() {
        let (this, before) = (word(at), at.checked_sub(2).map_or("", word));
        let within = at > 0 && is_path(at - 1);
        let is_method = at > 0 && marks[at - 1].0 == Token::Other('.');
        let changes = (within && before == "fs" && CHANGING.contains(&this))
            || (within && before == "File" && MAKING.contains(&this))
            || (is_method && ["set_len", "set_permissions", "set_modified", "set_times"].contains(&this))
            || OPENING.contains(&this);
        if changes {
            found.push((this.to_owned(), *line));
        }
    }
    found.extend(brought(&marks));
    found
}

/// Functions that a `use` brings in by their own name: `use std::fs::{self, write}`.
fn brought(marks: &[(Token, usize)]) -> Vec<(String, usize)> {
    let mut found = Vec::new();
    for (at, window) in marks.windows(3).enumerate() {
        let [(Token::Word(module), _), (Token::PathSeparator, _), (Token::Open, _)] = window else { continue };
        if module != "fs" {
            continue;
        }
        let list = marks[at + 3..].iter().take_while(|(mark, _)| *mark != Token::Close);
        found.extend(list.filter_map(|(mark, line)| match mark {
            Token::Word(word) if CHANGING.contains(&word.as_str()) => Some((word.clone(), *line)),
            _ => None,
        }));
    }
    found
}

#[test]
fn files_are_changed_through_one_door() {
    let mut used = Vec::new();
    for (path, text) in every_source() {
        let allowed = ALLOWED.iter().find(|(file, _)| Path::new(file) == path).map_or(&[][..], |(_, words)| words);
        for (word, line) in changes(&path, &text) {
            assert!(allowed.contains(&word.as_str()), "{}, line {line}: {word} goes by io::door", path.display());
            used.push((path.clone(), word));
        }
    }
    // What is allowed is made use of.
    for (file, words) in ALLOWED {
        for word in *words {
            assert!(used.contains(&(file.into(), (*word).to_owned())), "{file} makes no use of {word}");
        }
    }
}

#[test]
fn changes_of_files_are_found_however_they_are_written() {
    for (text, expected) in [
        ("fn f() { std::fs::write(p, b); }", vec!["write"]),
        ("use std::fs; fn f() { fs::rename(a, b); fs::read(a); }", vec!["rename"]),
        ("use std::fs::{self, remove_file, read};", vec!["remove_file"]),
        ("use std::fs::write;", vec!["write"]),
        ("fn f() { File::create(p); File::open(p); }", vec!["create"]),
        ("use std::fs::OpenOptions;", vec!["OpenOptions"]),
        ("fn f() { let d = tempfile::tempdir(); }", vec!["tempfile", "tempdir"]),
        ("fn f(file: &File) { file.set_len(3); out.write(b); }", vec!["set_len"]),
        ("// fs::write\nconst A: &str = \"fs::write\";", vec![]),
        ("fn f() {}\n#[cfg(test)]\nmod tests { fn g() { fs::write(p, b); } }", vec![]),
    ] {
        let found: Vec<String> = changes(Path::new("ui/a.rs"), text).into_iter().map(|(word, _)| word).collect();
        assert_eq!(found, expected, "{text}");
    }
}
