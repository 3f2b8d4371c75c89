//! The point of view. All in f64, so that a scene a kilometre from the origin is seen as steadily as one at home.
//!
//! View space has X right, Y up and the eye looking along -Z. Clip space is that of wgpu, with depth reversed (1 near,
//! 0 far), where floating point keeps it fine over any range. Pixels count from the upper left corner.

use crate::draw::Bounds;
use glam::{DMat3, DMat4, DVec2, DVec3, DVec4};
use std::f64::consts::{FRAC_PI_2, PI};

/// Least and greatest height of what is seen [m].
const HEIGHT_RANGE: (f64, f64) = (1e-6, 1e6);
/// Share of the picture left free around what is framed.
const MARGIN: f64 = 1.12;
/// Near plane as a share of the distance to the target.
const NEAR: f64 = 0.01;
/// Parallel views see this many picture heights before and behind their target.
const DEPTH_HEIGHTS: f64 = 200.0;

/// How space becomes a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Projection {
    /// As an eye sees it.
    Perspective {
        /// Vertical angle of view [rad].
        angle: f64,
    },
    /// Along parallel lines, to scale.
    Parallel,
}

/// The views along an axis, named for where the eye is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Facing {
    /// From +Z: X runs right, Y up.
    Front,
    /// From -Z.
    Back,
    /// From -X: Z runs right, Y up. The drawing view "side".
    Side,
    /// From +X.
    OtherSide,
    /// From +Y: X runs right, Z down.
    Top,
    /// From -Y.
    Bottom,
}

impl Facing {
    /// Yaw and pitch [rad].
    fn angles(self) -> (f64, f64) {
        match self {
            Self::Front => (0.0, 0.0),
            Self::Back => (PI, 0.0),
            Self::Side => (-FRAC_PI_2, 0.0),
            Self::OtherSide => (FRAC_PI_2, 0.0),
            Self::Top => (0.0, FRAC_PI_2),
            Self::Bottom => (0.0, -FRAC_PI_2),
        }
    }
}

/// A point of view: it looks at a target from a yaw and a pitch, and sees so much of its height.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// What it looks at [m].
    pub target: DVec3,
    /// Turn of the eye about the vertical [rad]; zero looks from +Z.
    pub yaw: f64,
    /// Height of the eye [rad]; a right angle looks straight down.
    pub pitch: f64,
    /// Height [m] of the plane through the target that fills the picture.
    pub height: f64,
    /// How space becomes a picture.
    pub projection: Projection,
}

/// A line of sight.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// Where it starts [m]: on the near side of everything that is seen.
    pub origin: DVec3,
    /// Unit direction away from the eye.
    pub direction: DVec3,
}

/// A point as it is seen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Projected {
    /// Where [pixels].
    pub pixel: DVec2,
    /// How far from the eye along its line of view [m]; in a parallel view, from the plane through the target.
    pub depth: f64,
}

impl Camera {
    /// A parallel view along an axis, one metre high.
    pub fn facing(facing: Facing) -> Self {
        let (yaw, pitch) = facing.angles();
        Self { target: DVec3::ZERO, yaw, pitch, height: 1.0, projection: Projection::Parallel }
    }

    /// The view in which results are shown: from the front, right and above.
    pub fn perspective() -> Self {
        let angle = 30_f64.to_radians();
        Self {
            target: DVec3::ZERO,
            yaw: 32_f64.to_radians(),
            pitch: 17_f64.to_radians(),
            height: 1.0,
            projection: Projection::Perspective { angle },
        }
    }

    /// Columns are the view's right, up and backward directions in the world.
    pub(crate) fn world_from_view(&self) -> DMat3 {
        DMat3::from_rotation_y(self.yaw) * DMat3::from_rotation_x(-self.pitch)
    }

    /// Distance from the eye to the target [m]; zero for a parallel view, whose eye has no place.
    pub fn distance(&self) -> f64 {
        match self.projection {
            Projection::Perspective { angle } => 0.5 * self.height / (0.5 * angle).tan(),
            Projection::Parallel => 0.0,
        }
    }

    /// Where the eye is [m]; for a parallel view the target, from which depths count.
    pub fn eye(&self) -> DVec3 {
        self.target + self.world_from_view().z_axis * self.distance()
    }

    /// Into view space, from coordinates about `origin` [m].
    pub(crate) fn view_from_local(&self, origin: DVec3) -> DMat4 {
        let view_from_world = self.world_from_view().transpose();
        DMat4::from_mat3_translation(view_from_world, view_from_world * (origin - self.eye()))
    }

