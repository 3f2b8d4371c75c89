//! What is under a pixel: pick numbers and depths are drawn for the pixels around it only, and read back.

use super::camera::Camera;
use super::content::{Content, MeshDraw};
use super::draw_calls::{draw_meshes, instances};
use super::renderer::Renderer;
use super::targets::{DEPTH_FORMAT, PICK_FORMAT, depth_attachment, target};
use super::uniforms::FrameUniforms;
use super::viewport::Viewport;
use crate::draw::{PickId, PickKind, Picks, SurfaceStyle};
use bytemuck::bytes_of;
use glam::{DVec2, DVec3};
use std::sync::mpsc::{Receiver, TryRecvError, channel};
use std::task::Poll;

/// Greatest distance from the pixel that is looked at [pixels].
const MOST_REACH: u32 = 15;
/// Bytes a pixel: number and depth.
const PIXEL_BYTES: u32 = 8;

/// Something under a pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pick {
    /// What it is.
    pub id: PickId,
    /// The point of it that is seen there [m], in the world.
    pub point: DVec3,
}

/// A pick on its way back from the device.
pub struct Picking {
    device: wgpu::Device,
    buffer: wgpu::Buffer,
    mapped: Receiver<Result<(), wgpu::BufferAsyncError>>,
    picks: Picks,
    camera: Camera,
    size: DVec2,
    pixel: [u32; 2],
    reach: u32,
}

impl Renderer {
    /// Asks what is under a pixel of a viewport, from its upper left corner, or else within `reach` [pixels] of it.
    /// What is seen there is what is picked; within reach, what is thin (fibres, particles) goes before skins and
    /// panels. Inside a see-through skin what it holds goes before the skin itself.
    pub fn pick(
        &self,
        content: &Content,
        viewport: &Viewport,
        camera: &Camera,
        pixel: [u32; 2],
        reach: u32,
    ) -> Picking {
        let reach = reach.min(MOST_REACH);
        let side = 2 * reach + 1;
        let size = DVec2::from_array(viewport.size().map(f64::from));
        let frame = self.frame_buffer();
        let window = window(pixel, side, size);
        let uniforms =
            FrameUniforms::new(&content.list, None, camera, viewport.size(), viewport.pixels_per_point(), window);
        self.queue().write_buffer(&frame, 0, bytes_of(&uniforms));
        let drawn = wgpu::TextureUsages::RENDER_ATTACHMENT;
        let kept = drawn | wgpu::TextureUsages::COPY_SRC;
        let numbers = target(self.device(), "picks", [side; 2], 1, PICK_FORMAT, kept);
        let depth = target(self.device(), "pick depth", [side; 2], 1, DEPTH_FORMAT, drawn);
        let mut encoder = self.device().create_command_encoder(&wgpu::CommandEncoderDescriptor { label: Some("pick") });
        self.draw_picks(&mut encoder, content, &frame, [&numbers, &depth], side as f32);
        let row = (side * PIXEL_BYTES).next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT);
        let buffer = self.device().create_buffer(&wgpu::BufferDescriptor {
            label: Some("picks read back"),
            size: u64::from(row * side),
            usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
            mapped_at_creation: false,
        });
        encoder.copy_texture_to_buffer(
            numbers.as_image_copy(),
            wgpu::TexelCopyBufferInfo {
                buffer: &buffer,
                layout: wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(row), rows_per_image: None },
            },
            numbers.size(),
        );
        self.queue().submit([encoder.finish()]);
        let (sender, mapped) = channel();
        // Nobody may wait for it any more: then there is nobody to tell.
        buffer.slice(..).map_async(wgpu::MapMode::Read, move |result| drop(sender.send(result)));
        let picks = content.list.picks.clone();
        Picking { device: self.device().clone(), buffer, mapped, picks, camera: *camera, size, pixel, reach }
    }

    fn draw_picks(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        content: &Content,
        frame: &wgpu::Buffer,
        targets: [&wgpu::Texture; 2],
        side: f32,
    ) {
        let [numbers, depth] = targets.map(|texture| texture.create_view(&wgpu::TextureViewDescriptor::default()));
        let group = self.frame_group(frame, &content.shade);
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("picks"),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: &numbers,
                depth_slice: None,
                resolve_target: None,
                ops: wgpu::Operations {
                    load: wgpu::LoadOp::Clear(wgpu::Color::TRANSPARENT),
                    store: wgpu::StoreOp::Store,
                },
            })],
            depth_stencil_attachment: Some(depth_attachment(&depth, 0.0, wgpu::StoreOp::Discard)),
            ..wgpu::RenderPassDescriptor::default()
        });
        pass.set_bind_group(0, &group, &[]);
        // What can be seen through lies in the far half of the depths: behind all that cannot.
        let picked = |surface: SurfaceStyle| move |mesh: &MeshDraw| mesh.picked && mesh.surface == surface;
        pass.set_viewport(0.0, 0.0, side, side, 0.0, 0.5);
        let inside = |surface: SurfaceStyle| move |mesh: &MeshDraw| mesh.cut && mesh.surface == surface;
        draw_meshes(&mut pass, &self.pipelines.pick_mesh, content, picked(SurfaceStyle::XRay));
        draw_meshes(&mut pass, &self.pipelines.pick_inside, content, inside(SurfaceStyle::XRay));
        draw_meshes(&mut pass, &self.pipelines.pick_mesh, content, picked(SurfaceStyle::Faint));
        for side in [&self.pipelines.pick_mesh, &self.pipelines.pick_inside] {
            draw_meshes(&mut pass, side, content, picked(SurfaceStyle::Film));
        }
        pass.set_viewport(0.0, 0.0, side, side, 0.5, 1.0);
        draw_meshes(&mut pass, &self.pipelines.pick_mesh, content, |mesh| mesh.surface == SurfaceStyle::Solid);
        draw_meshes(&mut pass, &self.pipelines.pick_inside, content, inside(SurfaceStyle::Solid));
        instances(&mut pass, &self.pipelines.pick_points, &content.points);
        instances(&mut pass, &self.pipelines.pick_lines, &content.segments);
    }
}

