//! Parts of a solid that its particles miss altogether: fins and blades between two layers of the lattice, of which no
//! count of particles tells anything, since there are none.

use super::cell_map::CellSet;
use super::inside::spread;
use super::lattice::LatticeSample;
use super::solid::Solid;
use glam::{DVec3, IVec3};

/// A place of the surface that no particle is near.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct MissedPlace {
    /// Where it is [m].
    pub(crate) at: DVec3,
    /// Unit vector out of the solid there.
    pub(crate) outwards: DVec3,
}

/// Places of the surface that are looked at, about.
const PLACES: f64 = 3000.0;

/// Spacings from the surface to the nearest particle, at most, where one is in what lies below it: at the corner of a
/// cube there may be 0.87, at an edge that is sharper some more.
const NEAR: f64 = 1.5;

/// Cells along each axis that may be so near.
const CELLS: i32 = 2;

/// Places of the surface near which there are neither particles nor any of `others` [m], and which share of the surface
/// they stand for.
pub(crate) fn missed_places(solid: &Solid, sample: &LatticeSample, others: &[DVec3]) -> (f64, Vec<MissedPlace>) {
    let (Some(&point), Some(cell)) = (sample.points.first(), sample.cells.first()) else { return (0.0, Vec::new()) };
    let spacings = sample.spacing * sample.stretch;
    let origin = point - spacings * cell.as_dvec3();
    let along = |at: DVec3| (at - origin) / spacings;
    let mut taken: CellSet = sample.cells.iter().copied().collect();
    taken.extend(others.iter().map(|&at| along(at).round().as_ivec3()));
    let reach = || -CELLS..=CELLS;
    let mut steps: Vec<IVec3> =
        reach().flat_map(|z| reach().flat_map(move |y| reach().map(move |x| IVec3::new(x, y, z)))).collect();
    // Most places have a particle in one of the first of them.
    steps.sort_by_key(|step| step.length_squared());
    let is_missed = |place: &MissedPlace| {
        let at = along(place.at);
        let middle = at.round().as_ivec3();
        let is_near = |step: &&IVec3| at.distance((middle + **step).as_dvec3()) < NEAR;
        !steps.iter().filter(is_near).any(|&step| taken.contains(&(middle + step)))
    };
    let all = places_on(solid);
    let missed: Vec<MissedPlace> = all.iter().filter(|place| is_missed(place)).copied().collect();
    (missed.len() as f64 / all.len().max(1) as f64, missed)
}

/// Places spread evenly over the surface.
fn places_on(solid: &Solid) -> Vec<MissedPlace> {
    let corners = |face: &[u32; 3]| face.map(|i| solid.surface.points[i as usize]);
    let doubled = |[a, b, c]: [DVec3; 3]| (b - a).cross(c - a);
    let whole: f64 = solid.surface.faces.iter().map(|face| doubled(corners(face)).length()).sum();
    let step = whole / PLACES;
    let mut places = Vec::with_capacity(PLACES as usize + 1);
    let (mut passed, mut next) = (0.0, 0.5 * step);
    for face in &solid.surface.faces {
        let [a, b, c] = corners(face);
        let normal = doubled([a, b, c]);
        passed += normal.length();
        while next < passed {
            let [u, v] = spread(places.len());
            // The other half of the parallelogram is turned onto the triangle.
            let [u, v] = if u + v > 1.0 { [1.0 - u, 1.0 - v] } else { [u, v] };
            places.push(MissedPlace { at: a + u * (b - a) + v * (c - a), outwards: normal.normalize_or_zero() });
            next += step;
        }
    }
    places
}
