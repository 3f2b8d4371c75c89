//! JSON out: nothing is written of a thing that it cannot hold.

use super::finite::check_numbers;
use super::{IoError, write_atomically};
use serde::Serialize;
use std::io::{self, Write};
use std::path::Path;

/// Writes a thing as indented JSON, wholly or not at all.
///
/// # Errors
/// As [`write_atomically`], and [`IoError::NotFinite`] for a number that JSON cannot hold.
pub(crate) fn write_json(path: &Path, thing: &impl Serialize) -> Result<(), IoError> {
    write_atomically(path, |out| {
        check_numbers(thing)?;
        serde_json::to_writer_pretty(&mut *out, thing)?;
        out.write_all(b"\n")
    })
}

/// Writes a thing as JSON on one line.
///
/// # Errors
/// What `out` gives, and [`IoError::NotFinite`] as an [`io::Error`].
pub(super) fn write_line(out: &mut dyn Write, thing: &impl Serialize) -> io::Result<()> {
    check_numbers(thing)?;
    serde_json::to_writer(&mut *out, thing)?;
    out.write_all(b"\n")
}
