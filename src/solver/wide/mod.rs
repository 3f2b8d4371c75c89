//! Linear algebra of several particles at a time: every entry of a vector, a matrix or a quaternion is a SIMD register
//! with a lane for each particle. Knows no force.
//!
//! Plain loops and no closures: a closure that is handed to the standard library (`map`, `from_fn`) is compiled without
//! the dispatched instruction set, and each of its vector operations then is a call.

mod lanes;
mod matrix;
mod quaternion;
mod rotation;
mod vector;

pub(crate) use lanes::{LANES, Lanes, Lanes4, Lanes8, Short8, Wide, load_all, quaternion_of, vector_of};
pub(crate) use matrix::Mat3x;
pub(crate) use quaternion::Quatx;
pub(crate) use rotation::nearest_rotations;
pub(crate) use vector::Vec3x;
