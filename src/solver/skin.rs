//! The surface that is drawn: it rides on the material particles, embedded once at rest.
//!
//! Weights are those of [`super::embedding`]: they reproduce linear fields, so the skin lies where it was modelled and
//! follows every affine motion of the particles exactly. Lists are flat: 50 000 vertices are moved in a few
//! milliseconds.

use super::embedding::{Embedder, Stencil};
use crate::geometry::kernel::Kernel;
use glam::{DVec3, Vec3};
use rayon::prelude::*;
use std::sync::Arc;

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
            shading: Shading::new(shape),
            triangles: shape.triangles.into(),
            colours: shape.colours.into(),
            ..Self::default()
        };
        let mut done = 0;
        for chunk in shape.points.chunks(CHUNK) {
            let tame = |stencil: &Stencil| stencil.square_sum() <= WILD;
            let first = &embedders[0];
            let mut stencils: Vec<Option<Stencil>> = chunk.par_iter().map(|&at| first.stencil(at)).collect();
            for (&at, stencil) in chunk.iter().zip(&mut stencils) {
                let mut wider = 1;
                while !stencil.as_ref().is_some_and(tame) && wider <= TRIES {
                    if embedders.len() == wider {
                        radius *= GROWTH;
                        embedders.push(Embedder::new(particles, Kernel::new(radius)));
                    }
                    let other = embedders[wider].stencil(at);
                    let calmer = |a: &Stencil, b: &Stencil| a.square_sum() < b.square_sum();
                    if let Some(other) = other
                        && stencil.as_ref().is_none_or(|one| calmer(&other, one))
                    {
                        *stencil = Some(other);
                    }
                    wider += 1;
                }
            }
            for stencil in stencils {
                for (particle, weight) in stencil?.weights {
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
            shading: Shading::new(shape),
            triangles: shape.triangles.into(),
            colours: shape.colours.into(),
        }
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
    pub fn stencil(&self, vertex: usize) -> Option<Stencil> {
        let p = *self.point_of.get(vertex)? as usize;
        let range = self.starts[p] as usize..self.starts[p + 1] as usize;
        let weights = self.particles[range.clone()].iter().copied().zip(self.weights[range].iter().copied()).collect();
        Some(Stencil { weights })
    }

    /// Vertex indices of the faces.
    pub fn triangles(&self) -> &Arc<[[u32; 3]]> {
        &self.triangles
    }

    /// Linear red, green, blue and opacity a vertex; empty where the model had none.
    pub fn colours(&self) -> &Arc<[[f32; 4]]> {
        &self.colours
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

/// Vertices that share a normal: those at one point on the same side of every edge.
#[derive(Clone, Debug, Default)]
struct Shading {
    group_of: Vec<u32>,
    /// Faces around group `g`: `starts[g]..starts[g + 1]`.
    starts: Vec<u32>,
    faces: Vec<u32>,
}

/// Normals of a file that agree to this share of a unit belong together.
const SAME_NORMAL: f32 = 1e-3;

impl Shading {
    fn new(shape: &SkinShape<'_>) -> Self {
        let normal_of = |vertex: u32| {
            let normal = shape.normals.get(vertex as usize).copied().unwrap_or_default();
            (normal / SAME_NORMAL).round().as_ivec3().to_array()
        };
        let mut keys: Vec<(u32, [i32; 3], u32)> = shape
            .point_of
            .iter()
            .enumerate()
            .map(|(vertex, &point)| (point, normal_of(vertex as u32), vertex as u32))
            .collect();
        keys.par_sort_unstable();
        let mut group_of = vec![0; keys.len()];
        let mut count = 0;
        for (k, (point, normal, vertex)) in keys.iter().enumerate() {
            if k > 0 && (keys[k - 1].0, keys[k - 1].1) != (*point, *normal) {
                count += 1;
            }
            group_of[*vertex as usize] = count;
        }
        let groups = if keys.is_empty() { 0 } else { count as usize + 1 };
        let mut around: Vec<(u32, u32)> = shape
            .triangles
            .iter()
            .enumerate()
            .flat_map(|(face, t)| t.map(|vertex| (group_of[vertex as usize], face as u32)))
            .collect();
        around.par_sort_unstable();
        around.dedup();
        let mut starts = vec![0; groups + 1];
        for (group, _) in &around {
            starts[*group as usize + 1] += 1;
        }
        for group in 0..groups {
            starts[group + 1] += starts[group];
        }
        Self { group_of, starts, faces: around.into_iter().map(|(_, face)| face).collect() }
    }

    fn normals(&self, triangles: &[[u32; 3]], vertices: &[DVec3]) -> Vec<Vec3> {
        let areas: Vec<Vec3> = triangles
            .par_iter()
            .with_min_len(1024)
            .map(|t| {
                let [a, b, c] = t.map(|i| vertices[i as usize]);
                (b - a).cross(c - a).normalize_or_zero().as_vec3() * ((b - a).cross(c - a).length() as f32)
            })
            .collect();
        let normals: Vec<Vec3> = (0..self.starts.len().saturating_sub(1))
            .into_par_iter()
            .with_min_len(1024)
            .map(|group| {
                let faces = &self.faces[self.starts[group] as usize..self.starts[group + 1] as usize];
                // Areas of small faces vanish in single precision when squared.
                let sum: Vec3 = faces.iter().map(|&face| areas[face as usize]).sum();
                sum.as_dvec3().normalize_or(DVec3::Y).as_vec3()
            })
            .collect();
        self.group_of.iter().map(|&group| normals[group as usize]).collect()
    }
}
