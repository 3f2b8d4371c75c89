//! How numbers are written for people, wherever they are shown: in a table, at a plot, beside a field; and how people
//! write them; and how a content is told by a number. Imports nothing.

pub(crate) mod fnv;
pub(crate) mod number;
#[cfg(feature = "gui")]
pub(crate) mod quantity;
