//! What a format makes of a motion, told before any of it is written.

use super::caches;
use super::formats::{MotionFiles, MotionFormat};
use super::gltf;
use super::writer::Planned;
use crate::export::{BodySize, BodySubject, Subject};
use crate::io::IoError;
use std::path::Path;

/// What a format makes of a motion.
#[derive(Debug, Default)]
pub(crate) struct Outline {
    /// Its files, as they are told: the first and the last of a sequence.
    pub(crate) files: Vec<String>,
    /// What there is of the bodies that it does not hold.
    pub(crate) left_out: Vec<&'static str>,
    /// Why it cannot hold the motion.
    pub(crate) refused: Option<IoError>,
}

/// Bodies of these names, all that the names of files are made of.
fn named(bodies: &[BodySize]) -> Subject {
    let body = |size: &BodySize| BodySubject { name: size.name.clone(), ..BodySubject::default() };
    Subject { bodies: bodies.iter().map(body).collect(), ..Subject::default() }
}

/// The files of a sequence.
fn sequence(prefix: &str, ending: &str, numbers: &Planned) -> String {
    let file = |number: &u64| format!("{prefix}{number:06}.{ending}");
    let (first, last) = (file(numbers.start()), file(numbers.end()));
    if first == last { first } else { format!("{first} to {last}") }
}

impl MotionFormat {
    /// What it is, in a few words.
    pub(crate) fn title(self) -> &'static str {
        match self {
            Self::Usd => "USD stage: shapes, velocities, fibres as curves with their tension",
            Self::Pc2 => "PC2 point caches on the file's own vertices, with rest shapes as OBJ",
            Self::Mdd => "MDD point caches on the file's own vertices, with rest shapes as OBJ",
            Self::Gltf => "glTF clip with morph targets, for up to 600 frames; always in metres with Y up",
            Self::Obj => "An OBJ file a frame: shapes, fibres as lines",
            Self::Ply => "Two PLY files a frame: shapes, and particles with their fields",
            Self::Csv => "A table of particles and their fields a frame",
        }
    }

    /// What it makes of bodies of these sizes in frames of these numbers.
    pub(crate) fn outline(self, bodies: &[BodySize], numbers: &Planned) -> Outline {
        let in_folder = || {
            let files = match self {
                Self::Pc2 => caches::files(Path::new(""), &named(bodies), "pc2"),
                _ => caches::files(Path::new(""), &named(bodies), "mdd"),
            };
            files.into_iter().map(|path| path.display().to_string()).collect()
        };
        let files = match self {
            Self::Usd => vec![format!("motion.usda with motion_layers/{}", sequence("frame.", "usda", numbers))],
            Self::Pc2 | Self::Mdd => in_folder(),
            Self::Gltf => vec!["motion.glb".to_owned()],
            Self::Obj => vec![sequence("frame_", "obj", numbers)],
            Self::Ply => ["frame_", "particles_"].map(|prefix| sequence(prefix, "ply", numbers)).to_vec(),
            Self::Csv => vec![sequence("particles_", "csv", numbers)],
        };
        let any = |of: fn(&BodySize) -> usize| bodies.iter().any(|body| of(body) > 0);
        let holds = |formats: &[Self]| formats.contains(&self);
        let parts = [
            ("surfaces", any(|body| body.faces), self == Self::Csv),
            ("fibres", any(|body| body.fibres), !holds(&[Self::Usd, Self::Obj])),
            ("sheets", any(|body| body.sheets), true),
            ("springs", any(|body| body.springs), self != Self::Usd),
            ("particles and their fields", any(|body| body.particles), !holds(&[Self::Ply, Self::Csv])),
        ];
        let left_out = parts.into_iter().filter(|(_, is_there, lacks)| *is_there && *lacks).map(|(what, ..)| what);
        let vectors: usize = bodies.iter().map(|body| body.vertices + body.normals).sum();
        let bytes = gltf::VECTOR * vectors;
        let refused = if self == Self::Gltf { gltf::check_length(bytes, numbers).err() } else { None };
        Outline { files, left_out: left_out.collect(), refused }
    }

    /// How many of its files are in a folder already and would be replaced.
    pub(crate) fn replaced(self, folder: &Path, bodies: &[BodySize], numbers: &Planned) -> usize {
        let files = MotionFiles::planned(&[self], folder, &named(bodies), numbers);
        files.iter().filter(|path| path.exists()).count()
    }
}
