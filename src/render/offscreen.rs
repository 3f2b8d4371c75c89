//! Pictures without a window.

use super::camera::Camera;
use super::content::Content;
use super::device::{NoDriver, open_device};
use super::renderer::{Options, Renderer};
use super::viewport::Viewport;
use crate::draw::DrawList;
use thiserror::Error;

const BYTES_PER_PIXEL: u32 = 4;

/// A picture that could not be made.
#[derive(Debug, Error)]
pub enum RenderError {
    /// There is no driver.
    #[error(transparent)]
    NoDriver(#[from] NoDriver),
    /// A picture larger than the device can draw.
    #[error("{width} x {height} pixels are more than this graphics driver draws; ask for at most {largest} each way")]
    TooLarge {
        /// Width asked for [pixels].
        width: u32,
        /// Height asked for [pixels].
        height: u32,
        /// Greatest extent [pixels].
        largest: u32,
    },
    /// The device gave up.
    #[error("the graphics driver stopped ({0}); try a smaller picture, or another driver")]
    Lost(String),
    /// The picture cannot be encoded.
    #[error("the picture cannot be encoded ({0})")]
    Encoding(#[from] png::EncodingError),
    /// The picture cannot be a part of a moving one.
    #[error("the picture cannot be encoded as GIF ({0})")]
    Gif(#[from] gif::EncodingError),
}

/// A picture: sRGB, opaque, rows from the top.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// Width and height [pixels].
    pub size: [u32; 2],
    /// Red, green, blue, alpha of each pixel.
    pub rgba: Vec<u8>,
}

/// A renderer with a device and one viewport of its own.
pub struct Offscreen {
    renderer: Renderer,
    content: Content,
    viewport: Viewport,
    software: bool,
}

impl Offscreen {
    /// For pictures of `size` [pixels], as good as the driver draws them at all.
    ///
    /// # Errors
    /// [`RenderError::NoDriver`] and [`RenderError::TooLarge`].
    pub fn new(size: [u32; 2]) -> Result<Self, RenderError> {
        Self::with(size, Options::best_for_adapter)
    }

    /// For pictures of `size` [pixels], with options chosen for the adapter.
    ///
    /// # Errors
    /// As [`Offscreen::new`].
    pub fn with(size: [u32; 2], options: impl FnOnce(&wgpu::Adapter) -> Options) -> Result<Self, RenderError> {
        let (adapter, device, queue) = open_device()?;
        let largest = device.limits().max_texture_dimension_2d;
        let [width, height] = size;
        if width > largest || height > largest {
            return Err(RenderError::TooLarge { width, height, largest });
        }
        let renderer = Renderer::new(&device, &queue, options(&adapter));
        let content = Content::new(&renderer);
        let viewport = Viewport::new(&renderer, size, 1.0);
        let software = adapter.get_info().device_type == wgpu::DeviceType::Cpu;
        Ok(Self { renderer, content, viewport, software })
    }

    /// Whether pictures are drawn in software.
    pub fn software(&self) -> bool {
        self.software
    }

    /// The renderer.
    pub fn renderer(&self) -> &Renderer {
        &self.renderer
    }

    /// What was drawn last.
    pub fn content(&self) -> &Content {
        &self.content
    }

    /// Where it was drawn.
    pub fn viewport(&self) -> &Viewport {
        &self.viewport
    }

    /// Draws a list as a camera sees it.
    ///
    /// # Errors
    /// [`RenderError::Lost`].
    pub fn draw(&mut self, list: DrawList, camera: &Camera) -> Result<Picture, RenderError> {
        self.content.send(&self.renderer, list);
        let device = self.renderer.device();
        let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor { label: Some("picture") });
        self.renderer.draw(&mut encoder, &self.content, &mut self.viewport, camera);
        self.renderer.queue().submit([encoder.finish()]);
        read_back(&self.renderer, &self.viewport)
    }
}

/// What was drawn into a viewport last.
///
/// # Errors
/// [`RenderError::Lost`].
pub(crate) fn read_back(renderer: &Renderer, viewport: &Viewport) -> Result<Picture, RenderError> {
    let device = renderer.device();
    let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor { label: Some("read back") });
    let [width, height] = viewport.size();
    let row = (width * BYTES_PER_PIXEL).next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT);
    let buffer = device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("picture read back"),
        size: u64::from(row) * u64::from(height),
        usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
        mapped_at_creation: false,
    });
    let texture = viewport.colour_texture();
    encoder.copy_texture_to_buffer(
        texture.as_image_copy(),
        wgpu::TexelCopyBufferInfo {
            buffer: &buffer,
            layout: wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(row), rows_per_image: None },
        },
        texture.size(),
    );
    renderer.queue().submit([encoder.finish()]);
    let (sender, mapped) = std::sync::mpsc::channel();
    buffer.slice(..).map_async(wgpu::MapMode::Read, move |result| drop(sender.send(result)));
    device.poll(wgpu::PollType::wait_indefinitely()).map_err(|error| RenderError::Lost(error.to_string()))?;
    match mapped.recv() {
        Ok(Ok(())) => {}
        Ok(Err(error)) => return Err(RenderError::Lost(error.to_string())),
        Err(error) => return Err(RenderError::Lost(error.to_string())),
    }
    let bytes = buffer.slice(..).get_mapped_range().map_err(|error| RenderError::Lost(error.to_string()))?;
    let mut rgba = Vec::with_capacity((width * height * BYTES_PER_PIXEL) as usize);
    for line in bytes.chunks_exact(row as usize) {
        rgba.extend_from_slice(&line[..(width * BYTES_PER_PIXEL) as usize]);
    }
    Ok(Picture { size: [width, height], rgba })
}

impl Picture {
    /// Red, green, blue and alpha of a pixel, from the upper left corner; none outside the picture.
    pub fn pixel(&self, at: [u32; 2]) -> Option<[u8; 4]> {
        let [x, y] = at;
        let inside = x < self.size[0] && y < self.size[1];
        let start = (y as usize * self.size[0] as usize + x as usize) * BYTES_PER_PIXEL as usize;
        inside.then(|| self.rgba.get(start..start + 4)?.try_into().ok()).flatten()
    }

    /// The picture as a PNG file.
    ///
    /// # Errors
    /// [`RenderError::Encoding`].
    pub fn to_png(&self) -> Result<Vec<u8>, RenderError> {
        let mut bytes = Vec::new();
        let mut encoder = png::Encoder::new(&mut bytes, self.size[0], self.size[1]);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_compression(png::Compression::Balanced);
        encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
        let mut writer = encoder.write_header()?;
        let rgb: Vec<u8> = self.rgba.chunks_exact(4).flat_map(|pixel| [pixel[0], pixel[1], pixel[2]]).collect();
        writer.write_image_data(&rgb)?;
        writer.finish()?;
        Ok(bytes)
    }
}
