//! The bytes that a glTF document speaks of: in its own text, in a file beside it, or in the binary part.

use super::super::failure::{Failure, missing};
use super::super::limits::MAX_MODEL_BYTES;
use super::document::{Buffer, Document};
use crate::io::read::read_bytes;
use crate::scene::one_line;
use std::borrow::Cow;
use std::cell::OnceCell;
use std::path::Path;

/// The buffers of a document, each fetched when it is first asked for: what only animations need may be missing.
pub(super) struct Buffers<'a> {
    document: &'a Document,
    folder: &'a Path,
    bin: Option<&'a [u8]>,
    loaded: Vec<OnceCell<Cow<'a, [u8]>>>,
}

impl<'a> Buffers<'a> {
    pub(super) fn new(document: &'a Document, folder: &'a Path, bin: Option<&'a [u8]>) -> Self {
        let loaded = document.buffers.iter().map(|_| OnceCell::new()).collect();
        Self { document, folder, bin, loaded }
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
        let (Some(buffer), Some(cell)) = (self.document.buffers.get(index), self.loaded.get(index)) else {
            return Err(Failure::new(format_args!("buffers[{index}] is referred to and not there")));
        };
        if let Some(bytes) = cell.get() {
            return Ok(bytes);
        }
        let bytes = self.fetch(buffer, index)?;
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
        Ok(cell.get_or_init(|| bytes))
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
        let name = decode_percent(uri);
        // Some exporters write paths as their system does.
        let slashed = self.folder.join(name.replace('\\', "/"));
        let path = self.folder.join(&name);
        let path = if name.contains('\\') && !path.exists() { slashed } else { path };
        read_bytes(&path, MAX_MODEL_BYTES).map(Cow::Owned).map_err(|error| Failure::Other(error.within(&path)))
    }
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
