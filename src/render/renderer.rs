//! Draws content into viewports.

use super::camera::Camera;
use super::content::{Content, ITEM_WORDS, TINT_WORDS};
use super::marks;
use super::pipelines::{DEPTH_FORMAT, Layouts, Pipelines, SHADE_FORMAT, row_offset};
use super::shadow::Caster;
use super::skinning::Skinning;
use super::uniforms::FrameUniforms;
use super::viewport::{Viewport, depth_attachment, target};
use crate::draw::SurfaceStyle;
use bytemuck::{Pod, bytes_of};

/// Format of every picture: encoded as sRGB by the shaders, plain to whoever shows it.
pub const COLOUR_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;

/// What pictures cost.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Options {
    /// Samples a pixel: 1 or 4.
    pub samples: u32,
    /// Extent of a shadow [texels].
    pub shadow_texels: u32,
    /// Whether the graphics processor moves skins, where the device has storage buffers.
    pub gpu_skinning: bool,
}

impl Options {
    /// What an adapter does with ease: a software driver neither multi-samples nor draws fine shadows, and what it computes
    /// the processor does faster without it.
    pub fn for_adapter(adapter: &wgpu::Adapter) -> Self {
        let software = adapter.get_info().device_type == wgpu::DeviceType::Cpu;
        let best = Self::best_for_adapter(adapter);
        if software { Self { samples: 1, shadow_texels: 80, gpu_skinning: false } } else { best }
    }

    /// The best pictures that an adapter can draw at all, for files.
    pub fn best_for_adapter(adapter: &wgpu::Adapter) -> Self {
        let can = |format| adapter.get_texture_format_features(format).flags.sample_count_supported(4);
        let samples = if can(COLOUR_FORMAT) && can(DEPTH_FORMAT) { 4 } else { 1 };
        Self { samples, shadow_texels: 256, gpu_skinning: true }
    }
}

/// Draws content into viewports, on one device.
pub struct Renderer {
    device: wgpu::Device,
    queue: wgpu::Queue,
    options: Options,
    pub(super) layouts: Layouts,
    pub(super) pipelines: Pipelines,
    sampler: wgpu::Sampler,
    heights: [wgpu::TextureView; 2],
    casters: [wgpu::Buffer; 2],
    skinning: Option<Skinning>,
}

impl Renderer {
    /// A renderer on a device, which needs no feature beyond the least that there is.
    pub fn new(device: &wgpu::Device, queue: &wgpu::Queue, options: Options) -> Self {
        let layouts = Layouts::new(device);
        let pipelines = Pipelines::new(device, &layouts, COLOUR_FORMAT, options.samples);
        let sampler = device.create_sampler(&wgpu::SamplerDescriptor {
            label: Some("shadow"),
            mag_filter: wgpu::FilterMode::Linear,
            min_filter: wgpu::FilterMode::Linear,
            ..wgpu::SamplerDescriptor::default()
        });
        let usage = wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::TEXTURE_BINDING;
        let heights = ["heights along the light", "heights from above"].map(|label| {
            target(device, label, [options.shadow_texels; 2], 1, DEPTH_FORMAT, usage)
                .create_view(&wgpu::TextureViewDescriptor::default())
        });
        let casters = ["caster along the light", "caster from above"].map(|label| uniform::<Caster>(device, label));
        let (device, queue) = (device.clone(), queue.clone());
        let skinning = Skinning::new(&device).filter(|_| options.gpu_skinning);
        Self { device, queue, options, layouts, pipelines, sampler, heights, casters, skinning }
    }

    /// The device on which it draws.
    pub fn device(&self) -> &wgpu::Device {
        &self.device
    }

    /// Where it hands its work in.
    pub fn queue(&self) -> &wgpu::Queue {
        &self.queue
    }

    /// What moves skins on the graphics processor; none where the processor does.
    pub(super) fn skinning(&self) -> Option<&Skinning> {
        self.skinning.as_ref()
    }

    /// Whether the graphics processor moves the skins.
    pub fn skins_on_gpu(&self) -> bool {
        self.skinning.is_some()
    }

