//! How the three views lie beside each other and what links them.

use super::drawing_tool::DrawingTool;
use super::frame::ViewFrame;
use super::kind::PaneKind;
use super::links::Links;
use super::options::ViewOptions;
use super::pane::Pane;
use super::picture::Painter;
use super::region::RegionTool;
use super::sketch_tool::Makes;
use super::sketching::Sketching;
use super::view::{Tools, show};
use crate::render::{Camera, RenderError};
use crate::sketch::View;
use crate::transfer::{Look, Viewpoint};
use crate::ui::context::Context;
use crate::ui::editing::{self, Editing, Kind};
use egui::{PointerButton, Pos2, Rect, Ui};
use egui_tiles::{Behavior, Container, Linear, LinearDir, Tile, TileId, Tiles, Tree, UiResponse};
use glam::DVec3;

/// The views and what is done in them.
pub(crate) struct Views {
    panes: Tree<Pane>,
    links: Links,
    painter: Option<Painter>,
    /// What is seen of the bodies.
    pub options: ViewOptions,
    tools: Tools,
}

/// Front and side stacked beside the result.
fn usual_layout() -> Tree<Pane> {
    let mut tiles = Tiles::default();
    let front = tiles.insert_pane(Pane::new(PaneKind::Drawing(View::Front)));
    let side = tiles.insert_pane(Pane::new(PaneKind::Drawing(View::Side)));
    let drawing = tiles.insert_vertical_tile(vec![front, side]);
    let result = tiles.insert_pane(Pane::new(PaneKind::Result));
    let mut row = Linear::new(LinearDir::Horizontal, vec![drawing, result]);
    row.shares.set_share(drawing, 0.75);
    row.shares.set_share(result, 1.25);
    let root = tiles.insert_container(Container::Linear(row));
    Tree::new(egui::Id::unique("views"), root, tiles)
}

/// Whether there are two different drawing views and a result, as there must be.
fn is_whole(views: &Tree<Pane>) -> bool {
    let kinds: Vec<PaneKind> = panes(views).map(|pane| pane.kind).collect();
    let drawn = |kind: &&PaneKind| matches!(kind, PaneKind::Drawing(_));
    let drawing: Vec<&PaneKind> = kinds.iter().filter(drawn).collect();
    kinds.len() == 3 && drawing.len() == 2 && drawing[0] != drawing[1]
}

fn panes(views: &Tree<Pane>) -> impl Iterator<Item = &Pane> {
    views.tiles.iter().filter_map(|(_, tile)| match tile {
        Tile::Pane(pane) => Some(pane),
        Tile::Container(_) => None,
    })
}

/// The drawing views and where they lay in the last frame; none before the first.
fn drawing_views(views: &Tree<Pane>) -> Vec<(View, Rect)> {
    let drawing = panes(views).filter_map(|pane| match pane.kind {
        PaneKind::Drawing(view) => Some((view, pane.rect)),
        PaneKind::Result => None,
    });
    drawing.filter(|(_, rect)| rect.is_positive()).collect()
}

impl Views {
    /// The views at the first start. Without a painter nothing is painted into them, but everything else works.
    pub(crate) fn new(painter: Option<Painter>) -> Self {
        Self {
            panes: usual_layout(),
            links: Links::default(),
            painter,
            options: ViewOptions::default(),
            tools: Tools::default(),
        }
    }

    /// Goes on with the views of the last time, unless they are not as they must be.
    pub(crate) fn recall(&mut self, views: Tree<Pane>, coach: bool) {
        if is_whole(&views) {
            self.panes = views;
        }
        self.tools.sketching.coach = coach;
    }

    /// The views as they lie, to be remembered.
    pub(crate) fn panes(&self) -> &Tree<Pane> {
        &self.panes
    }

    /// Whether the coach still explains the first fibre.
    pub(crate) fn coach(&self) -> bool {
        self.tools.sketching.coach
    }

    /// Shows the views.
    pub(crate) fn show(&mut self, ui: &mut Ui, cx: &mut Context) {
        egui::CentralPanel::default().frame(egui::Frame::NONE).show(ui, |ui| {
            self.links.drawing = drawing_views(&self.panes);
            let Self { panes, links, painter, options, tools } = self;
            let mut layout = Layout { links, painter: painter.as_ref(), options, tools, cx };
            panes.ui(&mut layout, ui);
        });
        self.turn_views();
        self.link_views();
        if ui.input(|input| input.pointer.button_released(PointerButton::Secondary)) {
            self.tools.editing.note_release();
        }
        if !self.tools.editing.has_gesture() {
            // However a gesture has ended, what it showed is gone.
            cx.placed = None;
        }
        cx.status.gesture = self.tools.editing.hint();
        cx.status.strokes = self.tools.sketching.tool.stage().number();
        cx.status.offers_stretch = self.tools.sketching.is_refused();
        if cx.simulation.is_playing() {
            // Should a notification be missed, the next picture still comes.
            ui.ctx().request_repaint_after_secs(0.1);
        }
    }

