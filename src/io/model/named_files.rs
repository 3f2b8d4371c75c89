//! The files that a model names: materials, textures, buffers.

use super::failure::Failure;
use super::gltf;
use super::limits::MAX_MODEL_BYTES;
use super::mtl::MOST_LIBRARIES;
use super::obj::each_statement;
use super::text::{Lines, decoded, number, without_mark, words};
use crate::io::paths::resolved;
use crate::io::read::read_bytes;
use std::collections::HashSet;
use std::path::{Path, PathBuf};

/// Files that a model names.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(in crate::io) struct NamedFiles {
    /// Those that are there, by their paths from its folder.
    pub(in crate::io) there: Vec<PathBuf>,
    /// Those that are not, as the model has their names.
    pub(in crate::io) missing: Vec<String>,
}

impl NamedFiles {
    /// Takes the first of the names that a file is there for, from the folder `beside` in `folder`; what is `told` is
    /// missing where none is.
    fn take(&mut self, (folder, beside): (&Path, &Path), names: &[&str], told: &str) -> Option<PathBuf> {
        let found = names.iter().flat_map(|name| ways(name)).map(|name| beside.join(name));
        let found = found.into_iter().find(|path| folder.join(path).is_file()).map(|path| within(folder, path));
        match &found {
            Some(path) => self.there.push(path.clone()),
            None => self.missing.push(told.to_owned()),
        }
        found
    }

    fn sorted(mut self) -> Self {
        self.there.sort();
        self.there.dedup();
        self.missing.sort();
        self.missing.dedup();
        self
    }
}

/// The ways in which a name may lead to a file: as it stands, with the slashes of this system, and beside the file that
/// names it, wherever it lay where that was written.
fn ways(name: &str) -> Vec<String> {
    let slashes = name.replace('\\', "/");
    let last = slashes.rsplit('/').next().unwrap_or_default().to_owned();
    [name.to_owned(), slashes, last].into_iter().filter(|way| !way.is_empty()).collect()
}

/// A path from a folder, which may be the whole path of a file in it.
fn within(folder: &Path, path: PathBuf) -> PathBuf {
    let relative = || Some(resolved(&path)?.strip_prefix(resolved(folder)?).ok()?.to_owned());
    if path.is_absolute() { relative().unwrap_or(path) } else { path }
}

/// Names of textures that are looked for, at most.
const MOST_TEXTURES: usize = 10_000;

/// Files that an OBJ file names: its materials, and the textures of these.
pub(super) fn of_obj(bytes: &[u8], folder: &Path) -> Result<NamedFiles, Failure> {
    let text = without_mark(bytes);
    let (mut files, mut libraries, mut named) = (NamedFiles::default(), Vec::new(), HashSet::new());
    let here = (folder, Path::new(""));
    each_statement(&text, |statement| {
        if statement.keyword() == b"mtllib" {
            let name = decoded(statement.name());
            if !named.insert(name.clone()) {
                return Ok(());
            }
            if named.len() > MOST_LIBRARIES {
                return Err(Failure::new(format_args!("it names more than {MOST_LIBRARIES} libraries of materials")));
            }
            // One with spaces in its name, or several.
            if ways(&name).iter().any(|name| folder.join(name).is_file()) {
                libraries.extend(files.take(here, &[&name], &name));
            } else {
                libraries.extend(name.split_whitespace().filter_map(|name| files.take(here, &[name], name)));
            }
        }
        Ok(())
    })?;
    libraries.sort();
    libraries.dedup();
    let (mut read, mut textures) = (HashSet::new(), HashSet::new());
    for library in libraries {
        if resolved(&folder.join(&library)).is_some_and(|file| !read.insert(file)) {
            continue;
        }
        let content = read_bytes(&folder.join(&library), MAX_MODEL_BYTES).unwrap_or_default();
        let beside = library.parent().unwrap_or(Path::new(""));
        for (_, line) in Lines::new(&without_mark(&content)) {
            if let Some(name) = texture_of(line) {
                let (name, last) = (decoded(name), decoded(words(name).last().unwrap_or_default()));
                if !textures.insert((beside.to_owned(), name.clone())) {
                    continue;
                }
                if textures.len() > MOST_TEXTURES {
                    return Err(Failure::new(format_args!("its materials name more than {MOST_TEXTURES} textures")));
                }
                files.take((folder, beside), &[&name, &last], &name);
            }
        }
    }
    Ok(files.sorted())
}

/// The name of the texture in a line of a material: all that stands behind the options, spaces included.
fn texture_of(line: &[u8]) -> Option<&[u8]> {
    let line = line.trim_ascii();
    let mut rest = after_word(line);
    let keyword = line[..line.len() - rest.len()].trim_ascii().to_ascii_lowercase();
    let is_texture = keyword.starts_with(b"map_")
        || [&b"bump"[..], b"disp", b"norm", b"refl", b"decal"].contains(&keyword.as_slice());
    if !is_texture {
        return None;
    }
    while rest.starts_with(b"-") {
        let option = words(rest).next().unwrap_or_default().to_ascii_lowercase();
        // Of scale, shift and turbulence all but the first of three numbers may be missing.
        let (sure, maybe) = match option.as_slice() {
            b"-o" | b"-s" | b"-t" => (1, 2),
            b"-mm" => (2, 0),
            b"-blendu" | b"-blendv" | b"-boost" | b"-cc" | b"-clamp" | b"-imfchan" | b"-texres" | b"-bm" | b"-type" => {
                (1, 0)
            }
            // No option: a name that begins like one.
            _ => break,
        };
        rest = after_word(rest);
        (0..sure).for_each(|_| rest = after_word(rest));
        for _ in 0..maybe {
            if words(rest).next().is_some_and(|word| number(word).is_some()) {
                rest = after_word(rest);
            }
        }
    }
    (!rest.is_empty()).then_some(rest)
}

/// What stands behind the first word of a text that begins with one.
fn after_word(text: &[u8]) -> &[u8] {
    let end = text.iter().position(u8::is_ascii_whitespace).unwrap_or(text.len());
    text[end..].trim_ascii()
}

/// Files that a glTF document names: its buffers and images.
pub(super) fn of_gltf(bytes: &[u8], folder: &Path) -> Result<NamedFiles, Failure> {
    let mut files = NamedFiles::default();
    for name in gltf::named_files(bytes)? {
        // Their reader takes them by this path alone.
        if folder.join(&name).is_file() {
            files.there.push(PathBuf::from(name));
        } else {
            files.missing.push(name);
        }
    }
    Ok(files.sorted())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_textures_name_is_all_behind_the_options() {
        for (line, name) in [
            ("map_Kd my leaf.png", Some("my leaf.png")),
            ("  MAP_Bump -bm 0.5 -clamp on rough bark.tif  ", Some("rough bark.tif")),
            ("map_Kd -s 1 1 1 -o 0.5 a 1.png", Some("a 1.png")),
            ("map_Kd -t 2 3 tex\\b.png", Some("tex\\b.png")),
            ("refl -type sphere -mm 0 1 sky.jpg", Some("sky.jpg")),
            ("bump -odd name.png", Some("-odd name.png")),
            ("map_Kd", None),
            ("map_Kd -s 1", None),
            ("Kd 1 0 0", None),
            ("", None),
        ] {
            let found = texture_of(line.as_bytes()).map(decoded);
            assert_eq!(found.as_deref(), name, "{line}");
        }
    }
}
