//! One view while it is shown: whom the pointer belongs to, and what is painted in which order.

use super::camera;
use super::context_menu::context_menu;
use super::corner::corner;
use super::displayed::DisplayedState;
use super::drawing_tool::DrawingTool;
use super::frame::ViewFrame;
use super::grab::grab;
use super::kind::PaneKind;
use super::links::Links;
use super::options::ViewOptions;
use super::out_of_sight::point_at_bodies;
use super::overlay::{paint_result, paint_title};
use super::pane::Pane;
use super::picture::{Painter, ViewInputs};
use super::pins::{follows, pins};
use super::region::{RegionTool, paint_pattern};
use super::sketching::Sketching;
use super::strokes::paint_strokes;
use crate::draw::{Display, SkinStyle};
use crate::ui::context::Context;
use crate::ui::editing::{self, Allowed, Editing};
use crate::ui::runs::tints;
use crate::ui::theme;
use egui::{Sense, Ui};
use std::sync::Arc;

/// What the pointer can do in the views.
#[derive(Default)]
pub(super) struct Tools {
    /// Draws fibres.
    pub sketching: Sketching,
    /// Selects, moves and paints.
    pub editing: Editing,
    /// Drags a box around what a pattern fills.
    pub region: RegionTool,
    /// What drags in the drawing views do.
    pub drawing: DrawingTool,
}

impl Tools {
    /// What drags in the drawing views do: while vertices are edited, nothing is drawn.
    pub(super) fn drawing(&self, cx: &Context) -> DrawingTool {
        if cx.selection.vertices().is_some() { DrawingTool::Select } else { self.drawing }
    }

    /// What the pointer may do in a view besides that.
    fn allowed(&self, kind: PaneKind, cx: &Context) -> Allowed {
        let selects = self.drawing(cx) == DrawingTool::Select;
        match kind {
            PaneKind::Drawing(_) => Allowed { handles: selects, boxes: selects },
            // Nor is what is drawn disturbed by handles.
            PaneKind::Result => Allowed { handles: self.sketching.tool.first().is_none(), boxes: false },
        }
    }
}

/// Shows a view in the room that is left.
pub(super) fn show(
    pane: &mut Pane,
    ui: &mut Ui,
    tools: &mut Tools,
    options: &mut ViewOptions,
    links: &mut Links,
    painter: Option<&Painter>,
    cx: &mut Context,
) {
    let rect = ui.available_rect_before_wrap();
    let response = ui.allocate_rect(rect, Sense::click_and_drag());
    let label = format!("{} view", pane.kind.title());
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Canvas, true, &label));
    pane.rect = rect;
    camera::settle(pane, ui, links, options.follow, cx);
    camera::follow(pane, ui, &response, links, cx.navigation);
    let frame = ViewFrame { kind: pane.kind, rect, camera: pane.camera };
    let slice = options.display.slice;
    let takes_region = !tools.editing.has_gesture() && tools.region.follow(ui, &response, &frame, cx);
    let allowed = tools.allowed(pane.kind, cx);
    if !takes_region {
        editing::take_pointer(&mut tools.editing, ui, &response, &frame, slice, allowed, cx);
    }
    match frame.kind {
        _ if takes_region => {}
        _ if tools.editing.has_pointer(frame.kind) => {}
        PaneKind::Drawing(view) if tools.drawing(cx) != DrawingTool::Select => {
            tools.sketching.draw(ui, &response, view, &frame, cx);
        }
        PaneKind::Drawing(_) => {}
        PaneKind::Result => grab(ui, &response, &frame, slice, cx),
    }
    let opens = response.secondary_clicked() && tools.editing.opens_menu();
    if let Some(at) = ui.input(|input| input.pointer.interact_pos()).filter(|_| opens) {
        editing::choose_at(&frame, at, slice, cx);
    }
    context_menu(&response, frame.kind, opens, cx);
    paint_picture(pane, ui, &options.display, painter, cx);
    match frame.kind {
        PaneKind::Drawing(view) => paint_strokes(&tools.sketching, ui, view, &frame, cx),
        PaneKind::Result => paint_result(&tools.sketching, ui, &frame, cx),
    }
    editing::paint(&tools.editing, ui, &frame, slice, tools.allowed(pane.kind, cx), cx);
    paint_pattern(ui, &frame, cx);
    paint_title(&tools.sketching, ui, &frame, cx);
    corner(pane, ui, options, links, cx);
    if frame.kind == PaneKind::Result {
        point_at_bodies(ui, &frame, cx);
    }
    follows(ui, &frame, cx);
    pins(ui, &frame, cx);
}

fn paint_picture(pane: &mut Pane, ui: &Ui, result: &Display, painter: Option<&Painter>, cx: &Context) {
    if ui.ctx().will_discard() {
        // More of the frame's input waits; what it comes to is drawn.
        return;
    }
    let state = DisplayedState::of(pane.kind, cx);
    let selected = selected(&state, cx);
    let selected_sheets = selected_sheets(&state, cx);
    let display = match pane.kind {
        PaneKind::Drawing(_) => {
            let first_body = cx.active.index;
            let skin = SkinStyle::XRay;
            Display { skin, room: false, selected, selected_sheets, first_body, ..Display::default() }
        }
        PaneKind::Result => Display { selected, selected_sheets, tints: tints(cx), ..result.clone() },
    };
    let theme = cx.tone.pictures();
    let (scene, ghost_aside) = (Arc::clone(cx.scene()), cx.ghost_aside());
    let inputs = ViewInputs { state, scene, display, tone: cx.tone, ghost_aside };
    let scale = ui.ctx().pixels_per_point();
    let shown = painter.and_then(|painter| painter.paint(&mut pane.picture, inputs, &pane.camera, pane.rect, scale));
    if let Some(shown) = shown {
        ui.painter().add(shown);
    } else {
        ui.painter().rect_filled(pane.rect, 0.0, theme::color(theme.background_bottom));
    }
}

/// Selected fibres as the picture counts them.
fn selected(state: &DisplayedState, cx: &Context) -> Vec<[u32; 2]> {
    let body = state.active(cx);
    let fibres = state.bodies.get(body).into_iter().flat_map(|body| body.fibres.iter().enumerate());
    fibres.filter(|(_, fibre)| cx.selection.contains(&fibre.id)).map(|(k, _)| [body as u32, k as u32]).collect()
}

/// The selected sheet, likewise.
fn selected_sheets(state: &DisplayedState, cx: &Context) -> Vec<[u32; 2]> {
    let body = state.active(cx);
    let sheets = state.bodies.get(body).into_iter().flat_map(|body| body.sheets.iter().enumerate());
    let chosen = cx.selection.sheet();
    sheets.filter(|(_, sheet)| Some(&sheet.id) == chosen).map(|(k, _)| [body as u32, k as u32]).collect()
}
