//! The surface by which a fibre solid meets others.

use crate::geometry::hollows::Hollows;
use crate::geometry::lattice::LatticeSample;
use crate::geometry::lattice_hull::LatticeHull;
use crate::geometry::nearest::SurfaceIndex;
use crate::scene::Scene;
use crate::solver::contact_surface::ContactSurface;
use crate::solver::skin::Skin;
use glam::IVec3;
use rayon::prelude::*;
use std::collections::HashMap;
use std::sync::Arc;

/// Least and greatest radius of a ball, in spacings.
const RADII: [f64; 2] = [0.2, 1.0];

/// That of a body, from its particles at rest and its skin; none where there is nothing else that it could meet by it.
pub(super) fn contact_surface(
    scene: &Scene,
    sample: &LatticeSample,
    hollows: &Hollows,
    skin: Option<&Skin>,
) -> Option<Arc<ContactSurface>> {
    if scene.bodies.len() < 2 {
        return None;
    }
    let LatticeSample { points, cells, spacing, .. } = sample;
    let hull = LatticeHull::new(points, cells, |a, b| hollows.is_empty() || !hollows.separate(a, b));
    let radii = match skin {
        Some(skin) => {
            let index = SurfaceIndex::new(skin.positions(points), skin.triangles().to_vec());
            let depth = |&i: &u32| {
                let at = points[i as usize];
                index.nearest(at).map_or(0.5 * spacing, |nearest| nearest.point.distance(at))
            };
            let [least, greatest] = RADII;
            hull.outer.par_iter().map(depth).map(|r| r.clamp(least * spacing, greatest * spacing)).collect()
        }
        None => vec![0.5 * spacing; hull.outer.len()],
    };
    let around = around(cells, &hull.outer);
    let distance = |a: u32, b: u32| points[a as usize].distance(points[b as usize]);
    Some(Arc::new(ContactSurface::new(points.len(), hull, radii, distance, &around)))
}

/// Those of some points and of their six neighbours that are there, of each.
fn around(cells: &[IVec3], of: &[u32]) -> Vec<Vec<u32>> {
    let at: HashMap<IVec3, u32> = cells.iter().zip(0..).map(|(&cell, i)| (cell, i)).collect();
    let steps = [IVec3::ZERO, IVec3::X, IVec3::NEG_X, IVec3::Y, IVec3::NEG_Y, IVec3::Z, IVec3::NEG_Z];
    let near = |&i: &u32| {
        let cell = cells[i as usize];
        steps.iter().filter_map(|&step| at.get(&(cell + step)).copied()).collect()
    };
    of.iter().map(near).collect()
}
