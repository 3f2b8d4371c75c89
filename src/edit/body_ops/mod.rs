//! What can be done to a whole body: pure functions from a body to the body as it is to be, for a
//! [`Command`](super::Command) to put into the document.
//!
//! How it works. A body is moved and turned by its placement, and what of it is given in the world, such as the point
//! about which a pin turns it, goes along. It is scaled in its model frame: shape, fibres, regions and what is painted,
//! and with them the support radius, so that it is filled by as many particles as before.
//!
//! What scaling keeps is the material: the modulus and density of the matrix, and those of the fibres, whose stiffness
//! grows with their cross-section. A two-layer body has no material but its springs; its masses, gas and damping follow
//! so that it sags, swings and bulges by the same share of its size.

mod change;
mod copy;
mod filling;
mod of_elements;
mod of_fibres;
mod of_pins;
mod of_two_layer;
mod rigid;

pub use change::{moved, placed, scaled, turned};
pub use copy::copy;
pub use filling::{filled_by, of_any_filling};
pub use of_two_layer::scaled_two_layer;
