//! Where a view lies and from where it looks: between points of the window and points in space.

use super::kind::PaneKind;
use crate::render::Camera;
use crate::sketch::View;
use egui::{Pos2, Rect};
use glam::{DVec2, DVec3};

/// A view as it is shown in this frame.
#[derive(Clone, Copy)]
pub(crate) struct ViewFrame {
    /// What it is for.
    pub kind: PaneKind,
    /// Where it lies in the window.
    pub rect: Rect,
    /// From where it looks.
    pub camera: Camera,
}

impl ViewFrame {
    /// Its width and height [points].
    pub(crate) fn size(&self) -> DVec2 {
        DVec2::new(f64::from(self.rect.width()), f64::from(self.rect.height()))
    }

    /// A point of the window counted from the view's corner [points].
    pub(crate) fn pixel(&self, at: Pos2) -> DVec2 {
        DVec2::new(f64::from(at.x - self.rect.min.x), f64::from(at.y - self.rect.min.y))
    }

    /// Where a point in space [m] is shown; none behind the eye.
    pub(crate) fn screen(&self, point: DVec3) -> Option<Pos2> {
        let pixel = self.camera.project(point, self.size())?.pixel;
        Some(self.rect.min + egui::vec2(pixel.x as f32, pixel.y as f32))
    }

    /// The point of a drawing view's plane under a pixel, in the view's own coordinates [m].
    pub(crate) fn drawn(&self, view: View, at: Pos2) -> DVec2 {
        view.project(self.camera.ray(self.pixel(at), self.size()).origin)
    }

    /// Where a drawing view shows a point of its plane.
    pub(crate) fn shown(&self, view: View, point: DVec2) -> Option<Pos2> {
        let mut space = self.camera.target;
        let [horizontal, vertical] = view.axes();
        space[horizontal] = point.x;
        space[vertical] = point.y;
        self.screen(space)
    }
}
