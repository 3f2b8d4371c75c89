//! A scene, its models and what belongs to them in one archive, to be sent.

use super::assets::Stages;
use super::collect::files_of;
use super::json_out::write_line;
use super::read::read_bytes;
use super::zip::ZipWriter;
use super::{IoError, write_atomically};
use serde::Serialize;
use std::collections::BTreeMap;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// Larger files than this do not go along [bytes].
const LARGEST: u64 = 1 << 30;

/// What goes into an archive.
#[derive(Default)]
pub(crate) struct Archive {
    /// Names in the archive, and what stands there.
    files: Vec<(String, Content)>,
    /// Names of models that go along, by where they are from.
    models: BTreeMap<PathBuf, String>,
    /// What could not go along, and why.
    missing: Vec<String>,
}

enum Content {
    Bytes(Vec<u8>),
    File(PathBuf),
}

impl Archive {
    /// Adds a file of this content.
    pub(crate) fn add(&mut self, name: &str, content: Vec<u8>) {
        self.files.push((name.to_owned(), Content::Bytes(content)));
    }

    /// Adds a thing as JSON.
    ///
    /// # Errors
    /// [`IoError::NotFinite`] for a number that JSON cannot hold.
    pub(crate) fn add_json(&mut self, name: &str, thing: &impl Serialize) -> Result<(), IoError> {
        let mut bytes = Vec::new();
        write_line(&mut bytes, thing).map_err(IoError::of_writing)?;
        self.add(name, bytes);
        Ok(())
    }

    /// Adds a model, with the files that it names, unless it goes along already; `given` is its content where that lies
    /// in no file. Gives its name in the archive; that of one which cannot be read stands for nothing.
    pub(crate) fn add_model(&mut self, source: &Path, given: Option<&[u8]>) -> String {
        if let Some(name) = self.models.get(source) {
            return name.clone();
        }
        let folder = format!("models/{}", self.models.len() + 1);
        let own = source.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let name = format!("{folder}/{own}");
        self.models.insert(source.to_owned(), name.clone());
        if let Some(bytes) = given {
            self.add(&name, bytes.to_vec());
            return name;
        }
        match files_of(source) {
            Ok((files, missing)) => {
                self.missing.extend(missing.into_iter().map(|file| format!("{own} names {file}, which is not there")));
                for file in files {
                    let name = file.name.to_string_lossy().replace('\\', "/");
                    match fs::metadata(&file.source) {
                        Ok(about) if about.len() > LARGEST => self.missing.push(format!("{name} is larger than 1 GiB")),
                        _ => self.files.push((format!("{folder}/{name}"), Content::File(file.source))),
                    }
                }
            }
            Err(error) => self.missing.push(error.to_string()),
        }
        name
    }

    /// What could not go along, and why.
    pub(crate) fn missing(&self) -> &[String] {
        &self.missing
    }

    /// Writes it, wholly or not at all; false where `progress`, which hears what is being worked on, broke it off.
    ///
    /// # Errors
    /// A model that cannot be read, or as [`write_atomically`].
    pub(crate) fn write(&self, path: &Path, progress: &mut Stages<'_>) -> Result<bool, IoError> {
        let mut ended = false;
        let written = write_atomically(path, |out| {
            let mut zip = ZipWriter::new(out);
            for (name, content) in &self.files {
                if progress(&format!("{name}: writing")).is_break() {
                    ended = true;
                    return Err(io::ErrorKind::Interrupted.into());
                }
                match content {
                    Content::Bytes(bytes) => zip.add(name, bytes)?,
                    Content::File(file) => {
                        let bytes = read_bytes(file, LARGEST).map_err(|error| io::Error::other(error.within(file)))?;
                        zip.add(name, &bytes)?;
                    }
                }
            }
            if progress("ending the archive").is_break() {
                ended = true;
                return Err(io::ErrorKind::Interrupted.into());
            }
            zip.end()
        });
        if ended { Ok(false) } else { written.map(|()| true) }
    }
}

/// What system this is, in a line.
pub(crate) fn system() -> String {
    let of_list = fs::read_to_string("/etc/os-release").ok().and_then(|list| {
        let line = list.lines().find_map(|line| line.strip_prefix("PRETTY_NAME="))?;
        Some(line.trim_matches('"').to_owned())
    });
    let kernel = fs::read_to_string("/proc/sys/kernel/osrelease")
        .map_or_else(|_| String::new(), |kernel| format!(", kernel {}", kernel.trim()));
    let kind = if cfg!(target_os = "windows") {
        "Windows"
    } else if cfg!(target_os = "macos") {
        "macOS"
    } else if cfg!(target_os = "linux") {
        "Linux"
    } else {
        "another system"
    };
    let machine = if cfg!(target_arch = "x86_64") {
        "x86-64"
    } else if cfg!(target_arch = "aarch64") {
        "64-bit ARM"
    } else {
        "another processor"
    };
    format!("{} on {machine}{kernel}", of_list.unwrap_or_else(|| kind.to_owned()))
}
