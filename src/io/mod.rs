//! The only file access: scene files in and out, their published schema, models in and out, sequences of files out,
//! writes that happen wholly or not at all, documents that are found again after a crash, files that others changed.

mod assets;
mod atomic;
mod beside;
mod error;
mod frames;
mod glb;
mod json;
mod json_folder;
mod model;
mod obj;
mod paths;
mod pointer;
mod read;
mod recent;
mod recovery;
mod scene;
mod schema;
mod stamp;
mod trace;

pub use assets::{complete_assets, load_assets, load_assets_by};
pub use atomic::{check_writable, make_folder, write_atomically};
pub use beside::put_beside;
pub use error::IoError;
pub use frames::FrameFolder;
pub use glb::write_glb;
pub use json_folder::{JsonFile, JsonFolder};
pub use model::{MAX_MODEL_BYTES, is_model, load_model, read_model};
pub use obj::write_obj;
pub use paths::{missing_files, resolved};
pub use pointer::{apply_sets, set_pointer};
pub use recent::RecentFiles;
pub use recovery::{Origin, RecoverableDocument, RecoveryFile, recoverable_documents};
pub use scene::{MAX_SCENE_BYTES, load_scene, save_scene, scene_from_json, scene_to_json};
pub use schema::{scene_schema, unknown_fields};
pub use stamp::{FileStamp, FileState};
pub use trace::Trace;
