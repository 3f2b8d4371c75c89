//! The bytes that a glTF document speaks of: in its own text, in a file beside it, or in the binary part.

use super::super::failure::{Failure, missing};
use super::super::limits::MAX_MODEL_BYTES;
use super::document::{Buffer, Document};
use crate::io::paths::resolved;
use crate::io::read::{length_of, read_bytes};
use crate::scene::one_line;
use std::borrow::Cow;
use std::cell::OnceCell;
use std::collections::HashMap;
use std::path::{Path, PathBuf};

/// The buffers of a document, each fetched when it is first asked for: what only animations need may be missing.
pub(super) struct Buffers<'a> {
    document: &'a Document,
    folder: &'a Path,
    bin: Option<&'a [u8]>,
    loaded: Vec<OnceCell<Cow<'a, [u8]>>>,
    /// The first buffer that names the same file, or the same text, as each.
    first: Vec<usize>,
}

impl<'a> Buffers<'a> {
    pub(super) fn new(document: &'a Document, folder: &'a Path, bin: Option<&'a [u8]>) -> Self {
        let loaded = document.buffers.iter().map(|_| OnceCell::new()).collect();
        let mut known: HashMap<&str, usize> = HashMap::new();
        let mut files: HashMap<PathBuf, usize> = HashMap::new();
        let first = document.buffers.iter().enumerate().map(|(index, buffer)| {
            let Some(uri) = &buffer.uri else { return index };
            let named = *known.entry(uri).or_insert(index);
            if named != index || uri.starts_with("data:") || uri.contains("://") {
                return named;
            }
            resolved(&path_of(folder, uri)).map_or(index, |file| *files.entry(file).or_insert(index))
        });
        let first = first.collect();
        Self { document, folder, bin, loaded, first }
    }

    /// Bytes of the binary part and of all files that are named; those of the text count with it.
    pub(super) fn bytes_there(&self) -> usize {
        let files = self.document.buffers.iter().enumerate().filter(|(index, _)| self.first[*index] == *index);
        let uris = files.filter_map(|(_, buffer)| buffer.uri.as_ref()).filter(|uri| !uri.starts_with("data:"));
        let sizes = uris.filter_map(|uri| length_of(&path_of(self.folder, uri)));
        sizes.fold(self.bin.map_or(0, <[u8]>::len), |sum, size| sum.saturating_add(size as usize))
    }

    /// The bytes of a buffer view.
    pub(super) fn view(&self, index: usize) -> Result<&[u8], Failure> {
        let Some(view) = self.document.buffer_views.get(index) else {
            return Err(Failure::new(format_args!("bufferViews[{index}] is referred to and not there")));
        };
        if let Some(extension) = view.extensions.keys().find(|name| name.ends_with("meshopt_compression")) {
            let whole = self.document.buffers.get(view.buffer);
            let has_fallback = whole.is_some_and(|buffer| buffer.uri.is_some() || self.bin.is_some());
            if !has_fallback {
                return Err(compressed(extension));
            }
        }
        let bytes = self.buffer(view.buffer)?;
        let end = view.byte_offset.saturating_add(view.byte_length);
        bytes.get(view.byte_offset..end).ok_or_else(|| {
            Failure::new(format_args!(
                "bufferViews[{index}] ends at byte {end} of buffers[{}], which has {}: {}",
                view.buffer,
                bytes.len(),
                missing(end.saturating_sub(bytes.len()))
            ))
        })
    }

    fn buffer(&self, index: usize) -> Result<&[u8], Failure> {
        let cell = self.first.get(index).and_then(|&first| self.loaded.get(first));
        let (Some(buffer), Some(cell)) = (self.document.buffers.get(index), cell) else {
            return Err(Failure::new(format_args!("buffers[{index}] is referred to and not there")));
        };
        if cell.get().is_none() {
            let bytes = self.fetch(buffer, index)?;
            cell.get_or_init(|| bytes);
        }
        let bytes: &[u8] = cell.get().map_or(&[], |bytes| bytes);
        if bytes.len() < buffer.byte_length {
            let place = match &buffer.uri {
                Some(uri) if !uri.starts_with("data:") => format!(" (the file {})", one_line(uri)),
                _ => String::new(),
            };
            return Err(Failure::new(format_args!(
                "buffers[{index}]{place} has {} bytes where {} are announced: {}",
                bytes.len(),
                buffer.byte_length,
                missing(buffer.byte_length - bytes.len())
            )));
        }
        Ok(bytes)
    }

