//! How the shapes of a run are written: in which formats, which frames, in what unit.

use super::output::{self, Inputs};
use super::{CliError, Console};
use crate::cli::error::printable;
use crate::cli::finite::check_finite;
use crate::export::{Motion, Space, Wanted};
use crate::geometry::model::UpAxis;
use crate::io::MovingFormat;
use crate::io::export::{MotionFiles, MotionFormat};
use crate::scene::{Assets, Scene};
use crate::sim::Runner;
use clap::{Args, ValueEnum};
use std::ops::RangeInclusive;
use std::path::Path;
use std::str::FromStr;

/// What goes into `--out`, and how.
#[derive(Clone, Debug, Default, PartialEq, Args)]
pub(super) struct MotionOptions {
    /// Formats of the files in --out, as in usd,pc2: usd, pc2, mdd, gltf, obj, ply, csv, or a moving picture, apng or gif; OBJ
    /// unless given
    #[arg(long, value_name = "LIST", value_delimiter = ',')]
    format: Vec<FormatName>,
    /// First and last frame for --out and --png, as in 10..60; all unless given. The run ends with the last unless --seconds
    /// is given
    #[arg(long, value_name = "A..B")]
    pub(super) frames: Option<FrameRange>,
    /// Units to a metre in --out: 100 for a program that takes its units for centimetres; glTF is always in metres
    #[arg(long, value_name = "N", value_parser = scale, allow_negative_numbers = true)]
    scale: Option<f64>,
    /// Axis that points up in --out; in glTF it is always Y
    #[arg(long, value_enum)]
    up: Option<Up>,
}

/// Axes that point up in other programs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Up {
    /// As in Maya, Houdini and here
    Y,
    /// As in Blender and Unreal
    Z,
}

/// A format by its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum FormatName {
    Motion(MotionFormat),
    Moving(MovingFormat),
}

impl FromStr for FormatName {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let motions = MotionFormat::ALL.map(|(name, format)| (name, Self::Motion(format)));
        let moving = MovingFormat::ALL.map(|(name, format)| (name, Self::Moving(format)));
        let all: Vec<(&str, Self)> = motions.into_iter().chain(moving).collect();
        let known = all.iter().find(|(name, _)| name.eq_ignore_ascii_case(text.trim()));
        known.map(|&(_, format)| format).ok_or_else(|| {
            let (last, names) = all
                .split_last()
                .map_or(("", Vec::new()), |(last, others)| (last.0, others.iter().map(|(name, _)| *name).collect()));
            format!("there is no format of that name; give one of {} or {last}", names.join(", "))
        })
    }
}

/// First and last frame, both of them meant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct FrameRange {
    first: u64,
    last: u64,
}

impl FromStr for FrameRange {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let read = || {
            let (first, last) = text.split_once("..")?;
            let (first, last) = (first.trim().parse().ok()?, last.trim_start_matches('=').trim().parse().ok()?);
            (first <= last).then_some(Self { first, last })
        };
        read().ok_or_else(|| "give the first and the last frame, counted from 0, as in 10..60".to_owned())
    }
}

/// Units to a metre.
pub(super) fn scale(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(scale) if (1e-6..=1e9).contains(&scale) => Ok(scale),
        _ => Err("give how many units make a metre, as in 100 for centimetres".to_owned()),
    }
}

impl MotionOptions {
    /// Refuses options for which nothing is written.
    ///
    /// # Errors
    /// [`CliError::NoFilesAsked`].
    pub(super) fn check(&self, out: bool, png: bool) -> Result<(), CliError> {
        let of_shapes = Self { frames: None, ..self.clone() } != Self::default();
        let is_asked = out || (png && !of_shapes) || *self == Self::default();
        if is_asked { Ok(()) } else { Err(CliError::NoFilesAsked) }
    }

    /// The last frame of a run that could go on to `most`.
    ///
    /// # Errors
    /// [`CliError::FramesBeyond`] for frames that it does not reach.
    pub(super) fn last_frame(&self, most: u64, seconds: Option<f64>) -> Result<u64, CliError> {
        match self.frames {
            Some(FrameRange { first, last }) if last > most => Err(CliError::FramesBeyond { first, last, most }),
            Some(range) if seconds.is_none() => Ok(range.last),
            _ => Ok(most),
        }
    }

