//! Folders in which the program keeps small things for a person, each as JSON in a file of its own.

use super::atomic::sweep;
use super::door;
use super::json::{place_and_problem, pointer_of};
use super::json_out::write_line;
use super::read::read_text;
use super::{IoError, make_folder, write_atomically};
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::Value;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// Files larger than this are no small things [bytes].
const LARGEST: u64 = 16 << 20;
/// Files beyond this number are not looked at.
const MOST: usize = 1000;
/// Letters that a file takes from a title.
const NAME_LENGTH: usize = 40;

/// A folder of small things, each a JSON file. It is made when the first one is put into it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct JsonFolder {
    folder: PathBuf,
}

/// One of the things.
#[derive(Debug)]
pub(crate) struct JsonFile<T> {
    /// Its file.
    pub path: PathBuf,
    /// What it holds, or why that cannot be used. The file is left as it is.
    pub content: Result<T, IoError>,
}

impl JsonFolder {
    /// The folder at this path.
    pub(crate) fn new(folder: impl Into<PathBuf>) -> Self {
        Self { folder: folder.into() }
    }

    /// Everything there, by the names of the files. A folder that is not there holds nothing.
    ///
    /// # Errors
    /// The folder cannot be read. What is wrong with one file stands with it.
    pub(crate) fn list<T: DeserializeOwned>(&self) -> Result<Vec<JsonFile<T>>, IoError> {
        let entries = match fs::read_dir(&self.folder) {
            Ok(entries) => entries,
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(Vec::new()),
            Err(error) => return Err(IoError::Read(error).within(&self.folder)),
        };
        let json = |path: &PathBuf| path.extension().is_some_and(|extension| extension == "json");
        let mut paths: Vec<PathBuf> = entries.flatten().map(|entry| entry.path()).filter(json).take(MOST).collect();
        paths.sort();
        Ok(paths.into_iter().map(|path| JsonFile { content: read(&path).map_err(|e| e.within(&path)), path }).collect())
    }

    /// Puts a thing into a new file, named after `title`. Returns the file.
    ///
    /// # Errors
    /// [`IoError::InFile`]: the folder or the file cannot be written.
    pub(crate) fn add(&self, title: &str, thing: &impl Serialize) -> Result<PathBuf, IoError> {
        make_folder(&self.folder)?;
        let name = file_name(title);
        let numbered = |n: usize| if n == 1 { format!("{name}.json") } else { format!("{name}-{n}.json") };
        let free = (1..=MOST + 1).map(|n| self.folder.join(numbered(n))).find(|path| !path.exists());
        let path = free.unwrap_or_else(|| self.folder.join(numbered(MOST + 2)));
        write(&path, thing)?;
        Ok(path)
    }

    /// Changes one text of a thing and leaves all else in its file as it is.
    ///
    /// # Errors
    /// [`IoError::InFile`]: it cannot be read or written.
    pub(crate) fn set_text(path: &Path, member: &str, text: &str) -> Result<(), IoError> {
        let mut value: Value = read(path).map_err(|error| error.within(path))?;
        if let Value::Object(members) = &mut value {
            members.insert(member.to_owned(), Value::String(text.to_owned()));
        }
        write(path, &value)
    }

    /// Removes a thing.
    ///
    /// # Errors
    /// [`IoError::InFile`]: the system does not let it go.
    pub(crate) fn remove(path: &Path) -> Result<(), IoError> {
        door::remove(path).map_err(|error| IoError::Write(error).within(path))
    }
}

fn read<T: DeserializeOwned>(path: &Path) -> Result<T, IoError> {
    let text = read_text(path, LARGEST)?;
    let mut source = serde_json::Deserializer::from_str(&text);
    serde_path_to_error::deserialize(&mut source).map_err(|error| {
        let path = pointer_of(error.path());
        let (line, column, problem) = place_and_problem(error.inner());
        IoError::Syntax { line, column, path, problem }
    })
}

fn write(path: &Path, thing: &impl Serialize) -> Result<(), IoError> {
    sweep(path);
    write_atomically(path, |out| write_line(out, thing))
}

/// A title as a file may be named on any system.
fn file_name(title: &str) -> String {
    let kept = |c: char| if c.is_alphanumeric() { c.to_lowercase().next().unwrap_or('-') } else { '-' };
    let spelt: String = title.trim().chars().take(NAME_LENGTH).map(kept).collect();
    let spelt = spelt.trim_matches('-');
    if spelt.is_empty() { "untitled".to_owned() } else { spelt.to_owned() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde::Deserialize;

    #[derive(Debug, PartialEq, Serialize, Deserialize)]
    struct Item {
        title: String,
    }

    #[test]
    fn things_come_and_go_and_damaged_ones_stay_as_they_are() {
        let root = tempfile::tempdir().expect("a folder");
        let folder = JsonFolder::new(root.path().join("things"));
        assert!(folder.list::<Item>().expect("nothing is there").is_empty());
        let thing = || Item { title: "A Thing / of mine".to_owned() };
        let [first, second] = [(); 2].map(|()| folder.add(&thing().title, &thing()).expect("kept"));
        let name = |path: &Path| path.file_name().map(|name| name.to_string_lossy().into_owned());
        assert_eq!(name(&first).as_deref(), Some("a-thing---of-mine.json"));
        assert_ne!(first, second, "none takes another's place");

        fs::write(&second, r#"{"title": "Two", "note": [1, 2]}"#).expect("written");
        JsonFolder::set_text(&second, "title", "Second").expect("changed");
        let text = fs::read_to_string(&second).expect("there");
        assert!(text.contains("\"Second\"") && text.contains("[1,2]"), "{text}");

        let damaged = first.with_file_name("damaged.json");
        fs::write(&damaged, "{\n  \"title\": 5\n}").expect("written");
        let said: Vec<String> = folder
            .list::<Item>()
            .expect("three are there")
            .into_iter()
            .filter_map(|kept| Some(kept.content.err()?.to_string()))
            .collect();
        assert_eq!(said.len(), 1);
        assert!(said[0].contains("damaged.json: line 2, column") && said[0].contains("/title"), "{}", said[0]);
        assert!(JsonFolder::set_text(&first.with_file_name("gone.json"), "title", "a").is_err());

        JsonFolder::remove(&first).expect("removed");
        assert_eq!(folder.list::<Item>().expect("two are left").len(), 2);
        assert!(JsonFolder::remove(&first).is_err());
    }

    #[test]
    fn names_of_files_are_such_everywhere() {
        for (title, name) in [("..", "untitled"), ("", "untitled"), ("C:\\a", "c--a"), ("Ähre", "ähre")] {
            assert_eq!(file_name(title), name);
        }
    }
}
