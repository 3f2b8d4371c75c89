//! Energies, momenta and measures frame by frame: rows for tables and plots.

use crate::scene::one_line;
use crate::solver::body::Body;
use crate::solver::energy::Energies;
use crate::solver::measure::MeasureValue;
use crate::solver::world::World;
use std::collections::{HashSet, VecDeque};
use std::io;

const AXES: [&str; 3] = ["x", "y", "z"];

/// What a column holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ColumnKind {
    /// Simulated time.
    Time,
    /// An energy of a body, by its place in [`Energies::NAMES`].
    Energy(usize),
    /// A component of a body's linear momentum.
    LinearMomentum(usize),
    /// A component of a body's angular momentum about the world's origin.
    AngularMomentum(usize),
    /// A measure.
    Measure,
}

/// A column.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Column {
    /// Its name, with the body's where there are several.
    pub name: String,
    /// Its unit.
    pub unit: &'static str,
    /// What it holds.
    pub kind: ColumnKind,
}

/// Rows so far, one a frame, under columns that are those of a world.
#[derive(Clone, Debug, Default)]
pub struct TimeSeries {
    columns: Vec<Column>,
    rows: VecDeque<Box<[f64]>>,
    /// Rows that are kept at most.
    most: usize,
    /// Rows that had to make room.
    dropped: u64,
    /// Which columns have ever held anything but zero.
    used: Vec<bool>,
}

impl TimeSeries {
    /// No rows yet of a world; of more than `most` rows the oldest are dropped.
    pub fn new(world: &World, most: usize) -> Self {
        let columns = columns(world);
        let used = vec![false; columns.len()];
        Self { columns, rows: VecDeque::new(), most, dropped: 0, used }
    }

    /// Adds the present frame of the world in place of all that are not before it: the world was put back to there.
    pub fn push(&mut self, world: &World) {
        let row = row(world);
        let had_rows = !self.rows.is_empty();
        while self.rows.back().is_some_and(|last| last[0] >= row[0]) {
            self.rows.pop_back();
        }
        if had_rows && self.rows.is_empty() {
            self.used.fill(false);
            self.dropped = 0;
        }
        for (used, value) in self.used.iter_mut().zip(&row) {
            *used |= *value != 0.0;
        }
        self.rows.push_back(row.into_boxed_slice());
        while self.rows.len() > self.most {
            self.rows.pop_front();
            self.dropped += 1;
        }
    }

    /// Goes on with a world after an edit: with other names if only those have changed, and without the rows so far where
    /// the columns are others.
    pub(crate) fn continue_with(&mut self, world: &World, most: usize) {
        let columns = columns(world);
        if columns == self.columns {
            return;
        }
        let nature = |column: &Column| (column.unit, column.kind);
        if columns.iter().map(nature).eq(self.columns.iter().map(nature)) {
            self.columns = columns;
        } else {
            let dropped = self.dropped + self.rows.len() as u64;
            *self = Self { dropped, ..Self::new(world, most) };
        }
    }

    /// The first value that is no finite number: its time [s] and the name of its column.
    pub fn not_finite(&self) -> Option<(f64, &str)> {
        self.rows.iter().find_map(|row| {
            let place = row.iter().position(|value| !value.is_finite())?;
            Some((row[0], self.columns[place].name.as_str()))
        })
    }

    /// The columns.
    pub fn columns(&self) -> &[Column] {
        &self.columns
    }

    /// The rows that are kept, oldest first, each with its number since the start.
    pub fn rows(&self) -> impl DoubleEndedIterator<Item = (u64, &[f64])> {
        self.rows.iter().enumerate().map(|(place, row)| (self.dropped + place as u64, &**row))
    }

    /// Number of rows that are kept.
    pub fn len(&self) -> usize {
        self.rows.len()
    }

    /// Whether there is no row.
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    /// Rows that had to make room for later ones.
    pub fn dropped(&self) -> u64 {
        self.dropped
    }

    /// The newest row.
    pub fn last(&self) -> Option<&[f64]> {
        self.rows.back().map(|row| &**row)
    }

    /// The newest row up to a time [s].
    pub fn at(&self, time: f64) -> Option<&[f64]> {
        let after = self.rows.partition_point(|row| row[0] <= time);
        self.rows.get(after.checked_sub(1)?).map(|row| &**row)
    }

    /// Whether a column has ever held anything but zero.
    pub fn is_used(&self, column: usize) -> bool {
        self.used.get(column).copied().unwrap_or_default()
    }

    /// The table as CSV.
    ///
    /// # Errors
    /// A value that is no number, by its column and time, or what cannot be formatted.
    pub fn to_csv(&self) -> Result<Vec<u8>, csv::Error> {
        let mut writer = csv::WriterBuilder::new().has_headers(false).from_writer(Vec::new());
        writer.write_record(self.columns.iter().map(|column| format!("{} [{}]", column.name, column.unit)))?;
        if let Some((time, column)) = self.not_finite() {
            let problem = format!("{column:?} at {time} s is not a finite number, which no table may hold");
            return Err(io::Error::new(io::ErrorKind::InvalidData, problem).into());
        }
        for row in &self.rows {
            writer.serialize(row)?;
        }
        writer.into_inner().map_err(|error| error.into_error().into())
    }
}

/// Names by which bodies are told apart: their names, or their identifiers where two share a name.
pub(crate) fn body_labels(bodies: &[Body]) -> Vec<String> {
    let names: HashSet<&str> = bodies.iter().map(|body| body.parts().name.as_str()).collect();
    let unique = names.len() == bodies.len();
    bodies.iter().map(|body| one_line(if unique { &body.parts().name } else { &body.parts().id })).collect()
}

fn columns(world: &World) -> Vec<Column> {
    let bodies = world.bodies();
    let column = |name: String, unit, kind| Column { name, unit, kind };
    let mut columns = vec![column("time".to_owned(), "s", ColumnKind::Time)];
    for label in body_labels(bodies) {
        let prefix = if bodies.len() > 1 { format!("{label}: ") } else { String::new() };
        let energies = Energies::NAMES.iter().enumerate();
        columns.extend(energies.map(|(k, name)| column(format!("{prefix}{name}"), "J", ColumnKind::Energy(k))));
        for (what, unit, kind) in [
            ("linear_momentum", "kg m/s", ColumnKind::LinearMomentum as fn(usize) -> ColumnKind),
            ("angular_momentum", "kg m²/s", ColumnKind::AngularMomentum),
        ] {
            let axes = AXES.iter().enumerate();
            columns.extend(axes.map(|(k, axis)| column(format!("{prefix}{what} {axis}"), unit, kind(k))));
        }
    }
    for probe in world.probes() {
        let (name, unit) = (one_line(&probe.name), probe.quantity.unit());
        if probe.quantity.is_vector() {
            columns.extend(AXES.map(|axis| column(format!("{name} {axis}"), unit, ColumnKind::Measure)));
        } else {
            columns.push(column(name, unit, ColumnKind::Measure));
        }
    }
    columns
}

fn row(world: &World) -> Vec<f64> {
    let mut row = vec![world.time()];
    for body in world.bodies() {
        row.extend(body.energies(world.time()).values());
        row.extend(body.state().linear_momentum().to_array());
        row.extend(body.state().angular_momentum().to_array());
    }
    for value in world.measures() {
        match value {
            MeasureValue::Scalar(value) => row.push(value),
            MeasureValue::Vector(value) => row.extend(value.to_array()),
        }
    }
    row
}
