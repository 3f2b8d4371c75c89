//! What is written for those who work on it names files that are there.

use std::fs;
use std::path::Path;

#[test]
fn every_path_that_the_guide_names_is_there() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let guide = fs::read_to_string(root.join(".github/CONTRIBUTING.md")).expect("the guide can be read");
    // Every second piece stands between two backticks.
    let quoted: Vec<&str> = guide.split('`').skip(1).step_by(2).collect();
    let is_path = |text: &&&str| {
        let first = text.split('/').next().unwrap_or_default();
        ["src", "tests", "scenes", "assets", ".ci", ".github"].contains(&first) && !text.contains(char::is_whitespace)
    };
    let paths: Vec<&&str> = quoted.iter().filter(is_path).collect();
    assert!(paths.len() > 20, "only {} paths are named", paths.len());
    let gone: Vec<&&&str> = paths.iter().filter(|path| !root.join(path).exists()).collect();
    assert!(gone.is_empty(), "the guide names what is not there: {gone:?}");
}
