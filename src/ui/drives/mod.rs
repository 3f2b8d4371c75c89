//! Drives in the window: lanes below the timeline, in which their courses are seen and their keys are moved, and
//! buttons for keys beside every field that can be driven.
//!
//! How it works. What can be driven is what [`Scene::drivables`](crate::scene::Scene::drivables) lists; what is done to
//! a drive comes from the pure functions of `keys` and leaves as a
//! [`Command::SetDrive`](crate::edit::Command::SetDrive), a whole gesture as one step. A lane that follows a shared
//! drive shows it and leaves its keys to the lane of that.

mod actions;
mod drag;
mod fields;
mod handle;
mod key_button;
mod keys;
mod lane;
mod lanes;
mod value_scale;
mod wave_handle;

pub(crate) use actions::{KEYS, copied_keys, delete_keys, paste_keys, toggle_key};
pub(crate) use key_button::{key_button, keyed_field, point_at};
pub(crate) use lanes::{Columns, DriveLanes};
