//! What drawing takes on one device, whatever is drawn: pipelines, samplers and buffers. The work itself is done by
//! picture_pass.rs, shadow_pass.rs and pick.rs.

use super::pipelines::{Layouts, Pipelines};
use super::shadow::Caster;
use super::skinning::Skinning;
use super::targets::{COLOUR_FORMAT, DEPTH_FORMAT, SHADE_FORMAT, target};
use super::uniforms::FrameUniforms;
use bytemuck::Pod;

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
    /// What an adapter does with ease: a software driver neither multi-samples nor draws fine shadows, and what it
    /// computes the processor does faster without it.
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
    pub(super) heights: [wgpu::TextureView; 2],
    pub(super) casters: [wgpu::Buffer; 2],
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

    pub(super) fn shade_target(&self) -> wgpu::TextureView {
        let usage = wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::TEXTURE_BINDING;
        target(&self.device, "shade", [self.options.shadow_texels; 2], 1, SHADE_FORMAT, usage)
            .create_view(&wgpu::TextureViewDescriptor::default())
    }

    pub(super) fn frame_buffer(&self) -> wgpu::Buffer {
        uniform::<FrameUniforms>(&self.device, "frame")
    }

    pub(super) fn frame_group(&self, frame: &wgpu::Buffer, shade: &wgpu::TextureView) -> wgpu::BindGroup {
        self.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("frame"),
            layout: &self.layouts.frame,
            entries: &[
                wgpu::BindGroupEntry { binding: 0, resource: frame.as_entire_binding() },
                wgpu::BindGroupEntry { binding: 1, resource: wgpu::BindingResource::TextureView(shade) },
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
