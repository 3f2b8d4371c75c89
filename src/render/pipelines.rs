//! Pipelines: what is drawn how.

use super::content::{ITEM_WORDS, POINT_WORDS, SEGMENT_WORDS, TINT_WORDS, VERTEX_WORDS};
use super::shaders;
use wgpu::{BlendState, CompareFunction, Face};

pub(super) const DEPTH_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Depth32Float;
pub(super) const PICK_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rg32Uint;
pub(super) const SHADE_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rg8Unorm;

const WORD: usize = 4;

/// How something meets what was drawn before.
#[derive(Clone, Copy)]
struct Meets {
    depth: CompareFunction,
    writes: bool,
    blend: bool,
    /// Edges by samples, where there are some, in place of blending: right whatever is drawn behind later.
    covers: bool,
    cull: Option<Face>,
}

const OPAQUE: Meets =
    Meets { depth: CompareFunction::GreaterEqual, writes: true, blend: false, covers: false, cull: Some(Face::Back) };
const CLEAR: Meets =
    Meets { depth: CompareFunction::GreaterEqual, writes: false, blend: true, covers: false, cull: None };
/// Where something is in front: depth is reversed.
const BEHIND: Meets = Meets { depth: CompareFunction::Less, ..CLEAR };
const ANYWHERE: Meets = Meets { depth: CompareFunction::Always, ..CLEAR };

/// Pipelines that draw into the same kind of target.
pub(super) struct Pipelines {
    pub(super) background: wgpu::RenderPipeline,
    pub(super) paper: wgpu::RenderPipeline,
    pub(super) floor: wgpu::RenderPipeline,
    pub(super) grid: wgpu::RenderPipeline,
    pub(super) solid: wgpu::RenderPipeline,
    pub(super) inside: wgpu::RenderPipeline,
    pub(super) x_ray_back: wgpu::RenderPipeline,
    pub(super) x_ray_front: wgpu::RenderPipeline,
    pub(super) faint: wgpu::RenderPipeline,
    pub(super) points: wgpu::RenderPipeline,
    pub(super) points_through: wgpu::RenderPipeline,
    pub(super) lines: wgpu::RenderPipeline,
    pub(super) lines_through: wgpu::RenderPipeline,
    pub(super) pick_mesh: wgpu::RenderPipeline,
    pub(super) pick_inside: wgpu::RenderPipeline,
    pub(super) pick_points: wgpu::RenderPipeline,
    pub(super) pick_lines: wgpu::RenderPipeline,
    pub(super) cast_mesh: wgpu::RenderPipeline,
    pub(super) cast_points: wgpu::RenderPipeline,
    pub(super) shade: wgpu::RenderPipeline,
}

/// Layouts of what the shaders are told.
pub(super) struct Layouts {
    pub(super) frame: wgpu::BindGroupLayout,
    pub(super) caster: wgpu::BindGroupLayout,
    pub(super) shade: wgpu::BindGroupLayout,
}

impl Layouts {
    pub(super) fn new(device: &wgpu::Device) -> Self {
        let entry = |binding: u32, ty: wgpu::BindingType| wgpu::BindGroupLayoutEntry {
            binding,
            visibility: wgpu::ShaderStages::VERTEX_FRAGMENT,
            ty,
            count: None,
        };
        let uniform = wgpu::BindingType::Buffer {
            ty: wgpu::BufferBindingType::Uniform,
            has_dynamic_offset: false,
            min_binding_size: None,
        };
        let texture = |sample_type: wgpu::TextureSampleType| wgpu::BindingType::Texture {
            sample_type,
            view_dimension: wgpu::TextureViewDimension::D2,
            multisampled: false,
        };
        let filtered = texture(wgpu::TextureSampleType::Float { filterable: true });
        let sampler = wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Filtering);
        let layout = |label: &str, entries: &[wgpu::BindGroupLayoutEntry]| {
            device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor { label: Some(label), entries })
        };
        // Depths are loaded as plain numbers: OpenGL knows no other way.
        let depth = texture(wgpu::TextureSampleType::Float { filterable: false });
        Self {
            frame: layout("frame", &[entry(0, uniform), entry(1, filtered), entry(2, sampler)]),
            caster: layout("caster", &[entry(0, uniform)]),
            shade: layout("shade", &[entry(0, uniform), entry(1, depth), entry(2, depth)]),
        }
    }
}

