//! A sheet at rest.

use super::hinge::{HingeRest, hinge_angle, hinge_curls, hinge_weight};
use super::membrane::{MembraneLaw, TriangleRest};
use crate::solver::drive::Drive;
use crate::solver::embedding::EmbeddingWeights;
use glam::{DVec2, DVec3};
use std::collections::BTreeMap;

/// What a sheet resists with, before its volume fraction is taken of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SheetLaw {
    /// Young's modulus times thickness Et [N/m].
    pub et: f64,
    /// Poisson's ratio in the surface.
    pub poisson_ratio: f64,
    /// Bending stiffness Db [N m].
    pub bending: f64,
    /// Et of the grain [N/m].
    pub grain: f64,
    /// Share `l_s` of it that counts.
    pub volume_fraction: f64,
}

/// What a drive does to a sheet.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct SheetDrive {
    /// What both shares are multiplied by.
    pub(crate) drive: Drive,
    /// Shares by which it wants to be shorter along its two directions.
    pub(crate) contract: DVec2,
    /// Curvatures that it wants to have along them [rad/m].
    pub(crate) curl: DVec2,
}

impl SheetDrive {
    /// Its size along both directions over the drawn one at a time [s].
    pub(super) fn metric(&self, time: f64) -> DVec2 {
        DVec2::ONE - self.contract * self.drive.at(time).0
    }

    /// Curvatures along both directions [rad/m] that it wants at a time [s].
    fn curvature(&self, time: f64) -> DVec2 {
        self.curl * self.drive.at(time).0
    }
}

/// A sheet at rest.
#[derive(Clone, Debug, PartialEq)]
pub struct SheetRest {
    /// How its vertices ride on the particles.
    pub vertices: Vec<EmbeddingWeights>,
    /// Its triangles.
    pub triangles: Vec<TriangleRest>,
    /// What they are made of.
    pub membrane: MembraneLaw,
    /// Its hinges; none where nothing bends it back.
    pub hinges: Vec<HingeRest>,
    pub(super) drive: Option<SheetDrive>,
}

impl SheetRest {
    /// A sheet of triangles between points at rest `x` [m], whose directions, along it and of its grain, are given for
    /// every triangle. `is_diagonal` says of two vertices whether the edge between them is a grid's diagonal. Triangles
    /// of no area carry nothing.
    pub fn new(
        vertices: Vec<EmbeddingWeights>,
        x: &[DVec3],
        triangles: &[([u32; 3], [DVec3; 2])],
        law: SheetLaw,
        is_diagonal: impl Fn(u32, u32) -> bool,
    ) -> Self {
        let SheetLaw { et, poisson_ratio: nu, bending, grain, volume_fraction: share } = law;
        let membrane = MembraneLaw {
            mu: share * et / (2.0 * (1.0 + nu)),
            lambda: share * nu * et / (1.0 - nu * nu),
            grain: share * grain,
        };
        let at = |k: u32| x[k as usize];
        let made: Vec<(TriangleRest, DVec3)> = triangles
            .iter()
            .filter_map(|&(corners, ways)| Some((TriangleRest::new(corners, corners.map(at), ways)?, ways[0])))
            .collect();
        let stiffness = share * bending;
        let hinges = if stiffness > 0.0 { hinges(&made, stiffness, at, is_diagonal) } else { Vec::new() };
        let triangles = made.into_iter().map(|(of, _)| of).collect();
        Self { vertices, triangles, membrane, hinges, drive: None }
    }

    /// The same sheet, at rest where it is flat.
    #[must_use]
    pub fn flattened(mut self) -> Self {
        self.hinges.iter_mut().for_each(|hinge| hinge.angle = 0.0);
        self
    }

    /// With a drive that acts on it.
    pub(crate) fn acting(self, drive: Option<SheetDrive>) -> Self {
        Self { drive, ..self }
    }

