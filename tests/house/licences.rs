//! Every crate that is built into the program has a licence that `.deny.toml` allows.

use std::path::Path;
use std::process::Command;

/// The entries of a list of strings in a TOML file, of which each stands in a line of its own.
fn list(toml: &str, table: &str, key: &str) -> Vec<String> {
    let lines = toml.lines().map(str::trim).skip_while(|line| *line != format!("[{table}]"));
    let entries = lines.skip_while(|line| *line != format!("{key} = [")).skip(1).take_while(|line| *line != "]");
    entries.map(|line| line.trim_matches([',', '"']).to_owned()).collect()
}

/// Whether an SPDX expression can be satisfied by licences that are allowed. `A/B`, an older way to write, is a choice.
fn is_allowed(expression: &str, allowed: &[String]) -> bool {
    let spaced = expression.replace('/', " OR ").replace('(', " ( ").replace(')', " ) ");
    let words: Vec<&str> = spaced.split_whitespace().collect();
    let mut at = 0;
    let met = any(&words, &mut at, allowed);
    met && at == words.len()
}

fn any(words: &[&str], at: &mut usize, allowed: &[String]) -> bool {
    let mut met = all(words, at, allowed);
    while words.get(*at) == Some(&"OR") {
        *at += 1;
        met |= all(words, at, allowed);
    }
    met
}

fn all(words: &[&str], at: &mut usize, allowed: &[String]) -> bool {
    let mut met = one(words, at, allowed);
    while words.get(*at) == Some(&"AND") {
        *at += 1;
        met &= one(words, at, allowed);
    }
    met
}

fn one(words: &[&str], at: &mut usize, allowed: &[String]) -> bool {
    let Some(word) = words.get(*at) else { return false };
    *at += 1;
    if *word == "(" {
        let met = any(words, at, allowed);
        let closed = words.get(*at) == Some(&")");
        *at += 1;
        return met && closed;
    }
    let mut name = (*word).to_owned();
    if words.get(*at) == Some(&"WITH") {
        name = format!("{name} WITH {}", words.get(*at + 1).unwrap_or(&""));
        *at += 2;
    }
    allowed.contains(&name)
}

/// What these tests were built with: only that is sure to be here without a network.
pub fn features() -> &'static [&'static str] {
    match (cfg!(feature = "gui"), cfg!(feature = "render")) {
        (true, _) => &[],
        (false, true) => &["--no-default-features", "--features", "render"],
        (false, false) => &["--no-default-features"],
    }
}

#[test]
fn every_crate_has_a_licence_that_is_allowed() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let rules = std::fs::read_to_string(root.join(".deny.toml")).expect("the rules can be read");
    let allowed = list(&rules, "licenses", "allow");
    assert!(allowed.iter().any(|licence| licence == "MIT"), "{allowed:?}");
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let tree = Command::new(cargo)
        .args(["tree", "--locked", "--offline", "--edges", "normal,build", "--prefix", "none"])
        .args(["--format", "{l}\t{p}"])
        .args(features())
        .current_dir(root)
        .output()
        .expect("cargo can be run");
    assert!(tree.status.success(), "{}", String::from_utf8_lossy(&tree.stderr));
    let mut crates: Vec<&str> = std::str::from_utf8(&tree.stdout).expect("text").lines().collect();
    crates.sort_unstable();
    crates.dedup();
    assert!(crates.len() > 50, "only {} crates are listed", crates.len());
    let refused: Vec<&&str> =
        crates.iter().filter(|line| !is_allowed(line.split('\t').next().unwrap_or_default(), &allowed)).collect();
    assert!(refused.is_empty(), "licences that .deny.toml does not allow: {refused:#?}");
}

#[test]
fn expressions_of_licences_are_read() {
    let allowed = ["MIT", "Zlib", "Apache-2.0 WITH LLVM-exception"].map(str::to_owned);
    for (expression, expected) in [
        ("MIT", true),
        ("GPL-3.0-only", false),
        ("MIT OR GPL-3.0-only", true),
        ("GPL-3.0-only/MIT", true),
        ("MIT AND GPL-3.0-only", false),
        ("MIT AND Zlib", true),
        ("(GPL-3.0-only OR MIT) AND Zlib", true),
        ("(GPL-3.0-only OR MIT) AND ISC", false),
        ("GPL-3.0-only OR MIT AND Zlib", true),
        ("GPL-3.0-only OR MIT AND ISC", false),
        ("Apache-2.0 WITH LLVM-exception", true),
        ("Apache-2.0", false),
        ("(MIT", false),
        ("MIT)", false),
        ("", false),
    ] {
        assert_eq!(is_allowed(expression, &allowed), expected, "{expression}");
    }
}
