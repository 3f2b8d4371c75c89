//! The targets of one view.

use super::renderer::Renderer;
use super::store::Store;
use super::targets::{COLOUR_FORMAT, DEPTH_FORMAT, depth_attachment, target};

/// The targets of one view: as large as the picture, made anew when its size changes.
pub struct Viewport {
    size: [u32; 2],
    pixels_per_point: f32,
    samples: u32,
    largest: u32,
    colour: wgpu::Texture,
    colour_view: wgpu::TextureView,
    multisampled: Option<wgpu::TextureView>,
    depth_view: wgpu::TextureView,
    pub(super) frame: wgpu::Buffer,
    pub(super) marks: Store,
}

impl Viewport {
    /// Targets of `size` [pixels] for a renderer's pictures, on a display with so many pixels a point.
    pub fn new(renderer: &Renderer, size: [u32; 2], pixels_per_point: f32) -> Self {
        let device = renderer.device();
        let (samples, largest) = (renderer.samples(), device.limits().max_texture_dimension_2d);
        let size = fitting(size, largest);
        let (colour, multisampled, depth_view) = targets(device, size, samples);
        Self {
            size,
            pixels_per_point,
            samples,
            largest,
            colour_view: colour.create_view(&wgpu::TextureViewDescriptor::default()),
            colour,
            multisampled,
            depth_view,
            frame: renderer.frame_buffer(),
            marks: Store::new(device, "marks", wgpu::BufferUsages::VERTEX),
        }
    }

    /// Changes the size [pixels]; gives whether the targets are new, so that whoever shows [`Self::colour`] must look
    /// again.
    pub fn resize(&mut self, renderer: &Renderer, size: [u32; 2], pixels_per_point: f32) -> bool {
        self.pixels_per_point = pixels_per_point;
        let size = fitting(size, self.largest);
        if size == self.size {
            return false;
        }
        self.size = size;
        let (colour, multisampled, depth_view) = targets(renderer.device(), size, self.samples);
        self.colour_view = colour.create_view(&wgpu::TextureViewDescriptor::default());
        (self.colour, self.multisampled, self.depth_view) = (colour, multisampled, depth_view);
        true
    }

    /// Width and height [pixels].
    pub fn size(&self) -> [u32; 2] {
        self.size
    }

    /// Pixels a point: 1 on most displays, 2 on fine ones. Line widths count in points.
    pub fn pixels_per_point(&self) -> f32 {
        self.pixels_per_point
    }

    /// The picture, resolved: sRGB-encoded in a plain format, opaque.
    pub fn colour(&self) -> &wgpu::TextureView {
        &self.colour_view
    }

    /// The texture of the picture.
    pub fn colour_texture(&self) -> &wgpu::Texture {
        &self.colour
    }

    pub(super) fn colour_attachment(&self) -> wgpu::RenderPassColorAttachment<'_> {
        let (view, resolve_target) = match &self.multisampled {
            Some(view) => (view, Some(&self.colour_view)),
            None => (&self.colour_view, None),
        };
        let store = if resolve_target.is_some() { wgpu::StoreOp::Discard } else { wgpu::StoreOp::Store };
        wgpu::RenderPassColorAttachment {
            view,
            depth_slice: None,
            resolve_target,
            ops: wgpu::Operations { load: wgpu::LoadOp::Clear(wgpu::Color::BLACK), store },
        }
    }

    pub(super) fn depth_attachment(&self) -> wgpu::RenderPassDepthStencilAttachment<'_> {
        depth_attachment(&self.depth_view, 0.0, wgpu::StoreOp::Discard)
    }
}

/// A size that the device can draw.
fn fitting(size: [u32; 2], largest: u32) -> [u32; 2] {
    size.map(|extent| extent.clamp(1, largest))
}

fn targets(
    device: &wgpu::Device,
    size: [u32; 2],
    samples: u32,
) -> (wgpu::Texture, Option<wgpu::TextureView>, wgpu::TextureView) {
    let drawn = wgpu::TextureUsages::RENDER_ATTACHMENT;
    let kept = drawn | wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_SRC;
    let view = |texture: wgpu::Texture| texture.create_view(&wgpu::TextureViewDescriptor::default());
    let colour = target(device, "colour", size, 1, COLOUR_FORMAT, kept);
    let multisampled =
        (samples > 1).then(|| view(target(device, "colour samples", size, samples, COLOUR_FORMAT, drawn)));
    let depth = view(target(device, "depth", size, samples, DEPTH_FORMAT, drawn));
    (colour, multisampled, depth)
}
