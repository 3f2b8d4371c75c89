//! Everything that is written of a run, frame by frame.

use super::pictures::Pictures;
use super::shapes::Shapes;
use super::{Format, FrameChoice, Inputs, Look, SceneRenderer, TransferError, Written};
use crate::export::Space;
use crate::io::export::MotionFormat;
use crate::scene::{Assets, Scene};
use crate::sim::Runner;
use std::path::Path;

/// What is to be written of a run.
#[derive(Clone, Debug)]
pub(crate) struct Order<'a> {
    /// In which formats.
    pub(crate) formats: &'a [Format],
    /// Folder that they go to; none for none of them.
    pub(crate) folder: Option<&'a Path>,
    /// Folder of a PNG file a frame.
    pub(crate) stills: Option<&'a Path>,
    /// Which frames.
    pub(crate) frames: FrameChoice,
    /// In which unit and axes.
    pub(crate) space: Space,
    /// How pictures look.
    pub(crate) look: &'a Look,
    /// What a message calls the files that are written.
    pub(crate) target: &'static str,
}

/// The files of a run: each is whole up to the last frame that went into it, whatever comes after.
pub(crate) struct RunFiles {
    shapes: Option<Shapes>,
    pictures: Option<Pictures>,
    frames: FrameChoice,
}

impl RunFiles {
    /// Of a run that is put together of a scene, `runner` at its start or further on.
    ///
    /// # Errors
    /// A driver that is missing and a motion that a format cannot hold, before anything is made; a folder that cannot
    /// be written, a file there that is read.
    pub(crate) fn create(
        order: &Order<'_>,
        (scene, assets): (&Scene, &Assets),
        inputs: &Inputs,
        runner: &Runner,
    ) -> Result<Self, TransferError> {
        let mut motions: Vec<MotionFormat> = Vec::new();
        let mut moving = Vec::new();
        for format in order.formats {
            match format {
                Format::Motion(format) if !motions.contains(format) => motions.push(*format),
                Format::Picture(format) if !moving.contains(format) => moving.push(*format),
                _ => {}
            }
        }
        let animated = order.folder.filter(|_| !moving.is_empty());
        let renderer = (order.stills.is_some() || animated.is_some())
            .then(|| SceneRenderer::open(order.look, scene, &runner.snapshot()))
            .transpose()?;
        let shapes = |folder| {
            let at = (order.frames, order.space);
            Shapes::create((&motions, folder), at, (scene, assets), (inputs, order.target), runner)
        };
        let shapes = order.folder.map_or(Ok(None), shapes)?;
        let seconds = order.frames.step as f64 * runner.world().plan().frame_seconds;
        let first = *order.frames.numbers().start();
        let pictures = |renderer| Pictures::create(renderer, (order.stills, first), (animated, &moving), seconds);
        let pictures = renderer.map(pictures).transpose()?;
        Ok(Self { shapes, pictures, frames: order.frames })
    }

    /// Writes the frame at hand, if it is among those that are asked for.
    ///
    /// # Errors
    /// A file that cannot be written, a place that is no numbers, a picture that cannot be made.
    pub(crate) fn push(&mut self, scene: &Scene, runner: &Runner) -> Result<(), TransferError> {
        if !self.frames.takes(runner.world().number()) {
            return Ok(());
        }
        let _export = tracing::info_span!("export", frame = runner.world().number()).entered();
        if let Some(shapes) = &mut self.shapes {
            shapes.push(runner)?;
        }
        if let Some(pictures) = &mut self.pictures {
            pictures.push(scene, runner)?;
        }
        Ok(())
    }

    /// Writes what is left of the frames so far.
    ///
    /// # Errors
    /// A file that cannot be written.
    pub(crate) fn keep(&mut self) -> Result<(), TransferError> {
        self.shapes.as_mut().map_or(Ok(()), Shapes::keep)
    }

    /// What was written, of all that got a frame.
    pub(crate) fn written(&self) -> Vec<Written> {
        let shapes = self.shapes.as_ref().map_or_else(Vec::new, Shapes::written);
        let pictures = self.pictures.as_ref().map_or_else(Vec::new, Pictures::written);
        [shapes, pictures].concat()
    }
}
