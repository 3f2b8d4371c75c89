//! ZIP archives of files as they are, without compression: what every system opens, in the form of PKWARE's
//! APPNOTE.TXT 6.3.3 (4.3.7 local headers, 4.3.12 central directory, 4.3.16 its end).

use std::io::{self, Write};

/// Local header of a file, its entry in the directory, and the end of that.
const LOCAL: u32 = 0x0403_4b50;
const ENTRY: u32 = 0x0201_4b50;
const END: u32 = 0x0605_4b50;
/// Version of the format that a reader needs, and the flag of names in UTF-8.
const VERSION: u16 = 20;
const UTF8: u16 = 1 << 11;
/// The first day that the format knows: the same files give the same archive.
const DAY: u16 = (1 << 5) | 1;

/// Writes an archive file by file.
pub(super) struct ZipWriter<'a> {
    out: &'a mut dyn Write,
    written: u64,
    directory: Vec<u8>,
    files: u64,
}

impl<'a> ZipWriter<'a> {
    /// An archive without any file.
    pub(super) fn new(out: &'a mut dyn Write) -> Self {
        Self { out, written: 0, directory: Vec::new(), files: 0 }
    }

    /// Adds a file; folders in its name are parted by slashes.
    ///
    /// # Errors
    /// What `out` gives, and [`io::ErrorKind::FileTooLarge`] for an archive of more than 4 GiB.
    pub(super) fn add(&mut self, name: &str, content: &[u8]) -> io::Result<()> {
        let length = short(content.len() as u64)?;
        let offset = short(self.written)?;
        let mut fields = Vec::new();
        for field in [VERSION, UTF8, 0, 0, DAY] {
            fields.extend(field.to_le_bytes());
        }
        for field in [crc32fast::hash(content), length, length] {
            fields.extend(field.to_le_bytes());
        }
        let name_length = u16::try_from(name.len()).map_err(|_| too_large())?;
        fields.extend(name_length.to_le_bytes());
        // No extra fields.
        fields.extend(0_u16.to_le_bytes());
        self.put(&LOCAL.to_le_bytes())?;
        self.put(&fields)?;
        self.put(name.as_bytes())?;
        self.put(content)?;
        self.directory.extend(ENTRY.to_le_bytes());
        self.directory.extend(VERSION.to_le_bytes());
        self.directory.extend(fields);
        // No comment, the first disk, no attributes.
        self.directory.extend([0; 10]);
        self.directory.extend(offset.to_le_bytes());
        self.directory.extend(name.as_bytes());
        self.files += 1;
        Ok(())
    }

    /// Ends the archive.
    ///
    /// # Errors
    /// As [`Self::add`].
    pub(super) fn end(mut self) -> io::Result<()> {
        let (offset, length) = (short(self.written)?, short(self.directory.len() as u64)?);
        let files = u16::try_from(self.files).map_err(|_| too_large())?;
        let directory = std::mem::take(&mut self.directory);
        self.put(&directory)?;
        self.put(&END.to_le_bytes())?;
        self.put(&[0; 4])?;
        for _ in 0..2 {
            self.put(&files.to_le_bytes())?;
        }
        self.put(&length.to_le_bytes())?;
        self.put(&offset.to_le_bytes())?;
        self.put(&[0; 2])
    }

    fn put(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.out.write_all(bytes)?;
        self.written += bytes.len() as u64;
        Ok(())
    }
}

fn short(number: u64) -> io::Result<u32> {
    u32::try_from(number).map_err(|_| too_large())
}

fn too_large() -> io::Error {
    io::Error::new(io::ErrorKind::FileTooLarge, "the archive would be longer than the 4 GiB that its format holds")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_archive_is_as_long_as_its_parts() {
        let mut bytes = Vec::new();
        let mut zip = ZipWriter::new(&mut bytes);
        zip.add("a/größe.txt", b"one").expect("written");
        zip.add("b", b"").expect("written");
        zip.end().expect("written");
        let names = "a/größe.txt".len() + 1;
        assert_eq!(bytes.len(), 2 * (30 + 46) + 2 * names + 3 + 22);
        assert_eq!(&bytes[..4], b"PK\x03\x04");
        assert_eq!(&bytes[bytes.len() - 22..][..4], b"PK\x05\x06");
        assert_eq!(bytes[14..18], crc32fast::hash(b"one").to_le_bytes());
    }
}
