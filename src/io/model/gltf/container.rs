//! The two ways in which a glTF document comes: as text, or with its binary part in a GLB.

use super::super::failure::{Failure, missing};
use super::super::text::without_mark;
use super::document::old_version;
use std::borrow::Cow;

/// The document's text, and the binary part beside it.
pub(super) struct Container<'a> {
    pub(super) json: Cow<'a, [u8]>,
    pub(super) bin: Option<&'a [u8]>,
}

impl<'a> Container<'a> {
    pub(super) fn open(bytes: &'a [u8]) -> Result<Self, Failure> {
        let Some(rest) = bytes.strip_prefix(b"glTF") else {
            return Ok(Self { json: without_mark(bytes), bin: None });
        };
        let cut = |announced: usize| {
            Failure::new(format_args!(
                "it is cut off: {announced} bytes are announced, {} are there, {}",
                bytes.len(),
                missing(announced.saturating_sub(bytes.len()))
            ))
        };
        let (version, rest) = word(rest).ok_or_else(|| cut(20))?;
        if version != 2 {
            return Err(old_version(&format!("{version}.0")));
        }
        let (length, mut rest) = word(rest).ok_or_else(|| cut(20))?;
        if length > bytes.len() {
            return Err(cut(length));
        }
        let (mut json, mut bin) = (None, None);
        while let Some((length, behind)) = word(rest) {
            let Some((kind, behind)) = behind.split_at_checked(4) else { break };
            let Some((chunk, behind)) = behind.split_at_checked(length) else {
                // What follows both parts is padding or another program's.
                if json.is_some() && bin.is_some() {
                    break;
                }
                return Err(cut(bytes.len() - behind.len() + length));
            };
            match kind {
                b"JSON" if json.is_none() => json = Some(chunk),
                b"BIN\0" if bin.is_none() => bin = Some(chunk),
                _ => {}
            }
            rest = behind;
        }
        let json = json.ok_or_else(|| Failure::new("it has no JSON part"))?;
        Ok(Self { json: Cow::Borrowed(json), bin })
    }
}

fn word(bytes: &[u8]) -> Option<(usize, &[u8])> {
    let (word, rest) = bytes.split_first_chunk()?;
    Some((u32::from_le_bytes(*word) as usize, rest))
}
