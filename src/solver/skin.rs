//! The surface that is drawn: it rides on the material particles, embedded once at rest.
//!
//! Weights are those of [`super::skin_weights`]: the skin lies where it was modelled and follows every affine motion of
//! the particles exactly, as far as they span space beside its distance; what lies further out turns with them, as on
//! an arm. The absolute weights of a vertex sum to at most [`Skin::GREATEST_SUM`]: it moves by no more than so many
//! times the greatest displacement of a particle, and by the turn of its arm. Lists are flat: 50 000 vertices are moved
//! in a few milliseconds.

mod parted;

pub(crate) use parted::PartedSkin;
pub(super) use parted::TornSkin;

use super::embedding::EmbeddingWeights;
use super::forces::FlowSurface;
use super::skin_arms::{Arms, DIRECTIONS};
use super::skin_weights::{Carried, FARTHEST, SkinEmbedder};
use crate::geometry::clip::DrawnSurface;
use crate::geometry::hollows::Hollows;
use crate::geometry::kernel::Kernel;
use crate::geometry::linear_map::LinearMap;
use crate::geometry::rig::{Rig, Shading};
use crate::geometry::solid::Solid;
use crate::geometry::subdivide::rounded;
use glam::{DVec3, Vec3};
use rayon::prelude::*;
use std::borrow::Cow;
use std::convert::Infallible;
use std::sync::{Arc, OnceLock};

/// A render surface that rides on the particles.
#[derive(Clone, Debug, Default)]
pub struct Skin {
    /// Sources and weights of every point: those of point `p` are `starts[p]..starts[p + 1]`. A source is a particle
    /// or, behind the `particles` of them, a direction of an arm.
    starts: Vec<u32>,
    sources: Vec<u32>,
    weights: Vec<f64>,
    /// Number of particles.
    particles: u32,
    arms: Arms,
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

impl<'a> SkinShape<'a> {
    /// The surface of a solid as its model has it.
    pub fn of(solid: &'a Solid) -> Self {
        Self {
            points: &solid.surface.points,
            point_of: &solid.surface.point_of,
            normals: &solid.model.normals,
            colours: &solid.model.colours,
            triangles: &solid.model.triangles,
        }
    }

    /// A surface as it was made to be drawn.
    pub(crate) fn of_drawn(surface: &'a DrawnSurface) -> Self {
        let DrawnSurface { points, point_of, normals, colours, triangles } = surface;
        Self { points, point_of, normals, colours, triangles }
    }
}

/// Points embedded before it is said how far the work has come.
const CHUNK: usize = 16_384;

impl Skin {
    /// Greatest sum of the absolute weights of a vertex's particles.
    pub const GREATEST_SUM: f64 = 1.0 + FARTHEST;

    /// Embeds a surface in particles (rest, model frame). None only where there are no particles. `progress` hears how
    /// many points of how many are done.
    pub fn embed(
        shape: &SkinShape<'_>,
        particles: &[DVec3],
        kernel: Kernel,
        progress: &mut dyn FnMut(usize, usize),
    ) -> Option<Self> {
        let never = Self::try_embed::<Infallible>(shape, particles, kernel, &Hollows::default(), &mut |done, of| {
            progress(done, of);
            Ok(())
        });
        never.unwrap_or_else(|never| match never {})
    }

    /// [`Self::embed`], where nothing hangs on particles across a hollow, and an error of `progress` ends it.
    ///
    /// # Errors
    /// That of `progress`.
    pub(crate) fn try_embed<E>(
        shape: &SkinShape<'_>,
        particles: &[DVec3],
        kernel: Kernel,
        hollows: &Hollows,
        progress: &mut dyn FnMut(usize, usize) -> Result<(), E>,
    ) -> Result<Option<Self>, E> {
        let Some(embedder) = SkinEmbedder::new(particles, kernel, hollows) else { return Ok(None) };
        let mut skin = Self {
            starts: vec![0],
            particles: particles.len() as u32,
            arms: Arms::new(embedder.whole()),
            point_of: shape.point_of.to_vec(),
            shading: Shading::new(shape.point_of, shape.normals, shape.triangles),
            triangles: shape.triangles.into(),
            colours: shape.colours.into(),
            ..Self::default()
        };
        let mut done = 0;
        for chunk in shape.points.chunks(CHUNK) {
            let found: Vec<Carried> = chunk.par_iter().map(|&at| embedder.carried(at)).collect();
            for carried in found {
                skin.push(carried);
            }
            done += chunk.len();
            progress(done, shape.points.len())?;
        }
        Ok(Some(skin))
    }

    fn push(&mut self, point: Carried) {
        for (particle, weight) in point.weights {
            self.sources.push(particle);
            self.weights.push(weight);
        }
        if let Some(arm) = point.arm {
            let first = self.particles as usize + DIRECTIONS * self.arms.push(&arm);
            for (axis, part) in arm.offset.to_array().into_iter().enumerate() {
                self.sources.push((first + axis) as u32);
                self.weights.push(part);
            }
        }
        self.starts.push(self.sources.len() as u32);
    }

