//! The only file access: scene files in and out, their published schema, models in and out, sequences of files out,
//! writes that happen wholly or not at all, documents that are found again after a crash, files that others changed.

mod apng;
#[cfg(feature = "gui")]
mod archive;
mod assets;
pub(crate) mod atomic;
mod beside;
mod collect;
mod colours;
pub(crate) mod door;
mod error;
pub(crate) mod export;
mod fingerprint;
mod finite;
mod frames;
mod gif;
mod glb;
#[cfg_attr(not(feature = "gui"), allow(dead_code, reason = "the window is who keeps recordings"))]
mod growing;
#[cfg(unix)]
mod heeded;
mod json;
#[cfg(feature = "gui")]
mod json_folder;
mod json_out;
mod lines;
mod memory;
mod model;
mod moving;
mod obj;
mod open;
mod outside;
mod paths;
mod pointer;
mod read;
#[cfg(feature = "gui")]
mod recent;
pub(crate) mod recovery;
pub(crate) mod scene;
mod schema;
mod skinned_glb;
#[cfg(feature = "gui")]
mod stamp;
mod trace;
#[cfg(feature = "gui")]
mod zip;

#[cfg(feature = "gui")]
pub(crate) use archive::{Archive, system};
pub(crate) use assets::complete_assets;
pub use assets::load_assets;
#[cfg(feature = "gui")]
pub(crate) use assets::{Stages, load_assets_unless};
#[cfg(feature = "gui")]
pub(crate) use assets::{add_collider_model, add_leader, add_models_of, load_assets_by, path_from};
pub(crate) use atomic::{check_writable, make_folder, write_atomically};
#[cfg(feature = "gui")]
pub(crate) use beside::put_beside;
pub(crate) use collect::{collect_scene, with_models_from};
pub use error::IoError;
pub(crate) use fingerprint::fingerprint;
pub use frames::FrameFolder;
pub use glb::write_glb;
#[cfg(feature = "gui")]
pub(crate) use growing::{GrowingLines, Kept};
#[cfg(unix)]
pub(crate) use heeded::heeds;
#[cfg(feature = "gui")]
pub(crate) use json_folder::{JsonFile, JsonFolder};
pub(crate) use json_out::write_json;
pub(crate) use lines::{NamedLine, check_lines_name, read_lines, write_lines};
pub(crate) use memory::free_memory;
pub(crate) use model::is_model;
pub use model::load_model;
pub use model::quiet_importers;
pub(crate) use moving::{MovingFormat, MovingPicture, PictureAs};
pub use obj::write_obj;
#[cfg(feature = "gui")]
pub(crate) use open::open_model_unless;
pub use open::{OpenedModel, open_model};
pub(crate) use outside::refuse_outside;
#[cfg(feature = "gui")]
pub(crate) use paths::is_same;
pub(crate) use paths::{is_there, missing_files, resolved};
pub use pointer::apply_sets;
pub(crate) use read::read_json;
#[cfg(feature = "gui")]
pub(crate) use recent::RecentFiles;
#[cfg(feature = "gui")]
pub(crate) use recovery::{
    LeftRecording, Origin, RecoverableDocument, RecoveryFile, left_recordings, recoverable_documents,
};
pub(crate) use scene::typed;
pub use scene::{load_scene, save_scene, scene_from_json, scene_to_json};
pub use schema::{scene_schema, unknown_fields};
pub(crate) use skinned_glb::write_skinned_glb;
#[cfg(feature = "gui")]
pub(crate) use stamp::{FileStamp, FileState};
pub(crate) use trace::Trace;
