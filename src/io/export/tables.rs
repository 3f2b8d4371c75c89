//! Particles as tables, a CSV file a frame: every digit of every number.

use super::writer::{MotionWriter, Planned, told};
use crate::export::{BodyFrame, Frame, Subject};
use crate::io::{FrameFolder, IoError};
use glam::DVec3;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// Names of the columns. Places and velocities are in the unit that was asked for, stress is in pascals, and the
/// direction of the fibres has length one or, where there are none, zero; a field that a body has not is empty.
const HEAD: [&str; 14] = [
    "body",
    "particle",
    "x",
    "y",
    "z",
    "vx",
    "vy",
    "vz",
    "volume_fraction",
    "strain",
    "stress",
    "fibre_x",
    "fibre_y",
    "fibre_z",
];

/// A table of particles a frame.
pub(super) struct Tables {
    names: Vec<String>,
    frames: FrameFolder,
}

impl Tables {
    /// # Errors
    /// A folder that cannot be written.
    pub(super) fn create(folder: &Path, subject: &Subject, frames: &Planned) -> Result<Self, IoError> {
        let frames = FrameFolder::numbered(folder, "particles", "csv", *frames.start())?;
        Ok(Self { names: subject.bodies.iter().map(|body| body.name.clone()).collect(), frames })
    }
}

fn write_table(out: &mut dyn Write, names: &[String], bodies: &[BodyFrame]) -> csv::Result<()> {
    let mut table = csv::Writer::from_writer(out);
    table.write_record(HEAD)?;
    for (name, body) in names.iter().zip(bodies) {
        let particles = &body.particles;
        let vector = |v: Option<&DVec3>| v.copied().unwrap_or_default().to_array().map(|c| c.to_string());
        let scalar = |field: &[f64], k: usize| field.get(k).map_or_else(String::new, f64::to_string);
        for k in 0..particles.positions.len() {
            let mut row = vec![name.clone(), k.to_string()];
            row.extend(vector(particles.positions.get(k)));
            row.extend(vector(particles.velocities.get(k)));
            row.extend([&particles.fractions, &particles.strains, &particles.stresses].map(|field| scalar(field, k)));
            row.extend(vector(particles.directions.get(k)));
            table.write_record(&row)?;
        }
    }
    Ok(table.flush()?)
}

impl MotionWriter for Tables {
    fn push(&mut self, frame: &Frame) -> Result<(), IoError> {
        self.frames.push(|out| write_table(out, &self.names, &frame.bodies).map_err(io::Error::other))
    }

    fn written(&self) -> Vec<(String, PathBuf)> {
        told(&self.frames, format!("{} tables of particles", self.frames.frames()))
    }

    fn left_over(&self) -> usize {
        self.frames.left_over()
    }
}
