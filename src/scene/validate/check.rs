//! The questions that validation asks of a value, each a function of a place and a value.

use super::{SceneError, brief};
use serde::Serialize;
use std::collections::BTreeSet;
use std::fmt;

/// What a check finds.
pub(super) type Checked = Result<(), SceneError>;

/// Greatest magnitude of any number. Products of a few such numbers stay finite in f64, and nothing that can be
/// simulated here comes near it.
const LARGEST: f64 = 1e15;

/// Least value of a number that must be above zero, so that its powers and quotients stay finite too.
const SMALLEST: f64 = 1e-15;

/// A place in the document, kept on the stack: pointers are spelt out for errors only.
#[derive(Clone, Copy)]
pub(super) struct At<'a> {
    parent: Option<&'a At<'a>>,
    step: Step<'a>,
}

#[derive(Clone, Copy)]
enum Step<'a> {
    Field(&'a str),
    Item(usize),
}

impl At<'_> {
    /// The whole document.
    pub(super) const ROOT: At<'static> = At { parent: None, step: Step::Item(0) };

    /// A member of the object here. Names are those of the document's own fields, which need no escaping.
    pub(super) fn field<'b>(&'b self, name: &'b str) -> At<'b> {
        At { parent: Some(self), step: Step::Field(name) }
    }

    /// An item of the array here.
    pub(super) fn item(&self, index: usize) -> At<'_> {
        At { parent: Some(self), step: Step::Item(index) }
    }
}

impl fmt::Display for At<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Some(parent) = self.parent else { return Ok(()) };
        write!(f, "{parent}/")?;
        match self.step {
            Step::Field(name) => f.write_str(name),
            Step::Item(index) => write!(f, "{index}"),
        }
    }
}

/// Fails unless `holds`. The remedy is made only then.
pub(super) fn require<V: Serialize, R: Into<String>>(
    at: &At<'_>,
    value: &V,
    holds: bool,
    problem: &str,
    remedy: impl FnOnce() -> R,
) -> Checked {
    if holds { Ok(()) } else { fail(at, brief(value), problem, remedy()) }
}

/// [`require`] for a number.
fn require_number(at: &At<'_>, value: f64, holds: bool, problem: &str, remedy: impl FnOnce() -> String) -> Checked {
    if holds { Ok(()) } else { fail(at, number(value), problem, remedy()) }
}

fn fail(at: &At<'_>, value: String, problem: &str, remedy: impl Into<String>) -> Checked {
    Err(SceneError { path: at.to_string(), value, problem: problem.to_owned(), remedy: remedy.into() })
}

/// A number as people write it. JSON has no spelling for non-finite ones, which a program can still put in a scene.
pub(super) fn number(value: f64) -> String {
    let is_plain = value == 0.0 || (1e-4..1e7).contains(&value.abs());
    if is_plain { value.to_string() } else { format!("{value:e}") }
}

/// A remedy with a unit, which may be none.
fn give(what: &str, unit: &str) -> String {
    format!("give a number {what} {unit}").trim_end().to_owned()
}

/// A number from `least` to `most`.
pub(super) fn within(at: &At<'_>, value: f64, least: f64, most: f64, unit: &str) -> Checked {
    require_number(at, value, (least..=most).contains(&value), "is out of range", || {
        give(&format!("from {} to {}", number(least), number(most)), unit)
    })
}

/// Any number of a sensible magnitude.
pub(super) fn finite(at: &At<'_>, value: f64, unit: &str) -> Checked {
    within(at, value, -LARGEST, LARGEST, unit)
}

/// A number above zero.
pub(super) fn positive(at: &At<'_>, value: f64, unit: &str) -> Checked {
    require_number(at, value, value > 0.0 || value.is_nan(), "is not above zero", || give("above 0", unit))?;
    within(at, value, SMALLEST, LARGEST, unit)
}

/// Zero or a number above it.
pub(super) fn not_negative(at: &At<'_>, value: f64, unit: &str) -> Checked {
    within(at, value, 0.0, LARGEST, unit)
}

/// A share of a whole.
pub(super) fn fraction(at: &At<'_>, value: f64) -> Checked {
    within(at, value, 0.0, 1.0, "")
}

/// The greater of two bounds.
pub(super) fn ordered(at: &At<'_>, least: f64, greatest: f64, least_is: &str) -> Checked {
    require_number(at, greatest, least < greatest, "leaves no room", || format!("give a number above {least_is}"))
}

/// A vector or point of finite components.
pub(super) fn vector(at: &At<'_>, value: &[f64], unit: &str) -> Checked {
    value.iter().enumerate().try_for_each(|(index, &component)| finite(&at.item(index), component, unit))
}

/// A vector that points somewhere.
pub(super) fn direction(at: &At<'_>, value: &[f64; 3]) -> Checked {
    vector(at, value, "")?;
    let points = value.iter().any(|component| component.abs() >= SMALLEST);
    require(at, value, points, "points nowhere", || "give a vector of any length but zero, such as [0, 1, 0]")
}

/// Times that start at 0 or later and increase.
pub(super) fn increasing(at: &At<'_>, times: impl ExactSizeIterator<Item = f64>) -> Checked {
    require(at, &[(); 0], times.len() > 0, "has no keys", || "give one key at least")?;
    let mut last = None;
    for (index, time) in times.enumerate() {
        let item = at.item(index);
        let at = item.field("time");
        not_negative(&at, time, "s")?;
        if let Some(last) = last {
            require_number(&at, time, time > last, "does not come after the key before it", || {
                format!("give keys in order of time, this one above {} s", number(last))
            })?;
        }
        last = Some(time);
    }
    Ok(())
}

/// The identifiers met in one scope.
pub(super) struct Ids<'a> {
    what: &'static str,
    seen: BTreeSet<&'a str>,
}

impl<'a> Ids<'a> {
    /// A scope without identifiers as yet; `what` names the things in it.
    pub(super) fn of(what: &'static str) -> Self {
        Self { what, seen: BTreeSet::new() }
    }

    /// Takes up an identifier, which must not be empty or taken.
    pub(super) fn add(&mut self, at: &At<'_>, id: &'a str) -> Checked {
        require(at, &id, !id.trim().is_empty(), "names nothing", || "give a name that is not empty")?;
        let problem = format!("is taken by another {}", self.what);
        require(at, &id, self.seen.insert(id), &problem, || format!("give each {} a name of its own", self.what))
    }

    /// An identifier that refers to one of these.
    pub(super) fn resolve(&self, at: &At<'_>, id: &str) -> Checked {
        const SHOWN: usize = 8;
        require(at, &id, self.seen.contains(id), &format!("is no {} that it can refer to", self.what), || {
            if self.seen.is_empty() {
                return format!("add a {} with this name first", self.what);
            }
            let known: Vec<_> = self.seen.iter().take(SHOWN).map(brief).collect();
            let more = if self.seen.len() > SHOWN { ", ..." } else { "" };
            format!("use one of {}{more}", known.join(", "))
        })
    }
}
