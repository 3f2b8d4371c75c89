//! A motion written for other programs, as it goes: each file is whole up to its last frame, whatever ends the run.
//!
//! Formats that grow by a frame at their end are written on ([`caches`], PC2); those that say at their head how much
//! there is are written anew whenever a half has been added, and at the end ([`republished`]: MDD, glTF); all else is a
//! file a frame ([`tables`], [`meshes`], and USD's value clips, [`usd`]).

mod caches;
mod formats;
mod gltf;
mod gltf_clip;
mod looks;
mod meshes;
mod names;
mod obj;
#[cfg(feature = "gui")]
mod outline;
mod ply;
mod republished;
mod tables;
mod usd;
mod usd_shape;
mod usd_text;
mod writer;

pub(crate) use formats::{MotionFiles, MotionFormat};
