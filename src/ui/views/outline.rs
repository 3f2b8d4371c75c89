//! The outline around the body that is selected, in the result view.

use super::displayed::DisplayedState;
use super::frame::ViewFrame;
use crate::scene::AnyBody;
use crate::solver::snapshot::BodySnapshot;
use crate::ui::context::Context;
use crate::ui::theme;
use egui::{Painter, Pos2, Shape, Stroke, Vec2};

/// Points of a body that are looked at, at most.
const POINTS: usize = 3000;
/// How far from the outermost particles the outline runs [points].
const AWAY: f32 = 7.0;
const WIDTH: f32 = 1.5;

/// Paints a line around the body that is selected.
pub(super) fn paint_outline(painter: &Painter, frame: &ViewFrame, cx: &Context) {
    if cx.chosen_body().is_none_or(AnyBody::hidden) || cx.simulation.is_comparing() {
        return;
    }
    let shown = DisplayedState::of(frame.kind, cx);
    // A copy that is moved stands behind the bodies that are there.
    let last = shown.bodies.len().saturating_sub(1);
    let count = cx.scene().all_bodies().count();
    let index = if cx.placed.is_some() && last == count { last } else { cx.active.index };
    let Some(body) = shown.bodies.get(index) else { return };
    let seen = seen(body, frame);
    let middle = seen.iter().fold(Vec2::ZERO, |sum, at| sum + at.to_vec2()) / seen.len().max(1) as f32;
    let out = |at: Pos2| at + AWAY * (at.to_vec2() - middle).normalized();
    let around: Vec<Pos2> = hull(seen).into_iter().map(out).collect();
    if around.len() > 2 {
        let accent = theme::color(cx.tone.pictures().accent);
        painter.add(Shape::closed_line(around, Stroke::new(WIDTH, accent)));
    }
}

fn seen(body: &BodySnapshot, frame: &ViewFrame) -> Vec<Pos2> {
    let every = body.particles.len().div_ceil(POINTS).max(1);
    body.particles.iter().step_by(every).filter_map(|&at| frame.screen(at)).filter(|at| at.is_finite()).collect()
}

/// The corners of the smallest polygon without a dent around points, in order (Andrew's monotone chain).
fn hull(mut points: Vec<Pos2>) -> Vec<Pos2> {
    points.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    points.dedup();
    if points.len() < 3 {
        return points;
    }
    let chain = |points: &mut dyn Iterator<Item = Pos2>| {
        let mut side: Vec<Pos2> = Vec::new();
        for next in points {
            while let [.., before, last] = side[..]
                && (last - before).rot90().dot(next - before) >= 0.0
            {
                side.pop();
            }
            side.push(next);
        }
        side.pop();
        side
    };
    let mut around = chain(&mut points.iter().copied());
    around.extend(chain(&mut points.iter().rev().copied()));
    around
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_hull_of_a_square_with_points_within_is_the_square() {
        let corners = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)];
        let within = [(1.0, 1.0), (2.0, 3.0), (2.0, 0.0), (3.9, 3.9)];
        let points = corners.iter().chain(&within).map(|&(x, y)| Pos2::new(x, y)).collect();
        let mut found = hull(points);
        assert_eq!(found.len(), 4, "{found:?}");
        found.sort_by(|a, b| (a.x + 10.0 * a.y).total_cmp(&(b.x + 10.0 * b.y)));
        assert_eq!(found, [(0.0, 0.0), (4.0, 0.0), (0.0, 4.0), (4.0, 4.0)].map(|(x, y)| Pos2::new(x, y)));
    }
}
