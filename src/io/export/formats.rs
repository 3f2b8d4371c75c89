//! The formats, and the files of several of them at once.

use super::caches::{Mdd, Pc2};
use super::gltf::Gltf;
use super::meshes::{ObjSequence, PlySequence};
use super::tables::Tables;
use super::usd::Usd;
use super::writer::{MotionWriter, Planned};
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
        Wanted { velocities: is(&[Self::Usd]), particles: is(&[Self::Ply, Self::Csv]), tensions: is(&[Self::Usd]) }
    }
}

/// Files of a motion in some formats.
pub(crate) struct MotionFiles {
    writers: Vec<Box<dyn MotionWriter>>,
    names: Vec<String>,
    frames: Planned,
}

impl MotionFiles {
    /// Makes the folder and what stands beside the frames.
    ///
    /// # Errors
    /// A folder or file that cannot be written; [`IoError::TooLong`] for a motion that a format cannot hold, before anything
    /// is made.
    pub(crate) fn create(
        formats: &[MotionFormat],
        folder: &Path,
        subject: &Subject,
        frames: Planned,
    ) -> Result<Self, IoError> {
        if formats.contains(&MotionFormat::Gltf) {
            Gltf::check(subject, &frames)?;
        }
        make_folder(folder)?;
        let mut writers: Vec<Box<dyn MotionWriter>> = Vec::new();
        for format in formats {
            writers.push(match format {
                MotionFormat::Usd => Box::new(Usd::create(folder, subject, &frames)?),
                MotionFormat::Pc2 => Box::new(Pc2::create(folder, subject, &frames)?),
                MotionFormat::Mdd => Box::new(Mdd::create(folder, subject)?),
                MotionFormat::Gltf => Box::new(Gltf::create(folder, subject)),
                MotionFormat::Obj => Box::new(ObjSequence::create(folder, subject, &frames)?),
                MotionFormat::Ply => Box::new(PlySequence::create(folder, subject, &frames)?),
                MotionFormat::Csv => Box::new(Tables::create(folder, subject, &frames)?),
            });
        }
        let names = subject.bodies.iter().map(|body| body.name.clone()).collect();
        Ok(Self { writers, names, frames })
    }

    /// Whether a frame is among those that are written.
    pub(crate) fn takes(&self, number: u64) -> bool {
        self.frames.contains(&number)
    }

    /// Writes the next frame.
    ///
    /// # Errors
    /// [`IoError::NotFinite`] for a place that is no numbers, a file that cannot be written; the frames before stay whole.
    pub(crate) fn push(&mut self, frame: &Frame) -> Result<(), IoError> {
        if let Some((what, value)) = frame.not_finite(|body| self.names[body].clone()) {
            return Err(IoError::NotFinite { what, value: value.to_string() });
        }
        self.writers.iter_mut().try_for_each(|writer| writer.push(frame))
    }

    /// Writes what is left to be written.
    ///
    /// # Errors
    /// As [`MotionFiles::push`].
    pub(crate) fn finish(&mut self) -> Result<(), IoError> {
        self.writers.iter_mut().try_for_each(|writer| writer.finish())
    }

    /// What was written, as it is told, and where; and how many files of an earlier run lie behind.
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
