//! The skin of a body with seams.

use super::error::BakeError;
use super::particle_sampling::ParticleSampling;
use super::seams::Seams;
use crate::geometry::kernel::Kernel;
use crate::geometry::point_tree::PointTree;
use crate::solver::forces::SeamBonds;
use crate::solver::skin::{PartedSkin, Skin, SkinShape};
use glam::DVec3;

/// Bonds within so many spacings of a point tell whether the seam is torn there; where there are none, within twice as
/// many, and so on.
const NEAR: f64 = 1.2;

/// Doublings after which nothing is near.
const DOUBLINGS: u32 = 3;

/// The skin that a body has once seams tear; none without any.
///
/// # Errors
/// That of `progress`.
pub(super) fn parted_skin(
    sampling: &ParticleSampling<'_>,
    (seams, bonds): (&Seams, &[SeamBonds]),
    kernel: Kernel,
    progress: &mut dyn FnMut(usize, usize) -> Result<(), BakeError>,
) -> Result<Option<PartedSkin>, BakeError> {
    if bonds.iter().all(|seam| seam.pairs.is_empty()) {
        return Ok(None);
    }
    let particles = &sampling.sample.points;
    let (surface, outer) = sampling.parted_surface(&seams.surfaces);
    let shape = SkinShape::of_drawn(&surface);
    let hollows = [sampling.hollows.clone(), seams.hollows(sampling)];
    let mut skins = Vec::new();
    for hollows in &hollows {
        skins.extend(Skin::try_embed(&shape, particles, kernel, hollows, progress)?);
    }
    let Ok(skins) = <[Skin; 2]>::try_from(skins) else { return Ok(None) };
    let place = |(&[i, j], seam): (&[u32; 2], usize)| {
        let ends = [i, j].map(|k| particles[k as usize]);
        ends[0].lerp(ends[1], seams.surfaces[seam].crossing(ends).unwrap_or(0.5))
    };
    let pairs = bonds.iter().enumerate().flat_map(|(seam, of)| of.pairs.iter().map(move |pair| (pair, seam)));
    let places = PointTree::new(pairs.map(place).collect());
    let near = |at: &DVec3| {
        let tried = (0..=DOUBLINGS).map(|k| NEAR * sampling.sample.spacing * f64::from(1 << k));
        let mut found =
            tried.map(|radius| places.within(*at, radius)).find(|near| !near.is_empty()).unwrap_or_default();
        found.sort_unstable();
        found
    };
    let near: Vec<Vec<u32>> = surface.points.iter().map(near).collect();
    // What hangs on the same particles either way is torn by nothing.
    let near: Vec<Vec<u32>> = (0..)
        .zip(near)
        .map(|(point, near)| if skins[0].hangs_alike(&skins[1], point) { Vec::new() } else { near })
        .collect();
    Ok(Some(PartedSkin::new(skins, surface.normals, outer, &near)))
}
