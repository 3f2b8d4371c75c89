//! Forces: a file or a folder for each, beside what several share. A body is a
//! [`ParticleState`](super::state::ParticleState) with a list of these.

mod active_springs;
mod air_drag;
mod bricks;
mod collider_contact;
mod contact;
pub(crate) mod element;
pub(crate) mod fibre;
mod flow;
mod force;
mod grab;
mod gravity;
mod grip;
mod led_springs;
pub(crate) mod matrix;
mod pair_damping;
pub(crate) mod pressure;
mod self_contact;
pub(crate) mod sheet;
pub(crate) mod springs;

pub(crate) use active_springs::ActiveSprings;
pub(crate) use air_drag::AirDrag;
pub(crate) use collider_contact::ColliderContact;
pub(crate) use contact::{Contact, ContactLaw, Plane};
pub(crate) use element::ElementForce;
pub(crate) use fibre::FibreForce;
pub(crate) use flow::{Flow, FlowSurface};
pub(crate) use force::total_forces;
pub use force::{Force, StepLimit};
pub use grab::Grab;
pub(crate) use gravity::Gravity;
pub(crate) use grip::Grip;
pub(crate) use led_springs::LedSprings;
pub use matrix::{Elasticity, EvaluationKind, MatrixForce, SeamTear};
pub(crate) use matrix::{Inelastic, InelasticLaw, MatrixThinning, Plasticity, SeamBonds, Viscosity};
pub(crate) use pair_damping::PairDamping;
pub(crate) use pressure::Pressure;
pub(crate) use self_contact::{SelfContact, SelfTouching, surface_particles};
pub(crate) use sheet::SheetForce;
pub(crate) use springs::Springs;
