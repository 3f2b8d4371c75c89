//! How numbers are written for people, wherever they are shown: in a table, at a plot, beside a field. Imports nothing.

pub(crate) mod number;
