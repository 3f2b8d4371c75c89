//! The surface by which a fibre solid meets others: that of balls around its outer particles, swept along the faces
//! between them.
//!
//! A ball is as large as its particle lies deep below the skin at rest, so that the swept surface is the skin as far as
//! particles can tell: flat where that is flat, round where it is round. It hangs on particles alone, by weights that
//! never reach outwards: a face is where its corners are.

use crate::geometry::lattice_hull::LatticeHull;

/// How a fibre solid shows to others.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct ContactSurface {
    /// Outer particles, in ascending order.
    pub(super) outer: Vec<u32>,
    /// Faces between them, counter-clockwise seen from outside.
    pub(super) faces: Vec<[u32; 3]>,
    /// Radius of the ball around every particle of the body [m]; zero of inner ones.
    pub(super) radii: Vec<f64>,
    /// The largest of them [m].
    pub(super) largest: f64,
    /// Those that turn with each outer particle, itself included: of the k-th, `starts[k]..starts[k + 1]` of `around`.
    starts: Vec<u32>,
    around: Vec<u32>,
}

/// Radius of a ball over its distance from another, by which it is larger at most: its surface shall be seen.
const STEEPEST: f64 = 0.6;

impl ContactSurface {
    /// Of a body whose outer particles have balls of these radii [m] and lie this far from each other, by `distance`
    /// [m]; `around` lists those that turn with each.
    pub(crate) fn new(
        count: usize,
        hull: LatticeHull,
        mut radii_of_outer: Vec<f64>,
        distance: impl Fn(u32, u32) -> f64,
        around: &[Vec<u32>],
    ) -> Self {
        let LatticeHull { outer, faces } = hull;
        let mut radii = vec![0.0; count];
        for (&i, radius) in outer.iter().zip(&mut radii_of_outer) {
            radii[i as usize] = *radius;
        }
        let edges = || faces.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
        // From ball to ball: what is cut down may have to cut down others.
        for _ in 0..3 {
            for [a, b] in edges() {
                let most = STEEPEST * distance(a, b);
                for [one, other] in [[a, b], [b, a]] {
                    radii[one as usize] = radii[one as usize].min(radii[other as usize] + most);
                }
            }
        }
        let largest = radii.iter().copied().fold(0.0, f64::max);
        let mut starts = vec![0];
        starts.extend(around.iter().scan(0, |end, list| {
            *end += list.len() as u32;
            Some(*end)
        }));
        Self { outer, faces, radii, largest, starts, around: around.concat() }
    }

    /// Particles that turn with an outer one, itself included; none of any other.
    pub(super) fn around(&self, particle: u32) -> &[u32] {
        let Ok(k) = self.outer.binary_search(&particle) else { return &[] };
        &self.around[self.starts[k] as usize..self.starts[k + 1] as usize]
    }

    /// Memory that it takes [bytes].
    pub(super) fn bytes(&self) -> usize {
        size_of_val(&*self.outer)
            + size_of_val(&*self.faces)
            + size_of_val(&*self.radii)
            + size_of_val(&*self.starts)
            + size_of_val(&*self.around)
    }
}
