//! Sends a draw list to the device.

use super::content::{Content, MeshDraw};
use super::encoding::{
    ITEM_WORDS, POINT_WORDS, SEGMENT_WORDS, TINT_WORDS, VERTEX_WORDS, push, push_line, push_mesh, push_points,
};
use super::renderer::Renderer;
use super::shadow::Caster;
use super::skinning::GpuSkin;
use crate::draw::{DrawList, Faces};

impl Content {
    /// Sends a list, which is kept for the sake of picks, and draws its shadow.
    pub fn send(&mut self, renderer: &Renderer, list: DrawList) {
        let (device, queue) = (renderer.device(), renderer.queue());
        self.casters = Caster::of(&list);
        let (mut vertices, mut indices, mut items) = (Vec::new(), Vec::new(), Vec::new());
        self.meshes.clear();
        // A skin that was there before stays in the graphics processor's memory.
        let mut known = std::mem::take(&mut self.skins);
        for mesh in &list.meshes {
            let skin = match (&mesh.faces, renderer.skinning()) {
                (Faces::Skinned(skinned), Some(skinning)) => {
                    self.skins.push(match known.iter().position(|skin| skin.is_of(skinned)) {
                        Some(place) => known.swap_remove(place),
                        None => GpuSkin::new(device, skinning, skinned),
                    });
                    Some(self.skins.len() - 1)
                }
                _ => None,
            };
            let range = match skin {
                Some(skin) => 0..self.skins[skin].index_count(),
                None => push_mesh(&mut vertices, &mut indices, &mesh.faces),
            };
            push(&mut items, mesh.colour.linear());
            let cut = list.slice.is_some() && matches!(mesh.faces, Faces::Skinned(_));
            items.extend([mesh.pick, u32::from(cut)]);
            self.meshes.push(MeshDraw {
                skin,
                tints: 0,
                indices: range,
                surface: mesh.surface,
                casts_shadow: mesh.casts_shadow,
                picked: mesh.pick != 0,
                cut,
            });
        }
        self.colour_vertices(renderer, &list, vertices.len() / VERTEX_WORDS);
        let mut points = Vec::new();
        for set in &list.points {
            push_points(&mut points, set);
        }
        let mut segments = Vec::new();
        for line in &list.lines {
            push_line(&mut segments, line, 0);
        }
        self.vertices.write(device, queue, &vertices, VERTEX_WORDS);
        self.indices.write(device, queue, &indices, 1);
        self.items.write(device, queue, &items, ITEM_WORDS);
        self.points.write(device, queue, &points, POINT_WORDS);
        self.segments.write(device, queue, &segments, SEGMENT_WORDS);
        self.move_skins(renderer, &list);
        self.list = list;
        renderer.draw_shadow(self);
    }

    /// Sends the colours of vertices, where the common buffers hold so many.
    fn colour_vertices(&mut self, renderer: &Renderer, list: &DrawList, common: usize) {
        let word = |&[red, green, blue]: &[u8; 3]| u32::from_le_bytes([red, green, blue, u8::MAX]);
        let mut words = vec![0; common];
        let mut first = 0;
        for (mesh, drawn) in list.meshes.iter().zip(&mut self.meshes) {
            if drawn.skin.is_none() {
                let count = mesh.faces.vertex_count();
                for (slot, tint) in words[first..first + count].iter_mut().zip(&mesh.tints) {
                    *slot = word(tint);
                }
                first += count;
            } else if !mesh.tints.is_empty() {
                drawn.tints = words.len() as u32;
                words.extend(mesh.tints.iter().map(word));
            }
        }
        let plain = words.len();
        for (mesh, drawn) in list.meshes.iter().zip(&mut self.meshes) {
            if drawn.skin.is_some() && mesh.tints.is_empty() {
                drawn.tints = plain as u32;
                words.resize(words.len().max(plain + mesh.faces.vertex_count()), 0);
            }
        }
        self.tints.write(renderer.device(), renderer.queue(), &words, TINT_WORDS);
    }

    /// Moves the vertices of skins to where their particles are.
    fn move_skins(&self, renderer: &Renderer, list: &DrawList) {
        let Some(skinning) = renderer.skinning().filter(|_| !self.skins.is_empty()) else { return };
        let descriptor = wgpu::CommandEncoderDescriptor { label: Some("skins") };
        let mut encoder = renderer.device().create_command_encoder(&descriptor);
        let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
        let skinned = list.meshes.iter().filter_map(|mesh| match &mesh.faces {
            Faces::Skinned(skinned) => Some(skinned),
            Faces::Free(..) => None,
        });
        for (skin, skinned) in self.skins.iter().zip(skinned) {
            skin.deform(renderer.queue(), &mut pass, skinning, skinned);
        }
        drop(pass);
        renderer.queue().submit([encoder.finish()]);
    }
}
