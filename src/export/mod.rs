//! A motion as other programs take it: every body's surface on the vertices of the file that it is from, in their
//! order; its fibres with what they carry; its particles with their fields. Plain data; [`crate::io`] writes it.

mod carrier;
mod fibre_directions;
mod frame;
mod motion;
mod normals;
mod panel;
#[cfg(feature = "gui")]
mod sizes;
mod space;
mod subject;

pub(crate) use frame::{BodyFrame, Frame, Wanted};
pub(crate) use motion::Motion;
#[cfg(feature = "gui")]
pub(crate) use sizes::{BodySize, sizes};
pub(crate) use space::Space;
pub(crate) use subject::{BodySubject, Subject};
