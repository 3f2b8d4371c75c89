//! The formats, and the files of several of them at once.

use super::caches::{self, Mdd, Pc2};
use super::gltf::{self, Gltf};
use super::meshes::{ObjSequence, PlySequence};
use super::tables::Tables;
use super::usd::{self, Usd};
use super::writer::{MotionWriter, Planned, frame_files};
use crate::export::{Frame, Subject, Wanted};
use crate::io::{IoError, make_folder};
use std::path::{Path, PathBuf};

/// A format in which a motion is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum MotionFormat {
    /// USD: a layer of what stays, and one a frame as value clips.
    Usd,
    /// PC2 point caches, with the rest shape beside them as OBJ.
    Pc2,
    /// MDD point caches, with the rest shape beside them as OBJ.
    Mdd,
    /// glTF (GLB) with a morph target a frame.
    Gltf,
    /// An OBJ file a frame.
    Obj,
    /// A PLY mesh and a PLY cloud of particles a frame.
    Ply,
    /// A table of particles a frame.
    Csv,
}

impl MotionFormat {
    /// All of them, by their names.
    pub(crate) const ALL: [(&'static str, Self); 7] = [
        ("usd", Self::Usd),
        ("pc2", Self::Pc2),
        ("mdd", Self::Mdd),
        ("gltf", Self::Gltf),
        ("obj", Self::Obj),
        ("ply", Self::Ply),
        ("csv", Self::Csv),
    ];

    /// What the format holds beside places.
    pub(crate) fn wanted(self) -> Wanted {
        let is = |of: &[Self]| of.contains(&self);
        Wanted {
            velocities: is(&[Self::Usd, Self::Ply]),
            normals: is(&[Self::Usd, Self::Gltf, Self::Obj, Self::Ply]),
            particles: is(&[Self::Ply, Self::Csv]),
            tensions: is(&[Self::Usd]),
        }
    }
}

impl MotionFormat {
    /// Whether numbers are written in single precision.
    fn is_single(self) -> bool {
        !matches!(self, Self::Obj | Self::Csv)
    }

    /// The files that it writes into a folder, as far as they may be there already.
    fn files(self, folder: &Path, subject: &Subject, frames: &Planned) -> Vec<PathBuf> {
        match self {
            Self::Usd => usd::files(folder),
            Self::Pc2 => caches::files(folder, subject, "pc2"),
            Self::Mdd => caches::files(folder, subject, "mdd"),
            Self::Gltf => vec![gltf::file(folder)],
            Self::Obj => frame_files(folder, "frame", "obj", frames),
            Self::Ply => {
                ["frame", "particles"].iter().flat_map(|prefix| frame_files(folder, prefix, "ply", frames)).collect()
            }
            Self::Csv => frame_files(folder, "particles", "csv", frames),
        }
    }
}

/// Files of a motion in some formats.
pub(crate) struct MotionFiles {
    writers: Vec<Box<dyn MotionWriter>>,
    names: Vec<String>,
    /// Whether any of them is in single precision.
    is_single: bool,
}

impl MotionFiles {
    /// The files that [`MotionFiles::create`] and the frames after it write, as far as they may be there already.
    pub(crate) fn planned(
        formats: &[MotionFormat],
        folder: &Path,
        subject: &Subject,
        frames: &Planned,
    ) -> Vec<PathBuf> {
        formats.iter().flat_map(|format| format.files(folder, subject, frames)).collect()
    }

    /// Makes the folder and what stands beside the frames.
    ///
    /// # Errors
    /// A folder or file that cannot be written; [`IoError::TooLong`] for a motion that a format cannot hold, before
    /// anything is made.
    pub(crate) fn create(
        formats: &[MotionFormat],
        folder: &Path,
        subject: &Subject,
        frames: &Planned,
    ) -> Result<Self, IoError> {
        // It makes nothing before the first frame.
        let mut gltf =
            formats.contains(&MotionFormat::Gltf).then(|| Gltf::create(folder, subject, frames)).transpose()?;
        make_folder(folder)?;
        let mut writers: Vec<Box<dyn MotionWriter>> = Vec::new();
        for format in formats {
            let writer: Box<dyn MotionWriter> = match format {
                MotionFormat::Usd => Box::new(Usd::create(folder, subject, frames)?),
                MotionFormat::Pc2 => Box::new(Pc2::create(folder, subject, frames)?),
                MotionFormat::Mdd => Box::new(Mdd::create(folder, subject)?),
                MotionFormat::Gltf => match gltf.take() {
                    Some(gltf) => Box::new(gltf),
                    None => continue,
                },
                MotionFormat::Obj => Box::new(ObjSequence::create(folder, subject, frames)?),
                MotionFormat::Ply => Box::new(PlySequence::create(folder, subject, frames)?),
                MotionFormat::Csv => Box::new(Tables::create(folder, subject, frames)?),
            };
            writers.push(writer);
        }
        let names = subject.bodies.iter().map(|body| body.name.clone()).collect();
        Ok(Self { writers, names, is_single: formats.iter().any(|format| format.is_single()) })
    }

    /// Writes the next frame.
    ///
    /// # Errors
    /// [`IoError::NotFinite`] for a place that is no numbers, a file that cannot be written; the frames before stay
    /// whole.
    pub(crate) fn push(&mut self, frame: &Frame) -> Result<(), IoError> {
        if let Some((what, value)) = frame.not_finite(self.is_single, |body| self.names[body].clone()) {
            return Err(IoError::NotFinite { what, value });
        }
        self.writers.iter_mut().try_for_each(|writer| writer.push(frame))
    }

    /// Writes what is left to be written, in every format, whatever becomes of another.
    ///
    /// # Errors
    /// As [`MotionFiles::push`]; the first.
    pub(crate) fn finish(&mut self) -> Result<(), IoError> {
        let results: Vec<_> = self.writers.iter_mut().map(|writer| writer.finish()).collect();
        results.into_iter().collect()
    }

    /// What was written, as it is told, and where, of formats that got a frame; and how many files of an earlier run
    /// lie behind.
    pub(crate) fn written(&self) -> Vec<(String, PathBuf, usize)> {
        let each = |writer: &dyn MotionWriter| {
            let left_over = writer.left_over();
            let written = writer.written().into_iter().enumerate();
            written
                .map(|(index, (what, path))| (what, path, if index == 0 { left_over } else { 0 }))
                .collect::<Vec<_>>()
        };
        self.writers.iter().flat_map(|writer| each(&**writer)).collect()
    }
}