    /// What is drawn.
    pub(crate) fn sketching(&mut self) -> &mut Sketching {
        &mut self.tools.sketching
    }

    /// Vertices of the surface that strokes sweep so far, model frame [m].
    pub(crate) fn swept_preview(&self, cx: &Context) -> Vec<DVec3> {
        let sketching = &self.tools.sketching;
        let swept = sketching.tool.swept_preview(cx.sampling()).filter(|_| sketching.makes == Makes::Sheet);
        swept.map_or_else(Vec::new, |swept| swept.vertices.clone())
    }

    /// What drags in the drawing views do.
    pub(crate) fn drawing_tool(&self, cx: &Context) -> DrawingTool {
        self.tools.drawing(cx)
    }

    /// Takes another tool in hand for the drawing views.
    pub(crate) fn take_in_hand(&mut self, tool: DrawingTool, cx: &mut Context) {
        self.tools.drawing = tool;
        match tool {
            DrawingTool::Draw => self.tools.sketching.makes = Makes::Fibre,
            DrawingTool::Sheet => self.tools.sketching.makes = Makes::Sheet,
            DrawingTool::Select => {}
        }
        if tool == DrawingTool::Draw {
            cx.selection.enter_vertices(false);
        }
    }

    /// Whether the next stroke takes the place of the selected fibre's.
    pub(crate) fn redraws(&self) -> bool {
        self.tools.sketching.redraws
    }

    /// What is being done to what is selected.
    pub(crate) fn editing(&self) -> &Editing {
        &self.tools.editing
    }

    /// As [`Self::editing`], to do something.
    pub(crate) fn editing_mut(&mut self) -> &mut Editing {
        &mut self.tools.editing
    }

    /// Forgets what is drawn, dragged and done so far: another body or document is drawn into.
    pub(crate) fn forget_gestures(&mut self) {
        self.tools.editing = Editing::default();
        self.tools.region = RegionTool::default();
        self.tools.sketching.forget();
    }

    /// Begins a gesture under the pointer, in the view where that is, or else in the result.
    pub(crate) fn begin_at_pointer(&mut self, ctx: &egui::Context, kind: Kind, cx: &mut Context) {
        let pointer = ctx.input(|input| input.pointer.latest_pos());
        let frames = self.frames();
        let under = |frame: &&ViewFrame| pointer.is_some_and(|at| frame.rect.contains(at));
        let result = || frames.iter().find(|frame| frame.kind == PaneKind::Result);
        let Some(ViewFrame { kind: view, rect, .. }) = frames.iter().find(under).or_else(result).copied() else {
            return;
        };
        let start: Pos2 = pointer.filter(|at| rect.contains(*at)).unwrap_or_else(|| rect.center());
        editing::begin_moving(&mut self.tools.editing, kind, None, view, start, false, cx);
    }

    /// Whether pictures are drawn in software; none where none are drawn.
    pub(crate) fn draws_in_software(&self) -> Option<bool> {
        self.painter.as_ref().map(Painter::saves_work)
    }

    /// What draws the pictures; none where none are drawn.
    pub(crate) fn adapter(&self) -> Option<String> {
        self.painter.as_ref().map(Painter::adapter)
    }

    /// How pictures look that are made of what the result view shows, as large as it is.
    pub(crate) fn look(&self, cx: &Context, pixels_per_point: f32) -> Look {
        let result = self.frames().into_iter().find(|frame| frame.kind == PaneKind::Result);
        let camera = result.map_or_else(Camera::perspective, |frame| frame.camera);
        // Even, as players of moving pictures like them.
        let extent = |points: f32| ((points * pixels_per_point / 2.0).round() as u32 * 2).clamp(64, 8192);
        let size = result.map_or([1280, 720], |frame| [extent(frame.rect.width()), extent(frame.rect.height())]);
        Look {
            view: Viewpoint::Placed(camera),
            size,
            display: self.options.display.clone(),
            theme: cx.tone.pictures(),
            field: self.options.field(),
            tension: self.options.tension,
            activation: self.options.activation,
        }
    }

