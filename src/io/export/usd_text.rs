//! USD's text, as far as motions need it.

use glam::DVec3;
use std::fmt::Display;
use std::io::{self, Write};

/// A list in brackets.
pub(super) fn write_list<T: Display>(out: &mut dyn Write, items: impl IntoIterator<Item = T>) -> io::Result<()> {
    write!(out, "[")?;
    for (index, item) in items.into_iter().enumerate() {
        write!(out, "{}{item}", if index == 0 { "" } else { ", " })?;
    }
    write!(out, "]")
}

/// Points or vectors in single precision.
pub(super) fn write_vectors(out: &mut dyn Write, vectors: &[DVec3]) -> io::Result<()> {
    write_list(out, vectors.iter().map(|&v| Vector(v)))
}

struct Vector(DVec3);

impl Display for Vector {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let [x, y, z] = self.0.as_vec3().to_array();
        write!(f, "({x}, {y}, {z})")
    }
}

/// A text between quotation marks.
pub(super) fn quoted(text: &str) -> String {
    let mut quoted = String::from("\"");
    for c in text.chars() {
        match c {
            '"' | '\\' => quoted.extend(['\\', c]),
            c if c.is_control() => quoted.push(' '),
            c => quoted.push(c),
        }
    }
    quoted.push('"');
    quoted
}

/// The box around what is drawn this wide at points.
pub(super) fn extent_of(points: &[DVec3], width: f64) -> [DVec3; 2] {
    let [min, max] = extent(points);
    let half = DVec3::splat(if points.is_empty() { 0.0 } else { 0.5 * width });
    [min - half, max + half]
}

/// The least and the greatest corner of a box around points; a box without extent for none.
pub(super) fn extent(points: &[DVec3]) -> [DVec3; 2] {
    let around = points.iter().map(|&point| [point; 2]).reduce(|a, b| [a[0].min(b[0]), a[1].max(b[1])]);
    around.unwrap_or_default()
}