/// Scale and offset in clip space that make the pixels around one the whole of a target.
fn window(pixel: [u32; 2], side: u32, size: DVec2) -> [f32; 4] {
    let scale = size / f64::from(side);
    let middle = DVec2::from_array(pixel.map(|at| f64::from(at) + 0.5)) / size * 2.0 - 1.0;
    [scale.x, scale.y, -middle.x * scale.x, middle.y * scale.y].map(|value| value as f32)
}

impl Picking {
    /// Whether the answer is there, and what it is: nothing, where nothing was hit or the device was lost.
    pub fn poll(&self) -> Poll<Option<Pick>> {
        // A device that cannot be polled never answers; the channel says so.
        drop(self.device.poll(wgpu::PollType::Poll));
        match self.mapped.try_recv() {
            Ok(Ok(())) => Poll::Ready(self.read()),
            Err(TryRecvError::Empty) => Poll::Pending,
            Ok(Err(_)) | Err(TryRecvError::Disconnected) => Poll::Ready(None),
        }
    }

    /// Waits for the answer.
    pub fn wait(&self) -> Option<Pick> {
        drop(self.device.poll(wgpu::PollType::wait_indefinitely()));
        match self.mapped.recv() {
            Ok(Ok(())) => self.read(),
            _ => None,
        }
    }

    fn read(&self) -> Option<Pick> {
        let bytes = self.buffer.slice(..).get_mapped_range().ok()?;
        let side = 2 * self.reach + 1;
        let row = (side * PIXEL_BYTES).next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT);
        let word = |at: u32| {
            let bytes = bytes.get(at as usize..at as usize + 4)?;
            Some(u32::from_le_bytes(bytes.try_into().ok()?))
        };
        let mut best: Option<((bool, u32), Pick)> = None;
        for y in 0..side {
            for x in 0..side {
                let at = y * row + x * PIXEL_BYTES;
                let Some(id) = self.picks.find(word(at)?) else { continue };
                let far = x.abs_diff(self.reach).pow(2) + y.abs_diff(self.reach).pow(2);
                if far > self.reach.pow(2) {
                    continue;
                }
                let rank = (matches!(id.kind, PickKind::Skin | PickKind::Panel | PickKind::Collider), far);
                if best.is_none_or(|(least, _)| rank < least) {
                    let depth = f64::from(f32::from_bits(word(at + 4)?));
                    let offset = DVec2::new(f64::from(x), f64::from(y)) - f64::from(self.reach);
                    let pixel = DVec2::from_array(self.pixel.map(f64::from)) + 0.5 + offset;
                    best = Some((rank, Pick { id, point: self.camera.point_at(pixel, depth, self.size) }));
                }
            }
        }
        best.map(|(_, pick)| pick)
    }
}