    /// Samples a pixel.
    pub fn samples(&self) -> u32 {
        self.options.samples
    }

    /// Draws content as a camera sees it. The work is recorded only: submit the encoder, then show or copy
    /// [`Viewport::colour`]. A viewport is drawn at most once a submission.
    pub fn draw(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        content: &Content,
        viewport: &mut Viewport,
        camera: &Camera,
    ) {
        let (size, scale) = (viewport.size(), viewport.pixels_per_point());
        let caster = content.casters.as_ref().map(|[along_key, _]| along_key);
        let frame = FrameUniforms::new(&content.list, caster, camera, size, scale, [1.0, 1.0, 0.0, 0.0]);
        self.queue.write_buffer(&viewport.frame, 0, bytes_of(&frame));
        marks::write(&mut viewport.marks, self, content.list(), camera, size, scale);
        let group = self.frame_group(&viewport.frame, content);
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("picture"),
            color_attachments: &[Some(viewport.colour_attachment())],
            depth_stencil_attachment: Some(viewport.depth_attachment()),
            ..wgpu::RenderPassDescriptor::default()
        });
        pass.set_bind_group(0, &group, &[]);
        let pipelines = &self.pipelines;
        pass.set_pipeline(&pipelines.background);
        pass.draw(0..3, 0..1);
        if frame.on_paper() || !frame.ground_in_front() {
            let ground = match (frame.on_paper(), content.list.ground.solid) {
                (true, _) => &pipelines.paper,
                (false, true) => &pipelines.floor,
                (false, false) => &pipelines.grid,
            };
            pass.set_pipeline(ground);
            pass.draw(0..4, 0..1);
        }
        meshes(&mut pass, &pipelines.solid, content, SurfaceStyle::Solid);
        draw_meshes(&mut pass, &pipelines.inside, content, |mesh| mesh.cut && mesh.surface == SurfaceStyle::Solid);
        instances(&mut pass, &pipelines.points, &content.points);
        meshes(&mut pass, &pipelines.x_ray_back, content, SurfaceStyle::XRay);
        meshes(&mut pass, &pipelines.x_ray_front, content, SurfaceStyle::XRay);
        meshes(&mut pass, &pipelines.faint, content, SurfaceStyle::Faint);
        if frame.ground_in_front() {
            pass.set_pipeline(&pipelines.grid);
            pass.draw(0..4, 0..1);
        }
        instances(&mut pass, &pipelines.lines_through, &content.segments);
        instances(&mut pass, &pipelines.lines, &content.segments);
        instances(&mut pass, &pipelines.points_through, &content.points);
        instances(&mut pass, &pipelines.lines, &viewport.marks);
    }

    /// Draws the shadow of content that was just sent.
    pub(super) fn draw_shadow(&self, content: &Content) {
        let Some(casters) = &content.casters else { return };
        let mut encoder = self.device.create_command_encoder(&wgpu::CommandEncoderDescriptor { label: Some("shadow") });
        for ((caster, buffer), heights) in casters.iter().zip(&self.casters).zip(&self.heights) {
            self.queue.write_buffer(buffer, 0, bytes_of(caster));
            let group = self.device.create_bind_group(&wgpu::BindGroupDescriptor {
                label: Some("caster"),
                layout: &self.layouts.caster,
                entries: &[wgpu::BindGroupEntry { binding: 0, resource: buffer.as_entire_binding() }],
            });
            let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
                label: Some("heights"),
                depth_stencil_attachment: Some(depth_attachment(heights, 1.0, wgpu::StoreOp::Store)),
                ..wgpu::RenderPassDescriptor::default()
            });
            pass.set_bind_group(0, &group, &[]);
            pass.set_pipeline(&self.pipelines.cast_mesh);
            for mesh in content.meshes.iter().filter(|mesh| mesh.casts_shadow) {
                let [vertices, indices] = content.buffers(mesh);
                pass.set_vertex_buffer(0, vertices.slice(..));
                pass.set_index_buffer(indices.slice(..), wgpu::IndexFormat::Uint32);
                pass.draw_indexed(mesh.indices.clone(), 0, 0..1);
            }
            instances(&mut pass, &self.pipelines.cast_points, &content.points);
        }
        let group = self.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("shade"),
            layout: &self.layouts.shade,
            entries: &[
                wgpu::BindGroupEntry { binding: 0, resource: self.casters[0].as_entire_binding() },
                wgpu::BindGroupEntry { binding: 1, resource: wgpu::BindingResource::TextureView(&self.heights[0]) },
                wgpu::BindGroupEntry { binding: 2, resource: wgpu::BindingResource::TextureView(&self.heights[1]) },
            ],
        });
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("shade"),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: &content.shade,
                depth_slice: None,
                resolve_target: None,
                ops: wgpu::Operations { load: wgpu::LoadOp::Clear(wgpu::Color::BLACK), store: wgpu::StoreOp::Store },
            })],
            ..wgpu::RenderPassDescriptor::default()
        });
        pass.set_bind_group(0, &group, &[]);
        pass.set_pipeline(&self.pipelines.shade);
        pass.draw(0..3, 0..1);
        drop(pass);
        self.queue.submit([encoder.finish()]);
    }

    pub(super) fn shade_target(&self) -> wgpu::TextureView {
        let usage = wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::TEXTURE_BINDING;
        target(&self.device, "shade", [self.options.shadow_texels; 2], 1, SHADE_FORMAT, usage)
            .create_view(&wgpu::TextureViewDescriptor::default())
    }

    pub(super) fn frame_buffer(&self) -> wgpu::Buffer {
        uniform::<FrameUniforms>(&self.device, "frame")
    }

    pub(super) fn frame_group(&self, frame: &wgpu::Buffer, content: &Content) -> wgpu::BindGroup {
        self.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("frame"),
            layout: &self.layouts.frame,
            entries: &[
                wgpu::BindGroupEntry { binding: 0, resource: frame.as_entire_binding() },
                wgpu::BindGroupEntry { binding: 1, resource: wgpu::BindingResource::TextureView(&content.shade) },
                wgpu::BindGroupEntry { binding: 2, resource: wgpu::BindingResource::Sampler(&self.sampler) },
            ],
        })
    }
}

