//! The published JSON Schema, and what follows from it: which fields a scene file has that this program does not know.

use super::json::{escape, pointer_tokens};
use crate::scene::Scene;
use serde_json::{Map, Value};
use std::sync::LazyLock;

static SCHEMA: LazyLock<Value> = LazyLock::new(|| schemars::schema_for!(Scene).to_value());

/// JSON Schema (draft 2020-12) of scene files.
pub fn scene_schema() -> &'static Value {
    &SCHEMA
}

/// Pointers to the fields of a scene that this program keeps but does not use, in the order of their names.
pub fn unknown_fields(scene: &Scene) -> Vec<String> {
    serde_json::to_value(scene).map(|value| unknown_fields_of(&value)).unwrap_or_default()
}

/// [`unknown_fields`] of a value tree.
pub(super) fn unknown_fields_of(value: &Value) -> Vec<String> {
    let mut found = Vec::new();
    collect_unknown(SchemaNode(&SCHEMA), value, "", &mut found);
    found
}

fn collect_unknown(node: SchemaNode, value: &Value, path: &str, found: &mut Vec<String>) {
    match value {
        Value::Object(members) => {
            for (name, member) in members {
                let path = format!("{path}/{}", escape(name));
                match node.member(name) {
                    Some(node) => collect_unknown(node, member, &path, found),
                    None => found.push(path),
                }
            }
        }
        Value::Array(items) => {
            for (index, item) in items.iter().enumerate() {
                if let Some(node) = node.item() {
                    collect_unknown(node, item, &format!("{path}/{index}"), found);
                }
            }
        }
        _ => {}
    }
}

/// A part of the schema: what may stand at one place of a scene file.
#[derive(Clone, Copy)]
pub(super) struct SchemaNode(&'static Value);

impl SchemaNode {
    /// What may stand at the place that these pointer tokens lead to.
    pub(super) fn at<'a>(tokens: impl IntoIterator<Item = &'a str>) -> Option<Self> {
        tokens.into_iter().try_fold(Self(&SCHEMA), Self::child)
    }

    /// What may stand in the member or item of this name.
    pub(super) fn child(self, token: &str) -> Option<Self> {
        self.member(token).or_else(|| self.item())
    }

    /// What the place is for, without the closing full stop.
    pub(super) fn description(self) -> &'static str {
        let own = |node: Self| node.0.get("description").and_then(Value::as_str);
        own(self).or_else(|| own(self.resolve())).unwrap_or_default().trim_end_matches('.')
    }

    /// Names of the members that may stand here, those of every alternative included.
    pub(super) fn members(self) -> Vec<&'static str> {
        self.shapes()
            .iter()
            .filter_map(|shape| shape.get("properties")?.as_object())
            .flat_map(Map::keys)
            .map(String::as_str)
            .collect()
    }

    /// Whether one of several alternatives stands here, each an object with one member or a name.
    pub(super) fn is_choice(self) -> bool {
        self.resolve().0.get("oneOf").is_some()
    }

    /// Whether a list stands here.
    pub(super) fn is_list(self) -> bool {
        self.item().is_some()
    }

    fn member(self, name: &str) -> Option<Self> {
        self.shapes().iter().find_map(|shape| shape.get("properties")?.get(name)).map(Self)
    }

    fn item(self) -> Option<Self> {
        self.resolve().0.get("items").map(Self)
    }

    /// The alternatives that may stand here; most often there is one.
    fn shapes(self) -> &'static [Value] {
        let schema = self.resolve().0;
        schema.get("oneOf").and_then(Value::as_array).map_or(std::slice::from_ref(schema), Vec::as_slice)
    }

    /// The definition that this part refers to, or itself.
    fn resolve(self) -> Self {
        // What may be left out is itself or null.
        let optional = self.0.get("anyOf").and_then(Value::as_array);
        let schema = optional.and_then(|any| any.iter().find(|part| part.get("$ref").is_some())).unwrap_or(self.0);
        let target = schema.get("$ref").and_then(Value::as_str).and_then(|target| target.strip_prefix('#'));
        target.and_then(|pointer| SCHEMA.pointer(pointer)).map_or(self, Self)
    }
}

/// What may stand at a pointer.
pub(super) fn node_at(pointer: &str) -> Option<SchemaNode> {
    let tokens: Vec<_> = pointer_tokens(pointer).collect();
    SchemaNode::at(tokens.iter().map(AsRef::as_ref))
}

/// The candidate that `name` is most likely a misspelling of.
pub(super) fn closest<'a>(name: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let most = (name.chars().count() / 3).max(2);
    let ranked = candidates.into_iter().map(|candidate| (edits(name, candidate), candidate));
    ranked.filter(|(distance, _)| *distance <= most).min().map(|(_, candidate)| candidate)
}

/// Insertions, deletions and replacements of characters that turn one name into another (Levenshtein's distance).
fn edits(from: &str, to: &str) -> usize {
    let to: Vec<char> = to.chars().collect();
    let mut row: Vec<usize> = (0..=to.len()).collect();
    for (i, a) in from.chars().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, &b) in to.iter().enumerate() {
            let replaced = diagonal + usize::from(a != b);
            diagonal = row[j + 1];
            row[j + 1] = replaced.min(row[j] + 1).min(diagonal + 1);
        }
    }
    row[to.len()]
}
