//! Sequences of meshes, a file a frame: OBJ and PLY, and the particles that PLY takes too.

use super::obj::write_frame;
use super::ply::{write_mesh, write_particles};
use super::writer::{MotionWriter, Planned, told};
use crate::export::{Frame, Subject};
use crate::io::{FrameFolder, IoError};
use std::path::{Path, PathBuf};

/// An OBJ file a frame.
pub(super) struct ObjSequence {
    subject: Subject,
    frames: FrameFolder,
}

impl ObjSequence {
    /// # Errors
    /// A folder that cannot be written.
    pub(super) fn create(folder: &Path, subject: &Subject, frames: &Planned) -> Result<Self, IoError> {
        let frames = FrameFolder::numbered(folder, "frame", "obj", *frames.start())?;
        Ok(Self { subject: subject.clone(), frames })
    }
}

impl MotionWriter for ObjSequence {
    fn push(&mut self, frame: &Frame) -> Result<(), IoError> {
        self.frames.push(|out| write_frame(out, &self.subject, &frame.bodies, frame.time))
    }

    fn written(&self) -> Vec<(String, PathBuf)> {
        told(&self.frames, format!("{} OBJ files", self.frames.frames()))
    }

    fn left_over(&self) -> usize {
        self.frames.left_over()
    }
}

/// A PLY mesh and a PLY cloud of particles a frame.
pub(super) struct PlySequence {
    subject: Subject,
    meshes: FrameFolder,
    particles: FrameFolder,
}

impl PlySequence {
    /// # Errors
    /// A folder that cannot be written.
    pub(super) fn create(folder: &Path, subject: &Subject, frames: &Planned) -> Result<Self, IoError> {
        let sequence = |prefix| FrameFolder::numbered(folder, prefix, "ply", *frames.start());
        Ok(Self { subject: subject.clone(), meshes: sequence("frame")?, particles: sequence("particles")? })
    }
}

impl MotionWriter for PlySequence {
    fn push(&mut self, frame: &Frame) -> Result<(), IoError> {
        self.meshes.push(|out| write_mesh(out, &self.subject, &frame.bodies, frame.time))?;
        self.particles.push(|out| write_particles(out, &frame.bodies, frame.time))
    }

    fn written(&self) -> Vec<(String, PathBuf)> {
        let count = self.meshes.frames();
        told(&self.meshes, format!("{count} PLY meshes and {count} PLY clouds of particles"))
    }

    fn left_over(&self) -> usize {
        self.meshes.left_over()
    }
}
