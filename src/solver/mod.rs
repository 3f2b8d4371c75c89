//! The solver: a world of bodies and its step. Knows no scene file, clock, thread start, egui or wgpu.
//!
//! A body is a [`ParticleState`] with a list of [`forces`], grabs among them, and any of the [`integrators`] steps any
//! body. Contact between bodies and with panels belongs to pairs and is no force of that list: the [`world`] evaluates
//! it. Positions are world coordinates in metres; rest data are in the body's model frame, and rotations carry one into
//! the other. State and forces are f64.

pub mod body;
pub mod body_contact;
pub mod constraint;
pub mod dynamics;
pub mod embedding;
pub mod energy;
pub mod field;
pub mod forces;
pub mod integrators;
pub mod layers;
pub mod linear_algebra;
pub mod measure;
pub mod modes;
pub mod neighbourhood;
pub mod panel;
pub mod rotation;
pub mod scratch;
pub mod skin;
pub mod snapshot;
pub mod stable_step;
pub mod state;
pub mod volume_fraction;
mod wide;
pub mod world;

pub use body::{Body, BodyParts, Divergence};
pub use dynamics::Dynamics;
pub use embedding::EmbeddingWeights;
pub use energy::Energies;
pub use forces::{Force, Grab};
pub use integrators::Integrator;
pub use measure::MeasureValue;
pub use snapshot::Snapshot;
pub use state::ParticleState;
pub use world::{Checkpoint, World};