    fn result(&self) -> Option<&Pane> {
        panes(&self.panes).find(|pane| pane.kind == PaneKind::Result)
    }

    /// Whether the result view has been drawn.
    pub(crate) fn has_picture(&self) -> bool {
        self.painter.is_some() && self.result().is_some_and(|pane| pane.picture.is_drawn())
    }

    /// The picture of the result view as it was drawn last, without what is written over it; none before it was.
    pub(crate) fn result_picture(&self) -> Option<Result<crate::render::Picture, RenderError>> {
        self.painter.as_ref()?.picture(&self.result()?.picture)
    }

    /// Where the result view shows a point of the world [m]; none behind its eye.
    pub(crate) fn shown_at(&self, point: DVec3) -> Option<Pos2> {
        self.frames().into_iter().find(|frame| frame.kind == PaneKind::Result)?.screen(point)
    }

    /// The views, where they lay in the last frame and from where they look.
    pub(crate) fn frames(&self) -> Vec<ViewFrame> {
        let frame = |pane: &Pane| ViewFrame { kind: pane.kind, rect: pane.rect, camera: pane.camera };
        panes(&self.panes).map(frame).collect()
    }

    fn panes_mut(&mut self) -> impl Iterator<Item = &mut Pane> {
        self.panes.tiles.iter_mut().filter_map(|(_, tile)| match tile {
            Tile::Pane(pane) => Some(pane),
            Tile::Container(_) => None,
        })
    }

    /// Fits every view again as soon as there is something to fit: the selected fibre or everything.
    pub(crate) fn reframe(&mut self, selected: bool) {
        self.links.fits_selected = selected;
        for pane in self.panes_mut() {
            pane.framed = false;
        }
    }

    /// A drawing view shows another side; where the other one shows that already, they change places.
    fn turn_views(&mut self) {
        let Some((old, new)) = self.links.turned.take() else { return };
        for pane in self.panes_mut() {
            let kind = match pane.kind {
                PaneKind::Drawing(view) if view == old => PaneKind::Drawing(new),
                PaneKind::Drawing(view) if view == new => PaneKind::Drawing(old),
                // Both are fitted anew, to one scale.
                PaneKind::Drawing(view) => PaneKind::Drawing(view),
                PaneKind::Result => continue,
            };
            *pane = Pane { rect: pane.rect, ..Pane::new(kind) };
        }
    }

    /// The drawing views are linked along the axis that they share: what one has moved, the other follows.
    fn link_views(&mut self) {
        let Some((view, from)) = self.links.moved.take() else { return };
        for pane in self.panes_mut() {
            if let PaneKind::Drawing(other) = pane.kind
                && let Some(axis) = view.shared_axis(other)
            {
                pane.camera.height = from.height;
                pane.camera.target[axis] = from.target[axis];
            }
        }
    }
}

/// Shows each view in its tile.
struct Layout<'a> {
    links: &'a mut Links,
    painter: Option<&'a Painter>,
    options: &'a mut ViewOptions,
    tools: &'a mut Tools,
    cx: &'a mut Context,
}

impl Behavior<Pane> for Layout<'_> {
    fn pane_ui(&mut self, ui: &mut Ui, _tile: TileId, pane: &mut Pane) -> UiResponse {
        show(pane, ui, self.tools, self.options, self.links, self.painter, self.cx);
        UiResponse::None
    }

    fn tab_title_for_pane(&mut self, pane: &Pane) -> egui::WidgetText {
        pane.kind.title().into()
    }

    fn gap_width(&self, _style: &egui::Style) -> f32 {
        2.0
    }

    fn min_size(&self) -> f32 {
        120.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_layout_is_remembered_and_a_broken_one_is_not_used() {
        let mut views = usual_layout();
        assert!(is_whole(&views));
        let text = serde_json::to_string(&views).expect("a layout is text");
        let back: Tree<Pane> = serde_json::from_str(&text).expect("and back");
        assert_eq!(
            panes(&back).map(|pane| pane.kind).collect::<Vec<_>>().len(),
            panes(&views).map(|pane| pane.kind).collect::<Vec<_>>().len()
        );
        for (_, tile) in views.tiles.iter_mut() {
            if let Tile::Pane(pane) = tile {
                *pane = Pane::new(PaneKind::Result);
            }
        }
        assert!(!is_whole(&views));
    }
}
