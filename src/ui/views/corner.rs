//! The controls in the corners of the views: what a drawing view shows, from where the result is watched.

use super::camera::{change_projection, face};
use super::kind::{PaneKind, view_name};
use super::legend::legend;
use super::links::Links;
use super::options::ViewOptions;
use super::pane::Pane;
use crate::draw::Theme;
use crate::render::{Facing, Projection};
use crate::sketch::View;
use crate::ui::action::Action;
use crate::ui::context::{Context, Request};
use crate::ui::controls::key_of;
use crate::ui::theme::{self, GRID, Tone};
use egui::{Align2, Button, FontId, Pos2, Rect, Sense, Stroke, Ui, UiBuilder, Vec2};
use glam::DVec3;

/// Width of a view [points] below which its buttons draw in.
const ROOMY: f32 = 210.0;
/// Reach of the axes gizmo [points].
const REACH: f32 = 30.0;
/// Radius of the balls at its ends [points].
const BALL: f32 = 8.0;

/// The controls in the corners of a view.
pub(super) fn corner(pane: &mut Pane, ui: &mut Ui, options: &mut ViewOptions, links: &mut Links, cx: &mut Context) {
    let rect = pane.rect;
    let mut bar = Rect::from_min_max(rect.min + Vec2::splat(2.0 * GRID), rect.max);
    if pane.kind == PaneKind::Result {
        // Room for the axes.
        bar.max.x = (bar.max.x - 2.0 * REACH - 8.0 * GRID).max(bar.min.x + 2.0 * REACH);
    }
    let mut child = ui.new_child(UiBuilder::new().max_rect(bar));
    match pane.kind {
        PaneKind::Drawing(view) => child.horizontal(|ui| {
            if bar.width() < ROOMY {
                ui.spacing_mut().button_padding.x = GRID;
            }
            choose_view(ui, view, links);
            choose_tool(ui, cx);
        }),
        PaneKind::Result => child.horizontal_wrapped(|ui| {
            choose_projection(pane, ui);
            options.menus(ui, cx);
        }),
    };
    if pane.kind == PaneKind::Result {
        legend(&mut child, cx);
        gizmo(pane, ui, cx.tone);
    }
}

fn choose_view(ui: &mut Ui, view: View, links: &mut Links) {
    let menu = ui.menu_button(view_name(view), |ui| {
        for other in [View::Front, View::Side, View::Top] {
            if ui.selectable_label(other == view, view_name(other)).clicked() {
                if other != view {
                    links.turned = Some((view, other));
                }
                ui.close();
            }
        }
    });
    menu.response.on_hover_text("Which side this view draws; the other drawing view makes room");
}

/// Shows what a drag does here, and changes it.
fn choose_tool(ui: &mut Ui, cx: &mut Context) {
    ui.spacing_mut().item_spacing.x = 0.5 * GRID;
    for (action, name) in [(Action::DrawTool, "Draw"), (Action::SheetTool, "Sheet"), (Action::SelectTool, "Select")] {
        let is_in_hand = cx.actions[action].on == Some(true);
        let tooltip = format!("{} ({})", action.tooltip(), key_of(ui, action));
        let button = ui.add(Button::selectable(is_in_hand, name).frame_when_inactive(true)).on_hover_text(tooltip);
        if button.clicked() {
            cx.request(Request::Do(action));
        }
    }
}

fn choose_projection(pane: &mut Pane, ui: &mut Ui) {
    let parallel = pane.camera.projection == Projection::Parallel;
    let text = if parallel { "Parallel" } else { "Perspective" };
    if ui.button(text).on_hover_text("Between perspective and parallel lines (5)").clicked() {
        change_projection(pane);
    }
}

/// The world's axes as the camera sees them; a click on an end looks from there.
fn gizmo(pane: &mut Pane, ui: &Ui, tone: Tone) {
    let rect = pane.rect;
    let center = Pos2::new(rect.right() - REACH - 4.0 * GRID, rect.top() + REACH + 4.0 * GRID);
    if rect.width() < 6.0 * REACH || rect.height() < 4.0 * REACH {
        return;
    }
    let view = pane.camera.world_from_view().transpose();
    let theme: Theme = tone.pictures();
    // The side view looks from -X, as drawings do: that end carries the letter's name in the tooltip.
    let ends = [
        (DVec3::X, 0, "X", Facing::OtherSide, "From the right (Ctrl+3)"),
        (DVec3::Y, 1, "Y", Facing::Top, "From above (7)"),
        (DVec3::Z, 2, "Z", Facing::Front, "From the front (1)"),
        (DVec3::NEG_X, 0, "", Facing::Side, "From the side that is drawn (3)"),
        (DVec3::NEG_Y, 1, "", Facing::Bottom, "From below (Ctrl+7)"),
        (DVec3::NEG_Z, 2, "", Facing::Back, "From behind (Ctrl+1)"),
    ];
    let mut seen: Vec<_> = ends.iter().map(|end| (view * end.0, end)).collect();
    seen.sort_by(|a, b| a.0.z.total_cmp(&b.0.z));
    let painter = ui.painter_at(rect);
    for (toward, (_, axis, letter, facing, tooltip)) in seen {
        let at = center + REACH * Vec2::new(toward.x as f32, -toward.y as f32);
        let colour = theme::color(theme.axes[*axis]);
        let spot = Rect::from_center_size(at, Vec2::splat(2.0 * BALL));
        let id = ui.scope_id().with(("axis", tooltip));
        let response = ui.interact(spot, id, Sense::click());
        response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, *tooltip));
        let hovered = response.hovered();
        if letter.is_empty() {
            let fill = colour.gamma_multiply(if hovered { 0.8 } else { 0.25 });
            painter.circle(at, 0.75 * BALL, fill, Stroke::new(1.0, colour.gamma_multiply(0.8)));
        } else {
            painter.line_segment([center, at], Stroke::new(2.0, colour));
            painter.circle_filled(at, if hovered { 1.15 * BALL } else { BALL }, colour);
            let ink = theme::color(theme.background_bottom);
            painter.text(at, Align2::CENTER_CENTER, letter, FontId::proportional(11.0), ink);
        }
        if response.on_hover_text(*tooltip).clicked() {
            face(pane, ui, *facing);
        }
    }
}