    /// From view space to clip space for a picture `aspect` times as wide as high.
    pub(crate) fn clip_from_view(&self, aspect: f64) -> DMat4 {
        let columns = |x: f64, y: f64, z: DVec4, w: DVec4| {
            DMat4::from_cols(DVec4::new(x, 0.0, 0.0, 0.0), DVec4::new(0.0, y, 0.0, 0.0), z, w)
        };
        match self.projection {
            Projection::Perspective { angle } => {
                let f = 1.0 / (0.5 * angle).tan();
                let near = NEAR * self.distance();
                columns(f / aspect, f, DVec4::NEG_W, DVec4::new(0.0, 0.0, near, 0.0))
            }
            Projection::Parallel => {
                let f = 2.0 / self.height;
                let reach = DEPTH_HEIGHTS * self.height;
                columns(f / aspect, f, DVec4::new(0.0, 0.0, 0.5 / reach, 0.0), DVec4::new(0.0, 0.0, 0.5, 1.0))
            }
        }
    }

    /// Length that a pixel covers at the target [m], in a picture this many pixels high.
    pub(crate) fn metres_per_pixel(&self, picture_height: f64) -> f64 {
        self.height / picture_height
    }

    /// Where a point [m] is seen in a picture of `size` [pixels]; none behind the eye.
    pub fn project(&self, point: DVec3, size: DVec2) -> Option<Projected> {
        let view = self.view_from_local(DVec3::ZERO).transform_point3(point);
        let clip = self.clip_from_view(size.x / size.y) * view.extend(1.0);
        (clip.w > 0.0)
            .then(|| Projected { pixel: (DVec2::new(clip.x, -clip.y) / clip.w + 1.0) * 0.5 * size, depth: -view.z })
    }

    /// The line of sight through a pixel of a picture of `size` [pixels].
    pub fn ray(&self, pixel: DVec2, size: DVec2) -> Ray {
        let offset = (pixel / size - 0.5) * DVec2::new(size.x / size.y, -1.0) * self.height;
        let axes = self.world_from_view();
        let on_plane = self.target + axes.x_axis * offset.x + axes.y_axis * offset.y;
        match self.projection {
            Projection::Perspective { .. } => {
                let origin = self.eye();
                Ray { origin, direction: (on_plane - origin).normalize_or(-axes.z_axis) }
            }
            Projection::Parallel => {
                let reach = DEPTH_HEIGHTS * self.height;
                Ray { origin: on_plane + axes.z_axis * reach, direction: -axes.z_axis }
            }
        }
    }

    /// The point [m] that is seen at a pixel at a depth as [`Projected`] gives it.
    pub fn point_at(&self, pixel: DVec2, depth: f64, size: DVec2) -> DVec3 {
        let backward = self.world_from_view().z_axis;
        let ray = self.ray(pixel, size);
        let start = (self.eye() - ray.origin).dot(-backward);
        ray.origin + ray.direction * ((start + depth) / ray.direction.dot(-backward))
    }

    /// Turns about the target by so many radians, without going over the top.
    pub fn orbit(&mut self, yaw: f64, pitch: f64) {
        self.yaw = (self.yaw + yaw).rem_euclid(2.0 * PI);
        self.pitch = (self.pitch + pitch).clamp(-FRAC_PI_2, FRAC_PI_2);
    }

    /// Moves so that what was under one pixel comes under another `by` [pixels] away, at the target's depth.
    pub fn pan(&mut self, by: DVec2, size: DVec2) {
        let axes = self.world_from_view();
        let step = by * self.metres_per_pixel(size.y);
        self.target += axes.y_axis * step.y - axes.x_axis * step.x;
    }

    /// Comes closer (`factor` below 1) or goes further, keeping what is seen at a pixel at the target's depth.
    pub fn zoom(&mut self, factor: f64, pixel: DVec2, size: DVec2) {
        let before = self.point_at(pixel, self.distance(), size);
        self.height = (self.height * factor).clamp(HEIGHT_RANGE.0, HEIGHT_RANGE.1);
        let after = self.point_at(pixel, self.distance(), size);
        self.target += before - after;
    }

