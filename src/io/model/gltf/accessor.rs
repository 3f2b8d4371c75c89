//! Numbers out of the buffers of a glTF document: any type of component, packed or apart, whole or sparse, with whole
//! numbers standing for themselves or for shares of the greatest.

use super::super::failure::{Failure, missing};
use super::super::limits::{MOST, REPEATED};
use super::buffers::Buffers;
use super::document::{Accessor, Document, SparsePart};
use std::cell::{Cell, RefCell};
use std::collections::HashSet;
use std::path::Path;

/// Reads accessors. What of them is read again and again, and kept, is counted: a few bytes may ask for any amount.
pub(super) struct Accessors<'a> {
    pub(super) document: &'a Document,
    pub(super) buffers: Buffers<'a>,
    /// Bytes of the document and of all files that it takes its numbers from.
    bytes: usize,
    /// Numbers that were read.
    read: Cell<usize>,
    /// Vertices that were made, or what takes as much memory.
    kept: Cell<usize>,
    /// Accessors whose positions a piece has shown.
    shown: RefCell<HashSet<usize>>,
}

/// Numbers that are read beside two for each byte, at most.
const MOST_READ: usize = 100_000_000;

/// Whether whole numbers are shares of the greatest of their type.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Whole {
    /// As the accessor says.
    AsSaid,
    /// Always, as in colours.
    Shares,
    /// Never, as in indices.
    Themselves,
}

/// Rows of numbers, one after another.
#[derive(Debug, Default)]
pub(super) struct Rows {
    pub(super) values: Vec<f64>,
    /// Numbers of a row.
    pub(super) width: usize,
}

impl Rows {
    pub(super) fn rows(&self) -> std::slice::ChunksExact<'_, f64> {
        self.values.chunks_exact(self.width.max(1))
    }
}

impl<'a> Accessors<'a> {
    /// Of a document whose text has so many bytes.
    pub(super) fn new(document: &'a Document, text: usize, folder: &'a Path, bin: Option<&'a [u8]>) -> Self {
        let buffers = Buffers::new(document, folder, bin);
        let bytes = text.saturating_add(buffers.bytes_there());
        Self { document, buffers, bytes, read: Cell::new(0), kept: Cell::new(0), shown: RefCell::default() }
    }

    /// Notes that a piece shows the positions of this accessor; whether another one did before.
    pub(super) fn is_shown_again(&self, index: usize) -> bool {
        !self.shown.borrow_mut().insert(index)
    }

    /// Counts so many vertices, or what takes as much memory, that are made of what was read.
    ///
    /// # Errors
    /// More than a file of its size has a use for: it shows the same again and again.
    pub(super) fn keep(&self, count: usize) -> Result<(), Failure> {
        let most = REPEATED + self.bytes / 8;
        self.kept.set(self.kept.get().saturating_add(count));
        if self.kept.get() <= most {
            return Ok(());
        }
        Err(Failure::with(
            format_args!(
                "it shows the same data again and again: more than {most} vertices are made of {} bytes",
                self.bytes
            ),
            "export fewer copies of it",
        ))
    }

    fn count(&self, numbers: usize, name: &str) -> Result<(), Failure> {
        self.read.set(self.read.get().saturating_add(numbers));
        if self.read.get() <= MOST_READ.saturating_add(2 * self.bytes) {
            return Ok(());
        }
        let (millions, bytes) = (self.read.get() / 1_000_000, self.bytes);
        Err(Failure::with(
            format_args!(
                "it reads the same data again and again: {millions} million numbers of {bytes} bytes at {name}"
            ),
            "export fewer copies of it",
        ))
    }

    /// The rows of an accessor that is used as `purpose`, which has one of the `kinds`.
    pub(super) fn read(&self, index: usize, kinds: &[&str], whole: Whole, purpose: &str) -> Result<Rows, Failure> {
        let name = format!("accessors[{index}] ({purpose})");
        let Some(accessor) = self.document.accessors.get(index) else {
            return Err(Failure::new(format_args!("{name} is not there")));
        };
        if !kinds.contains(&accessor.kind.as_str()) {
            return Err(Failure::new(format_args!(
                "{name} has the type {:?}, not {}",
                accessor.kind,
                kinds.join(" or ")
            )));
        }
        if accessor.count > MOST {
            return Err(Failure::new(format_args!("{name} announces {} rows, more than are read", accessor.count)));
        }
        let width = width_of(&accessor.kind);
        let convert = converter(accessor, whole).ok_or_else(|| {
            Failure::new(format_args!("{name} has the componentType {}, which is none", accessor.component_type))
        })?;
        self.count(width * accessor.count, &name)?;
        let zeros = || Rows { values: vec![0.0; width * accessor.count], width };
        let mut rows = if let Some(view) = accessor.buffer_view {
            let stride = self.document.buffer_views.get(view).and_then(|view| view.byte_stride);
            let part = SparsePart {
                buffer_view: view,
                byte_offset: accessor.byte_offset,
                component_type: accessor.component_type,
            };
            let block = Block { name: &name, part: &part, count: accessor.count, width, stride };
            self.bytes_of(&block)?;
            let mut rows = zeros();
            self.each(&block, |place, bytes| rows.values[place] = convert(bytes))?;
            rows
        } else if accessor.sparse.is_none() {
            return Err(Failure::new(format_args!("{name} has no bufferView: its data is not in the file")));
        } else {
            // Zeros, none of which is in the file.
            self.keep(accessor.count)?;
            zeros()
        };
        self.read_sparse(accessor, &name, convert, &mut rows)?;
        Ok(rows)
    }

