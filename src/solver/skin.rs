//! The surface that is drawn: it rides on the material particles, embedded once at rest.
//!
//! Weights are those of [`super::embedding`]: they reproduce linear fields, so the skin lies where it was modelled and
//! follows every affine motion of the particles exactly. Lists are flat: 50 000 vertices are moved in a few
//! milliseconds.

use super::embedding::{Embedder, EmbeddingWeights};
use crate::geometry::kernel::Kernel;
use crate::geometry::linear_map::LinearMap;
use crate::geometry::rig::{Rig, Shading};
use crate::geometry::subdivide::rounded;
use glam::{DVec3, Vec3};
use rayon::prelude::*;
use std::sync::{Arc, OnceLock};

/// A render surface that rides on the particles.
#[derive(Clone, Debug, Default)]
pub struct Skin {
    /// Particles and weights of every point: those of point `p` are `starts[p]..starts[p + 1]`.
    starts: Vec<u32>,
    particles: Vec<u32>,
    weights: Vec<f64>,
    /// Point of every vertex; vertices split for the picture share one.
    point_of: Vec<u32>,
    /// Which vertices share a normal, and the faces that it is the mean of.
    shading: Shading,
    triangles: Arc<[[u32; 3]]>,
    colours: Arc<[[f32; 4]]>,
    /// Made when the first picture asks for it.
    rig: OnceLock<Arc<Rig>>,
}

/// What a skin is made from.
#[derive(Clone, Copy, Debug)]
pub struct SkinShape<'a> {
    /// Different positions of the vertices at rest, model frame [m].
    pub points: &'a [DVec3],
    /// Point of every vertex.
    pub point_of: &'a [u32],
    /// A normal a vertex, which tells where the surface is smooth and where it has an edge; none at all for a surface
    /// smooth everywhere.
    pub normals: &'a [Vec3],
    /// Linear red, green, blue and opacity a vertex, or none at all.
    pub colours: &'a [[f32; 4]],
    /// Vertex indices of the faces.
    pub triangles: &'a [[u32; 3]],
}

/// How far outside the particles a point may lie: its weights' sum of squares. Beyond it, and where the particles in
/// reach do not span space, a larger support radius is tried.
const WILD: f64 = 6.0;

/// Growth of the support radius from try to try, and number of tries.
const GROWTH: f64 = 1.5;
const TRIES: usize = 8;

/// Points embedded before it is said how far the work has come.
const CHUNK: usize = 16_384;

impl Skin {
    /// Embeds a surface in particles (rest, model frame). None only where the particles themselves do not span space.
    /// `progress` hears how many points of how many are done.
    pub fn embed(
        shape: &SkinShape<'_>,
        particles: &[DVec3],
        kernel: Kernel,
        progress: &mut dyn FnMut(usize, usize),
    ) -> Option<Self> {
        let mut radius = kernel.support_radius;
        let mut embedders = vec![Embedder::new(particles, kernel)];
        let mut skin = Self {
            starts: vec![0],
            point_of: shape.point_of.to_vec(),
            shading: Shading::new(shape.point_of, shape.normals, shape.triangles),
            triangles: shape.triangles.into(),
            colours: shape.colours.into(),
            ..Self::default()
        };
        let mut done = 0;
        for chunk in shape.points.chunks(CHUNK) {
            let tame = |weights: &EmbeddingWeights| weights.square_sum() <= WILD;
            let first = &embedders[0];
            let mut found: Vec<Option<EmbeddingWeights>> = chunk.par_iter().map(|&at| first.weights(at)).collect();
            for (&at, weights) in chunk.iter().zip(&mut found) {
                let mut wider = 1;
                while !weights.as_ref().is_some_and(tame) && wider <= TRIES {
                    if embedders.len() == wider {
                        radius *= GROWTH;
                        embedders.push(Embedder::new(particles, Kernel::new(radius)));
                    }
                    let other = embedders[wider].weights(at);
                    let calmer = |a: &EmbeddingWeights, b: &EmbeddingWeights| a.square_sum() < b.square_sum();
                    if let Some(other) = other
                        && weights.as_ref().is_none_or(|one| calmer(&other, one))
                    {
                        *weights = Some(other);
                    }
                    wider += 1;
                }
            }
            for weights in found {
                for (particle, weight) in weights?.weights {
                    skin.particles.push(particle);
                    skin.weights.push(weight);
                }
                skin.starts.push(skin.particles.len() as u32);
            }
            done += chunk.len();
            progress(done, shape.points.len());
        }
        Some(skin)
    }

