//! JSON text to a value tree, with the place of what is wrong and no member lost.

use super::IoError;
use crate::scene::{brief, one_line};
use serde::de::{Deserialize, Deserializer, Error, MapAccess, SeqAccess, Visitor};
use serde_json::{Map, Number, Value};
use std::borrow::Cow;
use std::fmt;

/// Reads JSON text.
///
/// # Errors
/// Text that is not JSON, nests deeper than 128 levels, has a number beyond f64 or the same member twice.
pub(super) fn parse(text: &str) -> Result<Value, IoError> {
    // Some editors begin a file with a byte order mark; RFC 8259 lets a reader pass over it.
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let (needed, most) = (memory_of(text.as_bytes()), 10 * text.len() as u64 + FREE);
    if needed > most {
        return Err(IoError::TooManyValues { bytes: text.len(), megabytes: needed >> 20, most: most >> 20 });
    }
    let mut source = serde_json::Deserializer::from_str(text);
    let parsed: Result<Strict, _> = serde_path_to_error::deserialize(&mut source);
    let (error, path) = match parsed {
        Ok(Strict(value)) => match source.end() {
            Ok(()) => return Ok(value),
            Err(error) => (error, String::new()),
        },
        Err(error) => {
            let path = pointer_of(error.path());
            (error.into_inner(), path)
        }
    };
    let (line, column, mut problem) = place_and_problem(&error);
    let token = token(text, line, column);
    if !token.is_empty() && !problem.contains(&token) {
        problem = format!("{problem} near `{token}`");
    }
    Err(IoError::Syntax { line, column, path, problem })
}

/// Memory that a text's values may take beside ten times its length [bytes].
const FREE: u64 = 64 << 20;

/// About the memory that a text takes as values [bytes], at the time when a list grows, without reading any of them.
fn memory_of(text: &[u8]) -> u64 {
    /// A value in its list, with the room that the list keeps for more; a list's first four values; a leaf of the tree
    /// of an object's members; a member's name.
    const COSTS: [u64; 4] = [64, 160, 680, 40];
    let [value, list, object, name] = COSTS;
    let (mut bytes, mut at) = (text.len() as u64, 0);
    while let Some(&byte) = text.get(at) {
        at += 1;
        match byte {
            b'"' => {
                while let Some(&byte) = text.get(at) {
                    at += if byte == b'\\' { 2 } else { 1 };
                    if byte == b'"' {
                        break;
                    }
                }
            }
            b',' => bytes += value,
            b':' => bytes += name,
            // Empty ones take no room of their own.
            b'[' if text.get(at) != Some(&b']') => bytes += list,
            b'{' if text.get(at) != Some(&b'}') => bytes += object,
            _ => {}
        }
    }
    bytes
}

/// Line, column and what is wrong there, on one line.
pub(super) fn place_and_problem(error: &serde_json::Error) -> (usize, usize, String) {
    let (line, column, message) = (error.line(), error.column(), error.to_string());
    let place = format!(" at line {line} column {column}");
    (line, column, one_line(message.strip_suffix(&place).unwrap_or(&message)))
}

/// The RFC 6901 pointer of a path, as far as it is known.
pub(super) fn pointer_of(path: &serde_path_to_error::Path) -> String {
    use serde_path_to_error::Segment;
    let tokens = path.iter().map_while(|segment| match segment {
        Segment::Seq { index } => Some(format!("/{index}")),
        Segment::Map { key: name } | Segment::Enum { variant: name } => Some(format!("/{}", escape(name))),
        Segment::Unknown => None,
    });
    tokens.collect()
}

/// A member's name as a token of an RFC 6901 pointer, on one line.
pub(super) fn escape(name: &str) -> String {
    one_line(&name.replace('~', "~0").replace('/', "~1"))
}

/// The tokens of a pointer, unescaped.
pub(super) fn pointer_tokens(pointer: &str) -> impl Iterator<Item = Cow<'_, str>> {
    pointer.split('/').skip(1).map(|token| {
        if token.contains('~') { Cow::Owned(token.replace("~1", "/").replace("~0", "~")) } else { Cow::Borrowed(token) }
    })
}

/// The run of characters that ends at, or surrounds, the place of an error.
fn token(text: &str, line: usize, column: usize) -> String {
    const LONGEST: usize = 30;
    let Some(line) = line.checked_sub(1).and_then(|index| text.split('\n').nth(index)) else { return String::new() };
    let breaks = |byte: u8| byte.is_ascii_whitespace() || b",:[]{}\"".contains(&byte);
    let bytes = line.as_bytes();
    // Columns count bytes and may point one past the last byte that was read.
    let at = column.saturating_sub(1).min(bytes.len());
    let start = bytes[..at].iter().rposition(|&byte| breaks(byte)).map_or(0, |before| before + 1);
    let end = bytes[at..].iter().position(|&byte| breaks(byte)).map_or(bytes.len(), |length| at + length);
    let run = String::from_utf8_lossy(&bytes[start..end]);
    one_line(&run.chars().take(LONGEST).collect::<String>())
}

/// A value tree in whose objects every member occurs once: of two with one name, serde's own would drop the first.
struct Strict(Value);

impl<'de> Deserialize<'de> for Strict {
    fn deserialize<D: Deserializer<'de>>(source: D) -> Result<Self, D::Error> {
        source.deserialize_any(StrictVisitor).map(Strict)
    }
}

struct StrictVisitor;

impl<'de> Visitor<'de> for StrictVisitor {
    type Value = Value;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a JSON value")
    }

    fn visit_unit<E>(self) -> Result<Value, E> {
        Ok(Value::Null)
    }

    fn visit_bool<E>(self, value: bool) -> Result<Value, E> {
        Ok(Value::Bool(value))
    }

    fn visit_i64<E>(self, value: i64) -> Result<Value, E> {
        Ok(Value::from(value))
    }

    fn visit_u64<E>(self, value: u64) -> Result<Value, E> {
        Ok(Value::from(value))
    }

    fn visit_f64<E: Error>(self, value: f64) -> Result<Value, E> {
        Number::from_f64(value).map(Value::Number).ok_or_else(|| E::custom("number out of range"))
    }

    fn visit_str<E>(self, value: &str) -> Result<Value, E> {
        Ok(Value::from(value))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut items: A) -> Result<Value, A::Error> {
        let mut array = Vec::new();
        while let Some(Strict(item)) = items.next_element()? {
            array.push(item);
        }
        Ok(Value::Array(array))
    }

    fn visit_map<A: MapAccess<'de>>(self, mut members: A) -> Result<Value, A::Error> {
        let mut object = Map::new();
        while let Some((name, Strict(value))) = members.next_entry::<String, _>()? {
            let twice = object.insert(name.clone(), value).is_some();
            if twice {
                return Err(A::Error::custom(format_args!("the member {} is there twice", brief(&name))));
            }
        }
        Ok(Value::Object(object))
    }
}