    /// The frames that are written of a run that goes on to `last`.
    pub(super) fn range(&self, last: u64) -> RangeInclusive<u64> {
        self.frames.map_or(0..=last, |range| range.first..=range.last)
    }

    /// The formats of the shapes, each once.
    fn formats(&self) -> Vec<MotionFormat> {
        if self.format.is_empty() {
            return vec![MotionFormat::Obj];
        }
        self.named(|name| if let FormatName::Motion(format) = name { Some(format) } else { None })
    }

    /// The formats of the moving pictures, each once.
    pub(super) fn moving(&self) -> Vec<MovingFormat> {
        self.named(|name| if let FormatName::Moving(format) = name { Some(format) } else { None })
    }

    fn named<T: PartialEq>(&self, of: impl Fn(FormatName) -> Option<T>) -> Vec<T> {
        let mut formats = Vec::new();
        for format in self.format.iter().filter_map(|&name| of(name)) {
            if !formats.contains(&format) {
                formats.push(format);
            }
        }
        formats
    }

    fn space(&self) -> Space {
        let up = if self.up == Some(Up::Z) { UpAxis::Z } else { UpAxis::Y };
        Space { up, scale: self.scale.unwrap_or(1.0) }
    }
}

/// The files of a run's shapes.
pub(super) struct MotionOutput {
    motion: Motion,
    files: MotionFiles,
}

impl MotionOutput {
    /// In a folder, of a run that goes on to frame `last`; none where only pictures are asked for.
    ///
    /// # Errors
    /// A folder that cannot be written, a file there that is read, or a motion that a format cannot hold.
    pub(super) fn create(
        options: &MotionOptions,
        folder: &Path,
        (scene, assets): (&Scene, &Assets),
        inputs: &Inputs,
        runner: &Runner,
        last: u64,
    ) -> Result<Option<Self>, CliError> {
        let formats = options.formats();
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
        let motion = Motion::new(scene, assets, runner.world(), options.space(), wanted);
        let (subject, frames) = (motion.subject(), options.range(last));
        inputs.check_apart("--out", &MotionFiles::planned(&formats, folder, subject, &frames))?;
        let files = MotionFiles::create(&formats, folder, subject, frames)?;
        Ok(Some(Self { motion, files }))
    }

    /// Writes the frame at hand, if it is asked for.
    ///
    /// # Errors
    /// A file that cannot be written, a place that is no numbers.
    pub(super) fn push(&mut self, runner: &Runner) -> Result<(), CliError> {
        if self.files.takes(runner.world().frame()) {
            check_finite(&runner.particles())?;
            self.files.push(&self.motion.frame(runner.world()))?;
        }
        Ok(())
    }

    /// Writes what is left of the frames so far.
    ///
    /// # Errors
    /// A file that cannot be written.
    pub(super) fn keep(&mut self) -> Result<(), CliError> {
        Ok(self.files.finish()?)
    }

    /// A line about each file.
    pub(super) fn written(&self, console: &mut Console) -> String {
        let mut text = String::new();
        for (what, path, left_over) in self.files.written() {
            text += &output::wrote(&what, &path);
            warn_of_left_over(&path, left_over, console);
        }
        text
    }
}

/// Says that a folder holds more frames than were written now.
pub(super) fn warn_of_left_over(folder: &Path, left_over: usize, console: &mut Console) {
    if left_over > 0 {
        console.warn(&format!(
            "{}: {left_over} more frames of an earlier, longer run lie behind the last of this one; remove them",
            printable(folder)
        ));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frames_are_a_first_and_a_last_one() {
        assert_eq!("10..60".parse(), Ok(FrameRange { first: 10, last: 60 }));
        assert_eq!("0..=0".parse(), Ok(FrameRange { first: 0, last: 0 }));
        for bad in ["", "5", "5..", "..5", "6..5", "-1..5", "0..1.5", "a..b"] {
            assert!(bad.parse::<FrameRange>().is_err(), "{bad}");
        }
    }
}