    fn fetch(&self, buffer: &Buffer, index: usize) -> Result<Cow<'a, [u8]>, Failure> {
        let Some(uri) = &buffer.uri else {
            let nothing = format!("buffers[{index}] names no file, and there is no binary part");
            return self.bin.map(Cow::Borrowed).ok_or_else(|| Failure::new(nothing));
        };
        if let Some(data) = uri.strip_prefix("data:") {
            let Some((_, text)) = data.split_once(";base64,") else {
                return Err(Failure::new(format_args!("buffers[{index}]: its data in the text is not base64")));
            };
            let bytes = decode_base64(text);
            let damaged = || Failure::new(format_args!("buffers[{index}]: its base64 data is damaged"));
            return bytes.map(Cow::Owned).ok_or_else(damaged);
        }
        if uri.contains("://") {
            let problem = format!("buffers[{index}] lies on the web, at {}", one_line(uri));
            return Err(Failure::with(problem, "put that file beside this one and name it without its address"));
        }
        let path = path_of(self.folder, uri);
        read_bytes(&path, MAX_MODEL_BYTES).map(Cow::Owned).map_err(|error| Failure::Other(error.within(&path)))
    }
}

/// The file that a document in `folder` names.
fn path_of(folder: &Path, uri: &str) -> PathBuf {
    let name = decode_percent(uri);
    // Some exporters write paths as their system does.
    let slashed = folder.join(name.replace('\\', "/"));
    let path = folder.join(&name);
    if name.contains('\\') && !path.exists() { slashed } else { path }
}

/// A compression that is not read.
pub(super) fn compressed(extension: &str) -> Failure {
    let name = if extension.contains("draco") { "Draco" } else { "meshopt" };
    Failure::with(
        format_args!("its meshes are compressed by {name} ({extension}), which is not read here"),
        "export it without compression",
    )
}

fn decode_base64(text: &str) -> Option<Vec<u8>> {
    let mut bytes = Vec::with_capacity(text.len() / 4 * 3);
    let (mut bits, mut count) = (0_u32, 0);
    for c in text.bytes().filter(|&c| c != b'=') {
        let value = match c {
            b'A'..=b'Z' => c - b'A',
            b'a'..=b'z' => c - b'a' + 26,
            b'0'..=b'9' => c - b'0' + 52,
            b'+' | b'-' => 62,
            b'/' | b'_' => 63,
            _ => return None,
        };
        bits = bits << 6 | u32::from(value);
        count += 6;
        if count >= 8 {
            count -= 8;
            bytes.push((bits >> count) as u8);
        }
    }
    Some(bytes)
}

/// Names of files in a glTF are written as in web addresses.
pub(super) fn decode_percent(text: &str) -> String {
    let mut bytes = Vec::with_capacity(text.len());
    let mut rest = text.as_bytes();
    while let [first, behind @ ..] = rest {
        let code = behind.get(..2).and_then(|two| str::from_utf8(two).ok());
        let byte = code.filter(|_| *first == b'%').and_then(|code| u8::from_str_radix(code, 16).ok());
        bytes.push(byte.unwrap_or(*first));
        rest = if byte.is_some() { &behind[2..] } else { behind };
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn data_in_text_is_decoded() {
        assert_eq!(decode_base64("c2luZXc=").as_deref(), Some(b"sinew".as_slice()));
        assert_eq!(decode_base64("c2lu*"), None);
        assert_eq!(decode_percent("my%20part%.bin"), "my part%.bin");
    }
}
