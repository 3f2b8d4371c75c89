//! The files that a model names: materials, textures, buffers.

use super::failure::Failure;
use super::gltf;
use super::limits::MAX_MODEL_BYTES;
use super::obj::each_statement;
use super::text::{Lines, decoded, without_mark, words};
use crate::io::read::read_bytes;
use std::path::{Path, PathBuf};

/// Files that an OBJ file names, by their paths from its folder: its materials, and the textures of these.
pub(super) fn of_obj(bytes: &[u8], folder: &Path) -> Result<Vec<PathBuf>, Failure> {
    let text = without_mark(bytes);
    let mut libraries: Vec<PathBuf> = Vec::new();
    each_statement(&text, |statement| {
        if statement.keyword() == b"mtllib" {
            let name = decoded(statement.name());
            let is_there = |name: &str| folder.join(name).is_file();
            // One with spaces in its name, or several.
            let names: Vec<&str> =
                if is_there(&name) { vec![name.as_str()] } else { name.split_whitespace().collect() };
            for name in names {
                let last = name.rsplit(['/', '\\']).next().unwrap_or(name);
                libraries.extend([name, last].into_iter().find(|name| is_there(name)).map(PathBuf::from));
            }
        }
        Ok(())
    })?;
    let mut files = Vec::new();
    for library in libraries {
        let content = read_bytes(&folder.join(&library), MAX_MODEL_BYTES).unwrap_or_default();
        let beside = library.parent().unwrap_or(Path::new("")).to_owned();
        files.push(library);
        for (_, line) in Lines::new(&without_mark(&content)) {
            let mut words = words(line);
            let keyword = words.next().unwrap_or_default().to_ascii_lowercase();
            if (keyword.starts_with(b"map_") || keyword == b"bump" || keyword == b"disp" || keyword == b"norm")
                && let Some(name) = words.last()
            {
                files.push(beside.join(decoded(name)));
            }
        }
    }
    files.sort();
    files.dedup();
    Ok(files)
}

/// Files that a glTF document names: its buffers and images.
pub(super) fn of_gltf(bytes: &[u8]) -> Result<Vec<PathBuf>, Failure> {
    let mut files: Vec<PathBuf> = gltf::named_files(bytes)?.into_iter().map(PathBuf::from).collect();
    files.sort();
    files.dedup();
    Ok(files)
}
