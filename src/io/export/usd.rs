//! USD as text: `motion.usda` over a folder of layers, one for what stays, one a frame for what moves.
//!
//! The frames are value clips: the stage finds the layer of a time by its number, so that none of them has to be read
//! for another, nothing but the present frame is ever in memory here, and a run that ends early leaves a stage that
//! ends early. Numbers of the frames are the stage's time codes. Places are single precision, as the schemas have them.
//!
//! What an earlier run left stays whole until the first frame is there: layers are called otherwise than those of the
//! stage that is there, and when the new one takes its place nothing names them any more.

use super::usd_shape::{PrimNames, Widths, prim_names, write_shape};
use super::usd_text::{extent_of, quoted, write_list, write_vectors};
use super::writer::{MotionWriter, Planned};
use crate::export::{BodyFrame, Frame, Space, Subject};
use crate::geometry::model::UpAxis;
use crate::io::atomic::remove_orphan;
use crate::io::read::read_bytes;
use crate::io::{IoError, make_folder, write_atomically};
use glam::DVec3;
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// The stage, and the folder of its layers.
const STAGE: &str = "motion.usda";
const LAYERS: &str = "motion_layers";

/// No stage that was written here is longer [bytes].
const LONGEST_STAGE: u64 = 1 << 20;

/// What is put to the names of layers, by turns from run to run.
const TURNS: [&str; 2] = ["", "-2"];

/// Names of the layers of one stage.
#[derive(Clone, Copy)]
struct LayerNames {
    turn: &'static str,
}

impl LayerNames {
    fn all() -> [Self; 2] {
        TURNS.map(|turn| Self { turn })
    }

    /// Those that the stage in a folder does not name.
    fn unused(folder: &Path) -> Self {
        let stage = read_bytes(&folder.join(STAGE), LONGEST_STAGE).unwrap_or_default();
        let stage = String::from_utf8_lossy(&stage);
        let is_used = |of: &Self| stage.contains(&format!("@./{LAYERS}/{}@", of.shape()));
        let [first, second] = Self::all();
        if is_used(&first) { second } else { first }
    }

    fn shape(self) -> String {
        format!("shape{}.usda", self.turn)
    }

    fn manifest(self) -> String {
        format!("manifest{}.usda", self.turn)
    }

    /// The layer of a frame, by its number or by what stands for it.
    fn frame(self, number: &str) -> String {
        format!("frame{}.{number}.usda", self.turn)
    }

    /// Whether a file is called like one of these layers.
    fn is_one(self, name: &str) -> bool {
        let number = name.strip_prefix("frame").and_then(|rest| rest.strip_prefix(self.turn)?.strip_prefix('.'));
        let is_frame = number
            .and_then(|rest| rest.strip_suffix(".usda"))
            .is_some_and(|number| number.len() >= 6 && number.bytes().all(|digit| digit.is_ascii_digit()));
        is_frame || name == self.shape() || name == self.manifest()
    }

    /// Removes them from a folder, where no stage names them.
    fn remove(self, layers: &Path) {
        for entry in fs::read_dir(layers).into_iter().flatten().flatten() {
            if entry.file_name().to_str().is_some_and(|name| self.is_one(name)) {
                remove_orphan(&entry.path());
            }
        }
    }
}

/// The stage, and the layers of what stays.
pub(super) fn files(folder: &Path) -> Vec<PathBuf> {
    let layers = folder.join(LAYERS);
    let of = |names: LayerNames| [names.shape(), names.manifest()];
    let layers = LayerNames::all().into_iter().flat_map(of).map(|name| layers.join(name));
    std::iter::once(folder.join(STAGE)).chain(layers).collect()
}

/// A stage that is written.
pub(super) struct Usd {
    folder: PathBuf,
    layers: LayerNames,
    names: Vec<PrimNames>,
    widths: Vec<Widths>,
    head: Head,
    first: u64,
    frames: u64,
}

impl Usd {
    /// Writes what stays.
    ///
    /// # Errors
    /// A file that cannot be written.
    pub(super) fn create(folder: &Path, subject: &Subject, frames: &Planned) -> Result<Self, IoError> {
        let names = prim_names(subject);
        let within = folder.join(LAYERS);
        make_folder(&within)?;
        let layers = LayerNames::unused(folder);
        // A run that was killed may have left some.
        layers.remove(&within);
        write_atomically(&within.join(layers.shape()), |out| write_shape(out, subject, &names))?;
        write_atomically(&within.join(layers.manifest()), |out| write_manifest(out, &names))?;
        let head =
            Head { name: subject.name.clone(), frame_seconds: subject.frame_seconds, space: subject.space, layers };
        let widths = subject.bodies.iter().map(Widths::of).collect();
        Ok(Self { folder: folder.to_owned(), layers, names, widths, head, first: *frames.start(), frames: 0 })
    }
}

impl MotionWriter for Usd {
    fn push(&mut self, frame: &Frame) -> Result<(), IoError> {
        let layers = self.folder.join(LAYERS);
        let clip = layers.join(self.layers.frame(&format!("{:06}", frame.number)));
        write_atomically(&clip, |out| write_clip(out, &self.names, &self.widths, frame))?;
        // The stage tells of a frame once it is there.
        let last = self.first + self.frames;
        write_atomically(&self.folder.join(STAGE), |out| self.head.write(out, self.first, last))?;
        if self.frames == 0 {
            let others = LayerNames::all().into_iter().filter(|names| names.turn != self.layers.turn);
            others.for_each(|names| names.remove(&layers));
        }
        self.frames += 1;
        Ok(())
    }

    fn written(&self) -> Vec<(String, PathBuf)> {
        let told = (format!("USD stage of {} frames", self.frames), self.folder.join(STAGE));
        if self.frames == 0 { Vec::new() } else { vec![told] }
    }
}

