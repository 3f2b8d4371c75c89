//! Text as exporters write it: with or without a byte order mark, in UTF-8, UTF-16 or Latin-1, with lines that end as
//! on any system, and numbers as C, Fortran and spreadsheets print them.

use super::limits::LONGEST_NAME;
use std::borrow::Cow;

/// Characters of a line that a message repeats, at most.
const SHOWN: usize = 60;

/// The bytes without a byte order mark, and UTF-16 as UTF-8.
pub(super) fn without_mark(bytes: &[u8]) -> Cow<'_, [u8]> {
    let wide = |bytes: &[u8], unit: fn([u8; 2]) -> u16| {
        let units = bytes.as_chunks().0.iter().map(|&pair| unit(pair));
        let text: String = char::decode_utf16(units).map(|c| c.unwrap_or(char::REPLACEMENT_CHARACTER)).collect();
        Cow::Owned(text.into_bytes())
    };
    match bytes {
        [0xef, 0xbb, 0xbf, rest @ ..] => Cow::Borrowed(rest),
        [0xff, 0xfe, rest @ ..] => wide(rest, u16::from_le_bytes),
        [0xfe, 0xff, rest @ ..] => wide(rest, u16::from_be_bytes),
        _ => Cow::Borrowed(bytes),
    }
}

/// Lines with their numbers, from 1, without what ends them: `\n`, `\r\n` or `\r`.
#[derive(Clone, Debug)]
pub(super) struct Lines<'a> {
    rest: Option<&'a [u8]>,
    number: usize,
}

impl<'a> Lines<'a> {
    pub(super) fn new(text: &'a [u8]) -> Self {
        Self { rest: (!text.is_empty()).then_some(text), number: 0 }
    }

    /// What has not been read yet.
    pub(super) fn rest(&self) -> &'a [u8] {
        self.rest.unwrap_or_default()
    }
}

impl<'a> Iterator for Lines<'a> {
    type Item = (usize, &'a [u8]);

    fn next(&mut self) -> Option<Self::Item> {
        let text = self.rest?;
        self.number += 1;
        let Some(end) = text.iter().position(|&byte| byte == b'\n' || byte == b'\r') else {
            self.rest = None;
            return Some((self.number, text));
        };
        let behind = end + if text[end..].starts_with(b"\r\n") { 2 } else { 1 };
        self.rest = (behind < text.len()).then_some(&text[behind..]);
        Some((self.number, &text[..end]))
    }
}

/// The words of a line.
pub(super) fn words(line: &[u8]) -> impl Iterator<Item = &[u8]> {
    line.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty())
}

/// What a word says as a number; NaN for what stands for none, as C prints it on any system.
pub(super) fn number(word: &[u8]) -> Option<f64> {
    let text = str::from_utf8(word).ok()?;
    text.parse().ok().or_else(|| unusual(text))
}

fn unusual(text: &str) -> Option<f64> {
    let low = text.trim_start_matches(['+', '-']).to_ascii_lowercase();
    // Older runtimes of C print `1.#IND` and `1.#QNAN`, newer ones `-nan(ind)`.
    if low.starts_with("nan") || low.contains(".#ind") || low.contains("nan") && low.contains(".#") {
        return Some(f64::NAN);
    }
    if low.contains(".#inf") {
        return Some(if text.starts_with('-') { f64::NEG_INFINITY } else { f64::INFINITY });
    }
    // Fortran's double precision has an exponent of its own.
    (low.contains('d')).then(|| text.replace(['d', 'D'], "e").parse().ok()).flatten()
}

/// Bytes as text for people: what is not UTF-8 is taken for Latin-1.
pub(super) fn decoded(bytes: &[u8]) -> String {
    match str::from_utf8(bytes) {
        Ok(text) => text.to_owned(),
        Err(_) => bytes.iter().map(|&byte| char::from(byte)).collect(),
    }
}

/// Bytes as a name, whose end goes where it is longer than any is meant to be.
pub(super) fn named(bytes: &[u8]) -> String {
    shortened(&decoded(bytes))
}

/// A name without its end where it is longer than any is meant to be.
pub(super) fn shortened(name: &str) -> String {
    let end = name.char_indices().nth(LONGEST_NAME).map_or(name.len(), |(end, _)| end);
    name[..end].to_owned()
}

/// A line as a message shows it.
pub(super) fn shown(line: &[u8]) -> String {
    let line = line.trim_ascii();
    // Of a long one enough, up to a whole character.
    let enough = line.len().min(4 * SHOWN + 4);
    let cut_through = str::from_utf8(&line[..enough]).err().filter(|error| error.error_len().is_none());
    let end = cut_through.map_or(enough, |error| error.valid_up_to());
    let text = decoded(&line[..if enough < line.len() { end } else { enough }]);
    if text.chars().count() <= SHOWN { text } else { text.chars().take(SHOWN).chain("...".chars()).collect() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_end_as_on_any_system_and_are_counted() {
        for text in ["a\n\nb\n", "a\r\n\r\nb\r\n", "a\r\rb\r", "a\n\nb"] {
            let lines: Vec<_> = Lines::new(text.as_bytes()).collect();
            assert_eq!(lines, [(1, b"a".as_slice()), (2, b""), (3, b"b")], "{text:?}");
        }
        assert_eq!(Lines::new(b"").next(), None);
    }

    #[test]
    fn numbers_come_as_many_programs_print_them() {
        for (text, value) in [("2.", 2.0), (".5", 0.5), ("+1e-3", 1e-3), ("2.0D0", 2.0), ("1d-2", 0.01)] {
            assert_eq!(number(text.as_bytes()), Some(value), "{text}");
        }
        for text in ["nan", "-nan(ind)", "1.#IND", "-1.#QNAN", "NaN"] {
            assert!(number(text.as_bytes()).is_some_and(f64::is_nan), "{text}");
        }
        for text in ["-inf", "-1.#INF"] {
            assert_eq!(number(text.as_bytes()), Some(f64::NEG_INFINITY), "{text}");
        }
        for text in ["2,0", "x", "", "1/2", "dd", "\u{ff}"] {
            assert_eq!(number(text.as_bytes()), None, "{text}");
        }
    }

    #[test]
    fn text_is_read_in_whatever_encoding() {
        let units: Vec<u16> = "v \u{fc}".encode_utf16().collect();
        let little: Vec<u8> = [0xfeff].iter().chain(&units).flat_map(|u| u16::to_le_bytes(*u)).collect();
        let big: Vec<u8> = [0xfeff].iter().chain(&units).flat_map(|u| u16::to_be_bytes(*u)).collect();
        for bytes in [little.as_slice(), big.as_slice(), "\u{feff}v \u{fc}".as_bytes(), "v \u{fc}".as_bytes()] {
            assert_eq!(decoded(&without_mark(bytes)), "v \u{fc}");
        }
        assert_eq!(decoded(b"v \xfc"), "v \u{fc}");
    }
}
