//! The adapter between the renderer's pictures and the window's toolkit.

use crate::draw::DrawList;
use crate::render::{Camera, Content, Options, Renderer, Viewport};
use egui::TextureId;
use egui_wgpu::RenderState;

/// Draws pictures on the window's own device.
pub struct Painter {
    state: RenderState,
    renderer: Renderer,
}

/// The picture of one view, kept until what it shows changes.
#[derive(Default)]
pub struct Picture {
    content: Option<Content>,
    viewport: Option<Viewport>,
    texture: Option<TextureId>,
    camera: Option<Camera>,
}

impl Painter {
    pub(super) fn new(state: RenderState) -> Self {
        let renderer = Renderer::new(&state.device, &state.queue, Options::for_adapter(&state.adapter));
        Self { state, renderer }
    }

    /// The texture that shows `list` as `camera` sees it at `size` [pixels], drawn anew only if something has changed;
    /// none where there is no room.
    pub(super) fn paint(
        &self,
        picture: &mut Picture,
        list: DrawList,
        camera: &Camera,
        size: [u32; 2],
        pixels_per_point: f32,
    ) -> Option<TextureId> {
        if size.contains(&0) {
            return None;
        }
        let renderer = &self.renderer;
        let viewport = picture.viewport.get_or_insert_with(|| Viewport::new(renderer, size, pixels_per_point));
        let resized = viewport.resize(renderer, size, pixels_per_point);
        let content = picture.content.get_or_insert_with(|| Content::new(renderer));
        let fresh = picture.texture.is_none();
        let changed = fresh || *content.list() != list;
        if changed {
            content.send(renderer, list);
        }
        if changed || resized || picture.camera != Some(*camera) {
            let mut encoder = self.state.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
            renderer.draw(&mut encoder, content, viewport, camera);
            self.state.queue.submit([encoder.finish()]);
            picture.camera = Some(*camera);
        }
        let device = &self.state.device;
        let mut toolkit = self.state.renderer.write();
        match picture.texture {
            Some(texture) if resized => {
                toolkit.update_egui_texture_from_wgpu_texture(
                    device,
                    viewport.colour(),
                    wgpu::FilterMode::Linear,
                    texture,
                );
            }
            Some(_) => {}
            None => {
                picture.texture =
                    Some(toolkit.register_native_texture(device, viewport.colour(), wgpu::FilterMode::Linear));
            }
        }
        picture.texture
    }
}
