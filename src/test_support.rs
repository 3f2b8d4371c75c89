//! What the tests and benchmarks under `tests` look at besides the crate's face. No part of that face: these names come
//! and go with the inside of the crate, without a word in the list of changes.

/// Shapes and distances.
pub mod geometry {
    pub use crate::geometry::curve::{arc_length, distance_to_polyline};
    pub use crate::geometry::isosurface::isosurface;
    pub use crate::geometry::lattice::{LatticeSample, fill_box};
    pub use crate::geometry::nearest::SurfaceIndex;
    pub use crate::geometry::octahedron::sphere;
}

/// Forces one by one, and what they are made of.
pub mod solver {
    pub use crate::solver::forces::element::ElementForce;
    pub use crate::solver::forces::fibre::breaking::BreakLimits;
    pub use crate::solver::forces::fibre::{FibreForce, FibreRest};
    pub use crate::solver::forces::sheet::{SheetForce, SheetLaw, SheetRest};
    pub use crate::solver::forces::springs::{SpringGroup, Springs};
    pub use crate::solver::forces::{Elasticity, EvaluationKind, MatrixForce};
    pub use crate::solver::layers::Layers;
    pub use crate::solver::neighbourhood::Neighbourhood;
    pub use crate::solver::skin::{Skin, SkinShape};
}

/// The command line's own scenes.
pub mod cli {
    pub use crate::cli::make_pictures::{Demo, demo};
}

/// How files are written, and what is kept for the next start.
pub mod io {
    pub use crate::io::atomic::write_atomically;
    pub use crate::io::door::{Fate, Step, judged};
    pub use crate::io::recovery::{LeftRecording, Origin, RecoveryFile, left_recordings, recoverable_documents};
    pub use crate::io::scene::MAX_SCENE_BYTES;

    /// Writes a journal as the window does.
    ///
    /// # Errors
    /// As every write.
    pub fn write_journal(path: &std::path::Path, journal: &crate::sim::Journal) -> Result<(), crate::io::IoError> {
        crate::io::write_json(path, journal)
    }

    /// Reads a journal as `sinew replay` does: none of its scenes is out of range.
    ///
    /// # Errors
    /// What is wrong with the file, as people read it.
    pub fn read_journal(path: &std::path::Path) -> Result<crate::sim::Journal, String> {
        crate::cli::read_journal(path).map_err(|error| error.to_string())
    }

    /// Keeps what is done to a motion in the place of a document, as the window does: begun, then added to.
    ///
    /// # Errors
    /// As every write.
    pub fn write_recording(place: &RecoveryFile, lines: &[String]) -> Result<(), crate::io::IoError> {
        let mut kept = place.recording();
        let (begun, added) = lines.split_at(lines.len().min(2));
        kept.begin(begun)?;
        added.iter().try_for_each(|line| kept.add(&[line]).map(drop))
    }

    /// Points [m] of all lines in a file, one after the other, or what is said of it.
    ///
    /// # Errors
    /// What is wrong with the file, as people read it.
    pub fn points_of_lines(path: &std::path::Path) -> Result<Vec<glam::DVec3>, String> {
        let lines = crate::io::read_lines(path, |name| name == "bar").map_err(|error| error.to_string())?;
        Ok(lines.into_iter().flat_map(|line| line.points).collect())
    }
}

/// How large a scene is before it is put together.
pub mod scene {
    use crate::scene::{AnyBody, Scene};

    /// About how many particles it has; those of models are not counted.
    pub fn about_particles(scene: &Scene) -> f64 {
        let of = |body: AnyBody<'_>| match body {
            AnyBody::Solid(body) => body.about_particles(None),
            AnyBody::TwoLayer(body) => body.about_particles(None),
        };
        scene.all_bodies().filter_map(of).sum()
    }
}

/// Lines that help while a stroke is drawn, and the limits of a lift.
pub mod sketch {
    pub use crate::sketch::guides::guides;
    pub use crate::sketch::lift::{SAMPLES, STRAY_LIMIT};
    pub use crate::sketch::partial_lift::partial_lift;
}

/// Recording.
pub mod sim {
    pub use crate::sim::recording::DEFAULT_MEMORY;
}

/// Picking, and the device that a window shares.
#[cfg(feature = "render")]
pub mod render {
    pub use crate::render::device::open_device;
    pub use crate::render::pick::Pick;
}

/// The window without a screen.
#[cfg(feature = "gui")]
pub mod ui {
    pub use crate::ui::action::Action;
    pub use crate::ui::app::App;
    pub use crate::ui::gallery::{EXAMPLES, Example, Group};
    pub use crate::ui::menu::Menu;
}
