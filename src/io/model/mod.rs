//! Models in: OBJ, STL, PLY, glTF and GLB; and their motions: the skeletons of glTF, PC2 and MDD.

mod caches;
mod failure;
mod gltf;
mod limits;
mod mtl;
mod named_files;
mod notes;
mod obj;
mod obj_lines;
mod obj_piece;
mod ply;
mod polygon;
mod stl;
mod text;

pub(super) use named_files::NamedFiles;
pub(super) use polygon::Cutter;

use limits::MAX_MODEL_BYTES;

use self::failure::Failure;
use self::limits::MOST;
use super::IoError;
use super::read::read_bytes;
use crate::geometry::file_mesh::{FileMesh, FilePart};
use crate::geometry::model::Model;
use crate::geometry::point_cache::PointCache;
use crate::geometry::skeleton::Skeleton;
use crate::scene::one_line;
use std::cell::Cell;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::sync::Arc;

/// Formats, by how names end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Format {
    Obj,
    Stl,
    Ply,
    Gltf,
}

impl Format {
    fn of(path: &Path) -> Option<Self> {
        let ending = path.extension()?.to_str()?.to_ascii_lowercase();
        match ending.as_str() {
            "obj" => Some(Self::Obj),
            "stl" => Some(Self::Stl),
            "ply" => Some(Self::Ply),
            "gltf" | "glb" => Some(Self::Gltf),
            _ => None,
        }
    }

    fn name(self) -> &'static str {
        match self {
            Self::Obj => "OBJ",
            Self::Stl => "STL",
            Self::Ply => "PLY",
            Self::Gltf => "glTF",
        }
    }
}

/// Whether a path ends like that of a model.
pub(crate) fn is_model(path: &Path) -> bool {
    Format::of(path).is_some()
}

/// Reads a model, in the file's own unit and axes.
///
/// # Errors
/// [`IoError::InFile`] with what is wrong: no regular file of sensible size, no known format, no sense in it.
pub fn load_model(path: &Path) -> Result<Model, IoError> {
    let load = || {
        let format = Format::of(path).ok_or(IoError::UnknownModel)?;
        read(&model_bytes(path)?, format, path)
    };
    load().map_err(|error| error.within(path))
}

/// The bytes of a file of a model or of its motion.
///
/// # Errors
/// No regular file of sensible size.
pub(super) fn model_bytes(path: &Path) -> Result<Vec<u8>, IoError> {
    read_bytes(path, MAX_MODEL_BYTES)
}

/// Reads the skeleton of a glTF file of that name from its bytes, in the file's own unit and axes.
///
/// # Errors
/// As [`read_model`], and a file without a skin or without an animation.
pub(super) fn read_skeleton(name: &Path, bytes: &[u8]) -> Result<Skeleton, IoError> {
    if Format::of(name) != Some(Format::Gltf) {
        return Err(IoError::UnknownSkeleton.within(name));
    }
    let folder = name.parent().unwrap_or(Path::new(""));
    let read = guarded(|| gltf::read_skeleton(bytes, folder));
    read.map_err(|failure| error_of(failure, Format::Gltf.name()).within(name))
}

/// Reads a point cache of that name from its bytes, in the file's own unit and axes.
///
/// # Errors
/// A name or content that is none of PC2 or MDD.
pub(super) fn read_cache(name: &Path, bytes: &[u8]) -> Result<PointCache, IoError> {
    let ending = name.extension().and_then(|ending| ending.to_str()).map(str::to_ascii_lowercase);
    let (read, format) = match ending.as_deref() {
        Some("pc2") => (guarded(|| caches::read_pc2(bytes)), "PC2"),
        Some("mdd") => (guarded(|| caches::read_mdd(bytes)), "MDD"),
        _ => return Err(IoError::UnknownCache.within(name)),
    };
    read.map_err(|failure| error_of(failure, format).within(name))
}

thread_local! {
    /// Whether an importer is at work, whose panic is told as what it is.
    static IS_GUARDED: Cell<bool> = const { Cell::new(false) };
}

/// Has no panic of an importer printed from now on, in any thread: that a file is damaged is said instead. Other panics
/// are told as before.
pub fn quiet_importers() {
    let hook = std::panic::take_hook();
    std::panic::set_hook(Box::new(move |panic| {
        if !IS_GUARDED.get() {
            hook(panic);
        }
    }));
}

