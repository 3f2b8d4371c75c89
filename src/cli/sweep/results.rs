//! The rows of a sweep and their file: written while it runs, read again where one goes on.

use super::super::error::printable;
use super::super::{CliError, output};
use super::vary::{Product, Samples, Vary};
use crate::io::{is_there, read_json};
use crate::scene::Measure;
use crate::sim::MeasureReport;
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value, json};
use std::path::Path;
use std::time::{Duration, Instant};

/// Rows that finish within this time of each other are written together.
const BETWEEN_WRITES: Duration = Duration::from_millis(500);

/// One combination of values and what it gave.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct Row {
    pub(super) values: Map<String, Value>,
    pub(super) seconds: f64,
    pub(super) at_rest: bool,
    /// Why the first body that was stopped was stopped.
    pub(super) diverged: Option<String>,
    /// What gained energy that nothing gave it.
    #[serde(default)]
    pub(super) unbalanced: Vec<String>,
    pub(super) measures: Map<String, Value>,
    pub(super) bodies: Value,
    pub(super) wall_seconds: f64,
    /// Units of the measures.
    #[serde(skip)]
    pub(super) units: Vec<(String, String)>,
    /// Which of all combinations it is.
    #[serde(skip)]
    pub(super) index: usize,
}

impl Row {
    /// Measures that are no finite numbers: null in the report.
    pub(super) fn not_finite(&self) -> impl Iterator<Item = &String> {
        self.measures.iter().filter(|(_, value)| value.is_null()).map(|(name, _)| name)
    }

    /// Whether it has neither come to rest nor been stopped.
    pub(super) fn is_restless(&self) -> bool {
        !self.at_rest && self.diverged.is_none()
    }
}

/// The values and units of some measures.
pub(super) fn measured(readings: Vec<MeasureReport>) -> (Map<String, Value>, Vec<(String, String)>) {
    let units = readings.iter().map(|reading| (reading.name.clone(), reading.unit.to_owned())).collect();
    (readings.into_iter().map(|reading| (reading.name, reading.value)).collect(), units)
}

/// The measures of all rows, with their units.
pub(super) fn names_of(rows: &[Row]) -> Vec<(&str, &str)> {
    let mut names: Vec<(&str, &str)> = Vec::new();
    for (name, unit) in rows.iter().flat_map(|row| &row.units) {
        if !names.iter().any(|(other, _)| other == name) {
            names.push((name, unit));
        }
    }
    names
}

/// The rows as CSV, every number in full.
///
/// # Errors
/// Rows that cannot be formatted.
pub(super) fn to_csv(product: &Product<'_>, rows: &[Row]) -> Result<Vec<u8>, csv::Error> {
    let names = names_of(rows);
    let mut writer = csv::Writer::from_writer(Vec::new());
    let pointers = product.row(0).into_iter().map(|(list, _)| list.pointer.clone());
    let measures = names.iter().map(|(name, unit)| format!("{name} [{unit}]"));
    let ends = ["time [s]", "at rest", "diverged"].map(str::to_owned);
    writer.write_record(pointers.chain(measures).chain(ends))?;
    for row in rows {
        let values = product.row(row.index).into_iter().map(|(_, value)| plain(&value));
        let measures = names.iter().map(|(name, _)| row.measures.get(*name).map_or_else(String::new, plain));
        let ends = [row.seconds.to_string(), row.at_rest.to_string(), row.diverged.clone().unwrap_or_default()];
        writer.write_record(values.chain(measures).chain(ends))?;
    }
    writer.into_inner().map_err(|error| csv::Error::from(error.into_error()))
}

/// A value as a cell: text without its quotes.
fn plain(value: &Value) -> String {
    value.as_str().map_or_else(|| value.to_string(), str::to_owned)
}

/// What a sweep is: what must be the same for another to go on from its rows.
#[derive(Clone, Debug, Serialize)]
pub(super) struct Plan<'a> {
    pub(super) scene: &'a str,
    pub(super) vary: &'a [Vary],
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) samples: Option<Samples>,
    /// What else the rows follow from: the scene with all that was set, and how long it is run.
    pub(super) of: Value,
}

