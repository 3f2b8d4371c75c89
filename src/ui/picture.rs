//! The adapter between the renderer's pictures and the window's toolkit.

use super::theme::Tone;
use crate::draw::{Display, Subject, draw};
use crate::render::{Camera, Content, Options, Renderer, Viewport};
use crate::scene::Scene;
use crate::sim::Published;
use crate::solver::snapshot::Snapshot;
use egui::TextureId;
use egui_wgpu::RenderState;
use std::ops::Deref;
use std::sync::Arc;

/// Draws pictures on the window's own device.
pub struct Painter {
    state: RenderState,
    renderer: Renderer,
    software: bool,
}

/// A state of the bodies, shared with who made it.
#[derive(Clone, Debug)]
pub enum Shown {
    /// A body at rest, as it is drawn into.
    Model(Arc<Snapshot>),
    /// The simulation.
    Running(Arc<Published>),
}

impl Deref for Shown {
    type Target = Snapshot;

    fn deref(&self) -> &Snapshot {
        match self {
            Self::Model(snapshot) => snapshot,
            Self::Running(published) => &published.snapshot,
        }
    }
}

impl PartialEq for Shown {
    /// Whether it is the same one: what is published is never changed.
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Model(a), Self::Model(b)) => Arc::ptr_eq(a, b),
            (Self::Running(a), Self::Running(b)) => Arc::ptr_eq(a, b),
            _ => false,
        }
    }
}

/// Everything that a picture follows from, but for the point of view.
#[derive(Clone, Debug)]
pub struct Sight {
    /// The bodies.
    pub shown: Shown,
    /// The document.
    pub scene: Arc<Scene>,
    /// What is to be seen of them.
    pub display: Display,
    /// In which colours.
    pub tone: Tone,
}

impl PartialEq for Sight {
    fn eq(&self, other: &Self) -> bool {
        self.shown == other.shown
            && Arc::ptr_eq(&self.scene, &other.scene)
            && self.display == other.display
            && self.tone == other.tone
    }
}

/// The picture of one view, kept until what it shows changes.
#[derive(Default)]
pub struct Picture {
    sight: Option<Sight>,
    content: Option<Content>,
    viewport: Option<Viewport>,
    texture: Option<TextureId>,
    camera: Option<Camera>,
}

impl Painter {
    pub(super) fn new(state: RenderState) -> Self {
        let renderer = Renderer::new(&state.device, &state.queue, Options::for_adapter(&state.adapter));
        let software = state.adapter.get_info().device_type == wgpu::DeviceType::Cpu;
        Self { state, renderer, software }
    }

    /// Whether it draws in software and saves work where that is not seen much.
    pub(super) fn saves_work(&self) -> bool {
        self.software
    }

    /// The texture that shows `sight` as `camera` sees it at `size` [pixels], drawn anew only if something has changed;
    /// none where there is no room.
    pub(super) fn paint(
        &self,
        picture: &mut Picture,
        sight: Sight,
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
        let changed = picture.sight.as_ref() != Some(&sight);
        if changed {
            let subject = Subject { scene: &sight.scene, snapshot: &sight.shown, ghost: None };
            let list = draw(&subject, &sight.display, &sight.tone.pictures());
            if *content.list() != list || picture.texture.is_none() {
                content.send(renderer, list);
                picture.camera = None;
            }
            picture.sight = Some(sight);
        }
        if resized || picture.camera != Some(*camera) {
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
