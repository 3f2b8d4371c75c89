//! Elements: structures in a body behind one contract (sec. 7 of the fibre paper: "any other user defined structures
//! can be implemented in the same way").
//!
//! An [`Element`] is an energy of a few points that ride on the particles, `p = sum phi x`, and of how the material is
//! turned around some of them, R the rotation of `A = sum om x (x) Z` and `S = R^T A` its stretch. From its slopes the
//! force is passed on by the same weights, `-phi dE/dp` and, of a moment m by the turn in the model frame, `-om R (q x
//! Z)` with `q = (tr S I - S)^-1 m`: a gradient, so that momentum, angular momentum and energy are kept whatever the
//! element is.
//!
//! Built in are stretch, bending and twist of fibres and stretch, shear and bending of sheets, which bodies evaluate in
//! loops of their own (`fibre`, `sheet`) that keep the same contract and are held against these one by one; elements
//! without code, a [`Measure`] times a [`Law`]; and any other that implements the trait.
//!
//! The stable step is measured with `k sum |p - mean|² / 2` in an element's place where it has a majorant k, whatever
//! it does later; else with the element at the start, its law as steep as it is anywhere.

mod bound;
pub(crate) mod check;
pub(crate) mod contract;
mod force;
pub(crate) mod kind;
pub(crate) mod law;
pub(crate) mod measure;
mod measured;
mod structure;

pub use check::{ElementFault, check};
pub use contract::{Change, Element, Local, MOST_POINTS, Slopes};
pub use force::ElementForce;
pub(crate) use kind::Kind;
pub(crate) use law::Law;
pub(crate) use measure::Measure;
pub(crate) use measured::MeasuredElement;
pub(crate) use structure::Structure;
