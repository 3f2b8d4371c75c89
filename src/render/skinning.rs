//! Skins that the graphics processor moves: what never changes of one lies in its memory, and only particles go there
//! for each picture.

use super::encoding::VERTEX_WORDS;
use super::shaders;
use crate::draw::SkinnedFaces;
use crate::geometry::linear_map::LinearMap;
use crate::geometry::rig::Rig;
use glam::Vec3;
use std::sync::Arc;
use wgpu::util::{BufferInitDescriptor, DeviceExt};

/// Threads of a group, as in skin.wgsl.
const GROUP: u32 = 64;
/// Storage buffers of a stage, as in skin.wgsl.
const BUFFERS: u32 = 4;
const WORD: u64 = 4;

/// The work itself.
pub(super) struct Skinning {
    layout: wgpu::BindGroupLayout,
    sum_points: wgpu::ComputePipeline,
    shade_vertices: wgpu::ComputePipeline,
}

impl Skinning {
    /// None where the device has no storage buffers to compute with: vertices are moved by the processor then.
    pub(super) fn new(device: &wgpu::Device) -> Option<Self> {
        let limits = device.limits();
        if limits.max_storage_buffers_per_shader_stage < BUFFERS || limits.max_compute_workgroups_per_dimension == 0 {
            return None;
        }
        let entry = |binding: u32| wgpu::BindGroupLayoutEntry {
            binding,
            visibility: wgpu::ShaderStages::COMPUTE,
            ty: wgpu::BindingType::Buffer {
                ty: wgpu::BufferBindingType::Storage { read_only: binding + 1 < BUFFERS },
                has_dynamic_offset: false,
                min_binding_size: None,
            },
            count: None,
        };
        let entries: Vec<_> = (0..BUFFERS).map(entry).collect();
        let layout = device
            .create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor { label: Some("skinning"), entries: &entries });
        let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some("skin"),
            source: wgpu::ShaderSource::Wgsl(shaders::SKIN.into()),
        });
        let pipeline_layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: Some("skinning"),
            bind_group_layouts: &[Some(&layout)],
            ..wgpu::PipelineLayoutDescriptor::default()
        });
        let pipeline = |entry_point| {
            device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
                label: Some(entry_point),
                layout: Some(&pipeline_layout),
                module: &module,
                entry_point: Some(entry_point),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                cache: None,
            })
        };
        let [sum_points, shade_vertices] = ["sum_points", "shade_vertices"].map(pipeline);
        Some(Self { layout, sum_points, shade_vertices })
    }

    fn group(&self, device: &wgpu::Device, buffers: [&wgpu::Buffer; BUFFERS as usize]) -> wgpu::BindGroup {
        let entries: Vec<_> = (0..)
            .zip(buffers)
            .map(|(binding, buffer)| wgpu::BindGroupEntry { binding, resource: buffer.as_entire_binding() })
            .collect();
        device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("skinning"),
            layout: &self.layout,
            entries: &entries,
        })
    }
}

/// A skin in the memory of the graphics processor.
pub(super) struct GpuSkin {
    rig: Arc<Rig>,
    particles: wgpu::Buffer,
    /// Vertices as the pipelines of meshes read them.
    pub(super) vertices: wgpu::Buffer,
    pub(super) indices: wgpu::Buffer,
    points_group: wgpu::BindGroup,
    vertices_group: wgpu::BindGroup,
    shade_group: wgpu::BindGroup,
}

impl GpuSkin {
    /// Sends all that never changes.
    pub(super) fn new(device: &wgpu::Device, skinning: &Skinning, faces: &SkinnedFaces) -> Self {
        let rig = Arc::clone(&faces.rig);
        let storage = wgpu::BufferUsages::STORAGE;
        let constant = |words: &[u32], usage| {
            device.create_buffer_init(&BufferInitDescriptor {
                label: Some("skin"),
                contents: bytemuck::cast_slice(words),
                usage,
            })
        };
        let variable = |words: usize, usage| {
            device.create_buffer(&wgpu::BufferDescriptor {
                label: Some("moved skin"),
                size: (words as u64).max(1) * WORD,
                usage,
                mapped_at_creation: false,
            })
        };
        let map = |map: &LinearMap| [constant(&map.starts, storage), constant(&terms(map), storage)];
        let [point_starts, point_terms] = map(&rig.points);
        let [vertex_starts, vertex_terms] = map(&rig.vertices);
        let corner_starts = constant(&rig.corner_starts, storage);
        let corners = constant(bytemuck::cast_slice(&rig.corners), storage);
        let particles = variable(3 * faces.particles.len(), storage | wgpu::BufferUsages::COPY_DST);
        let points = variable(3 * rig.points.len(), storage);
        let positions = variable(3 * rig.vertices.len(), storage);
        let vertices = variable(VERTEX_WORDS * rig.vertices.len(), storage | wgpu::BufferUsages::VERTEX);
        let indices = constant(bytemuck::cast_slice(&rig.triangles), wgpu::BufferUsages::INDEX);
        let group = |buffers| skinning.group(device, buffers);
        Self {
            points_group: group([&point_starts, &point_terms, &particles, &points]),
            vertices_group: group([&vertex_starts, &vertex_terms, &points, &positions]),
            shade_group: group([&corner_starts, &corners, &positions, &vertices]),
            rig,
            particles,
            vertices,
            indices,
        }
    }

    /// Whether this is the skin of these faces.
    pub(super) fn is_of(&self, faces: &SkinnedFaces) -> bool {
        Arc::ptr_eq(&self.rig, &faces.rig)
    }

    /// Number of indices.
    pub(super) fn index_count(&self) -> u32 {
        3 * self.rig.triangles.len() as u32
    }

    /// Records the way from particles to vertices.
    pub(super) fn deform(
        &self,
        queue: &wgpu::Queue,
        pass: &mut wgpu::ComputePass<'_>,
        skinning: &Skinning,
        faces: &SkinnedFaces,
    ) {
        let words: Vec<f32> = faces.particles.iter().flat_map(Vec3::to_array).collect();
        queue.write_buffer(&self.particles, 0, bytemuck::cast_slice(&words));
        let steps = [
            (&skinning.sum_points, &self.points_group, self.rig.points.len()),
            (&skinning.sum_points, &self.vertices_group, self.rig.vertices.len()),
            (&skinning.shade_vertices, &self.shade_group, self.rig.vertices.len()),
        ];
        for (pipeline, group, count) in steps {
            pass.set_pipeline(pipeline);
            pass.set_bind_group(0, group, &[]);
            pass.dispatch_workgroups((count as u32).div_ceil(GROUP), 1, 1);
        }
    }
}

/// Sources and weights side by side.
fn terms(map: &LinearMap) -> Vec<u32> {
    map.sources.iter().zip(&map.weights).flat_map(|(&source, weight)| [source, weight.to_bits()]).collect()
}
