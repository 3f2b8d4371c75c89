//! Names of bodies as files and other programs take them: no two alike.

use std::collections::{BTreeMap, BTreeSet};

/// Names made of others by `clean`, those that are alike told apart by numbers behind them, whatever the case of their
/// letters: not every file system knows it.
pub(super) fn different<'a>(names: impl IntoIterator<Item = &'a str>, clean: impl Fn(&str) -> String) -> Vec<String> {
    let (mut taken, mut next) = (BTreeSet::new(), BTreeMap::new());
    let mut found = Vec::new();
    for name in names {
        let mut free = clean(name);
        // Numbers go on where the last of the same name had to stop: thousands may be alike.
        let number = next.entry(free.to_lowercase()).or_insert(2_usize);
        let clean = free.clone();
        while !taken.insert(free.to_lowercase()) {
            free = format!("{clean}_{number}");
            *number += 1;
        }
        found.push(free);
    }
    found
}

/// A name for a file: letters, digits, dashes and underscores.
pub(super) fn file_name(name: &str) -> String {
    let safe = |c: char| if c.is_alphanumeric() || c == '-' { c } else { '_' };
    let name: String = name.trim().chars().take(80).map(safe).collect();
    if name.is_empty() { "body".to_owned() } else { name }
}

/// A name as one word: many readers end a name at the first space, all do at the end of the line.
pub(super) fn word(name: &str) -> String {
    name.chars().map(|c| if c.is_whitespace() || c.is_control() { '_' } else { c }).collect()
}

/// An identifier as USD has them: Latin letters, digits and underscores, no digit first.
pub(super) fn identifier(name: &str) -> String {
    let mut id: String = name.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '_' }).collect();
    if id.is_empty() {
        id.push_str("body");
    } else if id.starts_with(|c: char| c.is_ascii_digit()) {
        id.insert(0, '_');
    }
    id
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_stay_what_they_can_be_and_no_two_are_alike() {
        assert_eq!(different(["Leaf", "leaf", "Leaf_2", "a b/c"], file_name), ["Leaf", "leaf_2", "Leaf_2_2", "a_b_c"]);
        assert_eq!(different(["2 Blätter", "", "x"], identifier), ["_2_Bl_tter", "body", "x"]);
    }
}
