//! Draws content into viewports.

use super::camera::Camera;
use super::content::Content;
use super::draw_calls::{draw_meshes, instances, meshes};
use super::marks;
use super::renderer::Renderer;
use super::uniforms::FrameUniforms;
use super::viewport::Viewport;
use crate::draw::SurfaceStyle;
use bytemuck::bytes_of;

impl Renderer {
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
        self.queue().write_buffer(&viewport.frame, 0, bytes_of(&frame));
        marks::write(&mut viewport.marks, self, content.list(), camera, size, scale);
        let group = self.frame_group(&viewport.frame, &content.shade);
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
        meshes(&mut pass, &pipelines.film, content, SurfaceStyle::Film);
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
}
