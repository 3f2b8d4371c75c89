//! The work on what leaves the window: on a thread of its own, from a motion that was taken.

use super::job::{Progress, TransferReport};
use crate::export::Space;
use crate::scene::Scene;
use crate::sim::TakenMotion;
use crate::solver::snapshot::Snapshot;
use crate::transfer::{Format, FrameChoice, Inputs, Look, Order, Pictures, RunFiles, SceneRenderer, TransferError};
use std::f64::consts::TAU;
use std::path::PathBuf;

/// Pictures of a turn, and how many are shown a second.
pub(super) const TURN_PICTURES: u64 = 120;
pub(super) const TURN_RATE: f64 = 30.0;

/// A clip has this many pictures a second at most, or little more.
const CLIP_RATE: f64 = 30.0;

/// The frames of a clip of those between two, each `seconds` [s] long.
pub(super) fn clip_frames(first: u64, last: u64, seconds: f64) -> FrameChoice {
    FrameChoice { first, last, step: (1.0 / (CLIP_RATE * seconds)).round().max(1.0) as u64 }
}

/// A motion that is to be written.
pub(super) struct MotionWork {
    pub(super) motion: TakenMotion,
    pub(super) formats: Vec<Format>,
    pub(super) folder: PathBuf,
    pub(super) frames: FrameChoice,
    pub(super) is_anew: bool,
    pub(super) space: Space,
    pub(super) look: Look,
    pub(super) inputs: Inputs,
}

impl MotionWork {
    /// How many frames are gone through.
    pub(super) fn pieces(&self) -> u64 {
        let FrameChoice { first, last, .. } = self.frames;
        if self.is_anew { last + 1 } else { last - first + 1 }
    }

    /// Writes it.
    pub(super) fn run(self, progress: &Progress) -> TransferReport {
        let order = Order {
            formats: &self.formats,
            folder: Some(&self.folder),
            stills: None,
            frames: self.frames,
            space: self.space,
            look: &self.look,
            target: "the export",
        };
        let (scene, assets) = self.motion.scene();
        let scene = scene.clone();
        let mut files = match RunFiles::create(&order, (&*scene, assets), &self.inputs, self.motion.start()) {
            Ok(files) => files,
            Err(error) => return error.into(),
        };
        let last = self.frames.last;
        let result = if self.is_anew {
            anew(&self.motion, &scene, last, &mut files, progress)
        } else {
            kept(self.motion, &scene, self.frames, &mut files, progress)
        };
        // What there is of it is to be whole in any case.
        let kept = files.keep();
        TransferReport::of(files.written(), result.and(kept))
    }
}

fn anew(
    motion: &TakenMotion,
    scene: &Scene,
    last: u64,
    files: &mut RunFiles,
    progress: &Progress,
) -> Result<(), TransferError> {
    let mut runner = motion.start().clone();
    files.push(scene, &runner)?;
    progress.step();
    while runner.world().number() < last && !runner.all_stopped() && !progress.is_cancelled() {
        runner.advance_frame();
        files.push(scene, &runner)?;
        progress.step();
    }
    Ok(())
}

fn kept(
    motion: TakenMotion,
    scene: &Scene,
    frames: FrameChoice,
    files: &mut RunFiles,
    progress: &Progress,
) -> Result<(), TransferError> {
    let mut taken = motion.into_frames();
    while let Some(runner) = taken.next()
        && !progress.is_cancelled()
    {
        let number = runner.world().number();
        if number > frames.last {
            break;
        }
        files.push(scene, runner)?;
        if number >= frames.first {
            progress.step();
        }
    }
    Ok(())
}

/// Draws the frames of a motion into a moving picture.
pub(super) fn draw_clip(
    motion: TakenMotion,
    frames: FrameChoice,
    look: &Look,
    path: PathBuf,
    progress: &Progress,
) -> TransferReport {
    let scene = motion.scene().0.clone();
    let start = motion.start();
    let seconds = frames.step as f64 * start.world().plan().frame_seconds;
    let renderer = match SceneRenderer::open(look, &scene, &start.snapshot()) {
        Ok(renderer) => renderer,
        Err(error) => return error.into(),
    };
    let mut pictures = Pictures::moving(renderer, path, seconds);
    let mut taken = motion.into_frames();
    let mut draw = || {
        while let Some(runner) = taken.next()
            && !progress.is_cancelled()
        {
            if frames.takes(runner.world().number()) {
                pictures.push(&scene, runner)?;
                progress.step();
            }
        }
        Ok(())
    };
    let result = draw();
    TransferReport::of(pictures.written(), result)
}

/// Draws one state from all around into a moving picture.
pub(super) fn draw_turn(
    scene: &Scene,
    shown: &Snapshot,
    look: &Look,
    path: PathBuf,
    progress: &Progress,
) -> TransferReport {
    let renderer = match SceneRenderer::open(look, scene, shown) {
        Ok(renderer) => renderer,
        Err(error) => return error.into(),
    };
    let mut pictures = Pictures::moving(renderer, path, 1.0 / TURN_RATE);
    let mut draw = || {
        for _ in 0..TURN_PICTURES {
            if progress.is_cancelled() {
                break;
            }
            pictures.push_state(scene, shown)?;
            pictures.turn(TAU / TURN_PICTURES as f64);
            progress.step();
        }
        Ok(())
    };
    let result = draw();
    TransferReport::of(pictures.written(), result)
}
