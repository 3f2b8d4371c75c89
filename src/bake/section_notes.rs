//! What is said of how a body's sections come out.

use super::note::Note;
use crate::geometry::filling::CellShares;
use crate::geometry::lattice::LatticeSample;
use crate::scene::Body;
use glam::DVec3;

/// By how much a section whose particles stand for parts of cells bends and twists off theory, at most, times its
/// layers. Measured by `sections_of_every_kind` in `tests/physics`.
const BENDING: f64 = 0.5;
const TORSION: f64 = 0.45;

/// The same of sections that are filled exactly by whole layers. Those about as wide as thick are met from three layers
/// on.
const WHOLE_BENDING: f64 = 0.27;
const WHOLE_TORSION: f64 = 0.48;
const COMPACT: f64 = 2.5;

/// What is that near to theory, in per cent, is not said.
const MET: f64 = 5.0;

/// That a box got another support radius than was asked for, if it did.
pub(super) fn radius_note(body: &Body, sample: &LatticeSample, path: &str) -> Option<Note> {
    let material = &body.material;
    let percent = 100.0 * (sample.spacing / material.spacing() - 1.0);
    let text = || {
        let radius = sample.spacing / material.spacing_ratio;
        format!("made {radius:.6} m ({percent:+.1} %) so that layers fit the box")
    };
    (percent != 0.0).then(|| Note { path: format!("{path}/material/support_radius"), text: text(), warning: false })
}

/// Where a shape is thinnest.
#[derive(Clone, Copy, Debug)]
pub(super) struct Thinnest {
    /// How thick it is there [m].
    pub(super) thickness: f64,
    /// Whether its section is a whole one, at most twice as wide as thick.
    pub(super) is_compact: bool,
}

/// How the lattice was stretched, and how far off theory a section may be that is as thin as the shape ever is.
pub(super) fn section_notes(
    sample: &LatticeSample,
    shares: Option<&CellShares>,
    thinnest: Thinnest,
    path: &str,
) -> Vec<Note> {
    let mut notes = Vec::new();
    let mut note = |text: String| notes.push(Note { path: format!("{path}/shape"), text, warning: false });
    let changes = sample.stretch - DVec3::ONE;
    if changes != DVec3::ZERO {
        let along = |(axis, change): (&str, f64)| format!("{:+.1} % along {axis}", 100.0 * change);
        let changed = ["x", "y", "z"].into_iter().zip(changes.to_array()).filter(|(_, change)| *change != 0.0);
        let changed: Vec<String> = changed.map(along).collect();
        note(format!("its layers are made thicker by {}, to fit the shape", changed.join(", ")));
    }
    let layers = thinnest.thickness / sample.cell_volume().cbrt();
    let off = |of: [f64; 2]| {
        let [bending, torsion] = of.map(|of| 100.0 * of / layers);
        match (bending > MET, torsion > MET) {
            (true, _) => format!(", it may bend up to {bending:.0} % and twist up to {torsion:.0} % off theory"),
            (false, true) => format!(", it may twist up to {torsion:.0} % off theory"),
            (false, false) => String::new(),
        }
    };
    if let Some(shares) = shares {
        let parts = shares.volumes.iter().filter(|volume| **volume != 1.0).count();
        let [least, most] = shares.range();
        let off = off([BENDING, TORSION]);
        note(format!(
            "{parts} of {} particles stand for {least:.2} to {most:.2} of a cell, since its surface lies askew to their \
             lattice: {layers:.1} layers thick where it is thinnest{off}",
            sample.points.len()
        ));
    } else {
        let off = off([WHOLE_BENDING, WHOLE_TORSION]);
        if !off.is_empty() && (!thinnest.is_compact || layers <= COMPACT) {
            note(format!("it is filled by whole layers, {layers:.1} of them where it is thinnest{off}"));
        }
    }
    notes
}
