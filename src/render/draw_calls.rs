//! Draw calls that passes share.

use super::content::{Content, MeshDraw};
use super::encoding::{ITEM_WORDS, TINT_WORDS, row_offset};
use super::store::Store;
use crate::draw::SurfaceStyle;

/// Draws the meshes of one surface.
pub(super) fn meshes(
    pass: &mut wgpu::RenderPass<'_>,
    pipeline: &wgpu::RenderPipeline,
    content: &Content,
    surface: SurfaceStyle,
) {
    draw_meshes(pass, pipeline, content, |mesh| mesh.surface == surface);
}

/// Draws the meshes that `which` chooses.
pub(super) fn draw_meshes(
    pass: &mut wgpu::RenderPass<'_>,
    pipeline: &wgpu::RenderPipeline,
    content: &Content,
    which: impl Fn(&MeshDraw) -> bool,
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
pub(super) fn instances(pass: &mut wgpu::RenderPass<'_>, pipeline: &wgpu::RenderPipeline, rows: &Store) {
    if rows.count > 0 {
        pass.set_pipeline(pipeline);
        pass.set_vertex_buffer(0, rows.buffer.slice(..));
        pass.draw(0..4, 0..rows.count);
    }
}
