//! The error of a scene that cannot be used, and how values are shown in it.

use serde::Serialize;
use thiserror::Error;

/// A value in a scene that cannot be used. Its message is one line.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("{}: {value} {problem}; {remedy}", place(path))]
pub struct SceneError {
    /// RFC 6901 pointer to the value; empty for the scene itself.
    pub path: String,
    /// The value as JSON, cut where it is long.
    pub value: String,
    /// What is wrong with it.
    pub problem: String,
    /// What to do.
    pub remedy: String,
}

/// A pointer as a person reads it: the whole document has an empty one.
fn place(path: &str) -> &str {
    if path.is_empty() { "the scene" } else { path }
}

/// A value as JSON on one line of at most about 60 characters; non-finite numbers, which JSON lacks, by their names.
pub(crate) fn brief<T: Serialize>(value: &T) -> String {
    const LONGEST: usize = 60;
    let text = serde_json::to_string(value).unwrap_or_else(|_| "this".to_owned());
    let text = one_line(&text);
    if text.chars().count() <= LONGEST { text } else { text.chars().take(LONGEST - 3).collect::<String>() + "..." }
}

/// Text with line breaks and other control characters escaped, so that a message stays one line.
pub(crate) fn one_line(text: &str) -> String {
    let breaks = |c: char| c.is_control() || matches!(c, '\u{2028}' | '\u{2029}');
    text.chars().flat_map(|c| if breaks(c) { c.escape_default().collect() } else { vec![c] }).collect()
}
