//! The adapter between the renderer's pictures and the window's toolkit.

use super::displayed::DisplayedState;
use crate::draw::{Display, Subject, draw};
use crate::render::{Blit, Camera, Content, Options, RenderError, Renderer, Viewport, read_back};
use crate::scene::Scene;
use crate::solver::snapshot::Snapshot;
use crate::ui::theme::Tone;
use egui::{PaintCallback, PaintCallbackInfo, Rect};
use egui_wgpu::{CallbackResources, CallbackTrait, RenderState};
use glam::DVec3;
use std::sync::Arc;

/// Draws pictures on the window's own device.
pub(crate) struct Painter {
    state: RenderState,
    renderer: Renderer,
    blit: Blit,
    software: bool,
}

/// Everything that a picture follows from, but for the point of view.
#[derive(Clone, Debug)]
pub(crate) struct ViewInputs {
    /// The bodies.
    pub state: DisplayedState,
    /// The document.
    pub scene: Arc<Scene>,
    /// What is to be seen of them.
    pub display: Display,
    /// In which colours.
    pub tone: Tone,
    /// By how much the ghost is shown aside [m].
    pub ghost_aside: DVec3,
}

impl PartialEq for ViewInputs {
    fn eq(&self, other: &Self) -> bool {
        self.state == other.state
            && Arc::ptr_eq(&self.scene, &other.scene)
            && self.display == other.display
            && self.tone == other.tone
            && self.ghost_aside == other.ghost_aside
    }
}

/// The picture of one view, kept until what it shows changes.
#[derive(Default)]
pub(crate) struct ViewPicture {
    inputs: Option<ViewInputs>,
    content: Option<Content>,
    viewport: Option<Viewport>,
    source: Option<wgpu::BindGroup>,
    camera: Option<Camera>,
}

impl Painter {
    pub(crate) fn new(state: RenderState) -> Self {
        let renderer = Renderer::new(&state.device, &state.queue, Options::for_adapter(&state.adapter));
        let software = state.adapter.get_info().device_type == wgpu::DeviceType::Cpu;
        let blit = Blit::new(&state.device, state.target_format);
        Self { state, renderer, blit, software }
    }

    /// Whether it draws in software and saves work where that is not seen much.
    pub(crate) fn saves_work(&self) -> bool {
        self.software
    }

    /// What draws, as its driver calls it.
    pub(crate) fn adapter(&self) -> String {
        let info = self.state.adapter.get_info();
        format!("{} by {:?}, {} {}", info.name, info.backend, info.driver, info.driver_info)
    }

    /// A picture as it was painted last; none before it was.
    pub(crate) fn picture(&self, picture: &ViewPicture) -> Option<Result<crate::render::Picture, RenderError>> {
        picture.viewport.as_ref().map(|viewport| read_back(&self.renderer, viewport))
    }

    /// What shows `inputs` as `camera` sees it in a place of the window, drawn anew only if something has changed; none
    /// where there is no room.
    pub(crate) fn paint(
        &self,
        picture: &mut ViewPicture,
        inputs: ViewInputs,
        camera: &Camera,
        place: Rect,
        pixels_per_point: f32,
    ) -> Option<PaintCallback> {
        // The pixels of its place, as the toolkit counts them.
        let info = PaintCallbackInfo {
            viewport: place,
            clip_rect: place,
            pixels_per_point,
            screen_size_px: [i32::MAX as u32; 2],
        };
        let pixels = info.viewport_in_pixels();
        let size = [pixels.width_px, pixels.height_px].map(|extent| u32::try_from(extent).unwrap_or(0));
        if size.contains(&0) {
            return None;
        }
        let renderer = &self.renderer;
        let viewport = picture.viewport.get_or_insert_with(|| Viewport::new(renderer, size, pixels_per_point));
        let resized = viewport.resize(renderer, size, pixels_per_point);
        let content = picture.content.get_or_insert_with(|| Content::new(renderer));
        let changed = picture.inputs.as_ref() != Some(&inputs);
        if changed {
            let ghost = match &inputs.state {
                DisplayedState::Running(published) => published.ghost.as_ref(),
                DisplayedState::Model(_) | DisplayedState::Placed(_) => None,
            };
            let moved = ghost.filter(|_| inputs.ghost_aside != DVec3::ZERO).map(|ghost| {
                let bodies = ghost.bodies.iter().map(|body| body.moved(inputs.ghost_aside)).collect();
                Snapshot { bodies, ..ghost.clone() }
            });
            let ghost = moved.as_ref().or(ghost);
            let subject = Subject { scene: &inputs.scene, snapshot: &inputs.state, ghost };
            let list = draw(&subject, &inputs.display, &inputs.tone.pictures());
            if *content.list() != list || picture.source.is_none() {
                content.send(renderer, list);
                picture.camera = None;
            }
            picture.inputs = Some(inputs);
        }
        if resized || picture.camera != Some(*camera) {
            let mut encoder = self.state.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
            renderer.draw(&mut encoder, content, viewport, camera);
            self.state.queue.submit([encoder.finish()]);
            picture.camera = Some(*camera);
        }
        if resized || picture.source.is_none() {
            picture.source = Some(self.blit.source(&self.state.device, viewport));
        }
        let shown = Blitted { blit: self.blit.clone(), source: picture.source.clone()? };
        Some(egui_wgpu::Callback::new_paint_callback(place, shown))
    }
}

impl ViewPicture {
    /// Whether there is one.
    pub(crate) fn is_drawn(&self) -> bool {
        self.viewport.is_some()
    }
}

/// A finished picture in the toolkit's pass.
struct Blitted {
    blit: Blit,
    source: wgpu::BindGroup,
}

impl CallbackTrait for Blitted {
    fn paint(&self, _info: PaintCallbackInfo, pass: &mut wgpu::RenderPass<'static>, _resources: &CallbackResources) {
        self.blit.draw(pass, &self.source);
    }
}