impl Pipelines {
    pub(super) fn new(device: &wgpu::Device, layouts: &Layouts, format: wgpu::TextureFormat, samples: u32) -> Self {
        let module = |label: &str, source: &'static str| {
            device.create_shader_module(wgpu::ShaderModuleDescriptor {
                label: Some(label),
                source: wgpu::ShaderSource::Wgsl(source.into()),
            })
        };
        let layout = |label: &str, group: &wgpu::BindGroupLayout| {
            device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
                label: Some(label),
                bind_group_layouts: &[Some(group)],
                immediate_size: 0,
            })
        };
        let [background, ground, line, mesh, point, shadow, shade] = [
            ("background", shaders::BACKGROUND),
            ("ground", shaders::GROUND),
            ("line", shaders::LINE),
            ("mesh", shaders::MESH),
            ("point", shaders::POINT),
            ("shadow", shaders::SHADOW),
            ("shade", shaders::SHADE),
        ]
        .map(|(label, source)| module(label, source));
        let frame = layout("frame", &layouts.frame);
        let caster = layout("caster", &layouts.caster);
        let picture = Maker { device, layout: &frame, colour: Some(format), depth: true, samples };
        let pick = Maker { colour: Some(PICK_FORMAT), samples: 1, ..picture };
        let cast = Maker { layout: &caster, colour: None, samples: 1, ..picture };
        let shades = Maker {
            layout: &layout("shade", &layouts.shade),
            colour: Some(SHADE_FORMAT),
            depth: false,
            samples: 1,
            ..picture
        };
        let inside = Meets { cull: Some(Face::Front), ..OPAQUE };
        let solid_pick = Meets { blend: false, ..OPAQUE };
        let lowest = Meets { depth: CompareFunction::Less, writes: true, blend: false, covers: false, cull: None };
        Self {
            background: picture.make(&background, ["vs_background", "fs_background"], Rows::None, ANYWHERE),
            paper: picture.make(&ground, ["vs_ground", "fs_ground"], Rows::None, ANYWHERE),
            floor: picture.make(&ground, ["vs_ground", "fs_ground"], Rows::None, Meets { writes: true, ..CLEAR }),
            grid: picture.make(&ground, ["vs_ground", "fs_ground"], Rows::None, CLEAR),
            solid: picture.make(&mesh, ["vs_mesh", "fs_solid"], Rows::Mesh, OPAQUE),
            inside: picture.make(&mesh, ["vs_mesh", "fs_inside"], Rows::Mesh, inside),
            x_ray_back: picture.make(
                &mesh,
                ["vs_mesh", "fs_x_ray"],
                Rows::Mesh,
                Meets { cull: Some(Face::Front), ..CLEAR },
            ),
            x_ray_front: picture.make(
                &mesh,
                ["vs_mesh", "fs_x_ray"],
                Rows::Mesh,
                Meets { cull: Some(Face::Back), ..CLEAR },
            ),
            faint: picture.make(&mesh, ["vs_mesh", "fs_faint"], Rows::Mesh, CLEAR),
            points: picture.make(
                &point,
                ["vs_point", "fs_point"],
                Rows::Points,
                Meets { writes: true, covers: true, ..CLEAR },
            ),
            points_through: picture.make(&point, ["vs_point", "fs_point_through"], Rows::Points, BEHIND),
            lines: picture.make(&line, ["vs_line", "fs_line"], Rows::Segments, CLEAR),
            lines_through: picture.make(&line, ["vs_line", "fs_line_through"], Rows::Segments, BEHIND),
            pick_mesh: pick.make(&mesh, ["vs_mesh", "fs_mesh_pick"], Rows::Mesh, solid_pick),
            pick_inside: pick.make(&mesh, ["vs_mesh", "fs_mesh_pick"], Rows::Mesh, inside),
            pick_points: pick.make(
                &point,
                ["vs_point", "fs_point_pick"],
                Rows::Points,
                Meets { cull: None, ..solid_pick },
            ),
            pick_lines: pick.make(
                &line,
                ["vs_line", "fs_line_pick"],
                Rows::Segments,
                Meets { cull: None, ..solid_pick },
            ),
            cast_mesh: cast.make(&shadow, ["vs_cast_mesh", ""], Rows::Vertices, lowest),
            cast_points: cast.make(&shadow, ["vs_cast_point", ""], Rows::Points, lowest),
            shade: shades.make(&shade, ["vs_shade", "fs_shade"], Rows::None, Meets { blend: false, ..ANYWHERE }),
        }
    }
}

/// What a vertex shader reads.
#[derive(Clone, Copy)]
enum Rows {
    None,
    Mesh,
    /// A mesh without what is told of it as a whole.
    Vertices,
    Points,
    Segments,
}

