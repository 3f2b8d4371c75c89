//! The solver: a world of bodies and its step. Knows no scene file, clock, thread start, egui or wgpu.
//!
//! A body is a [`ParticleState`] with a list of `forces`, grabs among them, and any of the `integrators` steps any
//! body. Contact between bodies and with panels belongs to pairs and is no force of that list: the `world` evaluates
//! it. Positions are world coordinates in metres; rest data are in the body's model frame, and rotations carry one into
//! the other. State and forces are f64.

mod account;
pub(crate) mod body;
pub(crate) mod body_contact;
pub(crate) mod collider;
pub(crate) mod constraint;
pub(crate) mod contact_surface;
pub(crate) mod drive;
pub(crate) mod drive_along;
pub(crate) mod driven;
pub(crate) mod driven_fractions;
pub(crate) mod dynamics;
pub(crate) mod eased_overlap;
pub(crate) mod embedding;
pub(crate) mod energy;
pub(crate) mod field;
pub(crate) mod forces;
pub(crate) mod hand;
pub(crate) mod implicit;
pub(crate) mod integrators;
pub(crate) mod layers;
pub(crate) mod led;
pub(crate) mod linear_algebra;
pub(crate) mod measure;
pub(crate) mod modes;
mod momentum;
pub(crate) mod neighbourhood;
pub(crate) mod outside;
mod outside_body;
pub(crate) mod overlap;
pub(crate) mod panel;
pub(crate) mod rotation;
pub(crate) mod scratch;
pub(crate) mod shared_drive;
pub(crate) mod skin;
mod skin_arms;
mod skin_weights;
pub(crate) mod snapshot;
pub(crate) mod stable_step;
pub(crate) mod state;
pub(crate) mod swing;
mod unbalanced;
pub(crate) mod volume_fraction;
mod way_out;
mod wide;
pub(crate) mod world;

pub use body::{Body, BodyParts, Divergence, ElementLines, FibreLine, RestScale, SheetSurface, SurfacePoint};
pub use collider::{Collider, Pose};
pub use dynamics::{Dynamics, Fallbacks};
pub use eased_overlap::EasedOverlap;
pub use embedding::EmbeddingWeights;
pub use energy::Energies;
pub use field::FieldKind;
pub use forces::element::{Change, Element, ElementFault, Local, MOST_POINTS, Slopes, check as check_element};
pub use forces::springs::SpringKind;
pub use forces::{Force, Grab, SeamTear, StepLimit};
pub use hand::Hand;
pub use integrators::Integrator;
pub use measure::MeasureValue;
pub use overlap::{Against, Overlap};
pub use panel::Panel;
pub use snapshot::{
    ActivationSnapshot, BodySnapshot, BreakPlace, ColliderSnapshot, FibreBreak, FibreSnapshot, FieldSnapshot,
    LayersSnapshot, SkinEmbedding, Snapshot, TensionSnapshot,
};
pub use state::ParticleState;
pub use swing::Swing;
pub use unbalanced::Unbalanced;
pub use world::{Accuracy, Checkpoint, MOST_GAINED, Probe, World};