fn uniform<T: Pod>(device: &wgpu::Device, label: &str) -> wgpu::Buffer {
    device.create_buffer(&wgpu::BufferDescriptor {
        label: Some(label),
        size: size_of::<T>() as u64,
        usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    })
}

/// Draws the meshes of one surface.
fn meshes(pass: &mut wgpu::RenderPass<'_>, pipeline: &wgpu::RenderPipeline, content: &Content, surface: SurfaceStyle) {
    draw_meshes(pass, pipeline, content, |mesh| mesh.surface == surface);
}

/// Draws the meshes that `which` chooses.
pub(super) fn draw_meshes(
    pass: &mut wgpu::RenderPass<'_>,
    pipeline: &wgpu::RenderPipeline,
    content: &Content,
    which: impl Fn(&super::content::MeshDraw) -> bool,
) {
    if !content.meshes.iter().any(&which) {
        return;
    }
    pass.set_pipeline(pipeline);
    for (item, mesh) in (0..).zip(&content.meshes).filter(|(_, mesh)| which(mesh)) {
        let [vertices, indices] = content.buffers(mesh);
        pass.set_vertex_buffer(0, vertices.slice(..));
        pass.set_index_buffer(indices.slice(..), wgpu::IndexFormat::Uint32);
        pass.set_vertex_buffer(1, content.items.buffer.slice(row_offset(item, ITEM_WORDS)..));
        pass.set_vertex_buffer(2, content.tints.buffer.slice(row_offset(mesh.tints, TINT_WORDS)..));
        pass.draw_indexed(mesh.indices.clone(), 0, 0..1);
    }
}

/// Draws a square for every row.
pub(super) fn instances(
    pass: &mut wgpu::RenderPass<'_>,
    pipeline: &wgpu::RenderPipeline,
    rows: &super::content::Store,
) {
    if rows.count > 0 {
        pass.set_pipeline(pipeline);
        pass.set_vertex_buffer(0, rows.buffer.slice(..));
        pass.draw(0..4, 0..rows.count);
    }
}