    /// A surface whose points are the first particles themselves, in their order.
    pub fn of_particles(shape: &SkinShape<'_>) -> Self {
        let count = shape.points.len() as u32;
        Self {
            starts: (0..=count).collect(),
            particles: (0..count).collect(),
            weights: vec![1.0; count as usize],
            point_of: shape.point_of.to_vec(),
            shading: Shading::new(shape.point_of, shape.normals, shape.triangles),
            triangles: shape.triangles.into(),
            colours: shape.colours.into(),
            rig: OnceLock::new(),
        }
    }

    /// Memory that it takes [bytes], about: the surface of pictures, the same again, is counted before it is made.
    pub(super) fn bytes(&self) -> usize {
        let lists = size_of_val(&*self.starts)
            + size_of_val(&*self.particles)
            + size_of_val(&*self.weights)
            + size_of_val(&*self.point_of)
            + size_of_val(&*self.triangles)
            + size_of_val(&*self.colours);
        2 * lists
    }

    /// Number of vertices.
    pub fn len(&self) -> usize {
        self.point_of.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.point_of.is_empty()
    }

    /// Particles and weights of one vertex; none if there is no such vertex.
    pub fn weights(&self, vertex: usize) -> Option<EmbeddingWeights> {
        let p = *self.point_of.get(vertex)? as usize;
        let range = self.starts[p] as usize..self.starts[p + 1] as usize;
        let weights = self.particles[range.clone()].iter().copied().zip(self.weights[range].iter().copied()).collect();
        Some(EmbeddingWeights { weights })
    }

    /// Vertex indices of the faces.
    pub fn triangles(&self) -> &Arc<[[u32; 3]]> {
        &self.triangles
    }

    /// Linear red, green, blue and opacity a vertex; empty where the model had none.
    pub fn colours(&self) -> &Arc<[[f32; 4]]> {
        &self.colours
    }

    /// The surface that pictures show: rounder than the skin where that is coarse.
    pub fn rig(&self) -> &Arc<Rig> {
        self.rig.get_or_init(|| {
            let points = LinearMap {
                starts: self.starts.clone(),
                sources: self.particles.clone(),
                weights: self.weights.iter().map(|&weight| weight as f32).collect(),
            };
            // Rounding knows no seams: it goes by points.
            let by_points: Vec<[u32; 3]> =
                self.triangles.iter().map(|triangle| triangle.map(|vertex| self.point_of[vertex as usize])).collect();
            Arc::new(match rounded(points.len(), &by_points) {
                Some((vertices, triangles)) => {
                    let each: Vec<u32> = (0..vertices.len() as u32).collect();
                    let shading = Shading::new(&each, &[], &triangles);
                    Rig::new(points, vertices, triangles, &shading)
                }
                None => Rig::new(points, LinearMap::gather(&self.point_of), self.triangles.to_vec(), &self.shading),
            })
        })
    }

    /// Positions of the vertices over particles at `positions` [m].
    pub fn positions(&self, positions: &[DVec3]) -> Vec<DVec3> {
        let points: Vec<DVec3> = (0..self.starts.len() - 1)
            .into_par_iter()
            .with_min_len(256)
            .map(|p| {
                let range = self.starts[p] as usize..self.starts[p + 1] as usize;
                let mut sum = DVec3::ZERO;
                for (&k, &weight) in self.particles[range.clone()].iter().zip(&self.weights[range]) {
                    sum += weight * positions[k as usize];
                }
                sum
            })
            .collect();
        self.point_of.iter().map(|&p| points[p as usize]).collect()
    }

    /// Unit normals of vertices at `vertices` [m]: means of the faces around them, by area.
    pub fn normals(&self, vertices: &[DVec3]) -> Vec<Vec3> {
        self.shading.normals(&self.triangles, vertices)
    }
}
