//! What has to go along with a program that is passed on: the licences of everything that is built into it, in the
//! words of each, fonts included. Made of what `Cargo.lock` says and of the sources, so that it is never another
//! program's: `tests/tools/notices.sh FILE` writes it.

use crate::licences::features;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Where the file is to be written.
const ASKED: &str = "SINEW_NOTICES";

/// Fonts that are built in, the crate that brings them, and the files of their licences there.
const FONTS: &[(&str, &str, &[&str])] = &[
    ("Ubuntu Light", "epaint_default_fonts", &["fonts/UFL.txt"]),
    ("Noto Emoji", "epaint_default_fonts", &["fonts/OFL.txt"]),
    ("Hack", "epaint_default_fonts", &["fonts/Hack-Regular.txt"]),
    ("emoji-icon-font", "epaint_default_fonts", &["fonts/emoji-icon-font-mit-license.txt"]),
    ("egui-icons", "epaint_default_fonts", &["fonts/egui-icons.txt"]),
];

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn said_by(program: &str, arguments: &[&str]) -> String {
    let out = Command::new(program).args(arguments).current_dir(root()).output().expect("it can be run");
    assert!(out.status.success(), "{program} {arguments:?}: {}", String::from_utf8_lossy(&out.stderr));
    String::from_utf8(out.stdout).expect("text")
}

fn cargo(arguments: &[&str]) -> String {
    let cargo = std::env::var("CARGO").unwrap_or_else(|_| "cargo".to_owned());
    said_by(&cargo, &[arguments, features()].concat())
}

/// A crate that is built in.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Crate {
    name: String,
    version: String,
    licence: String,
}

fn crates() -> BTreeSet<Crate> {
    let tree = cargo(&[
        "tree",
        "--locked",
        "--offline",
        "--edges",
        "normal",
        "--prefix",
        "none",
        "--no-dedupe",
        "--format",
        "{l}\t{p}",
    ]);
    let of = |line: &str| {
        let (licence, package) = line.split_once('\t')?;
        let (name, version) = package.split_once(" v")?;
        let version = version.split_whitespace().next()?.to_owned();
        (name != "sinew").then(|| Crate { name: name.to_owned(), version, licence: licence.to_owned() })
    };
    tree.lines().filter_map(of).collect()
}

/// Folders of the crates' sources, by their names: a crate's and its version.
fn sources() -> BTreeMap<String, PathBuf> {
    let host = said_by("rustc", &["-vV"]);
    let host = host.lines().find_map(|line| line.strip_prefix("host: ")).expect("a system");
    let list = cargo(&["metadata", "--locked", "--offline", "--format-version", "1", "--filter-platform", host]);
    let paths = list.split("\"manifest_path\":\"").skip(1).filter_map(|rest| rest.split('"').next());
    let folders = paths.filter_map(|path| Path::new(&path.replace("\\\\", "\\")).parent().map(Path::to_owned));
    folders.map(|folder| (folder.file_name().unwrap_or_default().to_string_lossy().into_owned(), folder)).collect()
}

/// The texts of licences that a crate brings along, by their files' names.
fn texts(folder: &Path) -> Vec<(String, String)> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let name = entry.file_name().to_string_lossy().into_owned();
        let upper = name.to_uppercase();
        let is_one =
            ["LICENSE", "LICENCE", "COPYING", "NOTICE", "UNLICENSE"].iter().any(|word| upper.starts_with(word));
        if is_one && entry.path().is_file() {
            let text = fs::read(entry.path()).map(|bytes| String::from_utf8_lossy(&bytes).into_owned());
            found.push((name, text.unwrap_or_default()));
        }
    }
    found.sort();
    found
}

/// Who a crate says that it is by.
fn authors(folder: &Path) -> String {
    let manifest = fs::read_to_string(folder.join("Cargo.toml")).unwrap_or_default();
    let list = manifest.split("\nauthors = [").nth(1).and_then(|rest| rest.split(']').next()).unwrap_or_default();
    let names: Vec<&str> = list.split('"').skip(1).step_by(2).collect();
    names.join(", ")
}

