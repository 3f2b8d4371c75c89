//! Lists of values and the combinations that a sweep runs.

use super::CliError;
use super::prepare::Assignment;
use serde::Serialize;
use serde_json::{Map, Value};
use std::str::FromStr;

/// More combinations than this are refused.
const MOST_ROWS: u128 = 100_000;

/// One value of the scene and what it is to be, one after the other.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(super) struct Vary {
    /// RFC 6901 pointer.
    pub pointer: String,
    /// The values.
    pub values: Vec<Value>,
}

impl FromStr for Vary {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let Assignment { pointer, text } = text.parse()?;
        let values: Vec<Value> = serde_json::from_str(&format!("[{text}]"))
            .map_err(|_| format!("`{text}` is no list of JSON values; write 1,2,3, with text in double quotes"))?;
        if values.is_empty() { Err("it has no value".to_owned()) } else { Ok(Self { pointer, values }) }
    }
}

/// Every combination of the values of several lists; the last list varies fastest.
#[derive(Clone, Copy, Debug)]
pub(super) struct Product<'a> {
    lists: &'a [Vary],
    rows: usize,
}

impl<'a> Product<'a> {
    /// The product of `lists`.
    ///
    /// # Errors
    /// A pointer that occurs twice, or more combinations than can be run.
    pub(super) fn of(lists: &'a [Vary]) -> Result<Self, CliError> {
        for (index, list) in lists.iter().enumerate() {
            if lists[..index].iter().any(|other| other.pointer == list.pointer) {
                return Err(CliError::VariedTwice { pointer: list.pointer.clone() });
            }
        }
        let rows = lists.iter().fold(1_u128, |rows, list| rows.saturating_mul(list.values.len() as u128));
        if rows > MOST_ROWS {
            return Err(CliError::TooManyRows { rows, limit: MOST_ROWS });
        }
        Ok(Self { lists, rows: rows as usize })
    }

    /// Number of combinations.
    pub(super) fn rows(&self) -> usize {
        self.rows
    }

    /// Pointers and values of a combination.
    pub(super) fn row(&self, row: usize) -> Vec<(&'a str, &'a Value)> {
        let mut rest = row;
        let mut found: Vec<_> = self
            .lists
            .iter()
            .rev()
            .map(|list| {
                let value = &list.values[rest % list.values.len()];
                rest /= list.values.len();
                (list.pointer.as_str(), value)
            })
            .collect();
        found.reverse();
        found
    }

    /// A combination as assignments.
    pub(super) fn assignments(&self, row: usize) -> Vec<Assignment> {
        let pairs = self.row(row).into_iter();
        pairs.map(|(pointer, value)| Assignment { pointer: pointer.to_owned(), text: value.to_string() }).collect()
    }

    /// A combination as a JSON object.
    pub(super) fn object(&self, row: usize) -> Map<String, Value> {
        self.row(row).into_iter().map(|(pointer, value)| (pointer.to_owned(), value.clone())).collect()
    }

    /// A combination on one line.
    pub(super) fn line(&self, row: usize) -> String {
        let pairs = self.row(row).into_iter().map(|(pointer, value)| format!("{pointer}={value}"));
        pairs.collect::<Vec<_>>().join(", ")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_json_and_may_be_lists_themselves() {
        let vary: Vary = "/gravity=[0,-9.81,0],[0,0,0]".parse().unwrap();
        assert_eq!(vary.values, [serde_json::json!([0, -9.81, 0]), serde_json::json!([0, 0, 0])]);
        for bad in ["/a", "/a=", "/a=1,", "/a=x", "/a=1],[2"] {
            assert!(bad.parse::<Vary>().is_err(), "{bad}");
        }
    }

    #[test]
    fn the_last_list_varies_fastest() {
        let lists: [Vary; 2] = ["/a=1,2".parse().unwrap(), "/b=3,4,5".parse().unwrap()];
        let product = Product::of(&lists).unwrap();
        let lines: Vec<String> = (0..product.rows()).map(|row| product.line(row)).collect();
        assert_eq!(lines, ["/a=1, /b=3", "/a=1, /b=4", "/a=1, /b=5", "/a=2, /b=3", "/a=2, /b=4", "/a=2, /b=5"]);
    }

    #[test]
    fn too_many_and_repeated_lists_are_refused() {
        let long: Vary = format!("/a={}", ["1"; 1000].join(",")).parse().unwrap();
        let lists: Vec<Vary> = ["/a", "/b"].map(|name| Vary { pointer: name.to_owned(), ..long.clone() }).to_vec();
        assert!(matches!(Product::of(&lists), Err(CliError::TooManyRows { rows: 1_000_000, .. })));
        assert!(matches!(Product::of(&[long.clone(), long]), Err(CliError::VariedTwice { .. })));
    }
}