    /// Rows that differ from what the bufferView has, or from zero.
    fn read_sparse(&self, accessor: &Accessor, name: &str, convert: Convert, rows: &mut Rows) -> Result<(), Failure> {
        let Some(sparse) = &accessor.sparse else { return Ok(()) };
        let count = sparse.count;
        let block = Block { name, part: &sparse.indices, count, width: 1, stride: None };
        self.bytes_of(&block)?;
        self.count(count, name)?;
        let mut places = vec![0; count];
        self.each(&block, |place, bytes| {
            let mut wide = [0; 8];
            wide[..bytes.len()].copy_from_slice(bytes);
            places[place] = u64::from_le_bytes(wide) as usize;
        })?;
        if let Some(place) = places.iter().find(|&&place| place >= accessor.count) {
            return Err(Failure::new(format_args!(
                "{name}: its sparse part refers to row {place} of {}",
                accessor.count
            )));
        }
        let width = rows.width;
        let SparsePart { buffer_view, byte_offset, .. } = sparse.values;
        let part = SparsePart { buffer_view, byte_offset, component_type: accessor.component_type };
        let block = Block { name, part: &part, count, width, stride: None };
        self.each(&block, |at, bytes| rows.values[places[at / width] * width + at % width] = convert(bytes))
    }

    /// The bytes of a block, how many of them a component has, and how many there are from row to row.
    fn bytes_of(&self, block: &Block<'_>) -> Result<(&[u8], usize, usize), Failure> {
        let &Block { name, part, count, width, stride } = block;
        let Some(size) = size_of(part.component_type) else {
            return Err(Failure::new(format_args!(
                "{name} has the componentType {}, which is none",
                part.component_type
            )));
        };
        let bytes = self.buffers.view(part.buffer_view)?;
        let packed = size * width;
        let stride = stride.filter(|&stride| stride > 0).unwrap_or(packed);
        let length = count.checked_sub(1).map_or(0, |last| last.saturating_mul(stride).saturating_add(packed));
        let Some(bytes) = bytes.get(part.byte_offset..).filter(|bytes| bytes.len() >= length) else {
            let end = part.byte_offset.saturating_add(length);
            return Err(Failure::new(format_args!(
                "{name}: its {count} rows need {end} bytes of bufferViews[{}], which has {}: {}",
                part.buffer_view,
                bytes.len(),
                missing(end.saturating_sub(bytes.len()))
            )));
        };
        Ok((bytes, size, stride))
    }

    /// Hands out the bytes of every component in turn.
    fn each(&self, block: &Block<'_>, mut take: impl FnMut(usize, &[u8])) -> Result<(), Failure> {
        let (bytes, size, stride) = self.bytes_of(block)?;
        let &Block { count, width, .. } = block;
        let packed = size * width;
        for row in 0..count {
            let row_bytes = &bytes[row * stride..row * stride + packed];
            for (column, component) in row_bytes.chunks_exact(size).enumerate() {
                take(row * width + column, component);
            }
        }
        Ok(())
    }
}

/// Components in a view.
struct Block<'a> {
    name: &'a str,
    part: &'a SparsePart,
    count: usize,
    width: usize,
    stride: Option<usize>,
}

type Convert = fn(&[u8]) -> f64;

/// Numbers of a row.
fn width_of(kind: &str) -> usize {
    match kind {
        "VEC2" => 2,
        "VEC3" => 3,
        "VEC4" => 4,
        "MAT4" => 16,
        _ => 1,
    }
}

/// Bytes of a component.
fn size_of(component_type: u32) -> Option<usize> {
    match component_type {
        5120 | 5121 => Some(1),
        5122 | 5123 => Some(2),
        5125 | 5126 => Some(4),
        _ => None,
    }
}

/// How the bytes of a component become a number.
fn converter(accessor: &Accessor, whole: Whole) -> Option<Convert> {
    let shares = match whole {
        Whole::AsSaid => accessor.normalized,
        Whole::Shares => true,
        Whole::Themselves => false,
    };
    // Of signed types two numbers stand for -1.
    Some(match (accessor.component_type, shares) {
        (5120, false) => |b| f64::from(b[0].cast_signed()),
        (5120, true) => |b| (f64::from(b[0].cast_signed()) / 127.0).max(-1.0),
        (5121, false) => |b| f64::from(b[0]),
        (5121, true) => |b| f64::from(b[0]) / 255.0,
        (5122, false) => |b| f64::from(i16::from_le_bytes([b[0], b[1]])),
        (5122, true) => |b| (f64::from(i16::from_le_bytes([b[0], b[1]])) / 32767.0).max(-1.0),
        (5123, false) => |b| f64::from(u16::from_le_bytes([b[0], b[1]])),
        (5123, true) => |b| f64::from(u16::from_le_bytes([b[0], b[1]])) / 65535.0,
        (5125, _) => |b| f64::from(u32::from_le_bytes([b[0], b[1], b[2], b[3]])),
        (5126, _) => |b| f64::from(f32::from_le_bytes([b[0], b[1], b[2], b[3]])),
        _ => return None,
    })
}
