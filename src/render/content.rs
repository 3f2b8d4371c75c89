//! A draw list on the device.

use super::renderer::Renderer;
use super::shadow::Caster;
use super::skinning::GpuSkin;
use crate::draw::{Colour, DrawList, Faces, Ground, Line, Points, Size, SurfaceStyle, Theme};
use glam::{DVec3, Vec3};
use std::ops::Range;

/// 32-bit words of a mesh vertex (position, normal), of what is told of a whole mesh (colour, pick, cut), of a point
/// (centre, radius, colour, share through, pick) and of a segment (four points, colour, style, flags, pick).
pub(super) const VERTEX_WORDS: usize = 6;
pub(super) const ITEM_WORDS: usize = 6;
/// Red, green and blue of a vertex, 8 bits each, and in the highest 8 whether it has a colour of its own.
pub(super) const TINT_WORDS: usize = 1;
pub(super) const POINT_WORDS: usize = 10;
pub(super) const SEGMENT_WORDS: usize = 20;

/// A segment's flags, as in line.wgsl.
const HAS_PREVIOUS: u32 = 1;
const HAS_NEXT: u32 = 2;
pub(super) const ON_SCREEN: u32 = 4;

/// A draw list on the device, with the shadow that it casts.
pub struct Content {
    pub(super) list: DrawList,
    pub(super) vertices: Store,
    pub(super) indices: Store,
    pub(super) items: Store,
    /// Colours of vertices: of those in the common buffers, then of each skin that has some, then as many as the largest
    /// skin has vertices that say nothing.
    pub(super) tints: Store,
    pub(super) points: Store,
    pub(super) segments: Store,
    pub(super) meshes: Vec<MeshDraw>,
    /// Skins that the graphics processor moves.
    pub(super) skins: Vec<GpuSkin>,
    pub(super) casters: Option<[Caster; 2]>,
    /// Light that is hidden on the floor.
    pub(super) shade: wgpu::TextureView,
}

/// A mesh in the buffers.
pub(super) struct MeshDraw {
    /// Which of [`Content::skins`] it is; none for a mesh in the common buffers.
    pub(super) skin: Option<usize>,
    /// Row of its first vertex's colour.
    pub(super) tints: u32,
    pub(super) indices: Range<u32>,
    pub(super) surface: SurfaceStyle,
    pub(super) casts_shadow: bool,
    pub(super) picked: bool,
    /// Whether it is cut open.
    pub(super) cut: bool,
}

impl Content {
    /// Nothing yet, for a renderer.
    pub fn new(renderer: &Renderer) -> Self {
        let device = renderer.device();
        let ground = Ground { height: 0.0, solid: false, grid: true, axes: true };
        let shade = renderer.shade_target();
        Self {
            list: DrawList::new(DVec3::ZERO, ground, Theme::light()),
            vertices: Store::new(device, "mesh vertices", wgpu::BufferUsages::VERTEX),
            indices: Store::new(device, "mesh indices", wgpu::BufferUsages::INDEX),
            items: Store::new(device, "meshes", wgpu::BufferUsages::VERTEX),
            tints: Store::new(device, "colours of vertices", wgpu::BufferUsages::VERTEX),
            points: Store::new(device, "points", wgpu::BufferUsages::VERTEX),
            segments: Store::new(device, "segments", wgpu::BufferUsages::VERTEX),
            meshes: Vec::new(),
            skins: Vec::new(),
            casters: None,
            shade,
        }
    }

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

    /// Buffers of a mesh's vertices and indices.
    pub(super) fn buffers(&self, mesh: &MeshDraw) -> [&wgpu::Buffer; 2] {
        match mesh.skin.and_then(|skin| self.skins.get(skin)) {
            Some(skin) => [&skin.vertices, &skin.indices],
            None => [&self.vertices.buffer, &self.indices.buffer],
        }
    }

    /// The list as it was sent.
    pub fn list(&self) -> &DrawList {
        &self.list
    }
}

fn push<const N: usize>(words: &mut Vec<u32>, values: [f32; N]) {
    words.extend(values.map(f32::to_bits));
}

/// Puts a mesh into the common buffers; gives the range of its indices.
fn push_mesh(vertices: &mut Vec<u32>, indices: &mut Vec<u32>, faces: &Faces) -> Range<u32> {
    let (first_vertex, first_index) = ((vertices.len() / VERTEX_WORDS) as u32, indices.len() as u32);
    let (new_vertices, new_indices) = faces.worked_out();
    for vertex in &*new_vertices {
        push(vertices, vertex.position.to_array());
        push(vertices, vertex.normal.to_array());
    }
    indices.extend(new_indices.iter().map(|index| first_vertex + index));
    first_index..indices.len() as u32
}

fn push_points(words: &mut Vec<u32>, set: &Points) {
    // A radius in pixels goes as a negative one, as in point.wgsl.
    let radius = match set.size {
        Size::Metres(radius) => radius.max(1e-12),
        Size::Pixels(radius) => -radius.max(1e-3),
    };
    for (number, centre) in (0..).zip(&set.centres) {
        // Numbers go by place, so what is left out still counts.
        if !centre.is_finite() {
            continue;
        }
        push(words, centre.to_array());
        push(words, [radius]);
        let own = set.tints.get(number as usize).map(|&[red, green, blue]| Colour::from_rgb([red, green, blue]));
        push(words, own.unwrap_or(set.colour).linear());
        push(words, [set.through]);
        words.push(if set.pick == 0 { 0 } else { set.pick + number });
    }
}

/// Segments of a line, with the flags that all of them have.
pub(super) fn push_line(words: &mut Vec<u32>, line: &Line, flags: u32) {
    let points: Vec<Vec3> = line.points.iter().copied().filter(|point| point.is_finite()).collect();
    let last = points.len().saturating_sub(2);
    for k in 0..points.len().saturating_sub(1) {
        let before = if k > 0 { HAS_PREVIOUS } else { 0 };
        let behind = if k < last { HAS_NEXT } else { 0 };
        for point in [points[k], points[k + 1], points[k.saturating_sub(1)], points[(k + 2).min(last + 1)]] {
            push(words, point.to_array());
        }
        push(words, Colour::linear(line.colour));
        push(words, [line.width, line.through]);
        words.extend([flags | before | behind, line.pick]);
    }
}

/// A buffer that grows with what is written to it.
pub(super) struct Store {
    pub(super) buffer: wgpu::Buffer,
    pub(super) count: u32,
    label: &'static str,
    usage: wgpu::BufferUsages,
}

impl Store {
    pub(super) fn new(device: &wgpu::Device, label: &'static str, usage: wgpu::BufferUsages) -> Self {
        Self { buffer: make(device, label, usage, 256), count: 0, label, usage }
    }

    /// Writes rows of so many words each.
    pub(super) fn write(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, words: &[u32], row: usize) {
        let bytes = size_of_val(words) as u64;
        if bytes > self.buffer.size() {
            self.buffer = make(device, self.label, self.usage, bytes.next_power_of_two());
        }
        queue.write_buffer(&self.buffer, 0, bytemuck::cast_slice(words));
        self.count = (words.len() / row) as u32;
    }
}

fn make(device: &wgpu::Device, label: &'static str, usage: wgpu::BufferUsages, size: u64) -> wgpu::Buffer {
    device.create_buffer(&wgpu::BufferDescriptor {
        label: Some(label),
        size,
        usage: usage | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    })
}
