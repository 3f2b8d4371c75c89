//! What faces look like: parts of a file that are of one name and look, however often the file goes from one to another
//! and back.

use crate::geometry::file_mesh::{FileMesh, FilePart};
use std::collections::HashMap;
use std::ops::Range;

/// A material by its name and its base colour, bit for bit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct Look<'a> {
    material: &'a str,
    colour: Option<[u32; 4]>,
}

impl<'a> Look<'a> {
    pub(super) fn of(part: &'a FilePart) -> Self {
        Self { material: &part.material, colour: part.colour.map(|colour| colour.map(f32::to_bits)) }
    }
}

/// Parts of different names or looks, in the order in which they are met first, with all their runs of faces.
pub(super) fn merged_parts(mesh: &FileMesh) -> Vec<(&FilePart, Vec<Range<usize>>)> {
    let (mut merged, mut numbers) = (Vec::<(&FilePart, Vec<Range<usize>>)>::new(), HashMap::new());
    for part in &mesh.parts {
        let number = *numbers.entry((part.name.as_str(), Look::of(part))).or_insert_with(|| {
            merged.push((part, Vec::new()));
            merged.len() - 1
        });
        merged[number].1.push(part.faces.clone());
    }
    merged
}
