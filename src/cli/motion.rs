//! How the shapes of a run are written: in which formats, which frames, in what unit.

use super::output;
use super::{CliError, Console};
use crate::cli::error::printable;
use crate::export::Space;
use crate::geometry::model::UpAxis;
use crate::io::export::MotionFormat;
use crate::transfer::{Format, FrameChoice, Program, Written};
use clap::{Args, ValueEnum};
use std::path::Path;
use std::str::FromStr;

/// What goes into `--out`, and how.
#[derive(Clone, Debug, Default, PartialEq, Args)]
pub(super) struct MotionOptions {
    /// Formats of the files in --out, as in usd,pc2: usd, pc2, mdd, gltf, obj, ply, csv, or a moving picture, apng or
    /// gif; OBJ unless given
    #[arg(long, value_name = "LIST", value_delimiter = ',')]
    format: Vec<FormatName>,
    /// First and last frame for --out and --png, as in 10..60; all unless given. The run ends with the last unless
    /// --seconds is given
    #[arg(long, value_name = "A..B")]
    pub(super) frames: Option<FrameRange>,
    /// Write every so many frames only, counted anew: what is written lasts as long
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    step: Option<u32>,
    /// Unit and axes of a program: blender (metres, Z up), houdini (metres, Y up), maya (centimetres, Y up) or unreal
    /// (centimetres, Z up); --scale and --up go before it
    #[arg(long = "for", value_name = "PROGRAM")]
    program: Option<ProgramName>,
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

impl Up {
    /// The axis.
    pub(super) fn axis(self) -> UpAxis {
        match self {
            Self::Y => UpAxis::Y,
            Self::Z => UpAxis::Z,
        }
    }
}

/// A format by its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct FormatName(Format);

impl FromStr for FormatName {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        Format::named(text).map(Self).ok_or_else(|| {
            let names: Vec<&str> = Format::all().map(|(name, _)| name).collect();
            let (last, others) = names.split_last().unwrap_or((&"", &[]));
            format!("there is no format of that name; give one of {} or {last}", others.join(", "))
        })
    }
}

/// A program by its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct ProgramName(Program);

impl FromStr for ProgramName {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let known = Program::ALL.iter().find(|(name, _)| name.eq_ignore_ascii_case(text.trim()));
        known.map(|&(_, program)| Self(program)).ok_or_else(|| {
            let names = Program::ALL.map(|(name, _)| name.to_lowercase());
            format!("its unit and axes are not known; give one of {}, or --scale and --up", names.join(", "))
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
        let of_shapes = Self { frames: None, step: None, ..self.clone() } != Self::default();
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
    pub(super) fn choice(&self, last: u64) -> FrameChoice {
        let FrameRange { first, last } = self.frames.unwrap_or(FrameRange { first: 0, last });
        FrameChoice { first, last, step: self.step.map_or(1, u64::from) }
    }

    /// The formats of what goes into `--out`.
    pub(super) fn formats(&self) -> Vec<Format> {
        let asked = self.format.iter().map(|FormatName(format)| *format);
        if self.format.is_empty() { vec![Format::Motion(MotionFormat::Obj)] } else { asked.collect() }
    }

    /// Whether a moving picture goes into `--out`.
    pub(super) fn wants_pictures(&self) -> bool {
        self.format.iter().any(|FormatName(format)| matches!(format, Format::Picture(_)))
    }

    /// The unit and axes of what goes into `--out`.
    pub(super) fn space(&self) -> Space {
        let usual = self.program.map_or_else(Space::default, |ProgramName(program)| program.space());
        Space { up: self.up.map_or(usual.up, Up::axis), scale: self.scale.unwrap_or(usual.scale) }
    }
}

/// A line about each of the files that were written.
pub(super) fn told(written: &[Written], console: &mut Console) -> String {
    let mut text = String::new();
    for Written { what, path, left_over } in written {
        text += &output::wrote(what, path);
        warn_of_left_over(path, *left_over, console);
    }
    text
}

/// Says that a folder holds more frames than were written now.
fn warn_of_left_over(folder: &Path, left_over: usize, console: &mut Console) {
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