/// Importers meet files that nobody has thought of: a panic in one is a file that cannot be read.
fn guarded<T>(read: impl FnOnce() -> Result<T, Failure>) -> Result<T, Failure> {
    IS_GUARDED.set(true);
    let read = catch_unwind(AssertUnwindSafe(read)).unwrap_or_else(|_| Err(Failure::new("it is damaged")));
    IS_GUARDED.set(false);
    read
}

/// Reads a model from the bytes of a file of that name, which need not be there; files beside it that it refers to
/// must.
///
/// # Errors
/// As [`load_model`], but for those of reading.
pub(crate) fn read_model(name: &Path, bytes: &[u8]) -> Result<Model, IoError> {
    let format = Format::of(name).ok_or(IoError::UnknownModel);
    format.and_then(|format| read(bytes, format, name)).map_err(|error| error.within(name))
}

fn read(bytes: &[u8], format: Format, path: &Path) -> Result<Model, IoError> {
    let folder = path.parent().unwrap_or(Path::new(""));
    let read = guarded(|| match format {
        Format::Obj => obj::read(bytes, folder),
        Format::Stl => stl::read(bytes),
        Format::Ply => ply::read(bytes),
        Format::Gltf => gltf::read(bytes, folder),
    });
    let failure = match read {
        Ok(model) if model.triangles.len().max(model.positions.len()) > MOST => {
            Failure::new(format_args!("it has more than {} million faces or vertices", MOST / 1_000_000))
        }
        Ok(model) => return Ok(without_strays(with_file(model))),
        Err(failure) => failure,
    };
    Err(error_of(failure, format.name()))
}

fn error_of(failure: Failure, format: &'static str) -> IoError {
    match failure {
        Failure::Content { problem, remedy } => {
            IoError::Model { format, problem: one_line(&problem), remedy: one_line(&remedy) }
        }
        Failure::Other(error) => error,
    }
}

/// Reads the polylines of an OBJ file, in the file's own unit and axes.
///
/// # Errors
/// As [`load_model`].
pub(super) fn load_obj_lines(path: &Path) -> Result<Vec<obj_lines::ObjLine>, IoError> {
    let load = || {
        obj_lines::read(&read_bytes(path, MAX_MODEL_BYTES)?).map_err(|failure| error_of(failure, Format::Obj.name()))
    };
    load().map_err(|error| error.within(path))
}

/// Files that a model with these bytes names.
///
/// # Errors
/// A file in which they cannot be found.
pub(super) fn companions(path: &Path, bytes: &[u8]) -> Result<NamedFiles, IoError> {
    let Some(format) = Format::of(path) else { return Ok(NamedFiles::default()) };
    let folder = path.parent().unwrap_or(Path::new(""));
    let found = match format {
        Format::Obj => named_files::of_obj(bytes, folder),
        Format::Gltf => named_files::of_gltf(bytes, folder),
        Format::Stl | Format::Ply => Ok(NamedFiles::default()),
    };
    found.map_err(|failure| error_of(failure, format.name()))
}

/// Where a reader cuts and splits nothing, the model is the mesh of its file.
fn with_file(mut model: Model) -> Model {
    if model.file.is_none() {
        let mut mesh = FileMesh { points: model.positions.clone(), ..FileMesh::default() };
        for part in &model.parts {
            mesh.begin_part(FilePart { name: part.name.clone(), ..FilePart::default() });
            model.triangles[part.triangles.clone()].iter().for_each(|triangle| mesh.add_face(triangle));
        }
        mesh.end_part();
        model.file = Some(Arc::new(mesh));
    }
    model
}

/// Vertices that are at no place stay only where nothing refers to them: then none that is not referred to does.
fn without_strays(model: Model) -> Model {
    if model.positions.iter().all(|position| position.is_finite()) { model } else { model.retain(|_| true) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::Mutex;

    #[test]
    fn panics_of_importers_are_told_as_damage_and_print_nothing() {
        let told = Arc::new(Mutex::new(Vec::<String>::new()));
        let hook = std::panic::take_hook();
        let said = Arc::clone(&told);
        std::panic::set_hook(Box::new(move |panic| said.lock().expect("a list").push(panic.to_string())));
        quiet_importers();
        let read = guarded(|| -> Result<(), Failure> { panic!("in an importer") });
        let other = catch_unwind(|| panic!("elsewhere"));
        std::panic::set_hook(hook);
        assert!(read.is_err() && other.is_err());
        let told = told.lock().expect("a list").join(" ");
        assert!(told.contains("elsewhere") && !told.contains("in an importer"), "{told}");
    }
}
