//! Scene files: versioned JSON in and out.

use super::atomic::sweep;
use super::finite::check_numbers;
use super::json::{parse, pointer_of};
use super::read::read_text;
use super::schema::{SchemaNode, closest, node_at, unknown_fields_of};
use super::{IoError, write_atomically};
use crate::scene::{SCENE_VERSION, Scene, SceneError, brief, one_line};
use serde::de::DeserializeOwned;
use serde_json::Value;
use std::path::Path;

/// Scene files larger than this are refused [bytes].
pub const MAX_SCENE_BYTES: u64 = 64 << 20;

/// Reads a scene file and checks it.
///
/// # Errors
/// [`IoError::InFile`] with what is wrong: no regular file of sensible size, no JSON, another version, another shape
/// than a scene has, or a value that [`Scene::validate`] refuses.
pub fn load_scene(path: &Path) -> Result<Scene, IoError> {
    read_text(path, MAX_SCENE_BYTES).and_then(|text| scene_from_json(&text)).map_err(|error| error.within(path))
}

/// Reads a scene from JSON text and checks it.
///
/// # Errors
/// As [`load_scene`], without the file.
pub fn scene_from_json(text: &str) -> Result<Scene, IoError> {
    checked_scene(&parse(text)?)
}

/// The scene that a value tree holds, if it can be used.
///
/// # Errors
/// [`IoError::Version`], [`IoError::Type`] or [`IoError::Invalid`].
pub(super) fn checked_scene(value: &Value) -> Result<Scene, IoError> {
    check_version(value)?;
    let scene = scene_from_value(value)?;
    scene.validate()?;
    Ok(scene)
}

/// A scene as JSON text for people: indented, short rows of numbers on one line, a line break at the end.
///
/// Every finite number reads back with the same bits. Non-finite ones have no JSON; [`save_scene`] refuses them.
pub fn scene_to_json(scene: &Scene) -> String {
    // Serialising these types to memory cannot fail: their map keys are strings.
    let text = serde_json::to_string_pretty(scene).unwrap_or_default();
    join_rows(&text)
}

/// Checks a scene and writes it, wholly or not at all. Temporary files that killed writers left in the folder are
/// removed.
///
/// # Errors
/// [`IoError::InFile`] with [`IoError::Invalid`] for a scene that could not be loaded again, or [`IoError::Write`].
pub fn save_scene(path: &Path, scene: &Scene) -> Result<(), IoError> {
    scene.validate().map_err(|error| IoError::Invalid(error).within(path))?;
    sweep(path);
    write_atomically(path, |out| {
        check_numbers(scene)?;
        out.write_all(scene_to_json(scene).as_bytes())
    })
}

/// The scene that a value tree holds, unchecked.
fn scene_from_value(value: &Value) -> Result<Scene, IoError> {
    serde_path_to_error::deserialize(value).map_err(|error| {
        let (path, found) = deepest(value, pointer_of(error.path()));
        let message = error.inner().to_string();
        let (problem, remedy) = match missing_field(&message) {
            Some(field) => (format!("lacks the member {field:?}"), add_field(value, &path, field)),
            None => (mismatch(&message), describe(&path)),
        };
        IoError::Type(SceneError { path, value: brief(found), problem: one_line(&problem), remedy })
    })
}

/// A value tree as a thing of a type.
///
/// # Errors
/// Where it is none, what stands there and what is wrong with it, as a part of a sentence.
pub(crate) fn typed<T: DeserializeOwned>(value: &Value) -> Result<T, String> {
    serde_path_to_error::deserialize(value).map_err(|error| {
        let (path, found) = deepest(value, pointer_of(error.path()));
        let message = error.inner().to_string();
        let problem = match missing_field(&message) {
            Some(field) => format!("lacks the member {field:?}"),
            None => mismatch(&message),
        };
        let at = if path.is_empty() { "/" } else { &path };
        one_line(&format!("{at}: {} {problem}", brief(found)))
    })
}

/// The longest part of a pointer that leads to a value: of a choice that is wrong its names lead nowhere.
fn deepest(value: &Value, mut pointer: String) -> (String, &Value) {
    loop {
        if let Some(found) = value.pointer(&pointer) {
            return (pointer, found);
        }
        pointer.truncate(pointer.rfind('/').unwrap_or(0));
    }
}

fn missing_field(message: &str) -> Option<&str> {
    message.strip_prefix("missing field `")?.split('`').next()
}

