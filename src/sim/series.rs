//! Energies, momenta and measures frame by frame: rows for tables and plots.

use super::columns::{Column, columns, row};
use crate::solver::world::World;
use std::collections::{HashMap, VecDeque};
use std::io;

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

    /// Goes on with a world after an edit: with other names if only those of measures have changed, with zeros of
    /// before for pins, fibres and panels that are new, and without the rows so far where bodies or measures are
    /// others.
    pub(crate) fn continue_with(&mut self, world: &World, most: usize) {
        let columns = columns(world);
        if columns == self.columns {
            return;
        }
        let lasting = |columns: &[Column]| -> Vec<_> {
            let lasting = columns.iter().filter(|column| !column.kind.is_of_a_part());
            lasting.map(|column| (column.unit, column.kind)).collect()
        };
        if lasting(&columns) != lasting(&self.columns) {
            let dropped = self.dropped + self.rows.len() as u64;
            *self = Self { dropped, ..Self::new(world, most) };
            return;
        }
        let parts = self.columns.iter().enumerate().filter(|(_, column)| column.kind.is_of_a_part());
        let place_of: HashMap<&str, usize> = parts.map(|(place, column)| (column.name.as_str(), place)).collect();
        let mut lasting = (0..self.columns.len()).filter(|&place| !self.columns[place].kind.is_of_a_part());
        let from: Vec<Option<usize>> =
            columns
                .iter()
                .map(|column| {
                    if column.kind.is_of_a_part() {
                        place_of.get(column.name.as_str()).copied()
                    } else {
                        lasting.next()
                    }
                })
                .collect();
        for row in &mut self.rows {
            *row = from.iter().map(|place| place.map_or(0.0, |place| row[place])).collect();
        }
        self.used = from.iter().map(|place| place.is_some_and(|place| self.used[place])).collect();
        self.columns = columns;
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
