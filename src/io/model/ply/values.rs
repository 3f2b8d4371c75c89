//! The values of a PLY file one after another, from text or bytes, exactly.

use super::super::failure::Failure;
use super::super::text::{Lines, number, shown, words};
use super::header::{Element, Encoding, Header, Property, Scalar};

/// Where the next value comes from.
pub(super) enum Values<'a> {
    Text(TextValues<'a>),
    Bytes { rest: &'a [u8], big: bool },
}

/// Words of lines; an element begins a line.
pub(super) struct TextValues<'a> {
    lines: Lines<'a>,
    before: usize,
    line: &'a [u8],
    number: usize,
    words: Vec<&'a [u8]>,
    next: usize,
}

/// The value that is read: of which property, of which one of how many elements.
#[derive(Clone, Copy)]
pub(super) struct Place<'a> {
    pub(super) element: &'a Element,
    /// From 0.
    pub(super) index: usize,
    pub(super) property: &'a Property,
}

impl Place<'_> {
    fn words(&self) -> String {
        let Element { name, count, .. } = self.element;
        format!("`{}` of {name} {} of {count}", self.property.name, self.index + 1)
    }
}

impl<'a> Values<'a> {
    pub(super) fn new(header: &Header, body: &'a [u8]) -> Self {
        match header.encoding {
            Encoding::Text => Self::Text(TextValues {
                lines: Lines::new(body),
                before: header.lines,
                line: &[],
                number: header.lines,
                words: Vec::new(),
                next: 0,
            }),
            encoding => Self::Bytes { rest: body, big: encoding == Encoding::BigEndian },
        }
    }

    /// The next value. Every type but the greatest integers is exact in f64, and those are too: none has over 32 bits.
    pub(super) fn next(&mut self, scalar: Scalar, place: &Place<'_>) -> Result<f64, Failure> {
        match self {
            Self::Text(text) => text.next(scalar, place),
            Self::Bytes { rest, big } => match rest.split_at_checked(scalar.size()) {
                Some((bytes, behind)) => {
                    *rest = behind;
                    Ok(from_bytes(scalar, bytes, *big))
                }
                None => Err(cut(place)),
            },
        }
    }

    /// The length of a list.
    pub(super) fn length(&mut self, scalar: Scalar, place: &Place<'_>) -> Result<usize, Failure> {
        let length = self.next(scalar, place)?;
        let most = match self {
            // A value takes a digit and a space at least.
            Self::Text(text) => text.words.len() + text.lines.rest().len() / 2 + 1,
            Self::Bytes { rest, .. } => rest.len() / place.property.scalar.size(),
        };
        if length < 0.0 || length.fract() != 0.0 {
            return Err(self.fail(place, format_args!("{length} is no length of a list")));
        }
        if length > most as f64 {
            return Err(cut(place));
        }
        Ok(length as usize)
    }

    /// Ends an element: its last value ends a line of text.
    pub(super) fn end(&mut self, element: &Element, index: usize) -> Result<(), Failure> {
        let Self::Text(text) = self else { return Ok(()) };
        if text.next < text.words.len() {
            let problem = format!(
                "{} values are left where {} {} of {} ends",
                text.words.len() - text.next,
                element.name,
                index + 1,
                element.count
            );
            return Err(Failure::in_line(text.number, &shown(text.line), problem));
        }
        Ok(())
    }

    /// Something wrong with the value that was read last.
    pub(super) fn fail(&self, place: &Place<'_>, problem: impl std::fmt::Display) -> Failure {
        match self {
            Self::Text(text) => {
                Failure::in_line(text.number, &shown(text.line), format_args!("{}: {problem}", place.words()))
            }
            Self::Bytes { .. } => Failure::new(format_args!("{}: {problem}", place.words())),
        }
    }
}

impl TextValues<'_> {
    fn next(&mut self, scalar: Scalar, place: &Place<'_>) -> Result<f64, Failure> {
        while self.next == self.words.len() {
            let Some((number, line)) = self.lines.next() else { return Err(cut(place)) };
            (self.line, self.number, self.next) = (line, self.before + number, 0);
            self.words.clear();
            self.words.extend(words(line));
        }
        let word = self.words[self.next];
        self.next += 1;
        from_text(scalar, word).ok_or_else(|| {
            let problem = format!("`{}`, which is {}, is not a number", shown(word), place.words());
            Failure::in_line(self.number, &shown(self.line), problem)
        })
    }
}

/// The file ends too early.
fn cut(place: &Place<'_>) -> Failure {
    let Element { name, count, .. } = place.element;
    let missing = count - place.index;
    Failure::new(format_args!("it is cut off at {}: {missing} of {count} are missing (element {name})", place.words()))
}

fn from_text(scalar: Scalar, word: &[u8]) -> Option<f64> {
    let text = str::from_utf8(word).ok();
    let exact = match scalar {
        Scalar::F64 => None,
        Scalar::F32 => text.and_then(|text| text.parse::<f32>().ok()).map(f64::from),
        _ => text.and_then(|text| text.parse::<i64>().ok()).map(|value| value as f64),
    };
    exact.or_else(|| number(word))
}

fn from_bytes(scalar: Scalar, bytes: &[u8], big: bool) -> f64 {
    let mut wide = [0; 8];
    // Least significant byte first.
    let places = wide.iter_mut();
    if big {
        places.zip(bytes.iter().rev()).for_each(|(place, byte)| *place = *byte);
    } else {
        places.zip(bytes).for_each(|(place, byte)| *place = *byte);
    }
    let bits = u64::from_le_bytes(wide);
    match scalar {
        Scalar::I8 => f64::from(bits as i8),
        Scalar::U8 => f64::from(bits as u8),
        Scalar::I16 => f64::from(bits as i16),
        Scalar::U16 => f64::from(bits as u16),
        Scalar::I32 => f64::from(bits as i32),
        Scalar::U32 => f64::from(bits as u32),
        Scalar::F32 => f64::from(f32::from_bits(bits as u32)),
        Scalar::F64 => f64::from_bits(bits),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_type_is_read_exactly_in_either_order() {
        let cases: [(Scalar, Vec<u8>, f64); 8] = [
            (Scalar::I8, (-3_i8).to_le_bytes().into(), -3.0),
            (Scalar::U8, 200_u8.to_le_bytes().into(), 200.0),
            (Scalar::I16, (-300_i16).to_le_bytes().into(), -300.0),
            (Scalar::U16, 60_000_u16.to_le_bytes().into(), 60_000.0),
            (Scalar::I32, (-16_777_217_i32).to_le_bytes().into(), -16_777_217.0),
            (Scalar::U32, u32::MAX.to_le_bytes().into(), 4_294_967_295.0),
            (Scalar::F32, 0.1_f32.to_le_bytes().into(), f64::from(0.1_f32)),
            (Scalar::F64, 0.1_f64.to_le_bytes().into(), 0.1),
        ];
        for (scalar, little, value) in cases {
            assert_eq!(little.len(), scalar.size());
            assert_eq!(from_bytes(scalar, &little, false), value, "{scalar:?}");
            let big: Vec<u8> = little.iter().rev().copied().collect();
            assert_eq!(from_bytes(scalar, &big, true), value, "{scalar:?}");
            assert_eq!(from_text(scalar, value.to_string().as_bytes()), Some(value), "{scalar:?}");
        }
    }
}
