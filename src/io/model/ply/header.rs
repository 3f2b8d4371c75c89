//! The header of a PLY file: which elements follow, of which properties.

use super::super::failure::Failure;
use super::super::text::{Lines, decoded, shown, words};

/// How values are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Encoding {
    Text,
    LittleEndian,
    BigEndian,
}

/// Types of values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Scalar {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

impl Scalar {
    fn of(name: &[u8]) -> Option<Self> {
        Some(match name {
            b"char" | b"int8" => Self::I8,
            b"uchar" | b"uint8" => Self::U8,
            b"short" | b"int16" => Self::I16,
            b"ushort" | b"uint16" => Self::U16,
            b"int" | b"int32" => Self::I32,
            b"uint" | b"uint32" => Self::U32,
            b"float" | b"float32" => Self::F32,
            b"double" | b"float64" => Self::F64,
            _ => return None,
        })
    }

    /// Bytes of a value.
    pub(super) fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::F64 => 8,
        }
    }
}

/// One value of each element, or a list of them.
#[derive(Clone, Debug)]
pub(super) struct Property {
    pub(super) name: String,
    /// Type of the number of values; none where there is one.
    pub(super) count: Option<Scalar>,
    pub(super) scalar: Scalar,
}

/// A table of the file.
#[derive(Clone, Debug)]
pub(super) struct Element {
    pub(super) name: String,
    pub(super) count: usize,
    pub(super) properties: Vec<Property>,
}

/// What the header says.
#[derive(Clone, Debug)]
pub(super) struct Header {
    pub(super) encoding: Encoding,
    pub(super) elements: Vec<Element>,
    /// Lines of the header.
    pub(super) lines: usize,
}

impl Header {
    /// Reads a header; returns what follows it.
    pub(super) fn read(bytes: &[u8]) -> Result<(Self, &[u8]), Failure> {
        let mut lines = Lines::new(bytes);
        if lines.next().is_none_or(|(_, line)| line.trim_ascii() != b"ply") {
            return Err(Failure::new("its first line is not `ply`"));
        }
        let (mut encoding, mut elements) = (None, Vec::<Element>::new());
        for (number, line) in lines.by_ref() {
            let fail = |problem: &str| Failure::in_line(number, &shown(line), problem);
            let mut words = words(line);
            match words.next().unwrap_or_default() {
                b"format" => {
                    encoding = Some(match words.next().unwrap_or_default() {
                        b"ascii" => Encoding::Text,
                        b"binary_little_endian" => Encoding::LittleEndian,
                        b"binary_big_endian" => Encoding::BigEndian,
                        _ => return Err(fail("the format is ascii, binary_little_endian or binary_big_endian")),
                    });
                }
                b"element" => {
                    let name = words.next().map(decoded);
                    let count = words.next().and_then(|word| str::from_utf8(word).ok()?.parse().ok());
                    let (Some(name), Some(count)) = (name, count) else {
                        return Err(fail("an element has a name and a count"));
                    };
                    elements.push(Element { name, count, properties: Vec::new() });
                }
                b"property" => {
                    let element = elements.last_mut().ok_or_else(|| fail("a property stands below its element"))?;
                    let property = property(words).map_err(|problem| fail(&problem))?;
                    if element.properties.iter().any(|other| other.name == property.name) {
                        return Err(fail("this property is there twice"));
                    }
                    element.properties.push(property);
                }
                b"" | b"comment" | b"obj_info" => {}
                b"end_header" => {
                    let Some(encoding) = encoding else { return Err(fail("the header names no format")) };
                    return Ok((Self { encoding, elements, lines: number }, lines.rest()));
                }
                _ => return Err(fail("this is no line of a PLY header")),
            }
        }
        Err(Failure::new("its header has no end: `end_header` is missing"))
    }
}

fn property<'a>(mut words: impl Iterator<Item = &'a [u8]>) -> Result<Property, String> {
    let mut scalar = || {
        let word = words.next().unwrap_or_default();
        let known = "char, uchar, short, ushort, int, uint, float and double are known";
        if word == b"list" {
            return Ok(None);
        }
        Scalar::of(word).map(Some).ok_or_else(|| format!("`{}` is no type of a value: {known}", shown(word)))
    };
    let no_list = || "a list has a type for its length and one for its values".to_owned();
    let (count, scalar) = match scalar()? {
        Some(scalar) => (None, scalar),
        None => (Some(scalar()?.ok_or_else(no_list)?), scalar()?.ok_or_else(no_list)?),
    };
    let name = words.next().map(decoded).ok_or("the property has no name")?;
    Ok(Property { name, count, scalar })
}
