//! Values set by RFC 6901 pointers, as `--set /bodies/0/material/young_modulus=2e5` asks for.

use super::IoError;
use super::json::{parse, pointer_tokens};
use super::scene::checked_scene;
use super::schema::{SchemaNode, closest, node_at, unknown_fields_of};
use crate::scene::{Scene, SceneError, brief, one_line};
use serde_json::{Map, Value};

/// The scene with some of its values replaced, checked. Each set is a pointer and the JSON text of its new value.
///
/// Fields that the scene leaves at their defaults can be set too.
///
/// # Errors
/// As `set_pointer` for each set in turn, then [`IoError::Type`], [`IoError::Version`] or [`IoError::Invalid`] for
/// what they make of the scene.
pub fn apply_sets<'a>(scene: &Scene, sets: impl IntoIterator<Item = (&'a str, &'a str)>) -> Result<Scene, IoError> {
    // Serialising these types cannot fail: their map keys are strings.
    let mut value = serde_json::to_value(scene).unwrap_or_default();
    for (pointer, text) in sets {
        set_pointer(&mut value, pointer, text)?;
    }
    checked_scene(&value)
}

/// Replaces the value at a pointer in the value tree of a scene, with its defaults filled in.
///
/// A member that the scene may have but lacks is added; `-` after a list adds an item; a member of a choice, such as
/// `/time/step/manual`, replaces what was chosen before.
///
/// # Errors
/// [`IoError::Pointer`]: text that is not JSON, a pointer that leads into nothing, or a field, in the pointer or in
/// the new value, that this program does not know. The tree is of no further use then.
pub(super) fn set_pointer(value: &mut Value, pointer: &str, json_text: &str) -> Result<(), IoError> {
    let new = parse(json_text).map_err(|error| {
        let problem = format!("is not JSON ({error})");
        failure(pointer, brief(&json_text), &problem, "give a JSON value; text needs double quotes")
    })?;
    if !pointer.is_empty() && !pointer.starts_with('/') {
        let remedy = format!("write /{}", one_line(pointer));
        return Err(failure("", brief(&pointer), "is not a pointer", &remedy));
    }
    *place(value, pointer)? = new;
    match unknown_fields_of(value).iter().find(|path| touches(path, pointer)) {
        Some(path) => {
            let parent = path.rsplit_once('/').map_or("", |(parent, _)| parent);
            Err(no_such(path, parent, &node_at(parent).map(SchemaNode::members).unwrap_or_default()))
        }
        None => Ok(()),
    }
}

/// The place that a pointer names, made where it may be and is not yet.
fn place<'v>(root: &'v mut Value, pointer: &str) -> Result<&'v mut Value, IoError> {
    let mut here = root;
    let mut node = SchemaNode::at([]);
    let mut path = String::new();
    let count = pointer_tokens(pointer).count();
    for (index, token) in pointer_tokens(pointer).enumerate() {
        let last = index + 1 == count;
        let next = node.and_then(|node| node.child(&token));
        let may_make = next.is_some_and(|next| last || next.is_list());
        if last && may_make && node.is_some_and(SchemaNode::is_choice) {
            *here = Value::Object(Map::new());
        }
        here = match here {
            Value::Object(members) => {
                if may_make && !members.contains_key(&*token) {
                    let empty = if last { Value::Null } else { Value::Array(Vec::new()) };
                    members.insert(token.to_string(), empty);
                }
                if !members.contains_key(&*token) {
                    let present: Vec<_> = members.keys().map(String::as_str).collect();
                    return Err(match node {
                        Some(node) if node.is_choice() && next.is_some() => {
                            not_chosen(pointer, &path, &token, &present)
                        }
                        Some(node) => no_such(pointer, &path, &node.members()),
                        None => no_such(pointer, &path, &present),
                    });
                }
                &mut members[&*token]
            }
            Value::Array(items) => {
                let length = items.len();
                if last && token == "-" {
                    items.push(Value::Null);
                }
                let at = if last && token == "-" { Some(length) } else { item_index(&token) };
                items.get_mut(at.unwrap_or(usize::MAX)).ok_or_else(|| no_item(pointer, &path, length))?
            }
            plain => {
                let problem = format!("leads into {path}, which is {} and has no members", brief(plain));
                return Err(failure(pointer, "the pointer".to_owned(), &problem, &format!("set {path} itself")));
            }
        };
        path = pointer.split('/').take(index + 2).collect::<Vec<_>>().join("/");
        node = next;
    }
    Ok(here)
}

fn no_such(pointer: &str, parent: &str, members: &[&str]) -> IoError {
    let parent_name = if parent.is_empty() { "the scene" } else { parent };
    let name = pointer.strip_prefix(parent).and_then(|rest| rest.split('/').nth(1)).unwrap_or_default();
    let remedy = match closest(name, members.iter().copied()) {
        Some(near) => format!("did you mean {near:?}? It has {}", members.join(", ")),
        None if members.is_empty() => "set another field".to_owned(),
        None => format!("it has {}", members.join(", ")),
    };
    failure(pointer, brief(&name), &format!("is no member of {parent_name}"), &remedy)
}

fn not_chosen(pointer: &str, parent: &str, name: &str, chosen: &[&str]) -> IoError {
    let problem = format!("is not what {parent} holds, which is {}", chosen.join(", "));
    failure(pointer, brief(&name), &problem, &format!("set {parent}/{name} as a whole"))
}

fn no_item(pointer: &str, parent: &str, length: usize) -> IoError {
    let remedy = match length {
        0 => format!("add one as {parent}/- first"),
        _ => format!("use an index from 0 to {}, or - as the last token to add an item", length - 1),
    };
    failure(pointer, "the pointer".to_owned(), &format!("leads to no item of {parent}, which has {length}"), &remedy)
}

fn failure(pointer: &str, value: String, problem: &str, remedy: &str) -> IoError {
    IoError::Pointer(SceneError {
        path: one_line(pointer),
        value,
        problem: one_line(problem),
        remedy: one_line(remedy),
    })
}

/// Whether a path is at, below or above a pointer. `-` stands for the item that was just added.
fn touches(path: &str, pointer: &str) -> bool {
    path.split('/').zip(pointer.split('/')).all(|(name, token)| name == token || token == "-")
}

/// An array index as RFC 6901 has it: digits without leading zeros.
fn item_index(token: &str) -> Option<usize> {
    let digits = token.bytes().all(|byte| byte.is_ascii_digit());
    if digits && (token == "0" || !token.starts_with('0')) { token.parse().ok() } else { None }
}
