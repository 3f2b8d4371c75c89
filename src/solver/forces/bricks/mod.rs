//! Particles of a lattice in bricks of four or eight along a row, so that vector code takes as many neighbours of a row
//! at a time.
//!
//! ```text
//!   a row of the lattice      . o o o o o o .      o a particle, . a cell without one
//!   its bricks                [. o o o][o o o .]
//! ```
//!
//! A place of a brick without a particle holds zeros wherever bricks hold numbers, so that no sum has to ask what is
//! there.

mod alignment;
mod layout;
mod palette;

pub(crate) use alignment::Alignment;
pub(crate) use layout::{Bricks, NO_PARTICLE, brick_and_lane};
pub(crate) use palette::Palette;
