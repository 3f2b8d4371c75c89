//! A draw list on the device.

use super::renderer::Renderer;
use super::shadow::Caster;
use super::skinning::GpuSkin;
use super::store::Store;
use crate::draw::{DrawList, Ground, SurfaceStyle, Theme};
use glam::DVec3;
use std::ops::Range;

/// A draw list on the device, with the shadow that it casts.
pub struct Content {
    pub(super) list: DrawList,
    pub(super) vertices: Store,
    pub(super) indices: Store,
    pub(super) items: Store,
    /// Colours of vertices: of those in the common buffers, then of each skin that has some, then as many as the
    /// largest skin has vertices that say nothing.
    pub(super) tints: Store,
    pub(super) points: Store,
    pub(super) segments: Store,
    pub(super) meshes: Vec<MeshDraw>,
    /// Skins that the graphics processor moves.
    pub(super) skins: Vec<GpuSkin>,
    pub(super) casters: Option<[Caster; 2]>,
    /// Light that is hidden on the floor.
    pub(super) shade: wgpu::TextureView,
}

/// A mesh in the buffers.
pub(super) struct MeshDraw {
    /// Which of [`Content::skins`] it is; none for a mesh in the common buffers.
    pub(super) skin: Option<usize>,
    /// Row of its first vertex's colour.
    pub(super) tints: u32,
    pub(super) indices: Range<u32>,
    pub(super) surface: SurfaceStyle,
    pub(super) casts_shadow: bool,
    pub(super) picked: bool,
    /// Whether it is cut open.
    pub(super) cut: bool,
}

impl Content {
    /// Nothing yet, for a renderer.
    pub fn new(renderer: &Renderer) -> Self {
        let device = renderer.device();
        let ground = Ground { height: 0.0, solid: false, grid: true, axes: true };
        let shade = renderer.shade_target();
        Self {
            list: DrawList::new(DVec3::ZERO, ground, Theme::light()),
            vertices: Store::new(device, "mesh vertices", wgpu::BufferUsages::VERTEX),
            indices: Store::new(device, "mesh indices", wgpu::BufferUsages::INDEX),
            items: Store::new(device, "meshes", wgpu::BufferUsages::VERTEX),
            tints: Store::new(device, "colours of vertices", wgpu::BufferUsages::VERTEX),
            points: Store::new(device, "points", wgpu::BufferUsages::VERTEX),
            segments: Store::new(device, "segments", wgpu::BufferUsages::VERTEX),
            meshes: Vec::new(),
            skins: Vec::new(),
            casters: None,
            shade,
        }
    }

    /// Buffers of a mesh's vertices and indices.
    pub(super) fn buffers(&self, mesh: &MeshDraw) -> [&wgpu::Buffer; 2] {
        match mesh.skin.and_then(|skin| self.skins.get(skin)) {
            Some(skin) => [&skin.vertices, &skin.indices],
            None => [&self.vertices.buffer, &self.indices.buffer],
        }
    }

    /// The list as it was sent.
    pub fn list(&self) -> &DrawList {
        &self.list
    }
}