const VERTEX: [wgpu::VertexAttribute; 2] = wgpu::vertex_attr_array![0 => Float32x3, 1 => Float32x3];
const ITEM: [wgpu::VertexAttribute; 3] = wgpu::vertex_attr_array![2 => Float32x4, 3 => Uint32, 5 => Uint32];
const TINT: [wgpu::VertexAttribute; 1] = wgpu::vertex_attr_array![4 => Unorm8x4];
const POINT: [wgpu::VertexAttribute; 5] =
    wgpu::vertex_attr_array![0 => Float32x3, 1 => Float32, 2 => Float32x4, 3 => Float32, 4 => Uint32];
const SEGMENT: [wgpu::VertexAttribute; 8] = wgpu::vertex_attr_array![
    0 => Float32x3, 1 => Float32x3, 2 => Float32x3, 3 => Float32x3, 4 => Float32x4, 5 => Float32x2, 6 => Uint32, 7 => Uint32
];

impl Rows {
    fn layouts(self) -> Vec<Option<wgpu::VertexBufferLayout<'static>>> {
        let rows = |words: usize, step_mode, attributes: &'static [wgpu::VertexAttribute]| {
            debug_assert!(
                attributes.iter().map(|at| at.offset + at.format.size()).max() == Some((words * WORD) as u64)
            );
            Some(wgpu::VertexBufferLayout { array_stride: (words * WORD) as u64, step_mode, attributes })
        };
        let (vertex, instance) = (wgpu::VertexStepMode::Vertex, wgpu::VertexStepMode::Instance);
        match self {
            Self::None => Vec::new(),
            Self::Mesh => vec![
                rows(VERTEX_WORDS, vertex, &VERTEX),
                rows(ITEM_WORDS, instance, &ITEM),
                rows(TINT_WORDS, vertex, &TINT),
            ],
            Self::Vertices => vec![rows(VERTEX_WORDS, vertex, &VERTEX)],
            Self::Points => vec![rows(POINT_WORDS, instance, &POINT)],
            Self::Segments => vec![rows(SEGMENT_WORDS, instance, &SEGMENT)],
        }
    }

    fn topology(self) -> wgpu::PrimitiveTopology {
        match self {
            Self::Mesh | Self::Vertices => wgpu::PrimitiveTopology::TriangleList,
            Self::None | Self::Points | Self::Segments => wgpu::PrimitiveTopology::TriangleStrip,
        }
    }
}

/// What pipelines for the same targets have in common.
#[derive(Clone, Copy)]
struct Maker<'a> {
    device: &'a wgpu::Device,
    layout: &'a wgpu::PipelineLayout,
    colour: Option<wgpu::TextureFormat>,
    depth: bool,
    samples: u32,
}

impl Maker<'_> {
    fn make(&self, module: &wgpu::ShaderModule, entries: [&str; 2], rows: Rows, meets: Meets) -> wgpu::RenderPipeline {
        let [vertex, fragment] = entries;
        let covers = meets.covers && self.samples > 1;
        let targets = [self.colour.map(|format| wgpu::ColorTargetState {
            format,
            blend: (meets.blend && !covers).then_some(BlendState::ALPHA_BLENDING),
            write_mask: wgpu::ColorWrites::ALL,
        })];
        let compilation_options = wgpu::PipelineCompilationOptions::default();
        self.device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: Some(vertex),
            layout: Some(self.layout),
            vertex: wgpu::VertexState {
                module,
                entry_point: Some(vertex),
                compilation_options: compilation_options.clone(),
                buffers: &rows.layouts(),
            },
            primitive: wgpu::PrimitiveState {
                topology: rows.topology(),
                cull_mode: meets.cull,
                ..wgpu::PrimitiveState::default()
            },
            depth_stencil: self.depth.then(|| wgpu::DepthStencilState {
                format: DEPTH_FORMAT,
                depth_write_enabled: Some(meets.writes),
                depth_compare: Some(meets.depth),
                stencil: wgpu::StencilState::default(),
                bias: wgpu::DepthBiasState::default(),
            }),
            multisample: wgpu::MultisampleState {
                count: self.samples,
                alpha_to_coverage_enabled: covers,
                ..wgpu::MultisampleState::default()
            },
            fragment: self.colour.map(|_| wgpu::FragmentState {
                module,
                entry_point: Some(fragment),
                compilation_options,
                targets: &targets,
            }),
            multiview_mask: None,
            cache: None,
        })
    }
}

/// Words of a buffer's row as an offset [bytes].
pub(super) fn row_offset(row: u32, words: usize) -> u64 {
    u64::from(row) * (words * WORD) as u64
}
