//! What becomes of fibres and of what drives them when their body is scaled.

use crate::edit::fibre_ops::{FibreEditError, Sampling, Transform, transform};
use crate::scene::{Drive, Fibre, FibreSource, SharedDrive, Stiffness, YieldPast};
use glam::DVec3;

/// A fibre of the same material in a body that is larger by a factor.
pub(super) fn scaled_fibre(fibre: &Fibre, factor: f64) -> Result<Fibre, FibreEditError> {
    let by = Transform::scaling(DVec3::ZERO, factor)?;
    // Strokes stay strokes and vertices vertices: nothing is sampled.
    let mut fibre = transform(fibre, &by, Sampling { model_diagonal: 1.0, spacing: 1.0 })?.fibre;
    let (area, inertia) = (factor.powi(2), factor.powi(4));
    match &mut fibre.stiffness {
        Stiffness::Rigidity(of) => (of.ea, of.ei, of.gj) = (of.ea * area, of.ei * inertia, of.gj * inertia),
        // Its bending stiffness is taken times the volume of a particle.
        Stiffness::Paper(of) => (of.ks, of.kb) = (of.ks * area, of.kb * factor),
    }
    if let Some(past) = &mut fibre.break_past
        && let Some(tension) = &mut past.tension
    {
        *tension *= area;
    }
    if let Some(YieldPast { tension, curvature_degrees_per_metre, .. }) = &mut fibre.yields {
        *tension = tension.map(|tension| tension * area);
        *curvature_degrees_per_metre = curvature_degrees_per_metre.map(|curvature| curvature / factor);
    }
    if let Some(activation) = &mut fibre.activation {
        if let Some(muscle) = &mut activation.muscle {
            muscle.force *= area;
        }
        scale_drive(&mut activation.drive, factor);
    }
    Ok(fibre)
}

/// A line that is drawn as fibres are, in a body that is larger by a factor.
pub(super) fn scaled_source(source: &FibreSource, factor: f64) -> Result<FibreSource, FibreEditError> {
    let drawn = Fibre { source: source.clone(), ..Fibre::through("line", Vec::<[f64; 3]>::new()) };
    Ok(scaled_fibre(&drawn, factor)?.source)
}

/// Waves along fibres are as many as before.
pub(super) fn scaled_drives(drives: &mut [SharedDrive], factor: f64) {
    for shared in drives {
        scale_drive(&mut shared.drive, factor);
    }
}

pub(super) fn scale_drive(drive: &mut Drive, factor: f64) {
    if let Some(wavelength) = drive.wave_mut().and_then(|wave| wave.wavelength.as_mut()) {
        *wavelength *= factor;
    }
}
