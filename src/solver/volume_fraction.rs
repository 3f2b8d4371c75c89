//! Volume fraction of fibre at every material particle (eq. 18).

use crate::geometry::closest::closest_on_triangle;
use crate::geometry::neighbours::PointGrid;
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

/// Raises the fractions at particles to those of a sheet: its `l_s` times the falloff at the distance to the nearest
/// point of its triangles [m], which ends at `reach` [m].
pub(crate) fn add_sheet(
    particles: &[DVec3],
    (fraction, triangles): (f64, Vec<[DVec3; 3]>),
    (reach, falloff): (f64, &FalloffCurve),
    fractions: &mut [f64],
) {
    // All that a triangle reaches lies this near to its middle.
    let middle = |[a, b, c]: [DVec3; 3]| (a + b + c) / 3.0;
    let size = triangles.iter().map(|&of| of.iter().map(|x| x.distance(middle(of))).fold(0.0, f64::max));
    let grid = PointGrid::new(particles, reach + size.fold(0.0, f64::max));
    let mut nearest = vec![f64::INFINITY; particles.len()];
    for of in triangles {
        for k in grid.within(middle(of)) {
            let k = k as usize;
            let [a, b, c] = closest_on_triangle(particles[k], of);
            let distance = particles[k].distance_squared(a * of[0] + b * of[1] + c * of[2]);
            nearest[k] = nearest[k].min(distance);
        }
    }
    for (share, nearest) in fractions.iter_mut().zip(nearest).filter(|(_, nearest)| nearest.is_finite()) {
        *share = share.max(fraction * falloff(nearest.sqrt()));
    }
}
