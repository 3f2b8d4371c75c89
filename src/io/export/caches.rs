//! Point caches: PC2 and MDD, one a body, with its rest shape beside them. Numbers are single precision, as the formats
//! have them.
//!
//! What an earlier run left stays whole until the first frame is there: then its cache and, at once after it, its rest
//! shape are replaced.
//!
//! PC2 (3ds Max, Blender): "POINTCACHE2", a zero; version 1, points, number of the first frame, frames a sample,
//! samples; then x, y, z of every point of every sample, the least byte first. MDD (LightWave, Blender): samples,
//! points, the time of every sample [s], then the points, the greatest byte first.

use super::names::{different, file_name};
use super::obj::write_rest;
use super::republished::Republished;
use super::writer::{MotionWriter, Planned};
use crate::export::{BodySubject, Frame, Subject};
use crate::io::IoError;
use crate::io::atomic::Draft;
use crate::io::door::OpenFile;
use glam::DVec3;
use std::io::{self, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

/// Bytes of the head of a PC2 file, and where in it the number of samples stands.
const PC2_HEAD: u64 = 32;
const PC2_SAMPLES: u64 = 28;

/// Names of the bodies' files without an ending.
fn names(subject: &Subject) -> Vec<String> {
    different(subject.bodies.iter().map(|body| body.name.as_str()), file_name)
}

/// The caches and the rest shapes.
pub(super) fn files(folder: &Path, subject: &Subject, ending: &str) -> Vec<PathBuf> {
    let of = |name: String| [folder.join(format!("{name}.{ending}")), rest_file(folder, &name)];
    names(subject).into_iter().flat_map(of).collect()
}

/// The rest shape's file: not of the body's own name, which may well be that of its model.
fn rest_file(folder: &Path, name: &str) -> PathBuf {
    folder.join(format!("{name}_rest.obj"))
}

/// A rest shape that waits beside its file for the first frame of its cache.
struct RestDraft {
    path: PathBuf,
    draft: Draft,
}

impl RestDraft {
    fn write(path: PathBuf, body: &BodySubject) -> Result<Self, IoError> {
        let write = || {
            let mut draft = Draft::begin(&path)?;
            write_rest(&mut draft, body)?;
            draft.flush()?;
            Ok(draft)
        };
        match write() {
            Ok(draft) => Ok(Self { path, draft }),
            Err(error) => Err(IoError::of_writing(error).within(&path)),
        }
    }

    fn put(self) -> Result<(), IoError> {
        self.draft.replace().map(drop).map_err(|error| IoError::of_writing(error).within(&self.path))
    }
}

/// Writes the rest shape of every body beside its file; gives the caches and those.
fn write_rests(folder: &Path, subject: &Subject, ending: &str) -> Result<Vec<(PathBuf, RestDraft)>, IoError> {
    let each = names(subject).into_iter().zip(&subject.bodies);
    let files = each.map(|(name, body)| {
        let rest = RestDraft::write(rest_file(folder, &name), body)?;
        Ok((folder.join(format!("{name}.{ending}")), rest))
    });
    files.collect()
}

fn bytes(points: &[DVec3], each: fn(f32) -> [u8; 4]) -> Vec<u8> {
    points.iter().flat_map(|point| point.as_vec3().to_array()).flat_map(each).collect()
}

/// A cache that is written on.
struct Growing {
    path: PathBuf,
    points: u32,
    /// None once the first frame is there.
    rest: Option<RestDraft>,
    /// None until the first frame is there.
    file: Option<OpenFile>,
    samples: u32,
}

/// PC2 point caches.
pub(super) struct Pc2 {
    first: u64,
    files: Vec<Growing>,
}

impl Pc2 {
    /// # Errors
    /// A file that cannot be written.
    pub(super) fn create(folder: &Path, subject: &Subject, frames: &Planned) -> Result<Self, IoError> {
        let caches = write_rests(folder, subject, "pc2")?;
        let file = |((path, rest), body): ((PathBuf, RestDraft), &BodySubject)| Growing {
            path,
            points: body.mesh.points.len() as u32,
            rest: Some(rest),
            file: None,
            samples: 0,
        };
        Ok(Self { first: *frames.start(), files: caches.into_iter().zip(&subject.bodies).map(file).collect() })
    }
}

impl Growing {
    fn push(&mut self, points: &[DVec3], first: u64) -> io::Result<()> {
        let data = bytes(points, f32::to_le_bytes);
        if let Some(file) = &mut self.file {
            file.seek(SeekFrom::Start(PC2_HEAD + data.len() as u64 * u64::from(self.samples)))?;
            file.write_all(&data)?;
            file.sync()?;
            // Only now there is one sample more: a file that is looked at in between is whole.
            file.seek(SeekFrom::Start(PC2_SAMPLES))?;
            file.write_all(&(self.samples + 1).to_le_bytes())?;
        } else {
            let mut draft = Draft::begin(&self.path)?;
            draft.write_all(b"POINTCACHE2\0")?;
            draft.write_all(&1_u32.to_le_bytes())?;
            draft.write_all(&self.points.to_le_bytes())?;
            draft.write_all(&(first as f32).to_le_bytes())?;
            draft.write_all(&1_f32.to_le_bytes())?;
            draft.write_all(&1_u32.to_le_bytes())?;
            draft.write_all(&data)?;
            self.file = Some(draft.replace()?);
        }
        self.samples += 1;
        Ok(())
    }
}

impl MotionWriter for Pc2 {
    fn push(&mut self, frame: &Frame) -> Result<(), IoError> {
        for (file, body) in self.files.iter_mut().zip(&frame.bodies) {
            file.push(&body.vertices, self.first).map_err(|error| IoError::Write(error).within(&file.path))?;
            file.rest.take().map_or(Ok(()), RestDraft::put)?;
        }
        Ok(())
    }

    fn written(&self) -> Vec<(String, PathBuf)> {
        let told = |file: &Growing| {
            (format!("PC2 cache of {} frames, its rest shape beside it,", file.samples), file.path.clone())
        };
        self.files.iter().filter(|file| file.samples > 0).map(told).collect()
    }
}

/// MDD point caches.
pub(super) struct Mdd {
    times: Vec<f32>,
    files: Vec<MddFile>,
}

/// One of them.
struct MddFile {
    file: Republished,
    points: u32,
    /// None once the first frame is there.
    rest: Option<RestDraft>,
}

impl MddFile {
    fn publish(&mut self, times: &[f32]) -> Result<(), IoError> {
        self.file.publish(&mdd_head(times, self.points), &[])?;
        self.rest.take().map_or(Ok(()), RestDraft::put)
    }
}

impl Mdd {
    /// # Errors
    /// A file that cannot be written.
    pub(super) fn create(folder: &Path, subject: &Subject) -> Result<Self, IoError> {
        let caches = write_rests(folder, subject, "mdd")?;
        let mut files = Vec::new();
        for ((cache, rest), body) in caches.into_iter().zip(&subject.bodies) {
            let points = body.mesh.points.len() as u32;
            files.push(MddFile { file: Republished::create(cache)?, points, rest: Some(rest) });
        }
        Ok(Self { times: Vec::new(), files })
    }
}

fn mdd_head(times: &[f32], points: u32) -> Vec<u8> {
    let numbers = [times.len() as u32, points].into_iter().flat_map(u32::to_be_bytes);
    numbers.chain(times.iter().flat_map(|time| time.to_be_bytes())).collect()
}

impl MotionWriter for Mdd {
    fn push(&mut self, frame: &Frame) -> Result<(), IoError> {
        self.times.push(frame.time as f32);
        for (of, body) in self.files.iter_mut().zip(&frame.bodies) {
            if of.file.add(&bytes(&body.vertices, f32::to_be_bytes))? {
                of.publish(&self.times)?;
            }
        }
        Ok(())
    }

    fn finish(&mut self) -> Result<(), IoError> {
        for of in self.files.iter_mut().filter(|of| of.file.is_behind()) {
            // Where a disk was full, one may have a frame less than another.
            of.publish(&self.times[..of.file.frames()])?;
        }
        Ok(())
    }

    fn written(&self) -> Vec<(String, PathBuf)> {
        let what = format!("MDD cache of {} frames, its rest shape beside it,", self.times.len());
        let files = self.files.iter().filter(|_| !self.times.is_empty());
        files.map(|of| (what.clone(), of.file.path().to_owned())).collect()
    }
}
