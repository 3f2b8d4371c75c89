//! The skin of a body with seams: whole at first, split along them where they are torn.
//!
//! It has points on both sides of every seam, and both walls of it, and each of its points hangs on the particles in
//! two ways: on all around, as the skin of a whole body does, and on those of its own side alone. The bonds near it
//! that lie across a seam tell which: on its own side as soon as more than half of them are torn. Walls are seen where
//! all their corners are.

use super::{DIRECTIONS, Skin};
use crate::geometry::rig::Shading;
use glam::Vec3;
use std::ops::Range;
use std::sync::{Arc, OnceLock};

/// A skin that comes apart.
#[derive(Clone, Debug)]
pub struct PartedSkin {
    whole: Skin,
    /// The same points on the particles of their own side.
    apart: Skin,
    normals: Vec<Vec3>,
    /// How many faces, the first ones, are not of walls.
    outer: usize,
    /// Numbers of the bonds that tell of every point: those of point `p` are `starts[p]..starts[p + 1]`.
    starts: Vec<u32>,
    bonds: Vec<u32>,
}

/// A skin that is torn.
#[derive(Clone)]
pub(in crate::solver) struct TornSkin {
    /// Which bonds it shows torn.
    pub(in crate::solver) torn: Vec<bool>,
    pub(in crate::solver) skin: Arc<Skin>,
}

impl PartedSkin {
    /// A skin whose points hang on the particles as those of `whole` and, torn, of `apart`, with the file's normals.
    /// Its first `outer` faces are no walls; the bonds `near` every point tell whether it is torn, none of one that
    /// never is.
    pub(crate) fn new([whole, apart]: [Skin; 2], normals: Vec<Vec3>, outer: usize, near: &[Vec<u32>]) -> Self {
        let ends = near.iter().scan(0, |end, of| {
            *end += of.len() as u32;
            Some(*end)
        });
        Self { whole, apart, normals, outer, starts: [0].into_iter().chain(ends).collect(), bonds: near.concat() }
    }

    /// Memory that it takes [bytes], about.
    pub(in crate::solver) fn bytes(&self) -> usize {
        self.whole.bytes() + self.apart.bytes() + size_of_val(&*self.starts) + size_of_val(&*self.bonds)
    }

    /// The skin where these bonds are torn.
    pub(in crate::solver) fn at(&self, torn: &[bool]) -> Skin {
        let Self { whole, apart, .. } = self;
        let is_torn: Vec<bool> = (0..self.starts.len() - 1)
            .map(|p| {
                let near = &self.bonds[self.starts[p] as usize..self.starts[p + 1] as usize];
                2 * near.iter().filter(|bond| torn[**bond as usize]).count() > near.len()
            })
            .collect();
        let mut skin = Skin {
            starts: vec![0],
            particles: whole.particles,
            arms: whole.arms.with(&apart.arms),
            point_of: whole.point_of.clone(),
            colours: Arc::clone(&whole.colours),
            ..Skin::default()
        };
        // The arms of the second follow on those of the first.
        let behind = (DIRECTIONS * whole.arms.len()) as u32;
        for (p, &is_torn) in is_torn.iter().enumerate() {
            let of = if is_torn { apart } else { whole };
            let range = of.sources_of(p);
            let moved = |&source: &u32| if is_torn && source >= whole.particles { source + behind } else { source };
            skin.sources.extend(of.sources[range.clone()].iter().map(moved));
            skin.weights.extend(&of.weights[range]);
            skin.starts.push(skin.sources.len() as u32);
        }
        let is_seen = |triangle: &&[u32; 3]| triangle.iter().all(|&v| is_torn[whole.point_of[v as usize] as usize]);
        let walls = whole.triangles[self.outer..].iter().filter(is_seen);
        let triangles: Vec<[u32; 3]> = whole.triangles[..self.outer].iter().chain(walls).copied().collect();
        skin.shading = Shading::new(&skin.point_of, &self.normals, &triangles);
        skin.triangles = triangles.into();
        skin.rig = OnceLock::new();
        skin
    }
}

impl Skin {
    /// Whether a point hangs on the same particles by the same weights as that of `other`, and on no arm.
    pub(crate) fn hangs_alike(&self, other: &Self, point: usize) -> bool {
        let [own, others] =
            [self, other].map(|of| (&of.sources[of.sources_of(point)], &of.weights[of.sources_of(point)]));
        own == others && own.0.iter().all(|&source| source < self.particles)
    }

    /// Where the sources of a point stand.
    fn sources_of(&self, point: usize) -> Range<usize> {
        self.starts[point] as usize..self.starts[point + 1] as usize
    }
}
