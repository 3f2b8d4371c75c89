//! A measure over what a sweep varies, as SVG.

use super::super::CliError;
use super::super::svg::{Canvas, Scale};
use super::results::Row;
use super::vary::Vary;
use crate::scene::{Scene, one_line};
use serde_json::Value;

/// What is drawn over what.
pub(super) struct Against {
    x: String,
    y: String,
    /// What tells the lines apart.
    others: Vec<String>,
}

impl Against {
    /// What the arguments ask for, or the first measure over the first value that is varied.
    ///
    /// # Errors
    /// A pointer that is not varied, a measure that there is not.
    pub(super) fn of(vary: &[Vary], x: Option<&String>, y: Option<&String>, scene: &Scene) -> Result<Self, CliError> {
        let varied: Vec<&String> = vary.iter().map(|list| &list.pointer).collect();
        let refused = |option: &'static str, given: &str, known: Vec<&String>| CliError::NotToBePlotted {
            option,
            given: one_line(given),
            known: known.into_iter().map(|name| one_line(name)).collect::<Vec<_>>().join(", "),
        };
        let x = x.or(varied.first().copied()).cloned().unwrap_or_default();
        if !varied.contains(&&x) {
            return Err(refused("--plot-x", &x, varied));
        }
        let measures: Vec<&String> = scene.measures.iter().map(|measure| &measure.name).collect();
        let y = y.or(measures.first().copied()).cloned().unwrap_or_default();
        if !measures.contains(&&y) {
            return Err(refused("--plot-y", &y, measures));
        }
        let others = varied.into_iter().filter(|pointer| **pointer != x).cloned().collect();
        Ok(Self { x, y, others })
    }
}

/// The plot: a line for each combination of all else that is varied. Rows that diverged, and values that are no
/// numbers, are left out; of a vector its length is drawn.
pub(super) fn plot(title: &str, against: &Against, rows: &[Row]) -> String {
    let mut lines: Vec<(String, Vec<(f64, f64)>)> = Vec::new();
    for row in rows.iter().filter(|row| row.diverged.is_none()) {
        let x = row.values.get(&against.x).and_then(Value::as_f64);
        let y = row.measures.get(&against.y).and_then(size);
        let (Some(x), Some(y)) = (x, y) else { continue };
        let name: Vec<String> = against.others.iter().map(|pointer| label(pointer, row)).collect();
        let name = name.join(", ");
        match lines.iter_mut().find(|(other, _)| *other == name) {
            Some((_, points)) => points.push((x, y)),
            None => lines.push((name, vec![(x, y)])),
        }
    }
    let unit = rows.iter().flat_map(|row| &row.units).find(|(name, _)| *name == against.y);
    let unit = unit.map_or_else(String::new, |(_, unit)| format!(" [{unit}]"));
    let points = || lines.iter().flat_map(|(_, points)| points);
    let scales = [Scale::linear(points().map(|point| point.0)), Scale::linear(points().map(|point| point.1))];
    let names = [one_line(&against.x), one_line(&format!("{}{unit}", against.y))];
    let mut canvas = Canvas::new(&one_line(title), names.each_ref().map(String::as_str), scales);
    for (index, (name, points)) in lines.iter_mut().enumerate() {
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
        canvas.line(index, &one_line(name), points);
    }
    canvas.finish()
}

/// A number, or the length of a vector.
fn size(value: &Value) -> Option<f64> {
    match value {
        Value::Array(parts) => {
            let squares: Option<Vec<f64>> = parts.iter().map(|part| part.as_f64().map(|part| part * part)).collect();
            squares.map(|squares| squares.iter().sum::<f64>().sqrt())
        }
        other => other.as_f64(),
    }
}

/// The last word of a pointer, and the value there.
fn label(pointer: &str, row: &Row) -> String {
    let word = pointer.rsplit('/').find(|word| word.parse::<usize>().is_err()).unwrap_or(pointer);
    format!("{word} {}", row.values.get(pointer).unwrap_or(&Value::Null))
}
