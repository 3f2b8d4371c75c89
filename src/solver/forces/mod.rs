//! Forces: one file a force. A body is a [`ParticleState`](super::state::ParticleState) with a list of these.

mod air_drag;
mod bricks;
mod contact;
pub mod fibre;
mod force;
mod grab;
mod gravity;
pub mod matrix;
mod pair_damping;
pub mod pressure;
pub mod springs;

pub use air_drag::AirDrag;
pub use contact::{Contact, ContactLaw, Plane};
pub use fibre::FibreForce;
pub use force::{Force, StepLimit, total_forces};
pub use grab::Grab;
pub use gravity::Gravity;
pub use matrix::{Elasticity, MatrixForce};
pub use pair_damping::PairDamping;
pub use pressure::Pressure;
pub use springs::Springs;
