//! Volume fraction of fibre at every material particle (eq. 18).

use glam::DVec3;

/// How the fraction falls off from 1 at distance 0 to 0 at the support radius: the relative value at a distance [m].
pub(crate) type FalloffCurve = dyn Fn(f64) -> f64 + Sync;

/// Fraction `l_i` at every particle: `l_f` times the falloff at the distance to the nearest structure particle; where
/// several fibres reach a particle, the largest counts. `fibres` gives each fibre's `l_f` and structure particles at
/// rest [m].
pub(crate) fn volume_fractions(particles: &[DVec3], fibres: &[(f64, &[DVec3])], falloff: &FalloffCurve) -> Vec<f64> {
    particles
        .iter()
        .map(|particle| {
            fibres
                .iter()
                .map(|(fraction, vertices)| {
                    let nearest =
                        vertices.iter().map(|vertex| vertex.distance_squared(*particle)).fold(f64::INFINITY, f64::min);
                    fraction * falloff(nearest.sqrt())
                })
                .fold(0.0, f64::max)
        })
        .collect()
}