    /// A surface whose points are the first particles themselves, in their order.
    pub fn of_particles(shape: &SkinShape<'_>) -> Self {
        let count = shape.points.len() as u32;
        Self {
            starts: (0..=count).collect(),
            sources: (0..count).collect(),
            weights: vec![1.0; count as usize],
            particles: count,
            arms: Arms::default(),
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
            + size_of_val(&*self.sources)
            + size_of_val(&*self.weights)
            + size_of_val(&*self.point_of)
            + size_of_val(&*self.triangles)
            + size_of_val(&*self.colours);
        2 * lists + self.arms.bytes()
    }

    /// Number of vertices.
    pub fn len(&self) -> usize {
        self.point_of.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.point_of.is_empty()
    }

    /// Particles and weights of one vertex; none if there is no such vertex. Of one that hangs on an arm they are those
    /// of the place where that begins.
    pub fn weights(&self, vertex: usize) -> Option<EmbeddingWeights> {
        let p = *self.point_of.get(vertex)? as usize;
        let range = self.starts[p] as usize..self.starts[p + 1] as usize;
        let all = self.sources[range.clone()].iter().copied().zip(self.weights[range].iter().copied());
        Some(EmbeddingWeights { weights: all.filter(|&(source, _)| source < self.particles).collect() })
    }

    /// The surface as a flow sees it; its arms count as the places where they begin.
    pub(crate) fn flow_surface(&self) -> FlowSurface {
        let vertices = (0..self.len()).map(|vertex| self.weights(vertex).unwrap_or_default()).collect();
        FlowSurface { vertices, triangles: Arc::clone(&self.triangles) }
    }

    /// The arm on which a vertex hangs over particles at `positions` [m]: from where its weights put it to where it is.
    /// Zero for one that they carry by themselves.
    pub(super) fn arm(&self, vertex: usize, positions: &[DVec3]) -> DVec3 {
        let Some(&p) = self.point_of.get(vertex) else { return DVec3::ZERO };
        let range = self.starts[p as usize] as usize..self.starts[p as usize + 1] as usize;
        let parts = self.sources[range.clone()].iter().zip(&self.weights[range]);
        let parts: Vec<(u32, f64)> =
            parts.filter(|(source, _)| **source >= self.particles).map(|(s, w)| (*s, *w)).collect();
        let Some(&(first, _)) = parts.first() else { return DVec3::ZERO };
        let axes = self.arms.axes((first - self.particles) as usize / DIRECTIONS, positions);
        parts.iter().zip(axes).map(|((_, part), axis)| *part * axis).sum()
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
                sources: self.sources.clone(),
                weights: self.weights.iter().map(|&weight| weight as f32).collect(),
            };
            // Rounding knows no seams: it goes by points.
            let by_points: Vec<[u32; 3]> =
                self.triangles.iter().map(|triangle| triangle.map(|vertex| self.point_of[vertex as usize])).collect();
            let rig = match rounded(points.len(), &by_points) {
                Some((vertices, triangles)) => {
                    let each: Vec<u32> = (0..vertices.len() as u32).collect();
                    let shading = Shading::new(&each, &[], &triangles);
                    Rig::new(points, vertices, triangles, &shading)
                }
                None => Rig::new(points, LinearMap::gather(&self.point_of), self.triangles.to_vec(), &self.shading),
            };
            Arc::new(Rig { directions: DIRECTIONS * self.arms.len(), ..rig })
        })
    }

    /// The directions of its arms over particles at `positions` [m]; what is drawn of it hangs on the particles and
    /// these behind them.
    pub(super) fn directions(&self, positions: &[DVec3]) -> Vec<DVec3> {
        self.arms.directions(positions)
    }

    /// What the points are sums of, over particles at `positions` [m].
    fn sources<'a>(&self, positions: &'a [DVec3]) -> Cow<'a, [DVec3]> {
        match self.directions(positions) {
            directions if directions.is_empty() => Cow::Borrowed(positions),
            directions => Cow::Owned([positions, &directions].concat()),
        }
    }

    /// Positions of the vertices over particles at `positions` [m].
    pub fn positions(&self, positions: &[DVec3]) -> Vec<DVec3> {
        let sources = self.sources(positions);
        let points: Vec<DVec3> = (0..self.starts.len() - 1)
            .into_par_iter()
            .with_min_len(256)
            .map(|p| {
                let range = self.starts[p] as usize..self.starts[p + 1] as usize;
                let mut sum = DVec3::ZERO;
                for (&k, &weight) in self.sources[range.clone()].iter().zip(&self.weights[range]) {
                    sum += weight * sources[k as usize];
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