/// What a sweep has shown.
#[derive(Serialize)]
struct SweepReport<'a> {
    #[serde(flatten)]
    plan: &'a Plan<'a>,
    /// Whether every row was run to its end; those that were not are left out.
    complete: bool,
    units: Map<String, Value>,
    rows: Vec<&'a Row>,
}

/// The rows that there are, by their number.
pub(super) struct Results<'a> {
    plan: Plan<'a>,
    path: Option<&'a Path>,
    rows: Vec<Option<Row>>,
    written: Instant,
}

impl<'a> Results<'a> {
    /// No rows yet, of `count`, to be kept in the file at `path`.
    pub(super) fn new(plan: Plan<'a>, path: Option<&'a Path>, count: usize) -> Self {
        Self { plan, path, rows: (0..count).map(|_| None).collect(), written: Instant::now() }
    }

    /// Takes over the rows in the file, if there is one, with their measures in the order of these; tells how many.
    ///
    /// # Errors
    /// A file that is no report of the same sweep.
    pub(super) fn resume(&mut self, product: &Product<'_>, measures: &[Measure]) -> Result<usize, CliError> {
        let Some(path) = self.path.filter(|path| is_there(path)) else { return Ok(0) };
        let refused = |what: String| CliError::CannotResume { path: printable(path), what };
        let before = read_json(path)?;
        let same = json!(&self.plan);
        for (field, now) in same.as_object().into_iter().flatten() {
            if before.get(field) != Some(now) {
                let what = if field == "of" { "scene, what is set in it or the time" } else { field };
                return Err(refused(format!("it is of another sweep (its {what} differs)")));
            }
        }
        let rows = before.get("rows").cloned().unwrap_or_default();
        let rows: Vec<Row> =
            serde_json::from_value(rows).map_err(|error| refused(format!("its rows cannot be read: {error}")))?;
        let units = before.get("units").and_then(Value::as_object).into_iter().flatten();
        let mut units: Vec<(String, String)> =
            units.map(|(name, unit)| (name.clone(), unit.as_str().unwrap_or_default().to_owned())).collect();
        // JSON has them by name.
        units.sort_by_key(|(name, _)| measures.iter().position(|measure| measure.name == *name));
        let mut found = 0;
        let mut rows = rows.into_iter().peekable();
        for index in 0..self.rows.len() {
            if let Some(row) = rows.next_if(|row| row.values == product.object(index)) {
                self.rows[index] = Some(Row { index, units: units.clone(), ..row });
                found += 1;
            }
        }
        Ok(found)
    }

    /// Numbers of the rows that are still to be run.
    pub(super) fn missing(&self) -> Vec<usize> {
        (0..self.rows.len()).filter(|&index| self.rows[index].is_none()).collect()
    }

    /// Takes a row, and writes what there is if that was not done just now.
    ///
    /// # Errors
    /// The file cannot be written.
    pub(super) fn push(&mut self, row: Row) -> Result<(), CliError> {
        let index = row.index;
        self.rows[index] = Some(row);
        if self.path.is_some() && self.written.elapsed() >= BETWEEN_WRITES {
            self.write()?;
        }
        Ok(())
    }

    /// The rows that there are.
    pub(super) fn rows(&self) -> impl Iterator<Item = &Row> + Clone {
        self.rows.iter().flatten()
    }

    /// Writes the file, if there is to be one; gives the line that says so.
    ///
    /// # Errors
    /// The file cannot be written.
    pub(super) fn write(&mut self) -> Result<String, CliError> {
        let Some(path) = self.path else { return Ok(String::new()) };
        let units = self.rows().flat_map(|row| &row.units);
        let units = units.map(|(name, unit)| (name.clone(), Value::from(unit.as_str()))).collect();
        let rows: Vec<&Row> = self.rows().collect();
        let complete = rows.len() == self.rows.len();
        let said = output::write_report(path, &SweepReport { plan: &self.plan, complete, units, rows })?;
        self.written = Instant::now();
        Ok(said)
    }
}
