//! The files of a run's shapes.

use super::behind::FilesBehind;
use super::{FrameChoice, Inputs, TransferError, Written, check_finite};
use crate::export::{Motion, Space, Wanted};
use crate::io::export::{MotionFiles, MotionFormat};
use crate::scene::{Assets, Scene};
use crate::sim::Runner;
use std::path::Path;

/// The files of a run's shapes.
pub(super) struct Shapes {
    motion: Motion,
    files: FilesBehind,
}

impl Shapes {
    /// In a folder; none where no formats are asked for.
    ///
    /// # Errors
    /// A folder that cannot be written, a file there that is read, or a motion that a format cannot hold.
    pub(super) fn create(
        (formats, folder): (&[MotionFormat], &Path),
        (frames, space): (FrameChoice, Space),
        (scene, assets): (&Scene, &Assets),
        (inputs, target): (&Inputs, &'static str),
        runner: &Runner,
    ) -> Result<Option<Self>, TransferError> {
        if formats.is_empty() {
            return Ok(None);
        }
        let each = formats.iter().map(|format| format.wanted());
        let wanted = each.fold(Wanted::default(), |all, one| Wanted {
            velocities: all.velocities || one.velocities,
            normals: all.normals || one.normals,
            particles: all.particles || one.particles,
            tensions: all.tensions || one.tensions,
        });
        let motion = Motion::new(scene, assets, runner.world(), space, wanted).every(frames.step);
        let (subject, numbers) = (motion.subject(), frames.numbers());
        inputs.check_apart(target, &MotionFiles::planned(formats, folder, subject, &numbers))?;
        let files = MotionFiles::create(formats, folder, subject, &numbers)?;
        Ok(Some(Self { motion, files: FilesBehind::new(files) }))
    }

    /// Has the frame at hand written beside what comes next.
    ///
    /// # Errors
    /// A place that is no numbers; a file that an earlier frame could not be written to.
    pub(super) fn push(&mut self, runner: &Runner) -> Result<(), TransferError> {
        check_finite(&runner.particles())?;
        Ok(self.files.push(self.motion.frame(runner.world()))?)
    }

    /// Writes what is left of the frames so far.
    ///
    /// # Errors
    /// A file that cannot be written.
    pub(super) fn keep(&mut self) -> Result<(), TransferError> {
        Ok(self.files.finish()?)
    }

    /// What was written.
    pub(super) fn written(&self) -> Vec<Written> {
        let each = self.files.written().into_iter();
        each.map(|(what, path, left_over)| Written { what, path, left_over }).collect()
    }
}
