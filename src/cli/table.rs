//! Tables for people.

use crate::text::number::four_figures;

/// Where the text of a column stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Align {
    /// Words.
    Left,
    /// Numbers.
    Right,
}

/// A table of aligned columns. Numbers stand to the right, words to the left.
#[derive(Clone, Debug, Default)]
pub(super) struct Table {
    rows: Vec<Vec<String>>,
    aligns: Vec<Align>,
}

const GAP: &str = "  ";

impl Table {
    /// A table with these columns.
    pub(super) fn new(columns: impl IntoIterator<Item = (impl Into<String>, Align)>) -> Self {
        let (head, aligns) = columns.into_iter().map(|(name, align)| (name.into(), align)).unzip();
        Self { rows: vec![head], aligns }
    }

    /// Adds a row.
    pub(super) fn push(&mut self, row: impl IntoIterator<Item = String>) {
        self.rows.push(row.into_iter().collect());
    }

    /// Whether it has no row but its head.
    pub(super) fn is_empty(&self) -> bool {
        self.rows.len() < 2
    }

    /// The table as text, a line a row.
    pub(super) fn render(&self) -> String {
        let widths: Vec<usize> = (0..self.aligns.len()).map(|column| self.width(column)).collect();
        let mut text = String::new();
        for row in &self.rows {
            let cells = row.iter().zip(&self.aligns).zip(&widths).map(|((cell, align), &width)| match align {
                Align::Left => format!("{cell:<width$}"),
                Align::Right => format!("{cell:>width$}"),
            });
            text += cells.collect::<Vec<_>>().join(GAP).trim_end();
            text.push('\n');
        }
        text
    }

    /// Width of a column [characters].
    fn width(&self, column: usize) -> usize {
        let cells = self.rows.iter().filter_map(|row| row.get(column));
        cells.map(|cell| cell.chars().count()).max().unwrap_or(0)
    }
}

/// A JSON value of a report for people: numbers to four figures, vectors in parentheses.
pub(super) fn readable(value: &serde_json::Value) -> String {
    match value {
        serde_json::Value::Number(number) => number.as_f64().map_or_else(|| number.to_string(), four_figures),
        serde_json::Value::Array(items) => {
            format!("({})", items.iter().map(readable).collect::<Vec<_>>().join(", "))
        }
        other => other.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_stand_below_each_other() {
        let mut table = Table::new([("name", Align::Left), ("value", Align::Right)]);
        assert!(table.is_empty());
        table.push(["größe".to_owned(), "1".to_owned()]);
        table.push(["x".to_owned(), "23.5".to_owned()]);
        assert_eq!(table.render(), "name   value\ngröße      1\nx       23.5\n");
    }
}