    /// Looks at the middle of a box so that all of it is in the picture, from the direction in which it looks now.
    pub fn frame(&mut self, bounds: &Bounds, aspect: f64) {
        self.target = bounds.center();
        let view_from_world = self.world_from_view().transpose();
        let corners = bounds.corners().map(|corner| view_from_world * (corner - self.target));
        // In a perspective a point of depth z before the target plane is seen larger by d / (d - z), and d is
        // proportional to the height that is looked for: |y| d = h/2 (d - z) gives h = 2 |y| + z h / d.
        let per_height = self.distance() / self.height;
        let fits = |corner: &DVec3| {
            let across = corner.y.abs().max(corner.x.abs() / aspect);
            let closer = if per_height > 0.0 { corner.z / per_height } else { 0.0 };
            MARGIN * 2.0 * across + closer
        };
        let height = corners.iter().map(fits).fold(0.0, f64::max);
        self.height = if height > 0.0 { height } else { 1.0 }.clamp(HEIGHT_RANGE.0, HEIGHT_RANGE.1);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIZE: DVec2 = DVec2::new(1280.0, 800.0);

    fn cameras() -> Vec<Camera> {
        use Facing::{Back, Bottom, Front, OtherSide, Side, Top};
        let mut cameras: Vec<Camera> = [Front, Back, Side, OtherSide, Top, Bottom].map(Camera::facing).to_vec();
        cameras.push(Camera::perspective());
        for camera in &mut cameras {
            camera.target = DVec3::new(1e3, 2.0, -7.0);
            camera.height = 0.1;
        }
        cameras
    }

    #[test]
    fn a_projected_point_is_found_again() {
        for camera in cameras() {
            for point in [DVec3::ZERO, DVec3::new(0.02, -0.01, 0.03), DVec3::new(-0.03, 0.04, -0.05)] {
                let point = camera.target + point;
                let seen = camera.project(point, SIZE).unwrap();
                assert!(camera.point_at(seen.pixel, seen.depth, SIZE).distance(point) < 1e-9, "{camera:?}");
                let ray = camera.ray(seen.pixel, SIZE);
                let off = (point - ray.origin).reject_from(ray.direction);
                assert!(off.length() < 1e-9 && ray.direction.dot(point - ray.origin) > 0.0);
            }
        }
    }

    #[test]
    fn drawing_views_run_as_they_say() {
        let seen = |facing, point: DVec3| Camera::facing(facing).project(point, DVec2::splat(100.0)).unwrap();
        assert!(seen(Facing::Front, DVec3::X * 0.1).pixel.abs_diff_eq(DVec2::new(60.0, 50.0), 1e-9));
        assert!(seen(Facing::Front, DVec3::Y * 0.1).pixel.abs_diff_eq(DVec2::new(50.0, 40.0), 1e-9));
        assert!(seen(Facing::Side, DVec3::Z * 0.1).pixel.abs_diff_eq(DVec2::new(60.0, 50.0), 1e-9));
        assert!(seen(Facing::Side, DVec3::Y * 0.1).pixel.abs_diff_eq(DVec2::new(50.0, 40.0), 1e-9));
        assert!(seen(Facing::Top, DVec3::X * 0.1).pixel.abs_diff_eq(DVec2::new(60.0, 50.0), 1e-9));
        assert!(seen(Facing::Top, DVec3::Z * 0.1).pixel.abs_diff_eq(DVec2::new(50.0, 60.0), 1e-9));
        assert!(seen(Facing::Front, DVec3::Z).depth < seen(Facing::Front, DVec3::ZERO).depth);
    }

    #[test]
    fn depth_is_reversed_and_stays_within_clip_space() {
        for camera in cameras() {
            let depth = |toward: f64| {
                let view = DVec3::Z * (toward - camera.distance());
                let clip = camera.clip_from_view(1.6) * view.extend(1.0);
                clip.z / clip.w
            };
            assert!(0.0 < depth(-5.0) && depth(-5.0) < depth(0.0) && depth(0.0) < depth(0.1) && depth(0.1) < 1.0);
        }
    }

    #[test]
    fn what_is_framed_is_in_the_picture_and_fills_it() {
        let boxes = [DVec3::new(0.04, 0.07, 0.04), DVec3::new(1e3, 1.0, 2.0), DVec3::new(1e-3, 0.0, 0.0)];
        for extent in boxes {
            let bounds = Bounds { min: DVec3::splat(5.0), max: DVec3::splat(5.0) + extent };
            for mut camera in cameras() {
                for size in [SIZE, DVec2::new(300.0, 900.0)] {
                    camera.frame(&bounds, size.x / size.y);
                    let reach = bounds
                        .corners()
                        .map(|corner| camera.project(corner, size).unwrap().pixel / size * 2.0 - 1.0)
                        .map(|seen| seen.abs().max_element());
                    let most = reach.into_iter().fold(0.0, f64::max);
                    let point_like = reach.iter().all(|reach| *reach < 1e-6);
                    assert!(most < 1.0 && (most > 0.55 || point_like), "{most} {camera:?}");
                }
            }
        }
    }

    #[test]
    fn zooming_keeps_what_is_under_the_pointer_and_panning_moves_with_it() {
        for mut camera in cameras() {
            let pixel = DVec2::new(200.0, 650.0);
            let point = camera.point_at(pixel, camera.distance(), SIZE);
            camera.zoom(0.5, pixel, SIZE);
            assert!(camera.project(point, SIZE).unwrap().pixel.distance(pixel) < 1e-6);
            camera.pan(DVec2::new(30.0, -40.0), SIZE);
            assert!(camera.project(point, SIZE).unwrap().pixel.distance(pixel + DVec2::new(30.0, -40.0)) < 1e-6);
        }
    }
}