/// What to do about a missing member: often it is there, misspelt.
fn add_field(value: &Value, path: &str, field: &str) -> String {
    let described = node_at(path).and_then(|node| node.child(field)).map_or("", SchemaNode::description);
    let described = first_paragraph(described);
    let add = if described.is_empty() { "add it".to_owned() } else { format!("add it: {described}") };
    let unknown = unknown_fields_of(value);
    let here = unknown.iter().filter_map(|other| other.strip_prefix(path)?.strip_prefix('/'));
    match closest(field, here) {
        Some(other) => format!("{add} (is {other:?} a misspelling of it?)"),
        None => add,
    }
}

/// What the schema says belongs at a place.
fn describe(path: &str) -> String {
    match node_at(path).map_or("", SchemaNode::description) {
        "" => "see `sinew schema`".to_owned(),
        text => format!("it stands for: {}", first_paragraph(text)),
    }
}

/// The first paragraph of a description, which says what it is; a message is one line.
fn first_paragraph(text: &str) -> String {
    let lines: Vec<&str> = text.lines().take_while(|line| !line.is_empty()).collect();
    lines.join(" ")
}

/// What serde says of a value of another shape, without the value, which stands beside it, and in plain words.
fn mismatch(message: &str) -> String {
    const PLAIN: [(&str, &str); 9] = [
        ("f64", "a number"),
        ("u8", "a whole number from 0 to 255"),
        ("u32", "a whole number from 0 to 4294967295"),
        ("a sequence", "an array"),
        ("map with a single key", "an object with a single member"),
        ("newtype variant", "an object with this name as its only member"),
        ("struct variant", "an object with this name as its only member"),
        ("unit variant", "a name without members"),
        ("variant identifier", "a name"),
    ];
    let (_, expected) = message.rsplit_once(", expected ").unwrap_or(("", "another value"));
    let expected = PLAIN.iter().find(|(rust, _)| *rust == expected).map_or(expected, |(_, plain)| plain);
    let expected = expected.strip_prefix("struct ").map_or(expected.to_owned(), |name| format!("an object ({name})"));
    let fault = if message.starts_with("unknown variant") { "is unknown here" } else { "has the wrong type" };
    format!("{fault}, expected {expected}")
}

/// Refuses versions of the format that this program does not read, before anything else is made of the file.
fn check_version(value: &Value) -> Result<(), IoError> {
    let fail = |path: &str, found: &Value, problem: String, remedy: String| {
        Err(IoError::Version(SceneError { path: path.to_owned(), value: brief(found), problem, remedy }))
    };
    let Value::Object(members) = value else {
        return fail("", value, "is not an object".to_owned(), "give a scene, {\"version\": 1, ...}".to_owned());
    };
    let known = format!("\"version\": {SCENE_VERSION}");
    match members.get("version") {
        None => fail("", value, "has no version".to_owned(), format!("add {known}")),
        Some(found) => match found.as_u64() {
            Some(version) if version == u64::from(SCENE_VERSION) => Ok(()),
            Some(version) if version > u64::from(SCENE_VERSION) => fail(
                "/version",
                found,
                format!("is newer than this program reads ({SCENE_VERSION})"),
                "use a newer sinew for this scene".to_owned(),
            ),
            _ => fail("/version", found, "is no version of the format".to_owned(), format!("give {known}")),
        },
    }
}

/// Puts arrays of plain values that fit on one line there. Works on lines: JSON strings hold no line breaks.
fn join_rows(pretty: &str) -> String {
    const WIDTH: usize = 100;
    let mut out = String::with_capacity(pretty.len());
    let lines: Vec<_> = pretty.lines().collect();
    let mut index = 0;
    while index < lines.len() {
        let line = lines[index];
        index += 1;
        out += line;
        if line.ends_with('[') {
            let plain = |line: &&str| !line.ends_with(['[', '{', ']', '}']) && !line.ends_with("],");
            let items: Vec<_> = lines[index..].iter().copied().take_while(plain).map(str::trim).collect();
            let close = lines.get(index + items.len()).map_or("", |line| line.trim());
            let length = line.len() + items.iter().map(|item| item.len() + 1).sum::<usize>() + close.len();
            if close.starts_with(']') && length <= WIDTH {
                out += &items.join(" ");
                out += close;
                index += items.len() + 1;
            }
        }
        out.push('\n');
    }
    out
}
