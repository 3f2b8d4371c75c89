//! How numbers are written for people, wherever they are shown: in a table, at a plot, beside a field; and how people
//! write them. Imports nothing.

pub(crate) mod number;
#[cfg(feature = "gui")]
pub(crate) mod quantity;
