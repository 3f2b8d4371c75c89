//! Pictures from the command line: what they show, and the making of them.

use super::CliError;
use crate::draw::Slice;
use crate::scene::{Axis, Scene};
use crate::solver::snapshot::Snapshot;
use clap::{Args, ValueEnum};
use std::fmt;
use std::str::FromStr;

/// What pictures show, and how.
#[derive(Clone, Copy, Debug, Default, PartialEq, Args)]
#[command(next_help_heading = "Pictures")]
pub struct Look {
    /// From where
    #[arg(long, value_name = "VIEW", default_value_t, value_enum)]
    view: Viewpoint,
    /// Width and height in pixels
    #[arg(long, value_name = "WxH", default_value_t)]
    size: PixelSize,
    /// Show the inside: skins see-through, fibres as tubes
    #[arg(long)]
    x_ray: bool,
    /// Show material and structure particles in place of skins
    #[arg(long, conflicts_with = "x_ray")]
    particles: bool,
    /// Cut bodies open across X, Y or Z at so many metres: `x=0.01` takes away what lies beyond, `-x=0.01` what lies before
    #[arg(long, value_name = "AXIS=M", allow_hyphen_values = true)]
    slice: Option<SliceOption>,
    /// Colours
    #[arg(long, value_name = "THEME", default_value_t, value_enum)]
    theme: ThemeName,
}

/// Points of view.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
enum Viewpoint {
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
enum ThemeName {
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
struct PixelSize([u32; 2]);

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
struct SliceOption(Slice);

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

#[cfg(feature = "render")]
pub use drawn::SceneRenderer;
#[cfg(not(feature = "render"))]
pub use undrawn::SceneRenderer;

#[cfg(feature = "render")]
mod drawn {
    use super::{CliError, Look, Scene, Snapshot, ThemeName, Viewpoint};
    use crate::draw::{Bounds, Display, Subject, Theme, draw};
    use crate::render::{Camera, Facing, Offscreen};

    /// Makes pictures of a scene, all from the same point of view.
    pub struct SceneRenderer {
        offscreen: Offscreen,
        camera: Camera,
        display: Display,
        theme: Theme,
        aspect: f64,
        bounds: Option<Bounds>,
    }

    impl SceneRenderer {
        /// Opens a driver, and looks at the scene as it starts.
        ///
        /// # Errors
        /// [`CliError::Render`] where there is no driver, or none for pictures of this size.
        pub fn open(look: &Look, scene: &Scene, start: &Snapshot) -> Result<Self, CliError> {
            let camera = match look.view {
                Viewpoint::Front => Camera::facing(Facing::Front),
                Viewpoint::Side => Camera::facing(Facing::Side),
                Viewpoint::Top => Camera::facing(Facing::Top),
                Viewpoint::Persp => Camera::perspective(),
            };
            let display = match (look.x_ray, look.particles) {
                (true, _) => Display::x_ray(),
                (_, true) => Display::particles(),
                _ => Display::default(),
            };
            let display = Display { slice: look.slice.map(|cut| cut.0), ..display };
            let theme = match look.theme {
                ThemeName::Light => Theme::light(),
                ThemeName::Dark => Theme::dark(),
            };
            let [width, height] = look.size.0.map(f64::from);
            let offscreen = Offscreen::new(look.size.0)?;
            let mut renderer = Self { offscreen, camera, display, theme, aspect: width / height, bounds: None };
            renderer.take_in(scene, start);
            Ok(renderer)
        }

        /// Steps back far enough to see this state too, beside all that was to be seen before.
        pub fn take_in(&mut self, scene: &Scene, snapshot: &Snapshot) {
            let list = draw(&Subject { scene, snapshot, ghost: None }, &self.display, &self.theme);
            self.bounds = match (self.bounds, list.bounds) {
                (Some(a), Some(b)) => Some(a.union(b)),
                (a, b) => a.or(b),
            };
            if let Some(bounds) = &self.bounds {
                self.camera.frame(bounds, self.aspect);
            }
        }

        /// A picture as a PNG file.
        ///
        /// # Errors
        /// [`CliError::Render`].
        pub fn picture(&mut self, scene: &Scene, snapshot: &Snapshot) -> Result<Vec<u8>, CliError> {
            let list = draw(&Subject { scene, snapshot, ghost: None }, &self.display, &self.theme);
            Ok(self.offscreen.draw(list, &self.camera)?.to_png()?)
        }
    }
}

#[cfg(not(feature = "render"))]
mod undrawn {
    use super::{CliError, Look, Scene, Snapshot};

    /// Makes no pictures: the program was built without them.
    pub enum SceneRenderer {}

    impl SceneRenderer {
        /// Says so.
        ///
        /// # Errors
        /// [`CliError::NoPictures`].
        pub fn open(_look: &Look, _scene: &Scene, _start: &Snapshot) -> Result<Self, CliError> {
            Err(CliError::NoPictures)
        }

        /// Never called.
        pub fn take_in(&mut self, _scene: &Scene, _snapshot: &Snapshot) {
            match *self {}
        }

        /// Never called.
        ///
        /// # Errors
        /// None.
        pub fn picture(&mut self, _scene: &Scene, _snapshot: &Snapshot) -> Result<Vec<u8>, CliError> {
            match *self {}
        }
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