    /// A sheet that resists any move as much as this one does with its drive at its greatest or at its least.
    pub(super) fn at_extreme(&self, greatest: bool) -> Self {
        let still = |of: &SheetDrive| SheetDrive {
            drive: Drive::Constant(if greatest { of.drive.greatest() } else { of.drive.least() }),
            ..of.clone()
        };
        Self { drive: self.drive.as_ref().map(still), ..self.clone() }
    }

    /// Its size along both directions over the drawn one at a time [s].
    pub(super) fn metric(&self, time: f64) -> DVec2 {
        self.drive.as_ref().map_or(DVec2::ONE, |drive| drive.metric(time))
    }

    /// Curvatures along both directions [rad/m] that it wants beside those at rest, at a time [s].
    pub(super) fn curvature(&self, time: f64) -> DVec2 {
        self.drive.as_ref().map_or(DVec2::ZERO, |drive| drive.curvature(time))
    }

    /// Until when [s] it changes by itself.
    pub(super) fn changes_until(&self) -> f64 {
        self.drive.as_ref().map_or(0.0, |of| of.drive.until())
    }

    /// Places of its vertices [m].
    pub(super) fn places(&self, positions: &[DVec3]) -> Vec<DVec3> {
        self.vertices.iter().map(|vertex| vertex.gather(positions)).collect()
    }

    /// Stretching energy [J] of the sheet with its vertices at `x` [m].
    pub(super) fn membrane_energy(&self, x: &[DVec3], metric: DVec2) -> f64 {
        let energy = |of: &TriangleRest| of.energy(&self.membrane, of.vertices.map(|k| x[k as usize]), metric);
        self.triangles.iter().map(energy).sum()
    }

    /// Groups of particles that are tied to each other: those around every triangle, and around every hinge.
    pub(super) fn couplings(&self) -> impl Iterator<Item = Vec<u32>> + '_ {
        let around = |corners: &[u32]| {
            let weights = corners.iter().flat_map(|&k| &self.vertices[k as usize].weights);
            weights.map(|&(particle, _)| particle).collect()
        };
        let triangles = self.triangles.iter().map(move |of| around(&of.vertices));
        triangles.chain(self.hinges.iter().map(move |of| around(&of.vertices)))
    }
}

/// A hinge at every edge that two triangles share.
fn hinges(
    triangles: &[(TriangleRest, DVec3)],
    stiffness: f64,
    at: impl Fn(u32) -> DVec3,
    is_diagonal: impl Fn(u32, u32) -> bool,
) -> Vec<HingeRest> {
    // In the order of the vertices' numbers: sums over hinges must not depend on that of a hash.
    let mut edges: BTreeMap<[u32; 2], Vec<Side>> = BTreeMap::new();
    for (of, along) in triangles {
        let [a, b, c] = of.vertices;
        for (from, to, opposite) in [(a, b, c), (b, c, a), (c, a, b)] {
            edges.entry([from.min(to), from.max(to)]).or_default().push(Side {
                area: of.area,
                corners: [from, to, opposite],
                along: *along,
            });
        }
    }
    let hinge = |one: &Side, other: &Side| {
        let ([from, to, opposite], [.., beyond]) = (one.corners, other.corners);
        let vertices = [from, to, opposite, beyond];
        let x = vertices.map(&at);
        let weight = hinge_weight(at(from).distance(at(to)), [one.area, other.area], is_diagonal(from, to));
        // Directions say nothing of which way along them.
        let along = if one.along.dot(other.along) < 0.0 { one.along - other.along } else { one.along + other.along };
        HingeRest { vertices, stiffness: stiffness * weight, angle: hinge_angle(x), curl: hinge_curls(x, along) }
    };
    edges.into_values().filter_map(|sides| Some(hinge(sides.first()?, sides.get(1)?))).collect()
}

/// A triangle as seen from one of its edges.
struct Side {
    /// [m²]
    area: f64,
    /// Ends of the edge, and the vertex opposite.
    corners: [u32; 3],
    /// The sheet's first direction.
    along: DVec3,
}