/// The whole file, and crates whose licence it has no words of.
fn notices() -> (String, Vec<Crate>) {
    let (crates, sources) = (crates(), sources());
    let own = |name: &str| fs::read_to_string(root().join(name)).expect("our own licence");
    let (mit, apache) = (own("LICENSE-MIT"), own("LICENSE-APACHE"));
    let mut text =
        "What is built into sinew, and under which licences. Each text stands once, under the first that has it.\n\n"
            .to_owned();
    let mut told: BTreeMap<String, String> = BTreeMap::new();
    let mut without = Vec::new();
    let mut put = |text: &mut String, of: &str, file: &str, words: &str| {
        let plain = words.split_whitespace().collect::<Vec<_>>().join(" ");
        let written = if let Some(first) = told.get(&plain) {
            writeln!(text, "{file}: as of {first}")
        } else {
            told.insert(plain, format!("{of}, {file}"));
            writeln!(text, "{file}:\n\n{}\n", words.trim())
        };
        written.expect("text takes all");
    };
    for (font, of, files) in FONTS {
        let Some(found) = crates.iter().find(|each| each.name == *of) else { continue };
        let folder = &sources[&format!("{}-{}", found.name, found.version)];
        writeln!(text, "== font {font}").expect("text takes all");
        for file in *files {
            let words = fs::read_to_string(folder.join(file)).unwrap_or_else(|error| panic!("{font}, {file}: {error}"));
            put(&mut text, font, file, &words);
        }
    }
    for each in &crates {
        writeln!(text, "== {} {}: {}", each.name, each.version, each.licence).expect("text takes all");
        let folder = &sources[&format!("{}-{}", each.name, each.version)];
        let texts = texts(folder);
        for (file, words) in &texts {
            put(&mut text, &each.name, file, words);
        }
        if texts.is_empty() {
            // It names its licence and brings no text: the words are those of the licence itself.
            let by = authors(folder);
            let by = if by.is_empty() { format!("the authors of {}", each.name) } else { by };
            if each.licence.contains("Apache-2.0") {
                put(&mut text, "sinew", "Apache License 2.0", &apache);
            } else if each.licence == "MIT" {
                let words = mit.split_once("\n\n").map_or(&*mit, |(_, rest)| rest);
                let words = words
                    .split_once("\n\n")
                    .map_or(words, |(first, rest)| if first.starts_with("Copyright") { rest } else { words });
                put(&mut text, &each.name, "MIT License", &format!("Copyright (c) {by}\n\n{words}"));
            } else {
                without.push(each.clone());
            }
        }
    }
    (text, without)
}

#[test]
fn every_crate_and_font_that_is_built_in_has_its_licence_told() {
    let (text, without) = notices();
    assert!(without.is_empty(), "they name a licence and bring no text of it: {without:#?}");
    let crates = crates();
    assert!(crates.len() > 50, "only {} crates", crates.len());
    for each in &crates {
        assert!(text.contains(&format!("\n== {} {}: ", each.name, each.version)), "{each:?}");
    }
    for (font, of, _) in FONTS {
        assert!(!crates.iter().any(|each| each.name == *of) || text.contains(&format!("== font {font}\n")), "{font}");
    }
    if crates.iter().any(|each| each.name == "epaint_default_fonts") {
        // No font is there that nothing is said of.
        assert!(text.contains("UBUNTU FONT LICENCE") && text.contains("SIL OPEN FONT LICENSE"));
        let folder = &sources()[&crates
            .iter()
            .find(|each| each.name == "epaint_default_fonts")
            .map(|each| format!("{}-{}", each.name, each.version))
            .expect("there")];
        let fonts = fs::read_dir(folder.join("fonts")).expect("fonts").flatten();
        let fonts = fonts.filter(|entry| entry.path().extension().is_some_and(|ending| ending == "ttf")).count();
        assert_eq!(fonts, FONTS.len(), "fonts that are told of, and that there are");
    }
    for each in ["MIT License", "Apache License"] {
        assert!(text.contains(each), "{each}");
    }
    if let Some(path) = std::env::var_os(ASKED) {
        fs::write(path, text).expect("written");
    }
}
