//! Draws the shadow on the floor: see shadow.rs.

use super::content::Content;
use super::draw_calls::instances;
use super::renderer::Renderer;
use super::targets::depth_attachment;
use bytemuck::bytes_of;

impl Renderer {
    /// Draws the shadow of content that was just sent.
    pub(super) fn draw_shadow(&self, content: &Content) {
        let Some(casters) = &content.casters else { return };
        let mut encoder =
            self.device().create_command_encoder(&wgpu::CommandEncoderDescriptor { label: Some("shadow") });
        for ((caster, buffer), heights) in casters.iter().zip(&self.casters).zip(&self.heights) {
            self.queue().write_buffer(buffer, 0, bytes_of(caster));
            let group = self.device().create_bind_group(&wgpu::BindGroupDescriptor {
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
        let group = self.device().create_bind_group(&wgpu::BindGroupDescriptor {
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
        self.queue().submit([encoder.finish()]);
    }
}
