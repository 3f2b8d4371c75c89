//! Pictures from the command line: what they show, and how.

use crate::draw::{Display, Slice, Theme};
use crate::scene::Axis;
use crate::transfer;
use clap::{Args, ValueEnum};
use std::fmt;
use std::str::FromStr;

/// What pictures show, and how.
#[derive(Clone, Copy, Debug, Default, PartialEq, Args)]
#[command(next_help_heading = "Pictures")]
pub(super) struct Look {
    /// From where
    #[arg(long, value_name = "VIEW", default_value_t, value_enum)]
    pub(super) view: Viewpoint,
    /// Width and height in pixels
    #[arg(long, value_name = "WxH", default_value_t)]
    pub(super) size: PixelSize,
    /// Show the inside: skins see-through, fibres as tubes
    #[arg(long)]
    pub(super) x_ray: bool,
    /// Show material and structure particles in place of skins
    #[arg(long, conflicts_with = "x_ray")]
    pub(super) particles: bool,
    /// Cut bodies open across X, Y or Z at so many metres: `x=0.01` takes away what lies beyond, `-x=0.01` what lies
    /// before
    #[arg(long, value_name = "AXIS=M", allow_hyphen_values = true)]
    pub(super) slice: Option<SliceOption>,
    /// Colours
    #[arg(long, value_name = "THEME", default_value_t, value_enum)]
    pub(super) theme: ThemeName,
}

impl Look {
    /// What is asked for.
    pub(super) fn asked(&self) -> transfer::Look {
        let view = match self.view {
            Viewpoint::Front => transfer::Viewpoint::Front,
            Viewpoint::Side => transfer::Viewpoint::Side,
            Viewpoint::Top => transfer::Viewpoint::Top,
            Viewpoint::Persp => transfer::Viewpoint::Persp,
        };
        let display = match (self.x_ray, self.particles) {
            (true, _) => Display::x_ray(),
            (_, true) => Display::particles(),
            _ => Display::default(),
        };
        let display = Display { slice: self.slice.map(|slice| slice.0), ..display };
        let theme = match self.theme {
            ThemeName::Light => Theme::light(),
            ThemeName::Dark => Theme::dark(),
        };
        transfer::Look { view, size: self.size.0, display, theme, field: None, tension: false, activation: false }
    }
}

/// Points of view.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(super) enum Viewpoint {
    /// From the front, parallel: X right, Y up
    Front,
    /// From the side, parallel: Z right, Y up
    Side,
    /// From above, parallel: X right, Z down
    Top,
    /// In perspective, from the front, right and above
    #[default]
    Persp,
}

/// Themes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(super) enum ThemeName {
    /// For bright surroundings
    #[default]
    Light,
    /// For dark surroundings
    Dark,
}

/// Greatest extent that can be asked for [pixels]; a driver may draw less.
const LARGEST: u32 = 16384;

/// Width and height [pixels].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct PixelSize(pub(super) [u32; 2]);

impl Default for PixelSize {
    fn default() -> Self {
        Self([1280, 800])
    }
}

impl fmt::Display for PixelSize {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}x{}", self.0[0], self.0[1])
    }
}

impl FromStr for PixelSize {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let extent = |text: &str| text.parse().ok().filter(|extent| (1..=LARGEST).contains(extent));
        text.split_once(['x', 'X'])
            .and_then(|(width, height)| Some(Self([extent(width)?, extent(height)?])))
            .ok_or_else(|| format!("give width and height in pixels, up to {LARGEST} each, as in 1280x800"))
    }
}

/// Where bodies are cut open.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct SliceOption(pub(super) Slice);

impl FromStr for SliceOption {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let read = || {
            let (name, place) = text.split_once('=')?;
            let flipped = name.starts_with('-');
            let axis = match name.trim_start_matches('-').to_lowercase().as_str() {
                "x" => Axis::X,
                "y" => Axis::Y,
                "z" => Axis::Z,
                _ => return None,
            };
            let at = place.parse().ok().filter(|at: &f64| at.is_finite())?;
            Some(Self(Slice { axis, at, flipped }))
        };
        read().ok_or_else(|| {
            "give an axis and a place on it in metres, as in x=0.01, or -x=0.01 for the other side".to_owned()
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cut_is_an_axis_a_place_and_a_side() {
        let cut = |axis, at, flipped| Ok(SliceOption(Slice { axis, at, flipped }));
        assert_eq!("x=0.01".parse(), cut(Axis::X, 0.01, false));
        assert_eq!("-Y=-2e-3".parse(), cut(Axis::Y, -2e-3, true));
        for bad in ["", "x", "w=1", "x=", "x=nan", "x=0.01m", "=1"] {
            assert!(bad.parse::<SliceOption>().is_err(), "{bad}");
        }
    }

    #[test]
    fn sizes_are_two_numbers_with_an_x() {
        assert_eq!("640x480".parse(), Ok(PixelSize([640, 480])));
        for bad in ["", "640", "0x480", "640x-1", "640x480x2", "99999x1"] {
            assert!(bad.parse::<PixelSize>().is_err(), "{bad}");
        }
    }
}
