//! What is said of how a body's sections come out.

use super::note::Note;
use crate::geometry::cell_shares::CellShares;
use crate::geometry::lattice::LatticeSample;
use crate::scene::Body;
use glam::DVec3;

/// By how much a section whose particles stand for parts of cells bends and twists off theory, at most, times its
/// layers. Measured by `sections_of_every_kind` in `tests/physics`.
const BENDING: f64 = 0.5;
const TORSION: f64 = 0.45;

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

/// How the lattice was stretched, and how far off a section may be whose particles stand for parts of cells, where the
/// thinnest part is of this thickness [m].
pub(super) fn section_notes(
    sample: &LatticeSample,
    shares: Option<&CellShares>,
    thickness: f64,
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
    if let Some(shares) = shares {
        let layers = thickness / sample.cell_volume().cbrt();
        let parts = shares.volumes.iter().filter(|volume| **volume != 1.0).count();
        let [least, most] = shares.range();
        let [bending, torsion] = [BENDING, TORSION].map(|of| 100.0 * of / layers);
        let off = match (bending > MET, torsion > MET) {
            (true, _) => format!(", it may bend up to {bending:.0} % and twist up to {torsion:.0} % off theory"),
            (false, true) => format!(", it may twist up to {torsion:.0} % off theory"),
            (false, false) => String::new(),
        };
        note(format!(
            "{parts} of {} particles stand for {least:.2} to {most:.2} of a cell, since its surface lies askew to their \
             lattice: {layers:.1} layers thick where it is thinnest{off}",
            sample.points.len()
        ));
    }
    notes
}
