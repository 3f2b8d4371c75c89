//! Bodies that have left the result view: an arrow at its edge says where they are and brings them back.

use super::frame::ViewFrame;
use crate::render::Camera;
use crate::ui::action::Action;
use crate::ui::context::{Context, Request};
use crate::ui::controls::key_of;
use crate::ui::theme::{self, GRID};
use egui::{Align2, FontId, Pos2, Rect, Role, Sense, Shape, Stroke, Ui, Vec2};
use glam::DVec3;

/// Points of a body that are looked for in the view.
const LOOKED_FOR: usize = 200;
/// Size of the arrow, and its distance from the edge [points].
const ARROW: f32 = 14.0;
const FROM_EDGE: f32 = 9.0 * GRID;

/// Points at the bodies where none of them is in sight, and fits the view to them when clicked.
pub(super) fn point_at_bodies(ui: &mut Ui, frame: &ViewFrame, cx: &mut Context) {
    let bodies = &cx.simulation.published().snapshot.bodies;
    let count: usize = bodies.iter().map(|body| body.particles.len()).sum();
    if count == 0 || !frame.rect.is_positive() {
        return;
    }
    let all = || bodies.iter().flat_map(|body| body.particles.iter().copied());
    let every = count.div_ceil(LOOKED_FOR);
    let is_seen = |point: DVec3| frame.screen(point).is_some_and(|at| frame.rect.contains(at));
    if all().step_by(every).any(is_seen) {
        return;
    }
    let middle = all().sum::<DVec3>() / count as f64;
    let toward = direction(&frame.camera, middle);
    let room = frame.rect.shrink(FROM_EDGE);
    let at = at_edge(room, toward);
    let spot = Rect::from_center_size(at, Vec2::splat(2.0 * ARROW + 2.0 * GRID));
    let response = ui.interact(spot, ui.scope_id().with("out of sight"), Sense::click());
    let name = "The bodies are out of sight: show them";
    response.widget_info(|| egui::WidgetInfo::labeled(Role::Button, true, name));
    let painter = ui.painter_at(frame.rect);
    let pictures = cx.tone.pictures();
    let accent = theme::color(pictures.accent);
    let size = if response.hovered() { 1.2 * ARROW } else { ARROW };
    let side = 0.6 * size * toward.rot90();
    let tip = at + size * toward;
    let back = at - 0.7 * size * toward;
    let edge = Stroke::new(1.0, theme::color(pictures.background_bottom));
    painter.add(Shape::convex_polygon(vec![tip, back + side, back - side], accent, edge));
    let words = Align2([align(toward.x), align(toward.y)]);
    let beside = at - 2.2 * ARROW * toward;
    let text = format!("Out of sight ({})", key_of(ui, Action::FrameAll));
    painter.text(beside, words, text, FontId::proportional(12.0), theme::color(pictures.text));
    if response.on_hover_text(name).clicked() {
        cx.request(Request::Do(Action::FrameAll));
    }
}

/// Words stand on the inner side of what points outwards.
fn align(toward: f32) -> egui::Align {
    match toward {
        along if along > 0.4 => egui::Align::Max,
        along if along < -0.4 => egui::Align::Min,
        _ => egui::Align::Center,
    }
}

/// The direction on the screen in which a point [m] lies, of unit length; down for one right behind the eye.
fn direction(camera: &Camera, point: DVec3) -> Vec2 {
    let seen = camera.world_from_view().transpose() * (point - camera.target);
    let along = Vec2::new(seen.x as f32, -seen.y as f32);
    if along.length() > 0.0 && along.is_finite() { along.normalized() } else { Vec2::DOWN }
}

/// Where a line from the middle of a room leaves it.
fn at_edge(room: Rect, toward: Vec2) -> Pos2 {
    let half = 0.5 * room.size();
    let times = [half.x / toward.x.abs().max(1e-6), half.y / toward.y.abs().max(1e-6)];
    room.center() + times[0].min(times[1]).max(0.0) * toward
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_points_to_the_side_on_which_a_point_lies() {
        let camera = Camera::perspective();
        let axes = camera.world_from_view();
        for (way, expected) in [(axes.x_axis, Vec2::RIGHT), (axes.y_axis, Vec2::UP), (DVec3::ZERO, Vec2::DOWN)] {
            assert!((direction(&camera, camera.target + 9.0 * way) - expected).length() < 1e-6, "{expected:?}");
        }
        let room = Rect::from_min_size(Pos2::ZERO, Vec2::new(100.0, 50.0));
        assert_eq!(at_edge(room, Vec2::RIGHT), Pos2::new(100.0, 25.0));
        assert_eq!(at_edge(room, Vec2::UP), Pos2::new(50.0, 0.0));
    }
}
