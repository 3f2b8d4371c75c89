//! The only file access: scene files in and out, their published schema, sequences of meshes out, writes that happen
//! wholly or not at all.

mod atomic;
mod error;
mod frames;
mod json;
mod obj;
mod pointer;
mod scene;
mod schema;

pub use atomic::{check_writable, make_folder, write_atomically};
pub use error::IoError;
pub use frames::FrameFolder;
pub use obj::write_obj;
pub use pointer::{apply_sets, set_pointer};
pub use scene::{MAX_SCENE_BYTES, load_scene, save_scene, scene_from_json, scene_to_json};
pub use schema::{scene_schema, unknown_fields};