/// What the stage says of the whole.
struct Head {
    name: String,
    frame_seconds: f64,
    space: Space,
    layers: LayerNames,
}

impl Head {
    fn write(&self, out: &mut dyn Write, first: u64, last: u64) -> io::Result<()> {
        let rate = 1.0 / self.frame_seconds;
        // Sixty frames a second are meant to be sixty, whatever becomes of a sixtieth.
        let rate = if (rate - rate.round()).abs() < 1e-9 * rate { rate.round() } else { rate };
        let up = if self.space.up == UpAxis::Z { "Z" } else { "Y" };
        let unit = 1.0 / self.space.scale;
        let names = self.layers;
        let (shape, manifest, frames) = (names.shape(), names.manifest(), names.frame("######"));
        writeln!(out, "#usda 1.0\n(\n    defaultPrim = \"Scene\"\n    doc = {}", quoted(&self.name))?;
        writeln!(out, "    endTimeCode = {last}\n    framesPerSecond = {rate}\n    metersPerUnit = {unit}")?;
        writeln!(out, "    startTimeCode = {first}\n    subLayers = [\n        @./{LAYERS}/{shape}@\n    ]")?;
        writeln!(out, "    timeCodesPerSecond = {rate}\n    upAxis = \"{up}\"\n)\n")?;
        writeln!(out, "over \"Scene\" (\n    clips = {{\n        dictionary default = {{")?;
        writeln!(out, "            asset manifestAssetPath = @./{LAYERS}/{manifest}@")?;
        writeln!(out, "            string primPath = \"/Scene\"")?;
        writeln!(out, "            string templateAssetPath = \"./{LAYERS}/{frames}\"")?;
        writeln!(out, "            double templateStartTime = {first}\n            double templateEndTime = {last}")?;
        writeln!(out, "            double templateStride = 1\n        }}\n    }}\n)\n{{\n}}")
    }
}

/// What a clip has of every prim.
fn write_manifest(out: &mut dyn Write, names: &[PrimNames]) -> io::Result<()> {
    writeln!(out, "#usda 1.0\n\nover \"Scene\"\n{{")?;
    let mut declare = |name: &str, attributes: &[&str]| {
        writeln!(out, "    over \"{name}\"\n    {{\n        float3[] extent\n        point3f[] points")?;
        attributes.iter().try_for_each(|attribute| writeln!(out, "        {attribute}"))?;
        writeln!(out, "    }}")
    };
    for names in names {
        let normals = names.normals.as_ref().map(|_| "normal3f[] normals");
        declare(&names.surface, &[&["vector3f[] velocities"][..], normals.as_slice()].concat())?;
        names.fibres.iter().try_for_each(|name| declare(name, &["float[] primvars:tension"]))?;
        names.springs.iter().try_for_each(|name| declare(name, &[]))?;
    }
    writeln!(out, "}}")
}

/// What moves, in one frame.
fn write_clip(out: &mut dyn Write, names: &[PrimNames], widths: &[Widths], frame: &Frame) -> io::Result<()> {
    writeln!(out, "#usda 1.0\n\nover \"Scene\"\n{{")?;
    for ((names, widths), body) in names.iter().zip(widths).zip(&frame.bodies) {
        write_body(out, names, *widths, body, frame.number)?;
    }
    writeln!(out, "}}")
}

fn write_body(out: &mut dyn Write, names: &PrimNames, widths: Widths, body: &BodyFrame, at: u64) -> io::Result<()> {
    write_moving(out, (&names.surface, widths.surface), &body.vertices, at, &mut |out| {
        write!(out, "        vector3f[] velocities.timeSamples = {{\n            {at}: ")?;
        write_vectors(out, &body.velocities)?;
        writeln!(out, "\n        }}")?;
        let Some(normals) = &names.normals else { return Ok(()) };
        let normal = |&index: &u32| body.normals.get(index as usize).copied().unwrap_or(DVec3::Y);
        let normals: Vec<DVec3> = normals.list.iter().map(normal).collect();
        write!(out, "        normal3f[] normals.timeSamples = {{\n            {at}: ")?;
        write_vectors(out, &normals)?;
        writeln!(out, "\n        }}")
    })?;
    if let Some(name) = &names.fibres {
        let points: Vec<DVec3> = body.fibres.iter().flat_map(|fibre| fibre.vertices.iter().copied()).collect();
        write_moving(out, (name, widths.fibres), &points, at, &mut |out| {
            write!(out, "        float[] primvars:tension.timeSamples = {{\n            {at}: ")?;
            write_list(out, body.fibres.iter().flat_map(|fibre| fibre.tensions.iter().map(|force| *force as f32)))?;
            writeln!(out, "\n        }}")
        })?;
    }
    if let Some(name) = &names.springs {
        write_moving(out, (name, widths.springs), &body.springs, at, &mut |_| Ok(()))?;
    }
    Ok(())
}

/// A prim that moves, by its name and the width of what is drawn at its points, with what else it has.
fn write_moving(
    out: &mut dyn Write,
    (name, width): (&str, f64),
    points: &[DVec3],
    at: u64,
    more: &mut dyn FnMut(&mut dyn Write) -> io::Result<()>,
) -> io::Result<()> {
    write!(out, "    over \"{name}\"\n    {{\n        float3[] extent.timeSamples = {{\n            {at}: ")?;
    write_vectors(out, &extent_of(points, width))?;
    write!(out, "\n        }}\n        point3f[] points.timeSamples = {{\n            {at}: ")?;
    write_vectors(out, points)?;
    writeln!(out, "\n        }}")?;
    more(out)?;
    writeln!(out, "    }}")
}
