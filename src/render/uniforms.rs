//! What every shader of a picture is told: [`FrameUniforms`], as `common.wgsl` reads it.

use super::camera::{Camera, Projection};
use super::scale::steps;
use super::shadow::{Caster, KEY_DIRECTION};
use crate::draw::DrawList;
use bytemuck::{Pod, Zeroable};
use glam::{DMat4, DVec2, DVec3, Vec3, Vec4};

/// The ground reaches so many picture heights.
const REACH: f64 = 5.0;
/// A body's own shade on its foot, as a share of its radius.
const FOOT: f64 = 1.0;

/// As `FrameUniforms` in common.wgsl.
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub(super) struct FrameUniforms {
    clip_from_local: [[f32; 4]; 4],
    view_right: Vec4,
    view_up: Vec4,
    view_back: Vec4,
    eye: Vec4,
    size: Vec4,
    window: Vec4,
    key_direction: Vec4,
    key: [f32; 4],
    sky: Vec4,
    bounce: [f32; 4],
    rim: Vec4,
    background_top: [f32; 4],
    background_bottom: [f32; 4],
    floor: [f32; 4],
    grid: [f32; 4],
    axis_u: [f32; 4],
    axis_v: [f32; 4],
    plane_center: Vec4,
    plane_u: Vec4,
    plane_v: Vec4,
    plane_offset: Vec4,
    steps: Vec4,
    ground: Vec4,
    shadow: Vec4,
    slice: Vec4,
}

/// The plane that carries the grid.
struct GridPlane {
    center: DVec3,
    axes: [usize; 2],
    faces_eye: bool,
}

impl GridPlane {
    /// The paper of a view along an axis, or the ground.
    fn of(list: &DrawList, camera: &Camera) -> Self {
        let back = camera.world_from_view().z_axis;
        if camera.projection == Projection::Parallel {
            for (axis, axes) in [(0, [2, 1]), (2, [0, 1])] {
                if back[axis].abs() > 1.0 - 1e-6 {
                    return Self { center: camera.target, axes, faces_eye: true };
                }
            }
        }
        Self { center: camera.target.with_y(list.ground.height), axes: [0, 2], faces_eye: false }
    }
}

impl FrameUniforms {
    /// A picture of `size` [pixels], of which `window` (scale and offset in clip space) is drawn.
    pub(super) fn new(
        list: &DrawList,
        caster: Option<&Caster>,
        camera: &Camera,
        size: [u32; 2],
        pixels_per_point: f32,
        window: [f32; 4],
    ) -> Self {
        let theme = &list.theme;
        let extent = DVec2::from_array(size.map(f64::from));
        let clip_from_local: DMat4 = camera.clip_from_view(extent.x / extent.y) * camera.view_from_local(list.origin);
        let axes = camera.world_from_view();
        let plane = GridPlane::of(list, camera);
        let unit = |axis: usize| Vec3::AXES[axis];
        let steps = steps(camera.metres_per_pixel(extent.y) * f64::from(pixels_per_point));
        let coordinates = plane.axes.map(|axis| plane.center[axis]);
        let offset = coordinates.map(|at| (at - (at / steps.major).round() * steps.major) as f32);
        let radius = list.bounds.map_or(1.0, |bounds| bounds.radius().max(1e-6));
        // An eye has a height; parallel lines of sight have only a direction.
        let perspective = camera.projection != Projection::Parallel;
        let below = if perspective { camera.eye().y < list.ground.height } else { axes.z_axis.y < -1e-6 };
        let reach = REACH * (camera.height + (camera.target.y - list.ground.height).abs());
        let with = |rgb: [f32; 4], w: f32| Vec4::new(rgb[0], rgb[1], rgb[2], w);
        let is = |yes: bool| f32::from(u8::from(yes));
        Self {
            clip_from_local: clip_from_local.as_mat4().to_cols_array_2d(),
            view_right: axes.x_axis.as_vec3().extend(0.0),
            view_up: axes.y_axis.as_vec3().extend(0.0),
            view_back: axes.z_axis.as_vec3().extend(is(perspective)),
            eye: list.local(camera.eye()).extend(is(below)),
            size: Vec4::new(size[0] as f32, size[1] as f32, pixels_per_point, 0.0),
            window: Vec4::from_array(window),
            key_direction: KEY_DIRECTION.normalize_or(Vec3::Y).extend(theme.key_strength),
            key: theme.key.linear(),
            sky: with(theme.sky.linear(), theme.fill_strength),
            bounce: theme.bounce.linear(),
            rim: with(theme.rim.linear(), theme.rim_strength),
            background_top: theme.background_top.linear(),
            background_bottom: theme.background_bottom.linear(),
            floor: theme.floor.linear(),
            grid: theme.grid.linear(),
            axis_u: theme.axes[plane.axes[0]].linear(),
            axis_v: theme.axes[plane.axes[1]].linear(),
            plane_center: list.local(plane.center).extend(reach as f32),
            plane_u: unit(plane.axes[0]).extend(is(plane.faces_eye)),
            plane_v: unit(plane.axes[1]).extend(is(list.ground.grid)),
            plane_offset: Vec4::new(offset[0], offset[1], coordinates[0] as f32, coordinates[1] as f32),
            steps: Vec4::new(
                steps.minor as f32,
                steps.strength as f32,
                steps.major as f32,
                (list.ground.height - list.origin.y) as f32,
            ),
            ground: Vec4::new(is(list.ground.solid), theme.shadow, (FOOT * radius) as f32, is(caster.is_some())),
            shadow: caster.map_or(Vec4::ZERO, Caster::place),
            // Without a plane nothing is above it.
            slice: list
                .slice
                .map_or(Vec4::W, |slice| slice.normal().as_vec3().extend(-slice.height(list.origin) as f32)),
        }
    }

    /// Whether the ground lies between the eye and what stands on it.
    pub(super) fn ground_in_front(&self) -> bool {
        self.eye.w > 0.5 && !self.on_paper()
    }

    /// Whether the grid is the paper of a drawing view.
    pub(super) fn on_paper(&self) -> bool {
        self.plane_u.w > 0.5
    }
}
