//! Pipelines: what is drawn how.

use super::encoding::{ITEM_WORDS, POINT_WORDS, SEGMENT_WORDS, TINT_WORDS, VERTEX_WORDS, WORD};
use super::shaders;
use super::targets::{DEPTH_FORMAT, PICK_FORMAT, SHADE_FORMAT};
use wgpu::{BlendState, CompareFunction, Face};

/// How fragments meet what was drawn before: the fixed-function part of a pipeline.
#[derive(Clone, Copy)]
struct RenderState {
    depth_compare: CompareFunction,
    depth_write: bool,
    blend: bool,
    /// Edges by samples, where there are some, in place of blending: right whatever is drawn behind later.
    alpha_to_coverage: bool,
    cull: Option<Face>,
}

const OPAQUE: RenderState = RenderState {
    depth_compare: CompareFunction::GreaterEqual,
    depth_write: true,
    blend: false,
    alpha_to_coverage: false,
    cull: Some(Face::Back),
};
const CLEAR: RenderState = RenderState {
    depth_compare: CompareFunction::GreaterEqual,
    depth_write: false,
    blend: true,
    alpha_to_coverage: false,
    cull: None,
};
/// Where something is in front: depth is reversed.
const BEHIND: RenderState = RenderState { depth_compare: CompareFunction::Less, ..CLEAR };
const ANYWHERE: RenderState = RenderState { depth_compare: CompareFunction::Always, ..CLEAR };
/// The lowest of all stays: shadows are made of heights, which are not reversed.
const LOWEST: RenderState =
    RenderState { depth_compare: CompareFunction::Less, depth_write: true, cull: None, ..OPAQUE };

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
    pub(super) film: wgpu::RenderPipeline,
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
        let picture = PipelineBuilder { device, layout: &frame, colour: Some(format), depth: true, samples };
        let pick = PipelineBuilder { colour: Some(PICK_FORMAT), samples: 1, ..picture };
        let cast = PipelineBuilder { layout: &caster, colour: None, samples: 1, ..picture };
        let shades = PipelineBuilder {
            layout: &layout("shade", &layouts.shade),
            colour: Some(SHADE_FORMAT),
            depth: false,
            samples: 1,
            ..picture
        };
        let inside = RenderState { cull: Some(Face::Front), ..OPAQUE };
        let solid_pick = RenderState { blend: false, ..OPAQUE };
        Self {
            background: picture.build(&background, ["vs_background", "fs_background"], VertexInput::None, ANYWHERE),
            paper: picture.build(&ground, ["vs_ground", "fs_ground"], VertexInput::None, ANYWHERE),
            floor: picture.build(
                &ground,
                ["vs_ground", "fs_ground"],
                VertexInput::None,
                RenderState { depth_write: true, ..CLEAR },
            ),
            grid: picture.build(&ground, ["vs_ground", "fs_ground"], VertexInput::None, CLEAR),
            solid: picture.build(&mesh, ["vs_mesh", "fs_solid"], VertexInput::Mesh, OPAQUE),
            inside: picture.build(&mesh, ["vs_mesh", "fs_inside"], VertexInput::Mesh, inside),
            x_ray_back: picture.build(
                &mesh,
                ["vs_mesh", "fs_x_ray"],
                VertexInput::Mesh,
                RenderState { cull: Some(Face::Front), ..CLEAR },
            ),
            x_ray_front: picture.build(
                &mesh,
                ["vs_mesh", "fs_x_ray"],
                VertexInput::Mesh,
                RenderState { cull: Some(Face::Back), ..CLEAR },
            ),
            film: picture.build(&mesh, ["vs_mesh", "fs_film"], VertexInput::Mesh, CLEAR),
            faint: picture.build(&mesh, ["vs_mesh", "fs_faint"], VertexInput::Mesh, CLEAR),
            points: picture.build(
                &point,
                ["vs_point", "fs_point"],
                VertexInput::Points,
                RenderState { depth_write: true, alpha_to_coverage: true, ..CLEAR },
            ),
            points_through: picture.build(&point, ["vs_point", "fs_point_through"], VertexInput::Points, BEHIND),
            lines: picture.build(&line, ["vs_line", "fs_line"], VertexInput::Segments, CLEAR),
            lines_through: picture.build(&line, ["vs_line", "fs_line_through"], VertexInput::Segments, BEHIND),
            pick_mesh: pick.build(&mesh, ["vs_mesh", "fs_mesh_pick"], VertexInput::Mesh, solid_pick),
            pick_inside: pick.build(&mesh, ["vs_mesh", "fs_mesh_pick"], VertexInput::Mesh, inside),
            pick_points: pick.build(
                &point,
                ["vs_point", "fs_point_pick"],
                VertexInput::Points,
                RenderState { cull: None, ..solid_pick },
            ),
            pick_lines: pick.build(
                &line,
                ["vs_line", "fs_line_pick"],
                VertexInput::Segments,
                RenderState { cull: None, ..solid_pick },
            ),
            cast_mesh: cast.build(&shadow, ["vs_cast_mesh", ""], VertexInput::Vertices, LOWEST),
            cast_points: cast.build(&shadow, ["vs_cast_point", ""], VertexInput::Points, LOWEST),
            shade: shades.build(
                &shade,
                ["vs_shade", "fs_shade"],
                VertexInput::None,
                RenderState { blend: false, ..ANYWHERE },
            ),
        }
    }
}

/// What a vertex shader reads.
#[derive(Clone, Copy)]
enum VertexInput {
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

impl VertexInput {
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
struct PipelineBuilder<'a> {
    device: &'a wgpu::Device,
    layout: &'a wgpu::PipelineLayout,
    colour: Option<wgpu::TextureFormat>,
    depth: bool,
    samples: u32,
}

impl PipelineBuilder<'_> {
    fn build(
        &self,
        module: &wgpu::ShaderModule,
        entries: [&str; 2],
        input: VertexInput,
        state: RenderState,
    ) -> wgpu::RenderPipeline {
        let [vertex, fragment] = entries;
        let covers = state.alpha_to_coverage && self.samples > 1;
        let targets = [self.colour.map(|format| wgpu::ColorTargetState {
            format,
            blend: (state.blend && !covers).then_some(BlendState::ALPHA_BLENDING),
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
                buffers: &input.layouts(),
            },
            primitive: wgpu::PrimitiveState {
                topology: input.topology(),
                cull_mode: state.cull,
                ..wgpu::PrimitiveState::default()
            },
            depth_stencil: self.depth.then(|| wgpu::DepthStencilState {
                format: DEPTH_FORMAT,
                depth_write_enabled: Some(state.depth_write),
                depth_compare: Some(state.depth_compare),
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
